// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Curvatures and torsions of many jets.

#include "support/random_points.h"

#include <CGAL/Geometric_continuity/local/curvatures.h>

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
