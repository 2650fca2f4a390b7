// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Surfaces of all types and mixes are matched to others. That they are G1, G2 or G3 along whole
// edges is decided by edge_continuity(), which knows nothing of how they are made.

#include "support/errors.h"
#include "support/random_surfaces.h"

#include <CGAL/Geometric_continuity/surface_blends/match.h>

BOOST_AUTO_TEST_SUITE(match_surfaces)

typedef GC::Matching_shape<Q> Shape;

Patch_edge opposite(Patch_edge edge) { return edge == u0 ? u1 : edge == u1 ? u0 : edge == v0 ? v1 : v0; }

template <class S> constexpr bool is_spline = std::is_same_v<S, Bspline<Exact>> || std::is_same_v<S, Spline<Exact>>;
template <class S> constexpr bool is_rational = std::is_same_v<S, Patch<Exact>> || std::is_same_v<S, Spline<Exact>>;

// A surface as one of another type.
template <class Result, class S> Result converted(const S& s) {
  if constexpr (is_spline<Result> && !is_spline<S>)
    return converted<Result>(std::conditional_t<is_rational<S>, Spline<Exact>, Bspline<Exact>>(s));
  else
    return Result(s);
}

// The order of the match, and what stays at the opposite edge.
template <class A, class B, class S>
void check_match(const A& a, Patch_edge ea, const B& b, Patch_edge eb, const S& s, int order) {
  BOOST_CHECK_EQUAL(whole_edge_order(a, ea, s, eb), (std::min)(order, 2));
  BOOST_CHECK_EQUAL(GC::is_g3_edge(a, ea, s, eb), order == 3);
  const auto at_end = [&](const auto& surface) { return surface.template rows<Q>(opposite(eb), order); };
  typedef std::conditional_t<is_spline<S>, Bspline<Exact>, Bezier<Exact>> Polynomial;
  typedef std::conditional_t<is_rational<S>, GC::Rational_surface<Polynomial>, Polynomial> As_result;
  const auto before = at_end(converted<As_result>(b)), after = at_end(s);
  // along the edge degrees may be raised, and knots united: the derivatives are compared at an end
  for (int k = 0; k <= order; ++k) {
    BOOST_CHECK(before[k].front() == after[k].front());
    BOOST_CHECK(before[k].back() == after[k].back());
  }
}

