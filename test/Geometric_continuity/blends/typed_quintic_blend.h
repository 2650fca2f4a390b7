// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "support/typed.h"

#include <limits>

BOOST_AUTO_TEST_SUITE(blend_quintic)

template <class Traits> using Blend = GC::Quintic_blend<Traits>;
template <class Traits> using Strategies = std::vector<Any_strategy<Traits, Blend<Traits>>>;
typedef GC::Given_parameters<FT> Given;

template <class Traits> Strategies<Traits> all_strategies() {
  typedef typename Traits::FT Number;
  const Number s1 = Number(1) / Number(4), s2 = Number(-3) / Number(8);
  return {{"Matching_second_derivative", GC::Matching_second_derivative(), GC::Matching_second_derivative(), false},
          {"Normal_offset", GC::Normal_offset()},
          {"Minimal_second_derivative", GC::Minimal_second_derivative()},
          {"Near_line", GC::Near_line()},
          {"Minimal_energy<2>", GC::Minimal_energy<2>()},
          {"Minimal_energy<3>", GC::Minimal_energy<3>()},
          {"Given_parameters", GC::Given_parameters<Number>{s1, s2},
           GC::Given_parameters<Number>{Number(-s2), Number(-s1)}, true}};
}

// d n = w^perp / 20 at an end with derivatives d1, d2 and the shape parameter beta
template <class Traits> Column<Traits> offset(const Jet<Traits>& x, const FT& beta) {
  return FT(beta * beta / FT(20)) * GC::orthogonal_component(x[2], x[1]);
}

// gamma'' = 20 (d n + s gamma'), so that beta_2 = 20 s beta - beta^2 (d1.d2)/(d1.d1)
template <class Traits> FT beta2(const Jet<Traits>& x, const FT& beta, const FT& s) {
  return FT(FT(20) * s * beta - beta * beta * dot(x[1], x[2]) / dot(x[1], x[1]));
}

template <class Traits> void check_joins(const Blend_input<Traits>& input, const Blend<Traits>& gamma) {
  const Jet<Traits> start = gamma.start_jet(2), end = gamma.end_jet(2);
  const FT beta = input.shape.beta, eta = input.shape.eta;
  const auto left = GC::continuity(input.phi, start), right = GC::continuity(end, input.psi),
             right_backwards = GC::continuity(input.psi, end);
  BOOST_REQUIRE_EQUAL(left.g_order, 2);
  BOOST_REQUIRE_EQUAL(right.g_order, 2);
  BOOST_CHECK_EQUAL(left.f_order, 2);
  BOOST_CHECK(left.betas()[0] == beta);
  BOOST_CHECK(left.betas()[1] == beta2(input.phi, beta, gamma.parameters.s1));
  BOOST_CHECK(right.betas()[0] == FT(FT(1) / eta));
  BOOST_CHECK(right_backwards.betas()[0] == eta);
  BOOST_CHECK(right_backwards.betas()[1] == beta2(input.psi, eta, gamma.parameters.s2));
}

TEST_WITH_RANDOM_INPUT_IF(joins, exact) {
  const Blend_input<Traits> input = random_blend<Traits>(random, d, 2);
  for (const auto& strategy : all_strategies<Traits>()) BOOST_TEST_CONTEXT(strategy.name) {
      const Blend<Traits> gamma = strategy.blend(input);
      BOOST_CHECK(gamma.domain() == std::make_pair(FT(0), FT(1)));
      BOOST_CHECK(!gamma.parameters.fallback_start && !gamma.parameters.fallback_end);
      check_joins(input, gamma);
      check_symmetry(input, random, strategy);
    }
  Blend_input<Traits> smooth = input;
  smooth.shape = {};
  const Blend<Traits> gamma = smooth(GC::Matching_second_derivative());
  BOOST_CHECK_EQUAL(GC::continuity(input.phi, gamma.start_jet(2)).c_order, 2);
  BOOST_CHECK_EQUAL(GC::continuity(gamma.end_jet(2), input.psi).c_order, 2);
  smooth.shape = GC::automatic_shape(input.phi, input.psi);
  BOOST_CHECK(same_points<Traits>(GC::blend(input.phi, input.psi), smooth(GC::Minimal_energy<3>())));
}

