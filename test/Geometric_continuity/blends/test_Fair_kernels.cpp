// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Fair blends are exactly smooth on exact kernels, are the same on all kernels, move with their
// curves, and are sensible or refused where no good blend exists.

#define BOOST_TEST_MODULE Fair_kernels
#include "support/test.h"

#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Gmpq.h>
#include <cfenv>

typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Gmpq>> Gmp_3;

typedef std::vector<std::vector<double>> Numbers; // the derivatives

template <class Traits> GC::Curve_jet<Traits> jet(const Numbers& d, const typename Traits::FT& scale = 1) {
  GC::Curve_jet<Traits> x(static_cast<int>(d[0].size()), 3);
  for (std::size_t k = 0; k < d.size(); ++k)
    for (int i = 0; i < x.dimension(); ++i) x[static_cast<int>(k)][i] = typename Traits::FT(d[k][i]) * scale;
  return x;
}

// Two cubics that lead from one to the other.
struct Curves {
  Numbers phi, psi; // control points

  Curves(std::mt19937_64& random, int dimension) : phi(4, std::vector<double>(dimension)), psi(phi) {
    const auto number = [&] { return std::ldexp(static_cast<double>(random() >> 44), -19) - 1; };
    for (int i = 0; i < 4; ++i)
      for (int c = 0; c < dimension; ++c) {
        phi[i][c] = c == 0 ? i - 3 + 0.25 * number() : number();
        psi[i][c] = c == 0 ? i + 2 + 0.25 * number() : number();
      }
  }
};

template <class Traits> GC::Bezier_curve<Traits> curve(const Numbers& points) {
  std::vector<typename Traits::Point> result;
  for (const std::vector<double>& p : points) {
    GC::Coordinates<Traits> x(static_cast<int>(p.size()));
    for (int c = 0; c < x.dimension(); ++c) x[c] = typename Traits::FT(p[c]);
    result.push_back(GC::to_point<Traits>(x));
  }
  return GC::Bezier_curve<Traits>(result.begin(), result.end());
}

// The numbers that were chosen, all as double.
template <class Traits> std::array<double, 4> numbers(const GC::Quintic_blend<Traits>& b) {
  return {CGAL::to_double(b.shape.beta), CGAL::to_double(b.shape.eta), CGAL::to_double(b.parameters.s1),
          CGAL::to_double(b.parameters.s2)};
}

template <class Traits> std::array<double, 4> check_exact(const Curves& curves) {
  const GC::Bezier_curve<Traits> phi = curve<Traits>(curves.phi), psi = curve<Traits>(curves.psi);
  const auto gamma = GC::blend(phi, psi, GC::Fair());
  BOOST_CHECK(GC::is_g2_join(phi, gamma) && GC::is_g2_join(gamma, psi));
  BOOST_CHECK_GE(GC::continuity(phi, gamma).g_order, 2);
  BOOST_CHECK_GE(GC::continuity(gamma, psi).g_order, 2);
  const auto g3 = GC::blend(phi, psi, GC::Fair_g3());
  BOOST_CHECK_GE(GC::continuity(phi, g3).g_order, 3);
  BOOST_CHECK_GE(GC::continuity(g3, psi).g_order, 3);
  const auto f3 = GC::blend(phi, psi, GC::Fair_f3());
  const int f_order = phi.dimension() == 2 ? 2 : 3;
  BOOST_CHECK_GE(GC::continuity(phi, f3).f_order, f_order);
  BOOST_CHECK_GE(GC::continuity(f3, psi).f_order, f_order);
  // short
  for (double x : numbers(gamma)) BOOST_CHECK_EQUAL(std::ldexp(x, 20), std::floor(std::ldexp(x, 20)));
  return numbers(gamma);
}

BOOST_AUTO_TEST_CASE(exact_and_the_same_on_all_kernels) {
  std::mt19937_64 random = seeded<std::mt19937_64>(11);
  for (int i = 0; i < 4; ++i) {
    const Curves plane(random, 2), space(random, 3);
    const std::array<double, 4> x = numbers(
                                    GC::blend(curve<Double_2>(plane.phi), curve<Double_2>(plane.psi), GC::Fair())),
                                y = numbers(
                                    GC::blend(curve<Double_3>(space.phi), curve<Double_3>(space.psi), GC::Fair()));
    BOOST_CHECK(check_exact<Exact_2>(plane) == x);
    BOOST_CHECK(check_exact<Epeck_2>(plane) == x);
    BOOST_CHECK(check_exact<Exact_3>(space) == y);
    BOOST_CHECK(check_exact<Gmp_3>(space) == y);
  }
  for (int dimension : {2, 3, 4, 5}) check_exact<Exact_d>(Curves(random, dimension));
}