template <class A, class B> void check_random_match(Random_surfaces& random) {
  const A a = random.surface<A>();
  const B b = random.surface<B>();
  const Patch_edge ea = random.edge(), eb = random.edge();
  const int order = random.integer(1, 3);
  check_match(a, ea, b, eb, GC::match(a, ea, b, eb, order), order);
  // the numbers are small, so that the weights stay positive, and nothing leans where knots are
  const auto number = [&] { return is_spline<A> ? Q(0) : fraction(random.integer(-99, 99), 100000); };
  const Shape shape{number(), fraction(random.integer(1, 99), 5000), number(), number(), number(), number()};
  check_match(a, ea, b, eb, GC::match(a, ea, b, eb, order, shape, random.direction()), order);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(all_types, A, Surface_types) {
  Random_surfaces random;
  for_each_surface_type([&](auto b) {
    for (int i = 0; i < 4; ++i) check_random_match<A, typename decltype(b)::type>(random);
  });
}

// A surface that continues the other one already stays, with its numbers.
template <class Surface> void check_continued(const Surface& s) {
  const auto parts = s.split_v(Q(s.domain_v().first + fraction(2, 5) * (s.domain_v().second - s.domain_v().first)));
  for (int order = 1; order <= 3; ++order) {
    const Shape shape = nearest_matching_shape(parts.first, v1, parts.second, v0, order, Edge_direction::same);
    BOOST_CHECK(shape.alpha == 0 && shape.beta == 1 && shape.alpha2 == 0 && shape.delta == 0);
    const int raised = (std::max)(0, 2 * order + 1 - s.degree_v());
    BOOST_CHECK(GC::match(parts.first, v1, parts.second, v0, order) == parts.second.elevate(0, raised));
    BOOST_CHECK(GC::match(parts.first.reverse_u(), v1, parts.second, v0, order) == parts.second.elevate(0, raised));
  }
}
BOOST_AUTO_TEST_CASE(a_part_of_one_surface) {
  Random_surfaces random;
  check_continued(random.surface<Bezier<Exact>>());
  check_continued(random.surface<Bspline<Exact>>());
  check_continued(random.surface<Patch<Exact>>());
}

// Without names the edges are those that two parts of one surface have in common, whatever their
// directions, also where they are a little apart; two pairs that are equally near are refused.
BOOST_AUTO_TEST_CASE(nearest_edges) {
  typedef Bezier<Exact> S;
  typedef Exact::Point Point;
  const S a({{Point(0, 0, 0), Point(0, 3, 0)}, {Point(4, 0, 1), Point(4, 3, 1)}}),
      b({{Point(0, 3, 0), Point(0, 6, 2)}, {Point(4, 3, 1), Point(4, 6, 1)}});
  BOOST_CHECK(GC::nearest_edges(a, b) == std::pair(v1, v0));
  BOOST_CHECK(GC::nearest_edges(b, a) == std::pair(v0, v1));
  BOOST_CHECK(GC::nearest_edges(a, b.reverse_v()) == std::pair(v1, v1));
  BOOST_CHECK(GC::nearest_edges(a, b.reverse_u().swap_parameters()) == std::pair(v1, u0));
  const S aside({{Point(0, 4, 0), Point(0, 6, 2)}, {Point(4, 3, 2), Point(4, 6, 1)}});
  BOOST_CHECK(GC::nearest_edges(a, aside) == std::pair(v1, v0));
  check_match(a, v1, aside, v0, GC::match(a, aside), 2);
  const auto square = [](int z) { return S({{Point(0, 0, z), Point(0, 3, z)}, {Point(4, 0, z), Point(4, 3, z)}}); };
  CHECK_ERROR(GC::nearest_edges(square(0), square(9)), several_common_edges);
  CHECK_ERROR(GC::match(square(0), square(9)), several_common_edges);
}

BOOST_AUTO_TEST_CASE(what_is_refused) {
  const Bezier<Exact> square{{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 0}}},
      pole{{{0, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {1, 1, 0}}}, flat{{{0, 1, 0}, {0, 1, 0}}, {{1, 1, 0}, {1, 1, 0}}};
  CHECK_ERROR(GC::match(pole, v0, square, v0), zero_tangent);
  CHECK_ERROR(GC::match(flat, v1, square, v0), zero_tangent);
  for (int order : {0, 4}) CHECK_ERROR(GC::match(square, v1, square, v0, order), negative_count);
  // a cubic spline has no continuous third derivative
  Random_surfaces random;
  const Knots u(3, Q(0), Q(1), {{fraction(1, 2), 1}}), v(2, Q(0), Q(1));
  const Bspline<Exact> a(random.net(5, 3), u, v);
  CHECK_ERROR(GC::match(a, v1, square, v0, 3, {Q(1), Q(1)}, Edge_direction::same), knot_multiplicity);
  CHECK_ERROR(GC::match(square, v1, square, v0, 1, {Q(0), Q(0)}, Edge_direction::same), nonpositive_beta);
}

// On doubles the result is G1 and G2 but for rounding.
BOOST_AUTO_TEST_CASE(doubles) {
  typedef Bezier<Filtered> Surface;
  const Surface a{{{0, 0, 0}, {0, 1, 0.25}, {0, 2, 1}}, {{1, 0, 0}, {1, 1, 0.5}, {1, 2, 1.5}}},
      b{{{0, 2.125, 1}, {0, 3, 1}}, {{1, 2, 1.5}, {1, 3, 1}}};
  const Surface s = GC::match(a, v1, b, v0);
  BOOST_CHECK(s.control_point(0, 0) == a.control_point(0, 2) && s.control_point(1, 5) == b.control_point(1, 1));
  BOOST_CHECK_EQUAL(whole_edge_order(a, v1, s, v0) >= 0, true);
}

BOOST_AUTO_TEST_SUITE_END()
