// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Enclosures over whole edges: of shapes with known answers, and of random ones against samples.

#define BOOST_TEST_MODULE Edge_enclosure

#include "support/cad_sides.h"
#include "support/sampled_edges.h"

GC::Cad_conic<2> circle(double radius) {
  return {GC::Cad_conic<2>::Kind::ellipse, {0, 0}, {1, 0}, {0, 1}, radius, radius};
}

// The value lies in the enclosure, up to a rounding error of its own, and the enclosure is narrow.
void check_is(const GC::Enclosure& e, double value, double floor, double relative = 0.01) {
  BOOST_TEST_CONTEXT("enclosure " << e << " of " << value) {
    BOOST_TEST(e.lower <= value + 4e-16 * (1 + value));
    BOOST_TEST(value <= e.upper + 4e-16 * (1 + value));
    BOOST_TEST((e.upper <= floor || e.upper - e.lower <= relative * e.upper));
  }
}

// The largest gap, angle and jump of the curvature, up to what counts as nothing.
void check_is(const GC::Edge_enclosure& e, double gap, double angle, double jump) {
  check_is(e.gap.value, gap, gap == 0 ? 1e-9 : 0);
  check_is(e.angle->value, angle, angle == 0 ? 1e-8 : 0);
  check_is(e.curvature_jump->value, jump, jump == 0 ? 1e-4 : 0);
}

// No sample exceeds the upper end, and where the lower end is said to be attained it is.
void check_samples(const GC::Edge_side& a, const GC::Edge_side& b, double first, double last,
                   // a tenth of them exactly
                   const GC::Edge_enclosure& e, int samples = 1000, bool exact = false) {
  const long double slack = 1e-15L;
  const auto singular = [&](double t) {
    for (const auto* ranges : {&e.curvature_undefined, &e.curvature_unresolved, &e.unresolved})
      for (const auto& r : *ranges)
        if (r.first <= t && t <= r.second) return true;
    return false;
  };
  int wrong = 0;
  for (int i = 0; i <= samples; ++i) {
    const double t = i == samples ? last : first + i * ((last - first) / samples);
    if (t > last) continue;
    if (exact && i % 10 == 0) {
      const Q upper((std::min)(e.gap.value.upper, 1e300));
      wrong += sampled_edges::gap_square<Q>(a, b, t) > upper * upper;
    } else {
      wrong += std::sqrt(sampled_edges::gap_square<long double>(a, b, t)) > e.gap.value.upper + slack;
    }
    if (singular(t)) continue;
    if (e.angle) wrong += sampled_edges::angle(a, b, t) > e.angle->value.upper + slack;
    if (e.curvature_jump)
      wrong += sampled_edges::curvature_jump(a, b, t, 1e-6L) > e.curvature_jump->value.upper + 1e-12L;
  }
  BOOST_TEST(wrong == 0);
  const Q lower(e.gap.value.lower);
  if (exact)
    BOOST_TEST((sampled_edges::gap_square<Q>(a, b, e.gap.parameter) >= lower * lower));
  else
    BOOST_TEST(std::sqrt(sampled_edges::gap_square<long double>(a, b, e.gap.parameter)) >= e.gap.value.lower - slack);
  if (e.angle) BOOST_TEST(sampled_edges::angle(a, b, e.angle->parameter) >= e.angle->value.lower - slack);
  if (e.curvature_jump)
    BOOST_TEST(sampled_edges::curvature_jump(a, b, e.curvature_jump->parameter, 1e-6L) >=
               e.curvature_jump->value.lower - 1e-12L);
}

// A plane and a cylinder that touches it along the axis of y: the normal of both points down.
std::pair<GC::Edge_side, GC::Edge_side> fillet(double radius) {
  const GC::Cad_frame frame{{0, 0, radius}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}};
  return {side(plane(), line(0, 0, 0, 1), true), side(Elementary{Kind::cylinder, frame, radius}, line(0, 0, 0, -1))};
}

BOOST_AUTO_TEST_CASE(fillets) {
  for (double radius : {0.1, 3., 1e4}) {
    const auto [a, b] = fillet(radius);
    const GC::Edge_enclosure e = GC::edge_enclosure(a, b, -1, 5);
    check_is(e, 0, 0, 1);
    BOOST_TEST(e.singular.empty());
    check_samples(a, b, -1, 5, e);
    for (double other : {0.5, 7.}) { // of another radius
      const auto [c, d] = fillet(other);
      const double jump = 1 - (std::min)(radius, other) / (std::max)(radius, other);
      check_is(GC::edge_enclosure(b, d, -1, 5).curvature_jump->value, jump, 1e-4);
    }
    GC::Edge_side opposite = b; // the faces fold onto each other
    opposite.reversed = true;
    check_is(GC::edge_enclosure(a, opposite, -1, 5).angle->value, pi, 0);
  }
}

