// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Blends of surfaces of all types and mixes. That they are G2 along whole edges is decided by
// edge_continuity(), which knows nothing of how they are made.

#include "support/random_surfaces.h"
#include "support/rational_surfaces.h"
#include "support/translated_curves.h"

#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

BOOST_AUTO_TEST_SUITE(blend_surfaces)

typedef GC::Edge_function<Q> Function;
typedef GC::Edge_reparametrisation<Q> Reparametrisation;
typedef GC::Surface_blend_shape<Q> Shape;

typedef std::tuple<Double, Filtered> Rounded_traits;

struct Numbers : Random_surfaces {
  Function function(int degree, bool is_positive = false) {
    std::vector<Q> b;
    for (int i = 0; i <= degree; ++i)
      b.push_back(is_positive ? fraction_of<Q>(1, 99, 1, 99) : Q(rational() / Q(1000000)));
    return GC::Bernstein_polynomial<Q>(b);
  }
  // Twice continuously differentiable, on any domain.
  Function spline(int sign) {
    const Knots u = knots();
    std::vector<Q> c;
    for (int i = 0; i < u.number_of_coefficients(); ++i) c.push_back(fraction(integer(sign > 0 ? 1 : -99, 99), 1000));
    return GC::Bspline_function<Q>(u, c);
  }
  Reparametrisation spline_reparametrisation() { return {spline(0), spline(1), spline(0), spline(0)}; }
  Reparametrisation reparametrisation(int alpha, int beta, int alpha2, int delta) {
    return {function(alpha), function(beta, true), function(alpha2), function(delta)};
  }
  Reparametrisation reparametrisation() {
    const int a = integer(0, 2), b = integer(0, 2), c = integer(0, 2);
    return reparametrisation(a, b, c, integer(0, 2));
  }
};

// G2 at both edges, and not with a point moved.
template <class A, class B, class Surface>
void check_blend(const A& a, Patch_edge ea, const B& b, Patch_edge eb, const Surface& s, Edge_direction direction) {
  BOOST_CHECK_EQUAL(s.degree_v(), 5);
  BOOST_CHECK(s.domain_v() == std::make_pair(Q(0), Q(1)));
  BOOST_CHECK_EQUAL(whole_edge_order(a, ea, s, v0), 2);
  BOOST_CHECK_EQUAL(whole_edge_order(s, v1, b, eb), 2);
  BOOST_CHECK(!edge_continuity(a, ea, s, v0).reversed);
  BOOST_CHECK_EQUAL(edge_continuity(s, v1, b, eb).reversed, direction == Edge_direction::opposite);
  BOOST_CHECK_EQUAL(whole_edge_order(a, ea, moved(s, 1, 2), v0), 1);
  BOOST_CHECK_EQUAL(whole_edge_order(a, ea, moved(s, 1, 1), v0), 0);
  BOOST_CHECK_EQUAL(whole_edge_order(a, ea, moved(s, 1, 3), v0), 2);
  BOOST_CHECK_EQUAL(whole_edge_order(moved(s, 1, 3), v1, b, eb), 1);
  BOOST_CHECK_EQUAL(whole_edge_order(moved(s, 1, 4), v1, b, eb), 0);
}

template <class A, class B> void check_random_blend(Numbers& random, const A& a, const B& b, const Shape& given) {
  const Patch_edge ea = random.edge(), eb = random.edge();
  const Edge_direction direction = random.direction();
  GC::Blend_surface_shape<A, B> shape = given;
  if constexpr (std::is_same_v<decltype(shape), GC::Rational_surface_blend_shape<Q>>) {
    // the functions are small, so that the denominator stays positive
    const Function small{fraction(1, 1000)};
    for (auto* end : {&shape.start, &shape.end}) {
      end->alpha = small * end->alpha;
      end->beta = small * end->beta;
      end->alpha2 = small * end->alpha2;
      end->delta = small * end->delta;
      end->lambda1 = small * random.function(random.integer(0, 2));
      end->lambda2 = small * random.function(random.integer(0, 2));
    }
  }
  check_blend(a, ea, b, eb, blend(a, ea, b, eb, shape, direction), direction);
}
template <class S> const S& over_knots(const S& s) { return s; }
inline Bspline<Exact> over_knots(const Bezier<Exact>& s) { return Bspline<Exact>(s); }
inline Spline<Exact> over_knots(const Patch<Exact>& s) { return Spline<Exact>(s); }

// With polynomials, and with splines, along the edges.
template <class A, class B> void check_random_blends(Numbers& random) {
  check_random_blend(random, random.surface<A>(), random.surface<B>(),
                     {random.reparametrisation(), random.reparametrisation()});
  check_random_blend(random, over_knots(random.surface<A>()), random.surface<B>(),
                     {random.spline_reparametrisation(), random.spline_reparametrisation()});
}

