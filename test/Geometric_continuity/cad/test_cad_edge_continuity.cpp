// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Exact verdicts along whole edges: what continues each other exactly, what is off by one unit in
// the last place, and what is not decided.

#define BOOST_TEST_MODULE cad_edge_continuity

#include "support/cad_sides.h"
#include "support/limited.h"

const GC::Cad_placement cyclic{{{0, 2, 0, 5}, {0, 0, 2, -7}, {2, 0, 0, 0.5}}};

template <class Surface, class Curve>
GC::Edge_side side(const Surface& surface, const Curve& curve, int face_side, bool reversed = false,
                   const GC::Cad_placement& placement = unmoved) {
  GC::Edge_side s = side(surface, curve, reversed, placement);
  s.face_side = face_side;
  return s;
}
GC::Cad_frame at_height(double z) { return {{0, 0, z}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; }
double next(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }

// E.g. "G1 curvature", "gap", or "undecided".
std::string verdict(const GC::Edge_side& a, const GC::Edge_side& b, double first = 0, double last = 1) {
  const auto e = GC::edge_continuity(a, b, first, last);
  if (!e) return "undecided";
  if (e->g_order < 0) return to_string(e->defect);
  return 'G' + std::to_string(e->g_order) + (e->g_order == 2 ? "" : " " + to_string(e->defect));
}

unsigned seed() {
  static const unsigned s = first_seed();
  BOOST_TEST_MESSAGE("seed " << s);
  return s;
}

// Cubic with inner knots in u, cubic in v; near a plane so that no normal vanishes. Its numbers
// have few digits.
template <class Random> GC::Cad_spline_surface random_surface(Random& random, const std::vector<double>& inner_v) {
  GC::Cad_spline_surface s{3, 3, clamped(3, {0.25, 0.5, 0.5, 0.875}), clamped(3, inner_v), {}, {}};
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < s.v_points(); ++j)
      s.points.push_back({i + double(random() % 512) * 0x1p-11, j + double(random() % 512) * 0x1p-11,
                          double(random() % 512) * 0x1p-9});
  return s;
}
// The surface over v in [0, 1] that continues another beyond v = 1, twice continuously
// differentiably.
GC::Cad_spline_surface continuation(const GC::Cad_spline_surface& s) {
  GC::Cad_spline_surface t{3, 3, s.u_knots, clamped(3), {}, {}};
  const int n = s.v_points();
  for (int i = 0; i < 8; ++i) {
    P3 row[4];
    for (int k = 0; k < 3; ++k) {
      const double p = s.points[i * n + n - 3][k], q = s.points[i * n + n - 2][k], r = s.points[i * n + n - 1][k];
      row[0][k] = r;
      row[1][k] = 2 * r - q;
      row[2][k] = p - 4 * q + 4 * r;
      row[3][k] = row[2][k] + r - q;
    }
    t.points.insert(t.points.end(), row, row + 4);
    if (!s.weights.empty()) t.weights.insert(t.weights.end(), 4, s.weights[i * n + n - 1] * 8);
  }
  return t;
}
// The surface with u in the opposite direction.
GC::Cad_spline_surface turned(const GC::Cad_spline_surface& s) {
  GC::Cad_spline_surface t = s;
  const std::size_t n = s.u_knots.size(), m = s.v_points();
  for (std::size_t i = 0; i < n; ++i) t.u_knots[i] = 1 - s.u_knots[n - 1 - i];
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      t.points[i * m + j] = s.points[(7 - i) * m + j];
      if (!s.weights.empty()) t.weights[i * m + j] = s.weights[(7 - i) * m + j];
    }
  return t;
}

