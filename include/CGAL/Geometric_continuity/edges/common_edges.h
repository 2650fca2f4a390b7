// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_COMMON_EDGES_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_COMMON_EDGES_H

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

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns all pairs of edges of `a` and `b` that are the same curve, and not a single point. The points of the edges and their
/// parametrisations, after exact elevation to one degree, are compared exactly; 16 pairs are tried. Two edges of the same
/// patch `a = b` are listed once; an edge is not paired with itself. For many patches see `model_continuity()`.
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit` for one pair
template <class Traits>
std::vector<Common_edge> common_edges(const Bezier_patch<Traits>& a, const Bezier_patch<Traits>& b,
                                      Work_limit limit = Work_limit()) {
  std::vector<Common_edge> result;
  for (Patch_edge edge_a : patch_edges)
    for (Patch_edge edge_b : patch_edges) {
      if (&a == &b && !(edge_a < edge_b)) continue;
      internal::Work_meter work(limit, "common_edges");
      internal::Edge_sides<Edge_field<Traits>> sides(edge_rows(a, edge_a), edge_rows(b, edge_b), work);
      if (sides.collapsed()) continue;
      if (const std::optional<bool> reversed = sides.align()) result.push_back({edge_a, edge_b, *reversed});
    }
  return result;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_COMMON_EDGES_H
