// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// B-spline surfaces without a strip along an edge, up to curves that cross knot lines: bounds hold,
// and what is not promised to change stays.

#include "support/random_surfaces.h"
#include "support/rational_surfaces.h"

#include <CGAL/Geometric_continuity/surfaces/cut_back.h>

BOOST_AUTO_TEST_SUITE(surfaces_trimmed_back_within)

typedef GC::Bernstein_polynomial<Q> Function;

Q square_of_distance(const Exact::Point& p, const Exact::Point& q) { return Q((q - p).squared_length()); }

// Knots of the degree 3 over [0, 8] and seven spans across, or with an inner knot that is double.
template <class Surface> Surface surface_with_knots(Random_surfaces& random, int multiplicity) {
  const Knots u(2, Q(0), Q(1), {{fraction(1, 3), 1}}),
      v(3, Q(0), Q(8), {{Q(1), 1}, {Q(3), 1}, {Q(5), multiplicity}, {Q(6), 1}, {fraction(13, 2), 1}, {Q(7), 1}});
  const auto net = random.net(u.number_of_coefficients(), v.number_of_coefficients());
  if constexpr (std::is_same_v<Surface, Spline<Exact>>) {
    std::vector<std::vector<Q>> weights(net.size());
    for (std::size_t i = 0; i < net.size(); ++i)
      for (std::size_t j = 0; j < net[i].size(); ++j) weights[i].push_back(fraction(random.integer(90, 110), 100));
    return Surface(net, weights, u, v);
  } else
    return Surface(net, u, v);
}

// The last inner knot: where the strip begins.
Q start_of_strip(const Knots& v) { return v[v.number_of_coefficients() - 1]; }

template <class Surface> void check(Random_surfaces& random) {
  for (const Function& f : {Function{fraction(1, 2), fraction(5, 2)}, Function{Q(2), fraction(1, 4), Q(2)}}) {
    const Surface s = surface_with_knots<Surface>(random, 1);
    Q last(-1);
    for (const Q& tolerance : {Q(10000000000.0), Q(1000000000), Q(500000000)}) {
      const auto r = cut_back_within(s, v1, f, tolerance);
      const Surface& t = r.surface;
      BOOST_CHECK(Q(0) < r.squared_deviation && r.squared_deviation <= tolerance * tolerance);
      BOOST_CHECK(last < Q(0) || r.squared_deviation <= last);
      last = r.squared_deviation;
      BOOST_CHECK(t.domain_u() == s.domain_u() && t.domain_v() == s.domain_v());
      const Q start = start_of_strip(t.knots_v());
      BOOST_CHECK(Q(3) < start && start < Q(6));
      Q largest(0);
      for (int i = 0; i <= 12; ++i)
        for (int j = 0; j <= 12; ++j) {
          const Q u = fraction(i, 12), v = Q(8) * fraction(j, 12), y = start + (Q(8) - start) * fraction(j, 12);
          if (v <= start) BOOST_CHECK(t(u, v) == s(u, v));
          largest = (std::max)(largest, square_of_distance(t(u, y), s(u, Q(start + (y - start) * (Q(8) - f(u) - start) /
                                                                                       (Q(8) - start)))));
        }
      BOOST_CHECK(Q(0) < largest && largest <= r.squared_deviation);
      BOOST_CHECK(r.squared_deviation < Q(400) * largest); // a useful bound
      const auto parts = t.split_v(start);
      BOOST_CHECK_EQUAL(whole_edge_order(parts.first, v1, parts.second, v0), 2);
    }
    CHECK_ERROR(cut_back_within(s, v1, f, Q(1000)), unreachable_tolerance);
  }
}

BOOST_AUTO_TEST_CASE(bounds) {
  Random_surfaces random;
  check<Bspline<Exact>>(random);
  check<Spline<Exact>>(random);
}

// The other edges are v1 of the same surface in other parameters.
BOOST_AUTO_TEST_CASE(edges) {
  Random_surfaces random;
  const Function f{fraction(1, 2), fraction(5, 2)};
  const Q tolerance(5000000000.0);
  const Bspline<Exact> s = surface_with_knots<Bspline<Exact>>(random, 1);
  const auto r = cut_back_within(s, v1, f, tolerance), lower = cut_back_within(s.reverse_v(), v0, f, tolerance),
             right = cut_back_within(s.swap_parameters(), u1, f, tolerance),
             left = cut_back_within(s.swap_parameters().reverse_u(), u0, f, tolerance);
  BOOST_CHECK(lower.surface.reverse_v() == r.surface && lower.squared_deviation == r.squared_deviation);
  BOOST_CHECK(right.surface.swap_parameters() == r.surface && right.squared_deviation == r.squared_deviation);
  BOOST_CHECK(left.surface.reverse_u().swap_parameters() == r.surface && left.squared_deviation == r.squared_deviation);
}

