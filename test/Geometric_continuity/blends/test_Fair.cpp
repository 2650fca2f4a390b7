// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Fair blends are as fair as they can be: compared with an optimum that shares nothing with the
// package. E is computed by the textbook formulas of curvature and torsion, and minimised without
// derivatives.

#define BOOST_TEST_MODULE Fair

#include "support/allocations.h"
#include "support/fairness.h"
#include "support/test.h"

#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>
#include <boost/config.hpp>

typedef std::tuple<Double_2, Double_3> Traits_classes;

// The method of Nelder and Mead, from x with edges of the given lengths. Returns the least value; x
// is where it is.
template <std::size_t n, class Function>
double least_value(const Function& f, std::array<double, n>& x, const std::array<double, n>& edges) {
  typedef std::pair<double, std::array<double, n>> Corner;
  std::array<Corner, n + 1> simplex;
  simplex.fill({0, x});
  for (std::size_t i = 0; i < n; ++i) simplex[i + 1].second[i] += edges[i];
  for (Corner& c : simplex) c.first = f(c.second);
  for (int step = 0; step < 300; ++step) {
    std::sort(simplex.begin(), simplex.end());
    Corner& worst = simplex.back();
    if (worst.first - simplex[0].first <= 1e-6 * simplex[0].first) break;
    std::array<double, n> centre{};
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k) centre[k] += simplex[i].second[k] / n;
    const auto at = [&](double r) {
      std::array<double, n> y;
      for (std::size_t k = 0; k < n; ++k) y[k] = centre[k] + r * (worst.second[k] - centre[k]);
      return Corner(f(y), y);
    };
    const Corner reflected = at(-1);
    if (reflected.first < simplex[0].first)
      worst = (std::min)(reflected, at(-2));
    else if (reflected.first < simplex[n - 1].first)
      worst = reflected;
    else {
      const Corner nearer = at(reflected.first < worst.first ? -0.5 : 0.5);
      if (nearer.first < (std::min)(reflected.first, worst.first))
        worst = nearer;
      else
        for (std::size_t i = 1; i <= n; ++i) {
          for (std::size_t k = 0; k < n; ++k) simplex[i].second[k] = (simplex[i].second[k] + simplex[0].second[k]) / 2;
          simplex[i].first = f(simplex[i].second);
        }
    }
  }
  std::sort(simplex.begin(), simplex.end());
  x = simplex[0].second;
  return simplex[0].first;
}

// The least E near the automatic shape, over the logarithms of the changes of beta and eta, and s1
// and s2.
template <class Traits, int N = Traits::Dimension::value>
double independent_optimum(const GC::Curve_jet<Traits>& phi, const GC::Curve_jet<Traits>& psi) {
  const GC::Quintic_blend<Traits> automatic = GC::blend(phi, psi);
  // a point 2/5 + s of the tangent, and a twentieth of the second derivative's normal part, away
  // from the end
  const auto add_end = [&](const GC::Curve_jet<Traits>& jet, double beta, double s, int sign, Vector<N>& b,
                           Vector<N>& c) {
    double g = 0, h = 0;
    for (int i = 0; i < N; ++i) {
      g += jet[1][i] * jet[1][i];
      h += jet[1][i] * jet[2][i];
    }
    for (int i = 0; i < N; ++i) {
      b[i] = jet[0][i] + sign * beta * jet[1][i] / 5;
      c[i] = jet[0][i] + (sign * 0.4 + s) * beta * jet[1][i] + beta * beta * (jet[2][i] - h / g * jet[1][i]) / 20;
    }
  };
  const auto e = [&](const std::array<double, 4>& x) {
    const double bound = std::log(4.), none = std::numeric_limits<double>::infinity();
    if (!(std::abs(x[0]) <= bound && std::abs(x[1]) <= bound)) return none;
    std::array<Vector<N>, 6> p;
    for (int i = 0; i < N; ++i) {
      p[0][i] = phi[0][i];
      p[5][i] = psi[0][i];
    }
    add_end(phi, automatic.shape.beta * std::exp(x[0]), x[2], 1, p[1], p[2]);
    add_end(psi, automatic.shape.eta * std::exp(x[1]), x[3], -1, p[4], p[3]);
    const double value = fairness<N>(p, 256);
    return value >= 0 ? value : none;
  };
  std::array<double, 4> x = {0, 0, automatic.parameters.s1, automatic.parameters.s2};
  least_value(e, x, {0.1, 0.1, 0.03, 0.03});
  least_value(e, x, {0.1, -0.1, 0.03, -0.03});
  return least_value(e, x, {-0.05, -0.05, 0.02, 0.02});
}

