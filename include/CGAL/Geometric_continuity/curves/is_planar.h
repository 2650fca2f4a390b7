// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_IS_PLANAR_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_IS_PLANAR_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/curves/internal/curve_pieces.h>
#include <CGAL/Geometric_continuity/curves/internal/decision_numbers.h>
#include <CGAL/Geometric_continuity/local/homogeneous_jets.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <cstddef>
#include <utility>
#include <vector>

/// \file is_planar.h
/// Curves that lie in a plane. Hagen 1.13: a curve is planar if and only if its torsion vanishes. This holds for one polynomial or
/// rational piece, and for several only where the curvature does not vanish at their joins: \f$ (t, t^4, 0) \f$ for
/// \f$ t \le 0 \f$ and \f$ (t, 0, t^4) \f$ for \f$ t \ge 0 \f$ have no torsion where it is defined, and no plane in common. So the
/// control points are decided, and not the torsion.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The control points that a curve depends on, from the first to the one behind the last: of a spline those of the basis functions
// that do not vanish on the whole domain.
template <class Curve> std::pair<int, int> points_in_use(const Curve& curve) {
  return {0, static_cast<int>(curve.control_points().size())};
}
template <class FT> std::pair<int, int> coefficients_in_use(const Knot_vector<FT>& u) {
  const std::pair<FT, FT> domain = u.domain();
  std::pair<int, int> used(0, u.number_of_coefficients());
  while (!(domain.first < u[used.first + u.degree() + 1])) ++used.first;
  while (!(u[used.second - 1] < domain.second)) --used.second;
  return used;
}
template <class Traits> std::pair<int, int> points_in_use(const Bspline_curve<Traits>& curve) {
  return coefficients_in_use(curve.knots());
}
template <class Traits> std::pair<int, int> points_in_use(const Rational_bspline_curve<Traits>& curve) {
  return coefficients_in_use(curve.knots());
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// Decides whether a curve lies in a plane, in any dimension: the homogeneous control points \f$ (w_i b_i, w_i) \f$ that it depends on
/// span three dimensions at most. Exact with every kernel for the coordinates and weights as given. A line and a point are planar.
/// \f$ O(n) \f$ for `n` control points. Hagen 1.13.
/// \tparam Curve a Bézier, segmented or B-spline curve, or a rational one
template <class Curve> bool is_planar(const Curve& curve) {
  typedef typename Curve::Traits Traits;
  typedef internal::Decision_FT<Traits> Field;
  typedef Coordinate_vector<Field, dimension_v<Homogeneous_traits<Traits>>> Row;
  std::vector<Row> span; // orthogonal
  const std::pair<int, int> used = internal::points_in_use(curve);
  for (int i = used.first; i < used.second; ++i) {
    Field weight(1);
    if constexpr (internal::Is_rational<Curve>::value) weight = internal::to_field<Field>(curve.weight(i));
    const Row row = orthogonal_component(
        homogeneous_point(coordinates<Traits, Field>(curve.control_points()[static_cast<std::size_t>(i)]), weight),
        span);
    if (is_zero(row)) continue;
    span.push_back(row);
    if (span.size() > 3) return false;
  }
  return true;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_IS_PLANAR_H