BOOST_AUTO_TEST_CASE(sphere_cut_by_a_plane) {
  const double radius = 2.5;
  for (double latitude : {-1.2, -0.1, 0.3, 1.5}) {
    const double height = radius * std::sin(latitude);
    const GC::Cad_frame frame{{0, 0, height}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const GC::Edge_side sphere = side(Elementary{Kind::sphere, standard, radius}, line(0, latitude, 1, 0)),
                        cut = side(plane(frame), circle(radius * std::cos(latitude)));
    const GC::Edge_enclosure e = GC::edge_enclosure(sphere, cut, 0, 2 * pi);
    check_is(e, 0, pi / 2 - latitude, 1);
    check_samples(sphere, cut, 0, 2 * pi, e);
  }
}

BOOST_AUTO_TEST_CASE(cones_cylinders_and_tori) {
  const double half_angle = 0.4, radius = 3, small = 0.75;
  const GC::Edge_side cylinder = side(Elementary{Kind::cylinder, standard, radius}, line(0, 0, 1, 0)),
                      cone = side(Elementary{Kind::cone, standard, radius, half_angle}, line(0, 0, 1, 0));
  const GC::Edge_enclosure e = GC::edge_enclosure(cylinder, cone, 0.5, 6);
  check_is(e.gap.value, 0, 1e-9);
  check_is(e.angle->value, half_angle, 0);
  check_is(e.curvature_jump->value, 0, 1e-4); // both are straight across the circle
  const GC::Cad_frame top{{0, 0, small}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const GC::Edge_side torus = side(Elementary{Kind::torus, standard, radius, small}, line(0, pi / 2, 1, 0)),
                      cap = side(plane(top), circle(radius));
  const GC::Edge_enclosure f = GC::edge_enclosure(torus, cap, 0, 2 * pi);
  check_is(f, 0, 0, 1);
  check_samples(torus, cap, 0, 2 * pi, f);
  // a torus that touches a cylinder on its outside
  const GC::Edge_side outer = side(Elementary{Kind::torus, standard, radius - small, small}, line(0, 0, 1, 0));
  const GC::Edge_enclosure g = GC::edge_enclosure(outer, cylinder, 0, 2 * pi);
  check_is(g.angle->value, 0, 1e-8);
  check_is(g.curvature_jump->value, 1, 0);
}

// (x(u), v, v w(u)) by the abscissas of Greville and the control values of w.
GC::Cad_spline_surface tilted(const std::vector<double>& u_knots, const std::vector<double>& w) {
  GC::Cad_spline_surface s{3, 1, u_knots, {0, 0, 1, 1}, {}, {}};
  for (std::size_t i = 0; i < w.size(); ++i) {
    const double x = (u_knots[i + 1] + u_knots[i + 2] + u_knots[i + 3]) / 3;
    s.points.push_back({x, 0, 0});
    s.points.push_back({x, 1, w[i]});
  }
  return s;
}

// The normal turns by 1e-7 within a thousandth of the edge.
BOOST_AUTO_TEST_CASE(kink_between_samples) {
  const double step = 0x1p-12, at = 0.34375;
  const std::vector<double> knots = clamped(3, {at, at + step, at + 2 * step, at + 3 * step, at + 4 * step});
  std::vector<double> flat(9, 0.), bump = flat;
  bump[4] = 1.5e-7; // the basis function of those five knots, 2/3 at the third
  const GC::Edge_side a = side(tilted(knots, flat), line(0, 0, 1, 0)), b = side(tilted(knots, bump), line(0, 0, 1, 0));
  const GC::Edge_enclosure e = GC::edge_enclosure(a, b, 0, 1);
  check_is(e.gap.value, 0, 1e-9);
  check_is(e.angle->value, std::atan(1e-7), 1e-9);
  BOOST_TEST(e.angle->value.lower > 0.99e-7);
  BOOST_TEST(std::fabs(e.angle->parameter - (at + 2 * step)) < step);
  BOOST_TEST(std::fabs(e.angle->point[0] - e.angle->parameter) < 1e-12);
  check_samples(a, b, 0, 1, e);
}

BOOST_AUTO_TEST_CASE(known_gaps) {
  GC::Cad_frame above = standard;
  for (double height : {1e-6, 1e-3, 7.}) {
    above.origin[2] = height;
    const GC::Edge_enclosure e =
        GC::edge_enclosure(side(plane(), line(1, 2, 3, 4)), side(plane(above), line(1, 2, 3, 4)), 0, 1);
    check_is(e.gap.value, height, 0, 1e-6);
    check_is(e.angle->value, 0, 1e-8);
    check_is(e.curvature_jump->value, 0, 1e-4);
  }
  // a parabola above a plane: the gap t^2 is largest at an end
  const GC::Cad_spline_surface s{
      2, 1, {0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0}, {0, 1, 0}, {0.5, 0, 0}, {0.5, 1, 0}, {1, 0, 1}, {1, 1, 1}},
      {}};
  const GC::Edge_enclosure e = GC::edge_enclosure(side(s, line(0, 0, 1, 0)), side(plane(), line(0, 0, 1, 0)), 0, 0.75);
  check_is(e.gap.value, 0.5625, 0);
  BOOST_TEST(e.gap.parameter == 0.75);
  check_is(e.angle->value, std::atan(1.5), 0);
}

// The tests take one surface in different representations.
BOOST_AUTO_TEST_CASE(representations_of_one_surface) {
  const double radius = 2, height = 3, r = std::sqrt(0.5);
  const GC::Edge_side cylinder = side(Elementary{Kind::cylinder, standard, radius}, line(0.5, 1, 1, 0.25));
  const GC::Cad_conic<3> base{GC::Cad_conic<3>::Kind::ellipse, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, radius, radius};
  const GC::Edge_side extruded = side(GC::Cad_extrusion{base, {0, 0, 1}}, line(0.5, 1, 1, 0.25)),
                      turned =
                          side(GC::Cad_revolution{GC::Cad_line<3>{{radius, 0, 0}, {0, 0, 1}}, {0, 0, 0}, {0, 0, 1}},
                               line(0.5, 1, 1, 0.25));
  for (const GC::Edge_side& other : {extruded, turned}) {
    const GC::Edge_enclosure e = GC::edge_enclosure(cylinder, other, 0, 4);
    check_is(e, 0, 0, 0);
    check_samples(cylinder, other, 0, 4, e, 100);
  }
  // a quarter of the cylinder by a rational surface, and a plane through its upper circle by a
  // rational curve
  GC::Cad_spline_surface rational{2, 1, {0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}, {}, {1, 1, r, r, 1, 1}};
  for (const P2& p : {P2{radius, 0}, P2{radius, radius}, P2{0, radius}})
    for (double z : {0., height}) rational.points.push_back({p[0], p[1], z});
  const GC::Cad_spline_curve<2> arc{2, {0, 0, 0, 1, 1, 1}, {{radius, 0}, {radius, radius}, {0, radius}}, {1, r, 1}};
  const GC::Cad_frame top{{0, 0, height}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const GC::Edge_side quarter = side(rational, line(0, 1, 1, 0)), lid = side(plane(top), arc);
  const GC::Edge_enclosure e = GC::edge_enclosure(quarter, lid, 0, 1);
  BOOST_TEST(e.gap.value.upper < 1e-9);
  check_is(e.angle->value, pi / 2, 0);
  check_samples(quarter, lid, 0, 1, e);
  // and the analytic cylinder along a common ruling
  const GC::Edge_side at_start = side(rational, line(0, 0, 0, 1 / height)),
                      ruling = side(Elementary{Kind::cylinder, standard, radius}, line(0, 0, 0, 1));
  const GC::Edge_enclosure f = GC::edge_enclosure(at_start, ruling, 0, height);
  check_is(f, 0, 0, 0);
  // offsets: of a cylinder and of a torus
  for (const auto& [kind, first, second, distance] :
       {std::tuple{Kind::cylinder, 2., 0., 0.5}, std::tuple{Kind::torus, 5., 1., -0.25}}) {
    const auto basis = std::make_shared<GC::Cad_surface>(Elementary{kind, standard, first, second});
    const GC::Edge_side offset = side(GC::Cad_offset_surface{basis, distance}, line(0.25, 0.5, 1, 0.5)),
                        direct = side(kind == Kind::torus ? Elementary{kind, standard, first, second + distance}
                                                          : Elementary{kind, standard, first + distance},
                                      line(0.25, 0.5, 1, 0.5));
    const GC::Edge_enclosure g = GC::edge_enclosure(offset, direct, 0, 1);
    check_is(g, 0, 0, 0);
  }
}

// Offsets of circles are circles, in the parameter plane and in space.
BOOST_AUTO_TEST_CASE(rectangular_domains) { // planes over [0, 2] x [0, 1] and [0, 1] x [0, 2]
  const GC::Cad_spline_surface wide{1, 1, {0, 0, 2, 2}, {0, 0, 1, 1}, {{0, 0, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}}, {}},
      high{1, 1, {0, 0, 1, 1}, {0, 0, 2, 2}, {{0, 0, 0}, {0, 2, 0}, {1, 0, 0}, {1, 2, 0}}, {}};
  const auto gap = [](const GC::Cad_spline_surface& s, const GC::Cad_line<2>& x) {
    return GC::edge_enclosure(side(s, x), side(plane(), x), 0, 2).gap.value.upper;
  };
  BOOST_TEST(gap(wide, line(0, 0.5, 1, 0)) < 1e-14);
  BOOST_TEST(gap(high, line(0.5, 0, 0, 1)) < 1e-14);
  CHECK_ERROR(gap(wide, line(0.5, 0, 0, 1)), parameter_outside_domain);
  CHECK_ERROR(gap(high, line(0, 0.5, 1, 0)), parameter_outside_domain);
}

BOOST_AUTO_TEST_CASE(offset_curves) {
  const auto basis = std::make_shared<GC::Cad_curve<2>>(circle(2));
  const GC::Edge_side offset = side(plane(), GC::Cad_offset_curve<2>{basis, 0.5, {}}),
                      direct = side(plane(), circle(2.5));
  check_is(GC::edge_enclosure(offset, direct, 0, 6).gap.value, 0, 1e-9);
  check_is(GC::edge_enclosure(offset, side(plane(), circle(2)), 0, 6).gap.value, 0.5, 0);
  const GC::Cad_conic<3> base{GC::Cad_conic<3>::Kind::ellipse, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 3, 3};
  const GC::Cad_offset_curve<3> inner{std::make_shared<GC::Cad_curve<3>>(base), -1, {0, 0, 1}};
  const GC::Edge_enclosure e =
      GC::edge_enclosure(side(GC::Cad_extrusion{inner, {0, 0, 1}}, line(0, 0, 1, 0.5)),
                         side(Elementary{Kind::cylinder, standard, 2}, line(0, 0, 1, 0.5)), 0, 3);
  check_is(e, 0, 0, 0);
}

template <class Random> GC::Cad_spline_surface random_surface(Random& random, bool rational) {
  std::uniform_real_distribution<double> noise(-0.1, 0.1), weight(0.5, 2);
  GC::Cad_spline_surface s{3, 2, clamped(3, {0.25, 0.5, 0.5, 0.875}), clamped(2, {0.375}), {}, {}};
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 4; ++j) {
      s.points.push_back({i + noise(random), j + noise(random), 5 * noise(random)});
      if (rational) s.weights.push_back(weight(random));
    }
  return s;
}

BOOST_AUTO_TEST_CASE(random_splines) {
  const unsigned seed = first_seed();
  std::mt19937 random = seeded(seed);
  std::uniform_real_distribution<double> unit(0.05, 0.95), tiny(-1e-5, 1e-5);
  for (int round = 0; round < 12; ++round) {
    const bool rational = round % 3 == 2;
    const GC::Cad_spline_surface s = random_surface(random, rational);
    GC::Cad_spline_surface t = round % 2 ? random_surface(random, rational) : s;
    for (P3& p : t.points)
      for (double& x : p) x += tiny(random);
    GC::Cad_spline_curve<2> c{3, clamped(3, {0.5}), {}, {}};
    for (int i = 0; i < 5; ++i) c.points.push_back({(i + unit(random)) / 5, unit(random)});
    const GC::Edge_side a = side(s, c), b = side(t, c, round % 4 == 1);
    const GC::Edge_enclosure e = GC::edge_enclosure(a, b, 0, 1);
    BOOST_TEST_CONTEXT("seed " << seed << ", round " << round << ": gap " << e.gap.value << ", angle " << e.angle->value
                               << ", jump " << e.curvature_jump->value << ", " << e.boxes << " boxes") {
      check_samples(a, b, 0, 1, e, 1000, true);
      const auto narrow = [](const GC::Enclosure& x, double floor) {
        return x.upper <= floor || x.upper - x.lower <= 0.0101 * x.upper;
      };
      BOOST_TEST(narrow(e.gap.value, 1e-9));
      BOOST_TEST(narrow(e.angle->value, 1e-8));
      BOOST_TEST(narrow(e.curvature_jump->value, 1e-4));
    }
  }
}

// Meridians that end in a pole, rulings that end in an apex, a side of a patch that is one point:
// near these the normals are left out.
BOOST_AUTO_TEST_CASE(singular_points) {
  const auto tiny_at = [](const std::vector<std::pair<double, double>>& ranges, double t, double length) {
    return ranges.size() == 1 && ranges[0].first <= t && t <= ranges[0].second &&
           ranges[0].second - ranges[0].first <= length * 0x1p-19;
  };
  const double tilt = 0.25, apex = -1 / std::sin(0.5);
  const GC::Cad_frame turned{
      {0, 0, 0}, {std::cos(tilt), 0, std::sin(tilt)}, {0, 1, 0}, {-std::sin(tilt), 0, std::cos(tilt)}};
  const Elementary sphere{Kind::sphere, standard, 2}, cone{Kind::cone, standard, 1, 0.5};
  // the same meridian of the same sphere, by two frames
  GC::Edge_enclosure e =
      GC::edge_enclosure(side(sphere, line(0, 0.5, 0, 1)),
                         side(Elementary{Kind::sphere, turned, 2}, line(0, 0.5 - tilt, 0, 1)), 0, pi / 2 - 0.5);
  check_is(e, 0, 0, 0);
  BOOST_TEST(e.singular.empty()); // the normal of a sphere at its pole is known
  BOOST_TEST(e.curvature_undefined.empty());
  // a quarter of a cylinder of the radius 1 that touches the sphere of the radius 2 along the
  // meridian, and mirrored
  const GC::Cad_frame lying{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
  for (const GC::Cad_placement& p : {unmoved, mirrored}) {
    const GC::Edge_side meridian = side(sphere, line(0, 0, 0, 1), false, p),
                        touching = side(Elementary{Kind::cylinder, lying, 2}, line(0, 0, 1, 0), false, p);
    e = GC::edge_enclosure(meridian, touching, 0, pi / 2);
    check_is(e.angle->value, 0, 1e-8);
    check_is(e.curvature_jump->value, 1, 0);
    BOOST_TEST((e.singular.empty() && e.curvature_undefined.empty()));
    check_samples(meridian, touching, 0, 1.5, GC::edge_enclosure(meridian, touching, 0, 1.5), 100);
  }
  // along a ruling from the apex; the curvature is infinite there
  e = GC::edge_enclosure(side(cone, line(0.5, apex, 0, 1)), side(cone, line(0.5, apex, 0, 1), true), 0, 1);
  BOOST_TEST(e.gap.value.upper < 1e-9);
  check_is(e.angle->value, pi, 0);
  BOOST_TEST(e.singular.empty());
  BOOST_TEST(tiny_at(e.curvature_undefined, 0, 1));
  e = GC::edge_enclosure(side(cone, line(0.5, apex - 1, 0, 1)), side(cone, line(0.5, apex - 1, 0, 1)), 0,
                         1.9); // across it
  BOOST_TEST(tiny_at(e.singular, 1, 1.9));
  const GC::Edge_side other_nappe = side(cone, line(0.5, apex - 1, 1, 0.2)), floor = side(plane(), line(0, 0, 1, 1));
  check_samples(other_nappe, floor, 0, 1, GC::edge_enclosure(other_nappe, floor, 0, 1), 100);
  GC::Cad_spline_surface corner{2, 2, clamped(2), clamped(2), {}, {}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) corner.points.push_back({0.5 * j, 0.25 * j * i, 0.25 * j * (j - 1) + 0.125 * i * j});
  e = GC::edge_enclosure(side(corner, line(0, 0, 0, 1)), side(corner, line(0, 0, 0, 1)), 0, 1);
  check_is(e.angle->value, 0, 1e-8);
  BOOST_TEST(tiny_at(e.singular, 0, 1));
  // the whole edge is a point
  e = GC::edge_enclosure(side(corner, line(0, 0, 1, 0)), side(corner, line(0, 0, 1, 0)), 0, 1);
  BOOST_TEST(e.gap.value.upper < 1e-9);
  BOOST_TEST(!e.angle);
  BOOST_TEST(!e.curvature_jump);
  BOOST_TEST(e.singular.empty());
  BOOST_TEST(e.unresolved == (std::vector<std::pair<double, double>>{{0, 1}}));
  BOOST_TEST(e.boxes <= 3 * GC::Edge_precision().boxes);
  // no length
  e = GC::edge_enclosure(side(sphere, line(0, 0.5, 0, 1)), side(cone, line(0.5, 0, 0, 1)), 0.25, 0.25);
  check_samples(side(sphere, line(0, 0.5, 0, 1)), side(cone, line(0.5, 0, 0, 1)), 0.25, 0.25, e, 1);
  BOOST_TEST(e.gap.value.upper - e.gap.value.lower < 1e-12);
}

// A surface with a fold along a knot line, and one whose curvature jumps there.
BOOST_AUTO_TEST_CASE(knot_lines) {
  GC::Cad_spline_surface roof{1, 1, {0, 0, 0.5, 1, 1}, {0, 0, 1, 1}, {}, {}}; // z = |x|, x = 2u - 1
  for (double x : {-1., 0., 1.})
    for (double y : {0., 1.}) roof.points.push_back({x, y, std::fabs(x)});
  GC::Edge_side a = side(roof, line(0.5, 0, 0, 1));
  const GC::Edge_side b = side(plane(), line(0, 0, 0, 1));
  // along the fold either side of it may be meant, unless it is known where the face lies
  GC::Edge_side falling = b, rising = b;
  const double r = std::sqrt(0.5);
  rising.placement = {{{r, 0, -r, 0}, {0, 1, 0, 0}, {r, 0, r, 0}}};
  falling.placement = {{{r, 0, r, 0}, {0, 1, 0, 0}, {-r, 0, r, 0}}};
  for (const auto& [face_side, same, other] : {std::tuple{1, falling, rising}, std::tuple{-1, rising, falling}}) {
    a.face_side = face_side; // left of the line towards larger v are smaller u
    check_is(GC::edge_enclosure(a, same, 0, 1).angle->value, 0, 1e-8);
    check_is(GC::edge_enclosure(a, other, 0, 1).angle->value, pi / 2, 0);
  }
  a.face_side = 0;
  BOOST_TEST(GC::edge_enclosure(a, rising, 0, 1).angle->value.upper >= pi / 2);
  BOOST_TEST(GC::edge_enclosure(rising, a, 0, 1).angle->value.upper >= pi / 2);
  GC::Cad_spline_surface turned_roof{1, 1, {0, 0, 1, 1}, {0, 0, 0.5, 1, 1}, {}, {}};
  for (double y : {0., 1.})
    for (double x : {-1., 0., 1.}) turned_roof.points.push_back({x, y, std::fabs(x)});
  GC::Edge_side reversed_rising = rising; // the normal of the roof points down
  reversed_rising.reversed = true;
  BOOST_TEST(GC::edge_enclosure(side(turned_roof, line(0, 0.5, 1, 0)), reversed_rising, 0, 1).angle->value.upper >=
             pi / 2);
  // an edge that crosses the fold, at a parameter that is not rounded and at one that is
  for (double slope : {1., 0.7}) {
    const GC::Edge_side across = side(roof, line(0, 0.5, slope, 0)), below = side(plane(), line(-1, 0.5, 2 * slope, 0));
    const GC::Edge_enclosure e = GC::edge_enclosure(across, below, 0, 1);
    check_is(e.gap.value, 1, 0);
    check_is(e.angle->value, pi / 4, 0);
  }
  // the curvature across the edge is 0 on the left and 2 on the right of x = 1/2
  GC::Cad_spline_surface bend{2, 2, {0, 0, 0, 0.5, 1, 1, 1}, {0, 0, 0, 1, 1, 1}, {}, {}};
  const double x[4] = {0, 0.25, 0.75, 1}, z[4] = {0, 0, 0, 0.25};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j) bend.points.push_back({0.5 * j, x[i], z[i]});
  const GC::Edge_side crossing = side(bend, line(0.125, 0.1, 0.7, 0.3)),
                      flat = side(plane(), line(0.125, 0.1, 0.7, 0.3));
  const GC::Edge_enclosure e = GC::edge_enclosure(crossing, flat, 0, 1);
  check_is(e.curvature_jump->value, 1, 0);
  BOOST_TEST(e.curvature_undefined.empty());
  // with itself it agrees on both sides of the knot line, which both must be known to cross at once
  const GC::Edge_enclosure own = GC::edge_enclosure(crossing, crossing, 0, 1);
  check_is(own.curvature_jump->value, 0, 1e-4);
  BOOST_TEST(own.singular.empty());
  BOOST_TEST(own.curvature_undefined.size() == 1u);
  BOOST_TEST(std::fabs(own.curvature_undefined.at(0).first - 0.375 / 0.7) < 1e-10);
  const GC::Edge_side over = side(roof, line(0.125, 0.1, 0.7, 0.3));
  const GC::Edge_enclosure folded = GC::edge_enclosure(over, over, 0, 1);
  check_is(folded.angle->value, 0, 1e-8);
  BOOST_TEST(folded.singular.size() == 1u);
  BOOST_TEST(folded.gap.value.upper < 1e-9);
  // where the knot is met exactly nothing is left out, nor where the surface is smooth across a
  // knot of full multiplicity
  BOOST_TEST(GC::edge_enclosure(side(roof, line(0, 0.5, 1, 0)), side(roof, line(0, 0.5, 1, 0)), 0, 1).singular.empty());
  GC::Cad_spline_surface smooth = roof;
  for (P3& p : smooth.points) p[2] = p[0];
  const GC::Edge_side on_smooth = side(smooth, line(0.125, 0.1, 0.7, 0.3));
  const GC::Edge_enclosure f = GC::edge_enclosure(on_smooth, on_smooth, 0, 1);
  BOOST_TEST(f.singular.empty());
  BOOST_TEST(f.curvature_undefined.empty());
  check_is(f.angle->value, 0, 1e-8);
}

// A budget of one range gives wide enclosures, which are still true.
// Two patches, one of which has a side of a tiny length: the normal turns next to it, and is not
// left out unless it is proved to vanish.
BOOST_AUTO_TEST_CASE(sides_that_nearly_are_points) {
  const auto patch = [](double x, double z, double end) {
    return GC::Cad_spline_surface{1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0}, {0, 10, 0}, {x, 0, z}, {end, 10, z}},
                                  {}};
  };
  const GC::Edge_side ground = side(plane(), line(0, 0, 0, 10));
  for (double tiny : {1e-3, 1e-6, 1e-10, 1e-12}) { // at (0, 0, 0) the angle is 45 degrees
    const GC::Edge_enclosure e = GC::edge_enclosure(side(patch(tiny, tiny, 9), line(0, 0, 0, 1)), ground, 0, 1);
    BOOST_TEST_CONTEXT("length " << tiny)
    check_is(e.angle->value, pi / 4, 0);
    BOOST_TEST((e.singular.empty() && e.unresolved.empty()));
  }
  // a point: what is left out is proved to have no normal there
  const GC::Edge_enclosure point = GC::edge_enclosure(side(patch(0, 0, 9), line(0, 0, 0, 1)), ground, 0, 1);
  check_is(point.angle->value, 0, 1e-8);
  BOOST_TEST((point.singular.size() == 1 && point.unresolved.empty()));
  // nothing is known of it
  const GC::Edge_enclosure open = GC::edge_enclosure(side(patch(1e-200, 1e-200, 9), line(0, 0, 0, 1)), ground, 0, 1);
  BOOST_TEST((open.singular.empty() && open.unresolved.size() == 1));
}

