// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Representable blends that aim at the fair one: exactly G2, and almost as fair.

#include "support/decided_joins.h"
#include "support/fairness.h"
#include "support/test.h"

#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/representable_blend.h>

BOOST_AUTO_TEST_SUITE(Fair_representable)

typedef std::tuple<Epick_2, Epick_3> Traits_classes;

// A cubic from about x = from to from + 3, on the grid.
template <class Traits> GC::Bezier_curve<Traits> cubic(std::mt19937_64& random, double from, int grid) {
  constexpr int N = Traits::Dimension::value;
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<typename Traits::Point> points;
  for (int i = 0; i < 4; ++i) {
    GC::Coordinate_vector<double, N> p;
    for (int c = 0; c < N; ++c) {
      const double x = c == 0 ? from + i + 0.3 * number(random) : number(random);
      p[c] = std::ldexp(std::nearbyint(std::ldexp(x, grid)), -grid);
    }
    points.push_back(GC::to_point<Traits>(p));
  }
  return GC::Bezier_curve<Traits>(points.begin(), points.end());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(almost_as_fair, Traits, Traits_classes) {
  double largest = 0;
  for (unsigned seed : {1U, 4U, 5U, 7U}) { // with blends that need a precise shape
    std::mt19937_64 random(seed);
    for (int i = 0; i < 102; ++i) {
      BOOST_TEST_CONTEXT("seed " << seed << ", pair " << i) {
        const int grid = 20 + i % 17;
        const GC::Bezier_curve<Traits> phi = cubic<Traits>(random, -3, grid), psi = cubic<Traits>(random, 2, grid);
        const GC::Representable_blend<Traits> gamma = GC::representable_blend(phi, psi, GC::Fair());
        BOOST_CHECK(decide_g2_join(gamma.phi, gamma) && decide_g2_join(gamma, gamma.psi));
        if (grid < 36) BOOST_CHECK(!gamma.start_join.is_moved() && !gamma.end_join.is_moved());
        const double ratio = fairness(static_cast<const GC::Bezier_curve<Traits, 5>&>(gamma)) /
                             fairness(GC::blend(phi, psi, GC::Fair()));
        largest = (std::max)(largest, ratio);
        BOOST_CHECK_LE(ratio, 1.1);
      }
    }
  }
  BOOST_TEST_MESSAGE("E / E of the fair blend: largest " << largest);
}

BOOST_AUTO_TEST_SUITE_END()
