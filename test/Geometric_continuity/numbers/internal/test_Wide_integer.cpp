// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Integers of at most 512 bits: the same results as by integers of GMP.

#include <CGAL/Geometric_continuity/numbers/internal/Wide_integer.h>

#include "support/random.h"

#include <gmpxx.h>

#include <vector>

BOOST_AUTO_TEST_SUITE(Wide_integer)

typedef GC::internal::Wide_integer Wide;
typedef mpz_class Integer;

int size(const Integer& x) { return x == 0 ? 0 : static_cast<int>(mpz_sizeinbase(x.get_mpz_t(), 2)); }

Wide wide(const Integer& x) {
  const Integer absolute = abs(x);
  Wide y;
  for (int bit = size(x) / 60 * 60; bit >= 0; bit -= 60)
    y = (y << 60) + Wide(Integer((absolute >> bit) & 0xfffffffffffffff).get_si());
  return x < 0 ? -y : y;
}

void check(const Wide& x, const Integer& expected) {
  const Wide y = wide(expected);
  BOOST_CHECK(x <= y && y <= x);
  BOOST_CHECK_EQUAL(x.bits(), size(expected));
  BOOST_CHECK_EQUAL(x.is_zero(), expected == 0);
  BOOST_CHECK_EQUAL(x < Wide(0), expected < 0);
}

void check_operations(const Integer& x, const Integer& y) {
  const Wide a = wide(x), b = wide(y);
  BOOST_CHECK_EQUAL(a < b, x < y);
  BOOST_CHECK_EQUAL(a <= b, x <= y);
  check(-a, -x);
  check(abs(a), abs(x));
  if (size(x) < 512 && size(y) < 512) {
    check(a + b, x + y);
    check(a - b, x - y);
    Wide sum = a, difference = a;
    check(sum += b, x + y);
    check(difference -= b, x - y);
  }
  if (size(x) + size(y) <= 512) {
    Wide product = a;
    check(product *= b, x * y);
  }
}

// The numbers have any length, and many equal digits, so that sums carry.
Integer random_integer(std::mt19937_64& random, int most_bits) {
  Integer x = 0;
  for (int bits = 0; bits < most_bits; bits += 64)
    x = x << 64 | (random() % 4 == 0 ? std::uint64_t(0) : random() % 4 == 0 ? ~std::uint64_t(0) : random());
  x = (x & ((Integer(1) << most_bits) - 1)) >> random() % most_bits;
  return random() % 2 == 0 ? x : Integer(-x);
}

BOOST_AUTO_TEST_CASE(numbers_at_the_ends_of_words) {
  std::vector<Integer> numbers{Integer(0)};
  for (const int k : {0, 1, 31, 32, 33, 63, 64, 96, 255, 256, 480, 510, 511})
    for (const int d : {-1, 0, 1}) {
      numbers.push_back((Integer(1) << k) + d);
      numbers.push_back(-numbers.back());
    }
  for (const Integer& x : numbers)
    for (const Integer& y : numbers) check_operations(x, y);
  for (const std::int64_t x : {INT64_MIN, INT64_MIN + 1, INT64_MAX}) check(Wide(x), Integer(x));
}

BOOST_AUTO_TEST_CASE(random_numbers) {
  const unsigned seed = first_seed();
  std::cout << "random seed " << seed << '\n';
  std::mt19937_64 random(seed);
  for (int i = 0; i < 3000; ++i) {
    const int bits = i % 2 == 0 ? 256 : 511;
    const Integer x = random_integer(random, bits), y = random_integer(random, bits);
    check_operations(x, y);
    check_operations(x, x);
    check_operations(x, -x);
    const std::uint32_t divisor = static_cast<std::uint32_t>(random() >> (32 + random() % 31)) | 1;
    check(wide(x) / divisor, x / divisor);
    const int left = static_cast<int>(random() % (513 - size(x))), right = static_cast<int>(random() % 512);
    check(wide(x) << left, x << left);
    check(wide(x) >> right, x < 0 ? Integer(-(-x >> right)) : Integer(x >> right));
  }
}

BOOST_AUTO_TEST_SUITE_END()
