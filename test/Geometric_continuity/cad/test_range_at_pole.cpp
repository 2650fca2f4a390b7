// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// These tests check the ranges at poles of surfaces: known lengths, places that are no pole, and
// foot points next to poles.

#define BOOST_TEST_MODULE range_at_pole

#include "support/cad_sides.h"

const GC::Cad_placement turned{{{0, -1, 0, 5}, {1, 0, 0, 7}, {0, 0, 1, -2}}};
typedef std::optional<std::pair<double, double>> Found;

Found at(const GC::Edge_side& a, double first, double last, double t, double bound) {
  return GC::range_at_pole(a, a, first, last, t, bound);
}
// It does not reach farther than the ends, and not much less far.
void check_is(const Found& range, double from, double to) {
  BOOST_REQUIRE(range.has_value());
  const double slack = 0.04 * (to - from), rounding = 1e-9 * (to - from);
  BOOST_TEST_CONTEXT("from " << range->first << " to " << range->second << ", from " << from << " to " << to) {
    BOOST_TEST((from - rounding <= range->first && range->first <= from + slack));
    BOOST_TEST((to - slack <= range->second && range->second <= to + rounding));
  }
}
// The profile (x(v), 0, z(v)) around the axis of z.
template <class Profile> GC::Cad_revolution revolved(const Profile& profile) { return {profile, {0, 0, 0}, {0, 0, 1}}; }
// A part of the plane z = 0 in polar coordinates, as it were: a fan of the radius 2, whose side at
// v = 0 is these points.
GC::Cad_spline_surface fan(const std::vector<GC::Cad_point<3>>& tip) {
  GC::Cad_spline_surface s{2, 1, {0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}, {}, {}};
  const GC::Cad_point<3> rim[] = {{2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  for (std::size_t i = 0; i < 3; ++i) {
    s.points.push_back(tip[i]);
    s.points.push_back(rim[i]);
  }
  return s;
}

BOOST_AUTO_TEST_CASE(elementary_surfaces) {
  const unsigned seed = first_seed();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(0.5, 20), exponent(-6, -1), longitude(-3, 3);
  for (int i = 0; i < 20; ++i) {
    const double r = radius(random), bound = std::pow(10, exponent(random)), u = longitude(random);
    BOOST_TEST_CONTEXT("seed " << seed << ", radius " << r << ", bound " << bound) {
      for (const GC::Cad_placement& p : {unmoved, turned}) {
        // a chord of a sphere, along the cone of 30 degrees, and at the cusp of a spindle, where
        // the circle passes
        const double chord = 2 * std::asin(bound / (2 * r));
        const Elementary sphere{Kind::sphere, standard, r}, cone{Kind::cone, standard, r, pi / 6},
            spindle{Kind::torus, standard, r, 2 * r};
        check_is(at(side(sphere, line(u, 0, 0, 1), p), 0, pi / 2, pi / 2, bound), pi / 2 - chord, pi / 2);
        check_is(at(side(sphere, line(u, pi / 2, 0, -1), p), 0, 3, 0, bound), 0, chord);
        check_is(at(side(cone, line(u, -2 * r, 0, 1), p), 0, r, 0, bound), 0, bound);
        check_is(at(side(cone, line(u, -2 * r, 0, 1), p), -r, r, 0, bound), -bound, bound);
        const double cusp = 2 * pi / 3, half = 2 * std::asin(bound / (4 * r));
        check_is(at(side(spindle, line(u, 0, 0, 1), p), 0, pi, cusp, bound), cusp - half, cusp + half);
        // a little beyond the pole
        check_is(at(side(sphere, line(u, 0, 0, 1), p), 0, pi / 2 + 1e-10, pi / 2 + 1e-10, bound), pi / 2 - chord,
                 pi / 2 + 1e-10);
        // not at the pole, and no pole
        BOOST_TEST(!at(side(sphere, line(u, 0, 0, 1), p), 0, pi / 2, pi / 2 - 3 * chord, bound));
        BOOST_TEST(!at(side(sphere, line(u, 0, 0, 1), p), 0, pi / 2, 0, bound));
        BOOST_TEST(!at(side(Elementary{Kind::cylinder, standard, bound / 100}, line(u, 0, 0, 1), p), 0, 1, 0, bound));
        BOOST_TEST(!at(side(Elementary{Kind::plane, standard}, line(0, 0, 0, 1), p), 0, 1, 0, bound));
        BOOST_TEST(!at(side(Elementary{Kind::torus, standard, 2 * r, r}, line(u, 0, 0, 1), p), 0, pi, pi, bound));
        BOOST_TEST(!at(side(Elementary{Kind::cone, standard, r, 0}, line(u, 0, 0, 1), p), 0, 1, 0, bound));
      }
    }
  }
}

// Both sides have to be there; one of them has to have a pole.
BOOST_AUTO_TEST_CASE(two_sides) {
  const Elementary sphere{Kind::sphere, standard, 2};
  const GC::Edge_side meridian = side(sphere, line(0, 0, 0, 1));
  const GC::Cad_frame wall{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
  const GC::Cad_conic<2> circle{GC::Cad_conic<2>::Kind::ellipse, {0, 0}, {1, 0}, {0, 1}, 2, 2};
  const GC::Edge_side plane = side(Elementary{Kind::plane, wall}, circle);
  const double chord = 2 * std::asin(0.01 / 4);
  check_is(GC::range_at_pole(meridian, plane, 0, pi / 2, pi / 2, 0.01), pi / 2 - chord, pi / 2);
  check_is(GC::range_at_pole(plane, meridian, 0, pi / 2, pi / 2, 0.01), pi / 2 - chord, pi / 2);
  GC::Cad_conic<2> away = circle;
  away.centre = {0, 0.02};
  BOOST_TEST(!GC::range_at_pole(meridian, side(Elementary{Kind::plane, wall}, away), 0, pi / 2, pi / 2, 0.01));
  // within the distance d of the pole up to sqrt(0.01^2 - 0.006^2) = 0.008
  away.centre = {0, -0.006};
  check_is(GC::range_at_pole(meridian, side(Elementary{Kind::plane, wall}, away), 0, pi / 2, pi / 2, 0.01),
           pi / 2 - std::asin(0.004), pi / 2);
  BOOST_TEST(!GC::range_at_pole(plane, plane, 0, pi / 2, pi / 2, 0.01));
}

BOOST_AUTO_TEST_CASE(surfaces_of_revolution) {
  typedef GC::Cad_conic<3> Conic;
  const Conic ellipse{Conic::Kind::ellipse, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 5, 2};
  const auto reach = [](const auto& profile, double first, double last, double bound) {
    return at(side(revolved(profile), line(1, 0, 0, 1)), first, last, last, bound);
  };
  // along x nearly, with the speed 5
  check_is(reach(ellipse, 0, pi / 2, 0.001), pi / 2 - 0.0002, pi / 2);
  check_is(reach(ellipse, 0, pi / 2 + 1e-9, 0.001), pi / 2 - 0.0002, pi / 2 + 1e-9);
  // a line at 45 degrees that misses the axis by less or more than a sixteenth of the distance
  for (const double missed : {0., 1e-12, 1e-4, 4e-4}) {
    const GC::Cad_line<3> ruling{{1 + missed, 0, 0}, {-1, 0, 1}};
    const double inside = std::sqrt(0.0001 / 2 - missed * missed / 4) - missed / 2;
    check_is(reach(ruling, 0, 1, 0.01), 1 - inside, 1);
  }
  for (const double missed : {7e-4, 0.005, 0.1})
    BOOST_TEST(!reach(GC::Cad_line<3>{{1 + missed, 0, 0}, {-1, 0, 1}}, 0, 1, 0.01));
  // a polyline that has a knot on the axis, next to which one looks
  const GC::Cad_spline_curve<3> zigzag{1, {0, 0, 1, 2, 2}, {{1, 0, 0}, {0, 0, 1}, {1, 0, 2}}, {}};
  const double half = 0.01 / std::sqrt(2.);
  check_is(at(side(revolved(zigzag), line(1, 0, 0, 1)), 0, 2, 1, 0.01), 1 - half, 1 + half);
  check_is(at(side(revolved(zigzag), line(1, 0, 0, 1)), 0, 2, 1.001, 0.01), 1 - half, 1 + half);
  BOOST_TEST(!at(side(revolved(zigzag), line(1, 0, 0, 1)), 0, 2, 1.1, 0.01));
  // not an extrusion
  const GC::Cad_extrusion extrusion{GC::Cad_line<3>{{0, 0, 0}, {1, 0, 0}}, {0, 1e-9, 0}};
  BOOST_TEST(!at(side(extrusion, line(0, 0, 0, 1)), 0, 1, 0, 0.01));
}

BOOST_AUTO_TEST_CASE(spline_surfaces) {
  const GC::Cad_point<3> tip{0, 0, 0};
  const auto swapped = [](const GC::Cad_spline_surface& s) { // u and v
    GC::Cad_spline_surface t{s.v_degree, s.u_degree, s.v_knots, s.u_knots, {}, s.weights};
    const std::size_t columns = static_cast<std::size_t>(s.v_points());
    for (std::size_t j = 0; j < columns; ++j)
      for (std::size_t i = j; i < s.points.size(); i += columns) t.points.push_back(s.points[i]);
    t.weights.clear();
    return t;
  };
  const auto reach = [&](const std::vector<GC::Cad_point<3>>& points, double bound) {
    const GC::Cad_spline_surface s = fan(points);
    const Found found = at(side(s, line(0, 0, 0, 1)), 0, 1, 0, bound),
                other = at(side(swapped(s), line(0, 0, 1, 0)), 0, 1, 0, bound);
    BOOST_TEST((found == other));
    return found;
  };
  check_is(reach({tip, tip, tip}, 0.01), 0, 0.005);
  check_is(reach({{1e-15, 0, 0}, {0, -1e-15, 0}, {0, 0, 1e-16}}, 0.01), 0, 0.005);
  // more than rounding, and so little that it is meant
  for (const double apart : {1e-12, 1e-10, 1e-4, 1e-22, 1e-200}) {
    BOOST_TEST(!reach({{apart, 0, 0}, tip, tip}, 0.01));
    BOOST_TEST(!reach({tip, {0, apart, 0}, tip}, 0.01));
    BOOST_TEST(!reach({tip, tip, {0, 0, apart}}, 100));
  }
  // at most a quarter of the range
  BOOST_TEST((reach({tip, tip, tip}, 100) == Found({0, 0.25})));
  // at the other end, with weights, and at a double knot inside
  GC::Cad_spline_surface s = fan({tip, tip, tip});
  for (std::size_t i = 0; i < 6; i += 2) std::swap(s.points[i], s.points[i + 1]);
  s.weights = {1, 1, 0.5, 0.5, 1, 1};
  check_is(at(side(s, line(0, 0, 0, 1)), 0, 1, 1, 0.01), 0.995, 1);
  BOOST_TEST(!at(side(s, line(0, 0, 0, 1)), 0, 1, 0, 0.01));
  GC::Cad_spline_surface hourglass{1, 2, {0, 0, 1, 1}, {0, 0, 0, 1, 1, 2, 2, 2}, {}, {}};
  for (const double y : {-1., 1.})
    for (const double x : {-2., -1., 0., 1., 2.}) hourglass.points.push_back({x, y * x, 0});
  check_is(at(side(hourglass, line(0.5, 0, 0, 1)), 0, 2, 1, 0.01), 0.995, 1.005);
  check_is(at(side(hourglass, line(0.5, 0, 0, 1)), 0, 2, 1.001, 0.01), 0.995, 1.005);
  // a line between control points, which nearly is a point where the one above it is one
  hourglass.v_knots = {0, 0, 0, 1, 1.5, 2, 2, 2};
  for (const std::size_t i : {1u, 6u})
    for (double& x : hourglass.points[i]) x /= 1024;
  BOOST_TEST(!at(side(hourglass, line(0.5, 0, 0, 1)), 0, 2, 1, 0.01));
}

BOOST_AUTO_TEST_CASE(what_is_refused) {
  const GC::Edge_side meridian = side(Elementary{Kind::sphere, standard, 2}, line(0, 0, 0, 1));
  const double nan = (std::numeric_limits<double>::quiet_NaN)();
  CHECK_ERROR(at(meridian, 1, 0, 0.5, 0.01), empty_domain);
  CHECK_ERROR(at(meridian, 0, 1, 2, 0.01), empty_domain);
  CHECK_ERROR(at(meridian, 0, 1, -1, 0.01), empty_domain);
  CHECK_ERROR(at(meridian, 0, 1, nan, 0.01), not_finite);
  CHECK_ERROR(at(side(Elementary{Kind::sphere, standard, nan}, line(0, 0, 0, 1)), 0, 1, 1, 0.01), not_finite);
  BOOST_TEST(!at(meridian, 0, pi / 2, pi / 2, 0));
  BOOST_TEST(!at(meridian, 0, pi / 2, pi / 2, -1));
  BOOST_TEST(!at(meridian, pi / 2, pi / 2, pi / 2, 0.01)); // no length
}

// The part of an enclosure of which least is known is next to the pole.
BOOST_AUTO_TEST_CASE(where_least_is_known) {
  typedef GC::Cad_conic<3> Conic;
  const Conic arc{Conic::Kind::ellipse, {-4, 0, 0}, {1, 0, 0}, {0, 0, 1}, 8, 8};
  const double pole = std::acos(0.5);
  const GC::Edge_side a = side(revolved(arc), line(0.1, 0, 0, 1)), b = side(revolved(arc), line(0.1 + 1e-13, 0, 0, 1));
  const GC::Edge_enclosure e = GC::edge_enclosure(a, b, -1.5, 1.5);
  BOOST_REQUIRE(e.angle.has_value());
  BOOST_TEST(e.angle->value.upper > 1e-3);
  BOOST_TEST(std::fabs(std::fabs(e.angle->upper_at) - pole) < 1e-3);
  const Found range = GC::range_at_pole(a, b, -1.5, 1.5, e.angle->upper_at, 0.01);
  BOOST_REQUIRE(range.has_value());
  BOOST_TEST((range->first < e.angle->upper_at && e.angle->upper_at < range->second));
}

// The longitude at a pole is that to which the curve leads, whatever that of the given curve is.
BOOST_AUTO_TEST_CASE(projections) {
  const unsigned seed = first_seed();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> longitude(-3, 3), off(-0.3, 0.3), height(-1, 1);
  for (int i = 0; i < 20; ++i) {
    const double u = longitude(random), wrong = off(random), h = height(random);
    BOOST_TEST_CONTEXT("seed " << seed << ", longitude " << u << ", wrong by " << wrong << ", height " << h) {
      // a circle through the pole of a sphere of the radius 2, in a plane that is inclined to the
      // axis
      const double centre[] = {0, 0, 2}, c = std::cos(u), s = std::sin(u), r = std::sqrt(4 / (1 + h * h));
      const double n = std::sqrt(1 + h * h);
      // the plane through the pole with the normal (-s + ..): the centre of the circle lies below
      // the pole
      const GC::Cad_point<3> down{-s * h / n, c * h / n, -1 / n}, along{c, s, 0};
      const GC::Cad_conic<3> circle{GC::Cad_conic<3>::Kind::ellipse,
                                    {centre[0] + r * down[0], centre[1] + r * down[1], centre[2] + r * down[2]},
                                    {-down[0], -down[1], -down[2]},
                                    along,
                                    r,
                                    r};
      const GC::Edge_curve space{std::make_shared<GC::Cad_curve<3>>(circle), unmoved};
      const double length = 0.5;
      const Elementary sphere{Kind::sphere, standard, 2};
      // the given curve leads to another longitude at the pole
      const GC::Edge_side given = side(sphere, line(u + wrong, pi / 2, -wrong / length, -1));
      const GC::Edge_side feet = GC::projected_side(given, space, 0, length, 32);
      BOOST_TEST(GC::curve_deviation(feet, space, 0, length).value.upper < 2e-8);
      // and backwards
      GC::Cad_conic<3> backwards = circle;
      for (double& x : backwards.y_axis) x = -x;
      const GC::Edge_curve other{std::make_shared<GC::Cad_curve<3>>(backwards), unmoved};
      const GC::Edge_side reversed = side(sphere, line(u, pi / 2, wrong / length, 1));
      const GC::Edge_side feet_of_other = GC::projected_side(reversed, other, -length, 0, 32);
      BOOST_TEST(GC::curve_deviation(feet_of_other, other, -length, 0).value.upper < 2e-8);
    }
  }
}
