// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "support/typed.h"

BOOST_AUTO_TEST_SUITE(planar_curves)

TEST_WITH_RANDOM_INPUT(up_to_degree_2) {
  for (int degree = 0; degree <= 2; ++degree) BOOST_CHECK(GC::is_planar(random_curve<Traits>(random, d, degree)));
}

TEST_IN_EVERY_SPACE(points_in_a_plane_and_one_that_leaves_it) {
  const Column<Traits> origin = column<Traits>(d, {1, -2, 5, 1, 3}), v = column<Traits>(d, {1, 1, 2, 0, 1}),
                       w = column<Traits>(d, {0, 3, -1, 1, 1});
  std::vector<Point<Traits>> points;
  for (const Row& c : {Row{0, 0}, {1, 2}, {2, 4}, {3, 1}, {4, 4}, {0, 1}})
    points.push_back(point<Traits>(origin + FT(c.begin()[0]) * v + FT(c.begin()[1]) * w));
  BOOST_CHECK(GC::is_planar(Curve<Traits>(points.begin(), points.end())));
  BOOST_CHECK(GC::is_planar(Curve<Traits>(points.begin(), points.begin() + 3))); // a line
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<Point<Traits>> moved = points;
    Column<Traits> c = column<Traits>(points[i]);
    c[d - 1] = next_to(c[d - 1]);
    moved[i] = point<Traits>(c);
    BOOST_CHECK_EQUAL(GC::is_planar(Curve<Traits>(moved.begin(), moved.end())), d == 2);
  }
}

// Cubics: the torsion vanishes everywhere if and only if it does at one end.
BOOST_AUTO_TEST_CASE(hagen_1_13) {
  if (!exact) return;
  repeat([](Random& random) {
    std::vector<Point<Traits3>> points = random_points<Traits3>(random, 3, 4);
    BOOST_CHECK(!GC::is_planar(Curve<Traits3>(points.begin(), points.end())));
    BOOST_CHECK(*GC::end_invariants(Curve<Traits3>(points.begin(), points.end())).torsion != FT(0));
    const Column<Traits3> b0 = column<Traits3>(points[0]), b1 = column<Traits3>(points[1]),
                          b2 = column<Traits3>(points[2]);
    points[3] = point<Traits3>(b0 + random.number() * (b1 - b0) + random.number() * (b2 - b0));
    BOOST_CHECK(GC::is_planar(Curve<Traits3>(points.begin(), points.end())));
    BOOST_CHECK(*GC::end_invariants(Curve<Traits3>(points.begin(), points.end())).torsion == FT(0));
  });
}

// No torsion where it is defined, and not planar: the curvature vanishes at the join.
BOOST_AUTO_TEST_CASE(two_planes) {
  // 4 (t, t^4, 0) on [-1, 0] and 4 (t, 0, t^4) on [0, 1]
  std::vector<Point<Traits3>> points;
  for (const Row& x :
       {Row{-4, 4, 0}, {-3, 0, 0}, {-2, 0, 0}, {-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 4}})
    points.push_back(point<Traits3>(3, x));
  const std::vector<FT> knots{FT(-1), FT(0), FT(1)};
  const GC::Composite_bezier_curve<Traits3> both(points.begin(), points.end(), knots);
  BOOST_CHECK(!GC::is_planar(both));
  for (int l = 0; l < 2; ++l) {
    BOOST_CHECK(GC::is_planar(both.segment(l)));
    for (int i = 0; i <= 4; ++i) {
      const std::optional<FT> torsion = GC::torsion(both.segment(l).jet(FT(knots[l] + ratio(i, 4)), 3));
      BOOST_CHECK(!torsion || *torsion == FT(0));
    }
  }
}

BOOST_AUTO_TEST_CASE(splines) {
  std::vector<Point<Traits3>> points;
  for (const Row& x : {Row{7, 7, 7}, {0, 0, 1}, {1, 0, 1}, {1, 2, 1}, {3, 5, 1}, {9, 9, -9}})
    points.push_back(point<Traits3>(3, x));
  const auto is_planar = [&](std::initializer_list<int> knots) {
    std::vector<FT> u;
    for (int k : knots) u.push_back(FT(k));
    const GC::Knot_vector<FT> knot_vector(1, u);
    const std::vector<FT> weights(points.size(), FT(2));
    const bool planar = GC::is_planar(GC::Bspline_curve<Traits3>(points.begin(), points.end(), knot_vector));
    BOOST_CHECK_EQUAL(planar, GC::is_planar(GC::Rational_bspline_curve<Traits3>(
                                  points.begin(), points.end(), weights.begin(), weights.end(), knot_vector)));
    return planar;
  };
  // where an end of the domain is repeated, the point at that end has no influence
  BOOST_CHECK(is_planar({0, 1, 1, 2, 3, 4, 4, 5}));
  BOOST_CHECK(!is_planar({0, 1, 1, 2, 3, 4, 5, 6}));
  BOOST_CHECK(!is_planar({0, 1, 2, 3, 3, 4, 4, 5}));
  BOOST_CHECK(!is_planar({0, 0, 1, 2, 3, 4, 5, 5}));
}

// From homogeneous points (w x, w).
BOOST_AUTO_TEST_CASE(rational_curves) {
  const auto is_planar = [&](std::initializer_list<Row> rows) {
    typedef GC::Rational_bezier_curve<Traits3> Rational;
    std::vector<typename Rational::Homogeneous::Point> points;
    for (const Row& x : rows) points.push_back(column<GC::Homogeneous_traits<Traits3>>(4, x));
    return GC::is_planar(Rational(typename Rational::Homogeneous(points.begin(), points.end())));
  };
  // half a circle, one point is infinite
  BOOST_CHECK(is_planar({{1, 0, 4, 1}, {0, 1, 0, 0}, {-1, 0, 4, 1}}));
  BOOST_CHECK(is_planar({{1, 0, 4, 1}, {0, 1, 0, 0}, {6, 9, 12, 3}, {-1, 0, 4, 1}}));
  BOOST_CHECK(!is_planar({{1, 0, 4, 1}, {0, 1, 1, 0}, {6, 9, 12, 3}, {-1, 0, 4, 1}}));
  BOOST_CHECK(!is_planar({{1, 0, 4, 1}, {0, 1, 0, 1}, {6, 9, 12, 3}, {-1, 0, 4, 1}}));
}

BOOST_AUTO_TEST_SUITE_END()
