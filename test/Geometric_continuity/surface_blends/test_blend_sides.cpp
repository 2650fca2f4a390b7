// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Blends with given sides. Sides that fit are those of other blends of the same surfaces; that the
// results are G2 is decided by edge_continuity().

#include "support/random_surfaces.h"
#include "support/rational_surfaces.h"

#include <CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>

BOOST_AUTO_TEST_SUITE(blend_sides)

typedef GC::Edge_function<Q> Function;
typedef GC::Surface_blend_shape<Q> Shape;
template <class Shape> using Septic = GC::Septic_surface_blend_shape<Shape>;
template <class Shape> struct Order { static constexpr int value = 2; };
template <class Shape> struct Order<Septic<Shape>> { static constexpr int value = 3; };

struct Numbers : Random_surfaces {
  Function function(const Q& size, int least) {
    std::vector<Q> b;
    for (int i = 0; i <= 4; ++i) b.push_back(size * fraction(integer(least, 99), 99));
    return GC::Bernstein_polynomial<Q>(b);
  }
  template <class Shape> Shape shape() {
    Shape shape;
    constexpr bool rational = std::is_base_of_v<GC::Rational_edge_reparametrisation<Q>, decltype(Shape::start)>;
    const Q size = rational ? fraction(1, 1000) : Q(1); // so that the denominator stays positive
    for (auto* end : {&shape.start, &shape.end}) {
      for (Function* f : {&end->alpha, &end->alpha2, &end->delta}) *f = function(size, -99);
      end->beta = function(size, 50);
      if constexpr (rational) {
        end->lambda1 = function(size, -99);
        end->lambda2 = function(size, -99);
      }
      if constexpr (Order<Shape>::value == 3)
        for (Function* f : {&end->alpha3, &end->delta3, &end->lambda3}) *f = function(size, -99);
    }
    if constexpr (rational) shape.end.lambda = fraction(3, 2);
    return shape;
  }
};

// Returns the side beyond the blend: the same curve, and the derivative out of the blend.
template <class Side, class Surface> Side beyond(const Surface& blend, Patch_edge edge) {
  Side side(blend, edge);
  for (auto& x : side.cross) x = -1 * x;
  return side;
}

template <class Vector> void move(Vector& x) { x[2] += Q(1) / Q(1 << 30); }

// The order along a whole edge, up to that of the blend.
template <int order, class A, class B> int contact(const A& a, Patch_edge ea, const B& b, Patch_edge eb) {
  const int g = whole_edge_order(a, ea, b, eb);
  return order == 3 && g == 2 && is_g3_edge(a, ea, b, eb) ? 3 : g;
}

