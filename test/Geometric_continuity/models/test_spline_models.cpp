// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Models of B-spline surfaces.

#include "support/spline_surfaces.h"

#include <CGAL/Geometric_continuity/models/model_continuity.h>

// As many bicubic patches of one smooth surface as a test may take: the number of edges of each
// kind is known.
BOOST_AUTO_TEST_CASE(model_of_a_large_grid) {
  constexpr int n = 15;
  std::vector<Patch<Exact>> patches;
  std::vector<S> surfaces;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      surfaces.push_back(spline(wave, knots(i, i + 1), knots(j, j + 1)));
      patches.push_back(surfaces.back().bezier_patches()[0]);
    }
  for (const GC::Model_summary& s : {GC::model_continuity(patches).summary, GC::model_continuity(surfaces).summary})
    BOOST_CHECK_EQUAL(text(s), "420 G2, 0 G1, 0 G0, 60 boundary, 0 collapsed");
}

BOOST_AUTO_TEST_CASE_TEMPLATE(model_of_splines, K, Kernels) {
  // one above the other, in any direction, degree and domain; the last one meets half an edge only
  const std::vector<S> exact = {spline(wave, knots(0, 4, {1, 2, 2}), knots(0, 1)),
                                with_knots(spline(wave, knots(0, 4, {3}), knots(1, 2)).reverse_u(), 4, 1),
                                lifted(spline(wave, knots(0, 4, {1, 3}), knots(2, 3)), 5, 1).swap_parameters(),
                                spline(wave, knots(0, 2), knots(3, 4))};
  std::vector<Surface<K>> s;
  for (const S& x : exact) s.push_back(in<K>(x));
  const auto model = GC::model_continuity(s);
  BOOST_CHECK_EQUAL(text(model.summary),
                    "1 G2, 0 G1, 1 G0 (1 creases), 12 boundary, 0 collapsed; knot lines: 1 G2, 0 G1, 0 G0");
  BOOST_REQUIRE_EQUAL(model.edges.size(), 14);
  std::vector<std::string> shared;
  for (const auto& e : model.edges)
    if (e.kind == GC::Model_edge_kind::shared) shared.push_back(text(e));
  BOOST_REQUIRE_EQUAL(shared.size(), 2);
  BOOST_CHECK_EQUAL(shared[0], "0 v1 - 1 v0: G2, reversed");
  BOOST_CHECK_EQUAL(shared[1].substr(0, 24), "1 v1 - 2 u0: G0 (crease)");
  BOOST_REQUIRE_EQUAL(model.knot_lines.size(), 1);
  BOOST_CHECK_EQUAL(text(model.knot_lines[0]), "0 u = 2: G2");
  BOOST_CHECK_EQUAL(model.failing(1).size(), 1);
  BOOST_CHECK(model.has_order(0) && !model.has_order(1));
}

// One surface may be a model: the order is also that of its knot lines.
BOOST_AUTO_TEST_CASE(a_surface_with_a_kink) {
  typedef Exact::Point_3 P;
  const S roof({{P(-1, 0, 1), P(-1, 1, 1)}, {P(0, 0, 0), P(0, 1, 0)}, {P(1, 0, 1), P(1, 1, 1)}},
               Knots(1, {0, 0, 1, 2, 2}), Knots(1, {0, 0, 1, 1}));
  const auto model = GC::model_continuity(roof);
  BOOST_CHECK_EQUAL(text(model), text(GC::model_continuity(std::vector<S>{roof})));
  BOOST_CHECK(model.failing(1).empty() && model.failing_knot_lines(1).size() == 1);
  BOOST_CHECK(model.has_order(0) && !model.has_order(1));
}

BOOST_AUTO_TEST_CASE(closed_surface_with_a_pole) {
  // a band around a square: linear in u and closed, and a lid of triangles to one point, which is
  // collapsed
  typedef Exact::Point_3 P;
  const Knots u(1, {0, 0, 1, 2, 3, 4, 4}), v(1, {0, 0, 1, 1});
  const P square[] = {P(0, 0, 0), P(1, 0, 0), P(1, 1, 0), P(0, 1, 0), P(0, 0, 0)};
  std::vector<std::vector<P>> band, lid;
  for (const P& p : square) {
    band.push_back({p, P(p.x(), p.y(), 1)});
    lid.push_back({P(p.x(), p.y(), 1), P(Q(1) / 2, Q(1) / 2, 1)});
  }
  const auto model = GC::model_continuity(std::vector<S>{S(band, u, v), S(lid, u, v)});
  // the seams: a corner of the band is a right angle, that of the lid is flat but its normal
  // vanishes at the pole
  BOOST_CHECK_EQUAL(text(model.summary), "0 G2, 0 G1, 3 G0 (2 creases, 1 vanishing normals), 1 boundary, 1 collapsed; "
                                         "knot lines: 0 G2, 0 G1, 6 G0");
  for (const auto& l : model.failing_knot_lines(1)) {
    BOOST_CHECK_EQUAL(l.line.continuity.defect, l.patch == 0 ? Edge_defect::crease : Edge_defect::vanishing_normal);
    if (l.patch == 0) BOOST_CHECK(l.line.continuity.deviation->upper == Q(1)); // a right angle
  }
}
