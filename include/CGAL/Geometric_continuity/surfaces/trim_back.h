// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_TRIM_BACK_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_TRIM_BACK_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

#include <string>
#include <utility>
#include <vector>

/// \file trim_back.h
/// A surface without a strip along one of its edges, as it is needed where something else is put in the place of the edge.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the surface without the strip of a constant width along an edge: for the edge `v = d` of a surface on [a, b] x [c, d] the part
/// on [a, b] x [c, d - distance], with the same parameters. A Bézier patch is split, knots of a B-spline surface are inserted. Exact with
/// an exact kernel.
/// \param surface a `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or `Rational_bspline_surface`
/// \param edge the edge that is cut off
/// \param distance in the parameter that is constant on the edge
/// \throws Error `parameter_outside_domain` unless the distance is positive and less than the length of the domain, with the edge;
///   `not_finite` when floating-point numbers overflow
template <class Surface>
Surface trim_back(const Surface& surface, Patch_edge edge, const typename Surface::FT& distance) {
  typedef typename Surface::FT FT;
  const typename Surface::Interval domain = runs_along_u(edge) ? surface.domain_v() : surface.domain_u();
  const FT cut = at_upper_end(edge) ? FT(domain.second - distance) : FT(domain.first + distance);
  if (!(domain.first < cut && cut < domain.second))
    throw Error(Error_code::parameter_outside_domain, "trim_back: the distance from the edge " + to_string(edge) +
                                                          " does not lie between 0 and the other edge");
  const auto parts = runs_along_u(edge) ? surface.split_v(cut) : surface.split_u(cut);
  return at_upper_end(edge) ? parts.first : parts.second;
}