BOOST_AUTO_TEST_CASE(splines_that_continue_each_other) {
  std::mt19937 random(seed());
  for (bool rational : {false, true}) {
    GC::Cad_spline_surface s = random_surface(random, {});
    for (int i = 0; rational && i < 8; ++i) s.weights.insert(s.weights.end(), 4, std::ldexp(1., int(random() % 3)));
    const GC::Cad_spline_surface t = continuation(s);
    const auto a = side(s, line(0, 1, 1, 0)), b = side(t, line(0, 0, 1, 0));
    BOOST_TEST(verdict(a, b) == "G2");
    BOOST_TEST(verdict(b, a, 0.25, 0.75) == "G2");
    BOOST_TEST(verdict(a, side(turned(t), line(1, 0, -1, 0), 0, true)) == "G2");
    // other points at equal parameters
    BOOST_TEST(verdict(a, side(turned(t), line(0, 0, 1, 0), 0, true)) == "gap");
    BOOST_TEST(verdict(side(s, line(-2, 1, 0.5, 0)), side(turned(t), line(3, 0, -0.5, 0), 0, true), 4, 6) == "G2");
    BOOST_TEST(verdict(side(s, line(0, 1, 1, 0), 1, false, cyclic), side(t, line(0, 0, 1, 0), 1, false, cyclic)) ==
               "G2");
    BOOST_TEST(verdict(a, side(t, line(0, 0, 1, 0), 0, true)) == "G0 fold");
    BOOST_TEST(verdict(a, side(t, line(0, 0, 0.5, 0))) == "gap");
    BOOST_TEST(verdict(a, a, 0, 2) == "undecided");                         // beyond the domain
    BOOST_TEST(verdict(a, side(t, line(0, 0, 1, 0x1p-60))) == "undecided"); // not a parameter line
    const GC::Edge_side& d =
        side(t, GC::Cad_spline_curve<2>{2, {0, 0, 0, 0.5, 1, 1, 1}, {{0, 0}, {0.25, 0}, {0.75, 0}, {1, 0}}, {}});
    BOOST_TEST(verdict(a, d) == "G2"); // a spline that is straight
    const GC::Edge_side& e =
        side(t, GC::Cad_spline_curve<2>{2, {0, 0, 0, 0.5, 1, 1, 1}, {{0, 0}, {0.25, 0}, {next(0.75), 0}, {1, 0}}, {}});
    BOOST_TEST(verdict(a, e) == "undecided");
    // one control point off by one unit in the last place, in each row, at each place
    const char* expected[] = {"gap", "G0 crease", "G1 curvature", "G2"};
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 4; ++j) {
        GC::Cad_spline_surface off = t;
        off.points[i * 4 + j][2] = next(off.points[i * 4 + j][2]);
        const auto c = side(off, line(0, 0, 1, 0));
        BOOST_TEST(verdict(a, c) == expected[j]);
        BOOST_TEST(verdict(c, a) == expected[j]);
        // the first three belong to u < 1/2 only, the last three to u > 1/2
        BOOST_TEST(verdict(a, c, 0, 0.5) == (i < 5 ? expected[j] : "G2"));
        BOOST_TEST(verdict(a, c, 0.5, 1) == (i < 3 ? "G2" : expected[j]));
      }
    if (rational) {
      GC::Cad_spline_surface off = t;
      off.weights[4] = next(off.weights[4]);
      BOOST_TEST(verdict(a, side(off, line(0, 0, 1, 0))) == "gap");
    }
  }
}

// The two parts of one surface beside a line.
BOOST_AUTO_TEST_CASE(lines_inside_splines) {
  std::mt19937 random(seed() + 1);
  for (bool rational : {false, true}) {
    // the multiplicities 1, 2, 3 of 1/4, 1/2, 3/4
    GC::Cad_spline_surface s = random_surface(random, {0.25, 0.5, 0.5, 0.75, 0.75, 0.75});
    for (std::size_t i = 0; rational && i < s.points.size(); ++i)
      s.weights.push_back(1 + double(random() % 64) * 0x1p-7);
    for (const auto& [v, expected] : {std::pair{0.25, "G2"}, std::pair{0.5, "G1 curvature"},
                                      std::pair{0.75, "G0 crease"}, std::pair{next(0.5), "G2"}, std::pair{0.1, "G2"}}) {
      BOOST_TEST(verdict(side(s, line(0, v, 1, 0), 1), side(s, line(0, v, 1, 0), -1)) == expected);
      BOOST_TEST(verdict(side(s, line(0, v, 1, 0), -1), side(s, line(0, v, 1, 0), 1), 0.125, 0.875) == expected);
      const bool knot = v == 0.25 || v == 0.5 || v == 0.75;
      BOOST_TEST(verdict(side(s, line(0, v, 1, 0)), side(s, line(0, v, 1, 0))) == (knot ? "undecided" : "G2"));
      BOOST_TEST(verdict(side(s, line(0, v, 1, 0), 1), side(s, line(0, next(v), 1, 0), -1)) == "gap");
    }
    // across the other knots: that the surface itself is not smooth at v = 3/4 does not matter
    BOOST_TEST(verdict(side(s, line(0.25, 0, 0, 1), 1), side(s, line(0.25, 0, 0, 1), -1)) == "G2");
    BOOST_TEST(verdict(side(s, line(0.5, 0, 0, 1), 1), side(s, line(0.5, 0, 0, 1), -1)) == "G1 curvature");
  }
}

