// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_DECIDE_SURFACES_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_DECIDE_SURFACES_H

#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/edges/internal/Common_edge_part.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_decision.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_ladder.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_normals.h>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// \file decide_surfaces.h
/// The decisions about two surfaces along an edge of each: integers of fixed length where they
/// suffice, then spans of the common part.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The decisions on the spans of a match, by decide(rows, rows).
template <class Field, int N, class Decide>
Spline_edge_continuity<Field> decide_spans(const std::vector<Edge_piece<Field, N>>& a,
                                           const std::vector<Edge_piece<Field, N>>& b, const Edge_match<Field>& match,
                                           Decide decide) {
  Spline_edge_continuity<Field> result;
  if (match.spans.empty()) return result;
  for (const Common_span<Field>& span : match.spans) {
    const std::pair<Edge_rows<Field, N>, Edge_rows<Field, N>> rows = rows_on(a, b, span, match.map);
    Edge_continuity<Field> e = decide(rows.first, rows.second);
    e.reversed = match.map.reverses();
    result.spans.push_back(on_interval(span.begin, span.end, std::move(e)));
  }
  summarise(result);
  const Field begin = match.spans.front().begin, end = match.spans.back().end;
  result.part_a = {begin, end};
  result.part_b = {match.map(begin), match.map(end)};
  if (match.map.reverses()) std::swap(result.part_b.first, result.part_b.second);
  result.whole_a = begin == a.front().begin && end == a.back().end;
  result.whole_b = result.part_b.first == b.front().begin && result.part_b.second == b.back().end;
  return result;
}

// Decides two whole edges along which the surfaces are one polynomial each, from the verdict in the
// parameters of the first.
template <class Field>
Spline_edge_continuity<Field> verdict_on_whole_edge(Edge_continuity<Field> verdict, Edge_direction direction,
                                                    const std::pair<Field, Field>& domain_a,
                                                    const std::pair<Field, Field>& domain_b) {
  Spline_edge_continuity<Field> result;
  Edge_continuity<Field>& e = result;
  e = std::move(verdict);
  e.reversed = direction == Edge_direction::opposite;
  result.spans.push_back({domain_a.first, domain_a.second, e});
  result.part_a = domain_a;
  result.part_b = domain_b;
  result.whole_a = result.whole_b = true;
  return result;
}

// Tells whether a surface is a polynomial one over floating-point knots.
template <class Surface>
constexpr bool has_double_knots =
    std::is_same_v<Surface, Bspline_surface<typename Surface::Traits>>&& std::is_same_v<typename Surface::FT, double>;

// Decides two whole edges along which the surfaces have the order 2 on all spans, which are those
// of the knots of the first.
template <class Field, class FT>
Spline_edge_continuity<Field> smooth_on_all_spans(const Knot_vector<FT>& knots, Edge_direction direction,
                                                  const std::pair<Field, Field>& domain_b) {
  Spline_edge_continuity<Field> result;
  for (int k : knots.spans()) {
    const std::pair<Field, Field> span(to_field<Field>(knots[k]), to_field<Field>(knots[k + 1]));
    result.spans.push_back({span.first, span.second, smooth_continuity<Field>(2, span)});
    result.spans.back().continuity.reversed = direction == Edge_direction::opposite;
  }
  summarise(result);
  result.part_a = {result.spans.front().begin, result.spans.back().end};
  result.part_b = domain_b;
  result.whole_a = result.whole_b = true;
  return result;
}