// The rounding mode that the caller left set does not matter to exact kernels.
BOOST_AUTO_TEST_CASE(rounding_modes) {
  std::mt19937_64 random = seeded<std::mt19937_64>(14);
  const auto in_every_mode = [](const auto& phi, const auto& psi, const auto& strategy) {
    const auto nearest = GC::blend(phi, psi, strategy);
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      std::fesetround(mode);
      const auto gamma = GC::blend(phi, psi, strategy);
      const bool kept = std::fegetround() == mode;
      std::fesetround(FE_TONEAREST);
      BOOST_CHECK(kept);
      bool equal = true;
      for (int j = 0; j <= gamma.degree(); ++j) equal = equal && gamma.control_point(j) == nearest.control_point(j);
      BOOST_CHECK(equal);
    }
  };
  // of all sizes, so that many searches are long
  const auto derivatives = [&](int dimension) {
    Numbers d(4, std::vector<double>(dimension));
    for (std::vector<double>& v : d)
      for (double& x : v) {
        const int size = static_cast<int>(random() % 20) - 10;
        x = std::ldexp(static_cast<double>(random() >> 40) - 0x1p23, size - 23);
      }
    return d;
  };
  for (int i = 0; i < 60; ++i) {
    const Numbers phi = derivatives(2), psi = derivatives(2), phi_3 = derivatives(3), psi_3 = derivatives(3);
    in_every_mode(jet<Exact_2>(phi), jet<Exact_2>(psi), GC::Fair());
    in_every_mode(jet<Epeck_2>(phi), jet<Epeck_2>(psi), GC::Fair());
    in_every_mode(jet<Gmp_3>(phi_3), jet<Gmp_3>(psi_3), GC::Fair());
    if (i % 3 != 0) continue;
    in_every_mode(jet<Exact_2>(phi), jet<Exact_2>(psi), GC::Fair_g3());
    in_every_mode(jet<Exact_3>(phi_3), jet<Exact_3>(psi_3), GC::Fair_f3());
    in_every_mode(jet<Exact_d>(derivatives(4)), jet<Exact_d>(derivatives(4)), GC::Fair());
  }
}

// Scaled by a power of two: the same numbers. Turned, mirrored, and from the other side: as fair,
// and the same but for rounding.
BOOST_AUTO_TEST_CASE(invariance) {
  std::mt19937_64 random(13);
  for (int i = 0; i < 10; ++i) {
    const Curves c(random, 2);
    const GC::Curve_jet<Double_2> phi = curve<Double_2>(c.phi).end_jet(3), psi = curve<Double_2>(c.psi).start_jet(3);
    const auto image = [](const GC::Curve_jet<Double_2>& x, double a, double b, double sign, bool reversed) {
      GC::Curve_jet<Double_2> y = x; // turned and scaled by a + bi, after reflection when sign < 0
      for (int k = 0; k <= x.order(); ++k) {
        const double direction = reversed && k % 2 == 1 ? -1 : 1;
        y[k][0] = direction * (a * x[k][0] - b * sign * x[k][1]);
        y[k][1] = direction * (b * x[k][0] + a * sign * x[k][1]);
      }
      return y;
    };
    const auto gamma = GC::blend(phi, psi, GC::Fair());
    for (double scale : {0x1p20, 0x1p-60}) {
      const auto scaled = GC::blend(image(phi, scale, 0, 1, false), image(psi, scale, 0, 1, false), GC::Fair());
      BOOST_CHECK(numbers(scaled) == numbers(gamma));
    }
    const auto turned = GC::blend(image(phi, 1.7, 0.6, 1, false), image(psi, 1.7, 0.6, 1, false), GC::Fair()),
               mirrored = GC::blend(image(phi, 1, 0, -1, false), image(psi, 1, 0, -1, false), GC::Fair()),
               swapped = GC::blend(image(psi, 1, 0, 1, true), image(phi, 1, 0, 1, true), GC::Fair());
    BOOST_CHECK_CLOSE(turned.report.fairness, gamma.report.fairness, 0.1);
    BOOST_CHECK_CLOSE(mirrored.report.fairness, gamma.report.fairness, 0.1);
    BOOST_CHECK_CLOSE(swapped.report.fairness, gamma.report.fairness, 0.1);
    BOOST_CHECK_CLOSE(swapped.shape.beta, gamma.shape.eta, 5);
  }
}