template <class Given, class A, class B> void check_sides(Numbers& random, const A& a, const B& b) {
  typedef GC::Side_of_blend<A, B> Side;
  constexpr int order = Order<Given>::value, last = 2 * order + 1;
  const Patch_edge ea = random.edge(), eb = random.edge();
  const Edge_direction direction = random.direction();
  const auto shape = [&](const std::optional<Side>& at_start, const std::optional<Side>& at_end) {
    return surface_shape_with_sides(a, ea, b, eb, direction, Given(Shape()), at_start, at_end);
  };
  const auto other = blend(a, ea, b, eb, random.shape<Given>(), direction);
  const Side start = beyond<Side>(other, u0), end = beyond<Side>(other, u1);
  const auto s = blend(a, ea, b, eb, shape(start, end), direction);
  BOOST_CHECK(s != other);
  BOOST_CHECK_EQUAL(contact<order>(a, ea, s, v0), order);
  BOOST_CHECK_EQUAL(contact<order>(s, v1, b, eb), order);
  for (Patch_edge edge : {u0, u1}) {
    const Side is = beyond<Side>(s, edge), &is_asked = edge == u0 ? start : end;
    BOOST_CHECK(is.curve == is_asked.curve);
    BOOST_CHECK(is.cross == is_asked.cross);
  }
  // the curves only; and one
  const auto curves = blend(a, ea, b, eb, shape(start.curve_only(), end.curve_only()), direction);
  BOOST_CHECK(Side(curves, u0).curve == start.curve && Side(curves, u1).curve == end.curve);
  BOOST_CHECK_EQUAL(contact<order>(a, ea, curves, v0), order);
  BOOST_CHECK_EQUAL(contact<order>(curves, v1, b, eb), order);
  BOOST_CHECK(Side(blend(a, ea, b, eb, shape(std::nullopt, end), direction), u1).curve == end.curve);
  BOOST_CHECK(blend(a, ea, b, eb, shape(std::nullopt, std::nullopt), direction) ==
              blend(a, ea, b, eb, Given(Shape()), direction));
  // what does not fit is refused, by name
  const auto refused = [&](bool upper, bool of_curve, int i, const std::string& what) {
    Side x = upper ? end : start;
    auto& rows = of_curve ? x.curve : x.cross;
    move(rows[upper ? last - i : i]);
    const std::string error = error_of([&] { upper ? shape(start, x) : shape(x, end); }),
                      place = upper ? "u = 1, the edge " + to_string(eb) + " of the second surface: "
                                    : "u = 0, the edge " + to_string(ea) + " of the first surface: ",
                      text = std::string(of_curve && i == 0 ? "curves_do_not_meet" : "incompatible_corner") +
                             ": blend sides: " + place + what;
    BOOST_CHECK_MESSAGE(error.find(text) == 0, error + " is not " + text);
  };
  if constexpr (std::is_base_of_v<GC::Rational_edge_reparametrisation<Q>, decltype(Given().start)>) {
    // the same curve at another pace: it fits alone, but not after the other one
    Side x = end;
    Q power(1);
    for (int i = 0; i <= last; ++i, power *= Q(2)) {
      x.curve[i] *= power;
      x.cross[i] *= power;
    }
    shape(std::nullopt, x);
    const std::string error = error_of([&] { shape(start, x); });
    BOOST_CHECK_MESSAGE(error.find("belong to another factor") != std::string::npos, error);
  }
  const std::string derivatives[] = {"", "v", "vv", "vvv"};
  for (const bool upper : {false, true}) {
    refused(upper, true, 0, "the side curve does not end at the corner");
    for (int i = 1; i <= order; ++i) refused(upper, true, i, "S_" + derivatives[i] + ": ");
    for (int i = 0; i <= order; ++i) refused(upper, false, i, "S_u" + derivatives[i] + ": ");
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(all_types, A, Surface_types) {
  Numbers random;
  for_each_surface_type([&](auto b) {
    typedef typename decltype(b)::type B;
    const A a = random.surface<A>();
    check_sides<GC::Blend_surface_shape<A, B>>(random, a, random.surface<B>());
  });
}

// Also lambda_3 of polynomial surfaces is random: it means nothing.
BOOST_AUTO_TEST_CASE(of_degree_7) {
  Numbers random;
  const auto check = [&](const auto& a, const auto& b) {
    typedef GC::Blend_surface_shape<std::decay_t<decltype(a)>, std::decay_t<decltype(b)>> Of_degree_5;
    check_sides<Septic<Of_degree_5>>(random, a, b);
  };
  for (int i = 0; i < 3; ++i) {
    check(random.surface<Bezier<Exact>>(), random.surface<Bezier<Exact>>());
    check(random.surface<Patch<Exact>>(), random.surface<Bezier<Exact>>());
    check(random.surface<Patch<Exact>>(), random.surface<Patch<Exact>>());
  }
  // over knots across which third derivatives, and those along the edge, do not jump
  const Knots u(5, Q(-1), Q(2), {{fraction(1, 3), 1}}), v(5, Q(0), Q(1), {{fraction(2, 7), 1}, {fraction(1, 2), 1}});
  const Bspline<Exact> spline(random.net(7, 8), u, v);
  check(spline, random.surface<Bezier<Exact>>());
  check(Spline<Exact>(random.net(7, 8), random.weights(7, 8), u, v), spline);
}

// The blends of both parts of two surfaces meet: along a curve, and with a common tangent plane
// where the parts go on smoothly.
BOOST_AUTO_TEST_CASE(consecutive_edges) {
  typedef Bspline<Exact> S;
  typedef GC::Side_of_blend<S, S> Side;
  Numbers random;
  const S a = random.surface<S>(), b = random.surface<S>().swap_parameters().swap_parameters();
  const auto cut = [](const S& s) {
    const auto d = s.domain_u();
    return s.split_u(Q(d.first + fraction(3, 7) * (d.second - d.first)));
  };
  const auto parts_a = cut(a), parts_b = cut(b);
  const S s = blend(parts_a.first, v1, parts_b.first, v0);
  const Shape own =
      automatic_surface_shape(parts_a.second, v1, parts_b.second, v0, GC::Minimal_energy<2>(), Edge_direction::same);
  const auto next = [&](const Side& side) {
    return blend(parts_a.second, v1, parts_b.second, v0,
                 surface_shape_with_sides(parts_a.second, v1, parts_b.second, v0, Edge_direction::same, own,
                                          std::optional<Side>(side), std::optional<Side>()));
  };
  const Side side(s, u1);
  BOOST_CHECK(Side(blend(parts_a.second, v1, parts_b.second, v0, own), u0).curve != side.curve);
  const S along = next(side.curve_only()), smooth = next(side);
  BOOST_CHECK_EQUAL(whole_edge_order(s, u1, along, u0), 0);
  BOOST_CHECK(whole_edge_order(s, u1, smooth, u0) >= 1);
  for (const S* x : {&along, &smooth}) {
    BOOST_CHECK_EQUAL(whole_edge_order(parts_a.second, v1, *x, v0), 2);
    BOOST_CHECK_EQUAL(whole_edge_order(*x, v1, parts_b.second, v0), 2);
  }
}

// Along edges of patches that join with G2: those beyond are blends, too.
BOOST_AUTO_TEST_CASE(patches_that_join) {
  typedef Bezier<Exact> S;
  typedef GC::Side_of_blend<S, S> Side;
  Numbers random;
  const S a(random.net(3, 4)), b(random.net(4, 3)), c(random.net(3, 3)), d(random.net(3, 4));
  const S a2 = blend(a, u1, c, u0, random.shape<Shape>()), b2 = blend(b, u1, d, u0, random.shape<Shape>());
  const S s = blend(a, v1, b, v0);
  // the edges of a2 and b2 go on from those of a and b
  const S t = blend(a2, u1, b2, u0,
                    surface_shape_with_sides(a2, u1, b2, u0, Edge_direction::same, Shape(),
                                             std::optional<Side>(Side(s, u1).curve_only()), std::optional<Side>()));
  BOOST_CHECK(Side(t, u0).curve == Side(s, u1).curve);
  BOOST_CHECK_EQUAL(whole_edge_order(a2, u1, t, v0), 2);
  BOOST_CHECK_EQUAL(whole_edge_order(t, v1, b2, u0), 2);
}

// A neighbour of its own speed: the blend is G1 with it.
TEST_FOR_EACH(neighbours, Traits, All_traits) {
  typedef typename Traits::Point P;
  typedef Bezier<Traits> S;
  typedef GC::Side_of_blend<S, S> Side;
  // parts of one plane, and the neighbour is bent beyond its first row
  const S a({{P(0, 0, 0), P(0, 4, 0)}, {P(8, 0, 0), P(8, 4, 0)}}),
      b({{P(0, 12, 0), P(0, 16, 0)}, {P(8, 12, 0), P(8, 16, 0)}}),
      neighbour({{P(-8, 4, 4), P(-8, 12, 4)}, {P(-4, 4, 0), P(-2, 12, 0)}, {P(0, 4, 0), P(0, 12, 0)}});
  const Side side(neighbour, u1);
  const auto shape = [&](const Side& at_start, const auto& of, const S& first) {
    return surface_shape_with_sides(first, v1, b, v0, Edge_direction::same, of, std::optional<Side>(at_start),
                                    std::optional<Side>());
  };
  const GC::Surface_blend_shape<FT> plain{};
  const S s = blend(a, v1, b, v0, shape(side, plain, a));
  BOOST_CHECK(Side(s, u0).curve == Side(neighbour.elevate(0, 4), u1).curve);
  if constexpr (!std::is_floating_point_v<FT>) {
    BOOST_CHECK_EQUAL(whole_edge_order(s, u0, neighbour, u1), 1);
    BOOST_CHECK_EQUAL(whole_edge_order(a, v1, s, v0), 2);
  }
  const auto text = [&](const Side& x) { return error_of([&] { shape(x, plain, a); }); };
  BOOST_CHECK_EQUAL(text(Side(neighbour, u1, Edge_direction::opposite)),
                    "curves_do_not_meet: blend sides: u = 0, the edge v1 of the first surface: the side curve does not "
                    "end at the corner");
  Side wrong = side;
  for (auto& x : wrong.cross) x = FT(-1) * x;
  BOOST_CHECK_EQUAL(text(wrong), "incompatible_corner: blend sides: u = 0, the edge v1 of the first surface: S_u: what "
                                 "is given along the side does not lead along the edge");
  const auto curve = [](const std::vector<P>& points) {
    return Side(GC::Bezier_curve<Traits>(points.begin(), points.end())).curve_only();
  };
  BOOST_CHECK_EQUAL(text(curve({P(0, 4, 0), P(0, 3, 0), P(0, 12, 0)})),
                    "nonpositive_beta: blend sides: u = 0, the edge v1 of the first surface: S_v: the side curve does "
                    "not cross the edge");
  Side empty = side.curve_only();
  empty.curve.clear();
  BOOST_CHECK_EQUAL(text(empty),
                    "wrong_number_of_points: blend sides: u = 0, the curve: the degree must be at most 5, it is -1");
  BOOST_CHECK_EQUAL(text(curve({7, P(0, 4, 0)})),
                    "wrong_number_of_points: blend sides: u = 0, the curve: the degree must be at most 5, it is 6");
  typedef Septic<GC::Surface_blend_shape<FT>> Order_3;
  const S s7 = blend(a, v1, b, v0, shape(side, Order_3(), a));
  BOOST_CHECK(Side(s7, u0).curve == Side(neighbour.elevate(0, 6), u1).curve);
  if constexpr (!std::is_floating_point_v<FT>) {
    BOOST_CHECK_EQUAL(whole_edge_order(s7, u0, neighbour, u1), 1);
    BOOST_CHECK(is_g3_edge(a, v1, s7, v0) && is_g3_edge(s7, v1, b, v0));
  }
  BOOST_CHECK_EQUAL(error_of([&] {
                      shape(curve({9, P(0, 4, 0)}), Order_3(), a);
                    }),
                    "wrong_number_of_points: blend sides: u = 0, the curve: the degree must be at most 7, it is 8");
  const S pole({{P(0, 0, 0), P(0, 4, 0)}, {P(8, 0, 0), P(0, 4, 0)}});
  // the edge leads in the direction across it, from the corner
  const S folded({{P(0, 0, 0), P(0, 4, 0)}, {P(8, 0, 0), P(0, 8, 0)}});
  for (const S& singular : {pole, folded}) CHECK_ERROR(shape(side.curve_only(), plain, singular), singular_frame);
  GC::Surface_blend_shape<FT> vanishing;
  vanishing.start.beta = {FT(0)};
  BOOST_CHECK_EQUAL(error_of([&] { shape(side, vanishing, a); }),
                    "nonpositive_beta: blend sides: u = 1, where no side is given: the shape");
  const GC::Knot_vector<FT> knots(1, FT(0), FT(1), {{FT(1) / FT(2), 1}});
  const Bspline<Traits> bent({{P(0, 4, 0), P(0, 5, 1), P(0, 12, 0)}, {P(8, 4, 0), P(8, 5, 1), P(8, 12, 0)}},
                             GC::Knot_vector<FT>(1, FT(0), FT(1)), knots);
  BOOST_CHECK_EQUAL(error_of([&] { Side(bent, u0); }), "knot_multiplicity: Blend_side: the edge u0 has inner knots");
}

// A beta that must fall steeply and stay positive.
BOOST_AUTO_TEST_CASE(steep_functions) {
  typedef Bspline<Exact> S;
  typedef GC::Side_of_blend<S, S> Side;
  Numbers random;
  const Bezier<Exact> a(random.net(3, 3)), c(random.net(3, 3));
  Shape steep;
  steep.start.beta = Function{Q(1), fraction(1, 100), Q(9), Q(1)};
  const auto shape_between = [&](const Side& x, const Side& y) {
    return surface_shape_with_sides(S(a), v1, S(c), v0, Edge_direction::same, Shape(), std::optional<Side>(x),
                                    std::optional<Side>(y));
  };
  const S other = S(blend(a, v1, c, v0, steep));
  Side side = beyond<Side>(other, u0), end = beyond<Side>(other, u1);
  BOOST_CHECK(shape_between(side, end).start.beta.is_positive());
  Shape steeper;
  steeper.start.beta = Function{Q(2), fraction(1, 100), Q(1), fraction(1, 100), Q(9), fraction(1, 100), Q(2)};
  const S third = S(blend(a, v1, c, v0, steeper));
  side = beyond<Side>(third, u0), end = beyond<Side>(third, u1);
  const Shape spline = shape_between(side, end);
  BOOST_CHECK(!spline.start.beta.knots().inner_knots().empty());
  BOOST_CHECK(spline.start.beta.is_positive());
  const S s = blend(S(a), v1, S(c), v0, spline);
  BOOST_CHECK(beyond<Side>(s, u0).cross == side.cross && beyond<Side>(s, u1).cross == end.cross);
  BOOST_CHECK_EQUAL(whole_edge_order(a, v1, s, v0), 2);
  // also where only one slope is given; and the steeper they are the shorter are the spans at the
  // ends
  for (const bool at_start : {true, false}) {
    std::vector<Q> b(21, fraction(1, 100));
    b[at_start ? 0 : 20] = Q(1);
    Shape steepest;
    steepest.start.beta = GC::Bernstein_polynomial<Q>(b);
    const S fourth = S(blend(a, v1, c, v0, steepest));
    side = beyond<Side>(fourth, u0), end = beyond<Side>(fourth, u1);
    for (const auto& [x, y] :
         {std::make_pair(side, end), std::make_pair(side, end.curve_only()), std::make_pair(side.curve_only(), end)}) {
      const Shape found = shape_between(x, y);
      BOOST_CHECK(found.start.beta.is_positive());
      const S t = blend(S(a), v1, S(c), v0, found);
      BOOST_CHECK(beyond<Side>(t, u0).curve == side.curve && beyond<Side>(t, u1).curve == end.curve);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
