// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_CONTINUITY_H

#include <CGAL/Geometric_continuity/internal/Other_members.h>
#include <CGAL/Geometric_continuity/joins/Curve_ends.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_decision.h>
#include <CGAL/Geometric_continuity/joins/internal/decide_all_questions.h>
#include <CGAL/Geometric_continuity/joins/internal/rounded_points.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>

#include <algorithm>
#include <type_traits>
#include <utility>

/// \file join_continuity.h
/// Decides the continuity of a join: everything that can be said about it. One single question is
/// answered faster by join_predicates.h.
///
/// There are two ways to one answer. Curves with `double` coordinates in the plane and in space,
/// decided exactly up to order 3, take the stages of joins/internal/Join_ladder.h on their control
/// points. All others are decided by jets, see joins/internal/Join_decision.h.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// Multiplies two jets by their common denominator, which changes no answer, and makes rational
// numbers integers. The many products of a high order make it worthwhile.
template <class Field, int N> void clear_denominators(Coordinate_jet<Field, N>& x, Coordinate_jet<Field, N>& y) {
  if constexpr (Common_denominator<Field>::clears) {
    Common_denominator<Field> denominator;
    for (const Coordinate_jet<Field, N>* jet : {&x, &y})
      for (int j = 0; j <= jet->order(); ++j)
        for (const Field& number : (*jet)[j]) denominator.include(number);
    for (Coordinate_jet<Field, N>* jet : {&x, &y})
      for (int j = 0; j <= jet->order(); ++j)
        for (int i = 0; i < jet->dimension(); ++i)
          (*jet)[j][i] = Field(typename Common_denominator<Field>::Exact(denominator.numerator((*jet)[j][i])));
  }
}

// The order up to which all questions about curves with control points are decided on these.
typedef std::integral_constant<int, 3> Order_3;

template <class Left, class Right>
Join_continuity<Predicate_FT<typename Left::Traits>> decide_polygons_of_doubles(const Left& left, const Right& right,
                                                                                int max_order, bool only_orders) {
  Join_continuity<Predicate_FT<typename Left::Traits>> join;
  const Double_ends<dimension_v<typename Left::Traits>> ends(left_end(left), right_end(right));
  decide_all_on_doubles(ends, max_order, join, only_orders ? Join_asked::orders : Join_asked::all);
  return join;
}

// Everything about the join of two curves, see continuity(); if only the orders are wanted, flags
// and shape parameters may be missing. `Order` is `int`, or `Order_3`: then no jets need be
// compiled for curves that always have control points.
template <class Left, class Right, class Order>
Join_continuity<Predicate_FT<typename Left::Traits>> decide_continuity(const Left& left, const Right& right,
                                                                       Order max_order, bool only_orders) {
  typedef typename Left::Traits Traits;
  static_assert(std::is_same_v<Traits, typename Right::Traits>, "both curves must have the same traits class");
  typedef Predicate_FT<Traits> Field;
  constexpr int N = dimension_v<Traits>;
  if (max_order < 0) throw Error(Error_code::negative_count, "continuity: order");
  constexpr bool on_doubles = is_double<typename Traits::FT> && !std::is_floating_point_v<Field> &&
                              (N == 2 || N == 3) && Curve_ends<Left>::have_polygons && Curve_ends<Right>::have_polygons;
  if constexpr (on_doubles && std::is_same_v<Order, Order_3> && Always_has_polygons<Left>::value &&
                Always_has_polygons<Right>::value)
    return decide_polygons_of_doubles(left, right, max_order, only_orders);
  else {
    if constexpr (on_doubles)
      if (max_order <= 3 && has_polygon(left, Curve_end::end) && has_polygon(right, Curve_end::start))
        return decide_polygons_of_doubles(left, right, max_order, only_orders);
    // curvature and torsion are reported for every max_order
    const int order = (std::max)(int(max_order), 3);
    const Work_scope jets_and_decision(Work_scope::limit_of_each(), "continuity");
    Coordinate_jet<Field, N> x = jet_at<Field, Curve_end::end>(left, order),
                             y = jet_at<Field, Curve_end::start>(right, order);
    if (max_order > 3) clear_denominators(x, y);
    return Join_decision<Field, N>(x, y, max_order)();
  }
}