// The stages of fixed length for surfaces that are one patch each, then those for pieces, where
// find_match(pieces, pieces, work) finds what the edges have in common.
template <class Surface_a, class Surface_b, class Find_match>
auto decide_surfaces(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                     Find_match find_match, Crease_angles angles = Crease_angles::enclosed)
    -> Spline_edge_continuity<Edge_field<typename Surface_a::Traits>> {
  typedef Edge_field<typename Surface_a::Traits> Field;
  constexpr int N = row_dimension<Surface_a, Surface_b>;
  require_space(a, b, "edge_continuity");
  if constexpr (N == 4)
    if (has_equal_weights(a) && has_equal_weights(b))
      return decide_surfaces(without_weights(a), edge_a, without_weights(b), edge_b, find_match, angles);
  const Work_guard work("edge_continuity");
  std::optional<Edge_direction> direction;
  if constexpr (Fixed_length_stages<N>::exist) {
    typename Fixed_length_stages<N>::Layers x, y;
    if (edge_layers(a, edge_a, b, edge_b, 2, x, y)) direction = common_direction(x, y);
    if (direction) {
      if (*direction == Edge_direction::opposite) y.reverse();
      const std::pair<Field, Field> domain_a = edge_domain<Field>(a, edge_a), domain_b = edge_domain<Field>(b, edge_b);
      typename Fixed_length_stages<N>::Ladder ladder(x, y);
      if (const std::optional<int> order = smooth_order(ladder))
        return verdict_on_whole_edge(smooth_continuity<Field>(*order, domain_a), *direction, domain_a, domain_b);
      if constexpr (N == 3)
        if (std::optional<Edge_continuity<Field>> crease = crease_on_grid<Field>(ladder, angles))
          return verdict_on_whole_edge(on_interval(domain_a.first, domain_a.second, *std::move(crease)).continuity,
                                       *direction, domain_a, domain_b);
    }
  }
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  if constexpr (has_double_knots<Surface_a> && has_double_knots<Surface_b>)
    if (!direction)
      if (const std::optional<Edge_direction> smooth = smooth_spline_edge(a, edge_a, b, edge_b))
        return smooth_on_all_spans<Field>(a.knots_along(edge_a), *smooth, edge_domain<Field>(b, edge_b));
#endif
  const std::vector<Edge_piece<Field, N>> pieces_a = edge_pieces_in<N>(a, edge_a),
                                          pieces_b = edge_pieces_in<N>(b, edge_b);
  if (direction) // and the stages of fixed length have been tried
    return decide_spans(pieces_a, pieces_b, whole_match(pieces_a, pieces_b, *direction), decide_rough_edge<Field, N>);
  return decide_spans(pieces_a, pieces_b, find_match(pieces_a, pieces_b), decide_edge<Field, N>);
}

// Decides edges that have been recognised as the same, see Edge_key.
template <class Surface_a, class Surface_b>
auto continuity_of_same_edge(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                             Edge_direction direction, Crease_angles angles) {
  const auto find_match = [direction](const auto& pieces_a, const auto& pieces_b) {
    return whole_match(pieces_a, pieces_b, direction);
  };
  return decide_surfaces(a, edge_a, b, edge_b, find_match, angles);
}

// Decides along the common part of two edges.
template <class Field, class FT, int N>
Spline_edge_continuity<Field> decide_rows(const Spline_edge_rows<FT, N>& a, const Spline_edge_rows<FT, N>& b) {
  const Work_guard work("edge_continuity");
  const std::vector<Edge_piece<Field, N>> pieces_a = edge_pieces<Field>(a), pieces_b = edge_pieces<Field>(b);
  return decide_spans(pieces_a, pieces_b, common_edge_part(pieces_a, pieces_b), decide_edge<Field, N>);
}

// Decides along lines over one domain that have equal parameters in common points, or are not the
// same.
template <class Field, int N>
Spline_edge_continuity<Field> continuity_at_same_parameters(const Spline_edge_rows<Field, N>& a,
                                                            const Spline_edge_rows<Field, N>& b) {
  const Work_guard work("edge_continuity");
  const std::vector<Edge_piece<Field, N>> pieces_a = edge_pieces<Field>(a), pieces_b = edge_pieces<Field>(b);
  const Edge_match<Field> match = whole_match(pieces_a, pieces_b, Edge_direction::same);
  return decide_spans(pieces_a, pieces_b, match, [](const Edge_rows<Field, N>& x, const Edge_rows<Field, N>& y) {
    return x.edge == y.edge ? decide_edge(x, y) : Edge_continuity<Field>();
  });
}