// A face on one side of a knot line is compared, not that on the other side.
BOOST_AUTO_TEST_CASE(sides_of_knot_lines) {
  std::mt19937 random(seed() + 6);
  const GC::Cad_spline_surface s = random_surface(random, {0.5, 0.5, 0.5});
  GC::Cad_spline_surface above{3, 3, s.u_knots, clamped(3), {}, {}}, below = above;
  for (std::size_t i = 0; i < 8; ++i) {
    below.points.insert(below.points.end(), s.points.begin() + i * 7, s.points.begin() + i * 7 + 4);
    above.points.insert(above.points.end(), s.points.begin() + i * 7 + 3, s.points.begin() + i * 7 + 7);
  }
  for (const auto& [sign, same, other] : {std::tuple{1, &above, &below}, std::tuple{-1, &below, &above}}) {
    const GC::Edge_side a = side(s, line(0, 0.5, 1, 0), sign);
    const auto along = [&](const GC::Cad_spline_surface* t) { return side(*t, line(0, t == &above ? 0 : 1, 1, 0)); };
    BOOST_TEST(verdict(a, along(same)) == "G2");
    BOOST_TEST(verdict(a, along(other)) == "G0 crease");
  }
}

// x(t) is odd about t = 1/2 and vanishes at multiples of 1/4, y(t) is even: the edges agree at
// these, and as a whole when one is reversed.
BOOST_AUTO_TEST_CASE(edges_that_agree_backwards_only) {
  const double x[] = {0, 3, -6.5, 6.5, -3, 0}, y[] = {5, 1, -1, -1, 1, 5};
  GC::Cad_spline_surface a{5, 1, clamped(5, {}), clamped(1), {}, {}}, b = a;
  for (int i = 0; i < 6; ++i)
    for (double z : {0., 1.}) {
      a.points.push_back({x[i], y[i], z});
      b.points.push_back({-x[i], y[i], -z});
    }
  BOOST_TEST(verdict(side(a, line(0, 0, 1, 0)), side(b, line(1, 0, -1, 0))) == "G2");
  BOOST_TEST(verdict(side(a, line(0, 0, 1, 0)), side(b, line(0, 0, 1, 0))) == "undecided");
}

// A half of a shape and its mirror image, which is the other half.
BOOST_AUTO_TEST_CASE(mirrored_splines) {
  std::mt19937 random(seed() + 7);
  const GC::Cad_spline_surface s = random_surface(random, {});
  GC::Cad_spline_surface t = continuation(s);
  for (P3& p : t.points) p[0] = -p[0];
  for (bool reversed : {false, true})
    BOOST_TEST(verdict(side(s, line(0, 1, 1, 0)), side(t, line(0, 0, 1, 0), 0, reversed, mirrored)) ==
               (reversed ? "G2" : "G0 fold"));
}

BOOST_AUTO_TEST_CASE(seam_of_a_closed_spline) {
  std::mt19937 random(seed() + 2);
  GC::Cad_spline_surface s{5, 1, clamped(5, {}), clamped(1), {}, {}};
  P3 p[2][3];
  for (int j = 0; j < 2; ++j) {
    p[j][0] = {0, 0, double(j)};
    p[j][1] = {1, double(random() % 64) * 0x1p-9, double(j)};
    p[j][2] = {2, 1 + double(random() % 64) * 0x1p-9, double(j)};
  }
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 2; ++j) {
      P3 x;
      for (int k = 0; k < 3; ++k) {
        const double a = p[j][0][k], b = p[j][1][k], c = p[j][2][k];
        x[k] = i < 3 ? p[j][i][k] : i == 3 ? c - 4 * b + 4 * a : i == 4 ? 2 * a - b : a;
      }
      s.points.push_back(x);
    }
  BOOST_TEST(verdict(side(s, line(0, 0, 0, 1)), side(s, line(1, 0, 0, 1))) == "G2");
  s.points[7][1] = next(s.points[7][1]); // out of the tangent plane
  BOOST_TEST(verdict(side(s, line(0, 0, 0, 1)), side(s, line(1, 0, 0, 1))) == "G1 curvature");
}

// The straight edge (t, 0, 0), and the same one with homogeneous points that are multiplied by 1 +
// 2 t.
BOOST_AUTO_TEST_CASE(factors_of_rational_edges) {
  const GC::Cad_spline_surface a{1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}}, {}},
      b{2,
        1,
        {0, 0, 0, 1, 1, 1},
        {0, 0, 1, 1},
        {{0, 0, 0}, {0, -1, 0}, {0.25, 0, 0}, {0.25, -1, 0}, {1, 0, 0}, {1, -1, 0}},
        {1, 1, 2, 2, 3, 3}};
  BOOST_TEST(verdict(side(a, line(0, 0, 1, 0)), side(b, line(0, 0, 1, 0))) == "undecided");
}

