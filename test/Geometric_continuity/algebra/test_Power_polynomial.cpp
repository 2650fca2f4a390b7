// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Power polynomials: the Bernstein form and back, division, greatest common divisors; and sets of
// signs.

#include "support/random.h"

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>

BOOST_AUTO_TEST_SUITE(Power_polynomial)

typedef GC::Power_polynomial<Q> Power;
typedef GC::Bernstein_polynomial<Q> Bernstein;
using GC::Sign_pattern;

Power power(std::initializer_list<int> c) { return Power(std::vector<Q>(c.begin(), c.end())); }

Q value(const Power& p, const Q& t) {
  Q y(0);
  for (int k = p.degree(); k >= 0; --k) y = y * t + p[k];
  return y;
}

Power product(const Power& p, const Power& q) {
  if (p.is_zero() || q.is_zero()) return Power();
  std::vector<Q> c(p.degree() + q.degree() + 1, Q(0));
  for (int i = 0; i <= p.degree(); ++i)
    for (int j = 0; j <= q.degree(); ++j) c[i + j] += p[i] * q[j];
  return Power(c);
}

class Random : public Random_integers<> {
public:
  Power polynomial(int degree) {
    std::vector<Q> c;
    for (int i = 0; i <= degree; ++i) c.push_back(Q(integer(-9, 9)) / Q(integer(1, 9)));
    c.back() = Q(integer(1, 9));
    return Power(c);
  }
};

Power monic(Power p) {
  p.make_monic();
  return p;
}

BOOST_AUTO_TEST_CASE(forms) {
  BOOST_CHECK(Power().is_zero() && Power().degree() == -1);
  BOOST_CHECK(power({1, 2, 0, 0}) == power({1, 2}));
  BOOST_CHECK(power({0, 0}) == Power() && power({1}) != Power());
  BOOST_CHECK(Power().bernstein() == Bernstein{Q(0)});
  BOOST_CHECK(Power(Bernstein{Q(0), Q(0), Q(0)}).is_zero());
  // 2 t, of degree 2 in Bernstein form
  BOOST_CHECK(Power(Bernstein{Q(0), Q(1), Q(2)}) == power({0, 2}));
  BOOST_CHECK(Power(Bernstein{Q(1), Q(0), Q(1)}) == power({1, -2, 2}));
  BOOST_CHECK(power({1, -2, 2}).bernstein() == (Bernstein{Q(1), Q(0), Q(1)}));
  BOOST_CHECK(power({5, 0, 3, 1}).derivative() == power({0, 6, 3}));
  BOOST_CHECK(power({5}).derivative().is_zero() && Power().derivative().is_zero());
  BOOST_CHECK(monic(power({4, 2})) == power({2, 1}) && monic(Power()).is_zero());
  Random random;
  for (int n = 0; n < 7; ++n) {
    const Power p = random.polynomial(n);
    const Bernstein b = p.bernstein();
    BOOST_CHECK(Power(b) == p && b.degree() == n);
    for (int i = -2; i < 3; ++i) BOOST_CHECK(b(Q(i) / Q(3)) == value(p, Q(i) / Q(3)));
  }
  // of vectors, up to the last that is not zero
  typedef GC::Coordinate_vector<Q, 2> Vector;
  std::vector<Vector> c(3, Vector(2));
  c[1][0] = Q(1);
  c[2][0] = Q(2);
  const std::vector<Vector> a = GC::powers_from_bernstein<Q>(c);
  BOOST_REQUIRE_EQUAL(a.size(), 2u);
  BOOST_CHECK(is_zero(a[0]) && a[1][0] == Q(2) && a[1][1] == Q(0));
  BOOST_CHECK_EQUAL(GC::powers_from_bernstein<Q>(std::vector<Vector>(3, Vector(2))).size(), 1u);
}

BOOST_AUTO_TEST_CASE(division_and_common_divisors) {
  Random random;
  for (int run = 0; run < 60; ++run) {
    const Power p = random.polynomial(random.integer(0, 4)), q = random.polynomial(random.integer(0, 4)),
                d = random.polynomial(random.integer(0, 3));
    Power rest = p;
    const Power quotient = rest.divide(d);
    BOOST_CHECK(rest.degree() < d.degree() || rest.is_zero());
    for (int i = -3; i < 4; ++i)
      BOOST_CHECK(value(quotient, Q(i)) * value(d, Q(i)) + value(rest, Q(i)) == value(p, Q(i)));
    // p d and q d have d in common, and more only if p and q have
    Power common = greatest_common_divisor(product(p, d), product(q, d));
    const Power of_factors = greatest_common_divisor(p, q);
    BOOST_CHECK(monic(common) == monic(product(d, of_factors)));
  }
  BOOST_CHECK(monic(greatest_common_divisor(Power(), power({2, 2}))) == power({1, 1}));
  BOOST_CHECK(monic(greatest_common_divisor(power({2, 2}), Power())) == power({1, 1}));
  BOOST_CHECK(greatest_common_divisor(Power(), Power()).is_zero());
  Power p = power({1, 2});
  CHECK_ERROR(p.divide(Power()), wrong_number_of_points);
  BOOST_CHECK(p == power({1, 2}));
  // (t-2)^3 (t+1)^2 t -> (t-2)(t+1) t
  const Power a = power({-2, 1}), b = power({1, 1}), t = power({0, 1});
  const Power all = product(product(a, product(a, a)), product(product(b, b), t));
  BOOST_CHECK(monic(Power(square_free_part(all.bernstein()))) == product(product(a, b), t));
  CHECK_ERROR(square_free_part(Bernstein{Q(0), Q(0)}), wrong_number_of_points);
}

BOOST_AUTO_TEST_CASE(sets_of_signs) {
  const Sign_pattern patterns[] = {Sign_pattern::positive,    Sign_pattern::negative, Sign_pattern::nonnegative,
                                   Sign_pattern::nonpositive, Sign_pattern::mixed,    Sign_pattern::zero};
  for (Sign_pattern x : patterns) {
    GC::Sign_set signs;
    signs.add(x);
    BOOST_CHECK_EQUAL(signs.pattern(), x);
    BOOST_CHECK_EQUAL(GC::joint_pattern(x, x), x);
    BOOST_CHECK_EQUAL(GC::joint_pattern(x, Sign_pattern::mixed), Sign_pattern::mixed);
    for (Sign_pattern y : patterns) BOOST_CHECK_EQUAL(GC::joint_pattern(x, y), GC::joint_pattern(y, x));
  }
  BOOST_CHECK_EQUAL(GC::joint_pattern(Sign_pattern::positive, Sign_pattern::zero), Sign_pattern::nonnegative);
  BOOST_CHECK_EQUAL(GC::joint_pattern(Sign_pattern::negative, Sign_pattern::zero), Sign_pattern::nonpositive);
  BOOST_CHECK_EQUAL(GC::joint_pattern(Sign_pattern::nonnegative, Sign_pattern::negative), Sign_pattern::mixed);
  for (int sign : {-1, 0, 1}) {
    GC::Sign_set signs;
    signs.add(sign);
    BOOST_CHECK_EQUAL(signs.pattern(), sign < 0   ? Sign_pattern::negative
                                       : sign > 0 ? Sign_pattern::positive
                                                  : Sign_pattern::zero);
  }
}

BOOST_AUTO_TEST_SUITE_END()
