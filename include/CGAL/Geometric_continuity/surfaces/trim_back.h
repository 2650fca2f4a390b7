// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_TRIM_BACK_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_TRIM_BACK_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
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

// Without the strip beyond v = w(u), 0 < w < 1, of a patch on the unit square: S(u, w(u) v), by the algorithm of de Casteljau, whose parameter is
// a polynomial. For the strip from v = 0 on it is called with the patch turned.
template <class Traits>
Bezier_patch<Traits> part_below(const Bezier_patch<Traits>& s, const Bernstein_polynomial<typename Traits::FT>& w) {
  typedef typename Traits::FT FT;
  typedef Bernstein_polynomial<FT> Polynomial;
  const int p = s.degree_u(), q = s.degree_v(), degree = p + q * w.degree();
  const Polynomial rest = Polynomial{FT(1)} - w;
  std::vector<Coordinates<Traits>> sums(static_cast<std::size_t>(degree + 1) * static_cast<std::size_t>(q + 1),
                                        Coordinates<Traits>(s.dimension()));
  for (int x = 0; x < s.dimension(); ++x) {
    std::vector<Polynomial> row; // of constant j
    for (int j = 0; j <= q; ++j) {
      std::vector<FT> c;
      for (int i = 0; i <= p; ++i) c.push_back(s.coordinates(i, j)[x]);
      row.emplace_back(std::move(c));
    }
    for (int r = 0; r <= q; ++r) {
      const Polynomial c = row[0].elevated(degree - row[0].degree());
      for (int i = 0; i <= degree; ++i) sums[static_cast<std::size_t>(i * (q + 1) + r)][x] = c[i];
      for (int j = 0; j < q - r; ++j) row[j] = rest * row[j] + w * row[j + 1];
    }
  }
  std::vector<typename Traits::Point> points;
  for (const Coordinates<Traits>& c : sums) points.push_back(to_point<Traits>(c));
  return Bezier_patch<Traits>(degree, q, std::move(points), s.domain_u(), s.domain_v());
}
template <class Traits>
Rational_bezier_patch<Traits> part_below(const Rational_bezier_patch<Traits>& s,
                                         const Bernstein_polynomial<typename Traits::FT>& w) {
  return Rational_bezier_patch<Traits>(part_below(s.homogeneous(), w));
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the part of a patch between the opposite edge and a curve in the parameter plane: for the edge `v = d` of a patch on
/// [a, b] x [c, d] the part with \f$ c \le v \le d - f(u) \f$. The new edge has the parameter of the old one; along each line of constant `u`
/// the other parameter runs in proportion. Exact with an exact kernel, for straight lines and all other polynomials `f`: the degree along the
/// edge grows by the product of the degree of `f` and the degree across.
/// \param surface a `Bezier_patch` or `Rational_bezier_patch`
/// \param edge the edge that is cut off
/// \param distance \f$ f \f$, on the domain of the edge, which is mapped to [0, 1], in the parameter that is constant on the edge
/// \throws Error `parameter_outside_domain` unless the distance is everywhere positive and less than the length of the domain (decided exactly),
///   with the edge; `not_finite` when floating-point numbers overflow
template <class Patch>
Patch trim_back(const Patch& surface, Patch_edge edge, const Bernstein_polynomial<typename Patch::FT>& distance) {
  typedef typename Patch::FT FT;
  typedef Bernstein_polynomial<FT> Polynomial;
  const typename Patch::Interval domain = runs_along_u(edge) ? surface.domain_v() : surface.domain_u();
  const FT length = domain.second - domain.first;
  const Polynomial rest = Polynomial{length} - distance;
  if (sign_pattern(distance) != Sign_pattern::positive || sign_pattern(rest) != Sign_pattern::positive)
    throw Error(Error_code::parameter_outside_domain, "trim_back: the distance from the edge " + to_string(edge) +
                                                          " does not lie between 0 and the other edge everywhere");
  const bool lower = !at_upper_end(edge);
  Patch turned = runs_along_u(edge) ? surface : surface.swap_parameters();
  if (lower) turned = turned.reverse_v();
  turned = internal::part_below(turned, Polynomial{FT(FT(1) / length)} * rest);
  if (lower) turned = turned.reverse_v();
  return runs_along_u(edge) ? turned : turned.swap_parameters();
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_TRIM_BACK_H