// A plane and a cylinder that touches it along the axis of y: the normal of both points down.
const GC::Cad_frame lying{{0, 0, 2}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}};
const GC::Edge_side ground = side(plane(), line(0, 0, 0, 1), 0, true),
                    fillet = side(Elementary{Kind::cylinder, lying, 2}, line(0, 0, 0, -1));

BOOST_AUTO_TEST_CASE(planes_and_cylinders) {
  BOOST_TEST(verdict(ground, fillet, -1, 5) == "G1 curvature");
  const GC::Cad_spline_curve<2> straight{1, {-8, -8, 8, 8}, {{0, 8}, {0, -8}}, {}};
  BOOST_TEST(verdict(ground, side(Elementary{Kind::cylinder, lying, 2}, straight), -1, 5) == "G1 curvature");
  BOOST_TEST(verdict(fillet, fillet) == "G2");
  BOOST_TEST(verdict(ground, side(Elementary{Kind::cylinder, lying, next(2)}, line(0, 0, 0, -1))) == "gap");
  BOOST_TEST(verdict(ground, side(Elementary{Kind::cylinder, lying, 2}, line(1e-300, 0, 0, -1))) == "gap");
  BOOST_TEST(verdict(ground, side(Elementary{Kind::cylinder, lying, 2}, line(0, 0, 0, -1), 0, true)) == "G0 fold");
  GC::Cad_frame tilted = standard;
  tilted.x_axis[2] = 1e-300;
  BOOST_TEST(verdict(side(plane(tilted), line(0, 0, 0, 1), 0, true), fillet) == "G0 crease");
  const GC::Cad_frame larger{{0, 0, 5}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}}; // of another radius
  BOOST_TEST(verdict(fillet, side(Elementary{Kind::cylinder, larger, 5}, line(0, 0, 0, -1))) == "G1 curvature");

  // planes: the same by another frame, at an angle, parallel
  const GC::Cad_frame skew{{3, 1, 0}, {1, 2, 0}, {-1, 1, 0}, {0, 0, 1}};
  BOOST_TEST(verdict(side(plane(), line(3, 1, 0, 3)), side(plane(skew), line(0, 0, 1, 1))) == "G2");
  BOOST_TEST(verdict(side(plane(), line(3, 1, 0, 3)), side(plane(skew), line(0, 0, 1, next(1)))) == "gap");
  BOOST_TEST(verdict(side(plane(), line(0, 0, 0, 1)), side(plane(tilted), line(0, 0, 0, 1))) == "G0 crease");
  BOOST_TEST(verdict(side(plane(), line(0, 0, 0, 1)), side(plane(at_height(5e-324)), line(0, 0, 0, 1))) == "gap");

  // along each axis in space
  const GC::Cad_point<3> axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int k = 0; k < 3; ++k) {
    const GC::Cad_point<3>&x = axes[k], &y = axes[(k + 1) % 3], &z = axes[(k + 2) % 3];
    const GC::Cad_frame one{{0, 0, 0}, x, y, z}, other{{0, 0, 0}, x, z, {-y[0], -y[1], -y[2]}};
    BOOST_TEST(verdict(side(plane(one), line(0, 0, 1, 0)), side(plane(other), line(0, 0, 1, 0))) == "G0 crease");
  }

  // the top of a cylinder, and what closes it smoothly
  const GC::Cad_conic<2> circle{GC::Cad_conic<2>::Kind::ellipse, {0, 0}, {1, 0}, {0, 1}, 2, 2};
  const GC::Edge_side wall = side(Elementary{Kind::cylinder, standard, 2}, line(0, 3, 1, 0));
  BOOST_TEST(verdict(wall, side(plane(at_height(3)), circle), 0, 2 * pi) == "G0 crease");
  BOOST_TEST(verdict(wall, side(Elementary{Kind::sphere, at_height(3), 2}, line(0, 0, 1, 0)), 0, 2 * pi) ==
             "G1 curvature");
  BOOST_TEST(verdict(wall, side(Elementary{Kind::torus, at_height(3), 1.5, 0.5}, line(0, 0, 1, 0))) == "G1 curvature");
  BOOST_TEST(verdict(wall, side(Elementary{Kind::torus, at_height(3), 1.5, next(0.5)}, line(0, 0, 1, 0))) == "gap");
  BOOST_TEST(verdict(wall, side(Elementary{Kind::cone, at_height(3), 2, 1e-300}, line(0, 0, 1, 0))) == "G0 crease");
  BOOST_TEST(verdict(wall, side(Elementary{Kind::cone, standard, 2, 0}, line(0, 3, 1, 0))) == "G2");
  BOOST_TEST(verdict(side(Elementary{Kind::sphere, standard, 2}, line(0, 0, 1, 0)),
                     side(Elementary{Kind::torus, standard, 1.5, 0.5}, line(0, 0, 1, 0))) == "G1 curvature");
  BOOST_TEST(verdict(side(Elementary{Kind::sphere, standard, 2}, line(0, 0, 1, 0)),
                     side(Elementary{Kind::torus, standard, 0, 2}, line(0, 0, 1, 0))) == "G2");
  const double low = std::sin(0.3) * 2;
  GC::Cad_conic<2> parallel = circle;
  parallel.a = parallel.b = std::cos(0.3) * 2;
  BOOST_TEST(verdict(side(Elementary{Kind::sphere, standard, 2}, line(0, 0.3, 1, 0)),
                     side(plane(at_height(low)), parallel)) == "gap");
  // a seam, where it is exact, and one that is rounded
  BOOST_TEST(verdict(side(Elementary{Kind::cylinder, standard, 2}, line(0, 0, 0, 1)),
                     side(Elementary{Kind::cylinder, standard, 2}, line(2 * pi, 0, 0, 1))) == "gap");
}