// With the shape of a strategy, in the direction in which the ends of the edges are nearer.
template <class A, class B, class Strategy> void check_automatic_blend(Numbers& random, const Strategy& strategy) {
  const A a = random.surface<A>();
  const B b = random.surface<B>();
  const Patch_edge ea = random.edge(), eb = random.edge();
  const Edge_direction direction = nearer_direction(a, ea, b, eb);
  check_blend(a, ea, b, eb, blend(a, ea, b, eb, strategy), direction);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(all_types, A, Surface_types) {
  Numbers random;
  for_each_surface_type([&](auto b) { check_random_blends<A, typename decltype(b)::type>(random); });
}

// The part between two parts of one surface is the blend of them, with beta = the ratio of its
// length and 1.
template <class Surface> Surface middle(const Surface& s, const Q& low, const Q& high) {
  const auto rest = s.split_v(low).second;
  return rest.split_v(high).first;
}
template <class Surface> void check_middle_part(const Surface& s) {
  const Q low = fraction(1, 3), high = fraction(3, 5), length = high - low;
  const Surface a = s.split_v(low).first, b = s.split_v(high).second;
  Shape shape;
  shape.start.beta = shape.end.beta = Function{length};
  const Surface expected = middle(s, low, high).with_domain(s.domain_u(), {Q(0), Q(1)});
  BOOST_CHECK(blend(a, v1, b, v0, shape) == expected.elevate(0, 5 - s.degree_v()));
  BOOST_CHECK(blend(a.swap_parameters(), u1, b.reverse_v().reverse_u(), v1, shape, Edge_direction::opposite) ==
              expected.elevate(0, 5 - s.degree_v()));
}
BOOST_AUTO_TEST_CASE(a_part_of_one_surface) {
  Numbers random;
  check_middle_part(Bezier<Exact>{random.net(4, 4), random.domain()});
  check_middle_part(Bezier<Exact>{random.net(3, 6), random.domain()});
  check_middle_part(Patch<Exact>{random.net(4, 5), random.weights(4, 5), random.domain()});
}

// The homogeneous points are multiplied by 1 + v/2: lambda is 1 and lambda_1 is 1/2 at the start,
// and at the end they are 3/2 and 1/3.
BOOST_AUTO_TEST_CASE(factors_of_homogeneous_points) {
  Numbers random;
  const Patch<Exact> s{random.net(4, 5), random.weights(4, 5), random.domain()};
  const Q low = fraction(1, 3), high = fraction(3, 5);
  const Patch<Exact> part = middle(s, low, high);
  const auto homogeneous = part.homogeneous();
  const auto net = net_of(4, 6, [&](int i, int j) {
    Patch<Exact>::Homogeneous::Point b(4);
    if (j < 5) b += fraction(5 - j, 5) * homogeneous.control_point(i, j);
    if (j > 0) b += fraction(3 * j, 10) * homogeneous.control_point(i, j - 1);
    return b;
  });
  GC::Rational_surface_blend_shape<Q> shape;
  shape.start.beta = shape.end.beta = Function{Q(high - low)};
  shape.start.lambda1 = Function{fraction(1, 2)};
  shape.end.lambda = fraction(3, 2);
  shape.end.lambda1 = Function{fraction(1, 3)};
  const Patch<Exact> expected(Patch<Exact>::Homogeneous(net, s.domain_u()));
  BOOST_CHECK(blend(s.split_v(low).first, v1, s.split_v(high).second, v0, shape) == expected);
}

// Short numbers, up to those that no longer are: the same as with functions of degree 1 that are
// constant, which take another way.
BOOST_AUTO_TEST_CASE(short_numbers) {
  Numbers random;
  for (int i = 0; i < 200; ++i) {
    const int size = 1 << random.integer(1, 30), denominator = i % 4 == 0 ? 7919 : 1 << random.integer(0, 20);
    const auto patch = [&](int m, int from) {
      const auto number = [&](int at) -> Q { return Q(3 * at) + fraction(random.integer(-size, size), denominator); };
      const auto net = net_of(m, random.integer(2, 5), [&](int k, int l) {
        const Q x = number(k), y = number(from + l);
        return Exact::Point(x, y, number(0));
      });
      return Bezier<Exact>(net, {Q(0), Q(1)}, i % 3 == 0 ? random.domain() : std::pair<Q, Q>(0, 1));
    };
    const int m = random.integer(2, 4);
    const Bezier<Exact> a = patch(m, 0), b = patch(m, 8);
    Shape shape, other;
    shape.start = random.reparametrisation(0, 0, 0, 0);
    shape.end = random.reparametrisation(0, 0, 0, 0);
    for (auto* end : {&shape.start, &shape.end}) end->alpha = end->alpha2 = Function{Q(0)};
    if (i % 2 == 0) shape.end.delta = Function{fraction(random.integer(-99, 99), 8)};
    other = shape;
    other.start.beta = Function{shape.start.beta[0], shape.start.beta[0]};
    other.end.beta = Function{shape.end.beta[0], shape.end.beta[0]};
    const Edge_direction direction = random.direction();
    BOOST_CHECK(blend(a, v1, b, v0, shape, direction).elevate(2, 0) == blend(a, v1, b, v0, other, direction));
    BOOST_CHECK(blend(a, v0, b, v1, shape, direction).elevate(2, 0) == blend(a, v0, b, v1, other, direction));
    const Bezier<Exact> c = a.swap_parameters(), d = b.swap_parameters();
    BOOST_CHECK(blend(c, u1, d, u0, shape, direction) == blend(a, v1, b, v0, shape, direction));
    BOOST_CHECK(blend(c, u0, d, u1, shape, direction) == blend(a, v0, b, v1, shape, direction));
  }
}

BOOST_AUTO_TEST_CASE(automatic_blends) {
  Numbers random;
  check_automatic_blend<Bezier<Exact>, Bezier<Exact>>(random, GC::Minimal_energy<3>());
  check_automatic_blend<Bezier<Exact>, Bspline<Exact>>(random, GC::Minimal_energy<2>());
  check_automatic_blend<Bspline<Exact>, Patch<Exact>>(random, GC::Minimal_second_derivative());
  check_automatic_blend<Patch<Exact>, Spline<Exact>>(random, GC::Minimal_energy<3>());
  check_automatic_blend<Spline<Exact>, Spline<Exact>>(random, GC::Matching_second_derivative());
  check_automatic_blend<Bezier<Exact>, Bezier<Exact>>(random, GC::Fair());
  check_automatic_blend<Patch<Exact>, Bezier<Exact>>(random, GC::Fair());
  check_automatic_blend<Bezier<Exact>, Bezier<Exact>>(random, GC::Given_parameters<double>{0.25, -3});
}

// Where all curves u = const are the same but for a translation, the shape is that of the curves.
TEST_FOR_EACH(shape_of_translated_curves, Traits, All_traits) {
  const Translated_curves<Traits> given;
  const auto strategy = GC::Minimal_energy<3>();
  const auto shape = given.shape(strategy);
  const auto gamma = given.blend_of_curves(strategy);
  BOOST_CHECK(shape.start.beta == (GC::Bernstein_polynomial<FT>{gamma.shape.beta}));
  BOOST_CHECK(shape.end.beta == (GC::Bernstein_polynomial<FT>{gamma.shape.eta}));
  // S_vv = beta^2 W + delta T is the second derivative of the curve, up to the rounding of delta to
  // 8 digits
  const auto s = blend(given.first, v1, given.second, v0, strategy);
  for (int i : {0, 1})
    for (FT v : {FT(0), FT(1)})
      for (int x : {1, 2}) {
        const double expected = CGAL::to_double(gamma.jet(v, 2)[2][x]);
        BOOST_CHECK_SMALL(CGAL::to_double(s.jet(FT(i), v, 2)(0, 2)[x]) - expected, 0.1);
      }
  // the same of Fair, which chooses beta, too, and when all weights are equal
  BOOST_CHECK_CLOSE(CGAL::to_double(given.shape(GC::Fair()).start.beta[0]),
                    CGAL::to_double(given.blend_of_curves(GC::Fair()).shape.beta), 0.5);
  const auto rational = given.rational_shape(strategy);
  BOOST_CHECK(rational.start.beta == shape.start.beta && rational.end.delta == shape.end.delta);
  BOOST_CHECK(rational.start.lambda1 == (GC::Bernstein_polynomial<FT>{FT(0)}));
  BOOST_CHECK_EQUAL(rational.start.lambda, FT(8));
  BOOST_CHECK(nearer_direction(given.first, v1, given.second, v0) == Edge_direction::same);
  BOOST_CHECK(nearer_direction(given.first, v1, given.second.reverse_u(), v0) == Edge_direction::opposite);
}

// Among the neighbours in delta, the strategy has the least energy.
BOOST_AUTO_TEST_CASE(least_energy) {
  Numbers random;
  const Bezier<Exact> a(random.net(2, 3)), b(random.net(2, 4));
  Shape shape = automatic_surface_shape(a, v1, b, v0, GC::Minimal_energy<3>(), Edge_direction::same);
  const auto energy = [&] {
    const Bezier<Exact> s = blend(a, v1, b, v0, shape);
    Q sum(0);
    for (int i : {0, 1}) sum += boundary_curve(s, i == 0 ? u0 : u1).energy(3);
    return sum;
  };
  const Q least = energy();
  for (Function* delta : {&shape.start.delta, &shape.end.delta})
    for (const Q& factor : {fraction(9, 10), fraction(11, 10)}) {
      const Function before = *delta;
      *delta = Function{factor} * before;
      BOOST_CHECK(energy() > least);
      *delta = before;
    }
}

BOOST_AUTO_TEST_CASE(degrees_and_knots) {
  Numbers random;
  const Bezier<Exact> a(random.net(3, 4)), b(random.net(5, 3));
  BOOST_CHECK_EQUAL(blend(a, v1, b, v0, Shape{random.reparametrisation(0, 0, 0, 0), {}}).degree_u(), 4);
  BOOST_CHECK_EQUAL(blend(a, v1, b, v0, Shape{random.reparametrisation(2, 0, 0, 0), {}}).degree_u(), 4);
  BOOST_CHECK_EQUAL(blend(a, v1, b, v0, Shape{random.reparametrisation(0, 2, 0, 0), {}}).degree_u(), 6);
  BOOST_CHECK_EQUAL(blend(a, v1, b, v0, Shape{{}, random.reparametrisation(0, 0, 3, 0)}).degree_u(), 6);
  BOOST_CHECK_EQUAL(blend(a, v1, b, v0, Shape{{}, random.reparametrisation(0, 0, 0, 4)}).degree_u(), 8);
  // knots in the parameter of the first edge; that of the second one runs from 2 to 6, backwards
  const auto clamped = [](int degree, int from, int to, const std::vector<Knots::Knot>& inner) {
    return Knots(degree, Q(from), Q(to), inner);
  };
  const Knots u = clamped(3, 0, 1, {{fraction(1, 3), 1}}), w = clamped(2, 2, 6, {{Q(3), 1}});
  const Bspline<Exact> c(random.net(5, 3), u, Knots(2, Q(0), Q(1))), d(random.net(4, 3), w, Knots(2, Q(0), Q(1)));
  const Bspline<Exact> s = blend(c, v1, d, v0, Shape(), Edge_direction::opposite);
  BOOST_CHECK(s.knots_u() == clamped(3, 0, 1, {{fraction(1, 3), 1}, {fraction(3, 4), 2}}));
  BOOST_CHECK(s.knots_v() == Knots(5, Q(0), Q(1)));
  // knots that are not clamped
  const Bspline<Exact> e(random.net(4, 3), Knots(3, {-3, -2, -1, 0, 1, 2, 3, 4}), Knots(2, {-2, -1, 0, 1, 2, 3}));
  check_blend(e, v1, d, v0, blend(e, v1, d, v0, Shape()), Edge_direction::same);
  BOOST_CHECK(blend(e, v1, d, v0, Shape()) == blend(e.clamp(), v1, d, v0, Shape()));
}

// They are counted before anything is computed. A Work_scope raises the limit.
TEST_FOR_EACH(too_many_knots, Traits, All_traits) {
  typedef typename Traits::Point P;
  typedef GC::Knot_vector<FT> Knots;
  const auto surface = [](int inner, int y) {
    std::vector<typename Knots::Knot> knots;
    for (int i = 1; i <= inner; ++i) knots.push_back({FT(FT(i) / FT(inner + 1)), 1});
    const Knots u(1, FT(0), FT(1), knots);
    std::vector<std::vector<P>> net;
    for (int i = 0; i < u.number_of_coefficients(); ++i) net.push_back({P(i, y, 0), P(i, y + 1, i % 2)});
    return Bspline<Traits>(net, u, Knots(1, FT(0), FT(1)));
  };
  const Bspline<Traits> a = surface(14, 0), b = surface(5, 3).swap_parameters();
  GC::Surface_blend_shape<FT> shape;
  shape.end.beta = GC::Bspline_function<FT>(Knots(1, FT(0), FT(1), {{FT(FT(1) / FT(9)), 1}}), {FT(1), FT(2), FT(1)});
  const auto blended = [&](std::uint64_t steps) {
    const GC::Work_scope each((GC::Work_limit(steps)));
    return blend(a, v1, b, u0, shape);
  };
  // degree 1 + 2, in which each knot is there three times: up to 60, and 58 control points, because
  // both edges have 1/3 and 2/3
  const std::uint64_t steps = 6 * 3 * 16 * 64 * (std::is_same_v<FT, Q> ? 450 : 1);
  // what is computed counts as well
  const Bspline<Traits> s = blended(std::is_same_v<FT, Q> ? 4 * steps : steps);
  BOOST_CHECK_EQUAL(s.number_of_points_u(), 58);
  CHECK_ERROR(blended(steps - 1), too_many_knots);
  BOOST_CHECK_EQUAL(error_of([&] { blended(1000); }),
                    "too_many_knots: blend: 14 inner knots along the edge v1 of the first surface, 5 along the edge u0 "
                    "of the second one and 1 of the functions are up to 60 in degree 3, " +
                        std::to_string(steps) + " steps of work, and 1000 are allowed: a Work_scope raises the limit");
}

// From a closed edge to an open one: both side edges start in one point, and the blend is G2 as any
// other.
BOOST_AUTO_TEST_CASE(closed_and_open_edges) {
  const Knots u(2, Q(0), Q(1), {{fraction(1, 3), 1}, {fraction(2, 3), 1}}), v(1, Q(0), Q(1));
  const auto surface = [&](const std::vector<std::pair<int, int>>& edge, int z) {
    std::vector<std::vector<Exact::Point>> net;
    for (const auto& p : edge)
      net.push_back({Exact::Point(p.first, p.second, z), Exact::Point(p.first + 1, p.second + 2, z + 1)});
    return Bspline<Exact>(net, u, v);
  };
  const Bspline<Exact> closed = surface({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}, 0),
                       other = surface({{0, 0}, {5, 0}, {5, 7}, {0, 5}, {0, 0}}, 4),
                       open = surface({{0, 0}, {1, 1}, {2, 0}, {3, 3}, {4, 0}}, 4);
  const Bspline<Exact> s = blend(closed, v1, open, v0, Shape()), t = blend(closed, v1, other, v0, Shape());
  check_blend(closed, v1, open, v0, s, Edge_direction::same);
  check_blend(closed, v1, other, v0, t, Edge_direction::same);
  BOOST_CHECK(s(Q(0), Q(0)) == s(Q(1), Q(0)) && s(Q(0), Q(1)) != s(Q(1), Q(1)));
  for (int j = 0; j <= 5; ++j) BOOST_CHECK(t.control_point(0, j) == t.control_point(4, j));
}

// A row that a shift along the edge multiplies must not jump.
BOOST_AUTO_TEST_CASE(torn_blends) {
  Numbers random;
  const Knots v(2, Q(0), Q(1));
  const auto surface = [&](int degree, int multiplicity) {
    const Knots u(degree, Q(0), Q(1), {{fraction(1, 3), multiplicity}});
    return Bspline<Exact>(random.net(u.number_of_coefficients(), 3), u, v);
  };
  Shape none, shift, bend;
  shift.start.alpha = Function{Q(1), Q(2)};
  bend.end.alpha2 = Function{Q(1)};
  const auto check = [&](const Bspline<Exact>& s, const Shape& shape) {
    check_blend(s, v1, s, v1, blend(s, v1, s, v1, shape), Edge_direction::same);
  };
  for (int multiplicity : {1, 2, 3}) check(surface(3, multiplicity), none);
  for (int multiplicity : {1, 2}) check(surface(3, multiplicity), bend);
  CHECK_ERROR(check(surface(3, 3), bend), knot_multiplicity);
  check(surface(3, 1), shift);
  CHECK_ERROR(check(surface(3, 2), shift), knot_multiplicity);
  CHECK_ERROR(check(surface(3, 4), none), knot_multiplicity);
  BOOST_CHECK_EQUAL(error_of([&] { check(surface(2, 1), shift); }),
                    "knot_multiplicity: blend: it would be torn at the knot 0.333333 along an edge");
}

// Splines as functions: their knots are knots of the blend, and where they jump it would be torn.
BOOST_AUTO_TEST_CASE(functions_over_knots) {
  Numbers random;
  const Knots on_3_to_7(1, Q(3), Q(7), {{Q(4), 1}});
  const Function hat = GC::Bspline_function<Q>(on_3_to_7, {Q(1), Q(3), Q(2)});
  BOOST_CHECK(hat.knots() == Knots(1, Q(0), Q(1), {{fraction(1, 4), 1}}));
  BOOST_CHECK_EQUAL(hat(fraction(5, 8)), fraction(5, 2));
  std::ostringstream os;
  os << hat << "; " << Function{Q(7)} << "; " << Function{Q(1), Q(2)};
  BOOST_CHECK_EQUAL(os.str(), "1 3 2 over 1/4; 7; 1 2");
  const Bezier<Exact> a(random.net(3, 3), {Q(2), Q(6)}, {Q(0), Q(1)}), b(random.net(3, 3));
  Shape shape;
  shape.start.beta = hat;
  const Bspline<Exact> spline_a(a), spline_b(b), s = blend(spline_a, v1, spline_b, v0, shape);
  BOOST_CHECK(s.knots_u() == Knots(4, Q(2), Q(6), {{Q(3), 4}})); // degree 2 + 2 of beta^2
  // at each parameter the curve is the blend with beta there
  for (const Q& t : {fraction(1, 8), fraction(1, 4), fraction(2, 3)}) {
    Shape number;
    number.start.beta = Function{hat(t)};
    const Q u = Q(2) + Q(4) * t;
    const Bezier<Exact> at = blend(a, v1, b, v0, number);
    for (const Q& v : {fraction(1, 3), fraction(3, 4)}) BOOST_CHECK(s(u, v) == at(u, v));
  }
  check_blend(spline_a, v1, spline_b, v0, s, Edge_direction::same);
  // a spline that is negative somewhere, one with a negative coefficient that is positive, one that
  // jumps
  shape.start.beta = GC::Bspline_function<Q>(on_3_to_7, {Q(1), Q(-1), Q(2)});
  CHECK_ERROR(blend(spline_a, v1, spline_b, v0, shape), nonpositive_beta);
  shape.start.beta =
      GC::Bspline_function<Q>(Knots(2, Q(0), Q(1), {{fraction(1, 2), 2}}), {Q(4), Q(-1), Q(1), Q(1), Q(1)});
  check_blend(spline_a, v1, spline_b, v0, blend(spline_a, v1, spline_b, v0, shape), Edge_direction::same);
  shape.start.beta = GC::Bspline_function<Q>(Knots(0, Q(0), Q(1), {{fraction(1, 2), 1}}), {Q(4), Q(1)});
  CHECK_ERROR(blend(spline_a, v1, spline_b, v0, shape), knot_multiplicity);
  // patches have no room for knots
  shape.start.beta = hat;
  CHECK_ERROR(blend(a, v1, b, v0, shape), knot_multiplicity);
}

// Numbers that are short, but not over one denominator, or not when they are multiplied.
BOOST_AUTO_TEST_CASE(numbers_that_become_long) {
  const auto check = [](const std::array<Q, 4>& y, const Q& beta, const Q& delta) {
    const auto patch = [&](int from) {
      return Bezier<Exact>(net_of(2, 2, [&](int i, int j) { return Exact::Point(Q(i), y[from + j], Q(0)); }));
    };
    const Bezier<Exact> a = patch(0), b = patch(2);
    Shape shape;
    shape.start.beta = shape.end.beta = Function{beta};
    shape.start.delta = shape.end.delta = Function{delta};
    Shape other = shape; // the same as functions
    other.start.beta = other.end.beta = Function{beta, beta};
    BOOST_CHECK(blend(a, v1, b, v0, shape).elevate(2, 0) == blend(a, v1, b, v0, other));
    const Bezier<Exact> c = a.elevate(0, 1), d = b.elevate(0, 1); // with second derivatives
    BOOST_CHECK(blend(c, v1, d, v0, shape).elevate(2, 0) == blend(c, v1, d, v0, other));
  };
  const Q one(1), zero(0), long_number = Q(1) / Q(2147483647) / Q(2147483629);
  const std::array<Q, 4> whole{zero, one, Q(2), Q(3)};
  check(whole, one, zero);
  // the common denominator
  check({fraction(1, 2147483647), fraction(2, 2147483629), Q(2), Q(3)}, one, zero);
  check({zero, one, Q(Q(1 << 30) * Q(1 << 28)), Q(Q(1 << 30) * Q(1 << 29))}, one, zero);
  check(whole, long_number, zero);
  check(whole, Q(Q(1 << 30) * Q(1 << 30)), zero);
  check(whole, Q(Q(1 << 30) * Q(4)), zero); // short, but its square is not
  check(whole, fraction(1, 1 << 30) / Q(4), zero);
  check(whole, one, long_number);
  check(whole, one, Q(Q(1 << 30) * Q(1 << 30)));
  check(whole, fraction(1, 2147483647), fraction(1, 2147483629));
  // functions of each kind, and degrees across that are 0
  const Bezier<Exact> a(
      {{Exact::Point(0, 0, 0), Exact::Point(0, 1, 0)}, {Exact::Point(1, 0, 0), Exact::Point(1, 1, 0)}}),
      curve({{Exact::Point(0, 3, 0)}, {Exact::Point(1, 3, 0)}});
  CHECK_ERROR(blend(a, v1, curve, v0, Shape()), zero_tangent);
  CHECK_ERROR(blend(curve, v1, a, v0, Shape()), zero_tangent);
  Shape shape, same;
  shape.start.delta = Function{Q(3), Q(3)};
  same.start.delta = Function{Q(3)};
  BOOST_CHECK(blend(a, v1, a, u0, shape) == blend(a, v1, a, u0, same).elevate(1, 0));
  // the second surface has no derivative across its edge
  const Bezier<Exact> slow(
      {{Exact::Point(0, 5, 0), Exact::Point(0, 5, 0)}, {Exact::Point(1, 5, 0), Exact::Point(1, 5, 0)}});
  const auto error = [](const Bezier<Exact>& x, const Bezier<Exact>& y) {
    return error_of([&] { automatic_surface_shape(x, v1, y, v0, GC::Minimal_energy<3>(), Edge_direction::same); });
  };
  BOOST_CHECK_EQUAL(error(a, slow), "zero_tangent: automatic_surface_shape: the second surface");
  BOOST_CHECK_EQUAL(error(slow, a), "zero_tangent: automatic_surface_shape: the first surface");
}

TEST_FOR_EACH(errors, Traits, All_traits) {
  typedef typename Traits::Point P;
  typedef GC::Edge_function<FT> Function;
  const Bezier<Traits> a({{P(0, 0, 0), P(0, 1, 0)}, {P(1, 0, 0), P(1, 1, 0)}});
  const Bezier<Traits> b({{P(0, 3, 0), P(0, 4, 0)}, {P(1, 3, 0), P(1, 4, 0)}});
  GC::Surface_blend_shape<FT> shape;
  BOOST_CHECK_EQUAL(blend(a, v1, b, v0, shape).degree_u(), 1);
  for (const Function& beta : {Function{FT(0)}, Function{FT(-1)}, Function{FT(1), FT(-1)}, Function{FT(1), FT(0)},
                               Function{FT(1), FT(-1), FT(1)}}) {
    shape.start.beta = beta;
    CHECK_ERROR(blend(a, v1, b, v0, shape), nonpositive_beta);
    shape.start.beta = Function{FT(1)};
    shape.end.beta = beta;
    CHECK_ERROR(blend(a, v1, b, v0, shape), nonpositive_beta);
    shape.end.beta = Function{FT(1)};
  }
  shape.start.beta = Function{FT(4), FT(-1), FT(1)}; // has a negative coefficient, and is positive
  BOOST_CHECK_EQUAL(blend(a, v1, b, v0, shape).degree_u(), 5);
  shape.start.beta = Function{FT(1)};

  const Bezier<Traits> pole({{P(0, 0, 0), P(0, 1, 0)}, {P(1, 0, 0), P(0, 1, 0)}});
  CHECK_ERROR(blend(pole, v1, b, v0, shape), zero_tangent);
  CHECK_ERROR(blend(b, v0, pole, v1, shape), zero_tangent);
  BOOST_CHECK_EQUAL(blend(pole, v0, b, v0, shape).degree_u(), 1);
  const Bezier<Traits> slow({{P(0, 0, 0), P(0, 1, 0), P(0, 1, 0)}, {P(1, 0, 0), P(1, 1, 0), P(1, 1, 0)}});
  CHECK_ERROR(blend(slow, v1, b, v0, shape), zero_tangent);
  // in homogeneous points both hide behind the weights
  const Patch<Traits> round_pole({{P(0, 0, 0), P(0, 1, 0)}, {P(1, 0, 0), P(0, 1, 0)}}, {{1, 1}, {1, 2}});
  CHECK_ERROR(blend(b, v0, round_pole, v1, shape), zero_tangent);
  const Patch<Traits> weighted({{P(0, 0, 0), P(0, 1, 0), P(0, 1, 0)}, {P(1, 0, 0), P(1, 1, 0), P(1, 1, 0)}},
                               {{1, 1, 2}, {1, 1, 2}});
  CHECK_ERROR(blend(weighted, v1, b, v0, shape), zero_tangent);
  CHECK_ERROR(blend(b, v0, weighted, v1, shape), zero_tangent);
  BOOST_CHECK_EQUAL(blend(weighted, v0, b, v0, shape).degree_u(), 1);
  // a denominator that becomes negative
  const Patch<Traits> steep({{P(0, 0, 0), P(0, 1, 0)}, {P(1, 0, 0), P(1, 1, 0)}}, {{9, 1}, {9, 1}});
  CHECK_ERROR(blend(steep, v1, b, v0, shape), zero_weight);
  const std::string place = error_of([&] { blend(steep, v1, b, v0, shape); });
  BOOST_CHECK_EQUAL(place.substr(0, place.find(';')),
                    "zero_weight: blend: its denominator is not positive near (u, v) = (0.000000, 0.400000), where a "
                    "control point has the weight -2.200000");
  GC::Rational_surface_blend_shape<FT> factor = shape;
  factor.end.lambda = FT(0);
  CHECK_ERROR(blend(weighted, v0, b, v0, factor), zero_weight);
  // which the automatic factor avoids
  BOOST_CHECK_EQUAL(blend(steep, v1, b, v0).degree_u(), 1);
  CHECK_ERROR(blend(slow, v1, b, v0), zero_tangent);
  CHECK_ERROR(blend(weighted, v1, b, v0), zero_tangent);
  CHECK_ERROR(blend(b, v0, pole, v1), zero_tangent);
  if constexpr (std::is_floating_point_v<FT>) {
    shape.end.delta = Function{FT(1e308)};
    const Bezier<Traits> large = b.transform([](const P& p) { return P(1000 * p.x(), 1000 * p.y(), p.z()); });
    CHECK_ERROR(blend(a, v1, large, v0, shape), not_finite);
    shape.end.delta = Function{FT(1)};
    // by a power of two: products of its numbers overflow, its numbers do not
    const auto scaled = [](const Bezier<Traits>& s) {
      return s.transform([](const P& p) { return P(0x1p600 * p.x(), 0x1p600 * p.y(), 0x1p600 * p.z()); });
    };
    BOOST_CHECK(blend(scaled(a), v1, scaled(b), v0, shape) == scaled(blend(a, v1, b, v0, shape)));
    CHECK_ERROR(Function{std::numeric_limits<FT>::quiet_NaN()}, not_finite);
  }
}

// Numbers of thousands of digits are refused when they take too long.
BOOST_AUTO_TEST_CASE(work_limit) {
  Numbers random;
  const Bezier<Exact> a(random.net(4, 4));
  Shape shape;
  Q tiny(1);
  for (int i = 0; i < 2000; ++i) tiny *= fraction(1, 1000003);
  const auto with_long_numbers =
      a.transform([&](const Exact::Point& p) { return Exact::Point(p.x() + tiny, p.y(), p.z()); });
  BOOST_CHECK_EQUAL(blend(a, v1, with_long_numbers, v0, shape).degree_u(), 3);
  const GC::Work_scope each(GC::Work_limit(1000000));
  BOOST_CHECK_EQUAL(blend(a, v1, a, v0, shape).degree_u(), 3);
  CHECK_ERROR(blend(a, v1, with_long_numbers, v0, shape), work_limit);
}

// Any dimension; the coordinates do not mix.
BOOST_AUTO_TEST_CASE(other_dimensions) {
  typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Traits;
  Numbers random;
  const auto net = random.net(3, 4);
  const auto lift = [](const Exact::Point& p, int d) {
    const Q c[] = {p.x(), p.y(), p.z(), p.x(), p.y()};
    return Traits::Point(d, c, c + d);
  };
  const Bezier<Exact> a(net);
  const Shape shape{random.reparametrisation(), random.reparametrisation()};
  const Bezier<Exact> s = blend(a, v1, a, u0, shape);
  for (int d : {2, 3, 5}) {
    auto points = net_of(3, 4, [&](int i, int j) { return lift(net[i][j], d); });
    const Bezier<Traits> b(points), t = blend(b, v1, b, u0, shape);
    for (int i = 0; i <= t.degree_u(); ++i)
      for (int j = 0; j <= 5; ++j) BOOST_CHECK(t.control_point(i, j) == lift(s.control_point(i, j), d));
    if (d == 2) {
      for (auto& row : points)
        for (Traits::Point& p : row) p = lift(Exact::Point(p[0], p[1], 0), 3);
      CHECK_ERROR(blend(b, v1, Bezier<Traits>(points), v0, shape), dimension_mismatch);
      CHECK_ERROR(blend(b, v1, Bezier<Traits>(points), v0, Shape()), dimension_mismatch);
    }
  }
}

// Where nothing is rounded the blend is exact in floating-point numbers, and proved there;
// otherwise it is near.
BOOST_AUTO_TEST_CASE_TEMPLATE(floating_point, Traits, Rounded_traits) {
  typedef typename Traits::Point P;
  Numbers random;
  const auto net = [&](int m, int n, int from, int unit) {
    return net_of(m, n, [&](int i, int j) {
      const int x = 50 * i + random.integer(-9, 9), y = 50 * (from + j) + random.integer(-9, 9);
      return P(unit * x, unit * y, unit * random.integer(-9, 9));
    });
  };
  GC::Surface_blend_shape<double> constants, shape;
  constants.start.beta = {0.75};
  constants.end.delta = {-1.5};
  shape.start.alpha = {0.5, 1};
  shape.start.delta = {-1, 2, 3};
  shape.end.beta = {2};
  const Shape exact_shape{{{fraction(1, 2), Q(1)}, Function{Q(1)}, Function{Q(0)}, {Q(-1), Q(2), Q(3)}},
                          {Function{Q(0)}, Function{Q(2)}, Function{Q(0)}, Function{Q(0)}}};
  int rounded = 0;
  for (int i = 0; i < 20; ++i) {
    const Bezier<Traits> a(net(3, 3, 0, 320)), b(net(3, 3, 5, 320)), s = blend(a, v1, b, v0, constants);
    BOOST_CHECK_EQUAL(whole_edge_order(a, v1, s, v0), 2);
    BOOST_CHECK_EQUAL(whole_edge_order(s, v1, b, v0), 2);
    const Bezier<Traits> c(net(3, 3, 0, 1)), d(net(2, 3, 5, 1)), t = blend(c, v1, d, v0, shape);
    rounded += whole_edge_order(c, v1, t, v0) < 2;
    const Bezier<Exact> e = blend(surface_exactly<Exact>(c), v1, surface_exactly<Exact>(d), v0, exact_shape);
    for (int k = 0; k <= e.degree_u(); ++k)
      for (int l = 0; l <= 5; ++l)
        for (int x = 0; x < 3; ++x)
          BOOST_CHECK_SMALL(CGAL::to_double(e.coordinates(k, l)[x]) - t.coordinates(k, l)[x], 1e-11);
  }
  BOOST_CHECK_GT(rounded, 0);
}

// All curves u = const are one curve but for a translation. A common factor of all homogeneous
// points changes nothing, here 1 + v.
BOOST_AUTO_TEST_CASE(mean_fairness_of_translated_curves) {
  const Translated_curves<Double> curves;
  const GC::Minimal_energy<3> strategy;
  const Bezier<Double> s = blend(curves.first, v1, curves.second, v0, curves.shape(strategy), Edge_direction::same);
  const double e = GC::fairness(boundary_curve(s, u0));
  BOOST_CHECK_CLOSE(mean_fairness(s), e, 1e-6);
  std::vector<std::vector<Double::Point>> net(2);
  std::vector<std::vector<double>> weights(2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j <= 6; ++j) { // of degree 6
      const double before = 2 * j / 6., here = (6 - j) / 6.;
      const Double::Point &p = s.control_point(i, (std::max)(j - 1, 0)), &q = s.control_point(i, (std::min)(j, 5));
      net[i].push_back(CGAL::ORIGIN + (before * (p - CGAL::ORIGIN) + here * (q - CGAL::ORIGIN)) / (before + here));
      weights[i].push_back(before + here);
    }
  BOOST_CHECK_CLOSE(mean_fairness(Patch<Double>(net, weights)), e, 1e-6);
}

struct Bent_surfaces : Random_surfaces {
  double number(double size) { return size * integer(-1000, 1000) / 1000; }
  // From y on, or up to y.
  Bezier<Double> surface(double y, double z, bool before, double noise) {
    const int p = integer(1, 3), q = integer(1, 4);
    const double tilt = number(noise);
    return Bezier<Double>(net_of(p + 1, q + 1, [&](int i, int j) {
      const double across = 2. * (before ? j - q : j) + number(noise), up = number(noise);
      return Double::Point(6. * i / p + number(noise), y + std::cos(tilt) * across - std::sin(tilt) * up,
                           z + std::sin(tilt) * across + std::cos(tilt) * up);
    }));
  }
};

// The fairest blend is never less fair than those of the four strategies, has no fold where one of
// them has none, and is nearly always a minimum: others near it have folds or are less fair. `Fair`
// has no fold where the least energy has none.
BOOST_AUTO_TEST_CASE(fairest_blends) {
  Bent_surfaces random;
  int not_least = 0, smooth = 0;
  for (int round = 0; round < 40; ++round) {
    const double noise = round % 2 == 0 ? 0.4 : 1;
    const Bezier<Double> a = random.surface(0, 0, true, noise),
                         b = random.surface(5 + random.number(2), random.number(3), false, noise);
    const auto of_shape = [&](const GC::Surface_blend_shape<double>& shape) {
      return blend(a, v1, b, v0, shape, Edge_direction::same);
    };
    double best = std::numeric_limits<double>::infinity();
    const auto is_unfolded = [&](const auto& strategy) {
      const Bezier<Double> s = blend(a, v1, b, v0, strategy, Edge_direction::same);
      if (possible_fold(s)) return false;
      best = (std::min)(best, mean_fairness(s));
      return true;
    };
    is_unfolded(GC::Matching_second_derivative());
    is_unfolded(GC::Minimal_energy<2>());
    if (is_unfolded(GC::Minimal_energy<3>()))
      BOOST_CHECK(is_unfolded(GC::Fair()));
    else
      is_unfolded(GC::Fair());
    const auto shape = automatic_surface_shape(a, v1, b, v0, GC::Fairest(), Edge_direction::same);
    if (!std::isfinite(best)) continue;
    ++smooth;
    BOOST_CHECK(!possible_fold(of_shape(shape)));
    const double least = mean_fairness(of_shape(shape));
    BOOST_CHECK_LE(least, best);
    for (const auto end : {&GC::Surface_blend_shape<double>::start, &GC::Surface_blend_shape<double>::end})
      for (const double sign : {-1., 1.})
        for (const bool changes_beta : {false, true}) {
          GC::Surface_blend_shape<double> near = shape;
          const double beta = (near.*end).beta[0];
          if (changes_beta)
            (near.*end).beta = {beta * (1 + 0.15 * sign)};
          else
            (near.*end).delta = {(near.*end).delta[0] + beta * sign};
          const Bezier<Double> s = of_shape(near);
          if (mean_fairness(s) < 0.98 * least && !possible_fold(s)) ++not_least;
        }
  }
  BOOST_CHECK_GE(smooth, 35);
  BOOST_CHECK_LE(not_least, 4); // next to a fold
}

// Between steep surfaces, where the strategies for curves often fold, the fairest blend has no fold
// if one of many random shapes has none, and is fairer than all of these. The order of the surfaces
// makes no difference.
BOOST_AUTO_TEST_CASE(fairest_blends_of_steep_surfaces) {
  Bent_surfaces random;
  int unfolded = 0, folded = 0, less_fair = 0;
  for (int round = 0; round < 30; ++round) {
    const Bezier<Double> a = random.surface(0, 0, true, 1.5),
                         b = random.surface(5 + random.number(2), random.number(3), false, 1.5);
    const auto shape = automatic_surface_shape(a, v1, b, v0, GC::Fairest(), Edge_direction::same),
               backwards = automatic_surface_shape(b, v0, a, v1, GC::Fairest(), Edge_direction::same);
    BOOST_CHECK_EQUAL(shape.start.beta[0], backwards.end.beta[0]);
    BOOST_CHECK_EQUAL(shape.end.beta[0], backwards.start.beta[0]);
    BOOST_CHECK_SMALL(shape.start.delta[0] + backwards.end.delta[0], 1e-12);
    BOOST_CHECK_SMALL(shape.end.delta[0] + backwards.start.delta[0], 1e-12);
    const auto unit = automatic_surface_shape(a, v1, b, v0, GC::Minimal_energy<3>(), Edge_direction::same);
    double best = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 40; ++k) {
      GC::Surface_blend_shape<double> other = unit;
      for (const auto end : {&GC::Surface_blend_shape<double>::start, &GC::Surface_blend_shape<double>::end}) {
        const double beta = (unit.*end).beta[0] * std::exp(random.number(2));
        (other.*end).beta = {beta};
        (other.*end).delta = {beta * random.number(15)};
      }
      const Bezier<Double> s = blend(a, v1, b, v0, other, Edge_direction::same);
      if (!possible_fold(s)) best = (std::min)(best, mean_fairness(s));
    }
    if (!std::isfinite(best)) continue;
    ++unfolded;
    const Bezier<Double> s = blend(a, v1, b, v0, shape, Edge_direction::same);
    if (possible_fold(s))
      ++folded;
    else if (!(mean_fairness(s) < best))
      ++less_fair;
  }
  BOOST_CHECK_GE(unfolded, 25);
  BOOST_CHECK_EQUAL(folded, 0);
  BOOST_CHECK_LE(less_fair, 1);
}

// Surfaces with positive weights always have a blend, whatever the weights are.
BOOST_AUTO_TEST_CASE(weights_stay_positive) {
  Numbers random;
  for (int round = 0; round < 30; ++round) {
    const Patch<Exact> a = random_patch(random, random.integer(1, 2), random.integer(1, 3)),
                       b = random_patch(random, random.integer(1, 2), random.integer(1, 3));
    const auto check = [&](const auto& strategy) {
      const Patch<Exact> s = blend(a, v1, b, v0, strategy, Edge_direction::same);
      for (const Q& weight : s.weights()) BOOST_CHECK_GT(weight, Q(0));
      BOOST_CHECK_EQUAL(whole_edge_order(a, v1, s, v0), 2);
      BOOST_CHECK_EQUAL(whole_edge_order(s, v1, b, v0), 2);
    };
    check(GC::Matching_second_derivative());
    check(GC::Minimal_energy<3>());
    check(GC::Minimal_energy_g3<4>());
    if (round < 3) check(GC::Fairest());
  }
}

BOOST_AUTO_TEST_SUITE_END()