// An edge of many pieces needs as many parts, and gets them.
BOOST_AUTO_TEST_CASE(many_pieces) {
  GC::Cad_spline_curve<2> c{1, {0}, {}, {}};
  for (int i = 0; i <= 3000; ++i) {
    c.knots.push_back(i);
    c.points.push_back({double(i), i % 2 / 8.});
  }
  c.knots.push_back(3000);
  const GC::Edge_side a = side(plane(), c);
  GC::Cad_frame turned = standard;
  turned.y_axis = {0, 0.6, 0.8};
  const GC::Edge_side b = side(plane(turned), c);
  GC::Edge_precision precision;
  precision.with_curvature = false;
  const GC::Edge_enclosure e = GC::edge_enclosure(a, b, 0, 3000, precision);
  check_is(e.angle->value, std::acos(0.6), 0);
  check_is(e.gap.value, std::sqrt(0.8) / 8, 0);
  BOOST_TEST((e.singular.empty() && e.unresolved.empty() && !e.exhausted));
  precision.most_boxes = 1000;
  const GC::Edge_enclosure part = GC::edge_enclosure(a, b, 0, 3000, precision);
  BOOST_TEST((part.exhausted && !part.unresolved.empty() && part.singular.empty()));
  BOOST_TEST(part.gap.value.upper == (std::numeric_limits<double>::infinity)());
}

