// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The certificate of a verdict is checked: the equations hold, and their residuals are orthogonal.

#include "support/jets.h"

#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>

BOOST_AUTO_TEST_SUITE(join_certificates)

// The derivatives of X(s(t)), s = b1 t + b2 t^2/2 + b3 t^3/6 + ..., up to order 4.
template <class Traits> Jet<Traits> reparametrised(const Jet<Traits>& x, const std::array<Q, 5>& b) {
  Jet<Traits> y = x;
  y[1] = b[1] * x[1];
  y[2] = Q(b[1] * b[1]) * x[2] + b[2] * x[1];
  y[3] = Q(b[1] * b[1] * b[1]) * x[3] + Q(3 * b[1] * b[2]) * x[2] + b[3] * x[1];
  y[4] = Q(b[1] * b[1] * b[1] * b[1]) * x[4] + Q(6 * b[1] * b[1] * b[2]) * x[3] +
         Q(4 * b[1] * b[3] + 3 * b[2] * b[2]) * x[2] + b[4] * x[1];
  return y;
}

template <class Traits, class Certificate>
void check_f(const Jet<Traits>& x, const Jet<Traits>& y, const Certificate& c, int max_order) {
  const int most = std::min(max_order, x.dimension());
  BOOST_REQUIRE(static_cast<int>(c.f_factors.size()) == std::min(c.f_order + 1, most) - 1);
  Q power = c.betas[0];
  for (int j = 2; j <= std::min(c.f_order + 1, most); ++j) {
    power *= c.betas[0];
    Column<Traits> rest = y[j] - power * x[j];
    for (int i = 1; i < j; ++i) rest -= c.f_factors[j - 2][i - 1] * x[i];
    if (j <= c.f_order)
      BOOST_CHECK(is_zero(rest));
    else {
      BOOST_REQUIRE(c.f_residual);
      BOOST_CHECK(*c.f_residual == rest && !is_zero(rest));
      for (int i = 1; i < j; ++i) BOOST_CHECK(dot(rest, x[i]) == Q(0));
    }
  }
  BOOST_CHECK(c.f_residual.has_value() == (c.f_order < most));
}

// A join that has an order, and a derivative that is moved out of the way of the next one.
BOOST_AUTO_TEST_CASE(refuted_at_each_order) {
  Random random;
  in_every_exact_space([&](auto traits, int d) {
    typedef decltype(traits) Traits;
    for (int missed = 1; missed <= 5; ++missed)
      for (int i = 0; i < 5; ++i) {
        const Jet<Traits> x = random.jet<Traits>(d, 4);
        const std::array<Q, 5> b{Q(0), Q(Q(random.integer(1, 9)) / Q(7)), random.rational(), random.rational(),
                                 random.rational()};
        Jet<Traits> y = reparametrised(x, b);
        Column<Traits> away;
        do away = orthogonal_component(random.column<Traits>(d), x[1]);
        while (is_zero(away));
        if (missed <= 4) y[missed] += away;
        const auto verdict = GC::continuity(x, y, 4);
        const auto c = GC::join_certificate(x, y, verdict, 4);
        BOOST_REQUIRE(verdict.g_order == missed - 1 && c.g_order == missed - 1);
        BOOST_CHECK(c.left == x && c.right == y && c.c_order == verdict.c_order && c.f_order == verdict.f_order);
        for (int j = 1; j < missed; ++j) BOOST_CHECK(c.betas[j - 1] == b[j]);
        BOOST_CHECK(static_cast<int>(c.betas.size()) == std::min(missed, 4));
        BOOST_CHECK(missed <= 4 ? *c.g_residual == away : !c.g_residual);
        BOOST_CHECK(*c.c_residual == y[c.c_order + 1] - x[c.c_order + 1] && !is_zero(*c.c_residual));
        if (missed > 1)
          check_f(x, y, c, 4);
        else
          BOOST_CHECK(c.f_factors.empty() && !c.f_residual);
      }
  });
}

