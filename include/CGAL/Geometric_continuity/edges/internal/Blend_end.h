// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_BLEND_END_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_BLEND_END_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/surfaces/Patch_edge.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// \file Blend_end.h
/// What a surface gives to a blend that starts or ends at one of its edges, as splines along the edge; and splines over common
/// knots.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A spline along an edge with points or vectors as values.
template <class FT, int N> using Edge_spline = Bspline_function<FT, Coordinate_vector<FT, N>>;

template <class FT> bool is_constant(const Bernstein_polynomial<FT>& f, int value) {
  return f.degree() == 0 && f[0] == FT(value);
}

// The product with a polynomial on the domain of the spline, which is mapped to [0, 1].
template <class FT, int N>
Edge_spline<FT, N> product(const Bernstein_polynomial<FT>& f, const Edge_spline<FT, N>& row) {
  if (is_constant(f, 1)) return row;
  if (f.degree() == 0) {
    std::vector<Coordinate_vector<FT, N>> c = row.coefficients();
    for (Coordinate_vector<FT, N>& x : c) x *= f[0];
    return {row.knots(), std::move(c)};
  }
  const std::pair<FT, FT> domain = row.domain();
  return Bspline_function<FT>(Knot_vector<FT>(f.degree(), domain.first, domain.second), f.coefficients()) * row;
}

// The last coordinate of a spline of homogeneous points.
template <class FT, int N> Bspline_function<FT> weight_of(const Edge_spline<FT, N>& row) {
  std::vector<FT> weights;
  for (const Coordinate_vector<FT, N>& x : row.coefficients()) weights.push_back(x[x.dimension() - 1]);
  return {row.knots(), std::move(weights)};
}

// The edge C and the derivatives T and W across it, over clamped knots. T and W are those in the direction in which the blend
// runs: out of the surface where the blend starts, into it where it ends.
template <class FT, int N> struct Blend_end {
  Edge_spline<FT, N> edge, cross, second_cross;

  template <class Function> Blend_end transform(Function f) const { return {f(edge), f(cross), f(second_cross)}; }
  // Over another domain of the edge, by an affine map of the domains.
  Blend_end along(const std::pair<FT, FT>& other, Edge_direction direction) const {
    if (direction == Edge_direction::opposite)
      return transform([](const Edge_spline<FT, N>& row) { return row.reverse(); }).along(other, Edge_direction::same);
    const std::pair<FT, FT> domain = edge.domain();
    if (domain == other) return *this;
    const FT factor = FT(FT(other.second - other.first) / FT(domain.second - domain.first));
    std::vector<typename Knot_vector<FT>::Knot> inner = edge.knots().inner_knots();
    for (typename Knot_vector<FT>::Knot& knot : inner)
      knot.value = FT(other.first + factor * FT(knot.value - domain.first));
    const Knot_vector<FT> knots(edge.degree(), other.first, other.second, inner);
    return transform([&](const Edge_spline<FT, N>& row) { return Edge_spline<FT, N>(knots, row.coefficients()); });
  }
};

// The knots along an edge.
template <class Surface> Knot_vector<typename Surface::FT> knots_of_edge(const Surface& surface, Patch_edge edge) {
  if constexpr (Is_patch<Surface>::value) {
    const typename Surface::Interval domain = surface.domain(edge);
    return {surface.degree_along(edge), domain.first, domain.second};
  } else
    return surface.knots_along(edge);
}

// `direction` is 1 where the blend starts, -1 where it ends. Derivatives are those with respect to the parameters of the surface.
template <int N, class Surface>
Blend_end<typename Surface::FT, N> blend_end(const Surface& surface, Patch_edge edge, int direction) {
  typedef typename Surface::FT FT;
  auto rows = surface.template rows<FT>(edge, 2); // into the surface
  FT unit(-direction);
  if constexpr (Is_patch<Surface>::value) { // on the unit square
    const typename Surface::Interval across = runs_along_u(edge) ? surface.domain_v() : surface.domain_u();
    unit /= FT(across.second - across.first);
  }
  if (unit != FT(1))
    for (Coordinate_vector<FT, N>& x : rows[1]) x *= unit;
  const FT square = unit * unit;
  if (square != FT(1))
    for (Coordinate_vector<FT, N>& x : rows[2]) x *= square;
  const Knot_vector<FT> knots = knots_of_edge(surface, edge);
  const Blend_end<FT, N> end{{knots, std::move(rows[0])}, {knots, std::move(rows[1])}, {knots, std::move(rows[2])}};
  if (knots.is_clamped()) return end;
  return end.transform([](const Edge_spline<FT, N>& row) { return row.clamp(); });
}

// Raises the degrees of splines on one domain, and refines their knots, to those of all.
template <class Spline, std::size_t n> void unite(std::array<Spline, n>& splines) {
  int degree = 0;
  for (const Spline& s : splines) degree = (std::max)(degree, s.degree());
  for (Spline& s : splines)
    if (s.degree() < degree) s = s.elevate(degree - s.degree());
  auto knots = splines[0].knots();
  for (const Spline& s : splines)
    if (s.knots() != knots) knots = merge(knots, s.knots());
  for (Spline& s : splines)
    if (s.knots() != knots) s = s.refine(knots);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_BLEND_END_H