BOOST_AUTO_TEST_CASE(limited_work) {
  std::mt19937 random(7);
  const GC::Cad_spline_surface s = random_surface(random, true), t = random_surface(random, true);
  const GC::Cad_spline_curve<2> c{2, clamped(2), {{0, 0.1}, {0.5, 0.9}, {1, 0.2}}, {}};
  const GC::Edge_side a = side(s, c), b = side(t, c);
  GC::Edge_precision precision;
  int before = 0;
  for (int boxes : {1, 20, 100}) {
    precision.boxes = boxes;
    const GC::Edge_enclosure e = GC::edge_enclosure(a, b, 0, 1, precision);
    BOOST_TEST(e.boxes >= before);
    before = e.boxes;
    check_samples(a, b, 0, 1, e, 50, true);
  }
  precision.with_curvature = false;
  BOOST_TEST(!GC::edge_enclosure(a, b, 0, 1, precision).curvature_jump);
}

// Normals that vanish at both ends of an edge: where the surface is a point, and where its
// derivatives are parallel.
BOOST_AUTO_TEST_CASE(singular_ends) {
  typedef std::vector<std::pair<double, double>> Ranges;
  const auto is_at_ends = [](const Ranges& r) {
    return r.size() == 2 && r[0].first == 0 && r[0].second <= 0x1p-18 && r[1].first >= 1 - 0x1p-18 && r[1].second == 1;
  };
  const GC::Cad_spline_surface along_v{
      1, 2, clamped(1), clamped(2), {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {2, 0, 0}, {2, 3, 1}, {1, 2, 0}}, {}},
      along_u{2, 1, clamped(2), clamped(1), {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {2, 3, 1}, {1, 2, 0}, {1, 2, 0}}, {}};
  const GC::Cad_spline_surface spindle_shaped{
      1, 2, clamped(1), clamped(2), {{0, 0, 0}, {1, 1, 0}, {1, 2, 0}, {0, 0, 0}, {2, 1, 1}, {1, 2, 0}}, {}};
  const Elementary sphere{Kind::sphere, standard, 2}, spindle{Kind::torus, standard, 1, 2};
  for (const GC::Edge_side& a :
       {side(along_v, line(0, 0, 0, 1)), side(along_v, line(0, 1, 0, -1)), side(along_u, line(0, 0, 1, 0)),
        side(along_u, line(1, 0, -1, 0)), side(spindle_shaped, line(0, 0, 0, 1))}) {
    const GC::Edge_enclosure e = GC::edge_enclosure(a, a, 0, 1);
    check_is(e.angle->value, 0, 1e-8);
    BOOST_TEST((is_at_ends(e.singular) && e.unresolved.empty()));
    BOOST_TEST((is_at_ends(e.curvature_undefined) && e.curvature_unresolved.empty()));
  }
  // where the distance from the axis has another sign beyond a point, the normal has, too
  for (const auto& [surface, zero] : {std::pair{sphere, pi / 2}, std::pair{spindle, 2 * pi / 3}}) {
    const GC::Edge_side a = side(surface, line(0.5, 0, 0, 1));
    const GC::Edge_enclosure e = GC::edge_enclosure(a, a, zero - 1, zero + 0.9);
    check_is(e.angle->value, 0, 1e-8);
    BOOST_TEST((e.singular.size() == 1 && e.unresolved.empty()));
    BOOST_TEST((e.singular.at(0).first <= zero && zero <= e.singular.at(0).second));
  }
  // no surface
  const GC::Edge_side point = side(Elementary{Kind::sphere, standard, 0}, line(0, 0, 1, 0)),
                      tip = side(Elementary{Kind::cone, standard, 0, 0.5}, line(0, 0, 1, 0));
  for (const GC::Edge_side& a : {point, tip}) {
    const GC::Edge_enclosure e = GC::edge_enclosure(a, side(plane(), line(0, 0, 0, 0)), 0, 1);
    BOOST_TEST((!e.angle && e.gap.value.upper <= 1e-9));
    BOOST_TEST(!GC::edge_enclosure(a, side(plane(), line(0, 0, 0, 0)), 0.5, 0.5).angle);
  }
  // the curve stops at its start: only the direction of the edge vanishes there
  const GC::Cad_spline_curve<2> starting{2, clamped(2), {{0, 0}, {0, 0}, {1, 1}}, {}};
  const GC::Edge_side a = side(plane(), starting);
  const GC::Edge_enclosure e = GC::edge_enclosure(a, a, 0, 1);
  BOOST_TEST((e.singular.empty() && e.curvature_undefined.size() == 1 && e.curvature_undefined.at(0).first == 0));
}

