// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tells whether edges are sharp everywhere: with angles that are known along the edge.

#define BOOST_TEST_MODULE is_sharp_edge

#include "support/cad_sides.h"

#include <variant>

const double degree = 0.017453292519943295;

// The plane z = 0 along the axis of x, and a ruled surface below y = 0 that rises like `start` at
// x = 0 and like `end` at x = 1: the angle is the arc tangent of the slope.
const GC::Edge_side ground = side(Elementary{Kind::plane, standard}, line(0, 0, 1, 0));
GC::Edge_side ramp(double start, double end) {
  return side(
      GC::Cad_spline_surface{
          1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, -1, start}, {0, 0, 0}, {1, -1, end}, {1, 0, 0}}, {}},
      line(0, 1, 1, 0));
}

BOOST_AUTO_TEST_CASE(slopes) {
  using GC::Verdict;
  const auto sharp = [](double start, double end, const GC::Bound& bound, double from = 0, double to = 1) {
    const Verdict v = GC::is_sharp_edge(ground, ramp(start, end), from, to, bound);
    BOOST_TEST(GC::is_sharp_edge(ramp(start, end), ground, from, to, bound) == v);
    return v;
  };
  const GC::Enclosure right_half{0.7853981633974482, 0.7853981633974485};
  BOOST_TEST(sharp(1, 1, 44 * degree) == Verdict::proved);
  BOOST_TEST(sharp(1, 1, 46 * degree) == Verdict::refuted);
  BOOST_TEST(sharp(0, 1, 5 * degree) == Verdict::refuted);  // fades at an end
  BOOST_TEST(sharp(-1, 1, 5 * degree) == Verdict::refuted); // and in the middle
  BOOST_TEST(sharp(-1, 1, 1e-5 * degree) == Verdict::refuted);
  BOOST_TEST(sharp(0.1, 1, 5 * degree) == Verdict::proved);
  BOOST_TEST(sharp(0.08, 1, 5 * degree) == Verdict::refuted); // tan 5 degrees = 0.0875
  BOOST_TEST(sharp(1, 1, right_half) == Verdict::undecided);
  BOOST_TEST(sharp(1, 2, right_half) == Verdict::undecided); // at an end
  BOOST_TEST(sharp(1, 1, right_half, 0.5, 0.5) == Verdict::undecided);
  // a part
  BOOST_TEST(sharp(0, 1, 26 * degree, 0.5, 1) == Verdict::proved);
  BOOST_TEST(sharp(0, 1, 27 * degree, 0.5, 1) == Verdict::refuted);
  BOOST_TEST(sharp(0, 1, 26 * degree, 0.5, 0.5) == Verdict::proved); // a point
  GC::Edge_precision little;
  little.most_boxes = 3;
  BOOST_TEST(GC::is_sharp_edge(ground, ramp(1, 0.0875), 0, 1, 5 * degree, little) == Verdict::undecided);
  GC::Edge_side turned = ramp(0, 0.01);
  turned.reversed = true;
  BOOST_TEST(GC::is_sharp_edge(ground, turned, 0, 1, 170 * degree) == Verdict::proved); // folded
}

// The smallest angle of random slopes is known: at an end, or 0 where the slope changes its sign.
BOOST_AUTO_TEST_CASE(random_slopes) {
  const unsigned seed = first_seed();
  std::mt19937 random = seeded(seed);
  std::uniform_real_distribution<double> slope(-1, 1), angle(0.001, 0.8);
  for (int i = 0; i < 200; ++i) {
    const double start = slope(random), end = slope(random), bound = angle(random);
    const double least = start * end < 0 ? 0 : std::atan((std::min)(std::fabs(start), std::fabs(end)));
    if (std::fabs(least - bound) < 1e-6) continue;
    BOOST_TEST_CONTEXT("seed " << seed << ", slopes " << start << ", " << end << ", bound " << bound)
    BOOST_TEST((GC::is_sharp_edge(ground, ramp(start, end), 0, 1, bound) == GC::Verdict::proved) == (least > bound));
  }
}

