// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_EXTEND_TOWARD_H
#define CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_EXTEND_TOWARD_H

#include <CGAL/Geometric_continuity/algebra/internal/solve_positive_definite.h>
#include <CGAL/Geometric_continuity/extensions/extend.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_words.h>

#include <cstddef>
#include <utility>
#include <vector>

/// \file extend_toward.h
/// The next segment behind a curve that leads to a wished point with the least energy among the members of Hagen's families of
/// alternatives (see `alternatives.h`). Of a Bézier curve the segment is returned; a segmented curve and a B-spline curve are
/// returned with the segment.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// One degree of freedom of a polygon: the point b_index may move along a direction.
template <class Vector> struct Freedom {
  int index;
  Vector direction;
};

// Moves the points of the polygon b along the given directions so that the integral of |gamma''|^2 becomes least.
// b_0 and b_1 do not move, and the directions of one point are independent.
template <class FT, int N>
void minimize_energy(std::vector<Coordinate_vector<FT, N>>& b,
                     const std::vector<Freedom<Coordinate_vector<FT, N>>>& free) {
  const int m = static_cast<int>(b.size()) - 1;
  const Second_derivative_products<FT> products(m);
  Work_meter* const work = scope_of<FT>();
  std::vector<std::vector<FT>> a(free.size());
  std::vector<FT> rhs;
  for (std::size_t k = 0; k < free.size(); ++k) {
    const std::vector<FT> row = products.row(free[k].index);
    const std::size_t words = work ? most_words(free[k].direction) : 0;
    if (work) work->charge_fractions(static_cast<double>(free.size()) * free[k].direction.dimension(), 2 * words);
    for (const Freedom<Coordinate_vector<FT, N>>& other : free)
      a[k].push_back(FT(row[other.index] * dot(free[k].direction, other.direction)));
    FT sum(0);
    for (int j = 0; j <= m; ++j) {
      sum -= row[j] * dot(free[k].direction, b[j]);
      if (work) work->charge_fractions(b[j].dimension() + 1., number_words(sum), most_words(b[j]) + words);
    }
    rhs.push_back(sum);
  }
  const std::vector<FT> x = solve_positive_definite(std::move(a), std::move(rhs));
  for (std::size_t k = 0; k < free.size(); ++k) b[free[k].index] += x[k] * free[k].direction;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the next segment of a chain behind `left` that leads to a wished point: of the same degree `m`, on the domain
/// \f$ [b, b + \beta (b - a)] \f$ behind \f$ [a, b] \f$, with the wanted continuity `k`. When `m > k` it ends at the point; when
/// `m == k` it ends at the nearest member of the family of alternatives. All that is free otherwise, the scalars of the
/// families and the points between, has the least energy \f$ \int |\gamma''|^2 \f$: an exact linear system in at most
/// `3 + n (m - k - 1)` unknowns in dimension `n`, never singular, solved by elimination.
/// \throws Error `wrong_number_of_points` when `m < k`, `nonpositive_beta` unless \f$ \beta > 0 \f$, `zero_tangent` when the last
///   two control points are equal, `dimension_mismatch`, `not_finite` when the result overflows the number type; `work_limit` in a
///   `Work_scope`
template <class Traits, int Degree>
Bezier_curve<Traits, Degree> extend_toward(const Bezier_curve<Traits, Degree>& left, Frenet_order order,
                                           const typename Traits::Point& wished,
                                           const typename Traits::FT& beta = typename Traits::FT(1)) {
  typedef typename Traits::FT FT;
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;
  const int m = left.degree(), k = static_cast<int>(order), n = left.dimension();
  const Tangent_alternative<Traits> tangent = tangent_alternative(left, beta);
  const Coordinates end = Geometric_continuity::coordinates<Traits>(wished);
  if (end.dimension() != n) throw Error(Error_code::dimension_mismatch, "extend_toward: the wished point");

  std::vector<Coordinates> b{left.coordinates(m), Geometric_continuity::coordinates<Traits>(tangent.point())};
  std::vector<internal::Freedom<Coordinates>> free;
  if (order >= Frenet_order::curvature) {
    const Curvature_alternatives<Traits> line = curvature_alternatives(left, beta);
    const FT c0 = m == 2 ? line.nearest_parameter(wished) : FT(0);
    b.push_back(Geometric_continuity::coordinates<Traits>(line.point_at(c0)));
    if (m > 2) free.push_back({2, Geometric_continuity::coordinates<Traits>(line.direction())});
  }
  if (order >= Frenet_order::torsion) {
    const Torsion_alternatives<Traits> plane = torsion_alternatives(left, FT(0), beta);
    const Torsion_parameters<FT> c = m == 3 ? plane.nearest_parameters(wished) : Torsion_parameters<FT>{FT(0), FT(0)};
    b.push_back(Geometric_continuity::coordinates<Traits>(plane.point_at(c)));
    if (m > 3) free.push_back({3, Geometric_continuity::coordinates<Traits>(plane.directions().first)});
    if (m > 3 && !plane.is_line())
      free.push_back({3, Geometric_continuity::coordinates<Traits>(plane.directions().second)});
  }
  for (int j = k + 1; j < m; ++j) {
    b.push_back(Coordinates(n));
    for (int i = 0; i < n; ++i) {
      Coordinates axis(n);
      axis[i] = FT(1);
      free.push_back({j, axis});
    }
  }
  if (m > k) b.push_back(end);
  internal::minimize_energy(b, free);
  return internal::next_segment(left, beta, b);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the next segment of a chain behind a rational curve that leads to a wished point: a polynomial one, which `extend_toward()`
/// makes from the Taylor polynomial of `left` at its end, as `extend()` of a rational curve.
/// \throws Error `nonpositive_beta`, `zero_tangent`, `dimension_mismatch`, `not_finite` as `extend_toward()` of a Bézier curve
template <class Traits, int Degree>
Bezier_curve<Traits> extend_toward(const Rational_bezier_curve<Traits, Degree>& left, Frenet_order order,
                                   const typename Traits::Point& wished,
                                   const typename Traits::FT& beta = typename Traits::FT(1)) {
  return extend_toward(internal::polynomial_at_end(left, order), order, wished, beta);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the rational B-spline curve with one more segment, a polynomial one, which `extend_toward()` makes from the rational Bézier
/// curve on the last span.
/// \throws Error `wrong_number_of_points` when the order exceeds the degree, otherwise as `extend_toward()` of a Bézier curve
template <class Traits>
Rational_bspline_curve<Traits> extend_toward(const Rational_bspline_curve<Traits>& curve, Frenet_order order,
                                             const typename Traits::Point& wished,
                                             const typename Traits::FT& beta = typename Traits::FT(1)) {
  const Rational_bspline_curve<Traits> clamped = curve.clamp();
  return internal::with_segment(clamped, extend_toward(clamped.bezier_pieces().back(), order, wished, beta),
                                "extend_toward");
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the segmented curve with one more segment, which `extend_toward()` makes from the last one. In the global parameter
/// \f$ \beta \f$ is the ratio of the lengths of the two parameter intervals.
/// \throws Error `wrong_number_of_points`, `nonpositive_beta`, `zero_tangent`, `dimension_mismatch`, `not_finite` as
///   `extend_toward()` of a Bézier curve
template <class Traits, int Degree>
Composite_bezier_curve<Traits, Degree> extend_toward(const Composite_bezier_curve<Traits, Degree>& curve,
                                                     Frenet_order order, const typename Traits::Point& wished,
                                                     const typename Traits::FT& beta = typename Traits::FT(1)) {
  std::vector<Bezier_curve<Traits>> segments = internal::segments_of(curve);
  segments.push_back(extend_toward(segments.back(), order, wished, beta));
  return Composite_bezier_curve<Traits, Degree>(segments.begin(), segments.end());
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the B-spline curve with one more segment, which `extend_toward()` makes from the Bézier curve on the last span. It is
/// clamped, and the join becomes a knot of multiplicity `p`, as by `extend()` of a B-spline curve.
/// \throws Error `wrong_number_of_points`, `nonpositive_beta`, `zero_tangent`, `dimension_mismatch`, `not_finite` as
///   `extend_toward()` of a Bézier curve
template <class Traits>
Bspline_curve<Traits> extend_toward(const Bspline_curve<Traits>& curve, Frenet_order order,
                                    const typename Traits::Point& wished,
                                    const typename Traits::FT& beta = typename Traits::FT(1)) {
  const Bspline_curve<Traits> clamped = curve.clamp();
  return internal::with_segment(clamped, extend_toward(clamped.bezier_pieces().back(), order, wished, beta));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_EXTEND_TOWARD_H
