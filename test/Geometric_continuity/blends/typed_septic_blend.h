// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "support/typed.h"

#include <CGAL/Geometric_continuity/blends/blend_strategies.h>

BOOST_AUTO_TEST_SUITE(blend_septic)

template <class Traits> using Blend = GC::Septic_blend<Traits>;
template <class Traits> using Strategies = std::vector<Any_strategy<Traits, Blend<Traits>>>;
typedef GC::Septic_end_parameters<FT> End_parameters;
typedef GC::Given_end_parameters<FT> Given;

// The given parameters are not geometric: they multiply derivatives of the given curves. Backwards,
// all derivatives of odd order change sign on both sides, and so does beta_2.
template <class Traits> Strategies<Traits> all_strategies() {
  typedef typename Traits::FT Number;
  const GC::Septic_end_parameters<Number> p{Number(1), Number(2), Number(-3)}, q{Number(-1), Number(4), Number(5)};
  const auto mirror = [](const GC::Septic_end_parameters<Number>& e) {
    return GC::Septic_end_parameters<Number>{Number(-e.beta2), Number(-e.mu), e.beta3};
  };
  Strategies<Traits> strategies = {
      {"Matching_third_derivative", GC::Matching_third_derivative(), GC::Matching_third_derivative(), false},
      {"Sequential_g3", GC::Sequential_g3()},
      {"Sequential_f3", GC::Sequential_f3()},
      {"Joint_g3", GC::Joint_g3()},
      {"Given_end_parameters", GC::Given_end_parameters<Number>{p, q},
       GC::Given_end_parameters<Number>{mirror(q), mirror(p)}, false}};
  if (cancels) {
    strategies.push_back({"Minimal_energy_g3<3>", GC::Minimal_energy_g3<3>()});
    strategies.push_back({"Minimal_energy_g3<4>", GC::Minimal_energy_g3<4>()});
  }
  return strategies;
}

inline FT mu_of_g3(const FT& beta, const End_parameters& p) { return FT(FT(3) * beta * p.beta2); }

// The join of x with the blend y, seen from x, at either end: gamma' = beta d1, gamma'' = beta^2
// d2 + beta_2 d1, gamma''' = beta^3 d3 + mu d2 + beta_3 d1.
template <class Traits>
void check_join(const Jet<Traits>& x, const Jet<Traits>& y, const FT& beta, const End_parameters& p) {
  BOOST_CHECK(y[0] == x[0]);
  BOOST_CHECK(y[1] == beta * x[1]);
  BOOST_CHECK(y[2] == FT(beta * beta) * x[2] + p.beta2 * x[1]);
  BOOST_CHECK(y[3] == FT(beta * beta * beta) * x[3] + p.mu * x[2] + p.beta3 * x[1]);
  const bool g3 = p.mu == mu_of_g3(beta, p) || GC::curvature_squared(x) == FT(0);
  for (const auto& join : {GC::continuity(x, y), GC::continuity(y, x)}) {
    BOOST_CHECK_EQUAL(join.g_order, g3 ? 3 : 2);
    BOOST_CHECK_EQUAL(join.f_order, std::min(x.dimension(), 3));
  }
  const auto join = GC::continuity(x, y);
  BOOST_CHECK(join.betas()[0] == beta);
  BOOST_CHECK(join.betas()[1] == p.beta2);
  if (p.mu == mu_of_g3(beta, p)) BOOST_CHECK(join.betas()[2] == p.beta3);
  BOOST_CHECK(GC::continuity(y, x).betas()[0] == FT(FT(1) / beta));
}

template <class Traits> void check_joins(const Blend_input<Traits>& input, const Blend<Traits>& gamma) {
  check_join(input.phi, gamma.start_jet(3), input.shape.beta, gamma.parameters.start);
  check_join(input.psi, gamma.end_jet(3), input.shape.eta, gamma.parameters.end);
}

TEST_WITH_RANDOM_INPUT_IF(joins, exact) {
  const Blend_input<Traits> input = random_blend<Traits>(random, d, 3);
  for (const auto& strategy : all_strategies<Traits>()) BOOST_TEST_CONTEXT(strategy.name) {
      const Blend<Traits> gamma = strategy.blend(input);
      BOOST_CHECK(gamma.domain() == std::make_pair(FT(0), FT(1)));
      BOOST_CHECK(!gamma.parameters.fallback_start && !gamma.parameters.fallback_end);
      check_joins(input, gamma);
      if (std::string(strategy.name).find("g3") != std::string::npos) {
        BOOST_CHECK(gamma.parameters.start.mu == mu_of_g3(input.shape.beta, gamma.parameters.start));
        BOOST_CHECK(gamma.parameters.end.mu == mu_of_g3(input.shape.eta, gamma.parameters.end));
      }
      check_symmetry(input, random, strategy);
    }
  Blend_input<Traits> smooth = input;
  smooth.shape = {};
  const Blend<Traits> gamma = smooth(GC::Matching_third_derivative());
  BOOST_CHECK_EQUAL(GC::continuity(input.phi, gamma.start_jet(3)).c_order, 3);
  BOOST_CHECK_EQUAL(GC::continuity(gamma.end_jet(3), input.psi).c_order, 3);
}

