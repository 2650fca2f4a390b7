// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_SPLINE_EDGE_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_SPLINE_EDGE_CONTINUITY_H

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/edges/internal/common_edge_part.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// What was decided about two surfaces along an interval of their common edge on which both are polynomials.
/// \tparam FT the field in which it was decided
template <class FT> struct Edge_span {
  FT begin;                       ///< the parameter of the first edge
  FT end;                         ///< where the span ends, in the same parameter
  Edge_continuity<FT> continuity; ///< on the closed span; all parameters in it are those of the first edge
};

/// \ingroup PkgGeometricContinuityContinuity
/// What was decided about two piecewise polynomial surfaces along the part that their edges have in common, on each span of
/// the knots of both. The members of the base class hold for the whole part:
///
/// - `g_order` is the least order of all spans, and `defect` belongs to `worst`;
/// - `coplanar` and `collapsed` hold when they do on all spans, `normal_vanishes` when it does on one, with the first
///   sub-interval in `vanishing`; `side` has the signs of all spans;
/// - `deviation` encloses the largest angle of all spans.
///
/// All parameters are those of the first edge, unless stated otherwise. Without a common part there are no spans, and the
/// order is -1.
/// \tparam FT the field in which it was decided
template <class FT> struct Spline_edge_continuity : Edge_continuity<FT> {
  std::vector<Edge_span<FT>> spans;       ///< in the order of the parameters of the first edge
  std::size_t worst = 0;                  ///< the number of the span that has the least order for the gravest reason
  std::pair<FT, FT> part_a{FT(0), FT(0)}; ///< the part of the first edge that is common
  std::pair<FT, FT> part_b{FT(0), FT(0)}; ///< the same part of the second edge, in its parameters
  bool whole_a = false;                   ///< the common part is all of the first edge
  bool whole_b = false;                   ///< the common part is all of the second edge

  /// Writes the whole, then the place of the worst of several spans, and the part if it is not all of both edges; e.g.
  /// `G1 (curvature), worst of 3 spans on [0, 1/2]` or `G2, a part of the second edge`.
  friend std::ostream& operator<<(std::ostream& os, const Spline_edge_continuity& e) {
    os << static_cast<const Edge_continuity<FT>&>(e);
    if (e.spans.size() > 1 && e.defect != Edge_defect::none)
      os << ", worst of " << e.spans.size() << " spans on [" << e.spans[e.worst].begin << ", " << e.spans[e.worst].end
         << ']';
    if (!e.spans.empty() && !(e.whole_a && e.whole_b))
      os << ", a part of " << (e.whole_b ? "the first edge" : e.whole_a ? "the second edge" : "both edges");
    return os;
  }
};

