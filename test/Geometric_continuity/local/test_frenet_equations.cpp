// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The Frenet equations.

#include "support/jets.h"

// (t, t^2, t^3, ..., t^n) at t
template <class Traits> Jet<Traits> moment_curve(int n, double t, int k) {
  Jet<Traits> x = zero_jet<Traits>(n, k);
  for (int j = 0; j <= k; ++j)
    for (int i = 0; i < n; ++i) {
      double c = 1;
      for (int l = 0; l < j; ++l) c *= i + 1 - l;
      x[j][i] = j > i + 1 ? 0 : c * std::pow(t, i + 1 - j);
    }
  return x;
}

// The largest difference between the frame's derivatives and its central differences of step h.
template <class Traits> double frame_derivative_error(int n, double h) {
  const double t = 0.5;
  const std::vector<typename Traits::Vector> d = *GC::frenet_frame_derivatives(moment_curve<Traits>(n, t, n));
  const GC::Frenet_frame<Traits> before = GC::frenet_frame(moment_curve<Traits>(n, t - h, n))->normalized(),
                                 after = GC::frenet_frame(moment_curve<Traits>(n, t + h, n))->normalized();
  double error = 0;
  for (int i = 1; i <= n; ++i) {
    const Column<Traits> difference = 1 / (2 * h) * (after.coordinates(i) - before.coordinates(i)),
                         exact = GC::coordinates<Traits>(d[i - 1]);
    for (int j = 0; j < n; ++j) error = std::max(error, std::abs(difference[j] - exact[j]));
  }
  return error;
}

BOOST_AUTO_TEST_CASE(derivatives_of_the_frame) {
  // Central differences have errors in h^2 times third derivatives, and 2^-53 / h by rounding: a
  // tenth of h divides the error by 100 as long as rounding is smaller.
  const auto check = [](double coarse, double fine) {
    BOOST_CHECK_LE(fine, 0.012 * coarse);
    BOOST_CHECK_LE(fine, 1e-3);
  };
  check(frame_derivative_error<Double_2>(2, 1e-2), frame_derivative_error<Double_2>(2, 1e-3));
  check(frame_derivative_error<Double_3>(3, 1e-2), frame_derivative_error<Double_3>(3, 1e-3));
  check(frame_derivative_error<Double_d>(4, 1e-2), frame_derivative_error<Double_d>(4, 1e-3));
  check(frame_derivative_error<Double_d>(5, 1e-2), frame_derivative_error<Double_d>(5, 1e-3));
}

BOOST_AUTO_TEST_CASE(frenet_matrix_of_a_helix) {
  // (3 cos t, 3 sin t, 4 t): |X'| = 5, kappa = 3/25, tau = 4/25
  const Jet<Double_3> x = jet<Double_3>(3, {{3, 0, 0}, {0, 3, 4}, {-3, 0, 0}, {0, -3, 0}});
  const GC::Frenet_matrix<double> w = *GC::frenet_matrix(x);
  const double expected[3][3] = {{0, 0.6, 0}, {-0.6, 0, 0.8}, {0, -0.8, 0}};
  for (int i = 0; i < 3; ++i)
    // a few roundings
    for (int j = 0; j < 3; ++j) BOOST_CHECK_SMALL(w(i + 1, j + 1) - expected[i][j], 1e-15);
  std::ostringstream os;
  os << GC::Frenet_matrix<double>(2, {0.5, -1.5});
  BOOST_CHECK_EQUAL(os.str(), "0 1 0\n-1 0 -3\n0 3 0\n");
  os.str("");
  os << *GC::frenet_frame(jet<Double_3>(3, {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}}));
  BOOST_CHECK_EQUAL(os.str(), "2 0 0\n0 1 0\n0 0 2\n");
  // a right turn in the plane, and points without a frame
  BOOST_CHECK_EQUAL((*GC::frenet_matrix(jet<Double_2>(2, {{0}, {2, 0}, {0, -4}})))(1, 2), -2);
  BOOST_CHECK(!GC::frenet_matrix(jet<Double_2>(2, {{0}, {0}, {0, 1}})));
  BOOST_CHECK(!GC::frenet_matrix(jet<Double_3>(3, {{0}, {1}, {2}, {0, 1}})));
  BOOST_CHECK(!GC::frenet_frame_derivatives(jet<Double_3>(3, {{0}, {1}, {2}, {0, 1}})));
  CHECK_ERROR(GC::frenet_matrix(jet<Double_3>(3, {{0}, {1}, {0, 1}})), jet_order_too_low);
}
