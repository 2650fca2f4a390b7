// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_INTERNAL_BLEND_END_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_INTERNAL_BLEND_END_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Blend_end.h
/// The data that a surface gives to a blend that starts or ends at one of its edges, as splines
/// along the edge; and splines over common knots.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A spline along an edge with points or vectors as values.
template <class FT, int N> using Edge_spline = Bspline_function<FT, Coordinate_vector<FT, N>>;

template <class FT> bool is_constant(const Edge_function<FT>& f, int value) {
  return f.is_number() && f[0] == FT(value);
}

// Returns whether a function is 0 everywhere, also one over knots.
template <class FT> bool is_zero(const Edge_function<FT>& f) {
  for (int i = 0; i < f.number_of_coefficients(); ++i)
    if (f[i] != FT(0)) return false;
  return true;
}

// The product with a function along the edge.
template <class FT, int N> Edge_spline<FT, N> product(const Edge_function<FT>& f, const Edge_spline<FT, N>& row) {
  if (is_constant(f, 1)) return row;
  if (f.is_number()) {
    std::vector<Coordinate_vector<FT, N>> c = row.coefficients();
    for (Coordinate_vector<FT, N>& x : c) x *= f[0];
    return {row.knots(), std::move(c)};
  }
  return f.over(row.domain()) * row;
}

// The last coordinate of a row of homogeneous points.
template <class FT, int N>
Bspline_function<FT> weight_of(const Knot_vector<FT>& knots, const std::vector<Coordinate_vector<FT, N>>& row) {
  std::vector<FT> weights;
  for (const Coordinate_vector<FT, N>& x : row) weights.push_back(x[x.dimension() - 1]);
  return {knots, std::move(weights)};
}

// The knots along an edge.
template <class Surface> Knot_vector<typename Surface::FT> knots_of_edge(const Surface& surface, Patch_edge edge) {
  if constexpr (Is_patch<Surface>::value) {
    const typename Surface::Interval domain = surface.domain(edge);
    return {surface.degree_along(edge), domain.first, domain.second};
  } else
    return surface.knots_along(edge);
}

// The edge C and the derivatives T, W and X across it, as coefficients over clamped knots. T and W
// are those in the direction in which the blend runs: out of the surface where the blend starts,
// into it where it ends. X is empty where it is not asked for.
template <class FT, int N> struct Blend_end {
  typedef std::vector<Coordinate_vector<FT, N>> Row;

  Knot_vector<FT> knots;
  Row edge, cross, second_cross, third_cross;

  // `direction` is 1 where the blend starts, -1 where it ends. Derivatives are those with respect
  // to the parameters of the surface.
  template <class Surface>
  Blend_end(const Surface& surface, Patch_edge at, int direction, int order) : knots(knots_of_edge(surface, at)) {
    auto rows = surface.template rows<FT>(at, order); // into the surface
    edge = std::move(rows[0]);
    cross = std::move(rows[1]);
    second_cross = std::move(rows[2]);
    if (order >= 3) third_cross = std::move(rows[3]);
    FT unit(-direction);
    if constexpr (Is_patch<Surface>::value) { // on the unit square
      const typename Surface::Interval across = runs_along_u(at) ? surface.domain_v() : surface.domain_u();
      unit /= FT(across.second - across.first);
    }
    multiply(cross, unit);
    multiply(second_cross, FT(unit * unit));
    if (order >= 3) multiply(third_cross, FT(unit * unit * unit));
    if (knots.is_clamped()) return;
    const Knot_vector<FT> clamped = knots.clamp();
    for (Row* row : {&edge, &cross, &second_cross, &third_cross})
      if (!row->empty()) *row = bspline_refine(knots, *row, clamped);
    knots = clamped;
  }

  // Goes over to another domain, by an affine map of the domains.
  void run_along(const std::pair<FT, FT>& other, Edge_direction direction) {
    if (direction == Edge_direction::opposite) {
      knots = knots.reverse();
      for (Row* row : {&edge, &cross, &second_cross, &third_cross}) std::reverse(row->begin(), row->end());
    }
    knots = knots.on_domain(other.first, other.second);
  }

  // Multiplies all by a number, which changes nothing where they are homogeneous.
  void scale(const FT& factor) {
    for (Row* row : {&edge, &cross, &second_cross, &third_cross}) multiply(*row, factor);
  }

  Edge_spline<FT, N> spline(Row row) const { return {knots, std::move(row)}; }

private:
  static void multiply(Row& row, const FT& factor) {
    if (factor != FT(1))
      for (Coordinate_vector<FT, N>& x : row) x *= factor;
  }
};

