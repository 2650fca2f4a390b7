// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Remainders by several moduli: the moduli are those that are documented and suffice for all joins,
// and the arithmetic is that of integers.

#include <CGAL/Geometric_continuity/numbers/internal/Remainder.h>

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

#include "support/random.h"

#include <boost/multiprecision/cpp_int.hpp>

BOOST_AUTO_TEST_SUITE(Remainder)

typedef GC::internal::Remainder R;
typedef boost::multiprecision::cpp_int Integer;

const std::uint16_t (&moduli)[std::size(GC::internal::remainder_moduli)] = GC::internal::remainder_moduli;

Integer modulus(std::uint64_t c) { return (Integer(1) << 64) - c; }
std::uint64_t remainder(const Integer& x, std::uint64_t c) {
  Integer r = x % modulus(c);
  if (r < 0) r += modulus(c);
  return static_cast<std::uint64_t>(r);
}
R number(const Integer& x, std::uint64_t c) { return R(remainder(x, c), c); }

// Remainders at both ends of the range, and anywhere.
std::vector<std::uint64_t> samples(std::uint64_t c, std::mt19937_64& random) {
  std::vector<std::uint64_t> x{0, 1, 2, c, std::uint64_t(1) << 32, std::uint64_t(1) << 63};
  for (const std::uint64_t below : {1, 2, 3}) x.push_back(static_cast<std::uint64_t>(modulus(c) - below));
  for (int i = 0; i < 20; ++i) x.push_back(remainder(random() >> random() % 64, c));
  return x;
}

// Each modulus is the largest below those before it that has no common divisor with any of them, so
// that their product is 2^28160 but for a factor next to 1.
BOOST_AUTO_TEST_CASE(moduli_have_no_common_divisors) {
  Integer product = 1;
  std::uint64_t c = 0;
  for (const std::uint16_t given : moduli) {
    while (gcd(Integer(product % modulus(c)), modulus(c)) != 1) ++c;
    BOOST_TEST_REQUIRE(given == c);
    product *= modulus(c);
  }
  BOOST_TEST(std::size(moduli) == 440u);
  BOOST_TEST((msb(product) == 28159u));
}

BOOST_AUTO_TEST_CASE(arithmetic) {
  std::mt19937_64 random(first_seed());
  for (std::size_t i = 0; i < std::size(moduli); i += 10) {
    const std::uint64_t c = moduli[i];
    for (const std::uint64_t x : samples(c, random)) {
      for (const std::uint64_t y : samples(c, random)) {
        BOOST_REQUIRE(R(x, c) + R(y, c) == number(Integer(x) + y, c));
        BOOST_REQUIRE(R(x, c) - R(y, c) == number(Integer(x) - y, c));
        BOOST_REQUIRE(R(x, c) * R(y, c) == number(Integer(x) * y, c));
        BOOST_REQUIRE((R(x, c) == R(y, c)) == (x == y));
      }
      for (const std::uint64_t small : {0, 1, 2, 1 << 20}) { // without a modulus, on either side
        BOOST_REQUIRE(R(x, c) * R(small) == number(Integer(x) * small, c));
        BOOST_REQUIRE(R(small) - R(x, c) == number(Integer(small) - x, c));
        BOOST_REQUIRE(R(small) + R(x, c) == number(Integer(small) + x, c));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(remainders_of_long_numbers) {
  std::mt19937_64 random(first_seed());
  for (const std::uint64_t c : moduli)
    for (int i = 0; i < 100; ++i) {
      const std::uint64_t high = i % 4 == 0 ? ~std::uint64_t(0) : random(),
                          low = i % 3 == 0 ? ~std::uint64_t(i % 5) : random();
      const Integer x = (Integer(high) << 64) + low;
      BOOST_REQUIRE(R::of(static_cast<GC::internal::Unsigned_128>(high) << 64 | low, c) == number(x, c));
    }
}

// The numbers are doubles in one unit, from the smallest one to the largest.
BOOST_AUTO_TEST_CASE(doubles_of_all_sizes) {
  std::mt19937_64 random(first_seed());
  for (const int range : {0, 8, 100, 2000}) {
    GC::internal::Remainder_scale scale;
    std::vector<double> x{0};
    for (int e = 0; e <= range; e += 64) x.push_back(std::ldexp(1., e - range / 2));
    for (int i = 0; i < 20; ++i) {
      const double n = static_cast<double>(static_cast<std::int64_t>(random()) >> (11 + random() % 40));
      x.push_back(std::ldexp(n, static_cast<int>(random() % (range + 1)) - range / 2));
    }
    if (range == 2000) x.insert(x.end(), {0x1p-1074, -0x1.fffffffffffffp1023});
    BOOST_TEST(scale.bits() == 0);
    for (const double y : x) scale.include(scale.number(y));
    const int smallest = range == 2000 ? -1074 : -range / 2; // as one of the numbers is odd there
    Integer largest = 0;
    std::vector<Integer> wholes;
    for (const double y : x) {
      int e;
      const std::int64_t n = static_cast<std::int64_t>(std::ldexp(std::frexp(y, &e), 53));
      const int shift = e - 53 - smallest;
      wholes.push_back(shift >= 0 ? Integer(Integer(n) << shift) : Integer(Integer(n) / (Integer(1) << -shift)));
      if (abs(wholes.back()) > largest) largest = abs(wholes.back());
    }
    BOOST_TEST(scale.bits() == static_cast<int>(msb(largest)) + 1);
    for (int i = 0; i < static_cast<int>(std::size(moduli)); i += 7) {
      scale.take_modulus(i);
      BOOST_REQUIRE(scale.one() == R(1));
      for (std::size_t j = 0; j < x.size(); ++j)
        BOOST_REQUIRE(scale.numerator(scale.number(x[j])) == number(wholes[j], moduli[i]));
    }
  }
}

BOOST_AUTO_TEST_CASE(bits_of_one_number) {
  for (const auto& [x, bits] :
       {std::pair<double, int>{0., 0}, {1, 1}, {-1024, 1}, {3, 2}, {0x1.fffffffffffffp-1000, 53}}) {
    GC::internal::Remainder_scale scale;
    scale.include(scale.number(x));
    BOOST_TEST(scale.bits() == bits);
  }
}

// The product of so many moduli is greater than 2^bits, and no fewer would do.
BOOST_AUTO_TEST_CASE(as_many_moduli_as_needed) {
  Integer product = 1;
  for (int n = 0; n < static_cast<int>(std::size(moduli)); ++n) {
    for (int bits = 64 * n; bits < 64 * (n + 1); ++bits) {
      BOOST_TEST_REQUIRE(GC::internal::Remainder_scale::moduli(bits) == n + 1);
      BOOST_REQUIRE((product <= Integer(1) << bits && Integer(1) << bits < product * modulus(moduli[n])));
    }
    product *= modulus(moduli[n]);
  }
}

BOOST_AUTO_TEST_SUITE_END()

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