// A sphere of a negative radius is the other one, mirrored in its centre.
BOOST_AUTO_TEST_CASE(negative_radius) {
  const GC::Edge_side a = side(Elementary{Kind::sphere, standard, -2}, line(0.5, 0.25, 1, 0.5)),
                      b = side(Elementary{Kind::sphere, standard, 2}, line(0.5, -0.25, 1, -0.5), false,
                               {{{-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, 1, 0}}});
  const GC::Edge_enclosure e = GC::edge_enclosure(a, b, 0, 1);
  BOOST_TEST(e.gap.value.upper < 1e-9);
  check_samples(a, b, 0, 1, e, 100);
}

// Splines whose domain is a part of their knots, or with more equal knots at an end than there are
// functions, and parts of them.
BOOST_AUTO_TEST_CASE(knots_beyond_the_domain) {
  const auto check_flat = [](const GC::Edge_side& a, double first, double last) {
    const GC::Edge_enclosure e = GC::edge_enclosure(a, side(plane(), *a.curve), first, last);
    BOOST_TEST(e.gap.value.upper < 1e-9);
    check_is(e.angle->value, 0, 1e-8);
    BOOST_TEST((e.singular.empty() && e.unresolved.empty()));
  };
  const GC::Cad_spline_surface uniform{1, 1, {-1, 0, 1, 2}, {-1, 0, 1, 2}, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}},
                                       {}};
  check_flat(side(uniform, GC::Cad_curve<2>(line(0, 0.25, 1, 0.5))), 0, 1);
  const GC::Cad_spline_surface repeated{
      1,
      1,
      {0, 0, 0, 1, 1, 1},
      {0, 0, 1, 1},
      {{7, 7, 7}, {7, 7, 7}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {7, 7, 7}, {7, 7, 7}},
      {}};
  const GC::Edge_side along = side(repeated, line(0, 0.25, 1, 0.5));
  check_flat(along, 0, 1);
  const GC::Cad_spline_curve<2> repeated_curve{1, {0, 0, 0, 1, 1, 1}, {{7, 7}, {0, 0.25}, {1, 0.75}, {7, 7}}, {}};
  GC::Edge_side start = side(repeated, line(0, 0, 0, 1));
  start.face_side = 1; // of smaller u: of those beyond the start
  check_flat(start, 0, 1);
  for (const double t : {0., 1.}) {
    check_flat(along, t, t);
    check_flat(side(repeated, repeated_curve), t, t);
  }
  // parts of a curve with knots, and a knot line of the surface next to their ends
  GC::Cad_spline_surface bent{
      1, 1, {0, 0, 1, 2, 2}, {0, 0, 1, 1}, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 0}}, {}};
  const GC::Edge_side polyline =
      side(bent, GC::Cad_spline_curve<2>{1, {0, 0, 1, 2, 3, 3}, {{0, 0}, {0.5, 1}, {1.5, 0}, {2, 1}}, {}});
  for (const auto& [first, last] :
       {std::pair{0., 3.}, std::pair{1.25, 1.75}, std::pair{2.25, 3.}, std::pair{0., 0.5}, std::pair{1.5 + 1e-14, 2.},
        std::pair{1., 1.5 - 1e-14}, std::pair{1.5 - 1e-14, 2.}, std::pair{1., 1.5 + 1e-14}})
    check_flat(polyline, first, last);
  for (const auto& [first, last] :
       // u = 1 at 9/7, which is no number
       {std::pair{9. / 7 - 1e-14, 1.8}, std::pair{1., 9. / 7 + 1e-14}})
    check_flat(side(bent, line(0.1, 0.25, 0.7, 0)), first, last);
  // a curve that crosses many knot lines, and back
  GC::Cad_spline_surface cells{1, 1, {0, 0, 1, 2, 3, 4, 4}, {0, 0, 1, 2, 3, 4, 4}, {}, {}};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) cells.points.push_back({1. * i, 1. * j, 0});
  check_flat(side(cells, GC::Cad_spline_curve<2>{2, {0, 0, 0, 1, 1, 1}, {{0, 0.25}, {7.5, 7}, {0, 0.25}}, {}}), 0, 1);
}

