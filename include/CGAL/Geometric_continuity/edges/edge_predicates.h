// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_PREDICATES_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_PREDICATES_H

#include <CGAL/Geometric_continuity/edges/internal/Common_edge_part.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_normals.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_ladder.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \file edge_predicates.h
/// One question about an edge of each of two surfaces, answered exactly on the whole closed edges and on the control points as
/// given, for every kernel. The answers are those of `edge_continuity()`, without its reasons and places. Two surfaces without
/// inner knots whose coordinates are `double`, of whatever kernel, or rational numbers with short numerators, and the spans
/// of other surfaces, are decided in stages: control points that differ are a gap; values at the ends that exceed their
/// proven rounding errors refute; integers of fixed length on a grid decide nearly all other edges of degree 7 or less; and
/// multi-precision numbers the rest.

namespace internal {

// Along rows with the same edge, in one direction.
template <int order, class Field, int N, class Stages>
bool rows_have_order(const Edge_rows<Field, N>& a, const Edge_rows<Field, N>& b, Stages& stages) {
  if constexpr (N == 3) {
    Edge_layers x, y;
    if (edge_layers(a, b, x, y))
      if (const std::optional<bool> answer = decide_on_same_edge<order>(x, y, stages)) return *answer;
  }
  const Edge_sides<Field, N> sides(a, b);
  const Edge_normals<Field, N> normals(sides);
  const bool answer = normals.first_order() && (order == 1 || normals.second_order(sides));
  stages.decided(Edge_stage::multiprecision, answer);
  return answer;
}

// In the ring of the common denominators, for edges that are one polynomial each.
template <int order, class Field> bool polynomials_have_order(const Edge_rows<Field>& a, const Edge_rows<Field>& b) {
  Edge_sides<Field> sides(a, b);
  if (!sides.align()) return false;
  if (order == 0) return true;
  const Edge_normals<Field> normals(sides);
  return normals.first_order() && (order == 1 || normals.second_order(sides));
}

template <int order, class Surface_a, class Surface_b, class Stages>
bool edge_has_order(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b, Stages& stages) {
  typedef Edge_field<typename Surface_a::Traits> Field;
  constexpr int N = row_dimension<Surface_a, Surface_b>;
  require_space(a, b, "edge predicate");
  if constexpr (N == 4)
    if (has_equal_weights(a) && has_equal_weights(b))
      return edge_has_order<order>(without_weights(a), edge_a, without_weights(b), edge_b, stages);
  if constexpr (N == 3) {
    Edge_layers x, y;
    if (edge_layers(a, edge_a, b, edge_b, order, x, y))
      if (const std::optional<bool> answer = decide_on_layers<order>(x, y, stages)) return *answer;
  }
  const Work_on_object work("edge predicate");
  const std::vector<Edge_piece<Field, N>> pieces_a = edge_pieces_in<N>(a, edge_a),
                                          pieces_b = edge_pieces_in<N>(b, edge_b);
  if constexpr (N == 3)
    if (is_one_patch(a) && is_one_patch(b)) {
      const bool answer = polynomials_have_order<order>(pieces_a[0].rows, pieces_b[0].rows);
      stages.decided(Edge_stage::multiprecision, answer);
      return answer;
    }
  const std::optional<Edge_match<Field>> match = Common_edge_part<Field, N>(pieces_a, pieces_b).whole();
  if (!match || order == 0) {
    stages.decided(Edge_stage::multiprecision, match.has_value());
    return match.has_value();
  }
  return std::all_of(match->spans.begin(), match->spans.end(), [&](const Common_span<Field>& span) {
    const std::pair<Edge_rows<Field, N>, Edge_rows<Field, N>> rows = rows_on(pieces_a, pieces_b, span, match->map);
    return rows_have_order<order>(rows.first, rows.second, stages);
  });
}

template <int order, class Surface_a, class Surface_b>
bool edge_has_order(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  const All_edge_stages stages;
  return edge_has_order<order>(a, edge_a, b, edge_b, stages);
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns whether the edges are the same curve, whole, with the same parametrisation up to an affine map, in either direction.
/// \tparam Surface_a, Surface_b `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or `Rational_bspline_surface`, with one
///   traits class
/// \throws Error `dimension_mismatch` unless in dimension 3; `not_finite` when the answer depends on a coordinate that is
///   infinite or not a number; `work_limit`
template <class Surface_a, class Surface_b>
bool is_g0_edge(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  return internal::edge_has_order<0>(a, edge_a, b, edge_b);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns whether the edges are the same, see `is_g0_edge()`, the tangent planes agree along the whole closed edge and the
/// surfaces lie on different sides of it. Decides the signs of forms of degree 3 and 4. False where a normal vanishes.
/// \tparam Surface_a, Surface_b `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or `Rational_bspline_surface`, with one
///   traits class
/// \throws Error `dimension_mismatch` unless in dimension 3, `not_finite`, `work_limit`
template <class Surface_a, class Surface_b>
bool is_g1_edge(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  return internal::edge_has_order<1>(a, edge_a, b, edge_b);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns whether the surfaces are \f$ G^1 \f$ along the edges, see `is_g1_edge()`, and their curvatures agree, see
/// `Edge_conditions`. Decides whether a form of degree 7 vanishes.
/// \tparam Surface_a, Surface_b `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or `Rational_bspline_surface`, with one
///   traits class
/// \throws Error `dimension_mismatch` unless in dimension 3, `not_finite`, `work_limit`
template <class Surface_a, class Surface_b>
bool is_g2_edge(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  return internal::edge_has_order<2>(a, edge_a, b, edge_b);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_PREDICATES_H
