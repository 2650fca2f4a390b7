// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The coarsest grid of 52 bits on which all coordinates of two ends lie, against one that is found
// bit by bit.

#include <CGAL/Geometric_continuity/numbers/internal/Common_grid.h>

#include "support/test.h"

#if defined(__GNUC__)

BOOST_AUTO_TEST_SUITE(common_grid)

template <std::size_t N> using Points = std::array<std::array<double, N>, 4>;

template <int k, std::size_t N> void check(const Points<N>& x, const Points<N>& y) {
  double largest = 0;
  const auto for_each = [&](const auto& f) {
    for (int j = 0; j <= k; ++j)
      for (std::size_t i = 0; i < N; ++i) f(x[j][i]), f(y[j][i]);
  };
  for_each([&](double c) { largest = (std::max)(largest, std::abs(c)); });
  const CGAL::Geometric_continuity::internal::Common_grid<k, N> grid(x, y);
  const auto all_on = [&](int exponent) {
    bool all = true;
    for_each([&](double c) {
      const double n = std::ldexp(c, -exponent);
      all = all && n == std::trunc(n);
    });
    return all;
  };
  const int e = largest == 0 ? -2000 : std::ilogb(largest);
  const bool valid = -400 <= e && e <= 500 && all_on(e - 51);
  BOOST_CHECK_EQUAL(grid.valid(), valid);
  if (valid) BOOST_CHECK(all_on(grid.exponent()) && !all_on(grid.exponent() + 1));
}

// Numbers of `bits` bits, the last of them a multiple of 2^exponent, k + 1 points of which the
// others are not looked at.
template <int k, std::size_t N> void check_random(std::mt19937_64& random, int bits, int exponent) {
  Points<N> x, y;
  for (Points<N>* points : {&x, &y})
    for (int j = 0; j < 4; ++j)
      for (double& c : (*points)[j]) {
        const double n = std::ldexp(static_cast<double>(random() >> (64 - bits)), exponent);
        c = j > k ? 0.1 : random() % 2 == 0 ? n : -n;
      }
  check<k, N>(x, y);
  y[k][N - 1] = std::ldexp(1, exponent - static_cast<int>(random() % 60)); // finer by some bits
  check<k, N>(x, y);
}

BOOST_AUTO_TEST_CASE(grids_of_numbers) {
  std::mt19937_64 random(2026);
  std::cout << "seed 2026\n";
  for (int bits = 1; bits <= 53; ++bits)
    for (int exponent : {-1074, -500, -460, -440, -400, -30, 0, 30, 440, 460, 500, 900}) {
      check_random<1, 2>(random, bits, exponent);
      check_random<2, 2>(random, bits, exponent);
      check_random<2, 3>(random, bits, exponent);
      check_random<3, 3>(random, bits, exponent);
    }
  check<2, 2>({}, {});
}

BOOST_AUTO_TEST_SUITE_END()

#endif