BOOST_AUTO_TEST_CASE(representations_of_one_surface) {
  const GC::Cad_conic<3> base{GC::Cad_conic<3>::Kind::ellipse, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2, 2},
      upright{GC::Cad_conic<3>::Kind::ellipse, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 2, 2};
  const GC::Edge_side cylinder = side(Elementary{Kind::cylinder, standard, 2}, line(0.5, 1, 1, 0.25)),
                      extruded = side(GC::Cad_extrusion{base, {0, 0, 2}}, line(0.5, 0.5, 1, 0.125)),
                      ruled = side(GC::Cad_revolution{GC::Cad_line<3>{{2, 0, 0}, {0, 0, 0.5}}, {0, 0, 0}, {0, 0, 1}},
                                   line(0.5, 2, 1, 0.5)),
                      sphere = side(Elementary{Kind::sphere, standard, 2}, line(0.5, 0.3, 0.75, 0.0625)),
                      rotated = side(GC::Cad_revolution{upright, {0, 0, 0}, {0, 0, 1}}, line(0.5, 0.3, 0.75, 0.0625));
  BOOST_TEST(verdict(cylinder, extruded, 0, 4) == "G2");
  BOOST_TEST(verdict(cylinder, ruled, 0, 4) == "G2");
  BOOST_TEST(verdict(extruded, ruled, 0, 4) == "G2");
  BOOST_TEST(verdict(sphere, rotated, 0, 4) == "G2");
  GC::Cad_conic<3> flat = upright;
  flat.b = next(flat.b);
  BOOST_TEST(verdict(sphere, side(GC::Cad_revolution{flat, {0, 0, 0}, {0, 0, 1}}, line(0.5, 0.3, 0.75, 0.0625))) ==
             "gap");
  // along the equator it is the second derivative that differs
  BOOST_TEST(verdict(side(Elementary{Kind::sphere, standard, 2}, line(0.5, 0, 1, 0)),
                     side(GC::Cad_revolution{flat, {0, 0, 0}, {0, 0, 1}}, line(0.5, 0, 1, 0))) == "G1 curvature");
  BOOST_TEST(verdict(side(Elementary{Kind::sphere, standard, 2}, line(0.5, 0, 1, 0)),
                     side(GC::Cad_revolution{upright, {0, 0, 0}, {0, 0, 1}}, line(0.5, 0, 1, 0))) == "G2");
}

// Any surface continues itself, and not one of whose numbers one is off by one unit in the last
// place.
BOOST_AUTO_TEST_CASE(random_elementary_surfaces) {
  std::mt19937 random(seed() + 3);
  std::uniform_real_distribution<double> unit(0.1, 0.9);
  for (Kind kind : {Kind::plane, Kind::cylinder, Kind::cone, Kind::sphere, Kind::torus})
    for (int round = 0; round < 3; ++round) {
      Elementary s{kind, {}, 2 + unit(random), unit(random)};
      int i = 0;
      for (P3* p : {&s.frame.origin, &s.frame.x_axis, &s.frame.y_axis, &s.frame.z_axis}) {
        for (double& x : *p) x = unit(random) / 8;
        if (i > 0) (*p)[i - 1] += 1;
        ++i;
      }
      GC::Cad_placement placement = cyclic;
      for (auto& row : placement)
        for (double& x : row) x += unit(random) / 8;
      // v < 1.35: not over the poles of spheres
      const double p[] = {unit(random), unit(random), unit(random), round == 0 ? 0 : unit(random) / 2};
      const GC::Cad_line<2> l = line(p[0], p[1], p[2], p[3]);
      const GC::Edge_side a = side(s, l, 0, round == 1, placement);
      BOOST_TEST_CONTEXT("seed " << seed() << ", kind " << int(kind) << ", round " << round) {
        BOOST_TEST(verdict(a, a) == "G2");
        for (int number = 0; number < 3; ++number) {
          Elementary t = s;
          double& x = number == 0 ? t.frame.origin[1] : number == 1 ? t.frame.x_axis[2] : t.radius;
          x = next(x);
          if (kind != Kind::plane || number < 2) BOOST_TEST(verdict(a, side(t, l, 0, round == 1, placement)) == "gap");
        }
        GC::Cad_placement off = placement;
        off[1][2] = next(off[1][2]);
        BOOST_TEST(verdict(a, side(s, l, 0, round == 1, off)) == "gap");
      }
    }
}