TEST_WITH_RANDOM_INPUT_IF(geometry_of_the_strategies, exact) {
  const Blend_input<Traits> input = random_blend<Traits>(random, d, 2);
  const FT beta = input.shape.beta, eta = input.shape.eta, delta = ratio(1, 7);
  const Column<Traits> u = beta * input.phi[1], v = eta * input.psi[1], dn1 = offset(input.phi, beta),
                       dn2 = offset(input.psi, eta);

  const Blend<Traits> c2 = input(GC::Matching_second_derivative());
  BOOST_CHECK(c2.start_jet(2)[2] == FT(beta * beta) * input.phi[2]);
  BOOST_CHECK(c2.end_jet(2)[2] == FT(eta * eta) * input.psi[2]);

  const Blend<Traits> normal = input(GC::Normal_offset());
  BOOST_CHECK(normal.coordinates(2) - normal.coordinates(1) == dn1);
  BOOST_CHECK(normal.coordinates(3) - normal.coordinates(4) == dn2);

  const Blend<Traits> least = input(GC::Minimal_second_derivative());
  BOOST_CHECK(least.start_jet(2)[2] == FT(20) * dn1); // no component along the tangent
  BOOST_CHECK(least.end_jet(2)[2] == FT(20) * dn2);
  for (const FT& s : {delta, FT(-delta)}) {
    const Column<Traits> w = input(Given{s, s}).start_jet(2)[2], best = FT(20) * dn1;
    BOOST_CHECK(dot(best, best) < dot(w, w));
  }

  // C nearest to the line through B1 and B2: the squared distance is quadratic in s
  const Blend<Traits> near = input(GC::Near_line());
  const Column<Traits> b1 = near.coordinates(1), w = near.coordinates(4) - b1;
  const auto distance = [&](const Column<Traits>& c) -> FT {
    return GC::gram_determinant(std::vector<Column<Traits>>{c - b1, w});
  };
  const std::pair<Column<Traits>, Column<Traits>> lines[] = {{near.coordinates(2), delta * u},
                                                             {near.coordinates(3), delta * v}};
  for (const std::pair<Column<Traits>, Column<Traits>>& line : lines) {
    const FT up = distance(line.first + line.second), down = distance(line.first - line.second);
    BOOST_CHECK(up == down);
    BOOST_CHECK(distance(line.first) < up);
  }

  // whatever the strategy, gamma'' = 20 (d n + s gamma')
  const Blend<Traits> free = input(Given{random.whole(), random.whole()});
  BOOST_CHECK(free.start_jet(2)[2] == FT(20) * (dn1 + free.parameters.s1 * u));
  BOOST_CHECK(free.end_jet(2)[2] == FT(20) * (dn2 + free.parameters.s2 * v));
}

// The energy is a quadratic function of (s1, s2): at the minimum the values on both sides are
// equal, and larger.
template <int k, class Traits> void check_minimum(const Blend_input<Traits>& input) {
  const Blend<Traits> gamma = input(GC::Minimal_energy<k>());
  const FT least = gamma.energy(k), s1 = gamma.parameters.s1, s2 = gamma.parameters.s2;
  BOOST_CHECK(input(Given{s1, s2}).energy(k) == least);
  const std::pair<FT, FT> steps[] = {{ratio(1, 9), FT(0)}, {FT(0), FT(1)}, {FT(1), FT(1)}, {FT(1), FT(-2)}};
  for (const std::pair<FT, FT>& step : steps) {
    const FT up = input(Given{FT(s1 + step.first), FT(s2 + step.second)}).energy(k),
             down = input(Given{FT(s1 - step.first), FT(s2 - step.second)}).energy(k);
    BOOST_CHECK(up == down);
    BOOST_CHECK(least < up);
  }
}

