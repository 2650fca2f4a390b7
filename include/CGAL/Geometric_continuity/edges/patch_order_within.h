// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_PATCH_ORDER_WITHIN_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_PATCH_ORDER_WITHIN_H

#include <CGAL/Geometric_continuity/edges/edge_order_within.h>
#include <CGAL/Geometric_continuity/edges/knot_line_continuity.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_conversion.h>

#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// How far two surfaces are from being continuous along an edge of each: guaranteed enclosures of the largest distance of the
/// edges, whose domains correspond as a whole in the direction that makes it smaller, and of the largest angle of the normals.
/// Exact up to the last rounding, with every kernel.
/// \tparam Surface_a, Surface_b `Bezier_patch` or `Bspline_surface`, with one traits class
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Surface_a, class Surface_b>
Edge_deviation deviation(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  return deviation(spline_edge_rows(a, edge_a), spline_edge_rows(b, edge_b));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides which order, 0 or 1, two surfaces have along an edge of each within a tolerance, see the function for
/// `Spline_edge_rows`.
/// \tparam Surface_a, Surface_b `Bezier_patch` or `Bspline_surface`, with one traits class
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number; `dimension_mismatch` unless
///   in dimension 3
template <class Surface_a, class Surface_b>
Edge_order_within order_within(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                               const Edge_tolerance& tolerance) {
  return order_within(spline_edge_rows(a, edge_a), spline_edge_rows(b, edge_b), tolerance);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides which order, 0 or 1, a B-spline surface has along one of its knot lines within a tolerance.
/// \pre `line` is one of `knot_line_continuity(surface)`
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number
template <class Traits>
Edge_order_within order_within(const Bspline_surface<Traits>& surface, const Knot_line<Edge_field<Traits>>& line,
                               const Edge_tolerance& tolerance) {
  typedef Edge_field<Traits> Field;
  if (0 <= line.continuity.g_order) return order_within(line.continuity, tolerance);
  for (const auto& knot : (line.constant_u ? surface.knots_u() : surface.knots_v()).inner_knots())
    if (internal::to_field<Field>(knot.value) == line.knot)
      return order_within(
          internal::deviation_at_same_parameters(internal::knot_line_rows(surface, line.constant_u, knot.value, true),
                                                 internal::knot_line_rows(surface, line.constant_u, knot.value, false)),
          tolerance);
  throw Error(Error_code::knot_multiplicity, "order_within: not a knot line of the surface");
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_PATCH_ORDER_WITHIN_H