// Checks the orthogonality that the sequential and the joint strategies produce, at an end with the
// given jet x and the blend y.
template <class Traits>
void check_orthogonality(const Jet<Traits>& x, const Jet<Traits>& g3, const Jet<Traits>& f3, const Jet<Traits>& joint) {
  const Column<Traits> n = GC::orthogonal_component(x[2], x[1]);
  for (const Jet<Traits>& y : {g3, f3}) {
    BOOST_CHECK(dot(y[2], x[1]) == FT(0)); // |gamma''| is least
    BOOST_CHECK(dot(y[3], x[1]) == FT(0)); // then |gamma'''|, over beta_3
  }
  BOOST_CHECK(dot(f3[3], n) == FT(0)); // and over mu
  BOOST_CHECK(dot(joint[3], x[1]) == FT(0) && dot(joint[3], n) == FT(0));
}

TEST_WITH_RANDOM_INPUT_IF(geometry_of_the_strategies, exact) {
  const Blend_input<Traits> input = random_blend<Traits>(random, d, 3);
  const Blend<Traits> g3 = input(GC::Sequential_g3()), f3 = input(GC::Sequential_f3()), joint = input(GC::Joint_g3());
  check_orthogonality(input.phi, g3.start_jet(3), f3.start_jet(3), joint.start_jet(3));
  check_orthogonality(input.psi, g3.end_jet(3), f3.end_jet(3), joint.end_jet(3));
  // any other value is longer
  const Column<Traits> best2 = g3.start_jet(3)[2], best3 = joint.start_jet(3)[3];
  for (int side : {1, -1}) {
    End_parameters p = g3.parameters.start;
    p.beta2 += FT(side);
    const Column<Traits> second = input(Given{p, {}}).start_jet(2)[2];
    BOOST_CHECK(dot(best2, best2) < dot(second, second));
    p = joint.parameters.start;
    p.beta2 += ratio(side, 9);
    p.mu = mu_of_g3(input.shape.beta, p);
    const Column<Traits> third = input(Given{p, {}}).start_jet(3)[3];
    BOOST_CHECK(dot(best3, best3) < dot(third, third));
  }
}

// The energy is a quadratic function of (beta_2, beta_3) at both ends.
template <int k, class Traits> void check_minimum(const Blend_input<Traits>& input) {
  const Blend<Traits> gamma = input(GC::Minimal_energy_g3<k>());
  const FT least = gamma.energy(k);
  const auto energy = [&](const FT& b2, const FT& b3, const FT& e2, const FT& e3) -> FT {
    GC::Septic_parameters<FT> p = gamma.parameters;
    p.start.beta2 += b2;
    p.start.beta3 += b3;
    p.end.beta2 += e2;
    p.end.beta3 += e3;
    p.start.mu = mu_of_g3(input.shape.beta, p.start);
    p.end.mu = mu_of_g3(input.shape.eta, p.end);
    return input(Given{p.start, p.end}).energy(k);
  };
  const FT z(0), s(1), t = ratio(1, 3);
  BOOST_CHECK(energy(z, z, z, z) == least);
  const std::vector<FT> steps[] = {{t, z, z, z}, {z, s, z, z}, {z, z, t, z}, {z, z, z, s}, {s, t, FT(-s), t}};
  for (const std::vector<FT>& x : steps) {
    const FT up = energy(x[0], x[1], x[2], x[3]), down = energy(FT(-x[0]), FT(-x[1]), FT(-x[2]), FT(-x[3]));
    BOOST_CHECK(up == down);
    BOOST_CHECK(least < up);
  }
}

TEST_WITH_INPUTS_IF(minimal_energy, (rounds + 1) / 2, exact&& cancels) {
  const Blend_input<Traits> input = random_blend<Traits>(random, d, 3);
  check_minimum<3>(input);
  check_minimum<4>(input);
}

// ---------------------------------------------------------------- degenerate input

