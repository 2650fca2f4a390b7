// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Many blends at once: the same points as one by one.

#include "support/random_points.h"

#include <CGAL/Geometric_continuity/blends/blend.h>

BOOST_AUTO_TEST_CASE(blends) {
  const int n = 20;
  GC::Jet_arrays<Exact, 3, 2> phi(n), psi(n);
  std::vector<GC::Curve_jet<Traits<Exact>>> left, right;
  for (int l = 0; l < n; ++l)
    for (auto* side : {&left, &right}) {
      const auto d = points<Exact>(3);
      side->push_back({d[0], {d[1] - CGAL::ORIGIN, d[2] - CGAL::ORIGIN}});
      (side == &left ? phi : psi).set(l, side->back());
    }
  GC::Blend_arrays<Exact, 3> gamma;
  const auto check = [&](const auto& strategy) {
    GC::blend<CGAL::Parallel_if_available_tag>(phi, psi, strategy, gamma);
    for (int l = 0; l < n; ++l) {
      const auto single = GC::blend(left[l], right[l], strategy);
      for (int j = 0; j <= 5; ++j)
        for (int i = 0; i < 3; ++i) BOOST_CHECK_EQUAL(gamma.array(j, i)[l], single.control_point(j)[i]);
    }
  };
  check(GC::Minimal_energy<3>());
  const GC::Shape_parameters<Exact> shape(2, Exact(1) / 3);
  GC::blend<CGAL::Parallel_if_available_tag>(phi, psi, GC::Minimal_energy<2>(), shape, gamma);
  for (int l = 0; l < n; ++l)
    for (int j = 0; j <= 5; ++j)
      for (int i = 0; i < 3; ++i)
        BOOST_CHECK_EQUAL(gamma.array(j, i)[l],
                          GC::blend(left[l], right[l], GC::Minimal_energy<2>(), shape).control_point(j)[i]);
  CHECK_ERROR(GC::blend(phi, psi, GC::Minimal_energy<2>(), {1, 0}, gamma), nonpositive_beta);
  check(GC::Matching_second_derivative());
  for (int i = 0; i < 3; ++i) psi.array(1, i)[13] = 0;
  BOOST_CHECK_EXCEPTION(GC::blend(phi, psi, GC::Normal_offset(), gamma), GC::Error, [](const GC::Error& e) {
    return e.code() == GC::Error_code::zero_tangent &&
           std::string(e.what()).find("second curve number 13") != std::string::npos;
  });
  psi.resize(n - 1);
  CHECK_ERROR(GC::blend(phi, psi, GC::Normal_offset(), gamma), wrong_number_of_points);
}
