// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_PROPERTIES_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_PROPERTIES_H

#include <CGAL/Geometric_continuity/algebra/convex_weights.h>
#include <CGAL/Geometric_continuity/algebra/isolate_roots.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/internal/decision_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <optional>
#include <vector>

/// \file bezier_properties.h
/// What the control polygon tells about a Bézier curve. Lecture slides, "Bézier curves III". See blending_functions.h for the
/// properties of the Bernstein polynomials from which it follows, and control_polygon.h for the two tricks of the slides.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <class Traits, class Field, int Degree>
std::vector<Coordinate_vector<Field, dimension_v<Traits>>> control_columns(const Bezier_curve<Traits, Degree>& curve) {
  std::vector<Coordinate_vector<Field, dimension_v<Traits>>> columns;
  for (const typename Traits::Point& p : curve) columns.push_back(coordinates<Traits, Field>(p));
  return columns;
}

template <class Traits> typename Traits::Vector direction(const Coordinates<Traits>& v, const char* place) {
  for (const typename Traits::FT& x : v) check_finite(x, place);
  return to_vector<Traits>(v);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// Returns weights \f$ w_i \ge 0 \f$ with \f$ \sum_i w_i = 1 \f$ and \f$ \sum_i w_i b_i = p \f$ for the control points, which prove that `p` is in
/// their convex hull; empty if and only if it is outside. Exact with every kernel for the coordinates as given, in any
/// dimension. See `convex_weights()`.
/// \throws Error `dimension_mismatch` when `p` has another dimension
/// \throws Error `not_finite` when `p` has an infinite or undefined floating-point coordinate
template <class Traits, int Degree>
std::optional<std::vector<internal::Decision_FT<Traits>>> convex_hull_weights(const Bezier_curve<Traits, Degree>& curve,
                                                                              const typename Traits::Point& p) {
  typedef internal::Decision_FT<Traits> Field;
  return convex_weights(internal::control_columns<Traits, Field>(curve),
                        Geometric_continuity::coordinates<Traits, Field>(p));
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns whether `p` is in the convex hull of the control points, or on its boundary. Every point of the curve is, for parameters
/// in the domain: its weights are the values of the Bernstein polynomials there. (With rounded numbers the point that
/// the curve returns may be just outside.) Exact with every kernel for the coordinates as given. See `convex_hull_weights()`.
/// \throws Error `dimension_mismatch` when `p` has another dimension
/// \throws Error `not_finite` when `p` has an infinite or undefined floating-point coordinate
template <class Traits, int Degree>
bool is_in_convex_hull(const Bezier_curve<Traits, Degree>& curve, const typename Traits::Point& p) {
  return bool(convex_hull_weights(curve, p));
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the direction in which the curve starts: the first \f$ b_j - b_0 \f$ that is not zero. It is a positive multiple of the
/// first derivative that does not vanish, so it is that of the leg \f$ b_1 - b_0 \f$ in general. Empty when all control points are
/// equal. \f$ O(m) \f$ \throws Error `not_finite` when a floating-point coordinate overflows
template <class Traits, int Degree>
std::optional<typename Traits::Vector> start_tangent(const Bezier_curve<Traits, Degree>& curve) {
  for (int j = 1; j <= curve.degree(); ++j)
    if (curve.coordinates(j) != curve.coordinates(0))
      return internal::direction<Traits>(curve.coordinates(j) - curve.coordinates(0), "start_tangent");
  return std::nullopt;
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the direction in which the curve ends: the last \f$ b_m - b_j \f$ that is not zero, in general the leg
/// \f$ b_m - b_{m-1} \f$. Empty when all control points are equal. \f$ O(m) \f$
/// \throws Error `not_finite` when a floating-point coordinate overflows
template <class Traits, int Degree>
std::optional<typename Traits::Vector> end_tangent(const Bezier_curve<Traits, Degree>& curve) {
  const int m = curve.degree();
  for (int j = m - 1; j >= 0; --j)
    if (curve.coordinates(j) != curve.coordinates(m))
      return internal::direction<Traits>(curve.coordinates(m) - curve.coordinates(j), "end_tangent");
  return std::nullopt;
}

/// \ingroup PkgGeometricContinuityCurves
/// How often a curve and its control polygon meet a line in the plane, a plane in space, or a hyperplane.
struct Crossings {
  int polygon = 0;  ///< changes of side from control point to control point, those on the hyperplane left out
  int curve = 0;    ///< changes of side of the curve
  int contacts = 0; ///< common points other than the end points, each as often as its multiplicity
  /// Returns whether the curve does not cross more often than its polygon. So it is for every curve and hyperplane.
  bool diminished() const { return curve <= contacts && contacts <= polygon; }
};

/// \ingroup PkgGeometricContinuityCurves
/// Counts the crossings with the hyperplane through `origin` that is orthogonal to `normal`. Exact with every kernel for the
/// coordinates as given: the signed distances \f$ (b_i - q) \cdot n \f$ are the coefficients of a Bernstein polynomial, the roots of
/// which are counted. Empty when the whole curve is in the hyperplane.
/// \throws Error `zero_direction` when the normal is zero
/// \throws Error `dimension_mismatch` when the dimensions differ
/// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
template <class Traits, int Degree>
std::optional<Crossings> count_crossings(const Bezier_curve<Traits, Degree>& curve,
                                         const typename Traits::Point& origin, const typename Traits::Vector& normal) {
  typedef internal::Decision_FT<Traits> Field;
  typedef Coordinate_vector<Field, dimension_v<Traits>> Column;
  const Column q = Geometric_continuity::coordinates<Traits, Field>(origin),
               n = Geometric_continuity::coordinates<Traits, Field>(normal);
  if (q.dimension() != curve.dimension() || n.dimension() != curve.dimension())
    throw Error(Error_code::dimension_mismatch, "count_crossings");
  if (is_zero(n)) throw Error(Error_code::zero_direction, "count_crossings: normal");
  std::vector<Field> distances;
  for (const Column& b : internal::control_columns<Traits, Field>(curve)) distances.push_back(dot(b - q, n));
  const Bernstein_polynomial<Field> distance(distances);
  if (sign_pattern(distance) == Sign_pattern::zero) return std::nullopt;
  Crossings count;
  count.polygon = internal::sign_variations(internal::whole_multiple(distance));
  for (const Isolated_root<Field>& root : isolate_roots(distance, Field(1))) {
    if (root.end == Field(0) || root.begin == Field(1)) continue; // an end point of the curve
    count.contacts += root.multiplicity;
    count.curve += root.multiplicity % 2;
  }
  return count;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_PROPERTIES_H