BOOST_AUTO_TEST_CASE(random_swept_surfaces) {
  std::mt19937 random(seed() + 8);
  std::uniform_real_distribution<double> unit(0.1, 0.9);
  const auto vector = [&](int axis) {
    P3 p{unit(random) / 8, unit(random) / 8, unit(random) / 8};
    p[axis] += 1;
    return p;
  };
  for (int kind = 0; kind < 4; ++kind) {
    // about or along the axis of z; profiles near the plane of x and z, or that of x and y
    GC::Cad_conic<3> ellipse{GC::Cad_conic<3>::Kind::ellipse, {3, 0, 0},        vector(0),
                             vector(kind < 2 ? 2 : 1),        1 + unit(random), 1};
    GC::Cad_line<3> straight{{3, 0, 0}, vector(kind < 2 ? 2 : 1)};
    const P3 direction = vector(2);
    const auto swept = [&] {
      const GC::Cad_curve<3> profile = kind % 2 ? GC::Cad_curve<3>(straight) : GC::Cad_curve<3>(ellipse);
      return kind < 2 ? GC::Cad_surface(GC::Cad_revolution{profile, {0, 0, 0}, direction})
                      : GC::Cad_surface(GC::Cad_extrusion{profile, direction});
    };
    const double p[] = {unit(random), unit(random), unit(random), unit(random)};
    const GC::Cad_line<2> l = line(p[0], p[1], p[2], p[3]);
    const GC::Edge_side a = side(swept(), l);
    BOOST_TEST_CONTEXT("seed " << seed() << ", kind " << kind) {
      BOOST_TEST(verdict(a, a) == "G2");
      BOOST_TEST(verdict(a, side(swept(), l, 0, true)) == "G0 fold");
      ellipse.y_axis[0] = next(ellipse.y_axis[0]);
      straight.direction[0] = next(straight.direction[0]);
      BOOST_TEST(verdict(a, side(swept(), l)) == "gap");
    }
  }
}

// Polylines that meet at the parameters 0, 1/4, ..., 1: they differ next to one point, or one is a
// part of the other at another speed.
BOOST_AUTO_TEST_CASE(edges_that_meet_at_many_parameters) {
  const auto ruled = [](const std::vector<double>& at, const std::vector<P3>& points,
                        const std::vector<double>& weights) {
    GC::Cad_spline_surface s{1, 1, {0}, {0, 0, 1, 1}, {}, {}};
    s.u_knots.insert(s.u_knots.end(), at.begin(), at.end());
    s.u_knots.push_back(1);
    for (std::size_t i = 0; i < points.size(); ++i)
      for (const double z : {0., 1.}) {
        s.points.push_back({points[i][0], points[i][1], points[i][2] + z});
        if (!weights.empty()) s.weights.push_back(weights[i]);
      }
    return side(s, line(0, 0, 1, 0));
  };
  const std::vector<double> at{0, 0.0625, 0.125, 0.1875, 1};
  const std::vector<P3> straight{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {16, 0, 0}},
      bent{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 0, 0}, {16, 0, 0}};
  BOOST_TEST(verdict(ruled(at, straight, {}), ruled(at, straight, {})) == "G2");
  BOOST_TEST(verdict(ruled(at, straight, {}), ruled(at, bent, {})) == "gap");
  const std::vector<double> weights{1, 1, 1, 1, 2};
  BOOST_TEST(verdict(ruled(at, straight, weights), ruled(at, bent, weights)) == "undecided");
  const P3 p{0, 0, 0}, q[] = {{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}, r{5, 5, 0};
  const std::vector<P3> loops{p, q[0], p, q[1], p, q[2], p, q[3], p};
  std::vector<P3> faster = loops;
  for (const P3& x : {r, p, r, p}) faster.push_back(x);
  std::vector<double> slow{0}, fast{0};
  for (int i = 1; i <= 8; ++i) {
    slow.push_back(i / 8.);
    fast.push_back(i / 16.);
  }
  for (int i = 5; i <= 8; ++i) fast.push_back(i / 8.);
  BOOST_TEST(verdict(ruled(slow, loops, {}), ruled(fast, faster, {})) == "gap");
  BOOST_TEST(verdict(ruled(fast, faster, {}), ruled(slow, loops, {})) == "gap");
}

