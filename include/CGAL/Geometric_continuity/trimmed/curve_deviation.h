// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_TRIMMED_CURVE_DEVIATION_H
#define CGAL_GEOMETRIC_CONTINUITY_TRIMMED_CURVE_DEVIATION_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/trimmed/Edge_enclosure.h>
#include <CGAL/Geometric_continuity/trimmed/Parametric_geometry.h>
#include <CGAL/Geometric_continuity/trimmed/internal/edge_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityTrimmed
/// Encloses the largest distance \f$ |S(c(t)) - C(t)| \f$ of a side of an edge and the edge as a curve in space, at equal parameters over the
/// range `[first, last]`, as `edge_enclosure()` encloses gaps. The upper end is infinite where the work does not suffice.
/// \throws Error as `edge_enclosure()`
inline Edge_maximum curve_deviation(const Edge_side& side, const Edge_curve& curve, double first, double last,
                                    const Edge_precision& precision = Edge_precision()) {
  using namespace internal;
  check_range(first, last, "curve_deviation: the range");
  const Protect_FPU_rounding<true> rounding_upwards;
  const Edge_bounds bounds(side, side);
  const Placed_curve placed(curve);
  for (double t : {first, last}) given_domain(*curve.curve).check(t, "the range of an edge");
  std::vector<double> ends = bounds.divided(first, last);
  for (double k : inner_knots(*curve.curve))
    if (first < k && k < last) ends.push_back(k);
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  const auto square = [](double x) { return std::sqrt(x); };
  const Largest_on_ranges distance(
      ends, {precision.relative, precision.gap, square, precision.boxes, precision.most_boxes},
      [&](double lower, double upper) {
        const Edge_range range(lower, upper);
        return bounds.distance(range, placed.models(range));
      },
      [](double, double) { return false; });
  const bool bounded = distance.unresolved.empty() && std::isfinite(distance.upper);
  const auto [point, derivative] = placed.jet(distance.parameter);
  return {{distance.defined ? root_below(distance.lower) : 0,
           bounded ? root_above(distance.upper) : (std::numeric_limits<double>::infinity)()},
          distance.parameter,
          {middle(point[0]), middle(point[1]), middle(point[2])}};
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_TRIMMED_CURVE_DEVIATION_H