TEST_WITH_RANDOM_INPUT_IF(minimal_energy, exact) {
  const Blend_input<Traits> input = random_blend<Traits>(random, d, 2);
  check_minimum<2>(input);
  check_minimum<3>(input);
  // gamma''' is orthogonal to the tangents, and no bump t^3 (1-t)^3 w makes the energy smaller
  const Blend<Traits> gamma = input(GC::Minimal_energy<3>());
  BOOST_CHECK(dot(gamma.start_jet(3)[3], input.phi[1]) == FT(0));
  BOOST_CHECK(dot(gamma.end_jet(3)[3], input.psi[1]) == FT(0));
  const FT least = gamma.energy(3);
  for (int i = 0; i < d; ++i) {
    FT energies[2];
    for (int side : {0, 1}) {
      const Curve<Traits> sextic = gamma.elevate();
      std::vector<Point<Traits>> p(sextic.begin(), sextic.end());
      Column<Traits> middle = sextic.coordinates(3);
      middle[i] += FT(side == 0 ? 1 : -1);
      p[3] = point<Traits>(middle);
      energies[side] = Curve<Traits>(p.begin(), p.end()).energy(3);
    }
    BOOST_CHECK(energies[0] == energies[1]);
    BOOST_CHECK(least < energies[0]);
  }
}

// ---------------------------------------------------------------- degenerate input

// B1 = (1, 0). The line B1 B2 is parallel to u, to v, to both, or B1 = B2.
TEST_IN_EVERY_SPACE(near_line_fallback) {
  struct Case {
    Row a2, v;
    bool start, end;
  };
  const Case cases[] = {{{7, 1}, {5, 5}, true, false},   // B2 = (6, 0)
                        {{-3, 1}, {5, 5}, true, false},  // B2 = (-4, 0)
                        {{7, 6}, {5, 5}, false, true},   // B2 = (6, 5)
                        {{-3, -4}, {5, 5}, false, true}, // B2 = (-4, -5)
                        {{7, 0}, {5, 0}, true, true},    // B2 = (6, 0)
                        {{1, 1}, {0, 5}, true, true},    // B2 = B1
                        {{7, 6}, {5, 0}, false, false}}; // B2 = (6, 6)
  for (const Case& c : cases) {
    const Blend_input<Traits> input{jet<Traits>(d, {{0}, {5, 0}, {0, 20}}), jet<Traits>(d, {c.a2, c.v, {20, 40}}), {}};
    const Blend<Traits> near = input(GC::Near_line()), normal = input(GC::Normal_offset());
    BOOST_CHECK_EQUAL(near.parameters.fallback_start, c.start);
    BOOST_CHECK_EQUAL(near.parameters.fallback_end, c.end);
    BOOST_CHECK_EQUAL(near.parameters.s1 == normal.parameters.s1, c.start);
    BOOST_CHECK_EQUAL(near.parameters.s2 == normal.parameters.s2, c.end);
    BOOST_CHECK(!normal.parameters.fallback_start && !normal.parameters.fallback_end);
  }
}

// The middle part of a curve is found again from the outer ones.
TEST_WITH_RANDOM_INPUT(reproduction) {
  const auto check = [&](int degree, const auto& strategy) {
    // three parts of length 1
    const Taylor_curve<Traits> whole(random_jet<Traits>(random, d, degree), FT(0), FT(3));
    const Jet<Traits> phi = whole.jet(FT(1), 2), psi = whole.jet(FT(2), 2);
    if (is_zero(phi[1]) || is_zero(psi[1])) return;
    const Blend<Traits> gamma = GC::blend(phi, psi, strategy, {});
    const Jet<Traits> expected = whole.jet(FT(1), 5), start = gamma.start_jet(5);
    // whole numbers up to 2^9, conditions below 2^3, and differences that multiply errors by up to
    // 5! 2^5 < 2^12
    for (int j = 0; j <= 5; ++j)
      for (int i = 0; i < d; ++i) BOOST_CHECK(close(start[j][i], expected[j][i], FT(1 << 24), 100));
  };
  check(1, GC::Minimal_second_derivative());
  check(1, GC::Minimal_energy<2>());
  check(2, GC::Minimal_energy<3>());
  check(2, GC::Matching_second_derivative());
  if constexpr (exact) check(5, GC::Matching_second_derivative());
}