// Returns the result, with the data that up_to_rounding() needs.
template <class Left, class Right, class Order>
Join_continuity<Predicate_FT<typename Left::Traits>> continuity_of_curves(const Left& left, const Right& right,
                                                                          Order max_order) {
  static_assert(!is_surface<Left>, "continuity(a, b) is of two curves; of two surfaces, edge_continuity(a, b) decides "
                                   "their common edge, and is_g2_edge(a, b) is true or false");
  if constexpr (is_surface<Left>) // so that there is one error
    return {};
  else {
    Join_continuity<Predicate_FT<typename Left::Traits>> join = decide_continuity(left, right, max_order, false);
    constexpr int N = dimension_v<typename Left::Traits>;
    if constexpr (std::is_floating_point_v<typename Left::Traits::FT> && (N == 2 || N == 3))
      if (join.g_order < 2 && join.g_order < max_order)
        with_end_points<Curve_end::end>(left, [&](const auto& p) {
          with_end_points<Curve_end::start>(right,
                                            [&](const auto& q) { join.points.template set<N>(p, q, max_order); });
        });
    return join;
  }
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of the join of two jets, `left` at the end of one curve and `right` at
/// the start of the next, up to order `max_order >= 0` or as far as both jets go. The decision is
/// division-free and exact on the numbers of the jets with every exact kernel and with
/// `Exact_predicates_inexact_constructions_kernel`; it is plain floating point, not certified, with
/// `Simple_cartesian<double>` and `Simple_cartesian<float>`, where the jets are scaled by powers of
/// two, so that the units do not matter.
///
/// \f$ C^k \f$: equal derivatives. \f$ G^k \f$: equal arc-length derivatives, i.e. the chain rule
/// (Faà di Bruno) with \f$ \beta_1 > 0 \f$. \f$ F^k \f$: continuous Frenet frame and curvatures,
/// Hagen 2.1 and (2.2), corrected: the curvature \em vector counts.
///
/// \f$ O(n k^2 + k^4) \f$ field operations in dimension `n` for order `k`.
/// \throws Error `negative_count` for a negative order, `dimension_mismatch` when the dimensions
///   differ, `jet_order_too_low` for an empty jet, `not_finite` for an infinite or undefined
///   floating-point coordinate, `work_limit`
template <class Traits>
Join_continuity<Predicate_FT<Traits>> continuity(const Curve_jet<Traits>& left, const Curve_jet<Traits>& right,
                                                 int max_order) {
  typedef Predicate_FT<Traits> Field;
  constexpr int N = dimension_v<Traits>;
  const Coordinate_jet<Field, N> x = internal::convert_jet<Field>(left), y = internal::convert_jet<Field>(right);
  return internal::Join_decision<Field, N>(x, y, max_order)();
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of the join of two jets, `left` at the end of one curve and `right` at
/// the start of the next, as far as both jets go.
/// \throws Error `dimension_mismatch` when the dimensions differ, `jet_order_too_low` for an empty
///   jet, `not_finite` for an infinite or undefined floating-point coordinate
template <class Traits>
Join_continuity<Predicate_FT<Traits>> continuity(const Curve_jet<Traits>& left, const Curve_jet<Traits>& right) {
  const int order = (std::min)(left.order(), right.order());
  if (order < 0) throw Error(Error_code::jet_order_too_low, "continuity of two jets");
  return continuity(left, right, order);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of the join between the end of `left` and the start of `right`, up to
/// order `max_order >= 0`. The flags are decided whatever the order.
///
/// With `Exact_predicates_inexact_constructions_kernel` the control points are read as given, so
/// that the answer is exact; in the plane and in space, up to order 3, it costs little more than a
/// few predicates of join_predicates.h. With `Simple_cartesian<double>` and
/// `Simple_cartesian<float>` it is plain floating point, which may miss an order that holds and
/// report one that does not; those predicates are exact with every kernel.
///
/// \tparam Left, Right models of `ParametricCurve` with one traits class, or types for which
///   `Curve_ends` is specialised
/// \throws Error `negative_count` for a negative order, `dimension_mismatch` when the dimensions
///   differ, `not_finite` when derivatives overflow, `work_limit`: with exact numbers, high orders
///   are forms of high degree
template <class Left, class Right>
Join_continuity<Predicate_FT<typename Left::Traits>> continuity(const Left& left, const Right& right, int max_order) {
  return internal::continuity_of_curves(left, right, max_order);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of the join between the end of `left` and the start of `right`, up to
/// order 3. A program that calls this function for Bézier curves only compiles faster than with
/// orders that are known at run time.
/// \tparam Left, Right as above
/// \throws Error as above
template <class Left, class Right>
Join_continuity<Predicate_FT<typename Left::Traits>> continuity(const Left& left, const Right& right) {
  return internal::continuity_of_curves(left, right, internal::Order_3());
}

/// \cond SKIP_IN_MANUAL
// A tolerance, which would be rounded to an order.
template <class Left, class Right, class Number, class = std::enable_if_t<std::is_floating_point_v<Number>>>
internal::No_result continuity(const Left&, const Right&, Number) {
  static_assert(internal::never<Left>, "the third argument is the highest order to decide, and this function is exact: "
                                       "order_within(a, b, 1e-6) allows a tolerance");
  return {};
}
/// \endcond

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_CONTINUITY_H