BOOST_AUTO_TEST_CASE(apices_and_poles) {
  const Elementary cone{Kind::cone, standard, 0, 0.5}, sphere{Kind::sphere, standard, 2};
  BOOST_TEST(verdict(side(cone, line(0, 0, 1, 0)), side(cone, line(0, 0, 1, 0))) == "G0 collapsed");
  BOOST_TEST(verdict(side(cone, line(0, 0, 0, 1)), side(cone, line(0, 0, 0, 1)), -1, 1) == "undecided");
  BOOST_TEST(verdict(side(cone, line(0, 0, 0, 1)), side(cone, line(0, 0, 0, 1)), 0, 1) == "undecided");
  BOOST_TEST(verdict(side(cone, line(0, 0, 0, 1)), side(cone, line(0, 0, 0, 1)), 0.001, 1) == "G2");
  BOOST_TEST(verdict(side(sphere, line(0, 0, 0, 1)), side(sphere, line(0, 0, 0, 1)), 0, 1.6) == "undecided");
  // the same as surfaces of revolution, of which it is not known beforehand where the normal
  // vanishes
  const GC::Cad_conic<3> upright{GC::Cad_conic<3>::Kind::ellipse, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 2, 2};
  const GC::Cad_revolution rotated{upright, {0, 0, 0}, {0, 0, 1}},
      of_line{GC::Cad_line<3>{{0, 0, 0}, {1, 0, 1}}, {0, 0, 0}, {0, 0, 1}};
  const GC::Edge_side meridian = side(rotated, line(0, 0, 0, 1)), ruling = side(of_line, line(0, 0, 0, 1));
  BOOST_TEST(verdict(meridian, meridian, 0, 1.5) == "G2");
  BOOST_TEST(verdict(meridian, meridian, 0, 1.6) == "undecided");
  for (const auto& [first, second] :
       {std::pair{meridian, side(sphere, line(0, 0, 0, 1))}, std::pair{side(sphere, line(0, 0, 0, 1)), meridian}})
    BOOST_TEST((verdict(first, second, 0, 1.5) == "G2" && verdict(first, second, 0, 1.6) == "undecided"));
  BOOST_TEST(verdict(ruling, ruling, 0.25, 1) == "G2");
  BOOST_TEST(verdict(ruling, ruling, 0, 1) == "undecided");
}

// Reversed faces, mirrors and faces on either side mean the same as to enclosures.
BOOST_AUTO_TEST_CASE(orientations_are_those_of_enclosures) {
  std::mt19937 random(seed() + 4);
  const GC::Cad_spline_surface s = random_surface(random, {}), t = continuation(s),
                               whole = random_surface(random, {0.5});
  GC::Cad_placement both = cyclic; // a mirror
  both[0][1] = -2;
  int folds = 0, smooth = 0;
  for (int flags = 0; flags < 32; ++flags) {
    const bool turn = flags & 1;
    const GC::Cad_placement& placement = flags & 2 ? both : cyclic;
    for (bool inside : {false, true}) {
      const int left = flags & 16 ? -1 : 1;
      const GC::Edge_side a = side(inside ? whole : s, line(0, inside ? 0.5 : 1, 1, 0), inside ? left : -1, flags & 4,
                                   placement),
                          b = inside
                                  ? side(turn ? turned(whole) : whole, turn ? line(1, 0.5, -1, 0) : line(0, 0.5, 1, 0),
                                         turn ? left : -left, flags & 8, placement)
                                  : side(turn ? turned(t) : t, turn ? line(1, 0, -1, 0) : line(0, 0, 1, 0),
                                         turn ? -1 : 1, flags & 8, placement);
      const GC::Edge_enclosure e = GC::edge_enclosure(a, b, 0, 1);
      const std::string v = verdict(a, b);
      BOOST_TEST((v == "G2" || v == "G0 fold"));
      BOOST_TEST((e.angle->value.upper < 1e-6) == (v == "G2"));
      BOOST_TEST((e.angle->value.lower > 3) == (v == "G0 fold"));
      ++(v == "G2" ? smooth : folds);
    }
    // a half of a shape that is mirrored to the other half
    GC::Edge_side c = flags & 1 ? ground : fillet, d = flags & 2 ? ground : fillet;
    c.reversed = c.reversed != bool(flags & 4);
    d.reversed = d.reversed != bool(flags & 8);
    if (flags & 16) d.placement = mirrored;
    const GC::Edge_enclosure e = GC::edge_enclosure(c, d, -1, 5);
    const std::string v = verdict(c, d, -1, 5);
    BOOST_TEST((e.angle->value.upper < 1e-6) == (v == "G2" || v == "G1 curvature"));
    BOOST_TEST((e.angle->value.lower > 3) == (v == "G0 fold"));
    if (v != "G0 fold") BOOST_TEST((e.curvature_jump->value.upper < 0.5) == (v == "G2"));
    ++(v == "G0 fold" ? folds : smooth);
  }
  BOOST_TEST(folds == smooth);
}

