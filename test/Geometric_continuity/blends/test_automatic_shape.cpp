// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The shape parameters by the chord: rounded exactly, the same on every kernel, and defined for
// every chord.

#include "support/rounding_modes.h"
#include "support/test.h"

#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/blend_ends.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/fairness.h>

BOOST_AUTO_TEST_SUITE(automatic_shape)

// A jet of order 2 with a point and a tangent.
template <class Traits, class T> GC::Curve_jet<Traits> jet(const std::vector<T>& point, const std::vector<T>& tangent) {
  GC::Curve_jet<Traits> x(static_cast<int>(point.size()), 2);
  for (int i = 0; i < x.dimension(); ++i) {
    x[0][i] = typename Traits::FT(point[i]);
    x[1][i] = typename Traits::FT(tangent[i]);
  }
  return x;
}

template <class Traits, class T>
double beta(const std::vector<T>& a1, const std::vector<T>& a2, const std::vector<T>& d) {
  const GC::Shape_parameters<typename Traits::FT> s =
      GC::automatic_shape(jet<Traits>(a1, d), jet<Traits>(a2, std::vector<T>(d.size(), T(1))));
  BOOST_CHECK(typename Traits::FT(CGAL::to_double(s.beta)) == s.beta);
  return CGAL::to_double(s.beta);
}

// Returns whether b has 8 binary digits, and no such number is nearer to the root of x/y; of two
// the larger one.
bool is_nearest(double b, const Q& x, const Q& y) {
  const double unit = std::ldexp(1., std::ilogb(b) - 7);
  if (std::fmod(b, unit) != 0) return false;
  // to the next smaller number
  const double below = std::ldexp(1., std::ilogb(b)) == b ? unit / 2 : unit;
  const Q low = Q(b) - Q(below) / 2, high = Q(b) + Q(unit) / 2;
  return low * low * y <= x && x < high * high * y;
}

BOOST_AUTO_TEST_CASE(nearest_short_number) {
  std::mt19937_64 random = seeded<std::mt19937_64>(41);
  const auto number = [&](int bits) {
    const double digits = static_cast<double>(static_cast<long long>(random() >> (64 - bits))) + 1;
    return std::ldexp(digits, -static_cast<int>(random() % 40));
  };
  for (int round = 0; round < 2000; ++round) {
    const int bits = round % 2 == 0 ? 53 : 9;
    const std::vector<double> a1 = {number(bits), number(bits)}, a2 = {number(bits), number(bits)},
                              d = {number(bits), -number(bits)};
    Q x(0), y(0);
    for (int i = 0; i < 2; ++i) {
      x += (Q(a2[i]) - Q(a1[i])) * (Q(a2[i]) - Q(a1[i]));
      y += Q(d[i]) * Q(d[i]);
    }
    const double b = beta<Exact_2>(a1, a2, d);
    BOOST_CHECK(is_nearest(b, x, y));
    BOOST_CHECK_EQUAL(beta<Double_2>(a1, a2, d), b);
    BOOST_CHECK_EQUAL(beta<Epeck_2>(a1, a2, d), b);
    BOOST_CHECK_EQUAL(beta<Exact_d>(a1, a2, d), b);
  }
}

// A chord of 3, 4, 5 times a number in the middle of two short ones: the larger one, on every
// kernel and in every rounding mode.
BOOST_AUTO_TEST_CASE(ties) {
  for (int k = 128; k < 256; k += 5)
    for (int e : {-30, 0, 17}) {
      const double middle = std::ldexp(2. * k + 1, e - 1), up = std::ldexp(k + 1., e);
      const std::vector<double> origin = {0, 0}, a2 = {3 * middle, 4 * middle}, d = {0, 5};
      for (const int mode : rounding_modes())
        BOOST_CHECK_EQUAL(in_rounding_mode(mode, [&] { return beta<Double_2>(origin, a2, d); }), up);
      BOOST_CHECK_EQUAL(beta<Exact_2>(origin, a2, d), up);
      BOOST_CHECK_EQUAL(beta<Epeck_2>(origin, a2, d), up);
      // the least bit less
      const std::vector<double> less = {3 * middle, std::nextafter(4 * middle, 0)};
      BOOST_CHECK_EQUAL(beta<Double_2>(origin, less, d), std::ldexp(k, e));
      BOOST_CHECK_EQUAL(beta<Exact_2>(origin, less, d), std::ldexp(k, e));
    }
}

BOOST_AUTO_TEST_CASE(chords_of_every_size) {
  const std::vector<double> zero = {0, 0}, one = {1, 0};
  BOOST_CHECK_EQUAL(beta<Double_2>(one, one, one), 1); // coincident ends
  BOOST_CHECK_EQUAL(beta<Exact_2>(one, one, one), 1);
  const std::vector<Q> q = {Q(1), Q(2), Q(3), Q(4)};
  BOOST_CHECK_EQUAL(beta<Exact_d>(q, q, q), 1);
  for (double x : {5e-324, 1e-308, 1e-300, 1e-31}) // astronomically small
    for (double b :
         {beta<Double_2>(zero, {x, 0}, one), beta<Exact_2>(zero, {x, 0}, one), beta<Epeck_2>(zero, {x, 0}, one)})
      BOOST_CHECK_EQUAL(b, 1);
  BOOST_CHECK_EQUAL(beta<Double_2>(zero, {0x1p-100, 0}, one), 0x1p-100);
  for (double x : {1e31, 1e300, 1.7e308})
    for (double b :
         {beta<Double_2>(zero, {x, 0}, one), beta<Exact_2>(zero, {x, 0}, one), beta<Epeck_2>(zero, {-x, x}, one)})
      BOOST_CHECK_EQUAL(b, 0x1p100);
  // the difference overflows
  BOOST_CHECK_EQUAL((beta<Double_2, double>({-1.7e308, 0}, {1.7e308, 0}, {1.7e308, 0})), 2);
  // squares underflow
  BOOST_CHECK_EQUAL((beta<Double_2, double>({0, 0}, {3 * 5e-324, 0}, {0, 2 * 5e-324})), 1.5);
  Q huge(1);
  for (int i = 0; i < 4000; ++i) huge *= 10;
  BOOST_CHECK_EQUAL(beta<Exact_2>(std::vector<Q>{0, 0}, {3 * huge, 4 * huge}, {huge, 0}), 5);
  BOOST_CHECK_EQUAL(beta<Exact_2>(std::vector<Q>{0, 0}, {3 / huge, 4 / huge}, {1 / huge, 0}), 5);
}

