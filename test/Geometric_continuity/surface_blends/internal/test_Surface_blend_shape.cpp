// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The factor of the homogeneous points of an automatic shape, against the Taylor expansion of the
// weights.

#include "support/rational_surfaces.h"
#include "support/series.h"

#include <CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>

BOOST_AUTO_TEST_SUITE(surface_blend_shape)

// The automatic factor cancels the weights along one line across the edge: (1 + lambda_1 v + ...)
// w(phi(v)) is constant, up to v^3.
BOOST_AUTO_TEST_CASE(factor_of_one_line) {
  Random random;
  for (int round = 0; round < 20; ++round) {
    const auto number = [&] {
      return double(random.integer(-1, 1));
    }; // so that no factor has more digits than it may have
    const double b = random.integer(1, 2), d = number(), d3 = number(), w0 = 1 << random.integer(0, 2);
    const std::array<double, 4> w = {w0, w0 * number(), w0 * number(), w0 * number()};
    GC::Septic_edge_reparametrisation<GC::Rational_edge_reparametrisation<Q>> r;
    GC::internal::set_shape(r, {b, d, d3}, {w});
    // of second and third derivatives, the coefficients are 1/2 and 1/6
    const Series phi = {Q(0), Q(b), Q(d) / Q(2), Q(d3) / Q(6)}, square = product(phi, phi), cube = product(phi, square),
                 factor = {Q(1), r.lambda1(Q(0)), r.lambda2(Q(0)) / Q(2), r.lambda3(Q(0)) / Q(6)};
    Series weight = {Q(w[0]), Q(0), Q(0), Q(0)};
    for (int i = 1; i <= 3; ++i) weight[i] = Q(w[1]) * phi[i] + Q(w[2]) / Q(2) * square[i] + Q(w[3]) / Q(6) * cube[i];
    const Series constant = {Q(w[0]), Q(0), Q(0), Q(0)};
    BOOST_CHECK(product(factor, weight) == constant);
  }
}

BOOST_AUTO_TEST_SUITE_END()