TEST_IN_EVERY_SPACE(straight_and_closed) {
  for (const auto& strategy : all_strategies<Traits>()) BOOST_TEST_CONTEXT(strategy.name) {
      // on the first axis, with curvature 0
      const Jet<Traits> phi = jet<Traits>(d, {{0}, {1}, {4}}), psi = jet<Traits>(d, {{7}, {2}, {-1}});
      const Blend<Traits> line = strategy.blend({phi, psi, {}});
      for (int j = 0; j <= 5; ++j)
        for (int i = 1; i < d; ++i) BOOST_CHECK(line.coordinates(j)[i] == FT(0));
      // from a point back to itself, with other tangents
      const Jet<Traits> x = jet<Traits>(d, {{1, 2}, {4, 0}, {0, 8}}), y = jet<Traits>(d, {{1, 2}, {0, 4}, {8, 0}});
      const Blend<Traits> loop = strategy.blend({x, y, {FT(2), FT(4)}});
      BOOST_CHECK(loop.coordinates(0) == x[0] && loop.coordinates(5) == y[0]);
      if constexpr (exact) check_joins(Blend_input<Traits>{x, y, {FT(2), FT(4)}}, loop);
      // an end that is the start: all joins of the closed curve are smooth
      const Blend<Traits> closed = strategy.blend({x, x, {}});
      if constexpr (exact) BOOST_CHECK_EQUAL(GC::continuity(closed, closed, 2).g_order, 2);
    }
}

TEST_IN_EVERY_SPACE(refused_blends) {
  check_blend_errors<Traits>(d, 2, GC::Minimal_energy<2>());
  check_blend_errors<Traits>(d, 2, GC::Near_line());
  if constexpr (std::is_floating_point_v<typename Traits::FT>) {
    const FT infinity = std::numeric_limits<FT>::infinity(), undefined = std::numeric_limits<FT>::quiet_NaN();
    const Jet<Traits> x = jet<Traits>(d, {{1, 2}, {4, 0}, {0, 8}});
    const GC::Normal_offset normal;
    CHECK_ERROR(GC::blend(x, x, normal, {undefined, FT(1)}), nonpositive_beta);
    CHECK_ERROR(GC::blend(x, x, normal, {FT(1), infinity}), not_finite);
    Jet<Traits> far = x;
    far[1] *= FT(1e150);
    CHECK_ERROR(GC::blend(x, far, GC::Minimal_energy<2>(), {FT(1), FT(1e150)}), not_finite);
  }
}

// --------------------------------------------------------- strategies and curves of the user's own

struct Half_way { // between two strategies of the package
  template <class Number, int N> GC::Quintic_parameters<Number> operator()(const GC::Quintic_ends<Number, N>& e) const {
    const GC::Quintic_parameters<Number> p = GC::Minimal_energy<3>()(e), q = GC::Normal_offset()(e);
    return {Number((p.s1 + q.s1) / Number(2)), Number((p.s2 + q.s2) / Number(2)), true, false};
  }
};