// Exact before the next knot line, and where the knots in the strip are none of the surface.
BOOST_AUTO_TEST_CASE(exact) {
  Random_surfaces random;
  const Function f{fraction(1, 2), fraction(2, 3)}, across_knots{fraction(1, 2), fraction(5, 2)};
  const Bspline<Exact> s = surface_with_knots<Bspline<Exact>>(random, 1);
  const auto r = cut_back_within(s, v1, f, Q(1));
  BOOST_CHECK(r.surface == cut_back(s, v1, f));
  BOOST_CHECK(r.squared_deviation == Q(0));
  const Spline<Exact> cubic = Spline<Exact>(Bspline<Exact>(random.surface<Bezier<Exact>>().with_domain({0, 1}, {0, 8})))
                                  .insert_v(Q(6))
                                  .insert_v(Q(7), 2);
  const auto q = cut_back_within(cubic, v1, across_knots, Q(1));
  BOOST_CHECK(q.squared_deviation == Q(0));
  for (const Q& u : {Q(0), fraction(2, 7), Q(1)})
    BOOST_CHECK(q.surface(u, Q(8)) == cubic(u, Q(Q(8) - across_knots(u))));
  // from the opposite edge on, where the strip has no room before the curve
  const Function nearly_all{Q(1), fraction(79, 10)};
  const auto t = cut_back_within(s, v1, nearly_all, Q(100000000000.0));
  for (const Q& u : {Q(0), fraction(2, 7), Q(1)}) BOOST_CHECK(t.surface(u, Q(0)) == s(u, Q(0)));
}

// Curves of one parameter, curves that begin below a knot, and those whose coefficients lie beyond
// the edge.
BOOST_AUTO_TEST_CASE(other_curves) {
  Random_surfaces random;
  const Bspline<Exact> s = surface_with_knots<Bspline<Exact>>(random, 1);
  const Q tolerance(100000000000.0);
  for (const Function& f : {Function{fraction(5, 2)}, Function{fraction(5, 2), fraction(5, 2)},
                            Function{fraction(1, 2), fraction(21, 5)}, Function{Q(2), fraction(-1, 2), Q(2)}}) {
    const auto r = cut_back_within(s, v1, f, tolerance);
    BOOST_CHECK(Q(0) <= r.squared_deviation && r.squared_deviation <= tolerance * tolerance);
    for (const Q& u : {Q(0), fraction(2, 7), Q(1)}) {
      BOOST_CHECK(square_of_distance(r.surface(u, Q(8)), s(u, Q(Q(8) - f(u)))) <= r.squared_deviation);
      BOOST_CHECK(r.surface(u, Q(0)) == s(u, Q(0)));
    }
  }
  // the strip begins at the last knot below the curve
  const auto r = cut_back_within(s, v1, Function{fraction(1, 2), fraction(21, 5)}, tolerance);
  BOOST_CHECK(start_of_strip(r.surface.knots_v()) == Q(3));
}

BOOST_AUTO_TEST_CASE(errors) {
  Random_surfaces random;
  const Function f{fraction(1, 2), fraction(5, 2)};
  const Bspline<Exact> s = surface_with_knots<Bspline<Exact>>(random, 1),
                       jump = surface_with_knots<Bspline<Exact>>(random, 4);
  for (const Q& tolerance : {Q(0), Q(-1)}) CHECK_ERROR(cut_back_within(s, v1, f, tolerance), unreachable_tolerance);
  CHECK_ERROR(cut_back_within(jump, v1, Function{Q(2), Q(4)}, Q(1000000)), unreachable_tolerance);
  // a denominator that is positive, but not by its coefficients
  const Knots u(2, Q(0), Q(1)), v(1, Q(0), Q(2), {{Q(1), 1}});
  const Exact::Point o(0, 0, 0), x(1, 0, 0), y(0, 1, 0);
  const Spline<Exact> deep({{o, y, o}, {x, y, x}, {o, x, y}}, {{4, 4, 4}, {-1, -1, -1}, {4, 4, 4}}, u, v);
  CHECK_ERROR(cut_back_within(deep, v1, Function{fraction(1, 2), fraction(3, 2)}, Q(1000000)), unreachable_tolerance);
  for (const Function& bad : {Function{Q(0), Q(1)}, Function{Q(1), Q(8)}, Function{Q(1), Q(-1)}})
    CHECK_ERROR(cut_back_within(s, v1, bad, Q(1)), parameter_outside_domain);
}

TEST_FOR_EACH(kernels, Traits, All_traits) {
  typedef typename Traits::Point P;
  const GC::Knot_vector<FT> u(1, FT(0), FT(1)), v(2, FT(0), FT(4), {{FT(2), 1}, {FT(3), 1}});
  const Bspline<Traits> s({{P(0, 0, 0), P(0, 2, 0), P(0, 5, 1), P(0, 7, 3), P(0, 8, 4)},
                           {P(8, 0, 0), P(8, 2, 0), P(8, 5, 2), P(8, 7, 3), P(8, 8, 5)}},
                          u, v);
  const GC::Bernstein_polynomial<FT> f{FT(FT(1) / FT(2)), FT(FT(3) / FT(2))};
  const auto r = cut_back_within(s, v1, f, FT(FT(1) / FT(8)));
  BOOST_CHECK(FT(0) < r.squared_deviation && r.squared_deviation <= FT(FT(1) / FT(64)));
  const P p = r.surface(FT(1), FT(4)), q = s(FT(1), FT(FT(5) / FT(2)));
  FT square(0);
  for (int i = 0; i < 3; ++i) square += (p[i] - q[i]) * (p[i] - q[i]);
  BOOST_CHECK(square <= r.squared_deviation);
}

BOOST_AUTO_TEST_SUITE_END()
