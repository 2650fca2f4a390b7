// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_FOOT_POINTS_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_FOOT_POINTS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/edges/Cad_geometry.h>
#include <CGAL/Geometric_continuity/edges/cad_edge_continuity.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_bounds.h>
#include <CGAL/Geometric_continuity/edges/internal/Foot_finder.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

/// \file foot_points.h
/// The points of a surface that are next to a curve in space: where a file gives an edge in space only, its curve in the parameter plane of a
/// face is that of these foot points, and one that a system has computed is close to it at best.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The square of the distance of a side from points that are given.
inline Bounds_on_range distance_on(const Edge_range& range, const Placed_side& side, const Taylor_vector& points) {
  Bounds_on_range bounds{0, 0, range.middle, false};
  std::optional<double> at;
  for (const Side_models& x : side.models(range, Edge_quantity::gap)) {
    const Bounds_on_range of_piece = square_on(range, x.point - points, at);
    if (!of_piece.defined) return of_piece;
    include(of_piece, bounds, at);
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

/// \ingroup PkgGeometricContinuityCadEdges
/// Returns the side with another curve in its parameter plane: a cubic spline, continuously differentiable, through the foot points of
/// the curve in space at the ends of `pieces` equal parts of `[first, last]` and at the knots of that curve. They are computed in rounded numbers by
/// Newton's method, which starts at the curve of the side; `curve_deviation()` tells how good the result is.
/// \throws Error as `edge_enclosure()`
inline Edge_side projected_side(const Edge_side& side, const Edge_curve& curve, double first, double last, int pieces) {
  using namespace internal;
  check_range(first, last, "projected_side: the range");
  const Protect_FPU_rounding<true> rounding_upwards;
  const Placed_side placed(side);
  const Placed_curve in_space(curve);
  const Foot_finder finder(placed, in_space);
  std::vector<double> t = inner_knots(*curve.curve);
  t.erase(std::remove_if(t.begin(), t.end(), [=](double x) { return !(first < x && x < last); }), t.end());
  for (int i = 0; i <= pieces; ++i) t.push_back(i == pieces ? last : first + i * ((last - first) / pieces));
  std::sort(t.begin(), t.end());
  const double shortest = (last - first) * 1e-6;
  std::vector<double> ends{first}; // without parts that are very short
  for (double x : t)
    if (x - ends.back() > shortest && last - x > shortest) ends.push_back(x);
  ends.push_back(last);
  Cad_spline_curve<2> result{3, {}, {}, {}};
  std::vector<Foot_finder::Foot> feet;
  for (double x : ends) feet.push_back(finder.near_curve(x));
  const auto point = [](const Foot_finder::Foot& f, double factor) {
    return Cad_point<2>{f.point[0] + factor * f.derivative[0], f.point[1] + factor * f.derivative[1]};
  };
  result.points.push_back(feet.front().point);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double third = (ends[i + 1] - ends[i]) / 3;
    result.points.push_back(point(feet[i], third));
    result.points.push_back(point(feet[i + 1], -third));
  }
  result.points.push_back(feet.back().point);
  for (std::size_t i = 0; i < ends.size(); ++i)
    result.knots.insert(result.knots.end(), i == 0 || i + 1 == ends.size() ? 4 : 2, ends[i]);
  Edge_side projected = side;
  projected.curve = std::make_shared<const Cad_curve<2>>(std::move(result));
  return projected;
}

/// \ingroup PkgGeometricContinuityCadEdges
/// What holds at one parameter of an edge that is a curve in space, whatever curves in parameter planes have been computed: lower bounds.
struct Foot_comparison {
  std::array<double, 2>
      distances;         ///< of the point of the curve and its foot points on both sides, in units of the coordinates
  double gap;            ///< of the foot points
  double angle;          ///< of the oriented normals there, in radians
  double curvature_jump; ///< relative, see `Edge_enclosure::curvature_jump`
};

/// \ingroup PkgGeometricContinuityCadEdges
/// Compares two faces at the foot points of a curve in space at the parameter `t`: those for which it is proved, by interval arithmetic
/// and Krawczyk's test, that they exist and are the only ones near the curves of the sides. A side for which `is_projected` is false is compared at the
/// point of its own curve. Returns nothing when it cannot be proved, e.g. where a surface is singular, or on a knot line.
/// \throws Error as `edge_enclosure()`
inline std::optional<Foot_comparison> compare_at_feet(const Edge_side& a, const Edge_side& b,
                                                      const std::array<bool, 2>& is_projected, const Edge_curve& curve,
                                                      double t,
                                                      double flat_curvature = Edge_precision().flat_curvature) {
  using namespace internal;
  const Protect_FPU_rounding<true> rounding_upwards;
  const Placed_curve in_space(curve);
  const auto at = in_space.jet(t);
  std::array<std::optional<Foot_finder::Enclosed>, 2> feet;
  std::array<double, 2> distances{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Placed_side side(i == 0 ? a : b);
    const Foot_finder finder(side, in_space);
    feet[i] = finder.enclosed(t, is_projected[i]);
    if (!feet[i]) return std::nullopt;
    distances[i] = length_below(feet[i]->point, at[0]);
  }
  const Foot_finder::Enclosed &x = *feet[0], &y = *feet[1];
  Interval chord = 0;
  for (int k = 0; k < 3; ++k) chord += square(x.normal[k] - y.normal[k]);
  const double angle = chord.inf() >= 0 ? angle_of_chord_square(chord.inf()).lower : 0;
  const Interval difference = x.curvature - y.curvature;
  const double least = (std::max)({0., difference.inf(), -difference.sup()}),
               largest = (std::max)({magnitude(x.curvature), magnitude(y.curvature), flat_curvature});
  const double jump = least > 0 ? (Interval(least) / Interval(largest)).inf() : 0;
  return Foot_comparison{distances, length_below(x.point, y.point), angle, jump};
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_FOOT_POINTS_H