// Offsets of offsets, until derivatives are missing.
BOOST_AUTO_TEST_CASE(repeated_offsets) {
  GC::Cad_curve<2> curve = circle(3);
  GC::Cad_surface surface = Elementary{Kind::sphere, standard, 1};
  const GC::Edge_side flat = side(plane(), circle(3));
  const auto at_curve = [&] { return GC::edge_enclosure(side(plane(), curve), flat, 0, 1); };
  const auto at_surface = [&] {
    return GC::edge_enclosure(side(surface, line(0, 0, 1, 0.5)),
                              side(Elementary{Kind::sphere, standard, 3}, line(0, 0, 1, 0.5)), 0, 1);
  };
  int most[2] = {0, 0};
  for (int i = 1; i <= 12; ++i) {
    curve = GC::Cad_offset_curve<2>{std::make_shared<GC::Cad_curve<2>>(curve), 0.25, {0, 0}};
    surface = GC::Cad_offset_surface{std::make_shared<GC::Cad_surface>(surface), 0.25};
    try {
      check_is(at_curve().gap.value, 0.25 * i, 0);
      most[0] = i;
    } catch (const GC::Error& e) {
      BOOST_TEST((e.code() == GC::Error_code::jet_order_too_low));
    }
    try {
      check_is(at_surface().gap.value, std::fabs(2 - 0.25 * i), 1e-6);
      most[1] = i;
    } catch (const GC::Error& e) {
      BOOST_TEST((e.code() == GC::Error_code::jet_order_too_low));
    }
  }
  BOOST_TEST((1 <= most[0] && most[0] < 12 && 1 <= most[1] && most[1] < 12));
}

