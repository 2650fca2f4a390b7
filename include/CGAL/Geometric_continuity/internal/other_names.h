// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_OTHER_NAMES_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_OTHER_NAMES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

/// \file other_names.h
/// Names that other packages, and people who have not read the manual, give to what this package
/// has. Some are other names of the same thing: they work, and the compiler warns with the name
/// here. The others do not compile, and the first error is the sentence that tells the call. The
/// header is the last one that CGAL/Geometric_continuity.h includes, and uses what that has.

namespace CGAL {
namespace Geometric_continuity {

/// \cond SKIP_IN_MANUAL

// Classes
#define CGAL_GEOMETRIC_CONTINUITY_CLASS(name, real)                                                                    \
  template <class Traits> using name [[deprecated("the class is " #real)]] = real<Traits>;
CGAL_GEOMETRIC_CONTINUITY_CLASS(Bezier, Bezier_curve)
CGAL_GEOMETRIC_CONTINUITY_CLASS(Bspline, Bspline_curve)
CGAL_GEOMETRIC_CONTINUITY_CLASS(BSpline, Bspline_curve)
CGAL_GEOMETRIC_CONTINUITY_CLASS(NURBS, Rational_bspline_curve)
CGAL_GEOMETRIC_CONTINUITY_CLASS(B_spline_curve, Bspline_curve)
CGAL_GEOMETRIC_CONTINUITY_CLASS(BSpline_curve, Bspline_curve)
CGAL_GEOMETRIC_CONTINUITY_CLASS(NURBS_curve, Rational_bspline_curve)
CGAL_GEOMETRIC_CONTINUITY_CLASS(Nurbs_curve, Rational_bspline_curve)
CGAL_GEOMETRIC_CONTINUITY_CLASS(Rational_B_spline_curve, Rational_bspline_curve)
CGAL_GEOMETRIC_CONTINUITY_CLASS(Bezier_surface, Bezier_patch)
CGAL_GEOMETRIC_CONTINUITY_CLASS(Rational_bezier_surface, Rational_bezier_patch)
CGAL_GEOMETRIC_CONTINUITY_CLASS(B_spline_surface, Bspline_surface)
CGAL_GEOMETRIC_CONTINUITY_CLASS(BSpline_surface, Bspline_surface)
CGAL_GEOMETRIC_CONTINUITY_CLASS(NURBS_surface, Rational_bspline_surface)
CGAL_GEOMETRIC_CONTINUITY_CLASS(Nurbs_surface, Rational_bspline_surface)
CGAL_GEOMETRIC_CONTINUITY_CLASS(Piecewise_bezier_curve, Composite_bezier_curve)
CGAL_GEOMETRIC_CONTINUITY_CLASS(Bezier_spline, Composite_bezier_curve)
#undef CGAL_GEOMETRIC_CONTINUITY_CLASS

// Classes over a kernel, as other packages name them
#define CGAL_GEOMETRIC_CONTINUITY_CLASS(name, dimension, real)                                                         \
  template <class Kernel>                                                                                              \
  using name##_##dimension [[deprecated("the class is " #real "<Traits_" #dimension "<Kernel>>")]] =                   \
      real<Traits_##dimension<Kernel>>;
#define CGAL_GEOMETRIC_CONTINUITY_CURVE(name, real)                                                                    \
  CGAL_GEOMETRIC_CONTINUITY_CLASS(name, 2, real) CGAL_GEOMETRIC_CONTINUITY_CLASS(name, 3, real)
CGAL_GEOMETRIC_CONTINUITY_CURVE(Bezier_curve, Bezier_curve)
CGAL_GEOMETRIC_CONTINUITY_CURVE(Composite_bezier_curve, Composite_bezier_curve)
CGAL_GEOMETRIC_CONTINUITY_CURVE(Bspline_curve, Bspline_curve)
CGAL_GEOMETRIC_CONTINUITY_CURVE(B_spline_curve, Bspline_curve)
CGAL_GEOMETRIC_CONTINUITY_CURVE(BSpline_curve, Bspline_curve)
CGAL_GEOMETRIC_CONTINUITY_CURVE(NURBS_curve, Rational_bspline_curve)
CGAL_GEOMETRIC_CONTINUITY_CURVE(Nurbs_curve, Rational_bspline_curve)
CGAL_GEOMETRIC_CONTINUITY_CURVE(Rational_bspline_curve, Rational_bspline_curve)
CGAL_GEOMETRIC_CONTINUITY_CURVE(Rational_bezier_curve, Rational_bezier_curve)
CGAL_GEOMETRIC_CONTINUITY_CLASS(Bezier_patch, 3, Bezier_patch)
CGAL_GEOMETRIC_CONTINUITY_CLASS(Bezier_surface, 3, Bezier_patch)
CGAL_GEOMETRIC_CONTINUITY_CLASS(Bspline_surface, 3, Bspline_surface)
CGAL_GEOMETRIC_CONTINUITY_CLASS(B_spline_surface, 3, Bspline_surface)
CGAL_GEOMETRIC_CONTINUITY_CLASS(BSpline_surface, 3, Bspline_surface)
CGAL_GEOMETRIC_CONTINUITY_CLASS(NURBS_surface, 3, Rational_bspline_surface)
CGAL_GEOMETRIC_CONTINUITY_CLASS(Nurbs_surface, 3, Rational_bspline_surface)
#undef CGAL_GEOMETRIC_CONTINUITY_CURVE
#undef CGAL_GEOMETRIC_CONTINUITY_CLASS

template <class Kernel> using Bezier_traits_2 [[deprecated("the class is Traits_2<Kernel>")]] = Traits_2<Kernel>;
template <class Kernel> using Bezier_traits_3 [[deprecated("the class is Traits_3<Kernel>")]] = Traits_3<Kernel>;

// Edges
[[deprecated("the edge is Patch_edge::u0")]] inline constexpr Patch_edge U_MIN = Patch_edge::u0;
[[deprecated("the edge is Patch_edge::u1")]] inline constexpr Patch_edge U_MAX = Patch_edge::u1;
[[deprecated("the edge is Patch_edge::v0")]] inline constexpr Patch_edge V_MIN = Patch_edge::v0;
[[deprecated("the edge is Patch_edge::v1")]] inline constexpr Patch_edge V_MAX = Patch_edge::v1;

namespace internal {

// Tells whether an order up to 3 holds: of two curves at their join, of two surfaces along their
// common edge, of a spline at its knots, of a chain of curves at all joins.
template <int order> struct Has_order {
  template <class A, class B> bool operator()(const A& a, const B& b) const {
    static_assert(!std::is_arithmetic_v<B>, "knot_continuity(spline, u).g_order is the order at one parameter");
    constexpr bool are_iterators = std::is_same_v<A, B> && !Has_traits<A>::value;
    static_assert(!are_iterators,
                  "failing_joins(curves, is_g2_join).empty() decides a chain, which is given as a range");
    if constexpr (std::is_arithmetic_v<B> || are_iterators) // so that there is one error
      return false;
    else if constexpr (is_surface<A>)
      return edge_continuity(a, b).g_order >= order;
    else if constexpr (order == 1)
      return is_g1_join(a, b);
    else if constexpr (order == 2)
      return is_g2_join(a, b);
    else
      return is_g3_join(a, b);
  }

  // This refuses a tolerance.
  template <class A, class B, class Number> bool operator()(const A&, const B&, const Number&) const {
    static_assert(!std::is_same_v<Number, Number>, "order_within(a, b, 1e-6) proves or refutes the orders within a "
                                                   "tolerance; of surfaces it takes the edges, too");
    return false;
  }

  // This refuses two surfaces with the edges.
  template <class A, class B> bool operator()(const A&, const Patch_edge&, const B&, const Patch_edge&) const {
    static_assert(!std::is_same_v<A, A>, "edge_continuity(a, Patch_edge::u1, b, Patch_edge::u0).g_order is the order "
                                         "of two surfaces along these edges");
    return false;
  }

  template <class Chain> bool operator()(const Chain& chain) const {
    if constexpr (Has_traits<Chain>::value) {
      const auto knots = knot_continuities(chain, order);
      return std::all_of(knots.begin(), knots.end(), [](const auto& knot) { return knot.join.g_order >= order; });
    } else
      return failing_joins(chain, *this).empty();
  }
};

} // namespace internal

// Predicates, in the spelling of the orders
[[deprecated("call is_g1_join(a, b) for curves, is_g1_edge(a, b) for surfaces, knot_continuities(c) for a "
             "spline, failing_joins(curves, is_g1_join) for a chain")]] inline constexpr internal::Has_order<1>
    is_G1{}, is_g1{};
[[deprecated("call is_g2_join(a, b) for curves, is_g2_edge(a, b) for surfaces, knot_continuities(c) for a "
             "spline, failing_joins(curves, is_g2_join) for a chain")]] inline constexpr internal::Has_order<2>
    is_G2{}, is_g2{};
[[deprecated("call is_g3_join(a, b) for curves, is_g3_edge(a, b) for surfaces, knot_continuities(c) for a "
             "spline, failing_joins(curves, is_g3_join) for a chain")]] inline constexpr internal::Has_order<3>
    is_G3{}, is_g3{};
[[deprecated("call is_c_join<1>(a, b)")]] inline constexpr internal::Parametric_join_predicate<1> is_C1{}, is_c1{};
[[deprecated("call is_c_join<2>(a, b)")]] inline constexpr internal::Parametric_join_predicate<2> is_C2{}, is_c2{};
[[deprecated("call is_c_join<3>(a, b)")]] inline constexpr internal::Parametric_join_predicate<3> is_C3{}, is_c3{};

// Orders, where a strategy is expected, or behind it: blend() tells the strategies.
#define CGAL_GEOMETRIC_CONTINUITY_ASK_STRATEGY "blend(a, b, Fair()) is a blend with G2, blend(a, b, Fair_g3()) with G3"
namespace internal {
template <class Given, class Type> using If_same = std::enable_if_t<std::is_same_v<Given, Type>>;

struct Named_order {
  int order;
  constexpr operator int() const { return order; }
  template <class... Given> No_result operator()(const Given&...) const {
    static_assert(never<Given...>,
                  "is_g2_join(a, b) decides if two curves are G2; " CGAL_GEOMETRIC_CONTINUITY_ASK_STRATEGY);
    return {};
  }
};
} // namespace internal
[[deprecated(
    "the strategy tells the order: Fair() for G2, Fair_g3() for G3")]] inline constexpr internal::Named_order G1{1},
    G2{2}, G3{3};
template <int order, class Left, class Right> auto blend(const Left&, const Right&) {
  static_assert(internal::never<Left>, CGAL_GEOMETRIC_CONTINUITY_ASK_STRATEGY);
  return internal::No_result();
}
template <class Left, class Right> auto blend(const Left&, const Right&, const internal::Named_order&) {
  static_assert(internal::never<Left>, CGAL_GEOMETRIC_CONTINUITY_ASK_STRATEGY);
  return internal::No_result();
}
// The type of a number is deduced here and below, so that {} is none.
template <class Curve, class Strategy, class Order, class = typename Curve::Traits,
          class = internal::If_same<Order, int>>
auto blend(const Curve&, const Curve&, const Strategy&, Order) {
  static_assert(internal::never<Curve>, CGAL_GEOMETRIC_CONTINUITY_ASK_STRATEGY);
  return internal::No_result();
}
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_STRATEGY

// A spline in the place of a chain: its joins are its knots.
template <class Traits>
[[deprecated("the joins of a spline are its knots: call knot_continuities(c)")]] std::vector<Knot_continuity<Traits>>
chain_joins(const Bspline_curve<Traits>& c, int max_order = 3) {
  return knot_continuities(c, max_order);
}
template <class Traits>
[[deprecated("the joins of a spline are its knots: call knot_continuities(c)")]] std::vector<Knot_continuity<Traits>>
chain_joins(const Rational_bspline_curve<Traits>& c, int max_order = 3) {
  return knot_continuities(c, max_order);
}
template <class Traits>
[[deprecated("the joins of a spline are its knots: call knot_continuities(c)")]] std::vector<Knot_continuity<Traits>>
continuity(const Bspline_curve<Traits>& c, int max_order = 3) {
  return knot_continuities(c, max_order);
}
template <class Traits>
[[deprecated("the joins of a spline are its knots: call knot_continuities(c)")]] std::vector<Knot_continuity<Traits>>
continuity(const Rational_bspline_curve<Traits>& c, int max_order = 3) {
  return knot_continuities(c, max_order);
}

// An iterator to which the curves would be written, as algorithms of CGAL do.
template <class Chain, class Number, class Output_iterator,
          class = std::enable_if_t<std::is_same_v<typename std::iterator_traits<Output_iterator>::iterator_category,
                                                  std::output_iterator_tag>>>
internal::No_result round_corners(const Chain&, const Number&, const Output_iterator&) {
  static_assert(internal::never<Chain>,
                "round_corners(points_or_curves, distance) returns the chain, which has begin() "
                "and end(): std::copy(rounded.begin(), rounded.end(), out)");
  return {};
}

// A degree, which a curve through points does not take.
template <class Point, class Degree, class = internal::If_same<Degree, int>>
auto interpolate(const std::vector<Point>&, Degree) {
  static_assert(internal::never<Point>, "interpolate(points) is a cubic spline, interpolate_fair(points) has degree 5: "
                                        "there is no degree to give");
  return internal::No_result();
}
template <class Input_iterator, class Degree, class = internal::If_same<Degree, int>>
auto interpolate(Input_iterator, Input_iterator, Degree) {
  static_assert(internal::never<Input_iterator>, "interpolate(first, last) is a cubic spline, interpolate_fair(points) "
                                                 "has degree 5: there is no degree to give");
  return internal::No_result();
}
template <class Kernel, class Input_iterator, class Degree, class = typename Kernel::Point_2,
          class = internal::If_same<Degree, int>>
auto interpolate(Input_iterator, Input_iterator, Degree) {
  static_assert(internal::never<Kernel>, "interpolate(first, last) is a cubic spline over the kernel of the points: "
                                         "there is no kernel and no degree to give");
  return internal::No_result();
}

// Parameters without the traits class, and the traits class without parameters.
template <class Points, class Numbers> auto interpolate(const std::vector<Points>&, const std::vector<Numbers>&) {
  static_assert(internal::never<Points>, "interpolate<Traits>(points, parameters) is a spline through points at given "
                                         "parameters: name the traits class");
  return internal::No_result();
}
template <class Traits> auto interpolate(const std::vector<typename Traits::Point>&) {
  static_assert(internal::never<Traits>,
                "interpolate(points) is a cubic spline over the kernel of the points: there is "
                "no traits class to give");
  return internal::No_result();
}

// A tolerance that is missing, or a degree.
#define CGAL_GEOMETRIC_CONTINUITY_ASK_TOLERANCE                                                                        \
  "fit(points, tolerance) fits a smooth curve to a polyline: there is no degree to give"
template <class Point> auto fit(const std::vector<Point>&) {
  static_assert(internal::never<Point>, CGAL_GEOMETRIC_CONTINUITY_ASK_TOLERANCE);
  return internal::No_result();
}
template <class Point, class Degree, class Tolerance, class = internal::If_same<Degree, int>,
          class = internal::If_same<Tolerance, double>>
auto fit(const std::vector<Point>&, Degree, Tolerance) {
  static_assert(internal::never<Point>, CGAL_GEOMETRIC_CONTINUITY_ASK_TOLERANCE);
  return internal::No_result();
}
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_TOLERANCE

// A length, by which no curve is extended.
template <
    class Curve, class Number,
    class = std::enable_if_t<std::is_convertible_v<Number, typename Curve::Traits::FT> || std::is_arithmetic_v<Number>>>
auto extend(const Curve&, const Number&) {
  static_assert(internal::never<Curve>,
                "extend(c, Frenet_order::curvature, {beta}) is the next segment of a curve, whose "
                "speed is beta times that of the last one");
  return internal::No_result();
}

// An iterator to which joins would be written, as algorithms of CGAL do.
template <class Input_iterator, class Output_iterator, class... Given,
          class = std::enable_if_t<std::is_same_v<typename std::iterator_traits<Output_iterator>::iterator_category,
                                                  std::output_iterator_tag>>>
auto chain_joins(const Input_iterator&, const Input_iterator&, const Output_iterator&, const Given&...) {
  static_assert(internal::never<Input_iterator>,
                "chain_joins(curves) takes a range and returns one Join_continuity for "
                "each join");
  return internal::No_result();
}

// Curves in braces.
template <class Curve> auto chain_joins(std::initializer_list<Curve>) {
  static_assert(internal::never<Curve>, "chain_joins(std::vector{a, b}) takes a range of curves");
  return internal::No_result();
}
template <class Curve> auto chain_continuity(std::initializer_list<Curve>) {
  static_assert(internal::never<Curve>, "chain_continuity(std::vector{a, b}) takes a range of curves");
  return internal::No_result();
}

// A knot that is missing.
template <class Curve, class = typename Curve::Traits> auto knot_continuity(const Curve&) {
  static_assert(internal::never<Curve>, "knot_continuities(c) decides all knots, knot_continuity(c, u) one of them");
  return internal::No_result();
}

// Edges, for which there is a function of its own.
template <class Surface_a, class Surface_b>
auto continuity(const Surface_a&, Patch_edge, const Surface_b&, Patch_edge, int = 2) {
  static_assert(internal::never<Surface_a>,
                "edge_continuity(a, Patch_edge::u1, b, Patch_edge::u0) decides two surfaces "
                "along these edges");
  return internal::No_result();
}

// Curves in a range or between iterators, for which there are functions of their own.
#define CGAL_GEOMETRIC_CONTINUITY_ASK_JOINS                                                                            \
  "chain_joins(curves) decides the joins of a chain, and has one Join_continuity for each; chain_continuity(curves) "  \
  "counts them, failing_joins(curves, is_g2_join) lists those that fail; continuity(a, b) is of two curves"
template <class Iterator, class = typename std::iterator_traits<Iterator>::iterator_category>
auto continuity(const Iterator&, const Iterator&, int = 3, Closure = Closure::open) {
  static_assert(internal::never<Iterator>, CGAL_GEOMETRIC_CONTINUITY_ASK_JOINS);
  return internal::No_result();
}
template <class Range, class = internal::Curve_of_range<Range>>
auto continuity(const Range&, int = 3, Closure = Closure::open) {
  static_assert(internal::never<Range>, CGAL_GEOMETRIC_CONTINUITY_ASK_JOINS);
  return internal::No_result();
}
template <class Curve> auto continuity(std::initializer_list<Curve>) {
  static_assert(internal::never<Curve>, CGAL_GEOMETRIC_CONTINUITY_ASK_JOINS);
  return internal::No_result();
}
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_JOINS

// An order, or nothing, in the place of a predicate.
template <class Range, class = internal::Curve_of_range<Range>> auto failing_joins(const Range&, int = 2) {
  static_assert(internal::never<Range>,
                "failing_joins(curves, is_g2_join) lists the joins of a chain that are not G2: name the predicate");
  return internal::No_result();
}

// A tolerance that is missing.
template <class Left, class Right, class = typename Left::Traits, class = typename Right::Traits>
auto order_within(const Left&, const Right&) {
  static_assert(internal::never<Left>, "order_within(a, b, tolerance) decides within a tolerance, continuity(a, b) "
                                       "without one");
  return internal::No_result();
}

// Parameters, where functions take a jet, or more. They have the type of the curve's numbers, and
// are a pack, so that functions with such names that people have are better matches.
#define CGAL_GEOMETRIC_CONTINUITY_NO_CALL(name, parameters, sentence)                                                  \
  template <class Object, class... Given>                                                                              \
  std::enable_if_t<sizeof...(Given) == parameters && (std::is_same_v<Given, typename Object::Traits::FT> && ...) &&    \
                       std::is_class_v<typename Object::Traits>,                                                       \
                   internal::No_result>                                                                                \
  name(const Object&, const Given&...) {                                                                               \
    static_assert(internal::never<Object>, sentence);                                                                  \
    return {};                                                                                                         \
  }
CGAL_GEOMETRIC_CONTINUITY_NO_CALL(evaluate, 1, "c(u) is the point at the parameter u")
CGAL_GEOMETRIC_CONTINUITY_NO_CALL(evaluate, 2,
                                  "s(u, v) is the point of a surface, c.jet(u, k) has the derivatives of "
                                  "a curve up to order k")
CGAL_GEOMETRIC_CONTINUITY_NO_CALL(normal, 1, CGAL_GEOMETRIC_CONTINUITY_ASK_FRAME)
CGAL_GEOMETRIC_CONTINUITY_NO_CALL(normal, 2,
                                  "s.normal(u, v) is the normal of a surface, s.unit_normal(u, v) the one "
                                  "of length 1")
CGAL_GEOMETRIC_CONTINUITY_NO_CALL(curvature, 0, CGAL_GEOMETRIC_CONTINUITY_ASK_CURVATURE)
CGAL_GEOMETRIC_CONTINUITY_NO_CALL(signed_curvature, 1, CGAL_GEOMETRIC_CONTINUITY_ASK_CURVATURE)
CGAL_GEOMETRIC_CONTINUITY_NO_CALL(curvature_vector, 1,
                                  "curvature_vector(c.jet(u, 2)) is the curvature vector at u, an "
                                  "optional")
CGAL_GEOMETRIC_CONTINUITY_NO_CALL(chord_polyline, 1, CGAL_GEOMETRIC_CONTINUITY_ASK_POLYLINE)
#undef CGAL_GEOMETRIC_CONTINUITY_NO_CALL

// A curve, which has no triangles.
template <class Curve, class... Output_iterator>
std::enable_if_t<
    sizeof...(Output_iterator) == 1 &&
        (std::is_same_v<typename std::iterator_traits<Output_iterator>::iterator_category, std::output_iterator_tag> &&
         ...),
    internal::No_result>
tessellate(const Curve&, const typename Curve::Traits::FT&, const Output_iterator&...) {
  static_assert(internal::never<Curve>, CGAL_GEOMETRIC_CONTINUITY_ASK_POLYLINE);
  return {};
}

// Curves that are no Bezier curves, whose kink has no handles.
template <class Left, class Right, class = typename Left::Traits, class = typename Right::Traits,
          class = std::enable_if_t<!internal::is_bezier_curve<Left> || !internal::is_bezier_curve<Right>>>
auto kink_size(const Left&, const Right&) {
  static_assert(internal::never<Left>,
                "kink_size(a, b) is of two Bezier curves; deviation(a, b).tangent_angle encloses "
                "the angle at the join of any two curves, in radians");
  return internal::No_result();
}

// A flag, which interpolate_fair() does not take.
template <class Points, class Flag, class = internal::If_same<Flag, bool>> auto interpolate_fair(const Points&, Flag) {
  static_assert(internal::never<Points>, "interpolate_fair(points, Closure::closed) is a closed curve");
  return internal::No_result();
}

// Points in the place of a curve.
#define CGAL_GEOMETRIC_CONTINUITY_ASK_CURVE                                                                            \
  "control points are no curve: give Bezier_curve<Traits_2<Kernel>>(points), in space "                                \
  "Bezier_curve<Traits_3<Kernel>>(points)"
#define CGAL_GEOMETRIC_CONTINUITY_NO_CURVE(name)                                                                       \
  template <class Point, class Kernel = typename Point::R, class... Given>                                             \
  auto name(const std::vector<Point>&, const Given&...) {                                                              \
    static_assert(internal::never<Kernel>, CGAL_GEOMETRIC_CONTINUITY_ASK_CURVE);                                       \
    return internal::No_result();                                                                                      \
  }                                                                                                                    \
  template <class Point, std::size_t n, class Kernel = typename Point::R, class... Given>                              \
  auto name(const std::array<Point, n>&, const Given&...) {                                                            \
    static_assert(internal::never<Kernel>, CGAL_GEOMETRIC_CONTINUITY_ASK_CURVE);                                       \
    return internal::No_result();                                                                                      \
  }
CGAL_GEOMETRIC_CONTINUITY_NO_CURVE(continuity)
CGAL_GEOMETRIC_CONTINUITY_NO_CURVE(deviation)
CGAL_GEOMETRIC_CONTINUITY_NO_CURVE(order_within)
CGAL_GEOMETRIC_CONTINUITY_NO_CURVE(curvature)
CGAL_GEOMETRIC_CONTINUITY_NO_CURVE(torsion)
CGAL_GEOMETRIC_CONTINUITY_NO_CURVE(blend)
CGAL_GEOMETRIC_CONTINUITY_NO_CURVE(extend)
CGAL_GEOMETRIC_CONTINUITY_NO_CURVE(tangent_angle)
CGAL_GEOMETRIC_CONTINUITY_NO_CURVE(frenet_frame)
#undef CGAL_GEOMETRIC_CONTINUITY_NO_CURVE
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_CURVE
// ... and in that of the curves of a chain.
#define CGAL_GEOMETRIC_CONTINUITY_NO_CHAIN(name)                                                                       \
  template <class Point, class Kernel = typename Point::R, class... Given>                                             \
  auto name(const std::vector<std::vector<Point>>&, const Given&...) {                                                 \
    static_assert(internal::never<Kernel>, "lists of control points are no chain: give a std::vector of "              \
                                           "Bezier_curve<Traits_2<Kernel>>, in space of "                              \
                                           "Bezier_curve<Traits_3<Kernel>>");                                          \
    return internal::No_result();                                                                                      \
  }
CGAL_GEOMETRIC_CONTINUITY_NO_CHAIN(chain_continuity)
CGAL_GEOMETRIC_CONTINUITY_NO_CHAIN(chain_joins)
CGAL_GEOMETRIC_CONTINUITY_NO_CHAIN(failing_joins)
#undef CGAL_GEOMETRIC_CONTINUITY_NO_CHAIN

// A function that does not exist, with the sentence that is the first error of the compiler where
// it is called, also with a kernel in angle brackets. It is in a namespace of its own, so that a
// call without a namespace does not find it: people have functions with such names.
#define CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(name, sentence)                                                          \
  namespace other_names {                                                                                              \
  template <class Kernel = void, class... Given> auto name(const Given&...) {                                          \
    static_assert(internal::never<Kernel, Given...>, sentence);                                                        \
    return internal::No_result();                                                                                      \
  }                                                                                                                    \
  }

CGAL_GEOMETRIC_CONTINUITY_OTHER_CALLS(CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(derivative, CGAL_GEOMETRIC_CONTINUITY_ASK_DERIVATIVE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(reverse, "c.reverse() is the curve in the opposite direction")
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(elevate, CGAL_GEOMETRIC_CONTINUITY_ASK_ELEVATE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(bezier_pieces, "c.bezier_pieces() of a spline are its Bezier curves")
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(concatenate, CGAL_GEOMETRIC_CONTINUITY_ASK_CONVERSION)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(intersection, CGAL_GEOMETRIC_CONTINUITY_ASK_INTERSECTIONS)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(do_intersect, CGAL_GEOMETRIC_CONTINUITY_ASK_INTERSECTIONS)

#define CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN                                                                             \
  "continuity(a, b) decides the join of two curves: .g_order, .c_order, .f_order, .betas(); is_g2_join(a, b) is "      \
  "true or false; chain_continuity(curves) is of a chain; order_within(a, b, 1e-6) allows a tolerance; "               \
  "knot_continuity(spline, u) is of a knot, "                                                                          \
  "edge_continuity(a, b) of two surfaces"
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(is_geometrically_continuous, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(check_join, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(check_continuity, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(is_continuous, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(is_smooth, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(geometric_continuity, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(join_continuity, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(continuity_order, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(order_of_continuity, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(parametric_continuity, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(order_of_geometric_continuity, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(order, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(g_order, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(geometric_order, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
// ... also with an order in angle brackets.
#define CGAL_GEOMETRIC_CONTINUITY_NO_ORDER_FUNCTION(name)                                                              \
  CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(name, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)                                      \
  namespace other_names {                                                                                              \
  template <int order, class... Given> auto name(const Given&...) {                                                    \
    static_assert(internal::never<Given...>, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN);                                      \
    return internal::No_result();                                                                                      \
  }                                                                                                                    \
  }
CGAL_GEOMETRIC_CONTINUITY_NO_ORDER_FUNCTION(is_G)
CGAL_GEOMETRIC_CONTINUITY_NO_ORDER_FUNCTION(is_g)
CGAL_GEOMETRIC_CONTINUITY_NO_ORDER_FUNCTION(is_g_join)
CGAL_GEOMETRIC_CONTINUITY_NO_ORDER_FUNCTION(is_G_join)
#undef CGAL_GEOMETRIC_CONTINUITY_NO_ORDER_FUNCTION
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(is_G2_continuous, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(is_g2_continuous, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(is_geometric_continuous, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(decide_continuity, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(prove_continuity, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(are_g2, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(are_C1, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(are_C2, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(are_G1, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(are_G2, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(are_G3, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(joint_continuity, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(G1_join, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(G2_join, CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN)
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_JOIN

#define CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN                                                                            \
  "failing_joins(curves, is_g2_join) lists the joins of a chain that fail; chain_joins(curves) has one "               \
  "Join_continuity for each; chain_continuity(curves) counts them; knot_continuities(spline) is of a spline"
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(verify, CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(verify_chain, CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(verify_spline, CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(is_chain_continuous, CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(check_chain, CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(joins, CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(classify_joins, CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(chain_order, CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(kinks, CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(find_kinks, CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(is_closed, CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(is_g2_chain, CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(is_G2_chain, CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(is_chain_g2, CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(is_chain_G2, CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN)
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_CHAIN

#define CGAL_GEOMETRIC_CONTINUITY_ASK_EDGE                                                                             \
  "edge_continuity(a, b) decides two surfaces along their common edge: .g_order; is_g2_edge(a, b) is true or false; "  \
  "edge_deviation(a, Patch_edge::v1, b, Patch_edge::v0) measures the distance from smoothness"
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(surface_continuity, CGAL_GEOMETRIC_CONTINUITY_ASK_EDGE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(patch_continuity, CGAL_GEOMETRIC_CONTINUITY_ASK_EDGE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(check_edge, CGAL_GEOMETRIC_CONTINUITY_ASK_EDGE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(verify_edge, CGAL_GEOMETRIC_CONTINUITY_ASK_EDGE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(is_smooth_edge, CGAL_GEOMETRIC_CONTINUITY_ASK_EDGE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(edge_angle, CGAL_GEOMETRIC_CONTINUITY_ASK_EDGE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(normal_angle, CGAL_GEOMETRIC_CONTINUITY_ASK_EDGE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(max_normal_angle, CGAL_GEOMETRIC_CONTINUITY_ASK_EDGE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(largest_normal_angle, CGAL_GEOMETRIC_CONTINUITY_ASK_EDGE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(dihedral_angle, CGAL_GEOMETRIC_CONTINUITY_ASK_EDGE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(surface_deviation, CGAL_GEOMETRIC_CONTINUITY_ASK_EDGE)
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_EDGE

#define CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND                                                                            \
  "blend(a, b) joins two curves with G2, in degree 5; blend(a, b, Fair_g3()) with G3, in degree 7"
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(blend_curves, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(make_blend, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(G2_blend, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(g2_blend, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(quintic_blend, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(septic_blend, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(hermite_blend, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(quintic_hermite, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(bridge, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(connect_curves, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(fair_blend, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(blend_G1, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(blend_g1, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(blend_G2, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(blend_g2, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(blend_G3, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(blend_g3, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(G1_blend, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(g1_blend, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(G3_blend, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(g3_blend, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(quintic_G2_blend, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(make_G2_blend, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(make_blend_curve, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(blend_curve, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(join_curves, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(connect_g2, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(connect_G2, CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND)
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_BLEND
#define CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR                                                                           \
  "blend(a, b) makes a new curve between two; align_handles() and harmonise_handles() move handles on a grid until "   \
  "a join is G1 or G2; geometric_continuity repair FILE mends the joins of drawings, fonts and files .g2"
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(repair, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(repair_chain, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(repair_curves, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(repair_join, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(repair_joins, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(fix_chain, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(fix_join, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(fix_joins, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(mend_chain, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(heal, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(heal_chain, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(make_smooth, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(make_G1, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(make_g1, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(make_G2, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(make_g2, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(make_continuous, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(smooth, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(smooth_chain, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(smooth_join, CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR)
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_REPAIR
#define CGAL_GEOMETRIC_CONTINUITY_ASK_BOUNDARY                                                                         \
  "boundary_curve(s, Patch_edge::u0) is an edge as a curve; the edge u1 of s.split_u(u).first is the curve of a "      \
  "constant u"
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(edge_curve, CGAL_GEOMETRIC_CONTINUITY_ASK_BOUNDARY)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(patch_edge, CGAL_GEOMETRIC_CONTINUITY_ASK_BOUNDARY)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(iso_curve, CGAL_GEOMETRIC_CONTINUITY_ASK_BOUNDARY)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(isocurve, CGAL_GEOMETRIC_CONTINUITY_ASK_BOUNDARY)
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_BOUNDARY
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(match_surfaces, "match(a, Patch_edge::v1, b, Patch_edge::v0) changes b so that "
                                                      "it continues a")
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(
    blend_surfaces, "blend(a, Patch_edge::v1, b, Patch_edge::v0) joins two surfaces by a surface that is G2 along both "
                    "edges")
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(
    blend_surface, "blend(a, Patch_edge::v1, b, Patch_edge::v0) joins two surfaces by a surface that is G2 along both "
                   "edges")
#define CGAL_GEOMETRIC_CONTINUITY_ASK_ROUND                                                                            \
  "round_corners(points_or_curves, distance) rounds the corners of a polyline or a chain, round_corner(a, b, "         \
  "distance) one of them, round_edge() the edge between two surfaces"
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(fillet, CGAL_GEOMETRIC_CONTINUITY_ASK_ROUND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(round_polygon, CGAL_GEOMETRIC_CONTINUITY_ASK_ROUND)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(round_polyline, CGAL_GEOMETRIC_CONTINUITY_ASK_ROUND)
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_ROUND
#define CGAL_GEOMETRIC_CONTINUITY_ASK_FIT "fit(points, tolerance) fits a smooth curve to a polyline"
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(fit_curve, CGAL_GEOMETRIC_CONTINUITY_ASK_FIT)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(fit_spline, CGAL_GEOMETRIC_CONTINUITY_ASK_FIT)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(fit_polyline, CGAL_GEOMETRIC_CONTINUITY_ASK_FIT)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(fit_bspline, CGAL_GEOMETRIC_CONTINUITY_ASK_FIT)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(approximate_curve, CGAL_GEOMETRIC_CONTINUITY_ASK_FIT)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(least_squares, CGAL_GEOMETRIC_CONTINUITY_ASK_FIT)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(approximate, CGAL_GEOMETRIC_CONTINUITY_ASK_FIT
                                      ", chord_polyline(c, tolerance, out) a polyline to a curve")
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_FIT
#define CGAL_GEOMETRIC_CONTINUITY_ASK_POINTS                                                                           \
  "interpolate_fair(points) leads a fair curve through points, interpolate(points) a C2 spline"
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(interpolate_points, CGAL_GEOMETRIC_CONTINUITY_ASK_POINTS)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(interpolate_curve, CGAL_GEOMETRIC_CONTINUITY_ASK_POINTS)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(fair_interpolation, CGAL_GEOMETRIC_CONTINUITY_ASK_POINTS)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(fair_interpolate, CGAL_GEOMETRIC_CONTINUITY_ASK_POINTS)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(fair_curve, CGAL_GEOMETRIC_CONTINUITY_ASK_POINTS)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(fair_spline, CGAL_GEOMETRIC_CONTINUITY_ASK_POINTS)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(interpolate_spline, CGAL_GEOMETRIC_CONTINUITY_ASK_POINTS)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(interpolate_cubic, CGAL_GEOMETRIC_CONTINUITY_ASK_POINTS)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(cubic_spline, CGAL_GEOMETRIC_CONTINUITY_ASK_POINTS)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(catmull_rom, CGAL_GEOMETRIC_CONTINUITY_ASK_POINTS)
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_POINTS
#define CGAL_GEOMETRIC_CONTINUITY_ASK_ANGLE                                                                            \
  "kink_size(a, b)->angle encloses the angle of a kink in the plane, deviation(a, b).tangent_angle in any "            \
  "dimension, in radians; in_degrees() converts them"
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(kink_angle, CGAL_GEOMETRIC_CONTINUITY_ASK_ANGLE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(kink_angle_in_degrees, CGAL_GEOMETRIC_CONTINUITY_ASK_ANGLE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(join_angle, CGAL_GEOMETRIC_CONTINUITY_ASK_ANGLE)
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_ANGLE
template <class Curve, class Number, class = typename Curve::Traits> auto frenet_frame(const Curve&, const Number&) {
  static_assert(internal::never<Curve>, CGAL_GEOMETRIC_CONTINUITY_ASK_FRAME);
  return internal::No_result();
}
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(sample_curve, CGAL_GEOMETRIC_CONTINUITY_ASK_POLYLINE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(approximate_by_polyline, CGAL_GEOMETRIC_CONTINUITY_ASK_POLYLINE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(sample_points, CGAL_GEOMETRIC_CONTINUITY_ASK_POLYLINE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(sample_uniformly, CGAL_GEOMETRIC_CONTINUITY_ASK_POLYLINE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(flatten, CGAL_GEOMETRIC_CONTINUITY_ASK_POLYLINE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(inflections, "curvature_extrema(c).inflections are those of a curve")
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(inflection_points, "curvature_extrema(c).inflections are those of a curve")
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(surface_normal, "s.normal(u, v) is the normal of a surface, s.unit_normal(u, v) "
                                                      "the one of length 1")
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(extend_curve, "extend(c, Frenet_order::curvature, {beta}) is the next segment "
                                                    "of a curve, whose speed is beta times that of the last one")
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(make_clothoid,
                                      "Clothoid_segment(x, y, heading, k0, k1, length) is a clothoid between "
                                      "two curvatures")
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(max_deviation,
                                      "deviation(a, b) measures a join, edge_deviation(a, Patch_edge::v1, "
                                      "b, Patch_edge::v0) an edge")
#define CGAL_GEOMETRIC_CONTINUITY_ASK_DISTANCE                                                                         \
  "deviation(a, b) measures the join of two curves, order_within(a, b, tolerance) decides it; the distance of whole "  \
  "curves is not measured, fit(points, tolerance).distance is that from points"
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(is_within, CGAL_GEOMETRIC_CONTINUITY_ASK_DISTANCE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(distance, CGAL_GEOMETRIC_CONTINUITY_ASK_DISTANCE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(hausdorff_distance, CGAL_GEOMETRIC_CONTINUITY_ASK_DISTANCE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(max_distance, CGAL_GEOMETRIC_CONTINUITY_ASK_DISTANCE)
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_DISTANCE
template <class Start, class End, class... Given> auto clothoid_blend(const Start&, const End&, const Given&...) {
  static_assert(internal::never<Start>,
                "clothoid_blend({{x, y}, Heading(angle)}, {{x, y}, Heading(angle)}) takes two ends, "
                "whose curvature is a third member, 0 if it is left out");
  return internal::No_result();
}
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(maximum_curvature, CGAL_GEOMETRIC_CONTINUITY_ASK_CURVATURE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(minimum_radius, CGAL_GEOMETRIC_CONTINUITY_ASK_CURVATURE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(squared_curvature, CGAL_GEOMETRIC_CONTINUITY_ASK_CURVATURE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(curvature_bound, CGAL_GEOMETRIC_CONTINUITY_ASK_CURVATURE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(bound_curvature, CGAL_GEOMETRIC_CONTINUITY_ASK_CURVATURE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(is_curvature_bounded, CGAL_GEOMETRIC_CONTINUITY_ASK_CURVATURE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(is_curvature_bounded_by, CGAL_GEOMETRIC_CONTINUITY_ASK_CURVATURE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(curvature_bounded_by, CGAL_GEOMETRIC_CONTINUITY_ASK_CURVATURE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(min_radius, CGAL_GEOMETRIC_CONTINUITY_ASK_CURVATURE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(min_curvature, CGAL_GEOMETRIC_CONTINUITY_ASK_CURVATURE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(minimum_curvature, CGAL_GEOMETRIC_CONTINUITY_ASK_CURVATURE)
#define CGAL_GEOMETRIC_CONTINUITY_ASK_READ                                                                             \
  "read_g2_curves<Traits>(in) of <CGAL/Geometric_continuity/IO/g2.h> returns Bezier curves, "                          \
  "read_g2_bsplines<Traits>(in) B-spline curves, read_g2_surfaces<Traits>(in) patches; in is an open std::ifstream"
#define CGAL_GEOMETRIC_CONTINUITY_ASK_WRITE                                                                            \
  "write_g2(os, curve) of <CGAL/Geometric_continuity/IO/g2.h> takes an open std::ofstream, and a curve, a surface or " \
  "a range of them"
#define CGAL_GEOMETRIC_CONTINUITY_ASK_PICTURE                                                                          \
  "std::ofstream(file) << Svg_figure().add(Svg_panel().add(curve)) of <Geometric_continuity_figures/Svg_figure.h> in " \
  "the folder figures/include is a picture; write_g2(os, curve) of <CGAL/Geometric_continuity/IO/g2.h> writes what "   \
  "the program plots"
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(read_g2, CGAL_GEOMETRIC_CONTINUITY_ASK_READ)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(read_G2, CGAL_GEOMETRIC_CONTINUITY_ASK_READ)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(read_g2_curve, CGAL_GEOMETRIC_CONTINUITY_ASK_READ)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(read_curve, CGAL_GEOMETRIC_CONTINUITY_ASK_READ)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(read_curves, CGAL_GEOMETRIC_CONTINUITY_ASK_READ)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(load_g2, CGAL_GEOMETRIC_CONTINUITY_ASK_READ)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(write_G2, CGAL_GEOMETRIC_CONTINUITY_ASK_WRITE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(write_curve, CGAL_GEOMETRIC_CONTINUITY_ASK_WRITE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(write_curves, CGAL_GEOMETRIC_CONTINUITY_ASK_WRITE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(save_g2, CGAL_GEOMETRIC_CONTINUITY_ASK_WRITE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(write_svg, CGAL_GEOMETRIC_CONTINUITY_ASK_PICTURE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(write_SVG, CGAL_GEOMETRIC_CONTINUITY_ASK_PICTURE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(save_svg, CGAL_GEOMETRIC_CONTINUITY_ASK_PICTURE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(plot, CGAL_GEOMETRIC_CONTINUITY_ASK_PICTURE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(draw, CGAL_GEOMETRIC_CONTINUITY_ASK_PICTURE)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(curvature_comb, CGAL_GEOMETRIC_CONTINUITY_ASK_PICTURE)
// ... the name of a file, or no traits class, where a function reads,
#define CGAL_GEOMETRIC_CONTINUITY_NO_READER(name)                                                                      \
  template <class Traits> auto name(const std::string&) {                                                              \
    static_assert(internal::never<Traits>, CGAL_GEOMETRIC_CONTINUITY_ASK_READ);                                        \
    return internal::No_result();                                                                                      \
  }                                                                                                                    \
  template <class Stream> auto name(const Stream&) {                                                                   \
    static_assert(internal::never<Stream>, CGAL_GEOMETRIC_CONTINUITY_ASK_READ);                                        \
    return internal::No_result();                                                                                      \
  }
CGAL_GEOMETRIC_CONTINUITY_NO_READER(read_g2_curves)
CGAL_GEOMETRIC_CONTINUITY_NO_READER(read_g2_bsplines)
CGAL_GEOMETRIC_CONTINUITY_NO_READER(read_g2_surfaces)
#undef CGAL_GEOMETRIC_CONTINUITY_NO_READER
// ... or the name of a file, or the curve first, where one writes.
template <class Object> auto write_g2(const std::string&, const Object&) {
  static_assert(internal::never<Object>, CGAL_GEOMETRIC_CONTINUITY_ASK_WRITE);
  return internal::No_result();
}
template <class Object, class File, class = typename Object::Traits> auto write_g2(const Object&, const File&) {
  static_assert(internal::never<Object>, CGAL_GEOMETRIC_CONTINUITY_ASK_WRITE);
  return internal::No_result();
}
template <class Object, class File> auto write_g2(const std::vector<Object>&, const File&) {
  static_assert(internal::never<Object>, CGAL_GEOMETRIC_CONTINUITY_ASK_WRITE);
  return internal::No_result();
}
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_PICTURE
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_WRITE
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_READ
#define CGAL_GEOMETRIC_CONTINUITY_ASK_DRAWING                                                                          \
  "the program reads drawings, fonts and CAD models: geometric_continuity verify FILE; read_g2_curves<Traits>(in) of " \
  "<CGAL/Geometric_continuity/IO/g2.h> reads .g2 from an open std::ifstream"
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(read_svg, CGAL_GEOMETRIC_CONTINUITY_ASK_DRAWING)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(read_SVG, CGAL_GEOMETRIC_CONTINUITY_ASK_DRAWING)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(read_drawing, CGAL_GEOMETRIC_CONTINUITY_ASK_DRAWING)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(read_font, CGAL_GEOMETRIC_CONTINUITY_ASK_DRAWING)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(read_step, CGAL_GEOMETRIC_CONTINUITY_ASK_DRAWING)
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_DRAWING
#define CGAL_GEOMETRIC_CONTINUITY_ASK_MODEL                                                                            \
  "model_continuity(patches) decides all common edges in a range of surfaces: .edges has their orders, .failing(2) "   \
  "those that are not G2"
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(check_mesh, CGAL_GEOMETRIC_CONTINUITY_ASK_MODEL)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(check_model, CGAL_GEOMETRIC_CONTINUITY_ASK_MODEL)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(mesh_continuity, CGAL_GEOMETRIC_CONTINUITY_ASK_MODEL)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(verify_mesh, CGAL_GEOMETRIC_CONTINUITY_ASK_MODEL)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(verify_model, CGAL_GEOMETRIC_CONTINUITY_ASK_MODEL)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(edge_continuities, CGAL_GEOMETRIC_CONTINUITY_ASK_MODEL)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(find_edges, CGAL_GEOMETRIC_CONTINUITY_ASK_MODEL)
CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION(failing_edges, CGAL_GEOMETRIC_CONTINUITY_ASK_MODEL)

// A class that does not exist, with the sentence that is the first error of the compiler where an
// object of it is made.
#define CGAL_GEOMETRIC_CONTINUITY_NO_CLASS(name, sentence)                                                             \
  namespace other_names {                                                                                              \
  template <class... Given> struct name {                                                                              \
    static_assert(internal::never<Given...>, sentence);                                                                \
    template <class... Arguments> name(const Arguments&...);                                                           \
  };                                                                                                                   \
  }
CGAL_GEOMETRIC_CONTINUITY_NO_CLASS(Patch_mesh, CGAL_GEOMETRIC_CONTINUITY_ASK_MODEL)
CGAL_GEOMETRIC_CONTINUITY_NO_CLASS(Patch_complex, CGAL_GEOMETRIC_CONTINUITY_ASK_MODEL)
CGAL_GEOMETRIC_CONTINUITY_NO_CLASS(Bezier_patch_mesh, CGAL_GEOMETRIC_CONTINUITY_ASK_MODEL)
#undef CGAL_GEOMETRIC_CONTINUITY_ASK_MODEL
#undef CGAL_GEOMETRIC_CONTINUITY_NO_CLASS
#undef CGAL_GEOMETRIC_CONTINUITY_NO_FUNCTION
using namespace other_names;

} // namespace Geometric_continuity

// Other packages have functions for files here.
namespace IO {
using Geometric_continuity::read_g2;
using Geometric_continuity::read_G2;
using Geometric_continuity::write_g2;
using Geometric_continuity::write_G2;
} // namespace IO

/// \endcond

} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_OTHER_NAMES_H
