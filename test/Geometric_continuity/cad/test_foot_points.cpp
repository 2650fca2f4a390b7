// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Curves in space and the faces that they belong to: distances and foot points that are known.

#define BOOST_TEST_MODULE foot_points

#include "support/cad_sides.h"

#include <variant>

const GC::Cad_placement turned{{{0, -1, 0, 5}, {1, 0, 0, 7}, {0, 0, 1, -2}}};
template <class Curve> GC::Edge_curve in_space(const Curve& curve, const GC::Cad_placement& placement = unmoved) {
  return {std::make_shared<GC::Cad_curve<3>>(curve), placement};
}
GC::Cad_conic<3> circle(double radius, double height) {
  return {GC::Cad_conic<3>::Kind::ellipse, {0, 0, height}, {1, 0, 0}, {0, 1, 0}, radius, radius};
}
// The square [0, 1]^2 at z = 0.
const GC::Cad_spline_surface square{1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}}, {}};

void check_is(const GC::Enclosure& e, double value, double error) {
  BOOST_TEST_CONTEXT("enclosure " << e << " of " << value)
  BOOST_TEST((e.lower <= value + error && value - error <= e.upper && e.upper - e.lower <= 0.01 * e.upper + 1e-9));
}

BOOST_AUTO_TEST_CASE(distances_of_curves) {
  const GC::Edge_side plane = side(Elementary{Kind::plane, standard}, line(0, 0, 1, 0));
  // the line that rises from 0.25 by the slope 2, and the parabola z = t^2 / 4
  const GC::Edge_maximum rising = GC::curve_deviation(plane, in_space(GC::Cad_line<3>{{0, 0, 0.25}, {1, 0, 2}}), 0, 3);
  check_is(rising.value, 6.25, 0);
  BOOST_TEST(rising.parameter == 3);
  BOOST_TEST((rising.point == GC::Cad_point<3>{3, 0, 6.25}));
  const GC::Cad_conic<3> parabola{GC::Cad_conic<3>::Kind::parabola, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 1, 0};
  check_is(GC::curve_deviation(plane, in_space(parabola), -1, 3).value, 2.25, 0);
  // two circles about one axis, and about axes that are 0.5 apart
  const Elementary cylinder{Kind::cylinder, standard, 3};
  const GC::Edge_side ring = side(cylinder, line(0, 1, 1, 0), turned);
  check_is(GC::curve_deviation(ring, in_space(circle(3, 1), turned), 0, 2 * pi).value, 0, 1e-12);
  check_is(GC::curve_deviation(ring, in_space(circle(3.5, 1), turned), 0, 2 * pi).value, 0.5, 1e-12);
  GC::Cad_conic<3> moved = circle(3, 1);
  moved.centre[0] = 0.5;
  check_is(GC::curve_deviation(ring, in_space(moved, turned), 0, 2 * pi).value, 0.5, 1e-12);
  // a polyline with a corner at 1: the distance from the plane is largest there
  const GC::Cad_spline_curve<3> roof{1, {0, 0, 1, 2, 2}, {{0, 0, 0}, {1, 0, 0.125}, {2, 0, 0}}, {}};
  const GC::Edge_maximum top = GC::curve_deviation(plane, in_space(roof), 0, 2);
  check_is(top.value, 0.125, 0);
  BOOST_TEST(top.parameter == 1);
  // parts beside the corner
  for (const auto& [first, last] : {std::pair{0.25, 0.75}, std::pair{1.25, 1.75}})
    check_is(GC::curve_deviation(plane, in_space(roof), first, last).value, 0.09375, 0);
  // numbers that overflow: nothing is known
  const GC::Edge_side far = side(Elementary{Kind::plane, standard}, line(1e301, 0, 1e301, 0));
  BOOST_TEST(std::isinf(GC::curve_deviation(far, in_space(roof), 0.25, 0.75).value.upper));
  BOOST_TEST(
      std::isinf(GC::curve_deviation(plane, in_space(GC::Cad_line<3>{{0, 0, 1e200}, {1, 0, 0}}), 0, 1).value.upper));
  // a curve through the foot points has a knot where the curve in space has one
  for (const auto& [first, last, knots] :
       {std::tuple{0., 2., 10u}, std::tuple{0.25, 0.75, 8u}, std::tuple{1.25, 1.75, 8u}}) {
    const GC::Edge_side below = GC::projected_side(plane, in_space(roof), first, last, 1);
    BOOST_TEST(std::get<GC::Cad_spline_curve<2>>(*below.curve).knots.size() == knots);
  }
  GC::Edge_precision little;
  little.boxes = little.most_boxes = 1;
  BOOST_TEST(GC::curve_deviation(plane, in_space(roof), 0, 2, little).value.upper ==
             std::numeric_limits<double>::infinity());
}

