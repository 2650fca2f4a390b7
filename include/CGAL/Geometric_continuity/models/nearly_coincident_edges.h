// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_NEARLY_COINCIDENT_EDGES_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_NEARLY_COINCIDENT_EDGES_H

#include <CGAL/Geometric_continuity/edges/edge_deviation.h>
#include <CGAL/Geometric_continuity/edges/internal/Common_edge_part.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/certified_bounds.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
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
struct Nearly_coincident_edges {
  std::size_t patch_a;      ///< the number of the patch, from 0 on
  Patch_edge edge_a;        ///< its edge
  std::size_t patch_b;      ///< the other patch, or the same one
  Patch_edge edge_b;        ///< its edge
  Edge_order_within within; ///< how near, and what that means

  /// Writes the row, e.g. `0 u1 - 1 u0: near`.
  friend std::ostream& operator<<(std::ostream& os, const Nearly_coincident_edges& e) {
    return os << e.patch_a << ' ' << e.edge_a << " - " << e.patch_b << ' ' << e.edge_b << ": near"
              << (e.within.deviation.reversed ? ", reversed" : "");
  }
};

namespace internal {

// A boundary edge with its ends.
template <class Field, int N> struct Boundary_edge {
  typedef Coordinate_vector<Field, 3> Vector;
  typedef std::array<std::pair<double, double>, 3> Box; // that contains a point

  std::size_t patch;
  Patch_edge edge;
  std::vector<Edge_piece<Field, N>> pieces;
  Vector ends[2];
  Box boxes[2];

  Boundary_edge(std::size_t p, Patch_edge e, const Spline_edge_rows<Field, N>& rows) : patch(p), edge(e) {
    const Work_guard work("nearly_coincident_edges");
    pieces = edge_pieces<Field>(rows);
    ends[0] = point_of(pieces.front().rows.edge.front());
    ends[1] = point_of(pieces.back().rows.edge.back());
    for (int end : {0, 1})
      for (int i = 0; i < 3; ++i) boxes[end][i] = CGAL::to_interval(ends[end][i]);
  }

  static Vector point_of(const Coordinate_vector<Field, N>& p) {
    if constexpr (N == 4)
      return affine_point(p);
    else
      return p;
  }

  // Bounds of the smaller coordinate of both ends.
  double low(int i) const { return (std::min)(boxes[0][i].first, boxes[1][i].first); }
  double high(int i) const { return (std::min)(boxes[0][i].second, boxes[1][i].second); }

  // Returns whether the ends are not farther apart than the gap, in one of both directions. Boxes
  // tell nearly all that are.
  bool has_ends_near(const Boundary_edge& other, double gap, const Field& squared_gap) const {
    const auto within_gap = [&](int end, int other_end) {
      for (int i = 0; i < 3; ++i)
        if (is_beyond(boxes[end][i], other.boxes[other_end][i], gap) ||
            is_beyond(other.boxes[other_end][i], boxes[end][i], gap))
          return false;
      const Vector difference = other.ends[other_end] - ends[end];
      return !(squared_gap < dot(difference, difference));
    };
    return (within_gap(0, 0) && within_gap(1, 1)) || (within_gap(0, 1) && within_gap(1, 0));
  }

  // Returns whether the numbers of the second interval exceed those of the first by more than the
  // gap.
  static bool is_beyond(const std::pair<double, double>& x, const std::pair<double, double>& y, double gap) {
    return gap < next_below(y.first - x.second);
  }
};

// The coordinate in which the edges are spread most, as far as they are finite.
template <class Field, int N> int longest_side(const std::vector<Boundary_edge<Field, N>>& edges) {
  int longest = 0;
  double length = 0;
  for (int i = 0; i < 3; ++i) {
    const auto [least, most] = std::minmax_element(edges.begin(), edges.end(),
                                                   [i](const auto& a, const auto& b) { return a.low(i) < b.low(i); });
    if (least == edges.end() || !(length < most->low(i) - least->low(i))) continue;
    length = most->low(i) - least->low(i);
    longest = i;
  }
  return longest;
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Finds the pairs of boundary edges of a model whose gap is not refuted to be within the
/// tolerance, and their orders within the tolerance: edges that `model_continuity()` finds to
/// differ, such as those of rounded constructions. By the number of the first patch. An edge that
/// is near to several others is in several pairs.
///
/// The ends of near edges are near; so candidates are found by sorting, and for each the gap is
/// enclosed. A gap that is not small compared with the patches makes all pairs of edges candidates.
/// The limit of the work is that for each edge, and for the search, with its thousandth part more
/// for each edge.
/// \tparam PatchRange a forward range of surfaces, as for `model_continuity()`
/// \param patches of the model
/// \param model the result of `model_continuity(patches)`
/// \param tolerance for the gap and for the order 1
/// \param report is called as `report(n)` with the number of boundary edges compared so far, after
///   each
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number,
///   `not_finite` for an infinite gap, `work_limit`
template <class PatchRange, class FT, class Report>
std::vector<Nearly_coincident_edges> nearly_coincident_edges(const PatchRange& patches,
                                                             const Model_continuity<FT>& model,
                                                             const Edge_tolerance& tolerance, Report report) {
  typedef std::decay_t<decltype(*std::begin(patches))> Surface;
  typedef internal::Boundary_edge<FT, internal::row_dimension<Surface>> Edge;
  internal::check_tolerance(tolerance);
  const double gap = tolerance.gap.upper();
  internal::check_finite(gap, "nearly_coincident_edges: gap");
  const FT squared_gap = FT(gap) * FT(gap);
  std::vector<Edge> edges;
  std::size_t number = 0;
  auto row = model.edges.begin(); // by the number of the patch
  for (const auto& patch : patches) {
    for (; row != model.edges.end() && row->patch_a == number; ++row)
      if (row->kind == Model_edge_kind::boundary)
        edges.emplace_back(number, row->edge_a, spline_edge_rows(patch, row->edge_a));
    ++number;
  }
  const int side = internal::longest_side(edges);
  std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) { return a.low(side) < b.low(side); });
  const internal::Work_guard work("nearly_coincident_edges", 1 + static_cast<double>(edges.size()) / 1000);
  std::vector<Nearly_coincident_edges> result;
  for (auto i = edges.begin(); i != edges.end(); ++i) {
    for (auto j = i + 1; j != edges.end(); ++j) {
      if (gap < internal::next_below(j->low(side) - i->high(side))) break;
      if (!i->has_ends_near(*j, gap, squared_gap)) continue;
      const bool in_order = std::make_pair(i->patch, i->edge) < std::make_pair(j->patch, j->edge);
      const Edge &a = in_order ? *i : *j, &b = in_order ? *j : *i;
      const Edge_order_within within = order_within(internal::edge_deviation(a.pieces, b.pieces), tolerance);
      if (within(0) != Verdict::refuted) result.push_back({a.patch, a.edge, b.patch, b.edge, within});
    }
    report(static_cast<std::size_t>(i - edges.begin()) + 1);
  }
  std::sort(result.begin(), result.end(), [](const Nearly_coincident_edges& a, const Nearly_coincident_edges& b) {
    return std::make_pair(std::make_pair(a.patch_a, a.edge_a), std::make_pair(a.patch_b, a.edge_b)) <
           std::make_pair(std::make_pair(b.patch_a, b.edge_a), std::make_pair(b.patch_b, b.edge_b));
  });
  return result;
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Finds the near edges of a model, without reports.
/// \throws Error as the function that reports
template <class PatchRange, class FT>
std::vector<Nearly_coincident_edges>
nearly_coincident_edges(const PatchRange& patches, const Model_continuity<FT>& model, const Edge_tolerance& tolerance) {
  return nearly_coincident_edges(patches, model, tolerance, [](std::size_t) {});
}

#ifndef CGAL_NO_DEPRECATED_CODE
// Old names, for one release.
using Near_edges CGAL_DEPRECATED = Nearly_coincident_edges;
template <class... A> CGAL_DEPRECATED std::vector<Nearly_coincident_edges> near_edges(const A&... arguments) {
  return nearly_coincident_edges(arguments...);
}
#endif

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_NEARLY_COINCIDENT_EDGES_H
