// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tells whether a polynomial in two variables has a zero inside of the unit square, and what
// constructors say of such denominators.

#include "support/test.h"

#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>
#include <CGAL/Geometric_continuity/surfaces/internal/zeros_on_square.h>

BOOST_AUTO_TEST_SUITE(zeros_on_square)

typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Traits;

// Coefficients of u^i v^j.
typedef std::vector<std::vector<Q>> Polynomial;

Polynomial product(const Polynomial& f, const Polynomial& g) {
  Polynomial r(f.size() + g.size() - 1, std::vector<Q>(f[0].size() + g[0].size() - 1, Q(0)));
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < f[0].size(); ++j)
      for (std::size_t k = 0; k < g.size(); ++k)
        for (std::size_t l = 0; l < g[0].size(); ++l) r[i + k][j + l] += f[i][j] * g[k][l];
  return r;
}
Polynomial sum(const Polynomial& f, const Polynomial& g) {
  Polynomial r((std::max)(f.size(), g.size()), std::vector<Q>((std::max)(f[0].size(), g[0].size()), Q(0)));
  for (const Polynomial* h : {&f, &g})
    for (std::size_t i = 0; i < h->size(); ++i)
      for (std::size_t j = 0; j < (*h)[0].size(); ++j) r[i][j] += (*h)[i][j];
  return r;
}
Polynomial squared(const Polynomial& f) { return product(f, f); }
Polynomial constant(const Q& c) { return {{c}}; }
Polynomial transposed(const Polynomial& f) {
  Polynomial r(f[0].size(), std::vector<Q>(f.size()));
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < f[0].size(); ++j) r[j][i] = f[i][j];
  return r;
}

// f(1 - u, v)
Polynomial mirrored(const Polynomial& f) {
  Polynomial r = constant(Q(0)), power = constant(Q(1));
  for (const std::vector<Q>& row : f) {
    r = sum(r, product(power, Polynomial{row}));
    power = product(power, Polynomial{{Q(1)}, {Q(-1)}});
  }
  return r;
}

bool has_zero(const Polynomial& f) {
  const bool answer = GC::internal::has_zero_on_square(f);
  BOOST_CHECK_EQUAL(GC::internal::has_zero_on_square(transposed(f)), answer);
  for (const Polynomial& g : {f, transposed(f)})
    BOOST_CHECK_EQUAL(GC::internal::has_zero_on_square(mirrored(g)), answer);
  return answer;
}

// The patch with this denominator: Bernstein coefficients by sums of w_ij = sum C(i, k) C(j, l) /
// (C(m, k) C(n, l)) f_kl.
GC::Rational_bezier_patch<Traits> patch(const Polynomial& f) {
  const int m = static_cast<int>(f.size()) - 1, n = static_cast<int>(f[0].size()) - 1;
  const auto binomial = [](int n, int k) {
    Q r(1);
    for (int i = 0; i < k; ++i) r = Q(r * Q(n - i) / Q(i + 1));
    return r;
  };
  std::vector<std::vector<Traits::Point>> net(m + 1, std::vector<Traits::Point>(n + 1, Traits::Point(0, 0, 0)));
  std::vector<std::vector<Q>> w(m + 1, std::vector<Q>(n + 1, Q(0)));
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= i; ++k)
        for (int l = 0; l <= j; ++l)
          w[i][j] += binomial(i, k) * binomial(j, l) / (binomial(m, k) * binomial(n, l)) * f[k][l];
  return GC::Rational_bezier_patch<Traits>(net, w);
}

const Polynomial u{{Q(0)}, {Q(1)}}, v{{Q(0), Q(1)}};
Polynomial minus(const Polynomial& f, const Q& c) { return sum(f, constant(Q(-c))); }

// The middle of the interval of a number may be the number.
BOOST_AUTO_TEST_CASE(rational_numbers) {
  typedef GC::Power_polynomial<Q> Power;
  const Power s(std::vector<Q>{Q(3) / 2, Q(-7) / 2, Q(1)}); // (x - 1/2) (x - 3)
  const GC::internal::Work_guard work("test");
  const auto sign = [&](const Q& c) {
    return GC::internal::Algebraic_number<Q>(s, Q(0), Q(1)).sign(Power(std::vector<Q>{Q(-c), Q(1)}));
  };
  BOOST_CHECK_EQUAL(sign(Q(1) / 3), 1);
  BOOST_CHECK_EQUAL(sign(Q(2) / 3), -1);
  BOOST_CHECK_EQUAL(sign(Q(1) / 2), 0);
}