namespace internal {

// S(u, c + w(u) (v - c)) with 0 < w < 1 on the domain of u, mapped to [0, 1]: of a surface with one span in v, from c on, by the algorithm of
// de Casteljau, whose parameter is a function of u.
template <class Traits>
Bspline_surface<Traits> part_of_span(const Bspline_surface<Traits>& s,
                                     const Bernstein_polynomial<typename Traits::FT>& w) {
  typedef typename Traits::FT FT;
  typedef Bspline_function<FT, Coordinates<Traits>> Row; // of constant j
  const int q = s.degree_v(), m = w.degree();
  const Knot_vector<FT> knots(m, s.domain_u().first, s.domain_u().second);
  const Bernstein_polynomial<FT> rest = Bernstein_polynomial<FT>{FT(1)} - w;
  const Bspline_function<FT> f(knots, w.coefficients()), g(knots, rest.elevated(m - rest.degree()).coefficients());
  std::vector<Row> row;
  for (int j = 0; j <= q; ++j) {
    std::vector<Coordinates<Traits>> c;
    for (int i = 0; i < s.knots_u().number_of_coefficients(); ++i) c.push_back(s.coordinates(i, j));
    row.emplace_back(s.knots_u(), std::move(c));
  }
  std::vector<Row> column; // of the result
  for (int r = 0; r <= q; ++r) {
    column.push_back(row[0].elevate((q - r) * m));
    for (int j = 0; j < q - r; ++j) row[j] = g * row[j] + f * row[j + 1];
  }
  const Knot_vector<FT>& u = column[0].knots();
  std::vector<std::vector<typename Traits::Point>> net(u.number_of_coefficients());
  for (int i = 0; i < u.number_of_coefficients(); ++i)
    for (const Row& c : column) net[i].push_back(to_point<Traits>(c[i]));
  return Bspline_surface<Traits>(net, u, s.knots_v());
}

// One surface from two, over the same knots in u, where the second one begins in v where the first one ends; `jump` tells whether there the
// first one does not lead to the second one.
template <class Traits>
Bspline_surface<Traits> joined_in_v(const Bspline_surface<Traits>& a, const Bspline_surface<Traits>& b, bool jump) {
  typedef typename Traits::FT FT;
  const int q = b.degree_v(), first = jump ? 0 : 1; // row of the second surface
  std::vector<FT> v(a.knots_v().begin(), a.knots_v().end() - first);
  v.insert(v.end(), b.knots_v().begin() + q + 1, b.knots_v().end());
  std::vector<std::vector<typename Traits::Point>> net(a.knots_u().number_of_coefficients());
  for (int i = 0; i < a.knots_u().number_of_coefficients(); ++i) {
    for (int j = 0; j < a.knots_v().number_of_coefficients(); ++j) net[i].push_back(a.control_point(i, j));
    for (int j = first; j <= q; ++j) net[i].push_back(b.control_point(i, j));
  }
  return Bspline_surface<Traits>(net, a.knots_u(), Knot_vector<FT>(q, std::move(v)));
}

// The length across the edge without the distance from it, which must lie between both everywhere.
template <class Surface>
Bernstein_polynomial<typename Surface::FT>
height_below_curve(const Surface& surface, Patch_edge edge,
                   const Bernstein_polynomial<typename Surface::FT>& distance) {
  typedef typename Surface::FT FT;
  const typename Surface::Interval domain = runs_along_u(edge) ? surface.domain_v() : surface.domain_u();
  const Bernstein_polynomial<FT> rest = Bernstein_polynomial<FT>{FT(domain.second - domain.first)} - distance;
  if (sign_pattern(distance) != Sign_pattern::positive || sign_pattern(rest) != Sign_pattern::positive)
    throw Error(Error_code::parameter_outside_domain, "trim_back: the distance from the edge " + to_string(edge) +
                                                          " does not lie between 0 and the other edge everywhere");
  return rest;
}

// The surface f(s) in its own parameters, where s is the surface in those in which the edge is v1.
template <class Surface, class Function>
Surface turned_to_v1(const Surface& surface, Patch_edge edge, const Function& f) {
  const auto turn = [&](const Surface& s) { return at_upper_end(edge) ? s : s.reverse_v(); };
  const Surface turned = turn(f(turn(runs_along_u(edge) ? surface : surface.swap_parameters())));
  return runs_along_u(edge) ? turned : turned.swap_parameters();
}

// Without the strip beyond v = c + height(u), inside of the domain [c, d].
template <class Surface>
Surface part_below(const Surface& s, const Bernstein_polynomial<typename Surface::FT>& height, Patch_edge edge) {
  typedef typename Surface::FT FT;
  typedef Bernstein_polynomial<FT> Polynomial;
  if constexpr (Is_rational<Surface>::value)
    return Surface(part_below(s.homogeneous(), height, edge));
  else if constexpr (!Surface_shape<Surface>::is_spline) {
    const auto t = part_below(Bspline_surface<typename Surface::Traits>(s), height, edge);
    return Surface(t.degree_u(), t.degree_v(), std::vector<typename Surface::Traits::Point>(t.begin(), t.end()),
                   s.domain_u(), s.domain_v());
  } else {
    const Surface clamped = s.clamp();
    const Knot_vector<FT>& v = clamped.knots_v();
    const FT& knot = v[v.number_of_coefficients() - 1];
    const auto part = [&](const Surface& of, const Polynomial& h) {
      return part_of_span(of, Polynomial{FT(FT(1) / (v.domain().second - knot))} * h);
    };
    if (knot == v.domain().first) return part(clamped, height);
    const Polynomial beyond = height - Polynomial{FT(knot - v.domain().first)};
    if (sign_pattern(beyond) != Sign_pattern::positive)
      throw Error(Error_code::parameter_outside_domain, "trim_back: the curve is not everywhere between the edge " +
                                                            to_string(edge) + " and the knot line next to it");
    const std::pair<Surface, Surface> parts = clamped.split_v(knot);
    const Surface strip = part(parts.second, beyond);
    return joined_in_v(parts.first.elevate(strip.degree_u() - s.degree_u(), 0), strip,
                       v.multiplicity(knot) > s.degree_v());
  }
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the part of a surface between the opposite edge and a curve in the parameter plane: for the edge `v = d` of a surface on
/// [a, b] x [c, d] the part with \f$ c \le v \le d - f(u) \f$. The new edge has the parameter of the old one; along each line of constant `u`
/// the other parameter runs in proportion, of a B-spline surface from the knot line on that is next to the edge, where the knot gets the
/// multiplicity of the degree: up to there it keeps its parameters. Exact with an exact kernel, for straight lines and all other polynomials
/// `f`: the degree along the edge grows by the product of the degree of `f` and the degree across.
///
/// The curve may not cross a knot line of constant `v`: no surface over a rectangle of knots is the part beyond it. Where it would,
/// `trim_back_within()` is near it, or `bezier_patches()` are trimmed one by one.
/// \param surface a `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or `Rational_bspline_surface`
/// \param edge the edge that is cut off
/// \param distance \f$ f \f$, on the domain of the edge, which is mapped to [0, 1], in the parameter that is constant on the edge
/// \throws Error `parameter_outside_domain` unless the distance is everywhere positive and less than the length of the domain, of a B-spline
///   surface less than the distance of the next knot line (decided exactly), with the edge; `not_finite` when floating-point numbers overflow
template <class Surface>
Surface trim_back(const Surface& surface, Patch_edge edge, const Bernstein_polynomial<typename Surface::FT>& distance) {
  const auto height = internal::height_below_curve(surface, edge, distance);
  return internal::turned_to_v1(surface, edge, [&](const Surface& s) { return internal::part_below(s, height, edge); });
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_TRIM_BACK_H
