// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_DEVIATION_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_DEVIATION_H

#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/edges/internal/Common_edge_part.h>
#include <CGAL/Geometric_continuity/edges/internal/Largest_measure.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <algorithm>
#include <array>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// The distance of two surfaces from being continuous along an edge of each, as guaranteed
/// enclosures of the maxima on the whole edges, where points at corresponding parameters are
/// compared.
struct Edge_deviation {
  Enclosure gap; ///< the largest distance of the points of the edges, in units of the coordinates
  /// The largest angle between the normals, in radians, in \f$ [0, \pi] \f$: 0 where the surfaces
  /// continue each other, see `Normal_deviation`. Points where a normal vanishes are left out.
  /// Empty when a normal vanishes on a whole span.
  std::optional<Enclosure> normal_angle;
  bool normal_vanishes = false; ///< a normal vanishes somewhere on the closed edges
  bool reversed = false;        ///< the second edge runs backwards

  /// Writes what there is, the angle in degrees, e.g. `gap 0, normal angle [0.5, 0.50001] degrees`.
  friend std::ostream& operator<<(std::ostream& os, const Edge_deviation& d) {
    os << "gap " << d.gap;
    if (d.normal_angle) os << ", normal angle " << in_degrees(*d.normal_angle) << " degrees";
    if (d.normal_vanishes) os << ", a normal vanishes";
    return os;
  }
};

