// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_CURVE_DEVIATION_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_CURVE_DEVIATION_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/edges/Cad_geometry.h>
#include <CGAL/Geometric_continuity/edges/Edge_enclosure.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_bounds.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The square of the distance of a side from points that are given.
inline Bounds_on_range distance_on(const Edge_range& range, const Placed_side& side, const Taylor_vector& points) {
  Bounds_on_range bounds{0, 0, range.middle, false};
  std::optional<double> at;
  for (const Side_models& x : side.models(range, Edge_quantity::gap)) {
    Bounds_on_range of_piece = square_on(range, x.point - points, at);
    if (!of_piece.defined) return of_piece;
    if (at) {
      of_piece.lower = (std::min)(bounds.lower, of_piece.lower);
      of_piece.upper = (std::max)(bounds.upper, of_piece.upper);
    }
    bounds = of_piece;
    at = bounds.parameter;
  }
  return bounds;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCadEdges
/// Encloses the largest distance \f$ |S(c(t)) - C(t)| \f$ of a side of an edge and the edge as a curve in space, at equal parameters over the
/// range `[first, last]`, as `edge_enclosure()` encloses gaps. The upper end is infinite where the work does not suffice.
/// \throws Error as `edge_enclosure()`
inline Edge_maximum curve_deviation(const Edge_side& side, const Edge_curve& curve, double first, double last,
                                    const Edge_precision& precision = Edge_precision()) {
  using namespace internal;
  check_range(first, last, "curve_deviation: the range");
  const Protect_FPU_rounding<true> rounding_upwards;
  const Placed_side placed_side(side);
  const Placed_curve placed(curve);
  for (double t : {first, last}) cad_domain(*curve.curve).check(t, "the range of an edge");
  std::vector<double> ends = divided_range({&side}, first, last);
  for (double k : inner_knots(*curve.curve))
    if (first < k && k < last) ends.push_back(k);
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  const auto square = [](double x) { return std::sqrt(x); };
  const Largest_on_ranges distance(
      ends, {precision.relative, precision.gap, square, precision.boxes, precision.most_boxes},
      [&](double lower, double upper) {
        const Edge_range range(lower, upper);
        return distance_on(range, placed_side, placed.models(range));
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

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_CURVE_DEVIATION_H
