// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Parts of fractions, and sums of short ones.

#include "support/random.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <sstream>
#include <string>
#include <type_traits>

BOOST_AUTO_TEST_SUITE(rational_numbers)

namespace GC = CGAL::Geometric_continuity;

typedef CGAL::Exact_rational Q;

namespace {

template <class T> std::string text(const T& x) {
  std::ostringstream os;
  os << x;
  return os.str();
}

struct Random : Random_integers<std::mt19937_64> {
  // With a numerator and a denominator of up to 40 bits, often a power of ten.
  Q fraction() {
    const std::int64_t powers[] = {1, 10, 100, 1000000, integer(std::int64_t(1), std::int64_t(1) << integer(1, 40))};
    const std::int64_t most = std::int64_t(1) << integer(1, 40);
    return Q(integer(-most, most)) / Q(powers[integer(0, 4)]);
  }
};

} // namespace

// The same numbers in lowest terms, short or not.
BOOST_AUTO_TEST_CASE(sums) {
  Random random;
  for (int i = 0; i < 20000; ++i) {
    const Q x = random.fraction(), y = random.integer(0, 9) == 0 ? Q(-x) : random.fraction(), sum = x + y;
    BOOST_REQUIRE_EQUAL(text(GC::short_sum(x, y)), text(sum));
  }
  const Q limit((std::int64_t(1) << 30) - 1), beyond(limit + 1);
  for (const Q& x : {limit, beyond, Q(-limit), Q(-beyond), Q(1 / limit), Q(1 / beyond)})
    for (const Q& y : {limit, beyond, Q(-limit), Q(-beyond), Q(1 / limit), Q(1 / beyond), Q(0)})
      BOOST_CHECK_EQUAL(text(GC::short_sum(x, y)), text(Q(x + y)));
  BOOST_CHECK_EQUAL(GC::short_sum(0.25, 0.5), 0.75);
}

BOOST_AUTO_TEST_CASE(bits) {
  const Q large = Q(std::int64_t(1) << 62) * Q(4); // 2^64
  BOOST_CHECK(GC::has_short_parts<65>(large) && !GC::has_short_parts<64>(large));
  BOOST_CHECK(GC::has_short_parts<65>(Q(1 / large)) && !GC::has_short_parts<64>(Q(1 / large)));
  BOOST_CHECK(GC::has_short_parts<64>(Q(large - 1)) && GC::has_short_parts<64>(Q(1 - large)));
  BOOST_CHECK(GC::has_short_parts<64>(1e300));
}

BOOST_AUTO_TEST_SUITE_END()
