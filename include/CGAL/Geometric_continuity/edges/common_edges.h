// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_COMMON_EDGES_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_COMMON_EDGES_H

#include <CGAL/Geometric_continuity/edges/internal/Common_edge_part.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_normals.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// An edge of one patch and an edge of another that are the same curve.
struct Common_edge {
  Patch_edge edge_a; ///< of the first patch
  Patch_edge edge_b; ///< of the second patch
  bool reversed;     ///< they run in opposite directions
};

namespace internal {

// Whether two edges that are not single points are the same curve, and whether the second runs backwards.
template <class Traits>
std::optional<bool> common_edge_reversed(const Bezier_patch<Traits>& a, Patch_edge edge_a,
                                         const Bezier_patch<Traits>& b, Patch_edge edge_b) {
  Edge_sides<Edge_field<Traits>> sides(edge_rows(a, edge_a), edge_rows(b, edge_b));
  return sides.collapsed() ? std::nullopt : sides.align();
}
template <class Traits>
std::optional<bool> common_edge_reversed(const Rational_bezier_patch<Traits>& a, Patch_edge edge_a,
                                         const Rational_bezier_patch<Traits>& b, Patch_edge edge_b) {
  typedef Edge_field<Traits> Field;
  const std::vector<Edge_piece<Field, 4>> pieces_a = edge_pieces(a, edge_a), pieces_b = edge_pieces(b, edge_b);
  if (Edge_sides<Field, 4>(pieces_a[0].rows, pieces_b[0].rows).collapsed()) return std::nullopt;
  const std::optional<Edge_match<Field>> match = Common_edge_part<Field, 4>(pieces_a, pieces_b).whole();
  return match ? std::optional<bool>(match->map.reverses()) : std::nullopt;
}

template <class Patch> std::vector<Common_edge> all_common_edges(const Patch& a, const Patch& b) {
  std::vector<Common_edge> result;
  for (Patch_edge edge_a : patch_edges)
    for (Patch_edge edge_b : patch_edges) {
      if (&a == &b && !(edge_a < edge_b)) continue;
      const Work_on_object work("common_edges");
      if (const std::optional<bool> reversed = common_edge_reversed(a, edge_a, b, edge_b))
        result.push_back({edge_a, edge_b, *reversed});
    }
  return result;
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns all pairs of edges of `a` and `b` that are the same curve, and not a single point. The points of the edges and their
/// parametrisations, after exact elevation to one degree, are compared exactly; 16 pairs are tried. Two edges of the same
/// patch `a = b` are listed once; an edge is not paired with itself. For many patches see `model_continuity()`.
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit` for one pair
template <class Traits>
std::vector<Common_edge> common_edges(const Bezier_patch<Traits>& a, const Bezier_patch<Traits>& b) {
  return internal::all_common_edges(a, b);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns all pairs of edges of two rational patches that are the same curve, and not a single point, see the function for
/// `Bezier_patch`. The weights may differ by a constant factor.
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit` for one pair
template <class Traits>
std::vector<Common_edge> common_edges(const Rational_bezier_patch<Traits>& a, const Rational_bezier_patch<Traits>& b) {
  return internal::all_common_edges(a, b);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_COMMON_EDGES_H