// Every blend must satisfy this, however strange its ends are. Points stay within `reach` of the
// ends.
template <class Strategy>
auto sensible(const Numbers& phi, const Numbers& psi, const Strategy& strategy, double reach) {
  const auto gamma = GC::blend(jet<Double_2>(phi), jet<Double_2>(psi), strategy);
  BOOST_CHECK(std::isfinite(gamma.report.fairness));
  BOOST_CHECK_LE(gamma.report.fairness, gamma.report.automatic_fairness);
  for (int j = 0; j <= gamma.degree(); ++j)
    for (int i = 0; i < 2; ++i) BOOST_CHECK_LE(std::abs(gamma.control_point(j)[i]), reach);
  return gamma;
}

BOOST_AUTO_TEST_CASE(lines) {
  // a fillet, symmetric to the line x + y = 0
  const auto fillet = sensible({{-1, 0}, {1, 0}}, {{0, 1}, {0, 1}}, GC::Fair(), 1);
  BOOST_CHECK(fillet.report.converged);
  BOOST_CHECK_LE(fillet.report.fairness, 31);
  for (int j = 0; j <= 5; ++j)
    for (int i = 0; i < 2; ++i)
      BOOST_CHECK_SMALL(fillet.control_point(j)[i] + fillet.control_point(5 - j)[1 - i], 1e-12);
  // an S, symmetric to its middle, and a U
  const auto s = sensible({{0, 0}, {1, 0}}, {{2, 1}, {1, 0}}, GC::Fair(), 2);
  BOOST_CHECK(s.report.converged);
  for (int j = 0; j <= 5; ++j) BOOST_CHECK_SMALL(s.control_point(j)[0] + s.control_point(5 - j)[0] - 2, 1e-12);
  const auto u = sensible({{0, 0}, {1, 0}}, {{0, 1}, {-1, 0}}, GC::Fair(), 2);
  BOOST_CHECK(u.report.converged);
  BOOST_CHECK_LE(u.report.fairness, 125);
  for (int j = 0; j <= 5; ++j) BOOST_CHECK_SMALL(u.control_point(j)[0] - u.control_point(5 - j)[0], 1e-12);
  // one line gives the line, exactly and forward
  const auto line = GC::blend(jet<Exact_2>({{0, 0}, {2, 1}}), jet<Exact_2>({{4, 2}, {6, 3}}), GC::Fair());
  BOOST_CHECK(line.report.converged);
  for (int j = 0; j <= 5; ++j) {
    BOOST_CHECK(line.control_point(j)[0] == 2 * line.control_point(j)[1]);
    if (j > 0) BOOST_CHECK(line.control_point(j - 1)[0] < line.control_point(j)[0]);
  }
  // backwards on one line there is a cusp, and with tangents that point away from each other almost
  // one
  BOOST_CHECK(!sensible({{0, 0}, {-1, 0}}, {{3, 0}, {-1, 0}}, GC::Fair(), 30).report.converged);
  BOOST_CHECK_GE(sensible({{0, 0}, {-1, 0.3}}, {{3, 0}, {-1, 0}}, GC::Fair(), 30).report.fairness, 1e6);
}