TEST_WITH_RANDOM_INPUT(own_strategies_and_curves) {
  const Blend_input<Traits> input = random_blend<Traits>(random, d, 2);
  const Blend<Traits> half = input(Half_way()), p = input(GC::Minimal_energy<3>()), q = input(GC::Normal_offset());
  BOOST_CHECK(half.parameters.s1 == FT((p.parameters.s1 + q.parameters.s1) / FT(2)));
  BOOST_CHECK(half.parameters.fallback_start && !half.parameters.fallback_end);
  BOOST_CHECK(same_points<Traits>(half, input(Given{half.parameters.s1, half.parameters.s2})));

  int calls = 0;
  const Blend<Traits> lambda = input([&](const GC::Quintic_ends<FT, Curve<Traits>::N>& e) {
    ++calls;
    BOOST_CHECK(e.a1 == input.phi[0] && e.a2 == input.psi[0]);
    BOOST_CHECK(e.u == input.shape.beta * input.phi[1] && e.v == input.shape.eta * input.psi[1]);
    BOOST_CHECK(e.w1 == FT(input.shape.beta * input.shape.beta) * input.phi[2]);
    BOOST_CHECK(e.w2 == FT(input.shape.eta * input.shape.eta) * input.psi[2]);
    return GC::Quintic_parameters<FT>{FT(3), FT(4)};
  });
  BOOST_CHECK_EQUAL(calls, 1);
  BOOST_CHECK(same_points<Traits>(lambda, input(Given{FT(3), FT(4)})));
  // without naming the type of the ends
  const Blend<Traits> generic = input([](const auto& e) {
    return GC::Quintic_parameters<FT>{FT(e.u[0] - e.u[0] + FT(3)), FT(4)};
  });
  BOOST_CHECK(same_points<Traits>(lambda, generic));

  check_input_types(input, GC::Near_line());
  const Taylor_curve<Traits> left(input.phi, FT(-1), FT(0)), right(input.psi, FT(0), FT(1));
  const Jet<Traits> phi = left.jet(FT(0), 2);
  if (!is_zero(phi[1]))
    BOOST_CHECK(same_points<Traits>(GC::blend(left, right), GC::blend(phi, input.psi, GC::Minimal_energy<3>())));
  // more derivatives than needed change nothing
  const Blend_input<Traits> longer = random_blend<Traits>(random, d, 4);
  const Blend_input<Traits> shorter{truncated(longer.phi, 2), truncated(longer.psi, 2), longer.shape};
  BOOST_CHECK(same_points<Traits>(longer(GC::Minimal_energy<2>()), shorter(GC::Minimal_energy<2>())));
}

// ---------------------------------------------------------------- rounded numbers

// With M the sum of the lengths of the six vectors that define the blend, the right sides of the
// linear systems are sums of at most 42 M |u|, and the systems, scaled by |u| and |v|, have
// condition at most 2: 1000 roundings of M cover all. The shift of Near_line divides by the squared
// sine of an angle, which multiplies its error by at most its inverse squared.
TEST_WITH_RANDOM_INPUT_IF(rounded_blends, !exact) {
  const Blend_input<Traits> input = random_blend<Traits>(random, d, 2, &Random::rational);
  const Blend_input<Reference> reference{
      rational_jet(input.phi), rational_jet(input.psi), {rational(input.shape.beta), rational(input.shape.eta)}};
  const double beta = CGAL::to_double(input.shape.beta), eta = CGAL::to_double(input.shape.eta);
  const double m = length(input.phi[0]) + length(input.psi[0]) + beta * length(input.phi[1]) +
                   eta * length(input.psi[1]) + beta * beta * length(input.phi[2]) + eta * eta * length(input.psi[2]);
  const Strategies<Reference> exactly = all_strategies<Reference>();
  int i = 0;
  for (const auto& strategy : all_strategies<Traits>()) BOOST_TEST_CONTEXT(strategy.name) {
      const Blend<Traits> gamma = strategy.blend(input);
      const Blend<Reference> expected = exactly[i++].blend(reference);
      double condition = 1;
      if (strategy.name == std::string("Near_line")) {
        const Column<Reference> w = expected.coordinates(4) - expected.coordinates(1);
        for (const Jet<Reference>& x : {reference.phi, reference.psi})
          condition =
              std::max(condition,
                       std::pow(length(x[1]) * length(w), 4) /
                           std::pow(CGAL::to_double(GC::gram_determinant(std::vector<Column<Reference>>{x[1], w})), 2));
      }
      for (int j = 0; j <= 5; ++j)
        BOOST_CHECK(within(gamma.coordinates(j), expected.coordinates(j), 1000 * 0x1p-53 * m * condition));
    }
}

BOOST_AUTO_TEST_SUITE_END()
