// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CONTINUITY_H

#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/edges/Spline_edge_continuity.h>
#include <CGAL/Geometric_continuity/edges/internal/Common_edge_part.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_decision.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_ladder.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_normals.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// \file edge_continuity.h
/// The continuity of two surfaces along an edge of each, decided exactly on the whole closed edge; for every mix of surface
/// types, and for rows of coefficients. See `Edge_conditions` for what is decided. `edge_continuity()` tells the order, the reason and the
/// place, `is_g0_edge()`, `is_g1_edge()` and `is_g2_edge()` answer one question each, and `common_edges()` finds the edges that two patches
/// share.
///
/// The answers of the predicates are those of `edge_continuity()`, without its reasons and places. Two surfaces without
/// inner knots whose coordinates are `double`, of whatever kernel, or rational numbers with short numerators, and the spans
/// of other surfaces, are decided in stages: control points that differ are a gap; values at the ends that exceed their
/// proven rounding errors refute; integers of fixed length on a grid decide nearly all other edges of degree 7 or less; and
/// multi-precision numbers the rest.

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

// Of two whole edges along which the surfaces are one polynomial each, from the verdict in the parameters of the first.
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

// Whether a surface is a polynomial one over floating-point knots.
template <class Surface>
constexpr bool has_double_knots =
    std::is_same_v<Surface, Bspline_surface<typename Surface::Traits>>&& std::is_same_v<typename Surface::FT, double>;

// Of two whole edges along which the surfaces have the order 2 on all spans, which are those of the knots of the first.
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