namespace internal {

// The larger, the graver.
inline int severity(Edge_defect defect) {
  switch (defect) {
  case Edge_defect::none: return 0;
  case Edge_defect::curvature: return 1;
  case Edge_defect::collapsed: return 2;
  case Edge_defect::vanishing_normal: return 3;
  case Edge_defect::fold: return 4;
  case Edge_defect::crease: return 5;
  case Edge_defect::gap: return 6;
  }
  return 7;
}

template <class FT> bool is_worse(const Edge_continuity<FT>& x, const Edge_continuity<FT>& y) {
  if (x.defect != y.defect) return severity(y.defect) < severity(x.defect);
  return x.deviation && (!y.deviation || y.deviation->upper < x.deviation->upper);
}

// The verdict on all spans from those on each.
template <class FT> void summarise(Spline_edge_continuity<FT>& edge) {
  std::size_t i = 0;
  for (const Edge_span<FT>& span : edge.spans) {
    const Edge_continuity<FT>& s = span.continuity;
    if (i == 0) {
      static_cast<Edge_continuity<FT>&>(edge) = s;
      ++i;
      continue;
    }
    if (is_worse(s, edge.spans[edge.worst].continuity)) edge.worst = i;
    edge.coplanar = edge.coplanar && s.coplanar;
    edge.side = joint_pattern(edge.side, s.side);
    edge.collapsed = edge.collapsed && s.collapsed;
    edge.normal_vanishes = edge.normal_vanishes || s.normal_vanishes;
    if (!edge.vanishing) edge.vanishing = s.vanishing;
    if (s.deviation) {
      if (!edge.deviation) edge.deviation = s.deviation;
      const FT lower = std::max(edge.deviation->lower, s.deviation->lower);
      if (edge.deviation->upper < s.deviation->upper) edge.deviation = s.deviation;
      edge.deviation->lower = lower;
    }
    ++i;
  }
  edge.g_order = edge.spans[edge.worst].continuity.g_order;
  edge.defect = edge.spans[edge.worst].continuity.defect;
}

// The decision on one common span under the map, a gap if the edges differ.
template <class Field>
Edge_span<Field> decide_span(const std::vector<Edge_piece<Field>>& a, const std::vector<Edge_piece<Field>>& b,
                             const Common_span<Field>& span, const Affine_parameter_map<Field>& map) {
  const std::pair<Edge_rows<Field>, Edge_rows<Field>> rows = rows_on(a, b, span, map);
  Edge_continuity<Field> e = edge_continuity(rows.first, rows.second);
  if (e.reversed) e = Edge_continuity<Field>(); // equal only at other parameters
  e.reversed = map.reverses();
  const Field length = span.end - span.begin;
  const auto to_domain = [&](Field& t) { t = Field(span.begin + t * length); };
  if (e.vanishing) {
    to_domain(e.vanishing->first);
    to_domain(e.vanishing->second);
  }
  if (e.deviation) {
    to_domain(e.deviation->begin);
    to_domain(e.deviation->end);
  }
  return {span.begin, span.end, std::move(e)};
}

// The decisions on the given spans. Where the edges differ there is a gap.
template <class Field>
Spline_edge_continuity<Field> decide_spans(const std::vector<Edge_piece<Field>>& a,
                                           const std::vector<Edge_piece<Field>>& b, const Edge_match<Field>& match) {
  Spline_edge_continuity<Field> result;
  if (match.spans.empty()) return result;
  for (const Common_span<Field>& span : match.spans) result.spans.push_back(decide_span(a, b, span, match.map));
  summarise(result);
  const Field begin = match.spans.front().begin, end = match.spans.back().end;
  result.part_a = {begin, end};
  result.part_b = {match.map(begin), match.map(end)};
  if (match.map.reverses()) std::swap(result.part_b.first, result.part_b.second);
  result.whole_a = begin == a.front().begin && end == a.back().end;
  result.whole_b = result.part_b.first == b.front().begin && result.part_b.second == b.back().end;
  return result;
}

// Along lines over one domain that have equal parameters in common points, or are not the same.
template <class Field>
Spline_edge_continuity<Field> continuity_at_same_parameters(const Spline_edge_rows<Field>& a,
                                                            const Spline_edge_rows<Field>& b) {
  const std::vector<Edge_piece<Field>> pieces_a = edge_pieces<Field>(a), pieces_b = edge_pieces<Field>(b);
  const Affine_parameter_map<Field> identity{Field(1), Field(0)};
  return decide_spans(pieces_a, pieces_b, {identity, common_spans(pieces_a, pieces_b, identity)});
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of two piecewise polynomial surfaces along the part that their edges have in common, exactly, on
/// each closed span of the knots of both, see the function for `Edge_rows`.
///
/// The edges may differ in degree, in knots and in domain. First they are compared as a whole: they are the same when the
/// affine map of the one domain to the other, forwards or backwards, makes them the same curve. Otherwise the longest part is
/// found on which some affine map of the parameters does and which contains the first or the last span of one of the edges:
/// all of one edge where several patches meet one long edge, or where the edges overlap. (One case is not found: a part that
/// is not all of both edges and whose polynomial depends only on a power \f$ (t - c)^g \f$, `g > 1`, of the parameter.)
///
/// Only the rows are restricted to common spans; no surface is refined. For edges that are the same as a whole the number of
/// operations is linear in the number of knots, otherwise it is at most quadratic.
/// \tparam FT a field number type; for floating-point numbers all is exact in the numbers as given
/// \throws Error `wrong_number_of_points` when the rows do not fit the knots, `not_finite`
template <class FT>
Spline_edge_continuity<typename Exact_field<FT>::type> edge_continuity(const Spline_edge_rows<FT>& a,
                                                                       const Spline_edge_rows<FT>& b) {
  typedef typename Exact_field<FT>::type Field;
  const std::vector<internal::Edge_piece<Field>> pieces_a = internal::edge_pieces<Field>(a),
                                                 pieces_b = internal::edge_pieces<Field>(b);
  return internal::decide_spans(pieces_a, pieces_b, internal::Common_edge_part<Field>(pieces_a, pieces_b)());
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_SPLINE_EDGE_CONTINUITY_H
