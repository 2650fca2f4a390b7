// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_PATCH_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_PATCH_CONTINUITY_H

#include <CGAL/Geometric_continuity/edges/internal/patch_edge_decision.h>
#include <CGAL/Geometric_continuity/edges/spline_edge_continuity.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_conversion.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// The field in which the continuity of surfaces is decided: that of the predicates of the traits class, or
/// `Exact_rational` if those are floating-point numbers. The decision is exact with every kernel.
template <class Traits> using Edge_field = typename Exact_field<Predicate_FT<Traits>>::type;

namespace internal {

template <class Surface> void require_space(const Surface& surface, const char* function) {
  static_assert(Surface::N == 0 || Surface::N == 3, "surfaces are compared in dimension 3");
  if (surface.dimension() != 3)
    throw Error(Error_code::dimension_mismatch, std::string(function) + ": surfaces are compared in dimension 3");
}

// From the rows 0, 1 and 2.
template <class Field, class Rows> Edge_rows<Field> edge_rows_in_space(const Rows& rows) {
  const auto in_space = [](const auto& row) {
    typename Edge_rows<Field>::Row result;
    for (const auto& x : row) {
      result.emplace_back(3);
      for (int i = 0; i < 3; ++i) result.back()[i] = x[i];
    }
    return result;
  };
  return {in_space(rows[0]), in_space(rows[1]), in_space(rows[2])};
}

// Of two whole edges along which the surfaces have been decided to be smooth.
template <class Field>
Spline_edge_continuity<Field> smooth_continuity(const Smooth_edge& edge, const std::pair<Field, Field>& domain_a,
                                                const std::pair<Field, Field>& domain_b) {
  Edge_continuity<Field> e;
  e.g_order = edge.order;
  e.defect = edge.order == 2 ? Edge_defect::none : Edge_defect::curvature;
  e.reversed = edge.reversed;
  e.coplanar = true;
  e.side = Sign_pattern::negative;
  e.deviation = Normal_deviation<Field>{Field(0), Field(0), domain_a.first, domain_a.second};
  Spline_edge_continuity<Field> result;
  static_cast<Edge_continuity<Field>&>(result) = e;
  result.spans.push_back({domain_a.first, domain_a.second, e});
  result.part_a = domain_a;
  result.part_b = domain_b;
  result.whole_a = result.whole_b = true;
  return result;
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// The rows of a patch along one of its edges, with the patch taken on the unit square and turned so that the edge is at
/// `v = 0`. Continuity does not depend on the lengths of the domain. The control points are converted to `Field` before
/// anything is computed.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Field, class Traits>
Edge_rows<Field> edge_rows_over(const Bezier_patch<Traits>& patch, Patch_edge edge) {
  internal::require_space(patch, "edge_rows");
  return internal::edge_rows_in_space<Field>(patch.template rows<Field>(edge, 2));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// The rows in the field in which continuity is decided.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits> Edge_rows<Edge_field<Traits>> edge_rows(const Bezier_patch<Traits>& patch, Patch_edge edge) {
  return edge_rows_over<Edge_field<Traits>>(patch, edge);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// The same rows as splines over the domain of the edge.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Spline_edge_rows<Edge_field<Traits>> spline_edge_rows(const Bezier_patch<Traits>& patch, Patch_edge edge) {
  typedef Edge_field<Traits> Field;
  const typename Bezier_patch<Traits>::Interval domain = patch.domain(edge);
  return {Knot_vector<Field>(patch.degree_along(edge), internal::to_field<Field>(domain.first),
                             internal::to_field<Field>(domain.second)),
          edge_rows(patch, edge)};
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides the continuity of two patches along an edge of each, exactly, on the whole closed edge and with every kernel:
/// the control points are taken as they are given. The edge of `b` may run backwards, and degrees and domains may differ.
/// When the edges are not the same, the part that they have in common is decided, e.g. where several patches meet one long
/// edge; members of the result say which part of each edge it is. See the function for `Spline_edge_rows`.
///
/// All parameters in the result are those of the domain of the edge of `a`, without rounding. For two edges of one patch
/// that closes up, `a` and `b` are the same patch.
///
/// With `double` coordinates smooth edges of degree 7 or less are proved with integers of fixed length, see
/// edge_predicates.h. Otherwise a number of operations with integers that is quadratic in the degree, plus the search for the
/// largest angle where the patches are not \f$ G^1 \f$. \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
Spline_edge_continuity<Edge_field<Traits>> edge_continuity(const Bezier_patch<Traits>& a, Patch_edge edge_a,
                                                           const Bezier_patch<Traits>& b, Patch_edge edge_b) {
  typedef Edge_field<Traits> Field;
  internal::require_space(a, "edge_continuity");
  internal::require_space(b, "edge_continuity");
  if (const std::optional<internal::Smooth_edge> smooth = internal::smooth_edge(a, edge_a, b, edge_b)) {
    const auto domain = [](const Bezier_patch<Traits>& s, Patch_edge edge) {
      const typename Bezier_patch<Traits>::Interval i = s.domain(edge);
      return std::pair<Field, Field>(internal::to_field<Field>(i.first), internal::to_field<Field>(i.second));
    };
    return internal::smooth_continuity(*smooth, domain(a, edge_a), domain(b, edge_b));
  }
  return edge_continuity(spline_edge_rows(a, edge_a), spline_edge_rows(b, edge_b));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// An edge of one patch and an edge of another that are the same curve.
struct Common_edge {
  Patch_edge edge_a, edge_b;
  bool reversed; ///< they run in opposite directions
};

/// \ingroup PkgGeometricContinuitySurfaces
/// All pairs of edges of `a` and `b` that are the same curve, and not a single point. The points of the edges and their
/// parametrisations, after exact elevation to one degree, are compared exactly; 16 pairs are tried. Two edges of the same
/// patch `a = b` are listed once; an edge is not paired with itself.
/// \throws Error `dimension_mismatch` unless in dimension 3
template <class Traits>
std::vector<Common_edge> common_edges(const Bezier_patch<Traits>& a, const Bezier_patch<Traits>& b) {
  typedef Edge_field<Traits> Field;
  std::vector<Common_edge> result;
  for (Patch_edge edge_a : patch_edges)
    for (Patch_edge edge_b : patch_edges) {
      if (&a == &b && !(edge_a < edge_b)) continue;
      internal::Edge_sides<Field> sides(edge_rows(a, edge_a), edge_rows(b, edge_b));
      if (sides.collapsed()) continue;
      const bool forward = sides.same_edge();
      if (!forward) sides.reverse_second();
      if (forward || sides.same_edge()) result.push_back({edge_a, edge_b, !forward});
    }
  return result;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_PATCH_CONTINUITY_H
