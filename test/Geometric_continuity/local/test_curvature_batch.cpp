// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Curvatures and torsions of many jets.

#include "support/random_points.h"

#include <CGAL/Geometric_continuity/local/curvatures.h>

// At a parameter of a curve: (t, t^2, t^3) at 1 has 2 sqrt(19)/14^(3/2) and 3/19.
BOOST_AUTO_TEST_CASE(curvature_of_a_curve) {
  typedef CGAL::Exact_rational Q;
  typedef GC::Bezier_curve<Traits<Q>> Curve;
  typedef Curve::Point Point;
  const Curve cubic{Point(0, 0, 0), Point(Q(1) / 3, 0, 0), Point(Q(2) / 3, Q(1) / 3, 0), Point(1, 1, 1)};
  BOOST_CHECK(GC::torsion(cubic, 1) == Q(3) / 19);
  BOOST_CHECK_CLOSE_FRACTION(GC::curvature(cubic, 1), std::sqrt(19. / 686), 1e-15);
  const Curve line{Point(0, 0, 0), Point(1, 0, 0)}, point{Point(0, 0, 0), Point(0, 0, 0)};
  BOOST_CHECK(GC::curvature(line, 0) == 0);
  CHECK_ERROR(GC::torsion(line, 0), nonpositive_curvature);
  CHECK_ERROR(GC::curvature(point, 0), zero_tangent);
}

BOOST_AUTO_TEST_CASE(curvatures) {
  const int n = 5000; // several blocks, where there are several cores
  GC::Jet_arrays<double, 3, 3> jets(n);
  std::vector<GC::Curve_jet<Traits<double>>> single;
  for (int l = 0; l < n; ++l) {
    const auto d = points<double>(4);
    const auto vector = [&](int j) { return d[j] - CGAL::ORIGIN; };
    single.push_back({d[0], {vector(1), vector(2), vector(3)}});
    if (l == 7) single.back() = {d[0], {CGAL::NULL_VECTOR, vector(2), vector(3)}}; // no tangent
    if (l == 4000) single.back() = {d[0], {vector(1), 2 * vector(1), vector(3)}};  // no curvature
    jets.set(l, single.back());
  }
  std::vector<double> kappa(n, -1), tau(n, -1);
  BOOST_CHECK_EQUAL(GC::curvature_and_torsion<CGAL::Parallel_if_available_tag>(jets, kappa.data(), tau.data()), 2);
  for (int l = 0; l < n; ++l) {
    const auto square = GC::curvature_squared(single[l]);
    const auto torsion = GC::torsion(single[l]);
    BOOST_CHECK_EQUAL(torsion.has_value(), l != 7 && l != 4000);
    BOOST_CHECK_CLOSE_FRACTION(kappa[l], square ? std::sqrt(*square) : 0, 1e-9);
    BOOST_CHECK_CLOSE_FRACTION(tau[l], torsion.value_or(0), 1e-9);
  }
}