// The normal of a cone vanishes at the apex, where lines of two cones meet at an angle.
BOOST_AUTO_TEST_CASE(points_without_a_normal) {
  const Elementary cone{Kind::cone, standard, 0, 0.5}, wide{Kind::cone, standard, 0, 0.75};
  const GC::Edge_side a = side(cone, line(0, 0, 0, 1)), b = side(wide, line(0, 0, 0, 1));
  BOOST_TEST(GC::is_sharp_edge(a, b, 0, 1, 0.24) == GC::Verdict::proved);
  BOOST_TEST(GC::is_sharp_edge(a, b, 0, 1, 0.26) == GC::Verdict::refuted);
  // a patch of which one side is a point, at the end of the edge
  GC::Edge_side collapsed = ramp(0, 0.5);
  GC::Cad_spline_surface s = std::get<GC::Cad_spline_surface>(*collapsed.surface);
  s.points[0] = s.points[1];
  collapsed.surface = std::make_shared<GC::Cad_surface>(s);
  BOOST_TEST(GC::is_sharp_edge(ground, collapsed, 0, 1, 0.46) == GC::Verdict::proved);
  BOOST_TEST(GC::is_sharp_edge(ground, collapsed, 0, 1, 0.47) == GC::Verdict::refuted);
  BOOST_TEST(GC::is_sharp_edge(a, b, 0, 0, 0.1) == GC::Verdict::undecided); // the apex alone
  // nothing is known of a patch with a side of almost no length, at the end of the edge
  GC::Cad_spline_surface almost = s;
  almost.points[0] = {1e-200, 0, -1e-200};
  GC::Edge_side unknown = collapsed;
  unknown.surface = std::make_shared<GC::Cad_surface>(almost);
  BOOST_TEST(GC::is_sharp_edge(ground, unknown, 0, 1, 0.3) == GC::Verdict::undecided);
  s.points[2] = s.points[3];
  collapsed.surface = std::make_shared<GC::Cad_surface>(s);
  BOOST_TEST(GC::is_sharp_edge(ground, collapsed, 0, 1, 0.1) == GC::Verdict::undecided);
}

// Angles that the bound does not tell apart at both ends, and a fold of the surfaces themselves,
// which is left out.
BOOST_AUTO_TEST_CASE(undecided_parts) {
  const GC::Enclosure right_half{0.7853981633974482, 0.7853981633974485};
  const GC::Edge_side bulging =
      side(GC::Cad_spline_surface{2,
                                  1,
                                  {0, 0, 0, 1, 1, 1},
                                  {0, 0, 1, 1},
                                  {{0, -1, 1}, {0, 0, 0}, {0.5, -1, 3}, {0.5, 0, 0}, {1, -1, 1}, {1, 0, 0}},
                                  {}},
           line(0, 1, 1, 0));
  BOOST_TEST(GC::is_sharp_edge(ground, bulging, 0, 1, right_half) == GC::Verdict::undecided);
  BOOST_TEST(GC::is_sharp_edge(ground, bulging, 0, 1, 0.78) == GC::Verdict::proved);
  const GC::Cad_spline_surface roof{
      1, 1, {0, 0, 0.5, 1, 1}, {0, 0, 1, 1}, {{-1, 0, 1}, {-1, 1, 1}, {0, 0, 0}, {0, 1, 0}, {1, 0, 1}, {1, 1, 1}}, {}};
  const GC::Cad_line<2> across = line(0.125, 0.1, 0.7, 0.3);
  BOOST_TEST(GC::is_sharp_edge(side(roof, across), side(roof, across, true), 0, 1, 2.5) == GC::Verdict::proved);
  BOOST_TEST(GC::is_sharp_edge(side(roof, across), side(roof, across), 0, 1, 0.1) == GC::Verdict::refuted);
}

BOOST_AUTO_TEST_CASE(errors) {
  CHECK_ERROR(GC::is_sharp_edge(ground, ramp(0, 1), 1, 0, 0.1), empty_domain);
  CHECK_ERROR(GC::is_sharp_edge(ground, ramp(0, 1), 0, std::numeric_limits<double>::infinity(), 0.1), not_finite);
  CHECK_ERROR(GC::is_sharp_edge(ground, ramp(0, 1), 0, 3, 0.1), parameter_outside_domain);
  CHECK_ERROR(GC::is_sharp_edge(ground, ramp(0, 1), -3, 1, 0.1), parameter_outside_domain);
}
