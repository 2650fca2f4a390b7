// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_PREDICATES_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_PREDICATES_H

#include <CGAL/Geometric_continuity/edges/bspline_edge_continuity.h>

#include <optional>

namespace CGAL {
namespace Geometric_continuity {

/// \file edge_predicates.h
/// One question about an edge of each of two surfaces, answered exactly on the whole closed edges and on the control points as
/// given, for every kernel. The answers are those of `edge_continuity()`, without its reasons and places. With `double`
/// coordinates, of whatever kernel, two Bézier patches are decided in stages: control points that differ are a gap; values
/// at the ends that exceed their proven rounding errors refute; integers of fixed length on a grid decide nearly all other
/// edges of degree 7 or less; and multi-precision numbers the rest.

namespace internal {

// In the ring of the common denominators.
template <int order, class Traits>
bool edge_has_order(const Bezier_patch<Traits>& a, Patch_edge edge_a, const Bezier_patch<Traits>& b,
                    Patch_edge edge_b) {
  typedef Edge_field<Traits> Field;
  Edge_sides<Field> sides(edge_rows(a, edge_a), edge_rows(b, edge_b));
  if (!sides.same_edge()) {
    sides.reverse_second();
    if (!sides.same_edge()) return false;
  }
  if (order == 0) return true;
  const Edge_normals<Field> normals(sides);
  return normals.coplanar() && normals.side_signs() == Sign_pattern::negative &&
         (order == 1 || normals.second_order(sides));
}

template <int order, class Traits, class Stages>
bool edge_has_order(const Bezier_patch<Traits>& a, Patch_edge edge_a, const Bezier_patch<Traits>& b, Patch_edge edge_b,
                    Stages& stages) {
  require_space(a, "edge predicate");
  require_space(b, "edge predicate");
  if (const std::optional<bool> answer = decide_on_patches<order>(a, edge_a, b, edge_b, stages)) return *answer;
  const bool answer = edge_has_order<order>(a, edge_a, b, edge_b);
  stages.decided(Edge_stage::multiprecision, answer);
  return answer;
}

// B-spline surfaces have the least order of their spans.
template <int order, class Surface_a, class Surface_b>
bool edge_predicate(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  const auto edge = edge_continuity(a, edge_a, b, edge_b);
  return order <= edge.g_order && edge.whole_a && edge.whole_b;
}
template <int order, class Traits>
bool edge_predicate(const Bezier_patch<Traits>& a, Patch_edge edge_a, const Bezier_patch<Traits>& b,
                    Patch_edge edge_b) {
  const All_edge_stages stages;
  return edge_has_order<order>(a, edge_a, b, edge_b, stages);
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Whether the edges are the same curve, whole, with the same parametrisation up to an affine map, in either direction.
/// \tparam Surface_a, Surface_b `Bezier_patch` or `Bspline_surface`, with one traits class
/// \throws Error `dimension_mismatch` unless in dimension 3; `not_finite` when the answer depends on a coordinate that is
///   infinite or not a number
template <class Surface_a, class Surface_b>
bool is_g0_edge(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  return internal::edge_predicate<0>(a, edge_a, b, edge_b);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Whether in addition the tangent planes agree along the whole closed edge and the surfaces lie on different sides of it. Forms
/// of degree 3 and 4. False where a normal vanishes.
/// \throws Error `dimension_mismatch` unless in dimension 3, `not_finite`
template <class Surface_a, class Surface_b>
bool is_g1_edge(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  return internal::edge_predicate<1>(a, edge_a, b, edge_b);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Whether in addition the curvatures agree, see `Edge_conditions`. A form of degree 7.
/// \throws Error `dimension_mismatch` unless in dimension 3, `not_finite`
template <class Surface_a, class Surface_b>
bool is_g2_edge(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  return internal::edge_predicate<2>(a, edge_a, b, edge_b);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_PREDICATES_H