// The stages of fixed length for surfaces that are one patch each, then those for pieces, where find_match(pieces, pieces,
// work) finds what the edges have in common.
template <class Surface_a, class Surface_b, class Find_match>
auto decide_surfaces(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                     Find_match find_match) -> Spline_edge_continuity<Edge_field<typename Surface_a::Traits>> {
  typedef Edge_field<typename Surface_a::Traits> Field;
  constexpr int N = row_dimension<Surface_a, Surface_b>;
  require_space(a, b, "edge_continuity");
  if constexpr (N == 4)
    if (has_equal_weights(a) && has_equal_weights(b))
      return decide_surfaces(without_weights(a), edge_a, without_weights(b), edge_b, find_match);
  const Work_on_object work("edge_continuity");
  std::optional<Edge_direction> direction;
  if constexpr (Edge_rungs<N>::exist) {
    typename Edge_rungs<N>::Layers x, y;
    if (edge_layers(a, edge_a, b, edge_b, 2, x, y)) direction = common_direction(x, y);
    if (direction) {
      if (*direction == Edge_direction::opposite) y.reverse();
      const std::pair<Field, Field> domain_a = edge_domain<Field>(a, edge_a), domain_b = edge_domain<Field>(b, edge_b);
      typename Edge_rungs<N>::Ladder ladder(x, y);
      if (const std::optional<int> order = ladder.smooth_order())
        return verdict_on_whole_edge(smooth_continuity<Field>(*order, domain_a), *direction, domain_a, domain_b);
      if constexpr (N == 3)
        if (std::optional<Edge_continuity<Field>> crease = crease_on_grid<Field>(ladder))
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

// For edges that have been recognised as the same, see Edge_key.
template <class Surface_a, class Surface_b>
auto continuity_of_same_edge(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                             Edge_direction direction) {
  return decide_surfaces(a, edge_a, b, edge_b, [direction](const auto& pieces_a, const auto& pieces_b) {
    return whole_match(pieces_a, pieces_b, direction);
  });
}

// Along lines over one domain that have equal parameters in common points, or are not the same.
template <class Field, int N>
Spline_edge_continuity<Field> continuity_at_same_parameters(const Spline_edge_rows<Field, N>& a,
                                                            const Spline_edge_rows<Field, N>& b) {
  const Work_on_object work("edge_continuity");
  const std::vector<Edge_piece<Field, N>> pieces_a = edge_pieces<Field>(a), pieces_b = edge_pieces<Field>(b);
  const Edge_match<Field> match = whole_match(pieces_a, pieces_b, Edge_direction::same);
  return decide_spans(pieces_a, pieces_b, match, [](const Edge_rows<Field, N>& x, const Edge_rows<Field, N>& y) {
    return x.edge == y.edge ? decide_edge(x, y) : Edge_continuity<Field>();
  });
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of two surfaces along their edges `v = 0`, exactly and on the whole closed edge, see
/// `Edge_conditions`. The edges are the same when their points and their parametrisations are, after exact elevation to one
/// degree; the second one may run backwards. (An affine reparametrisation that maps an edge as a whole to itself is the
/// identity or the reversal.) Where the normal of one side vanishes there is no tangent plane, hence no \f$ G^1 \f$; this
/// is reported as such. All parameters in the result are those of the first edge, in [0, 1].
///
/// When the surfaces are not \f$ G^1 \f$, the largest angle between their normals \f$ n_i = C' \times T_i \f$ is enclosed by
/// branch and bound on the Bernstein coefficients of \f$ \sin^2\theta = 1 - (n_1 \cdot n_2)^2 / (|n_1|^2 |n_2|^2) \f$, in
/// integers of fixed length that are rounded outwards or, where these do not suffice, in exact arithmetic. Where the limit of
/// the work does not suffice for a close enclosure, it is a wider one; what is decided
/// is decided, or refused by an error.
///
/// \tparam FT a field number type; for floating-point numbers all is exact in the numbers as given
/// \throws Error `wrong_number_of_points` for an empty row, `not_finite`, `work_limit`
template <class FT>
Edge_continuity<typename Exact_field<FT>::type> edge_continuity(const Edge_rows<FT>& a, const Edge_rows<FT>& b) {
  typedef typename Exact_field<FT>::type Field;
  const internal::Work_on_object work("edge_continuity");
  internal::Edge_sides<Field> sides(a, b);
  const std::optional<bool> reversed = sides.align();
  if (!reversed) return {};
  Edge_continuity<Field> edge = internal::Edge_decision<Field>()(sides);
  edge.reversed = *reversed;
  return edge;
}

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
/// operations is linear in the number of knots, otherwise it is at most quadratic. On each span rational numbers with short
/// numerators are decided with integers of fixed length, as for surfaces.
///
/// Rows of homogeneous points, `N = 4`, are those of rational surfaces. Then edges are the same curve where their homogeneous
/// points differ by a constant factor on each span, and the conditions are those of the tangent planes in homogeneous space, with
/// \f$ C \wedge C' \wedge T \f$ in place of \f$ C' \times T \f$. Edges that are the same points in another rational
/// parametrisation, or with a factor that is not constant, are not recognised as the same, unless they are collapsed. With
/// one degree and the same knots this happens where the weights of one edge are those of the other times \f$ c^i \f$, and where the
/// homogeneous points of both have been multiplied by different polynomials: both curves are then of less degree than they seem.
/// \tparam FT a field number type; for floating-point numbers all is exact in the numbers as given
/// \tparam N the number of coordinates: 3, or 4 for homogeneous points
/// \throws Error `wrong_number_of_points` when the rows do not fit the knots, `not_finite`, `work_limit`; `zero_weight` where
///   a denominator is zero
template <class FT, int N>
Spline_edge_continuity<typename Exact_field<FT>::type> edge_continuity(const Spline_edge_rows<FT, N>& a,
                                                                       const Spline_edge_rows<FT, N>& b) {
  typedef typename Exact_field<FT>::type Field;
  const internal::Work_on_object work("edge_continuity");
  const std::vector<internal::Edge_piece<Field, N>> pieces_a = internal::edge_pieces<Field>(a),
                                                    pieces_b = internal::edge_pieces<Field>(b);
  return internal::decide_spans(pieces_a, pieces_b, internal::common_edge_part(pieces_a, pieces_b),
                                internal::decide_edge<Field, N>);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides the continuity of two surfaces along an edge of each, exactly, on the whole closed edge and with every kernel:
/// control points and knots are taken as they are given. The edge of `b` may run backwards, and degrees, knots and domains
/// may differ. When the edges are not the same, the part that they have in common is decided, e.g. where several surfaces meet
/// one long edge; members of the result say which part of each edge it is. The result has a verdict for each span of the
/// knots of both edges; see the function for `Spline_edge_rows`.
///
/// All parameters in the result are those of the domain of the edge of `a`, without rounding. For two edges of one surface
/// that closes up, `a` and `b` are the same surface. What happens at knots across the edge inside one of the surfaces is
/// decided by `knot_line_continuity()`. For the two sides of a ribbon pass `G1_ribbon::side1` and `G1_ribbon::side2`; swept
/// surfaces have `extrusion_continuity()` and `revolution_continuity()`.
///
/// Smooth edges of degree 7 or less are proved with integers of fixed length where the coordinates are `double`, or rational
/// numbers with short numerators over one denominator; see above. So are most creases of degree 5 or less, and with
/// `double` also edges of B-spline surfaces over inner knots where the derivatives across them are the same but for the speed of
/// the parameter. Otherwise a number of operations with integers
/// that is quadratic in the degree and linear in the number of knots, plus the search for the largest angle where the surfaces
/// are not \f$ G^1 \f$. Smooth edges of rational patches, and of spans of rational B-spline surfaces, are proved with
/// integers of fixed length where points and weights are `double`, or homogeneous points rational numbers of at most 105 bits.
/// \tparam Surface_a, Surface_b `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or `Rational_bspline_surface`, in any
///   combination, with one traits class
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit`
template <class Surface_a, class Surface_b>
auto edge_continuity(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b)
    -> Spline_edge_continuity<Edge_field<typename Surface_a::Traits>> {
  return internal::decide_surfaces(a, edge_a, b, edge_b, [](const auto& pieces_a, const auto& pieces_b) {
    return internal::common_edge_part(pieces_a, pieces_b);
  });
}

namespace internal {

// In the ring of the common denominators, along the same edge in one direction.
template <int order, class Field, int N> bool sides_have_order(const Edge_sides<Field, N>& sides) {
  const Edge_normals<Field, N> normals(sides);
  return normals.first_order() && (order == 1 || normals.second_order(sides));
}

// Along rows with the same edge, in one direction.
template <int order, class Field, int N, class Stages>
bool rows_have_order(const Edge_rows<Field, N>& a, const Edge_rows<Field, N>& b, Stages& stages) {
  if constexpr (Edge_rungs<N>::exist) {
    typename Edge_rungs<N>::Layers x, y;
    if (edge_layers(a, b, x, y))
      if (const std::optional<bool> answer = decide_on_same_edge<order>(x, y, stages)) return *answer;
  }
  const bool answer = sides_have_order<order>(Edge_sides<Field, N>(a, b));
  stages.decided(Edge_stage::multiprecision, answer);
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
  if constexpr (Edge_rungs<N>::exist) {
    typename Edge_rungs<N>::Layers x, y;
    if (edge_layers(a, edge_a, b, edge_b, order, x, y))
      if (const std::optional<bool> answer = decide_on_layers<order>(x, y, stages)) return *answer;
  }
  const Work_on_object work("edge predicate");
  const std::vector<Edge_piece<Field, N>> pieces_a = edge_pieces_in<N>(a, edge_a),
                                          pieces_b = edge_pieces_in<N>(b, edge_b);
  if constexpr (N == 3)
    if (is_one_patch(a) && is_one_patch(b)) {
      Edge_sides<Field> sides(pieces_a[0].rows, pieces_b[0].rows);
      const bool answer = sides.align() && (order == 0 || sides_have_order<order>(sides));
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

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CONTINUITY_H