// F3 without G3, where the factor of X'' is any number; in the plane F2 is all there is.
BOOST_AUTO_TEST_CASE(frames_alone) {
  Random random;
  const Jet<Exact_3> x = random.jet<Exact_3>(3, 3);
  Jet<Exact_3> y = x;
  y[3] += Q(5) * x[2] + Q(7) * x[1];
  const auto c = GC::join_certificate(x, y, GC::continuity(x, y, 3), 3);
  BOOST_CHECK(c.g_order == 2 && c.f_order == 3 && !c.f_residual);
  BOOST_REQUIRE(c.f_factors.size() == 2);
  BOOST_CHECK(c.f_factors[0][0] == Q(0) && c.f_factors[1][0] == Q(7) && c.f_factors[1][1] == Q(5));
  BOOST_CHECK(*c.g_residual == Q(5) * orthogonal_component(x[2], x[1]));
}

// Where the curvature vanishes X'' is a multiple of X', and has no factor.
BOOST_AUTO_TEST_CASE(dependent_derivatives) {
  const Jet<Exact_3> x = jet<Exact_3>(3, {{0}, {1, 2, 0}, {2, 4, 0}, {0, 1, 0}, {0, 0, 1}});
  Jet<Exact_3> y = x;
  y[3] += Q(3) * x[1];
  const auto c = GC::join_certificate(x, y, GC::continuity(x, y, 3), 3);
  BOOST_CHECK(c.f_order == 3 && c.g_order == 3 && c.f_factors[1][0] == Q(3) && c.f_factors[1][1] == Q(0));
  y[3] += column<Exact_3>(3, {0, 0, 4});
  const auto f2 = GC::join_certificate(x, y, GC::continuity(x, y, 3), 3);
  BOOST_CHECK(f2.f_order == 2 && *f2.f_residual == column<Exact_3>(3, {0, 0, 4}) && *f2.g_residual == *f2.f_residual);
}

BOOST_AUTO_TEST_CASE(no_tangents_and_no_orders) {
  const Jet<Exact_2> x = jet<Exact_2>(2, {{1, 1}, {2, 3}, {0, 1}}), gap = jet<Exact_2>(2, {{1, 2}, {2, 3}, {0, 1}}),
                     back = jet<Exact_2>(2, {{1, 1}, {-4, -6}, {0, 1}}),
                     zero = jet<Exact_2>(2, {{1, 1}, {0, 0}, {0, 1}});
  const auto certificate = [&](const Jet<Exact_2>& y, int order) {
    return GC::join_certificate(x, y, GC::continuity(x, y, order), order);
  };
  BOOST_CHECK(certificate(gap, 2).c_order == -1 && *certificate(gap, 2).c_residual == column<Exact_2>(2, {0, 1}));
  BOOST_CHECK(certificate(gap, 2).betas.empty() && !certificate(gap, 2).g_residual);
  BOOST_CHECK(certificate(back, 2).betas.front() == Q(-2) && is_zero(*certificate(back, 2).g_residual));
  BOOST_CHECK(certificate(zero, 2).g_order == 0 && certificate(zero, 2).betas.empty() &&
              !certificate(zero, 2).g_residual);
  const auto from_zero = GC::join_certificate(zero, x, GC::continuity(zero, x, 2), 2);
  BOOST_CHECK(from_zero.g_order == 0 && from_zero.betas.empty() && !from_zero.g_residual);
  BOOST_CHECK(!certificate(x, 0).c_residual && certificate(x, 0).left.order() == 0 && certificate(x, 0).betas.empty());
  const auto verdict = GC::continuity(x, x, 2);
  GC::Join_continuity<Q> made; // of which no shape parameters have been given
  made.g_order = 2;
  BOOST_CHECK(made.betas().empty());
  CHECK_ERROR(GC::join_certificate(x, x, verdict, 3), jet_order_too_low);
  CHECK_ERROR(GC::join_certificate(x, x, verdict, -1), negative_count);
}

BOOST_AUTO_TEST_SUITE_END()
