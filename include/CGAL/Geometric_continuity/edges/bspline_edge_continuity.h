// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_BSPLINE_EDGE_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_BSPLINE_EDGE_CONTINUITY_H

#include <CGAL/Geometric_continuity/edges/patch_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// The rows of a B-spline surface along one of its edges, in the field in which continuity is decided. Control points and
/// knots are converted before anything is computed.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Spline_edge_rows<Edge_field<Traits>> spline_edge_rows(const Bspline_surface<Traits>& surface, Patch_edge edge) {
  internal::require_space(surface, "spline_edge_rows");
  typedef Edge_field<Traits> Field;
  return {internal::knots_over<Field>(surface.knots_along(edge)),
          internal::edge_rows_in_space<Field>(surface.template rows<Field>(edge, 2))};
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides the continuity of two B-spline surfaces along an edge of each, exactly, on the whole closed edge and with every
/// kernel: control points and knots are taken as they are given. The result has a verdict for each span of the knots of both
/// edges. The edges may differ in direction, degree, knots and domain, or have only a part in common, see the function for
/// `Spline_edge_rows`. All parameters in the result are those of the edge of `a`, without rounding.
///
/// What happens at knots across the edge inside one of the surfaces is decided by `knot_line_continuity()`.
///
/// Linear in the number of knots for edges that are the same. \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Spline_edge_continuity<Edge_field<Traits>> edge_continuity(const Bspline_surface<Traits>& a, Patch_edge edge_a,
                                                           const Bspline_surface<Traits>& b, Patch_edge edge_b) {
  return edge_continuity(spline_edge_rows(a, edge_a), spline_edge_rows(b, edge_b));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// The same for a B-spline surface and a Bézier patch.
template <class Traits>
Spline_edge_continuity<Edge_field<Traits>> edge_continuity(const Bspline_surface<Traits>& a, Patch_edge edge_a,
                                                           const Bezier_patch<Traits>& b, Patch_edge edge_b) {
  return edge_continuity(spline_edge_rows(a, edge_a), spline_edge_rows(b, edge_b));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// The same for a Bézier patch and a B-spline surface.
template <class Traits>
Spline_edge_continuity<Edge_field<Traits>> edge_continuity(const Bezier_patch<Traits>& a, Patch_edge edge_a,
                                                           const Bspline_surface<Traits>& b, Patch_edge edge_b) {
  return edge_continuity(spline_edge_rows(a, edge_a), spline_edge_rows(b, edge_b));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_BSPLINE_EDGE_CONTINUITY_H
