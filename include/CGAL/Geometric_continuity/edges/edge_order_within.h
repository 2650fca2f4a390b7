// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_ORDER_WITHIN_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_ORDER_WITHIN_H

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/edges/edge_deviation.h>
#include <CGAL/Geometric_continuity/edges/knot_line_continuity.h>
#include <CGAL/Geometric_continuity/numbers/Verdict.h>

#include <array>
#include <string>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// What is tolerated along an edge; see `Edge_deviation` for the quantities.
struct Edge_tolerance {
  Bound angle = 0; ///< of the normals, in radians
  Bound gap = 0;   ///< in units of the coordinates
};

/// \ingroup PkgGeometricContinuityContinuity
/// Whether two surfaces have the orders 0 and 1 along an edge within a tolerance. (The order 2 has no tolerance: it is decided
/// exactly by `edge_continuity()`.)
struct Edge_order_within {
  Edge_deviation deviation; ///< on which the verdicts rest
  /// For each order: the edges are the same; in addition the tangent planes agree and the surfaces continue each other.
  std::array<Verdict, 2> verdicts;

  /// Returns whether the surfaces have the order, 0 or 1, within the tolerance.
  /// \throws Error `jet_order_too_low` for another order
  Verdict operator()(int order) const {
    if (order < 0 || 1 < order)
      throw Error(Error_code::jet_order_too_low,
                  "Edge_order_within: only the orders 0 and 1 have a tolerance, not " + std::to_string(order));
    return verdicts[order];
  }
  /// Returns the largest order that is proved, -1 if none is.
  int proved_order() const { return verdicts[1] == Verdict::proved ? 1 : verdicts[0] == Verdict::proved ? 0 : -1; }
};

namespace internal {

inline void check_tolerance(const Edge_tolerance& tolerance) {
  for (const Bound& bound : {tolerance.angle, tolerance.gap}) check_bound(bound);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns the verdicts on a deviation: *proved* when its enclosures are within the tolerance, *refuted* when one exceeds it,
/// otherwise *undecided*. A normal that vanishes somewhere refutes the order 1: there is no tangent plane.
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
/// Returns the verdicts on edges that have been decided to be the same, at least in part, along the part that they have in
/// common. An order that the surfaces have exactly is proved with each tolerance.
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number; `curves_do_not_meet` when the
///   edges have nothing in common (`edge.g_order < 0`): then their gap is not known, which `deviation()` of the surfaces
///   encloses
template <class FT>
Edge_order_within order_within(const Spline_edge_continuity<FT>& edge, const Edge_tolerance& tolerance) {
  internal::check_tolerance(tolerance);
  if (edge.g_order < 0) throw Error(Error_code::curves_do_not_meet, "order_within: the edges have nothing in common");
  Edge_deviation d{{0, 0}, {}, edge.normal_vanishes, edge.reversed};
  if (edge.deviation) d.normal_angle = edge.deviation->angle();
  return order_within(d, tolerance);
}

namespace internal {

// From the exact decision, and the deviation if it is needed.
template <class FT, class Deviation>
Edge_order_within order_within_or_exactly(const Spline_edge_continuity<FT>& exact, Deviation deviation,
                                          const Edge_tolerance& tolerance) {
  const bool meet = 0 <= exact.g_order;
  if (meet && exact.whole_a && exact.whole_b) return order_within(exact, tolerance);
  const Edge_order_within whole = order_within(deviation(), tolerance);
  return meet && whole(0) == Verdict::refuted ? order_within(exact, tolerance) : whole;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Decides which order, 0 or 1, two piecewise polynomial surfaces have along an edge within a tolerance. What counts is
/// `deviation()` along the whole edges; where these are farther apart than the tolerance but have a part exactly in common, see
/// `edge_continuity()`, this part counts.
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number, `wrong_number_of_points` when
///   the rows do not fit the knots, `not_finite`, `work_limit`
template <class FT, int N>
Edge_order_within order_within(const Spline_edge_rows<FT, N>& a, const Spline_edge_rows<FT, N>& b,
                               const Edge_tolerance& tolerance) {
  internal::check_tolerance(tolerance);
  return internal::order_within_or_exactly(
      edge_continuity(a, b), [&] { return deviation(a, b); }, tolerance);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides which order, 0 or 1, two surfaces have along an edge of each within a tolerance, see the function for
/// `Spline_edge_rows`. Edges that have nothing in common, exactly or within the tolerance, are refuted, with their gap.
/// \tparam Surface_a, Surface_b `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or `Rational_bspline_surface`, in any
///   combination, with one traits class
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number; `dimension_mismatch` unless
///   in dimension 3; `work_limit`
template <class Surface_a, class Surface_b>
Edge_order_within order_within(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                               const Edge_tolerance& tolerance) {
  internal::check_tolerance(tolerance);
  return internal::order_within_or_exactly(
      edge_continuity(a, edge_a, b, edge_b), [&] { return deviation(a, edge_a, b, edge_b); }, tolerance);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides which order, 0 or 1, a B-spline surface has along one of its knot lines within a tolerance. Where the surface jumps
/// its two parts are compared at equal parameters.
/// \tparam Surface `Bspline_surface` or `Rational_bspline_surface`
/// \param surface the surface
/// \param line one of `knot_line_continuity(surface)`
/// \param tolerance for the gap and for the order 1
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number; `knot_multiplicity` when
///   the surface jumps along `line`, but has no inner knot there; `work_limit`
template <class Surface>
Edge_order_within order_within(const Surface& surface, const Knot_line<Edge_field<typename Surface::Traits>>& line,
                               const Edge_tolerance& tolerance) {
  typedef Edge_field<typename Surface::Traits> Field;
  internal::check_tolerance(tolerance);
  if (0 <= line.continuity.g_order) return order_within(line.continuity, tolerance);
  const Parameter_line direction = line.constant_u ? Parameter_line::along_v : Parameter_line::along_u;
  for (const auto& knot : internal::knots_across(surface, direction).inner_knots())
    if (internal::to_field<Field>(knot.value) == line.knot)
      return order_within(internal::deviation_at_same_parameters(
                              internal::knot_line_rows(surface, direction, knot.value, Line_side::smaller_parameters),
                              internal::knot_line_rows(surface, direction, knot.value, Line_side::larger_parameters)),
                          tolerance);
  throw Error(Error_code::knot_multiplicity, "order_within: not a knot line of the surface");
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_ORDER_WITHIN_H
