// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Roots of polynomials on [0, 1].

#include "support/swept_surfaces.h"

#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>

typedef std::vector<GC::Isolated_root<Q>> Roots;

bool is(const GC::Isolated_root<Q>& r, const Q& x, int multiplicity) {
  return r.begin == x && r.end == x && r.multiplicity == multiplicity;
}
bool holds(const GC::Isolated_root<Q>& r, const Q& x, int multiplicity, const Q& width = Q(Q(1) / Q(1024))) {
  return r.begin < x && x < r.end && Q(r.end - r.begin) <= width && r.multiplicity == multiplicity;
}

BOOST_AUTO_TEST_CASE(roots_of_products_of_linear_factors) {
  const Q third = Q(Q(1) / Q(3)), half = Q(Q(1) / Q(2)), near = Q(half + Q(1) / Q(100000));
  Roots r = isolate_roots(factor(third));
  BOOST_REQUIRE_EQUAL(r.size(), 1u);
  BOOST_CHECK(is(r[0], third, 1));                   // linear: exact
  r = isolate_roots(factor(half) * factor(Q(5, 7))); // what is left on [1/2, 1] is linear
  BOOST_REQUIRE_EQUAL(r.size(), 2u);
  BOOST_CHECK(is(r[0], half, 1) && is(r[1], Q(5, 7), 1));
  r = isolate_roots(factor(third) * factor(third) * factor(third));
  BOOST_REQUIRE_EQUAL(r.size(), 1u);
  BOOST_CHECK(is(r[0], third, 3));
  r = isolate_roots(factor(Q(0)) * factor(third) * factor(Q(1)) * factor(Q(1)));
  BOOST_REQUIRE_EQUAL(r.size(), 3u);
  BOOST_CHECK(is(r[0], Q(0), 1) && is(r[1], third, 1) && is(r[2], Q(1), 2));
  // bisection meets 1/2; the intervals of its neighbours must not end there
  r = isolate_roots(factor(third) * factor(half) * factor(half) * factor(near) * factor(near) * factor(near));
  BOOST_REQUIRE_EQUAL(r.size(), 3u);
  BOOST_CHECK(is(r[1], half, 2));
  BOOST_CHECK(r[0].begin < third && third < r[0].end && r[0].multiplicity == 1);
  BOOST_CHECK(half < r[2].begin && r[2].begin <= near && near <= r[2].end && r[2].multiplicity == 3);
  // none inside: outside, complex, constant, zero
  BOOST_CHECK(isolate_roots(factor(Q(2)) * factor(Q(-1))).empty());
  BOOST_CHECK(isolate_roots(factor(half) * factor(half) + Polynomial{Q(Q(1) / Q(1000000))}).empty());
  BOOST_CHECK(isolate_roots(Polynomial{Q(5)}).empty());
  BOOST_CHECK(isolate_roots(Polynomial{Q(0), Q(0), Q(0)}).empty());
  CHECK_ERROR(isolate_roots(factor(half), Q(0)), empty_domain);
}

BOOST_AUTO_TEST_CASE(roots_of_random_products) {
  Random random;
  for (int run = 0; run < 20; ++run) {
    std::vector<std::pair<Q, int>> expected;
    Polynomial p{Q(random.positive())};
    for (int i = 1; i <= 4; ++i) { // roots in (i/5, (i+1)/5), one of them outside
      const Q x = Q((Q(i + (i == 4 ? 1 : 0)) + Q(random.integer(1, 9998)) / Q(9999)) / Q(5));
      const int multiplicity = random.integer(1, 3);
      for (int k = 0; k < multiplicity; ++k) p = p * factor(x);
      if (i < 4) expected.push_back({x, multiplicity});
    }
    const Q width = Q(Q(1) / Q(1 << 20));
    const Roots r = isolate_roots(p, width);
    BOOST_REQUIRE_EQUAL(r.size(), expected.size());
    for (std::size_t i = 0; i < r.size(); ++i)
      BOOST_CHECK(holds(r[i], expected[i].first, expected[i].second, width) ||
                  is(r[i], expected[i].first, expected[i].second));
  }
}

BOOST_AUTO_TEST_CASE(roots_with_double_coefficients) {
  // t^2 - 1/2 with coefficients that doubles represent; the root is irrational
  const Roots r = isolate_roots(GC::Bernstein_polynomial<double>{-0.5, -0.5, 0.5});
  BOOST_REQUIRE_EQUAL(r.size(), 1u);
  BOOST_CHECK(Q(r[0].begin * r[0].begin) < Q(0.5) && Q(0.5) < Q(r[0].end * r[0].end));
  CHECK_ERROR(isolate_roots(GC::Bernstein_polynomial<double>{-1., infinity}), not_finite);
}

// t^n - 2 (a t - 1)^2 has two roots near 1/a, about 2 a^(-n/2 - 1) apart: Mignotte.
BOOST_AUTO_TEST_CASE(close_roots) {
  const int n = 40;
  const Q a(1000), centre = Q(Q(1) / a);
  const Polynomial line{Q(-1), Q(a - Q(1))};
  Polynomial power{Q(1)};
  for (int i = 0; i < n; ++i) power = power * factor(Q(0));
  const Polynomial p = power - Polynomial{Q(2)} * line * line;
  const Roots r = isolate_roots(p);
  BOOST_REQUIRE_EQUAL(r.size(), 2u);
  BOOST_CHECK(r[0].begin < centre && r[0].end <= r[1].begin && centre < r[1].end);
  for (const GC::Isolated_root<Q>& root : r) BOOST_CHECK(p(root.begin) * p(root.end) < 0 && root.multiplicity == 1);
  BOOST_CHECK(GC::sign_pattern(p) == GC::Sign_pattern::mixed);
  // the work is limited
  CHECK_ERROR(isolate_roots(p, Q(1), 100), work_limit);
  BOOST_CHECK_EQUAL(isolate_roots(p, Q(1), 400).size(), 2u);
}

BOOST_AUTO_TEST_CASE(limits_of_the_work) {
  const Polynomial p = factor(Q(Q(1) / Q(3))) * factor(Q(Q(2) / Q(3)));
  Q width(1);
  for (int i = 0; i < 5000; ++i) width /= 2;
  CHECK_ERROR(isolate_roots(p, width), work_limit);
  CHECK_ERROR(isolate_roots(p, Q(1), -1), negative_count);
  CHECK_ERROR(isolate_roots(p, Q(1), 0), work_limit);
  // one bisection separates them,
  BOOST_CHECK_EQUAL(isolate_roots(p, Q(1), 1).size(), 2u);
  BOOST_CHECK_EQUAL(isolate_roots(factor(Q(1) / Q(3)), width, 0).size(), 1u); // and none is needed
}
