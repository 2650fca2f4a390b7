// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The inflections of pieces of plane fair splines: graphs of functions of degree 5 with second
// derivatives of known roots.

#include "support/test.h"

#include <CGAL/Geometric_continuity/blends/internal/inflections.h>

BOOST_AUTO_TEST_SUITE(inflections)

BOOST_AUTO_TEST_CASE(graphs_with_known_roots) {
  typedef CGAL::Simple_cartesian<double> K;
  typedef GC::Bernstein_polynomial<CGAL::Exact_rational> Polynomial;
  constexpr unsigned seed = 2026;
  BOOST_TEST_MESSAGE("seed " << seed);
  std::mt19937 engine(seed);
  for (int n = 0; n < 3000; ++n) {
    std::array<int, 3> roots; // in 64ths; with equal ones, and some at 0 and 1 or beyond
    for (int& x : roots) x = static_cast<int>(engine() % 80) - 8;
    if (n % 4 == 1) roots[1] = roots[0] + (n % 8 < 4 ? 0 : 1);
    Polynomial second({CGAL::Exact_rational(3 * 64 * 64 * 64)});
    for (const int x : roots)
      second = second * Polynomial({CGAL::Exact_rational(-x, 64), CGAL::Exact_rational(64 - x, 64)});
    std::array<double, 6> y{};
    for (int i = 0; i < 4; ++i) y[i + 2] = 2 * y[i + 1] - y[i] + CGAL::to_double(second[i]);
    const double unit = std::ldexp(1., n % 3 == 0 ? 0 : n % 3 == 1 ? 600 : -600);
    std::vector<K::Point_2> points;
    for (int i = 0; i < 6; ++i) points.emplace_back(1000 * i * unit, y[i] * unit);
    const GC::Bezier_curve<GC::Traits_2<K>, 5> graph(points.begin(), points.end());

    int expected = 0;
    for (const int x : std::set<int>(roots.begin(), roots.end()))
      expected += 0 < x && x < 64 && std::count(roots.begin(), roots.end(), x) % 2 == 1;
    const auto sign_beside = [&](double u) {
      int sign = 1;
      for (const int x : roots) sign *= u < x ? -1 : 1;
      return sign;
    };
    const GC::internal::Inflections found = GC::internal::inflections_of(graph, 0);
    BOOST_CHECK_EQUAL(found.number, expected);
    BOOST_CHECK_EQUAL(found.first, sign_beside(0.5));
    BOOST_CHECK_EQUAL(found.last, sign_beside(63.5));
    // the number of changes will do where it is wanted
    BOOST_CHECK_LE(expected, GC::internal::inflections_of(graph, 1).number);
  }
}

BOOST_AUTO_TEST_SUITE_END()