// Curves in the parameter plane that are computed anew lie below the curve in space, wherever the
// given ones lie.
BOOST_AUTO_TEST_CASE(projections) {
  const unsigned seed = first_seed();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-0.4, 0.4), distance(-0.5, 0.5);
  for (int i = 0; i < 20; ++i) {
    const double d = i == 0 ? 0 : distance(random);
    const double p[] = {shift(random), shift(random), 1 + shift(random) / 10};
    const GC::Edge_side wrong = side(Elementary{Kind::cylinder, standard, 3}, line(p[0], p[1], p[2], 0), turned);
    const GC::Edge_curve space = in_space(circle(3 + d, 1), turned);
    const GC::Edge_side right = GC::projected_side(wrong, space, 0, 2, 64);
    BOOST_TEST_CONTEXT("seed " << seed << ", distance " << d)
    check_is(GC::curve_deviation(right, space, 0, 2).value, std::fabs(d), 1e-8);
    // the foot points do not depend on the curves
    const auto f = GC::compare_at_feet(wrong, right, {true, true}, space, 0.7);
    BOOST_REQUIRE(f.has_value());
    for (double below : f->distances) BOOST_TEST((below <= std::fabs(d) + 1e-14 && below >= std::fabs(d) - 1e-12));
    BOOST_TEST((f->gap == 0 && f->angle == 0 && f->curvature_jump == 0));
  }
  // on a sphere of radius 2, a line: its foot points have angles that are known
  const GC::Edge_side sphere = side(Elementary{Kind::sphere, standard, 2}, line(0.1, 0.1, 0, 0.3));
  const GC::Edge_curve chord = in_space(GC::Cad_line<3>{{1, 0, 0}, {0, 0, 1}});
  const GC::Edge_side below = GC::projected_side(sphere, chord, 0, 1, 100);
  check_is(GC::curve_deviation(below, chord, 0, 1).value, 1, 1e-12);
  const auto f = GC::compare_at_feet(sphere, sphere, {true, false}, chord, 1);
  BOOST_REQUIRE(f.has_value()); // of (1, 0, 1), and of the parameters (0.1, 0.4)
  const double x = std::cos(0.1) * std::cos(0.4), z = std::sin(0.4);
  BOOST_TEST(f->distances[0] == 2 - std::sqrt(2.), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(f->angle == std::acos((x + z) / std::sqrt(2.)), boost::test_tools::tolerance(1e-12));
}

// Beyond the end of a surface the foot point lies on its boundary, when that is proved.
BOOST_AUTO_TEST_CASE(ends_of_surfaces) {
  const GC::Edge_side patch = side(square, line(0.9, 0, 0, 1));
  const GC::Edge_curve beyond = in_space(GC::Cad_line<3>{{1.5, 0, 0}, {0, 1, 0}});
  const auto f = GC::compare_at_feet(patch, patch, {true, false}, beyond, 0.5);
  BOOST_REQUIRE(f.has_value());
  BOOST_TEST(f->distances[0] == 0.5);
  BOOST_TEST(f->gap == 0.1, boost::test_tools::tolerance(1e-12));
  const auto corner = GC::compare_at_feet(patch, patch, {true, true}, beyond, 2);
  BOOST_REQUIRE(corner.has_value());
  BOOST_TEST(corner->distances[0] == std::sqrt(1.25), boost::test_tools::tolerance(1e-12));
  check_is(GC::curve_deviation(GC::projected_side(patch, beyond, 0, 1, 8), beyond, 0, 1).value, 0.5, 1e-12);
}