// Decides in the ring of the common denominators, along the same edge in one direction.
template <int order, class Field, int N> bool sides_have_order(const Edge_sides<Field, N>& sides) {
  const Edge_normals<Field, N> normals(sides);
  if (!normals.first_order() || (order >= 2 && !normals.second_order(sides))) return false;
  if constexpr (order < 3)
    return true;
  else
    return normals.third_order(sides);
}

// The orders above 2 are refuted by the stages of fixed length for the order 2.
template <int order> constexpr int order_on_layers = (std::min)(order, 2);

// Decides along rows with the same edge, in one direction.
template <int order, class Field, int N, class Stages>
bool rows_have_order(const Edge_rows<Field, N>& a, const Edge_rows<Field, N>& b, Stages& stages) {
  if constexpr (Fixed_length_stages<N>::exist) {
    typename Fixed_length_stages<N>::Layers x, y;
    if (edge_layers(a, b, x, y))
      if (const std::optional<bool> answer = decide_on_same_edge<order_on_layers<order>>(x, y, stages))
        if (order <= 2 || !*answer) return *answer;
  }
  const bool answer = sides_have_order<order>(Edge_sides<Field, N>(a, b));
  stages.decided(Stage::multiprecision, answer);
  return answer;
}

template <int order, class Surface_a, class Surface_b, class Stages>
bool edge_has_order(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b, Stages& stages) {
  typedef Edge_field<typename Surface_a::Traits> Field;
  constexpr int N = row_dimension<Surface_a, Surface_b>;
  require_space(a, b, "edge predicate");
  if constexpr (N == 4)
    if (has_equal_weights(a) && has_equal_weights(b))
      return edge_has_order<order>(without_weights(a), edge_a, without_weights(b), edge_b, stages);
  if constexpr (Fixed_length_stages<N>::exist) {
    typename Fixed_length_stages<N>::Layers x, y;
    if (edge_layers(a, edge_a, b, edge_b, order_on_layers<order>, x, y))
      if (const std::optional<bool> answer = decide_on_layers<order_on_layers<order>>(x, y, stages))
        if (order <= 2 || !*answer) return *answer;
  }
  const Work_guard work("edge predicate");
  constexpr int row_order = (std::max)(order, 2);
  const std::vector<Edge_piece<Field, N>> pieces_a = edge_pieces_in<N>(a, edge_a, row_order),
                                          pieces_b = edge_pieces_in<N>(b, edge_b, row_order);
  if constexpr (N == 3)
    if (is_one_patch(a) && is_one_patch(b)) {
      Edge_sides<Field> sides(pieces_a[0].rows, pieces_b[0].rows);
      const bool answer = sides.align() && (order == 0 || sides_have_order<order>(sides));
      stages.decided(Stage::multiprecision, answer);
      return answer;
    }
  const std::optional<Edge_match<Field>> match = Common_edge_part<Field, N>(pieces_a, pieces_b).whole();
  if (!match || order == 0) {
    stages.decided(Stage::multiprecision, match.has_value());
    return match.has_value();
  }
  return std::all_of(match->spans.begin(), match->spans.end(), [&](const Common_span<Field>& span) {
    const std::pair<Edge_rows<Field, N>, Edge_rows<Field, N>> rows = rows_on(pieces_a, pieces_b, span, match->map);
    return rows_have_order<order>(rows.first, rows.second, stages);
  });
}

template <int order, class Surface_a, class Surface_b>
bool edge_has_order(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  const All_stages stages;
  return edge_has_order<order>(a, edge_a, b, edge_b, stages);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_DECIDE_SURFACES_H