BOOST_AUTO_TEST_CASE(single_points) {
  // rational, and roots of quadratic and cubic equations
  const Polynomial third = minus(u, Q(1) / 3), quarter = minus(v, Q(1) / 4), root_u = minus(squared(u), Q(1) / 2),
                   root_v = minus(squared(v), Q(1) / 3), cubic = minus(product(u, squared(u)), Q(1) / 5);
  for (const Polynomial& f : {third, root_u, cubic})
    for (const Polynomial& g : {quarter, root_v}) {
      const Polynomial touching = sum(squared(f), squared(g));
      BOOST_CHECK(has_zero(touching));
      BOOST_CHECK(!has_zero(sum(touching, constant(Q(1) / 1000000))));
      BOOST_CHECK(has_zero(minus(touching, Q(1) / 1000000)));
      BOOST_CHECK(has_zero(squared(touching))); // a multiple factor
      BOOST_CHECK(!has_zero(squared(sum(touching, constant(Q(1) / 1000)))));
      CHECK_ERROR(patch(touching), zero_weight);
    }
  // not both at one point: u = 1/sqrt(2) and v = 2, u = 3 and v = 1/4
  BOOST_CHECK(!has_zero(sum(squared(root_u), squared(minus(v, Q(2))))));
  BOOST_CHECK(!has_zero(sum(squared(minus(u, Q(3))), squared(quarter))));
  // the square of the distance to a point on the diagonal, in other coordinates: u + v = 1, u^3 = v
  BOOST_CHECK(has_zero(
      sum(squared(minus(sum(u, v), Q(1))), squared(sum(product(u, squared(u)), product(v, constant(Q(-1))))))));
}

BOOST_AUTO_TEST_CASE(closed_curves) {
  // (8 (u - 1/3)^2 + 9 (v - 1/2)^2 - r)^2: an ellipse, inside for small r > 0, a point for r = 0,
  // nothing for r < 0
  const auto ellipse = [](const Q& r) {
    return minus(
        sum(product(constant(Q(8)), squared(minus(u, Q(1) / 3))), product(constant(Q(9)), squared(minus(v, Q(1) / 2)))),
        r);
  };
  BOOST_CHECK(has_zero(ellipse(Q(1) / 3)) && has_zero(squared(ellipse(Q(1) / 3))));
  BOOST_CHECK(has_zero(ellipse(Q(0))) && has_zero(squared(ellipse(Q(0)))));
  BOOST_CHECK(!has_zero(ellipse(Q(-1) / 1000)) && !has_zero(squared(ellipse(Q(-1) / 1000))));
  CHECK_ERROR(patch(squared(ellipse(Q(1) / 3))), zero_weight);
  // several factors, some of them multiple
  const Polynomial point = squared(ellipse(Q(0))),
                   shifted = sum(squared(minus(squared(u), Q(1) / 2)), squared(minus(v, Q(1) / 7)));
  BOOST_CHECK(has_zero(product(squared(shifted), ellipse(Q(-1)))) && has_zero(product(point, ellipse(Q(-1)))));
  BOOST_CHECK(!has_zero(product(squared(ellipse(Q(-1))), ellipse(Q(-2)))));
  // a factor in u alone with roots outside
  BOOST_CHECK(!has_zero(product(minus(u, Q(2)), ellipse(Q(-1)))));
  BOOST_CHECK(has_zero(product(minus(u, Q(2)), ellipse(Q(1) / 5))));
  // coefficients of higher powers that are all zero
  Polynomial padded = ellipse(Q(0));
  for (std::vector<Q>& row : padded) row.push_back(Q(0));
  BOOST_CHECK(has_zero(padded));
  BOOST_CHECK(!has_zero(constant(Q(1))) && !has_zero(minus(u, Q(5))) && !has_zero(minus(sum(u, v), Q(5))));
}

// Sums of two squares of random polynomials that are both zero at a random point, or one of them is
// not.
BOOST_AUTO_TEST_CASE(random_points) {
  std::mt19937 engine = seeded(2026);
  const auto number = [&] { return Q(static_cast<int>(engine() % 19) - 9); };
  int zeros = 0;
  for (int i = 0; i < 60; ++i) {
    const Q a = Q(1 + static_cast<int>(engine() % 12)) / Q(13), b = Q(1 + static_cast<int>(engine() % 10)) / Q(11);
    const Polynomial x = minus(u, a), y = minus(v, b);
    const auto random = [&] { // one that is zero at (a, b)
      const Q p[] = {number(), number(), number(), number()};
      return sum(sum(product(constant(p[0]), x), product(constant(p[1]), y)),
                 sum(product(constant(p[2]), product(x, y)), product(constant(p[3]), squared(x))));
    };
    const bool meets = i % 2 == 0;
    const Polynomial g = random(), h = random(),
                     f = sum(sum(squared(g), squared(h)), constant(meets ? Q(0) : Q(1) / 10000));
    bool boundary = false;
    for (int k = 0; k <= 1; ++k)
      for (const Polynomial& g : {f, transposed(f)}) { // g(k, .)
        std::vector<Q> c(g[0].size(), Q(0));
        for (std::size_t p = 0; p < g.size(); ++p)
          for (std::size_t q = 0; q < c.size(); ++q) c[q] += p == 0 || k == 1 ? g[p][q] : Q(0);
        boundary = boundary || GC::sign_pattern(GC::Power_polynomial<Q>(c).bernstein()) != GC::Sign_pattern::positive;
      }
    if (boundary) continue;
    BOOST_CHECK_EQUAL(has_zero(f), meets);
    zeros += meets;
    if (meets) CHECK_ERROR(patch(f), zero_weight);
  }
  BOOST_CHECK_GT(zeros, 20);
}

BOOST_AUTO_TEST_SUITE_END()