double quantile(std::vector<double> x, double part) {
  std::sort(x.begin(), x.end());
  return x[static_cast<std::size_t>(part * static_cast<double>(x.size() - 1))];
}

// On pairs with seeds for which a search from the automatic blend alone ends in space at 1.9 to 2.4
// times the optimum, and in the plane at 1.6 times.
template <class Traits> void compare_with_optimum() {
  constexpr int pairs_of_a_seed = 160;
  std::vector<double> ratio;
  int converged = 0;
  for (unsigned seed : {1U, 2U, 3U, 6U}) {
    std::mt19937_64 random(seed);
    for (int i = 0; i < pairs_of_a_seed; ++i) {
      BOOST_TEST_CONTEXT("seed " << seed << ", pair " << i) {
        const Pair<Traits> p(random, false);
        const auto gamma = GC::blend(p.phi, p.psi, GC::Fair());
        const double e = fairness(gamma), automatic = fairness(GC::blend(p.phi, p.psi));
        BOOST_CHECK_LE(e, automatic * 1.0001);
        BOOST_CHECK_CLOSE(e, gamma.report.fairness, 1);
        BOOST_CHECK_GE(gamma.report.iterations, 0);
        converged += gamma.report.converged;
        ratio.push_back(e / independent_optimum(p.phi, p.psi));
        BOOST_CHECK_LE(ratio.back(), 1.5);
      }
    }
  }
  const std::size_t pairs = ratio.size();
  BOOST_TEST_MESSAGE("E / optimum: median " << quantile(ratio, 0.5) << ", 95 % " << quantile(ratio, 0.95)
                                            << ", largest " << quantile(ratio, 1) << "; converged " << converged
                                            << " of " << pairs);
  BOOST_CHECK_LE(quantile(ratio, 0.5), 1.005);
  BOOST_CHECK_LE(quantile(ratio, 0.95), 1.02);
  BOOST_CHECK_GE(converged, 0.98 * static_cast<double>(pairs));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(optimum, Traits, Traits_classes) { compare_with_optimum<Traits>(); }

BOOST_AUTO_TEST_CASE(reports) {
  BOOST_CHECK_EQUAL(text(GC::Fair_report{8, 176.5, 158.25, true}, '\n', GC::Fair_report{1, 2, 2, false}),
                    "E = 158.25, from 176.5 in 8 steps\nE = 2, from 2 in 1 steps, not converged");
}

// Where nothing good may exist: never worse than the automatic shape, and the same again.
BOOST_AUTO_TEST_CASE_TEMPLATE(wild_pairs, Traits, Traits_classes) {
  std::mt19937_64 random = seeded<std::mt19937_64>(4);
  std::vector<double> gain;
  for (int i = 0; i < 300; ++i) {
    const Pair<Traits> p(random, true);
    const auto gamma = GC::blend(p.phi, p.psi, GC::Fair()), again = GC::blend(p.phi, p.psi, GC::Fair());
    for (int j = 0; j <= 5; ++j) BOOST_CHECK(gamma.control_point(j) == again.control_point(j));
    const double e = fairness(gamma), automatic = fairness(GC::blend(p.phi, p.psi));
    BOOST_CHECK(std::isfinite(e) && std::isfinite(gamma.report.fairness));
    BOOST_CHECK_LE(gamma.report.fairness, gamma.report.automatic_fairness);
    BOOST_CHECK_LE(e, automatic * 1.01);
    gain.push_back(automatic / e);
  }
  BOOST_TEST_MESSAGE("automatic / fair: median " << quantile(gain, 0.5));
  BOOST_CHECK_GE(quantile(gain, 0.5), 100);
}

// Shapes and domains of any size: a given shape is kept, what overflows is refused, and a search
// that finds nothing better says so.
BOOST_AUTO_TEST_CASE(extreme_shapes) {
  typedef Double_2::Point P;
  typedef GC::Bezier_curve<Double_2> Curve;
  const Curve phi = {P(-2, 1), P(-1, 0), P(0, 0)}, psi = {P(2, 1), P(3, 0), P(3, -1)};
  for (const double beta : {1e-100, 1e30, 1e100}) {
    const auto g2 = GC::blend(phi, psi, GC::Fair(), {beta, 1});
    const auto g3 = GC::blend(phi, psi, GC::Fair_g3(), {beta, 1});
    BOOST_CHECK(g2.shape.beta == beta && g2.shape.eta == 1 && g3.shape.beta == beta && g3.shape.eta == 1);
    for (int i = 0; i <= 5; ++i) BOOST_CHECK(std::isfinite(g2.control_point(i).x()));
  }
  for (const double beta : {1e-300, 1e200, 1.5e308}) {
    CHECK_ERROR(GC::blend(phi, psi, GC::Fair(), {beta, 1}), not_finite);
    CHECK_ERROR(GC::blend(phi, psi, GC::Fair_g3(), {beta, 1}), not_finite);
  }
  // with one end in common
  const Curve short_end = {P(1e-150, 0), P(0, 0)}, short_start = {P(0, 0), P(0, 1e-150)};
  CHECK_ERROR(GC::blend(short_end, short_start, GC::Fair(), {1e-200, 1e-200}), not_finite);
  const auto over = [](const Curve& c, double length) { return Curve(c.begin(), c.end(), 0, length); };
  const double least = GC::blend(phi, psi, GC::Fair()).report.fairness;
  for (const double length : {1e-30, 1e-10, 1e20})
    BOOST_CHECK_CLOSE(GC::blend(over(phi, length), psi, GC::Fair()).report.fairness, least, 0.1);
  const auto loops = GC::blend(over(phi, 1e-100), psi, GC::Fair());
  BOOST_CHECK_LE(loops.report.fairness, loops.report.automatic_fairness);
  const Curve winding = {P(1, -1), P(-1, -1), P(1, 0), P(-1, -1), P(0, -1)}, line = {P(1, 0), P(1, 1)};
  for (const double length : {1e-81, 1e-60, 1e-40}) {
    const auto report = GC::blend(over(winding, length), line, GC::Fair()).report;
    BOOST_CHECK(!report.converged && report.fairness == report.automatic_fairness && report.iterations > 0);
  }
}

// More freedom is not worse, and a given shape is kept.
BOOST_AUTO_TEST_CASE_TEMPLATE(septic_blends, Traits, Traits_classes) {
  std::mt19937_64 random = seeded<std::mt19937_64>(5);
  int converged = 0, better = 0, pairs = 200;
  std::vector<double> ratio;
  for (int i = 0; i < pairs; ++i) {
    const Pair<Traits> p(random, false);
    const auto g3 = GC::blend(p.phi, p.psi, GC::Fair_g3());
    const auto f3 = GC::blend(p.phi, p.psi, GC::Fair_f3());
    const double e = fairness(g3), e_f3 = fairness(f3),
                 automatic = fairness(GC::blend(p.phi, p.psi, GC::Minimal_energy_g3<4>()));
    BOOST_CHECK_LE(e, automatic * 1.001);
    BOOST_CHECK_LE(e_f3, e * 1.01);
    better += e_f3 < e;
    converged += g3.report.converged && f3.report.converged;
    ratio.push_back(e / fairness(GC::blend(p.phi, p.psi, GC::Fair())));

    const GC::Shape_parameters<double> shape(1.5, 0.75);
    const auto given = GC::blend(p.phi, p.psi, GC::Fair(), shape);
    BOOST_CHECK(given.shape.beta == 1.5 && given.shape.eta == 0.75);
    const double least = fairness(GC::blend(p.phi, p.psi, GC::Minimal_energy<3>(), shape)),
                 least_g3 = fairness(GC::blend(p.phi, p.psi, GC::Minimal_energy_g3<4>(), shape));
    constexpr double cusp = 1e9; // no quadrature is to be trusted there
    BOOST_CHECK(fairness(given) <= least * 1.001 || least > cusp);
    const auto given_g3 = GC::blend(p.phi, p.psi, GC::Fair_g3(), shape);
    BOOST_CHECK(fairness(given_g3) <= least_g3 * 1.001 || least_g3 > cusp);
  }
  BOOST_TEST_MESSAGE("E of G3 / E of G2: median " << quantile(ratio, 0.5) << "; F3 better " << better << ", converged "
                                                  << converged << " of " << pairs);
  BOOST_CHECK_LE(quantile(ratio, 0.5), 1.05);
  BOOST_CHECK_GE(better, pairs * 0.8);
  BOOST_CHECK_GE(converged, pairs * 0.95);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(nothing_is_allocated, Traits, Traits_classes) {
  std::mt19937_64 random(6);
  for (bool wild : {false, true})
    for (int i = 0; i < 20; ++i) {
      const Pair<Traits> p(random, wild);
      const std::size_t before = allocations;
      const auto fair = GC::Fair().choose(p.phi, p.psi);
      const auto g3 = GC::Fair_g3().choose(p.phi, p.psi);
      const auto f3 = GC::Fair_f3().choose(p.phi, p.psi);
      const std::size_t after = allocations;
      BOOST_CHECK_EQUAL(after - before, 0U);
      BOOST_CHECK(fair.shape.beta > 0 && g3.shape.beta > 0 && f3.shape.beta > 0);
    }
}