// The curvature across the edge: of a cylinder, and of the plane.
BOOST_AUTO_TEST_CASE(curvatures) {
  const Elementary cylinder{Kind::cylinder, {{0, 0, 3}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}}, 3};
  GC::Edge_side plane = side(Elementary{Kind::plane, standard}, line(0, 0, 0, 1));
  plane.reversed = true;
  const GC::Edge_side tangent = side(cylinder, line(0, 0, 0, -1));
  const GC::Edge_curve edge = in_space(GC::Cad_line<3>{{0, 0, 0}, {0, 1, 0}});
  const auto f = GC::compare_at_feet(plane, tangent, {true, true}, edge, 1);
  BOOST_REQUIRE(f.has_value());
  BOOST_TEST(f->angle == 0);
  BOOST_TEST(f->curvature_jump == 1, boost::test_tools::tolerance(1e-12));
  // along the outer circle of a torus, with the sphere around it; across it the curvatures are 1/2
  // and 1/7
  const GC::Edge_side torus = side(Elementary{Kind::torus, standard, 5, 2}, line(0, 0, 1, 0)),
                      around = side(Elementary{Kind::sphere, standard, 7}, line(0, 0, 1, 0));
  const auto g = GC::compare_at_feet(torus, around, {true, true}, in_space(circle(7, 0)), 1);
  BOOST_REQUIRE(g.has_value());
  BOOST_TEST(g->angle <= 1e-12);
  BOOST_TEST(g->curvature_jump == 5. / 7, boost::test_tools::tolerance(1e-9));
}

// z = c x^2 / 2 over (x, y) = (U + V, V + U) where U = u - 1/2, V = v - 1/2 and the other term of
// each is times `skew`: the lines of constant parameters are neither orthogonal to each other nor
// to the edge x = 0, whose curve in the parameter plane is moved a little.
BOOST_AUTO_TEST_CASE(skew_parameters) {
  const auto bent = [](double skew, double c, double wrong) {
    GC::Cad_spline_surface s{2, 2, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}, {}, {}};
    const double line_of[] = {-0.5, 0, 0.5}, square_of[] = {0.25, -0.25, 0.25};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        s.points.push_back({line_of[i] + skew * line_of[j], line_of[j] + skew * line_of[i],
                            c / 2 * (square_of[i] + 2 * skew * line_of[i] * line_of[j] + skew * skew * square_of[j])});
    const double speed = 1 / (1 - skew * skew);
    return side(s, line(0.5 + wrong, 0.5 - wrong, -skew * speed, speed));
  };
  const GC::Edge_curve edge = in_space(GC::Cad_line<3>{{0, 0, 0}, {0, 1, 0}});
  for (const double skew : {0., 0.25, 0.6})
    for (const double wrong : {0., 0.02, -0.03})
      for (const double t : {0., 0.1, -0.07}) {
        const auto f = GC::compare_at_feet(bent(skew, 1, wrong), bent(0, 0.5, -wrong), {true, true}, edge, t);
        BOOST_TEST_CONTEXT("skew " << skew << ", wrong by " << wrong << ", at " << t) {
          BOOST_REQUIRE(f.has_value());
          BOOST_TEST((f->distances[0] <= 1e-12 && f->distances[1] <= 1e-12 && f->gap <= 1e-12 && f->angle <= 1e-7));
          BOOST_TEST(f->curvature_jump == 0.5, boost::test_tools::tolerance(1e-9));
        }
      }
}

