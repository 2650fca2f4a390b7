// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Polynomials in integers of fixed length against the same in integers of any length, up to the
// bounds from which their lengths follow; and their signs, by bisection in numbers that are rounded
// outwards.

#include "support/random.h"

#include <CGAL/Fraction_traits.h>
#include <CGAL/Geometric_continuity/algebra/internal/Bounded_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/internal/Homogeneous_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/internal/Rounded_polynomial.h>

BOOST_AUTO_TEST_SUITE(Bounded_polynomial)

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

namespace I = GC::internal;
typedef CGAL::Fraction_traits<CGAL::Exact_rational>::Numerator_type Z;
typedef GC::internal::Homogeneous_polynomial<Z> Whole;

template <int degree, int bits> Whole whole(const I::Bounded_polynomial<degree, bits>& p) {
  constexpr int limbs = I::Bounded_polynomial<degree, bits>::limbs;
  std::vector<Z> c;
  for (int k = 0; k <= p.degree; ++k) {
    Z x(static_cast<double>(p.c[k].top() >> 32));
    for (int i = 2 * limbs - 2; i >= 0; --i)
      x = x * Z(0x1p32) + Z(static_cast<double>(p.c[k].limb[i / 2] >> (i % 2 * 32) & 0xffffffff));
    c.push_back(x);
  }
  return Whole(c);
}

// Coefficients up to the bound; half of them are at it.
template <int degree, int bits>
I::Bounded_polynomial<degree, bits> random_polynomial(Random_integers<>& random, int n, int sign) {
  const std::int64_t most = std::int64_t(1) << bits;
  return I::Bounded_polynomial<degree, bits>::from_bernstein(n, [&](int) {
    const std::int64_t x = random.integer(0, 1) ? most : most - random.integer(0, 1 << 30);
    return sign != 0 ? sign * x : random.integer(0, 1) ? x : -x;
  });
}

BOOST_AUTO_TEST_CASE(sums_and_products_up_to_the_bounds) {
  Random_integers<> random;
  for (int round = 0; round < 200; ++round) {
    const int n = round % 8, m = random.integer(0, 6), sign = round % 3 - 1;
    const auto p = random_polynomial<7, 60>(random, n, sign), q = random_polynomial<7, 60>(random, n, -sign);
    const auto r = random_polynomial<6, 55>(random, m, sign), s = random_polynomial<6, 55>(random, m, 1);
    BOOST_TEST_CONTEXT("seed " << random.seed << ", round " << round) {
      BOOST_CHECK(whole(p + q) == whole(p) + whole(q));
      BOOST_CHECK(whole(p - q) == whole(p) - whole(q));
      BOOST_CHECK(whole(p * r) == whole(p) * whole(r));
      auto sum = I::first_of_products<4>(p, r);
      subtract_product(sum, q, r);
      add_product(sum, p, s);
      subtract_product(sum, q, s);
      const Whole expected = (whole(p) - whole(q)) * (whole(r) + whole(s));
      BOOST_CHECK(whole(sum) == expected);
      const I::Bounded_factor<63> factor{sign < 0 ? -(std::int64_t(1) << 62) : (std::int64_t(1) << 62) + 5};
      const auto cube = sum * sum * sum;
      BOOST_CHECK(whole(cube) == expected * expected * expected);
      BOOST_CHECK(whole(factor * cube) == Whole({Z(static_cast<double>(factor.value >> 31)) * Z(0x1p31) +
                                                 Z(static_cast<double>(factor.value & 0x7fffffff))}) *
                                              expected * expected * expected);
      BOOST_CHECK((sum - sum).vanishes() && (sum.vanishes() == expected.is_zero()));
      if (sign != 0) BOOST_CHECK_EQUAL(p.strict_sign(), sign);
    }
  }
}

BOOST_AUTO_TEST_CASE(lengths_follow_from_degrees_and_bounds) {
  typedef I::Bounded_polynomial<7, 54> P;
  static_assert(P::limbs == 1 && decltype(P() * P())::limbs == 2 && decltype(P() * P() * P())::limbs == 3);
  static_assert(I::Bounded_polynomial<7, 56>::limbs == 1 && I::Bounded_polynomial<7, 57>::limbs == 2);
  static_assert(decltype(I::first_of_products<3>(P(), P()))::bits == 110 && decltype(P() + P())::bits == 55);
}

BOOST_AUTO_TEST_CASE(signs) {
  typedef I::Bounded_polynomial<4, 54> P;
  const auto polynomial = [](std::vector<std::int64_t> b) {
    return P::from_bernstein(static_cast<int>(b.size()) - 1, [&](int i) { return b[static_cast<std::size_t>(i)]; });
  };
  const std::int64_t big = std::int64_t(1) << 50;
  BOOST_CHECK_EQUAL(I::Rounded_polynomial::sign_of(polynomial({1, 2, 3})), 1);
  BOOST_CHECK_EQUAL(I::Rounded_polynomial::sign_of(polynomial({-1, -2, -3})), -1);
  BOOST_CHECK_EQUAL(I::Rounded_polynomial::sign_of(polynomial({5})), 1);
  BOOST_CHECK_EQUAL(I::Rounded_polynomial::sign_of(polynomial({-5})), -1);
  // 4 - 14 t (1-t) >= 1/2
  BOOST_CHECK_EQUAL(I::Rounded_polynomial::sign_of(polynomial({4, -3, 4})), 1);
  BOOST_CHECK_EQUAL(I::Rounded_polynomial::sign_of(polynomial({-4 * big, 3 * big, -4 * big})), -1);
  BOOST_CHECK_EQUAL(I::Rounded_polynomial::sign_of(polynomial({1, -1, 1})), 0); // a double zero
  BOOST_CHECK_EQUAL(I::Rounded_polynomial::sign_of(polynomial({4, -5, 4})), 0); // two zeros
  BOOST_CHECK_EQUAL(I::Rounded_polynomial::sign_of(polynomial({0, 1, 1})), 0);
  BOOST_CHECK_EQUAL(I::Rounded_polynomial::sign_of(polynomial({1, 1, 0})), 0);
  BOOST_CHECK_EQUAL(I::Rounded_polynomial::sign_of(polynomial({0, 0, 0})), 0);
  BOOST_CHECK_EQUAL(I::Rounded_polynomial::sign_of(polynomial({big, 1, -big})), 0);
}

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

BOOST_AUTO_TEST_SUITE_END()
