// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_NEAR_EDGES_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_NEAR_EDGES_H

#include <CGAL/Geometric_continuity/edges/edge_order_within.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_piece.h>
#include <CGAL/Geometric_continuity/models/Model_edge.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// Two boundary edges of a model that are not the same but near each other.
struct Near_edges {
  std::size_t patch_a;      ///< the number of the patch, from 0 on
  Patch_edge edge_a;        ///< its edge
  std::size_t patch_b;      ///< the other patch, or the same one
  Patch_edge edge_b;        ///< its edge
  Edge_order_within within; ///< how near, and what that means

  /// Writes the row, e.g. `0 u1 - 1 u0: near`.
  friend std::ostream& operator<<(std::ostream& os, const Near_edges& e) {
    return os << e.patch_a << ' ' << e.edge_a << " - " << e.patch_b << ' ' << e.edge_b << ": near"
              << (e.within.deviation.reversed ? ", reversed" : "");
  }
};

namespace internal {

// A boundary edge with its ends.
template <class Field> struct Boundary_edge {
  typedef Coordinate_vector<Field, 3> Vector;

  std::size_t patch;
  Patch_edge edge;
  Spline_edge_rows<Field> rows;
  Vector ends[2];
  Field x; // the smaller of the first coordinates of both ends

  Boundary_edge(std::size_t p, Patch_edge e, Spline_edge_rows<Field> r) : patch(p), edge(e), rows(std::move(r)) {
    const std::vector<Edge_piece<Field>> pieces = edge_pieces<Field>(rows);
    ends[0] = pieces.front().rows.edge.front();
    ends[1] = pieces.back().rows.edge.back();
    x = (std::min)(ends[0][0], ends[1][0]);
  }

  bool has_ends_near(const Boundary_edge& other, const Field& squared_gap) const {
    const auto near = [&](const Vector& p, const Vector& q) {
      const Vector difference = q - p;
      return !(squared_gap < dot(difference, difference));
    };
    return (near(ends[0], other.ends[0]) && near(ends[1], other.ends[1])) ||
           (near(ends[0], other.ends[1]) && near(ends[1], other.ends[0]));
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Finds the pairs of boundary edges of a model whose gap is not refuted to be within the tolerance, and their orders within the
/// tolerance: edges that `model_continuity()` finds to differ, such as those of rounded constructions. By the number of the
/// first patch. An edge that is near to several others is in several pairs.
///
/// The ends of near edges are near; so candidates are found by sorting, and for each the gap is enclosed.
/// \tparam PatchRange a forward range of `Bezier_patch` or of `Bspline_surface`
/// \param patches of the model
/// \param model the result of `model_continuity(patches)`
/// \param tolerance for the gap and for the order 1
/// \param report is called as `report(n)` with the number of boundary edges compared so far, after each
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number, `not_finite` for an infinite
///   gap
template <class PatchRange, class FT, class Report>
std::vector<Near_edges> near_edges(const PatchRange& patches, const Model_continuity<FT>& model,
                                   const Edge_tolerance& tolerance, Report report) {
  typedef internal::Boundary_edge<FT> Edge;
  internal::check_tolerance(tolerance);
  internal::check_finite(tolerance.gap, "near_edges: gap");
  const FT gap(tolerance.gap), squared_gap(gap * gap);
  std::vector<Edge> edges;
  std::size_t number = 0;
  auto row = model.edges.begin(); // by the number of the patch
  for (const auto& patch : patches) {
    for (; row != model.edges.end() && row->patch_a == number; ++row)
      if (row->kind == Model_edge_kind::boundary)
        edges.emplace_back(number, row->edge_a, spline_edge_rows(patch, row->edge_a));
    ++number;
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return bool(a.x < b.x); });
  std::vector<Near_edges> result;
  for (auto i = edges.begin(); i != edges.end(); ++i) {
    for (auto j = i + 1; j != edges.end() && !(gap < FT(j->x - i->x)); ++j) {
      if (!i->has_ends_near(*j, squared_gap)) continue;
      const bool in_order = std::make_pair(i->patch, i->edge) < std::make_pair(j->patch, j->edge);
      const Edge &a = in_order ? *i : *j, &b = in_order ? *j : *i;
      const Edge_order_within within = order_within(deviation(a.rows, b.rows), tolerance);
      if (within(0) != Verdict::refuted) result.push_back({a.patch, a.edge, b.patch, b.edge, within});
    }
    report(static_cast<std::size_t>(i - edges.begin()) + 1);
  }
  std::sort(result.begin(), result.end(), [](const Near_edges& a, const Near_edges& b) {
    return std::make_pair(std::make_pair(a.patch_a, a.edge_a), std::make_pair(a.patch_b, a.edge_b)) <
           std::make_pair(std::make_pair(b.patch_a, b.edge_a), std::make_pair(b.patch_b, b.edge_b));
  });
  return result;
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Finds the near edges of a model, without reports.
/// \throws Error as the function that reports
template <class PatchRange, class FT>
std::vector<Near_edges> near_edges(const PatchRange& patches, const Model_continuity<FT>& model,
                                   const Edge_tolerance& tolerance) {
  return near_edges(patches, model, tolerance, [](std::size_t) {});
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_NEAR_EDGES_H
