// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Rounded numbers are what printf() writes with %g, in each rounding mode of the processor.
#define BOOST_TEST_MODULE words
#include "reports/words.h"

#include "Geometric_continuity/support/random.h"

#include <boost/test/unit_test.hpp>

#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>

namespace {

struct Random : Random_integers<std::mt19937_64> {
  // Any number of digits before and behind the point, also next to powers of ten and to middles
  // between two rounded numbers.
  double number() {
    const double digits = static_cast<double>(integer(std::int64_t(-2000000), 2000000)),
                 power = std::pow(10., integer(-12, 12));
    switch (integer(0, 4)) {
    case 0: return std::ldexp(digits, integer(-70, 40));
    case 1: return digits * power;
    case 2: return digits / power;
    case 3: return std::nextafter(power, digits);
    default: return power * (1 - std::pow(10., integer(-9, 0)) / 2);
    }
  }
};

void check(double x, int digits) {
  char expected[64];
  std::snprintf(expected, sizeof expected, "%.*g", digits, x == 0 ? 0. : x);
  for (const int mode : {FE_TONEAREST, FE_UPWARD}) {
    std::fesetround(mode);
    const std::string text = rounded(x, digits);
    std::fesetround(FE_TONEAREST);
    BOOST_REQUIRE_EQUAL(text, expected);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(rounded_as_printf) {
  Random random;
  for (int i = 0; i < 200000; ++i) check(random.number(), random.integer(1, 9));
  for (const double x : {0., -0., 1., -1., 1e-4, 9.9995, 0.00099995, 2.5, 999999.5, 1e300, 5e-324,
                         std::numeric_limits<double>::infinity()})
    for (int digits = 1; digits <= 9; ++digits) check(x, digits);
}
