// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Zero bits at the ends of words: as counted one by one, with the functions of the compiler and
// without.

#include <CGAL/Geometric_continuity/numbers/internal/zero_bits.h>

#include "support/random.h"

BOOST_AUTO_TEST_SUITE(zero_bits)

void check_word(std::uint64_t x) {
  int trailing = 0, leading = 0;
  while ((x >> trailing & 1) == 0) ++trailing;
  while ((x >> (63 - leading) & 1) == 0) ++leading;
  BOOST_CHECK_EQUAL(GC::internal::trailing_zero_bits(x), trailing);
  BOOST_CHECK_EQUAL(GC::internal::leading_zero_bits(x), leading);
  BOOST_CHECK_EQUAL(GC::internal::trailing_zero_bits_by_halves(x), trailing);
  BOOST_CHECK_EQUAL(GC::internal::leading_zero_bits_by_halves(x), leading);
}

BOOST_AUTO_TEST_CASE(from_every_bit_to_every_bit) {
  for (int high = 0; high < 64; ++high)
    for (int low = 0; low <= high; ++low) check_word(std::uint64_t(1) << high | std::uint64_t(1) << low);
}

BOOST_AUTO_TEST_CASE(random_words) {
  const unsigned seed = first_seed();
  std::cout << "random seed " << seed << '\n';
  std::mt19937_64 random(seed);
  for (int i = 0; i < 2000; ++i) check_word((random() | std::uint64_t(1) << 63) >> (random() % 64));
}

BOOST_AUTO_TEST_SUITE_END()
