// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Polynomials in homogeneous form: factors at the ends, and their signs as those of the Bernstein
// form.

#include "support/random.h"

#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>

BOOST_AUTO_TEST_SUITE(Homogeneous_polynomial)

using GC::Sign_pattern;

BOOST_AUTO_TEST_CASE(rings) {
  typedef GC::internal::Homogeneous_polynomial<Q> Polynomial;
  const Polynomial p(std::vector<Q>{Q(0), Q(1), Q(-1), Q(0), Q(0)}); // t (1-t)^3 - t^2 (1-t)^2
  BOOST_CHECK(p.order_at_0() == 1 && p.order_at_1() == 2);
  BOOST_CHECK(p.without_end_factors(1, 2) == Polynomial(std::vector<Q>{Q(1), Q(-1)}));
  CHECK_ERROR(p.without_end_factors(-1, 0), negative_count);
  CHECK_ERROR(p.without_end_factors(0, -1), negative_count);
  CHECK_ERROR(p.without_end_factors(2, 0), wrong_number_of_points);
  CHECK_ERROR(p.without_end_factors(0, 3), wrong_number_of_points);
  CHECK_ERROR(Polynomial().without_end_factors(1, 1), wrong_number_of_points);
  CHECK_ERROR(p.elevated_to(3), negative_count);
  CHECK_ERROR(Polynomial::from_bernstein({}), wrong_number_of_points);
  // both functions decide alike, where bisection suffices and where not
  Random_integers<> random;
  for (int run = 0; run < 300; ++run) {
    const int n = random.integer(1, 6);
    std::vector<Q> c;
    for (int i = 0; i <= n; ++i) c.push_back(Q(random.integer(-2, 3)));
    const Polynomial square = Polynomial(c) * Polynomial(c), q = random.integer(0, 1) == 0 ? square : Polynomial(c);
    const Sign_pattern signs = GC::internal::sign_pattern<Q>(q);
    BOOST_CHECK_EQUAL(signs, GC::sign_pattern(q.bernstein<Q>()));
    if (q == square) BOOST_CHECK(signs != Sign_pattern::mixed && signs != Sign_pattern::negative);
    // the signs at some parameters belong to it
    GC::Sign_set some;
    for (int i = 0; i <= 24; ++i)
      some.add(CGAL::to_double(q.bernstein<Q>()(Q(i) / Q(24))) < 0 ? -1 : q.bernstein<Q>()(Q(i) / Q(24)) == 0 ? 0 : 1);
    BOOST_CHECK_EQUAL(GC::joint_pattern(signs, some.pattern()), signs);
  }
}

BOOST_AUTO_TEST_SUITE_END()
