// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The integers and fractions with which exact blends are computed: the same numbers as by the operators of each number type.

#include "support/fractions.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/numbers/internal/Unreduced_fraction.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>
#include <CGAL/Quotient.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/gmp.hpp>
#include <boost/test/unit_test.hpp>

#include <vector>

BOOST_AUTO_TEST_SUITE(Unreduced_fraction)

namespace GC = CGAL::Geometric_continuity;

namespace {

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

} // namespace

BOOST_AUTO_TEST_CASE(fractions) {
  check_fractions<CGAL::Exact_rational>();
  check_fractions<CGAL::Gmpq>();
  check_fractions<boost::multiprecision::cpp_rational>();
  check_fractions<boost::multiprecision::mpq_rational>();
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
