// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Edges that nearly meet.

#include "support/nets.h"

#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>

// Patches and B-spline surfaces, on doubles and on exact numbers.
BOOST_AUTO_TEST_CASE(near_edges_of_a_model) {
  using GC::Verdict;
  typedef GC::Traits_3<CGAL::Epick> Space;
  typedef GC::Bezier_patch<Space> Patch;
  const auto patch = [](double x, double y, double z, double tilt) { // over [x, x + 1] x [y, y + 1]
    return Patch({{Space::Point(x, y, z), Space::Point(x, y + 1, z)},
                  {Space::Point(x + 1, y, z + tilt), Space::Point(x + 1, y + 1, z + tilt)}});
  };
  const double unit = 0x1p-40;
  // 0 | 1 with a gap in z, 1 | 2 the same edge with a kink, 3 next to 0 in v, turned; 4 far away
  std::vector<Patch> model = {patch(0, 0, 0, 0), patch(1, 0, unit, 0), patch(2, 0, unit, 0.125),
                              patch(0, 1, 0, 4 * unit).reverse_u(), patch(100, 0, 0, 0)};
  const auto exact = GC::model_continuity(model);
  BOOST_CHECK_EQUAL(exact.summary.g0 + exact.summary.g1 + exact.summary.g2, 1);
  BOOST_CHECK(GC::nearly_coincident_edges(model, exact, {1, 0}).empty());
  BOOST_CHECK(GC::nearly_coincident_edges(model, exact, {1, unit / 2}).empty());
  const auto one_pair = GC::nearly_coincident_edges(model, exact, {0, unit});
  BOOST_REQUIRE_EQUAL(one_pair.size(), 1);
  BOOST_CHECK(one_pair[0].patch_a == 0 && one_pair[0].edge_a == u1 && one_pair[0].patch_b == 1 &&
              one_pair[0].edge_b == u0);
  BOOST_CHECK_EQUAL(one_pair[0].within.deviation.gap, (GC::Enclosure{unit, unit}));
  BOOST_CHECK_EQUAL(one_pair[0].within.proved_order(), 1);
  const auto pairs = GC::nearly_coincident_edges(model, exact, {0, 4 * unit});
  BOOST_REQUIRE_EQUAL(pairs.size(), 2);
  BOOST_CHECK(pairs[0].edge_a == u1 && pairs[1].edge_a == v1 && pairs[1].patch_b == 3 && pairs[1].edge_b == v0);
  BOOST_CHECK(pairs[1].within.deviation.reversed);
  BOOST_CHECK_EQUAL(pairs[1].within.deviation.gap, (GC::Enclosure{4 * unit, 4 * unit}));
  BOOST_CHECK_EQUAL(pairs[1].within(0), Verdict::proved);
  BOOST_CHECK_EQUAL(pairs[1].within(1), Verdict::refuted); // tilted by arctan(4 unit)
  BOOST_CHECK_EQUAL(GC::nearly_coincident_edges(model, exact, {5 * unit, 4 * unit})[1].within(1), Verdict::proved);
  std::ostringstream os;
  os << pairs[1];
  os << "; " << pairs[0];
  BOOST_CHECK_EQUAL(os.str(), "0 v1 - 3 v0: near, reversed; 0 u1 - 1 u0: near");
  CHECK_ERROR((GC::nearly_coincident_edges(model, exact, {0, std::numeric_limits<double>::infinity()})), not_finite);

  // the same functions of surfaces
  const GC::Edge_order_within kink = GC::order_within(model[1], u1, model[2], u0, {0.1243549945467615, 0});
  BOOST_CHECK_EQUAL(kink(1), Verdict::proved); // arctan(1/8) = 0.12435499454676143...
  BOOST_CHECK_EQUAL(GC::order_within(model[1], u1, model[2], u0, {0.1243549945467613, 0})(1), Verdict::refuted);
  const GC::Bspline_surface<Space> spline(model[2]);
  BOOST_CHECK_EQUAL(*GC::deviation(model[1], u1, spline, u0).normal_angle, *kink.deviation.normal_angle);
  BOOST_CHECK_EQUAL(GC::deviation(spline, u0, model[1], u1).gap, (GC::Enclosure{0, 0}));
}

BOOST_AUTO_TEST_CASE(progress_is_told) {
  // strips of two linear patches each, three side by side and one apart
  typedef GC::Traits_3<CGAL::Epick> Space;
  typedef GC::Bspline_surface<Space> Surface;
  const GC::Knot_vector<double> u(1, {0, 0, 1, 2, 2}), v(1, {0, 0, 1, 1});
  std::vector<Surface> strips;
  for (int y : {0, 1, 2, 5}) {
    std::vector<std::vector<Space::Point>> net;
    for (int x : {0, 1, 2}) net.push_back({Space::Point(x, y, 0), Space::Point(x, y + 1, 0)});
    strips.emplace_back(net, u, v);
  }
  std::vector<std::size_t> told;
  const auto tell = [&told](std::size_t n) { told.push_back(n); };
  const auto model = GC::model_continuity(strips, tell);
  BOOST_CHECK_EQUAL(model.summary.g2, 2);
  BOOST_CHECK_EQUAL(model.knot_lines.size(), 4);
  BOOST_CHECK(told == (std::vector<std::size_t>{1, 2, 3, 4, 5, 6}));
  told.clear();
  GC::nearly_coincident_edges(strips, model, {1, 0.5}, tell);
  BOOST_CHECK_EQUAL(told.size(), model.summary.boundary);
  BOOST_CHECK_EQUAL(told.back(), model.summary.boundary);
}
