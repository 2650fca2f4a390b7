// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Rounded numbers are what printf() writes with %g, in each rounding mode of the processor.
#define BOOST_TEST_MODULE words
#include "support/random.h"

#include "reports/words.h"
#include <cfenv>
#include <cstdio>

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

// Two numbers have one text by products only where each has it.
bool check_both(double x, double y, int digits) {
  const std::string text = rounded_by_product(x, y, digits);
  if (!text.empty()) {
    check(x, digits);
    check(y, digits);
    BOOST_REQUIRE_EQUAL(text, rounded(x, digits));
    BOOST_REQUIRE_EQUAL(text, rounded(y, digits));
  }
  return !text.empty();
}

} // namespace

BOOST_AUTO_TEST_CASE(rounded_as_printf) {
  Random random;
  for (int i = 0; i < 200000; ++i) check(random.number(), random.integer(1, 9));
  for (const double x : {0., -0., 1., -1., 1e-4, 9.9995, 0.00099995, 2.5, 999999.5, 1e300, 5e-324,
                         std::numeric_limits<double>::infinity()})
    for (int digits = 1; digits <= 9; ++digits) check(x, digits);
}

BOOST_AUTO_TEST_CASE(rounded_together) {
  Random random;
  int found = 0;
  for (int i = 0; i < 100000; ++i) {
    const double x = random.number(), y = x * (1 + std::pow(10., -random.integer(1, 12)));
    const int digits = random.integer(1, 6);
    found += check_both(x, y, digits) + check_both(y, x, digits);
    BOOST_REQUIRE(!check_both(x, -x, digits) || x == 0);
  }
  BOOST_CHECK_GT(found, 10000);
  BOOST_CHECK(check_both(12.341, 12.344, 4) && check_both(-0.5, -0.5, 3));
  BOOST_CHECK(!check_both(12.344, 12.346, 4) && !check_both(12.336, 12.344, 4) && !check_both(12.34, 123.4, 4));
}
