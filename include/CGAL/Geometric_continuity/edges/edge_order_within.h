// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_ORDER_WITHIN_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_ORDER_WITHIN_H

#include <CGAL/Geometric_continuity/edges/edge_deviation.h>
#include <CGAL/Geometric_continuity/edges/spline_edge_continuity.h>
#include <CGAL/Geometric_continuity/joins/Verdict.h>

#include <array>
#include <string>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// What is tolerated along an edge; see `Edge_deviation` for the quantities.
struct Edge_tolerance {
  double angle = 0; ///< of the normals, in radians
  double gap = 0;   ///< in units of the coordinates
};

/// \ingroup PkgGeometricContinuityContinuity
/// Whether two surfaces have the orders 0 and 1 along an edge within a tolerance. (The order 2 has no tolerance: it is decided
/// exactly by `edge_continuity()`.)
struct Edge_order_within {
  Edge_deviation deviation; ///< on which the verdicts rest
  /// For each order: the edges are the same; in addition the tangent planes agree and the surfaces continue each other.
  std::array<Verdict, 2> verdicts;

  /// Whether the surfaces have the order, 0 or 1, within the tolerance.
  Verdict operator()(int order) const { return verdicts[order]; }
  /// The largest order that is proved, -1 if none is.
  int proved_order() const { return verdicts[1] == Verdict::proved ? 1 : verdicts[0] == Verdict::proved ? 0 : -1; }
};

namespace internal {

inline void check_tolerance(const Edge_tolerance& tolerance) {
  for (double bound : {tolerance.angle, tolerance.gap})
    if (!(0 <= bound)) throw Error(Error_code::unreachable_tolerance, "order_within: " + std::to_string(bound));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// The verdicts on a deviation: *proved* when its enclosures are within the tolerance, *refuted* when one exceeds it, otherwise
/// *undecided*. A normal that vanishes somewhere refutes the order 1: there is no tangent plane.
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number
inline Edge_order_within order_within(const Edge_deviation& deviation, const Edge_tolerance& tolerance) {
  internal::check_tolerance(tolerance);
  const Verdict gap = at_most(deviation.gap, tolerance.gap),
                angle = deviation.normal_angle && !deviation.normal_vanishes
                            ? at_most(*deviation.normal_angle, tolerance.angle)
                            : Verdict::refuted;
  return {deviation, {gap, gap && angle}};
}

/// \ingroup PkgGeometricContinuityContinuity
/// The same for edges that have been decided to be the same, at least in part, along the part that they have in common. An
/// order that the surfaces have exactly is proved with each tolerance.
/// \pre `edge.g_order >= 0`
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number
template <class FT>
Edge_order_within order_within(const Spline_edge_continuity<FT>& edge, const Edge_tolerance& tolerance) {
  CGAL_precondition(0 <= edge.g_order);
  Edge_deviation d{{0, 0}, {}, edge.normal_vanishes, edge.reversed};
  if (edge.deviation) d.normal_angle = edge.deviation->angle();
  return order_within(d, tolerance);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides which order two piecewise polynomial surfaces have along an edge within a tolerance. What counts is
/// `deviation()` along the whole edges; where these are farther apart than the tolerance but have a part exactly in common, see
/// `edge_continuity()`, this part counts.
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number, `wrong_number_of_points` when
///   the rows do not fit the knots, `not_finite`
template <class FT>
Edge_order_within order_within(const Spline_edge_rows<FT>& a, const Spline_edge_rows<FT>& b,
                               const Edge_tolerance& tolerance) {
  internal::check_tolerance(tolerance);
  const auto exact = edge_continuity(a, b);
  if (0 <= exact.g_order && exact.whole_a && exact.whole_b) return order_within(exact, tolerance);
  const Edge_order_within whole = order_within(deviation(a, b), tolerance);
  return 0 <= exact.g_order && whole(0) == Verdict::refuted ? order_within(exact, tolerance) : whole;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_ORDER_WITHIN_H