// A range whose length is no number, parameters beyond those of which something is known, and
// quotients without a least divisor.
BOOST_AUTO_TEST_CASE(ranges_beyond_numbers) {
  const GC::Edge_side low = side(plane(), line(0, 0, 1e-308, 0)),
                      high = side(plane({{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), line(0, 0, 1e-308, 0));
  const GC::Edge_enclosure wide = GC::edge_enclosure(low, high, -1e308, 1.5e308);
  BOOST_TEST((wide.gap.value.lower <= 1 && 1 <= wide.gap.value.upper));
  for (const GC::Cad_line<2>& far : {line(1e301, 0, 1e301, 0), line(0, 1e301, 0, 1e301)}) {
    const GC::Edge_side a = side(plane(), far);
    const GC::Edge_enclosure e = GC::edge_enclosure(a, a, 0, 1);
    BOOST_TEST((e.gap.value.lower == 0 && std::isinf(e.gap.value.upper) && !e.angle && !e.curvature_jump));
  }
  GC::Edge_precision exact;
  exact.flat_curvature = 0;
  const GC::Edge_side a = side(plane(), line(0, 0, 1, 0));
  const GC::Edge_enclosure e = GC::edge_enclosure(a, a, 0, 1, exact);
  BOOST_TEST((e.curvature_jump && e.curvature_jump->value.lower == 0 && e.curvature_jump->value.upper <= 2));
}

BOOST_AUTO_TEST_CASE(refused_and_huge_numbers) {
  const double infinite = (std::numeric_limits<double>::infinity)();
  const GC::Edge_side good = side(plane(), line(0, 0, 1, 0));
  const auto enclose = [&](const GC::Edge_side& a) { return GC::edge_enclosure(a, good, 0, 1); };
  CHECK_ERROR(GC::edge_enclosure(good, good, 1, 0), empty_domain);
  CHECK_ERROR(GC::edge_enclosure(good, good, 0, infinite), not_finite);
  CHECK_ERROR(enclose(side(plane(), line(0, 0, std::nan(""), 0))), not_finite);
  CHECK_ERROR(enclose(side(Elementary{Kind::sphere, standard, infinite}, line(0, 0, 1, 0))), not_finite);
  CHECK_ERROR(enclose(side(plane(), line(0, 0, 1, 0), false, {{{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, 0}}})),
              singular_frame);
  GC::Cad_spline_surface s{1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}}, {}};
  CHECK_ERROR(enclose(side(s, line(0.5, 0, 1, 0))), parameter_outside_domain);
  enclose(side(s, line(-1e-9, 0, 1, 0)));
  GC::Cad_spline_surface bad = s;
  bad.points.pop_back();
  CHECK_ERROR(enclose(side(bad, line(0, 0, 1, 0))), wrong_number_of_points);
  bad = s;
  bad.u_degree = -1;
  CHECK_ERROR(enclose(side(bad, line(0, 0, 1, 0))), wrong_number_of_points);
  bad = s;
  bad.v_knots = {0, 1, 0, 1};
  CHECK_ERROR(enclose(side(bad, line(0, 0, 1, 0))), knot_multiplicity);
  bad = s;
  bad.weights = {1, 1, 0, 1};
  CHECK_ERROR(enclose(side(bad, line(0, 0, 1, 0))), zero_weight);
  // numbers so large or small that nothing is known are no errors, and there is no NaN
  for (double scale : {1e-300, 1e-160, 1e150, 1e300}) {
    GC::Cad_spline_surface huge = s;
    for (P3& p : huge.points)
      for (double& x : p) x *= scale;
    const GC::Edge_enclosure e = enclose(side(huge, line(0, 0, 1, 0)));
    BOOST_TEST(e.gap.value.lower <= e.gap.value.upper);
    if (e.angle) BOOST_TEST((0 <= e.angle->value.lower && e.angle->value.upper <= 3.1416));
    if (e.curvature_jump) BOOST_TEST((0 <= e.curvature_jump->value.lower && e.curvature_jump->value.upper <= 2));
    if (scale < 1) BOOST_TEST(e.gap.value.upper >= 1 - scale);
  }
}