// Curvature 0 at one end or at both
TEST_IN_EVERY_SPACE(fallbacks) {
  const Jet<Traits> bent = jet<Traits>(d, {{0}, {2}, {2, 4}, {0, 8, 16}}),
                    straight = jet<Traits>(d, {{3, 4}, {0, 1}, {0, 4}, {1, 2, 3}});
  for (bool start : {false, true})
    for (bool end : {false, true}) {
      const Blend_input<Traits> input{start ? straight : bent, end ? straight : bent, {FT(2), FT(1)}};
      for (const auto& strategy : all_strategies<Traits>())
        BOOST_TEST_CONTEXT(strategy.name << ", curvature 0: " << start << end) {
          const std::string name = strategy.name;
          const bool falls_back = name == "Sequential_f3" || name == "Joint_g3";
          const Blend<Traits> gamma = strategy.blend(input), g3 = input(GC::Sequential_g3());
          BOOST_CHECK_EQUAL(gamma.parameters.fallback_start, start && falls_back);
          BOOST_CHECK_EQUAL(gamma.parameters.fallback_end, end && falls_back);
          if (start && name == "Joint_g3") BOOST_CHECK(gamma.parameters.start == g3.parameters.start);
          if (end && name == "Joint_g3") BOOST_CHECK(gamma.parameters.end == g3.parameters.end);
          if (start && name == "Sequential_f3") BOOST_CHECK(gamma.parameters.start.mu == FT(0));
          if (end && name == "Sequential_f3") BOOST_CHECK(gamma.parameters.end.mu == FT(0));
          if constexpr (exact) {
            const auto left = GC::continuity(input.phi, gamma.start_jet(3)),
                       right = GC::continuity(gamma.end_jet(3), input.psi);
            BOOST_CHECK(left.f_order == std::min(d, 3) && right.f_order == left.f_order);
            const bool g3_asked = name.find("g3") != std::string::npos;
            if (g3_asked || start) BOOST_CHECK_EQUAL(left.g_order, 3);
            if (g3_asked || end) BOOST_CHECK_EQUAL(right.g_order, 3);
          }
        }
    }
}

// The middle part of a curve is found again from the outer ones.
TEST_WITH_RANDOM_INPUT_IF(reproduction, exact&& cancels) {
  const auto check = [&](int degree, const auto& strategy) {
    // three parts of length 1
    const Taylor_curve<Traits> whole(random_jet<Traits>(random, d, degree), FT(0), FT(3));
    const Jet<Traits> phi = whole.jet(FT(1), 3), psi = whole.jet(FT(2), 3);
    if (is_zero(phi[1]) || is_zero(psi[1])) return;
    BOOST_CHECK(GC::blend(phi, psi, strategy, {}).start_jet(7) == whole.jet(FT(1), 7));
  };
  check(1, GC::Sequential_g3());
  check(1, GC::Sequential_f3());
  check(2, GC::Minimal_energy_g3<3>());
  check(3, GC::Minimal_energy_g3<4>());
  check(7, GC::Matching_third_derivative());
}

TEST_IN_EVERY_SPACE(straight_and_closed) {
  for (const auto& strategy : all_strategies<Traits>()) BOOST_TEST_CONTEXT(strategy.name) {
      const Jet<Traits> phi = jet<Traits>(d, {{0}, {1}, {4}, {9}}), psi = jet<Traits>(d, {{7}, {2}, {-1}, {3}});
      const Blend<Traits> line = strategy.blend({phi, psi, {}});
      for (int j = 0; j <= 7; ++j)
        for (int i = 1; i < d; ++i) BOOST_CHECK(line.coordinates(j)[i] == FT(0));
      const Jet<Traits> x = jet<Traits>(d, {{1, 2}, {4, 0}, {0, 8}, {1, 1, 1}}),
                        y = jet<Traits>(d, {{1, 2}, {0, 4}, {8, 0}, {1, 1, -1}});
      const Blend<Traits> loop = strategy.blend({x, y, {FT(2), FT(4)}});
      BOOST_CHECK(loop.coordinates(0) == x[0] && loop.coordinates(7) == y[0]);
      if constexpr (exact) check_joins(Blend_input<Traits>{x, y, {FT(2), FT(4)}}, loop);
    }
}

TEST_IN_EVERY_SPACE(refused_blends) {
  if constexpr (cancels) check_blend_errors<Traits>(d, 3, GC::Minimal_energy_g3<3>());
  check_blend_errors<Traits>(d, 3, GC::Joint_g3());
}

// --------------------------------------------------------- strategies and curves of the user's own

struct Own_strategy {
  template <class Number, int N> GC::Septic_parameters<Number> operator()(const GC::Septic_ends<Number, N>& e) const {
    GC::Septic_parameters<Number> p = GC::Sequential_g3()(e);
    p.start.beta3 += Number(1);
    p.fallback_end = true;
    return p;
  }
};