BOOST_AUTO_TEST_CASE(similarities) {
  const std::vector<double> a1 = {1, 2}, a2 = {4, 9}, d1 = {3, 1}, d2 = {-1, 5};
  const auto shape = [](const auto& phi, const auto& psi) { return GC::automatic_shape(phi, psi); };
  const GC::Shape_parameters<double> s = shape(jet<Double_2>(a1, d1), jet<Double_2>(a2, d2)),
                                     reversed = shape(jet<Double_2>(a2, d2), jet<Double_2>(a1, d1)),
                                     turned = shape(jet<Double_2, double>({2, -1}, {1, -3}),
                                                    jet<Double_2, double>({9, -4}, {5, 1})),
                                     large = shape(jet<Double_2, double>({7, 14}, {21, 7}),
                                                   jet<Double_2, double>({28, 63}, {-7, 35}));
  BOOST_CHECK(s.beta == reversed.eta && s.eta == reversed.beta);
  BOOST_CHECK(s.beta == turned.beta && s.eta == turned.eta);
  BOOST_CHECK(s.beta == large.beta && s.eta == large.eta);
}

// blend() takes these shape parameters when it is given none, and says so.
BOOST_AUTO_TEST_CASE(default_of_blend) {
  GC::Curve_jet<Exact_2> phi = jet<Exact_2, Q>({Q(0), Q(0)}, {Q(3), Q(1)}),
                         psi = jet<Exact_2, Q>({Q(5), Q(2)}, {Q(1), Q(7)});
  const GC::Shape_parameters<Q> shape = GC::automatic_shape(phi, psi);
  BOOST_CHECK(shape.beta != 1 && shape.eta != 1);
  const auto gamma = GC::blend(phi, psi), same = GC::blend(phi, psi, GC::Minimal_energy<3>(), shape),
             old = GC::blend(phi, psi, GC::Minimal_energy<3>(), {1, 1});
  BOOST_CHECK(gamma.shape.beta == shape.beta && gamma.shape.eta == shape.eta);
  BOOST_CHECK(old.shape.beta == 1 && old.shape.eta == 1);
  for (int j = 0; j <= 5; ++j) BOOST_CHECK(gamma.control_point(j) == same.control_point(j));
  BOOST_CHECK(gamma.control_point(1) != old.control_point(1));
  BOOST_CHECK(gamma.start_jet(1)[1] == shape.beta * phi[1]);
  BOOST_CHECK(gamma.end_jet(1)[1] == shape.eta * psi[1]);
}

// The default is a formula: of these curves another shape has the lower E, and the shape of the
// search an even lower one.
BOOST_AUTO_TEST_CASE(no_optimum) {
  const GC::Bezier_curve<Exact_2> phi{{9, 8}, {-4, 8}, {1, -6}, {0, 0}}, psi{{10, 3}, {16, -7}, {16, 0}, {21, -8}};
  const double of_default = GC::fairness(GC::blend(phi, psi)), of_ones = GC::fairness(GC::blend(phi, psi, {1, 1})),
               of_search = GC::fairness(GC::blend(phi, psi, GC::Fair()));
  BOOST_CHECK(of_ones < 0.5 * of_default && of_search < 0.5 * of_ones);
}

BOOST_AUTO_TEST_CASE(errors) {
  const GC::Curve_jet<Double_2> x = jet<Double_2, double>({0, 0}, {1, 0}), y = jet<Double_2, double>({1, 0}, {0, 0});
  CHECK_ERROR(GC::automatic_shape(x, y), zero_tangent);
  CHECK_ERROR(GC::automatic_shape(y, x), zero_tangent);
  CHECK_ERROR(GC::automatic_shape(x, GC::Curve_jet<Double_2>(2, 0)), jet_order_too_low);
  CHECK_ERROR(GC::automatic_shape(jet<Exact_d, Q>({Q(0), Q(0)}, {Q(1), Q(0)}),
                                  jet<Exact_d, Q>({Q(0), Q(0), Q(0)}, {Q(1), Q(0), Q(0)})),
              dimension_mismatch);
  for (double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_ERROR(GC::automatic_shape(jet<Double_2, double>({bad, 0}, {1, 0}), x), not_finite);
    CHECK_ERROR(GC::automatic_shape(jet<Double_2, double>({0, 0}, {bad, 0}), x), not_finite);
  }
}

BOOST_AUTO_TEST_CASE(equal_parameters_of_ends) {
  typedef GC::Septic_end_parameters<double> Parameters;
  const Parameters p(1, 2, 3);
  BOOST_CHECK(p == Parameters(1, 2, 3));
  for (const Parameters& q : {Parameters(0, 2, 3), Parameters(1, 0, 3), Parameters(1, 2, 0)}) BOOST_CHECK(!(p == q));
}

BOOST_AUTO_TEST_SUITE_END()