BOOST_AUTO_TEST_CASE(what_is_not_decided) {
  std::mt19937 random(seed() + 5);
  const GC::Edge_side spline = side(random_surface(random, {}), line(0, 0, 1, 0));
  BOOST_TEST(verdict(ground, spline) == "undecided");
  BOOST_TEST(verdict(ground, fillet, 1, 1) == "undecided");
  // beside the surface
  BOOST_TEST(verdict(spline, side(random_surface(random, {}), line(0, 2, 1, 0))) == "undecided");
  const GC::Edge_side point = side(random_surface(random, {}), line(0.25, 0.5, 0, 0));
  BOOST_TEST(verdict(point, point) == "undecided");
  // profiles and curves of other kinds, and a surface without a normal
  const GC::Cad_conic<3> parabola{GC::Cad_conic<3>::Kind::parabola, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}, 1, 0};
  const GC::Cad_conic<2> flat_parabola{GC::Cad_conic<2>::Kind::parabola, {0, 0}, {0, 1}, {1, 0}, 1, 0};
  const GC::Cad_spline_curve<2> bent{2, {0, 0, 0, 1, 1, 1}, {{0, 0}, {0.5, 1}, {1, 0}}, {}};
  const GC::Edge_side others[] = {
      side(GC::Cad_extrusion{parabola, {0, 0, 1}}, line(0, 0, 1, 0)),
      side(GC::Cad_revolution{parabola, {0, 5, 0}, {1, 0, 0}}, line(0, 0, 1, 0)),
      side(GC::Cad_extrusion{GC::Cad_spline_curve<3>{1, {0, 0, 1, 1}, {{0, 0, 0}, {1, 0, 0}}, {}}, {0, 0, 1}},
           line(0, 0, 1, 0)),
      side(plane(), flat_parabola),
      side(plane(), bent),
      side(plane(),
           // straight, in another parameter
           GC::Cad_spline_curve<2>{1, {0, 0, 1, 1}, {{0, 0}, {1, 0}}, {1, 2}}),
      side(Elementary{Kind::cylinder, standard, 1}, bent),
      side(Elementary{Kind::cylinder, standard, 1}, flat_parabola)};
  for (const GC::Edge_side& s : others) BOOST_TEST(verdict(s, s) == "undecided");
  const GC::Edge_side flat = side(plane(), line(0, 0, 1, 0)),
                      folded =
                          side(GC::Cad_extrusion{GC::Cad_line<3>{{0, 0, 0}, {1, 0, 0}}, {1, 0, 0}}, line(0, 0, 1, 0));
  BOOST_TEST((verdict(flat, folded) == "undecided" && verdict(folded, flat) == "undecided"));
  BOOST_TEST(!limited(GC::Work_limit(1), [&] { return GC::edge_continuity(spline, spline, 0, 1); }));
  GC::Edge_side bad = ground;
  bad.placement[0][0] = std::numeric_limits<double>::quiet_NaN();
  CHECK_ERROR(GC::edge_continuity(bad, fillet, 0, 1), not_finite);
  bad.placement[0][0] = 0;
  CHECK_ERROR(GC::edge_continuity(bad, fillet, 0, 1), singular_frame);
  CHECK_ERROR(GC::edge_continuity(ground, fillet, 0, std::numeric_limits<double>::infinity()), not_finite);
  CHECK_ERROR(GC::edge_continuity(ground, fillet, 1, 0), empty_domain);
  GC::Cad_spline_surface s = random_surface(random, {});
  s.points.pop_back();
  CHECK_ERROR(GC::edge_continuity(side(s, line(0, 0, 1, 0)), spline, 0, 1), wrong_number_of_points);
}
