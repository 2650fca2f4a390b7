// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Parts of fractions, and sums of short ones.

#include "support/random.h"

#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

BOOST_AUTO_TEST_SUITE(rational_numbers)

struct Random : Random_integers<std::mt19937_64> {
  // With a numerator and a denominator of up to 40 bits, often a power of ten.
  Q fraction() {
    const std::int64_t powers[] = {1, 10, 100, 1000000, integer(std::int64_t(1), std::int64_t(1) << integer(1, 40))};
    const std::int64_t most = std::int64_t(1) << integer(1, 40);
    return Q(integer(-most, most)) / Q(powers[integer(0, 4)]);
  }
};

// Tries the same numbers in lowest terms, short or not.
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

// The root of a square, of fractions in any terms, and of nothing else.
BOOST_AUTO_TEST_CASE(square_roots) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Q x = random.fraction(), square = x * x;
    BOOST_REQUIRE(GC::rational_square_root(square) == (x < 0 ? Q(-x) : x));
    if (x != 0) {
      BOOST_REQUIRE(!GC::rational_square_root(Q(2 * square)) && !GC::rational_square_root(Q(-square)));
      BOOST_REQUIRE(!GC::rational_square_root(Q(square / 3)));
    }
  }
  BOOST_CHECK(GC::rational_square_root(Q(0)) == Q(0) && GC::rational_square_root(2.25) == 1.5);
  BOOST_CHECK(!GC::rational_square_root(-1.));
}

// The quarter turns of an angle, and the rest up to 45 degrees, also of negative angles and of many
// turns.
BOOST_AUTO_TEST_CASE(quarter_turns) {
  for (int degrees = -1000; degrees <= 1000; ++degrees) {
    const GC::Quarter_turns<Q> turns(Q(degrees) + Q(1) / 3);
    BOOST_REQUIRE(0 <= turns.count && turns.count <= 3);
    BOOST_REQUIRE(Q(-45) <= turns.rest && turns.rest <= Q(45));
    const Q full = (Q(degrees) + Q(1) / 3 - turns.rest - 90 * turns.count) / 360;
    BOOST_REQUIRE(full == Q(std::lround(CGAL::to_double(full))));
  }
  CHECK_ERROR(GC::Quarter_turns<Q>(Q(1000000001)), parameter_outside_domain);
  CHECK_ERROR(GC::Quarter_turns<Q>(Q(-1000000001)), parameter_outside_domain);
}

BOOST_AUTO_TEST_SUITE_END()