// Describes the blend of two surfaces.
template <class A, class B> struct Blended_surfaces {
  static_assert(std::is_same_v<typename A::Traits, typename B::Traits>,
                "both surfaces must have the same traits class");
  typedef typename A::Traits Traits;
  typedef typename Traits::FT FT;
  static constexpr bool is_rational = Is_rational<A>::value || Is_rational<B>::value,
                        is_patch = Is_patch<A>::value && Is_patch<B>::value;
  template <class T> using Shape_over = std::conditional_t<is_patch, Bezier_patch<T>, Bspline_surface<T>>;

  // of the points in the rows
  typedef std::conditional_t<is_rational, Homogeneous_traits<Traits>, Traits> Row_traits;
  static constexpr int N = dimension_v<Row_traits>;
  typedef std::conditional_t<is_rational, Rational_surface<Shape_over<Traits>>, Shape_over<Traits>> Surface;

  typedef Blend_end<FT, N> End;

  // Both ends, over the domain of the first edge.
  static std::pair<End, End> ends(const A& a, Patch_edge edge_a, const B& b, Patch_edge edge_b,
                                  Edge_direction direction, int order = 2) {
    if (a.dimension() != b.dimension()) throw Error(Error_code::dimension_mismatch, "blend: of the two surfaces");
    std::pair<End, End> ends(end(a, edge_a, 1, order), end(b, edge_b, -1, order));
    ends.second.run_along(ends.first.knots.domain(), direction);
    return ends;
  }

  // Makes the surface with these rows of control points across the blend.
  template <std::size_t n> static Surface surface(const std::array<Edge_spline<FT, N>, n>& rows) {
    typedef Shape_over<Row_traits> Polynomial;
    const Knot_vector<FT>& knots = rows[0].knots();
    if (is_patch && knots.number_of_coefficients() > knots.degree() + 1)
      throw Error(Error_code::knot_multiplicity,
                  "blend: the blend of two patches has no knots, but a function has; blend B-spline surfaces instead");
    std::vector<std::vector<typename Row_traits::Point>> net(knots.number_of_coefficients());
    for (int i = 0; i < knots.number_of_coefficients(); ++i) {
      net[i].reserve(rows.size());
      for (const Edge_spline<FT, N>& row : rows) net[i].push_back(to_point<Row_traits>(row[i]));
    }
    const auto surface_of = [](const Polynomial& s) {
      if constexpr (is_rational) try {
          return Surface(s);
        } catch (const Error& e) {
          if (e.code() != Error_code::zero_weight) throw;
          throw Error(Error_code::zero_weight, place_of_least_weight(s));
        }
      else
        return Surface(s);
    };
    if constexpr (is_patch)
      return surface_of(Polynomial(net, knots.domain()));
    else
      return surface_of(Polynomial(net, knots, Knot_vector<FT>(static_cast<int>(n) - 1, FT(0), FT(1))));
  }

private:
  // Where the denominator of the homogeneous points of a blend is not positive.
  template <class Polynomial> static std::string place_of_least_weight(const Polynomial& s) {
    const Knot_vector<FT> knots = knots_of_edge(s, Patch_edge::v0);
    const int last = s.dimension() - 1;
    int at_u = 0, at_v = 0;
    for (int i = 0; i < knots.number_of_coefficients(); ++i)
      for (int j = 0; j <= s.degree_v(); ++j)
        if (s.coordinates(i, j)[last] < s.coordinates(at_u, at_v)[last]) at_u = i, at_v = j;
    const auto text = [](const FT& x) { return std::to_string(CGAL::to_double(x)); };
    return "blend: its denominator is not positive near (u, v) = (" + text(knots.greville_abscissa(at_u)) + ", " +
           text(FT(FT(at_v) / FT(s.degree_v()))) + "), where a control point has the weight " +
           text(FT(s.coordinates(at_u, at_v)[last])) +
           "; it grows with lambda1 at the start, with -lambda1 at the end, and with lambda2";
  }

  template <class S> static End end(const S& surface, Patch_edge edge, int direction, int order) {
    if constexpr (is_rational && !Is_rational<S>::value)
      return {Rational_surface<S>(surface), edge, direction, order};
    else
      return {surface, edge, direction, order};
  }
};

// Raises the degrees of splines on one domain, and refines their knots, to those of all.
template <class Splines> void unite(Splines& splines) {
  typedef typename Splines::value_type Spline;
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

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_INTERNAL_BLEND_END_H
