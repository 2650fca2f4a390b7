// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_CONTROL_POLYGON_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_CONTROL_POLYGON_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <string>
#include <vector>

/// \file control_polygon.h
/// Two tricks with the control polygon of a Bézier curve: points that pull, and polygons that close. Lecture slides, "Bézier
/// curve tricks".

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// Returns the curve whose control polygon has `times` more copies of the `i`-th control point: it is pulled towards this point,
/// whose weight at `t` grows from \f$ B_i^m(t) \f$ to \f$ B_i^{m+1}(t) + B_{i+1}^{m+1}(t) \f$ when doubled. The degree rises
/// by `times`. Lecture slides, "Bézier curve tricks I".
/// \f$ O(m + times) \f$
/// \throws Error `wrong_number_of_points` unless `0 <= i <= m`, `negative_count` unless `times >= 0`
template <class Traits, int Degree>
Bezier_curve<Traits> repeat_control_point(const Bezier_curve<Traits, Degree>& curve, int i, int times = 1) {
  internal::check_count(times, "repeat_control_point");
  if (i < 0 || i > curve.degree())
    throw Error(Error_code::wrong_number_of_points, "repeat_control_point: point " + std::to_string(i) +
                                                        " in a curve of degree " + std::to_string(curve.degree()));
  std::vector<typename Traits::Point> points(curve.begin(), curve.end());
  points.insert(points.begin() + i, times, curve.control_point(i));
  return Bezier_curve<Traits>(points.begin(), points.end(), curve.domain().first, curve.domain().second);
}

/// \ingroup PkgGeometricContinuityCurves
/// How a single Bézier curve closes up.
enum class Closing {
  open,    ///< the end points differ
  smooth,  ///< the tangents at the closing point have one direction
  cusp,    ///< they are opposite
  corner,  ///< they are not parallel
  singular ///< the first or the last leg of the polygon is zero, so that it does not give the tangent
};

/// \ingroup PkgGeometricContinuityCurves
/// Returns the name of a way to close, as spelled in the enumeration.
inline std::string to_string(Closing closing) {
  switch (closing) {
  case Closing::open: return "open";
  case Closing::smooth: return "smooth";
  case Closing::cusp: return "cusp";
  case Closing::corner: return "corner";
  case Closing::singular: return "singular";
  }
  return "unknown";
}

/// \ingroup PkgGeometricContinuityCurves
/// Decides how a curve closes, exactly with exact kernels and with `Exact_predicates_inexact_constructions_kernel`: smooth if
/// and only if \f$ b_1 - b_0 \f$ and \f$ b_m - b_{m-1} \f$ are nonzero \em positive multiples. Lecture slides, "Bézier curve
/// tricks II", corrected: collinear is not enough. \f$ O(1) \f$
template <class Traits, int Degree> Closing closing(const Bezier_curve<Traits, Degree>& curve) {
  typedef Predicate_FT<Traits> Field;
  typedef Coordinate_vector<Field, dimension_v<Traits>> Coordinates;
  const int m = curve.degree();
  const auto point = [&](int i) { return Geometric_continuity::coordinates<Traits, Field>(curve.control_point(i)); };
  if (point(0) != point(m)) return Closing::open;
  if (m == 0) return Closing::singular;
  const Coordinates first = point(1) - point(0), last = point(m) - point(m - 1);
  if (is_zero(first) || is_zero(last)) return Closing::singular;
  const Field a = dot(first, last);
  if (dot(first, first) * last != a * first) return Closing::corner;
  return Field(0) < a ? Closing::smooth : Closing::cusp;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_CONTROL_POLYGON_H
