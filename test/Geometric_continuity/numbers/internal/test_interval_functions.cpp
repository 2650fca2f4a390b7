// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Sine, cosine and exponential function of intervals, against those of long numbers.

#include "support/random.h"

#include <CGAL/Geometric_continuity/numbers/internal/interval_functions.h>
#include <CGAL/Geometric_continuity/numbers/internal/subdivision.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

BOOST_AUTO_TEST_SUITE(interval_functions)

using GC::internal::Cosine_and_sine;
typedef CGAL::Interval_nt<false> Interval;
typedef boost::multiprecision::cpp_bin_float_100 Long;

bool encloses(const Interval& i, const Long& x) { return Long(i.inf()) <= x && x <= Long(i.sup()); }

// By numbers of 100 digits; they are computed when roundings are to the nearest.
struct Checks {
  int wrong = 0, wide = 0;

  void point(double x) {
    const Long c = cos(Long(x)), s = sin(Long(x));
    const CGAL::Protect_FPU_rounding<true> upwards;
    const Cosine_and_sine cs = GC::internal::cosine_and_sine(x);
    wrong += !encloses(cs.cosine, c) + !encloses(cs.sine, s);
    const double width = 1e-15 + std::fabs(x) * 1e-26;
    wide += !(cs.cosine.sup() - cs.cosine.inf() <= width) + !(cs.sine.sup() - cs.sine.inf() <= width);
  }
  void range(double x, double y) {
    const Long c[] = {cos(Long(x)), cos(Long(y)), cos(Long(x / 2 + y / 2))},
               s[] = {sin(Long(x)), sin(Long(y)), sin(Long(x / 2 + y / 2))};
    const CGAL::Protect_FPU_rounding<true> upwards;
    const Cosine_and_sine cs = GC::internal::cosine_and_sine(Interval(x, y));
    for (int i = 0; i < 3; ++i) wrong += !encloses(cs.cosine, c[i]) + !encloses(cs.sine, s[i]);
    for (const Interval& i : {cs.cosine, cs.sine}) {
      wide += !(i.sup() - i.inf() <= 2.1 * (y - x) + 1e-14);
      wrong += !(-1 <= i.inf() && i.sup() <= 1);
    }
  }
  void power(double x) {
    const Long e = exp(Long(x));
    const CGAL::Protect_FPU_rounding<true> upwards;
    const Interval i = GC::internal::exponential(x);
    wrong += !encloses(i, e);
    wide += !(i.sup() - i.inf() <= i.sup() * 1e-15 * (8 + 8 * std::fabs(x)));
  }
};

BOOST_AUTO_TEST_CASE(enclose_the_values) {
  const unsigned seed = first_seed();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> near(-8, 8), far(-5e5, 5e5), tiny(-1e-9, 1e-9), length(0, 1),
      exponent(-50, 50);
  Checks checks;
  for (int i = 0; i < 300; ++i) {
    checks.point(near(random));
    checks.point(far(random));
    checks.point(tiny(random));
    checks.point(std::floor(near(random)) * 0.7853981633974483 +
                 1e-7 * tiny(random)); // at zeros, and where the quarter changes
    const double x = near(random);
    checks.range(x, x + length(random));
    checks.range(x, x + 1e-9 * length(random));
    checks.power(exponent(random));
    checks.power(tiny(random));
  }
  BOOST_TEST_CONTEXT("seed " << seed) {
    BOOST_TEST(checks.wrong == 0);
    BOOST_TEST(checks.wide == 0);
  }
}

BOOST_AUTO_TEST_CASE(of_numbers_without_bounds) {
  const CGAL::Protect_FPU_rounding<true> upwards;
  const double infinite = (std::numeric_limits<double>::infinity)();
  for (const Interval& x : {Interval(-infinite, infinite), Interval(0, infinite), Interval(1e300), Interval(0, 7)}) {
    const Cosine_and_sine cs = GC::internal::cosine_and_sine(x);
    BOOST_TEST((cs.cosine.inf() == -1 && cs.cosine.sup() == 1 && cs.sine.inf() == -1 && cs.sine.sup() == 1));
  }
  for (double x : {1e6, -1e300, infinite, std::nan("")}) {
    const Cosine_and_sine cs = GC::internal::cosine_and_sine(x);
    BOOST_TEST((cs.cosine.inf() == -1 && cs.cosine.sup() == 1 && cs.sine.inf() == -1 && cs.sine.sup() == 1));
  }
  BOOST_TEST(GC::internal::exponential(Interval(-1e4, 1e4)).inf() >= 0);
  BOOST_TEST(GC::internal::exponential(1e4).sup() == infinite);
}

// Neighbouring numbers have nothing between them, whichever of them their mean is rounded to.
BOOST_AUTO_TEST_CASE(ranges_of_neighbours) {
  double x = 1;
  for (int i = 0; i < 4; ++i) {
    const double next = std::nextafter(x, 2.), second = std::nextafter(next, 2.);
    BOOST_TEST(!(GC::internal::Range{x, next}.is_divisible()));
    BOOST_TEST((GC::internal::Range{x, second}.is_divisible()));
    x = next;
  }
}

BOOST_AUTO_TEST_SUITE_END()