// (u + 4v, v, 0): the shortest steps along the lines of one parameter alone lead nowhere.
BOOST_AUTO_TEST_CASE(parameters_at_a_small_angle) {
  const GC::Cad_spline_surface sheared{1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0}, {4, 1, 0}, {1, 0, 0}, {5, 1, 0}},
                                       {}};
  const GC::Edge_side patch = side(sheared, line(0.25, 0.25, 0, 0));
  const auto distance = [&](const GC::Cad_point<3>& x) {
    const auto f = GC::compare_at_feet(patch, patch, {true, true}, in_space(GC::Cad_line<3>{x, {0, 1, 0}}), 0);
    BOOST_REQUIRE(f.has_value());
    return f->distances[0];
  };
  BOOST_TEST(distance({2.5, 0.5, 0.75}) == 0.75);
  BOOST_TEST(distance({0.25, 0.0625, 3}) == 3);
  // beyond the line from (1, 0) to (5, 1), in the direction (1, -4)
  BOOST_TEST(distance({3.125, 0, 0}) == std::sqrt(17.) / 8, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(distance({2.25, -0.75, 0}) == std::sqrt(17.) / 4, boost::test_tools::tolerance(1e-12));
}

// The proved distances of foot points on a parallelogram are the true ones. (Next to its long sides
// the steps may end at another point.)
BOOST_AUTO_TEST_CASE(distances_from_a_parallelogram) {
  const unsigned seed = 2026;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-6, 10);
  const GC::Cad_spline_surface sheared{1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0}, {4, 1, 0}, {1, 0, 0}, {5, 1, 0}},
                                       {}};
  const GC::Edge_side patch = side(sheared, line(0.5, 0.5, 0, 0));
  const auto distance_from_segment = [](const double(&p)[2], const double(&a)[2], const double(&d)[2]) {
    const double x = p[0] - a[0], y = p[1] - a[1],
                 t = std::min(std::max((x * d[0] + y * d[1]) / (d[0] * d[0] + d[1] * d[1]), 0.), 1.);
    return std::hypot(x - t * d[0], y - t * d[1]);
  };
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    const double p[] = {coordinate(random), coordinate(random) / 4}, z = coordinate(random);
    const double v = p[1], u = p[0] - 4 * v;
    double beside = 0; // the distance in the plane
    if (!(0 <= u && u <= 1 && 0 <= v && v <= 1))
      beside = std::min({distance_from_segment(p, {0, 0}, {1, 0}), distance_from_segment(p, {4, 1}, {1, 0}),
                         distance_from_segment(p, {0, 0}, {4, 1}), distance_from_segment(p, {1, 0}, {4, 1})});
    const auto f =
        GC::compare_at_feet(patch, patch, {true, true}, in_space(GC::Cad_line<3>{{p[0], p[1], z}, {0, 1, 0}}), 0);
    BOOST_TEST_CONTEXT("seed " << seed << ", point " << p[0] << ' ' << p[1] << ' ' << z)
    if (f) BOOST_TEST(f->distances[0] == std::hypot(beside, z), boost::test_tools::tolerance(1e-9));
    found += f.has_value();
  }
  BOOST_TEST(found >= 90);
  // beyond each of the four sides
  for (const double x : {-0.5, 0.5, 1.5})
    for (const double y : {-0.5, 0.5, 1.5}) {
      const auto f = GC::compare_at_feet(side(square, line(0.5, 0.5, 0, 0)), patch, {true, false},
                                         in_space(GC::Cad_line<3>{{x, y, 0}, {0, 1, 0}}), 0);
      BOOST_REQUIRE(f.has_value());
      BOOST_TEST(f->distances[0] == std::hypot(x == 0.5 ? 0 : 0.5, y == 0.5 ? 0 : 0.5),
                 boost::test_tools::tolerance(1e-12));
    }
}