namespace internal {

inline Enclosure larger_of(const Enclosure& x, const Enclosure& y) {
  return {(std::max)(x.lower, y.lower), (std::max)(x.upper, y.upper)};
}

// A number that is at least twice the largest value of s/q on [0, 1], of polynomials of one degree.
// As the coefficients of q are not all positive where some weights are not, it is found on parts of
// the interval, after so many halvings.
// \throws Error `work_limit` when q comes too close to zero
template <class Polynomial>
typename Polynomial::NT twice_the_quotient(const Polynomial& s, const Polynomial& q, int halvings) {
  typedef typename Polynomial::NT Ring;
  if (coefficient_signs(q) == Sign_pattern::positive) {
    Ring k(1);
    for (int i = 0; i <= q.degree(); ++i)
      while (Ring(k * q[i]) < Ring(Ring(2) * s[i])) k *= Ring(2);
    return k;
  }
  if (halvings == 0) throw Error(Error_code::work_limit, "deviation of edges: the denominator is too close to zero");
  charge_bisection(q);
  charge_bisection(s);
  const std::pair<Polynomial, Polynomial> p = s.halves(), r = q.halves();
  return (std::max)(twice_the_quotient(p.first, r.first, halvings - 1),
                    twice_the_quotient(p.second, r.second, halvings - 1));
}

// The largest distance of two edges is the root of the largest value of s/q, where s = |C1 - C2|^2
// and q = 1, or s = |w2 C1 - w1 C2|^2 and q = (w1 w2)^2 for homogeneous points. With a number k >=
// 2 s/q it is that of k times the largest value of s/(k q), of which at least half is left to 1, so
// that its bounds differ by the 2^-53-th part at most.
template <class Field, int N> Enclosure largest_distance(const Edge_sides<Field, N>& sides) {
  typedef typename Edge_sides<Field, N>::Ring Ring;
  typedef typename Edge_sides<Field, N>::Polynomial Polynomial;
  typedef typename Edge_normals<Field>::Exact Exact;
  if (sides.same_edge()) return {0, 0};
  Polynomial s, q(std::vector<Ring>(1, Ring(1)));
  for (int i = 0; i < 3; ++i) {
    Polynomial difference;
    if constexpr (N == 4)
      difference = counted_product(sides.c[0][i], sides.c[1][3]) - counted_product(sides.c[1][i], sides.c[0][3]);
    else
      difference = sides.c[0][i] - sides.c[1][i];
    s = s + counted_product(difference, difference);
  }
  if constexpr (N == 4) {
    const Polynomial w = counted_product(sides.c[0][3], sides.c[1][3]);
    q = counted_product(w, w);
  }
  const int degree = (std::max)(s.degree(), q.degree());
  const Ring k = twice_the_quotient(s.elevated_to(degree), q.elevated_to(degree), 64);
  const Polynomial factor(std::vector<Ring>(1, k)), acute(std::vector<Ring>(1, Ring(-1)));
  const Normal_deviation<Exact> largest =
      largest_measure<Exact>(s.elevated_to(degree), factor * q.elevated_to(degree), acute);
  // of homogeneous points the common denominator cancels out
  const auto distance = [&](const Exact& measure) {
    return sqrt_enclosure(sides.denominator.divided(Exact(measure * Exact(k)), N == 4 ? 0 : 2));
  };
  return {distance(largest.lower).lower, distance(largest.upper).upper};
}

// The largest angle of the normals on one span, empty when one vanishes identically, and whether
// one vanishes somewhere.
template <class Field, int N>
std::pair<std::optional<Enclosure>, bool> normal_angle(const Edge_sides<Field, N>& sides) {
  typedef typename Edge_sides<Field, N>::Ring Ring;
  const Homogeneous_vector<Ring> n1 = normal_along_edge(sides, 0), n2 = normal_along_edge(sides, 1);
  if (Edge_sides<Field>::is_zero(n1) || Edge_sides<Field>::is_zero(n2)) return {std::nullopt, true};
  const bool vanishing = Edge_normals<Field>::vanishes(n1) || Edge_normals<Field>::vanishes(n2);
  return {largest_angle<Field>(n1, n2, vanishing).angle(), vanishing};
}

template <class Field, int N>
std::vector<Edge_sides<Field, N>> sides_on_spans(const std::vector<Edge_piece<Field, N>>& a,
                                                 const std::vector<Edge_piece<Field, N>>& b,
                                                 const Affine_parameter_map<Field>& map) {
  std::vector<Edge_sides<Field, N>> sides;
  for (const Common_span<Field>& span : common_spans(a, b, map)) {
    const std::pair<Edge_rows<Field, N>, Edge_rows<Field, N>> rows = rows_on(a, b, span, map);
    sides.emplace_back(rows.first, rows.second);
  }
  return sides;
}

template <class Field, int N> Enclosure largest_distance(const std::vector<Edge_sides<Field, N>>& spans) {
  Enclosure gap{0, 0};
  for (const Edge_sides<Field, N>& sides : spans) gap = larger_of(gap, largest_distance(sides));
  return gap;
}

// The deviation on spans whose gap is known.
template <class Field, int N>
Edge_deviation edge_deviation(const std::vector<Edge_sides<Field, N>>& spans, const Enclosure& gap,
                              Edge_direction direction) {
  Edge_deviation d{gap, Enclosure{0, 0}, false, direction == Edge_direction::opposite};
  for (const Edge_sides<Field, N>& sides : spans) {
    const std::pair<std::optional<Enclosure>, bool> angle = normal_angle(sides);
    d.normal_vanishes = d.normal_vanishes || angle.second;
    if (!angle.first) d.normal_angle.reset();
    if (d.normal_angle) d.normal_angle = larger_of(*d.normal_angle, *angle.first);
  }
  return d;
}

// The deviation along the whole edges, forwards or backwards, whichever has the smaller gap.
template <class Field, int N>
Edge_deviation edge_deviation(const std::vector<Edge_piece<Field, N>>& a, const std::vector<Edge_piece<Field, N>>& b) {
  const std::vector<Edge_sides<Field, N>> forwards = sides_on_spans(a, b, whole_map(a, b, Edge_direction::same));
  const Enclosure gap = largest_distance(forwards);
  if (gap.upper == 0) return edge_deviation(forwards, gap, Edge_direction::same);
  const std::vector<Edge_sides<Field, N>> backwards = sides_on_spans(a, b, whole_map(a, b, Edge_direction::opposite));
  const Enclosure other_gap = largest_distance(backwards);
  return gap.upper <= other_gap.upper ? edge_deviation(forwards, gap, Edge_direction::same)
                                      : edge_deviation(backwards, other_gap, Edge_direction::opposite);
}

// Along lines over one domain, at equal parameters.
template <class Field, int N>
Edge_deviation deviation_at_same_parameters(const Spline_edge_rows<Field, N>& a, const Spline_edge_rows<Field, N>& b) {
  const Work_guard work("deviation of edges");
  const std::vector<Edge_sides<Field, N>> spans =
      sides_on_spans(edge_pieces<Field>(a), edge_pieces<Field>(b), Affine_parameter_map<Field>{Field(1), Field(0)});
  return edge_deviation(spans, largest_distance(spans), Edge_direction::same);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Encloses how far two surfaces are from being continuous along their edges `v = 0`. The second
/// edge is taken in the direction that gives the smaller gap. Everything is computed in an exact
/// field from the coefficients as given; only the last step, a root or an arc tangent, is rounded,
/// outwards. With a gap the normals are compared that belong to the same parameter. Where the limit
/// of the work does not suffice for close enclosures, they are wider ones, and still guaranteed.
/// \throws Error `wrong_number_of_points` for an empty row, `not_finite`, `work_limit`
template <class FT> Edge_deviation deviation(const Edge_rows<FT>& a, const Edge_rows<FT>& b) {
  typedef typename Exact_field<FT>::type Field;
  const internal::Work_guard work("deviation of edges");
  const auto pieces = [](const Edge_rows<FT>& rows) {
    return std::vector<internal::Edge_piece<Field>>{
        {Field(0),
         Field(1),
         {internal::row_in_space<Field>(rows.edge), internal::row_in_space<Field>(rows.cross),
          internal::row_in_space<Field>(rows.second_cross)}}};
  };
  return internal::edge_deviation(pieces(a), pieces(b));
}

/// \ingroup PkgGeometricContinuityContinuity
/// Encloses how far two piecewise polynomial surfaces are from being continuous along an edge of
/// each, on all spans of the knots of both: the domain of one edge as a whole corresponds to that
/// of the other, in the direction that gives the smaller gap. See the function for `Edge_rows`.
/// \throws Error `wrong_number_of_points` when the rows do not fit the knots, `not_finite`,
///   `work_limit`
template <class FT, int N>
Edge_deviation deviation(const Spline_edge_rows<FT, N>& a, const Spline_edge_rows<FT, N>& b) {
  typedef typename Exact_field<FT>::type Field;
  const internal::Work_guard work("deviation of edges");
  return internal::edge_deviation(internal::edge_pieces<Field>(a), internal::edge_pieces<Field>(b));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Encloses how far two surfaces are from being continuous along an edge of each: guaranteed
/// enclosures of the largest distance of the edges, whose domains correspond as a whole in the
/// direction that makes it smaller, and of the largest angle of the normals. Exact up to the last
/// rounding, with every kernel.
/// \tparam Surface_a, Surface_b `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`, in any combination, with one traits class
/// \throws Error `dimension_mismatch` unless in dimension 3, `work_limit`
template <class Surface_a, class Surface_b>
Edge_deviation deviation(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  internal::require_space(a, b, "deviation");
  const internal::Work_guard work("deviation of edges");
  constexpr int N = internal::row_dimension<Surface_a, Surface_b>;
  return internal::edge_deviation(internal::edge_pieces_in<N>(a, edge_a), internal::edge_pieces_in<N>(b, edge_b));
}

/// \ingroup PkgGeometricContinuityContinuity
/// A tolerance along an edge: the quantities of `Edge_deviation`, in their units.
struct Edge_tolerance {
  Bound normal_angle = 0; ///< in radians
  Bound gap = 0;          ///< in units of the coordinates
};

/// \ingroup PkgGeometricContinuityContinuity
/// The orders 0 and 1 of two surfaces along an edge, within a tolerance. (The order 2 has no
/// tolerance: it is decided exactly by `edge_continuity()`.)
struct Edge_order_within {
  Edge_deviation deviation; ///< the deviation on which the verdicts rest
  /// For each order: the edges are the same; in addition the tangent planes agree and the surfaces
  /// continue each other.
  std::array<Verdict, 2> verdicts;

  /// Returns whether the surfaces have the order, 0 or 1, within the tolerance.
  /// \throws Error `jet_order_too_low` for another order
  Verdict operator()(int order) const {
    if (order < 0 || 1 < order)
      throw Error(Error_code::jet_order_too_low,
                  "Edge_order_within: only the orders 0 and 1 have a tolerance, not " + std::to_string(order));
    return verdicts[order];
  }
  /// Returns the largest order that is proved, -1 if none is.
  int proved_order() const { return verdicts[1] == Verdict::proved ? 1 : verdicts[0] == Verdict::proved ? 0 : -1; }

  /// Writes the verdicts and the deviation, e.g. `order 0 proved, 1 refuted; gap 0, ...`.
  friend std::ostream& operator<<(std::ostream& os, const Edge_order_within& within) {
    return os << "order 0 " << within(0) << ", 1 " << within(1) << "; " << within.deviation;
  }
};

namespace internal {

inline void check_tolerance(const Edge_tolerance& tolerance) {
  for (const Bound& bound : {tolerance.normal_angle, tolerance.gap}) check_bound(bound);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns the verdicts on a deviation: *proved* when its enclosures are within the tolerance,
/// *refuted* when one exceeds it, otherwise *undecided*. A normal that vanishes somewhere refutes
/// the order 1: there is no tangent plane.
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number
inline Edge_order_within order_within(const Edge_deviation& deviation, const Edge_tolerance& tolerance) {
  internal::check_tolerance(tolerance);
  const Verdict gap = at_most(deviation.gap, tolerance.gap),
                angle = deviation.normal_angle && !deviation.normal_vanishes
                            ? at_most(*deviation.normal_angle, tolerance.normal_angle)
                            : Verdict::refuted;
  return {deviation, {gap, gap && angle}};
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns the verdicts on edges that have been decided to be the same, at least in part, along the
/// part that they have in common. An order that the surfaces have exactly is proved with each
/// tolerance.
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number;
///   `curves_do_not_meet` when the edges have nothing in common (`edge.g_order < 0`): then their
///   gap is not known, which `deviation()` of the surfaces encloses
template <class FT>
Edge_order_within order_within(const Spline_edge_continuity<FT>& edge, const Edge_tolerance& tolerance) {
  internal::check_tolerance(tolerance);
  if (edge.g_order < 0) throw Error(Error_code::curves_do_not_meet, "order_within: the edges have nothing in common");
  Edge_deviation d{{0, 0}, {}, edge.normal_vanishes, edge.reversed};
  if (edge.deviation) d.normal_angle = edge.deviation->angle();
  return order_within(d, tolerance);
}

namespace internal {

// From the exact decision, and the deviation if it is needed.
template <class FT, class Deviation>
Edge_order_within order_within_or_exactly(const Spline_edge_continuity<FT>& exact, Deviation deviation,
                                          const Edge_tolerance& tolerance) {
  const bool meet = 0 <= exact.g_order;
  if (meet && exact.whole_a && exact.whole_b) return order_within(exact, tolerance);
  const Edge_order_within whole = order_within(deviation(), tolerance);
  return meet && whole(0) == Verdict::refuted ? order_within(exact, tolerance) : whole;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Decides which order, 0 or 1, two piecewise polynomial surfaces have along an edge within a
/// tolerance. The order follows from `deviation()` along the whole edges; where these are farther
/// apart than the tolerance but have a part exactly in common, see `edge_continuity()`, this part
/// counts.
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number,
///   `wrong_number_of_points` when the rows do not fit the knots, `not_finite`, `work_limit`
template <class FT, int N>
Edge_order_within order_within(const Spline_edge_rows<FT, N>& a, const Spline_edge_rows<FT, N>& b,
                               const Edge_tolerance& tolerance) {
  internal::check_tolerance(tolerance);
  return internal::order_within_or_exactly(
      edge_continuity(a, b), [&] { return deviation(a, b); }, tolerance);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides which order, 0 or 1, two surfaces have along an edge of each within a tolerance, see the
/// function for `Spline_edge_rows`. Edges that have nothing in common, exactly or within the
/// tolerance, are refuted, with their gap.
/// \tparam Surface_a, Surface_b `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`, in any combination, with one traits class
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number;
///   `dimension_mismatch` unless in dimension 3; `work_limit`
template <class Surface_a, class Surface_b>
Edge_order_within order_within(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                               const Edge_tolerance& tolerance) {
  internal::check_tolerance(tolerance);
  return internal::order_within_or_exactly(
      edge_continuity(a, edge_a, b, edge_b), [&] { return deviation(a, edge_a, b, edge_b); }, tolerance);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides which order, 0 or 1, two surfaces have along an edge of each within one number, which is
/// the tolerance for the angle of the normals, in radians, and for the gap.
/// \throws Error as the function that takes an `Edge_tolerance`
template <class Surface_a, class Surface_b, class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>>
Edge_order_within order_within(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                               Number tolerance) {
  return order_within(a, edge_a, b, edge_b, Edge_tolerance{Bound(tolerance), Bound(tolerance)});
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides which order, 0 or 1, a B-spline surface has along one of its knot lines within a
/// tolerance. Where the surface jumps its two parts are compared at equal parameters.
/// \tparam Surface `Bspline_surface` or `Rational_bspline_surface`
/// \param surface the surface
/// \param line one of `knot_line_continuity(surface)`
/// \param tolerance for the gap and for the order 1
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number;
///   `knot_multiplicity` when the surface jumps along `line`, but has no inner knot there;
///   `work_limit`
template <class Surface>
Edge_order_within order_within(const Surface& surface, const Knot_line<Edge_field<typename Surface::Traits>>& line,
                               const Edge_tolerance& tolerance) {
  typedef Edge_field<typename Surface::Traits> Field;
  internal::check_tolerance(tolerance);
  if (0 <= line.continuity.g_order) return order_within(line.continuity, tolerance);
  const Parameter_line direction = line.constant_u ? Parameter_line::along_v : Parameter_line::along_u;
  for (const auto& knot : internal::knots_across(surface, direction).inner_knots())
    if (internal::to_field<Field>(knot.value) == line.knot)
      return order_within(internal::deviation_at_same_parameters(
                              internal::knot_line_rows(surface, direction, knot.value, Line_side::smaller_parameters),
                              internal::knot_line_rows(surface, direction, knot.value, Line_side::larger_parameters)),
                          tolerance);
  throw Error(Error_code::knot_multiplicity, "order_within: not a knot line of the surface");
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_DEVIATION_H