BOOST_AUTO_TEST_CASE(curvatures) {
  // an arc of a circle
  const Numbers right = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, top = {{0, 1}, {-1, 0}, {0, -1}, {1, 0}};
  const auto arc = sensible(right, top, GC::Fair(), 2);
  BOOST_CHECK(arc.report.converged);
  BOOST_CHECK_LE(arc.report.fairness, 0.001);
  BOOST_CHECK_LE(sensible(right, top, GC::Fair_g3(), 2).report.fairness, 0.001);
  // a loop, a straight side, curvatures 1 : 10^6
  BOOST_CHECK(sensible({{0, 0}, {1, 1}}, {{1, 0}, {1, -3}}, GC::Fair(), 5).report.converged);
  BOOST_CHECK(sensible({{0, 0}, {1, 0}}, {{2, 1}, {0, 1}, {-2, 0}}, GC::Fair(), 5).report.converged);
  BOOST_CHECK(sensible({{0, 0}, {1, 0}, {0, 1e-6}}, {{2, 1}, {0, 1}, {-1, 0}}, GC::Fair(), 5).report.converged);
  // next to which the chord is long: a curve that does not go far away, and is reported as not
  // converged
  for (double curvature : {1e6, -1e6, 1e9, -1e9, 1e12, -1e12}) {
    const auto curl = sensible({{0, 0}, {1, 0}, {0, 1}}, {{2, 1}, {0, 1}, {curvature, 0}}, GC::Fair(), 10);
    BOOST_CHECK(!curl.report.converged);
    if (std::abs(curvature) < 1e7) BOOST_CHECK_LE(curl.report.fairness, curl.report.automatic_fairness / 1000);
  }
}

BOOST_AUTO_TEST_CASE(ends_that_meet) {
  for (double distance : {0., 1e-12, 1e-200})
    for (const Numbers& psi : {Numbers{{distance, 0}, {0, 1}}, Numbers{{distance, 0}, {1, 0}, {0, 1}},
                               Numbers{{distance, 0}, {-1, 0}, {0, 1}}}) {
      sensible({{0, 0}, {1, 0}, {0, 1}}, psi, GC::Fair(), 10);
      sensible({{0, 0}, {1, 0}, {0, 1}}, psi, GC::Fair_g3(), 100);
      sensible({{0, 0}, {1, 0}, {0, 1}}, psi, GC::Fair_f3(), 100);
    }
}

BOOST_AUTO_TEST_CASE(numbers_of_any_size) {
  const Numbers a = {{0, 0}, {3, 1}, {1, 0}}, b = {{5, 2}, {2, -1}, {0, 1}};
  const auto gamma = GC::blend(jet<Exact_2>(a), jet<Exact_2>(b), GC::Fair());
  for (int exponent : {400, -400}) {
    Q scale(1);
    for (int i = 0; i < 400; ++i) scale = exponent > 0 ? Q(scale * 10) : Q(scale / 10);
    const auto scaled = GC::blend(jet<Exact_2>(a, scale), jet<Exact_2>(b, scale), GC::Fair());
    BOOST_CHECK(scaled.report.converged);
    BOOST_CHECK_CLOSE(scaled.report.fairness, gamma.report.fairness, 0.1);
    // the derivatives of one end only: that leaves no double of them next to the chord
    const std::string place = "not_finite: fair blend: derivatives that are too large or too small for the chord";
    BOOST_CHECK_EQUAL(error_of([&] { GC::blend(jet<Exact_2>(a, scale), jet<Exact_2>(b), GC::Fair()); }), place);
    BOOST_CHECK_EQUAL(error_of([&] { GC::blend(jet<Exact_2>(a, scale), jet<Exact_2>(b), GC::Fair_g3()); }), place);
  }
  for (double scale : {1e60, 1e-60}) {
    const auto scaled = GC::blend(jet<Double_2>(a, scale), jet<Double_2>(b, scale), GC::Fair());
    BOOST_CHECK_CLOSE(scaled.report.fairness, gamma.report.fairness, 0.1);
  }
  for (double scale : {1e150, 1e-150, 1e300, 1e-300}) // where squares overflow, or underflow
    try {
      BOOST_CHECK_GT(GC::blend(jet<Double_2>(a, scale), jet<Double_2>(b, scale), GC::Fair()).shape.beta, 0);
    } catch (const GC::Error& e) {
      BOOST_CHECK(e.code() == GC::Error_code::not_finite || e.code() == GC::Error_code::zero_tangent);
    }
  for (double x : {infinity, std::nan("")})
    for (int k : {0, 1, 2}) {
      Numbers wrong = a;
      wrong[k][0] = x;
      CHECK_ERROR(GC::blend(jet<Double_2>(wrong), jet<Double_2>(b), GC::Fair()), not_finite);
      CHECK_ERROR(GC::blend(jet<Double_2>(b), jet<Double_2>(wrong), GC::Fair_g3()), not_finite);
    }
}