// Where the distance is not least, or the foot point is not the only one, or not on one piece of
// the surface.
BOOST_AUTO_TEST_CASE(what_is_not_proved) {
  const auto at = [](const GC::Edge_side& s, const GC::Cad_point<3>& x, bool is_projected = true) {
    return GC::compare_at_feet(s, s, {is_projected, is_projected}, in_space(GC::Cad_line<3>{x, {0, 1, 0}}), 0);
  };
  const Elementary cylinder{Kind::cylinder, standard, 3}, torus{Kind::torus, standard, 5, 2};
  const GC::Edge_side ring = side(cylinder, line(0, 1, 1, 0)), tube = side(torus, line(0, 0, 1, 0));
  BOOST_TEST(at(ring, {1, 0, 0}).has_value());
  BOOST_TEST(!at(ring, {0, 0, 0}).has_value());  // on the axis
  BOOST_TEST(!at(ring, {-1, 0, 0}).has_value()); // farthest
  BOOST_TEST(!at(tube, {1, 0, 0}).has_value());
  for (int k = 0; k <= 16; ++k) { // ever closer to the axis, or to the middle of the tube
    const double d = std::pow(10, -k), x = d * std::cos(0.3), y = d * std::sin(0.3);
    const auto f = at(side(cylinder, line(0.3, 1, 1, 0)), {x, y, 0}),
               g = at(side(torus, line(0, 0.3, 1, 0)), {5 + x, 0, y});
    if (f) BOOST_TEST((f->distances[0] <= 3 - d + 1e-12 && f->distances[0] >= 3 - d - 1e-6));
    if (g) BOOST_TEST((g->distances[0] <= 2 - d + 1e-12 && g->distances[0] >= 2 - d - 1e-6));
    if (k < 4) BOOST_TEST((f && g));
    if (k > 14) BOOST_TEST((!f && !g));
  }
  // z = u v and a point below it: farther away along u = v
  const GC::Cad_spline_surface saddle{
      1, 1, {-1, -1, 1, 1}, {-1, -1, 1, 1}, {{-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}, {1, 1, 1}}, {}};
  BOOST_TEST(at(side(saddle, line(0, 0, 1, 0)), {0, 0, -0.5}).has_value());
  BOOST_TEST(!at(side(saddle, line(0, 0, 1, 0)), {0, 0, -2}).has_value());
  // beside a trough z = v^2: near its side, and beyond the centre of curvature
  GC::Cad_spline_surface trough{1, 2, {0, 0, 1, 1}, {-1, -1, -1, 1, 1, 1}, {}, {}};
  for (const double u : {0., 1.}) trough.points.insert(trough.points.end(), {{u, -1, 1}, {u, 0, -1}, {u, 1, 1}});
  const auto beside = at(side(trough, line(0.5, 0, 1, 0)), {-1, 0, 0.25});
  BOOST_REQUIRE(beside.has_value());
  BOOST_TEST(beside->distances[0] == std::hypot(1, 0.25), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(!at(side(trough, line(0.5, 0, 1, 0)), {-1, 0, 2}).has_value());
  // on knot lines
  GC::Cad_spline_surface four{1, 1, {0, 0, 1, 2, 2}, {0, 0, 1, 2, 2}, {}, {}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) four.points.push_back({1. * i, 1. * j, 0});
  for (const bool is_projected : {false, true}) {
    BOOST_TEST(at(side(four, line(0.5, 0.5, 0, 0)), {0.5, 0.5, 1}, is_projected).has_value());
    BOOST_TEST(!at(side(four, line(1, 0.5, 0, 0)), {1, 0.5, 1}, is_projected).has_value());
    BOOST_TEST(!at(side(four, line(0.5, 1, 0, 0)), {0.5, 1, 1}, is_projected).has_value());
  }
}

// At the point that a side of a surface is, the parameter along it stays.
BOOST_AUTO_TEST_CASE(singular_surfaces) {
  typedef std::vector<GC::Cad_point<2>> Points;
  const GC::Edge_curve before = in_space(GC::Cad_line<3>{{-1, 0, 0}, {0, 0, 1}});
  for (const bool swapped : {false, true}) {
    GC::Cad_spline_surface triangle{1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {}};
    if (swapped) std::swap(triangle.points[1], triangle.points[2]);
    const GC::Edge_side tip = side(triangle, swapped ? line(0.25, 0, 0, 0) : line(0, 0.25, 0, 0));
    const GC::Edge_side projected = GC::projected_side(tip, before, 0, 1, 1);
    const Points p = std::get<GC::Cad_spline_curve<2>>(*projected.curve).points;
    BOOST_TEST((p == Points(4, swapped ? GC::Cad_point<2>{0.25, 0} : GC::Cad_point<2>{0, 0.25})));
    BOOST_TEST(!GC::compare_at_feet(tip, tip, {false, false}, before, 0).has_value()); // no normal
  }
  // a curve without a direction: nothing is known across it
  const GC::Edge_side plane = side(Elementary{Kind::plane, standard}, line(1, 1, 0, 0)),
                      ring = side(Elementary{Kind::cylinder, standard, 3}, line(0, 0, 1, 0));
  const auto f = GC::compare_at_feet(ring, plane, {true, true}, in_space(GC::Cad_line<3>{{3, 0, 0}, {0, 0, 0}}), 0);
  BOOST_REQUIRE(f.has_value());
  BOOST_TEST(f->curvature_jump == 0);
}

// Numbers so large that rounding errors do not let the steps end, and so large that products
// overflow: then the curve stays.
BOOST_AUTO_TEST_CASE(large_numbers) {
  typedef std::vector<GC::Cad_point<2>> Points;
  const auto points = [](const GC::Edge_side& s, const GC::Cad_line<3>& curve) {
    const GC::Edge_side projected = GC::projected_side(s, in_space(curve), 0, 1, 1);
    return std::get<GC::Cad_spline_curve<2>>(*projected.curve).points;
  };
  for (int i = 0; i < 20; ++i) {
    const double far = 1e9 * (1 + 0.1 * i);
    const Elementary distant{Kind::cylinder, {{far, far / 3, far / 7}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 3};
    const GC::Edge_side ring = side(distant, line(0.3, 1, 0, 0));
    const Points p = points(ring, {{far + 4, far / 3 + 3, far / 7}, {0, 0, 1}});
    for (const GC::Cad_point<2>& x : p) BOOST_TEST(std::fabs(x[0] - std::atan2(3, 4)) <= 1e-6);
  }
  const Elementary huge{Kind::plane, {{0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}, {0, 0, 1}}},
      plane{Kind::plane, {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 1}}};
  BOOST_TEST((points(side(huge, line(0.5, 0.25, 0, 0)), {{1, 2, 3}, {0, 0, 1}}) == Points(4, {0.5, 0.25})));
  // a derivative that overflows
  const Points p = points(side(plane, line(0, 0, 0, 0)), {{0, 0, 0}, {1e308, 0, 0}});
  for (const GC::Cad_point<2>& x : p) BOOST_TEST((std::isfinite(x[0]) && x[1] == 0));
}

BOOST_AUTO_TEST_CASE(knot_lines) {
  const std::vector<GC::Cad_point<3>> points(5 * 2);
  GC::Cad_spline_surface s{2, 1, {0, 0, 0, 1, 1, 2, 2, 2}, {0, 0, 1, 1}, points, {}};
  const auto count = [&](int order) { return GC::surface_knot_lines(s, order).size(); };
  BOOST_TEST(count(0) == 0u);
  BOOST_TEST(count(1) == 1u);
  BOOST_TEST((GC::surface_knot_lines(s, 1)[0].constant_u && GC::surface_knot_lines(s, 1)[0].knot == 1));
  s.u_knots = {0, 0, 0, 0.5, 1, 2, 2, 2};
  BOOST_TEST(count(1) == 0u);
  BOOST_TEST(count(2) == 2u);
  const GC::Cad_offset_surface offset{std::make_shared<GC::Cad_surface>(s), 1};
  BOOST_TEST(GC::surface_knot_lines(offset, 1).size() == 2u);
  const GC::Cad_spline_curve<3> roof{1, {0, 0, 1, 2, 2}, {{0, 0, 0}, {1, 0, 1}, {2, 0, 0}}, {}};
  BOOST_TEST((GC::surface_knot_lines(GC::Cad_extrusion{roof, {0, 1, 0}}, 1).at(0).constant_u));
  BOOST_TEST((!GC::surface_knot_lines(GC::Cad_revolution{roof, {0, 0, -1}, {1, 0, 0}}, 1).at(0).constant_u));
  BOOST_TEST(GC::surface_knot_lines(Elementary{Kind::plane, standard}, 2).empty());
}

BOOST_AUTO_TEST_CASE(errors) {
  const GC::Edge_side plane = side(Elementary{Kind::plane, standard}, line(0, 0, 1, 0));
  const GC::Edge_curve edge = in_space(GC::Cad_line<3>{{0, 0, 0}, {1, 0, 0}});
  CHECK_ERROR(GC::curve_deviation(plane, edge, 1, 0), empty_domain);
  CHECK_ERROR(GC::curve_deviation(plane, edge, 0, infinity), not_finite);
  CHECK_ERROR(GC::curve_deviation(plane, in_space(GC::Cad_line<3>{{0, 0, 0}, {infinity, 0, 0}}), 0, 1), not_finite);
  const GC::Cad_placement flat{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}}};
  CHECK_ERROR(GC::curve_deviation(plane, in_space(GC::Cad_line<3>{{0, 0, 0}, {1, 0, 0}}, flat), 0, 1), singular_frame);
  CHECK_ERROR(GC::projected_side(plane, edge, 1, 0, 8), empty_domain);
  // curves and surfaces whose numbers do not fit
  typedef GC::Cad_spline_curve<3> Spline;
  const auto measured = [&](const auto& curve) { return GC::curve_deviation(plane, in_space(curve), 0, 1); };
  const std::vector<GC::Cad_point<3>> two{{0, 0, 0}, {1, 0, 0}};
  const std::vector<double> knots{0, 0, 1, 1};
  check_is(measured(Spline{1, knots, two, {}}).value, 0, 1e-12);
  CHECK_ERROR(measured(Spline{0, {0, 0.5, 1}, two, {}}), wrong_number_of_points);
  CHECK_ERROR(measured(Spline{61, std::vector<double>(64), two, {}}), wrong_number_of_points);
  CHECK_ERROR(measured(Spline{2, {0, 0, 0, 1, 1}, two, {}}), wrong_number_of_points);
  CHECK_ERROR(measured(Spline{1, {0, 0, 1}, two, {}}), wrong_number_of_points);
  CHECK_ERROR(measured(Spline{1, {0, 0, infinity, infinity}, two, {}}), not_finite);
  CHECK_ERROR(measured(Spline{1, {0, 1, 0, 1}, two, {}}), knot_multiplicity);
  CHECK_ERROR(measured(Spline{1, {0, 1, 1, 2}, two, {}}), empty_domain);
  CHECK_ERROR(measured(Spline{1, knots, two, {1}}), wrong_number_of_points);
  CHECK_ERROR(measured(Spline{1, knots, two, {1, 0}}), zero_weight);
  CHECK_ERROR(measured(Spline{1, knots, two, {1, infinity}}), not_finite);
  const GC::Cad_conic<3> point{GC::Cad_conic<3>::Kind::parabola, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 0};
  CHECK_ERROR(measured(point), zero_direction);
  GC::Cad_spline_surface torn = square;
  torn.points.pop_back();
  CHECK_ERROR(GC::curve_deviation(side(torn, line(0, 0, 1, 0)), edge, 0, 1), wrong_number_of_points);
  GC::Cad_spline_surface long_one = square;
  long_one.points.emplace_back();
  CHECK_ERROR(GC::curve_deviation(side(long_one, line(0, 0, 1, 0)), edge, 0, 1), wrong_number_of_points);
  const GC::Cad_offset_surface far{std::make_shared<GC::Cad_surface>(square), infinity},
      of_torn{std::make_shared<GC::Cad_surface>(torn), 1};
  CHECK_ERROR(GC::curve_deviation(side(far, line(0, 0, 1, 0)), edge, 0, 1), not_finite);
  CHECK_ERROR(GC::curve_deviation(side(of_torn, line(0, 0, 1, 0)), edge, 0, 1), wrong_number_of_points);
}
