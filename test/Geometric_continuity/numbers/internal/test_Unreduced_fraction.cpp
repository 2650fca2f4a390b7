// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The integers and fractions with which exact blends are computed: the same numbers as by the
// operators of each number type.

#include "support/fractions.h"
#include "support/test.h"

#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/Unreduced_fraction.h>
#include <CGAL/Geometric_continuity/numbers/internal/number_words.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>
#include <CGAL/Quotient.h>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/gmp.hpp>

BOOST_AUTO_TEST_SUITE(Unreduced_fraction)

template <class FT> void check_number(const FT& x, const FT& expected) {
  BOOST_CHECK(x == expected);
  BOOST_CHECK(is_canonical(x));
}

// Numbers around the limits of limbs and of the memory that needs no allocation.
template <class FT> std::vector<FT> special_numbers() {
  std::vector<FT> numbers{FT(0), FT(1), FT(-1), FT(FT(-3) / FT(40)), power_of_two<FT>(64), FT(-power_of_two<FT>(-64))};
  for (const int k : {63, 64, 128, 1023, 1024, 1025}) {
    numbers.push_back(FT(power_of_two<FT>(k) - FT(1)));
    numbers.push_back(FT(FT(-1) / numbers.back()));
    numbers.push_back(FT(FT(FT(5) * power_of_two<FT>(k)) / FT(3)));
  }
  return numbers;
}

template <class FT> void check_fractions() {
  typedef GC::internal::Rational_parts<FT> Parts;
  typedef GC::internal::Unreduced_fraction<FT> Fraction;
  typedef GC::internal::Inline_integer Integer;
  const std::vector<FT> numbers = special_numbers<FT>();
  for (const FT& x : numbers) {
    Integer n, d;
    Parts::split(x, n, d);
    check_number(Parts::make(n, d, 0), x);
    check_number(Parts::make(n, d, 70), FT(x * power_of_two<FT>(-70)));
    check_number(Parts::make(n, d, -70), FT(x * power_of_two<FT>(70)));
    check_number(Parts::make(n * Integer(15), d * Integer(35), 0), FT(x * FT(FT(3) / FT(7))));
    check_number(FT(-Fraction(x).reduced()), (-Fraction(x)).reduced());
    for (const FT& y : numbers) {
      const Fraction p(x), q(y);
      check_number((p + q).reduced(), FT(x + y));
      check_number((p - q).reduced(), FT(x - y));
      check_number((p * q).reduced(), FT(x * y));
      if (y != FT(0)) check_number((p / q).reduced(), FT(x / y));
      BOOST_CHECK_EQUAL(p == q, x == y);
      BOOST_CHECK_EQUAL(p < q, x < y);
    }
  }
}

BOOST_AUTO_TEST_CASE(fractions) {
  check_fractions<CGAL::Exact_rational>();
  check_fractions<CGAL::Gmpq>();
  check_fractions<boost::multiprecision::cpp_rational>();
  check_fractions<boost::multiprecision::mpq_rational>();
}

// The test asks the questions about one integer or fraction, for zero, negative numbers, and
// numbers at the limits of short ones.
BOOST_AUTO_TEST_CASE(single_numbers) {
  typedef GC::internal::Inline_integer Integer;
  Integer zero(0), quotient(5);
  BOOST_CHECK_EQUAL(zero.remove_twos(), 0);
  BOOST_CHECK(zero.is_zero() && divides(Integer(7), Integer(0), quotient) && quotient.is_zero());
  BOOST_CHECK(Integer(-3) < Integer(-2) && !(Integer(-2) < Integer(-3)) && !(Integer(-2) < Integer(-2)));
  Integer moved = Integer(12345) * Integer(-6789), &same = moved;
  moved = std::move(same);
  BOOST_CHECK(moved == Integer(-83810205));
}

template <class FT> void check_short_numbers() {
  typedef GC::internal::Rational_parts<FT> Parts;
  const auto parts = [](const FT& x) {
    std::int64_t n, d;
    if (!Parts::short_parts(x, n, d)) return false;
    BOOST_CHECK(Parts::make_short(n, d) == x);
    return true;
  };
  const auto has_64_bits = [](const FT& x) { return GC::has_short_parts<64>(x); };
  const FT below_60(power_of_two<FT>(60) - FT(1)), below_64(power_of_two<FT>(64) - FT(1));
  for (const FT& x : {FT(0), FT(7), below_60, below_64, power_of_two<FT>(60), power_of_two<FT>(64)})
    for (const FT& y : {x, FT(-x), FT(FT(1) / (x == FT(0) ? FT(3) : x)), FT(FT(-2) / (x == FT(0) ? FT(3) : x))}) {
      BOOST_CHECK_EQUAL(parts(y), x < power_of_two<FT>(60) || y == FT(FT(-2) / power_of_two<FT>(60)));
      BOOST_CHECK_EQUAL(has_64_bits(y), x < power_of_two<FT>(64) || y == FT(FT(-2) / power_of_two<FT>(64)));
      for (const FT& z : {FT(0), FT(-5), FT(FT(1) / FT(3)), below_60, power_of_two<FT>(70)}) {
        BOOST_CHECK(GC::short_sum(y, z) == FT(y + z));
        BOOST_CHECK(GC::short_sum(z, y) == FT(y + z));
      }
    }
}

BOOST_AUTO_TEST_CASE(short_numbers) {
  check_short_numbers<CGAL::Exact_rational>();
  check_short_numbers<CGAL::Gmpq>();
  check_short_numbers<boost::multiprecision::cpp_rational>();
  check_short_numbers<boost::multiprecision::mpq_rational>();
}

BOOST_AUTO_TEST_CASE(words_of_numbers) {
  const auto check_words = [](const auto& x, std::size_t words) {
    BOOST_CHECK_EQUAL(GC::internal::Number_words<std::decay_t<decltype(x)>>::of(x), words);
  };
  const CGAL::Gmpq long_q = power_of_two<CGAL::Gmpq>(-64);
  check_words(long_q, 2);
  check_words(CGAL::Gmpq(7), 1);
  check_words(CGAL::Gmpz(7), 1);
  check_words(power_of_two<boost::multiprecision::mpq_rational>(128), 3);
  check_words(boost::multiprecision::mpz_int(7), 1);
}

// numbers with and without parts
typedef CGAL::Exact_predicates_exact_constructions_kernel::FT Lazy;
static_assert(GC::internal::Rational_parts<CGAL::Exact_rational>::value);
static_assert(GC::internal::Rational_parts<CGAL::Gmpq>::value);
static_assert(GC::internal::Rational_parts<boost::multiprecision::cpp_rational>::value);
static_assert(GC::internal::Rational_parts<boost::multiprecision::mpq_rational>::value);
static_assert(!GC::internal::Rational_parts<CGAL::Quotient<CGAL::Gmpz>>::value);
static_assert(!GC::internal::Rational_parts<double>::value && !GC::internal::Rational_parts<Lazy>::value);

BOOST_AUTO_TEST_SUITE_END()
