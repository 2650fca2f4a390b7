// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Degrees and percent: the enclosures hold, proved by exact numbers, in every rounding mode, and
// are narrow.

#include "support/enclosures.h"
#include "support/rounding_modes.h"

BOOST_AUTO_TEST_SUITE(units)

using enclosures::ulps;

// arctan(1/n) lies between two partial sums of its alternating series.
std::pair<Q, Q> arctan_of_inverse(int n) {
  Q power = Q(1) / Q(n), sum(0), previous(0);
  for (int k = 0; k < 40; ++k) {
    previous = sum;
    sum += (k % 2 == 0 ? power : Q(-power)) / Q(2 * k + 1);
    power /= Q(n * n);
  }
  return {sum < previous ? sum : previous, sum < previous ? previous : sum};
}

// pi = 16 arctan(1/5) - 4 arctan(1/239), to more than 50 digits.
std::pair<Q, Q> pi() {
  const std::pair<Q, Q> a = arctan_of_inverse(5), b = arctan_of_inverse(239);
  return {Q(16) * a.first - Q(4) * b.second, Q(16) * a.second - Q(4) * b.first};
}

BOOST_AUTO_TEST_CASE(random_angles_and_ratios) {
  std::cout << "seed 17\n";
  std::mt19937_64 random(17);
  const std::pair<Q, Q> half_turn = pi();
  BOOST_REQUIRE(half_turn.first < half_turn.second && Q(half_turn.second - half_turn.first) < Q(1e-50));
  for (int i = 0; i < 400; ++i) {
    const int mode = rounding_mode(i);
    const double digits = double(random() >> 11), x = std::ldexp(digits, -53 - static_cast<int>(random() % 200));
    const GC::Enclosure degrees = in_rounding_mode(mode, [&] { return GC::in_degrees({x, x}); });
    BOOST_CHECK(Q(degrees.lower) * half_turn.second <= Q(x) * Q(180));
    BOOST_CHECK(Q(x) * Q(180) <= Q(degrees.upper) * half_turn.first);
    BOOST_CHECK(ulps(degrees) <= 4);
    const GC::Enclosure percent = in_rounding_mode(mode, [&] { return GC::in_percent({x, 2 * x}); });
    BOOST_CHECK(Q(percent.lower) <= Q(100) * Q(x) && Q(200) * Q(x) <= Q(percent.upper));
    BOOST_CHECK(percent.lower == percent.upper / 2 || ulps(GC::in_percent({x, x})) == 1);
  }
}

// So many that mistakes in the last digits of pi/180 show.
BOOST_AUTO_TEST_CASE(random_decimals) {
  std::cout << "seed 18\n";
  std::mt19937_64 random(18);
  const std::pair<Q, Q> half_turn = pi();
  const auto is_below = [&](double bound, const Q& angle) { // bound <= angle pi / 180
    return Q(bound) * Q(180) <= angle * (angle < 0 ? half_turn.second : half_turn.first);
  };
  for (int i = 0; i < 4000; ++i) {
    const int mode = rounding_mode(i);
    const Q decimal = Q(static_cast<int>(random() % 2000001) - 1000000) / Q(100000);
    const GC::Enclosure radians = in_rounding_mode(mode, [&] { return GC::in_radians(decimal); });
    BOOST_CHECK(is_below(radians.lower, decimal) && is_below(-radians.upper, Q(-decimal)));
    BOOST_CHECK(ulps(radians) <= 2);
  }
}

BOOST_AUTO_TEST_CASE(special_values) {
  BOOST_CHECK(GC::in_radians(0) == (GC::Enclosure{0, 0}));
  BOOST_CHECK(GC::in_degrees({0, 0}) == (GC::Enclosure{0, 0}));
  BOOST_CHECK(GC::in_percent({0, 0.25}) == (GC::Enclosure{0, 25})); // exact numbers stay exact
  const double most = (std::numeric_limits<double>::max)();
  BOOST_CHECK(GC::in_percent({1, infinity}) == (GC::Enclosure{100, infinity}));
  BOOST_CHECK(GC::in_percent({most, most}) == (GC::Enclosure{most, infinity}));
  CHECK_ERROR(GC::in_percent({infinity, infinity}), not_finite);
  const GC::Enclosure right_angle = GC::in_radians(90), back = GC::in_degrees(right_angle);
  BOOST_CHECK(back.lower < 90 && 90 < back.upper && back.upper - back.lower < 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()
