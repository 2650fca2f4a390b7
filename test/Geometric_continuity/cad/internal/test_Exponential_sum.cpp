// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Identities between sums of exponential functions, which hold or fail exactly.

#define BOOST_TEST_MODULE Exponential_sum
#include <boost/test/unit_test.hpp>

#include <CGAL/Geometric_continuity/cad/internal/Exponential_sum.h>

#include <random>

namespace I = CGAL::Geometric_continuity::internal;
typedef I::Exponential_sum Sum;
typedef I::Model_number Q;

BOOST_AUTO_TEST_CASE(identities) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-3, 3);
  for (int round = 0; round < 20; ++round) {
    const I::Linear_function x{Q(unit(random)), Q(unit(random))}, y{Q(unit(random)), Q(unit(random))},
        sum{Q(x.constant + y.constant), Q(x.slope + y.slope)};
    const Sum cx = Sum::cosine(x), sx = Sum::sine(x), cy = Sum::cosine(y), sy = Sum::sine(y), one = Q(1);
    BOOST_TEST((cx * cx + sx * sx == one));
    BOOST_TEST((Sum::cosine(sum) == cx * cy - sx * sy));
    BOOST_TEST((Sum::sine(sum) == cx * sy + sx * cy));
    BOOST_TEST((cx.derivative() == Sum(Q(-x.slope)) * sx));
    BOOST_TEST(((Sum(y) * sx).derivative() == Sum(y.slope) * sx + Sum(Q(x.slope)) * Sum(y) * cx));
    BOOST_TEST(!(cx == cy));
    BOOST_TEST(!(cx * cx + sx * sx * Sum(Q(1 + 0x1p-52)) == one));
    BOOST_TEST((cx - cx).is_zero());
  }
  // numbers without a parameter: no sum of cosines of different rational numbers is rational
  const auto cosine = [](double w) { return Sum::cosine({Q(w), Q(0)}); };
  BOOST_TEST((cosine(0) == Sum(Q(1))));
  BOOST_TEST((cosine(2) == Sum(Q(2)) * cosine(1) * cosine(1) - Sum(Q(1))));
  BOOST_TEST(!(cosine(1e-200) == Sum(Q(1))));
  BOOST_TEST((cosine(1) == cosine(-1)));
}

BOOST_AUTO_TEST_CASE(signs) {
  const I::Linear_function t{Q(0), Q(1)};
  const Sum cosine = Sum::cosine(t), x = t;
  BOOST_TEST((cosine.sign_on(-1.57, 1.57) == 1));
  BOOST_TEST((cosine.sign_on(1.5708, 4.71) == -1));
  BOOST_TEST(!cosine.sign_on(-1.57, 1.58));
  BOOST_TEST(!cosine.sign_on(-4, 4.2)); // another sign at the start than in the middle
  BOOST_TEST(!(x * x).sign_on(-1, 1));
  BOOST_TEST(!x.sign_on(0, 1));
  BOOST_TEST((x.sign_on(1e-9, 1) == 1));
  BOOST_TEST(((x * x + Sum(Q(1e-3))).sign_on(-1, 1) == 1));
  BOOST_TEST(!Sum().sign_on(0, 1));
}