TEST_WITH_RANDOM_INPUT_IF(own_strategies_and_curves, exact) {
  const Blend_input<Traits> input = random_blend<Traits>(random, d, 3);
  const Blend<Traits> own = input(Own_strategy());
  BOOST_CHECK(own.parameters.start.beta3 == FT(input(GC::Sequential_g3()).parameters.start.beta3 + FT(1)));
  BOOST_CHECK(own.parameters.fallback_end && !own.parameters.fallback_start);
  check_joins(input, own);
  const Blend<Traits> lambda = input([&](const GC::Septic_ends<FT, Curve<Traits>::N>& e) {
    BOOST_CHECK(e.start.x == input.phi[0] && e.start.d1 == input.phi[1] && e.start.d2 == input.phi[2] &&
                e.start.d3 == input.phi[3]);
    BOOST_CHECK(e.end.x == input.psi[0] && e.end.d1 == input.psi[1] && e.end.d2 == input.psi[2] &&
                e.end.d3 == input.psi[3]);
    BOOST_CHECK(e.start.beta == input.shape.beta && e.end.beta == input.shape.eta);
    return GC::Septic_parameters<FT>{own.parameters.start, own.parameters.end};
  });
  BOOST_CHECK(same_points<Traits>(own, lambda));
  BOOST_CHECK(same_points<Traits>(own, input(Given{own.parameters.start, own.parameters.end})));
  check_input_types(input, GC::Sequential_f3());
  const Blend_input<Traits> longer = random_blend<Traits>(random, d, 5);
  const Blend_input<Traits> shorter{truncated(longer.phi, 3), truncated(longer.psi, 3), longer.shape};
  BOOST_CHECK(same_points<Traits>(longer(GC::Joint_g3()), shorter(GC::Joint_g3())));
}

// ---------------------------------------------------------------- rounded numbers

// At an end with derivatives d1, d2, d3 (times beta, beta^2, beta^3) all terms of the closed
// formulas are at most M = (|d1| + |d2| + |d3|)(1 + c)^2 with c = |d2|/|d1| + (|d1| + |d2| + |d3|)
// / |n|, n = d2 orthogonal to d1, and the errors of their factors grow by c^2: 1000 roundings of M
// (1 + c)^2 cover all. Where a minimum is computed, an error of the four scalars counts in second
// order only: elimination is backward stable, so the energy exceeds the least one by at most
// (1000 * 2^-53 * K)^2 of that at zero, where K is the condition of the scaled system. 2^-40 admits
// K up to 2^23.
TEST_WITH_RANDOM_INPUT_IF(rounded_blends, !exact) {
  const Blend_input<Traits> input = random_blend<Traits>(random, d, 3, &Random::number);
  const Blend_input<Reference> reference{
      rational_jet(input.phi), rational_jet(input.psi), {rational(input.shape.beta), rational(input.shape.eta)}};
  double m = length(input.phi[0]) + length(input.psi[0]), c = 0;
  for (bool end : {false, true}) {
    const Jet<Reference>& x = end ? reference.psi : reference.phi;
    const double beta = CGAL::to_double(end ? input.shape.eta : input.shape.beta);
    const double d1 = beta * length(x[1]), d2 = beta * beta * length(x[2]), d3 = beta * beta * beta * length(x[3]);
    const double n = beta * beta * length(GC::orthogonal_component(x[2], x[1]));
    m += d1 + d2 + d3;
    c = std::max(c, d2 / d1 + (d1 + d2 + d3) / n);
  }
  const double bound = 1000 * 0x1p-53 * m * std::pow(1 + c, 4);
  const Strategies<Reference> exactly = all_strategies<Reference>();
  int i = 0;
  for (const auto& strategy : all_strategies<Traits>()) BOOST_TEST_CONTEXT(strategy.name) {
      const Blend<Traits> gamma = strategy.blend(input);
      const Blend<Reference> expected = exactly[i++].blend(reference);
      const std::string name = strategy.name;
      const bool minimal = name.find("Minimal") == 0;
      for (int j = 0; j <= 7; ++j)
        if (!minimal) BOOST_CHECK(within(gamma.coordinates(j), expected.coordinates(j), bound));
      if (!minimal) continue;
      const int k = name.find('4') != std::string::npos ? 4 : 3;
      const auto at = [](const auto& e) {
        typedef GC::Septic_end_parameters<CGAL::Exact_rational> Parameters;
        return Parameters{rational(e.beta2), rational(e.mu), rational(e.beta3)};
      };
      typedef GC::Given_end_parameters<CGAL::Exact_rational> Exact_parameters;
      Exact_parameters p{at(gamma.parameters.start), at(gamma.parameters.end)};
      p.start.mu = 3 * reference.shape.beta * p.start.beta2;
      p.end.mu = 3 * reference.shape.eta * p.end.beta2;
      const CGAL::Exact_rational excess = reference(p).energy(k) - expected.energy(k),
                                 at_zero = reference(Exact_parameters()).energy(k);
      BOOST_CHECK(0 <= excess && CGAL::to_double(excess) <= 0x1p-40 * CGAL::to_double(at_zero));
    }
}

BOOST_AUTO_TEST_SUITE_END()
