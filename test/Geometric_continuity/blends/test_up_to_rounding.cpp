// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// These tests check the words about joins of rounded numbers that miss an order by no more than
// rounding.

#include "support/test.h"

#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>

BOOST_AUTO_TEST_SUITE(up_to_rounding)

typedef GC::Traits_2<CGAL::Epick> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits> Curve;

// Not one of a hundred rounded blends has exact joins at both ends, and all of them are G2 but for
// some units.
BOOST_AUTO_TEST_CASE(blends) {
  std::mt19937 generator(2026);
  std::uniform_real_distribution<double> number(-1, 1);
  int missed = 0;
  for (int repetition = 0; repetition < 100; ++repetition) {
    const auto point = [&](double x) { return Point{x + number(generator), 3 * number(generator)}; };
    const Curve phi{point(0), point(2), point(4)}, psi{point(9), point(11), point(13)};
    for (const auto& join : {continuity(phi, blend(phi, psi)), continuity(blend(phi, psi, GC::Fair()), psi)}) {
      if (join.g_order >= 2) continue;
      ++missed;
      BOOST_REQUIRE(join.up_to_rounding());
      BOOST_CHECK_EQUAL(join.up_to_rounding()->g_order, 2);
      BOOST_CHECK(0 < join.up_to_rounding()->units && join.up_to_rounding()->units < 8);
    }
  }
  BOOST_CHECK_GT(missed, 150);
}

BOOST_AUTO_TEST_CASE(how_far) {
  const double ulp = std::ldexp(1, -52); // of the largest coordinate, 1
  const Curve left{Point(-1, 0), Point(-0.5, 0), Point(0, 0)};
  const auto join = [&](double x, double y, double bend) {
    return continuity(left, Curve{Point(x, 0), Point(0.5, y), Point(1, bend)});
  };
  BOOST_CHECK(!join(0, 0, 0).up_to_rounding());
  BOOST_CHECK(
      // G1, as was asked
      !continuity(left, Curve{Point(0, 0), Point(0.5, 0), Point(1, 1)}, 1).up_to_rounding());
  // has no tangent
  const Curve point{Point(ulp, 0), Point(ulp, 0)};
  BOOST_CHECK_EQUAL(continuity(left, point).up_to_rounding()->g_order, 0);
  BOOST_CHECK_EQUAL(continuity(point, left.reverse()).up_to_rounding()->g_order, 0);
  // a corner
  BOOST_CHECK_EQUAL(continuity(left, Curve{Point(ulp, 0), Point(0, 1)}).up_to_rounding()->g_order, 0);
  typedef GC::Rational_bezier_curve<Traits> Rational;
  const Rational line(std::vector<Point>{Point(0, 3 * ulp), Point(1, 0)}, std::vector<double>{1, 2});
  BOOST_CHECK_EQUAL(continuity(Rational(left), line).up_to_rounding()->g_order, 2);
  BOOST_CHECK_EQUAL(text(join(0, 3 * ulp, 0)),
                    // the second leg turns twice as far
                    "C0 G0 F0; G2 but for 6 units in the last place");
  BOOST_CHECK_EQUAL(text(join(3 * ulp, 0, 0)), "gap; G2 but for 3 units in the last place");
  BOOST_CHECK_EQUAL(text(join(0, 0, 5 * ulp)), "C1 G1 F1, beta = (1); G2 but for 5 units in the last place");
  BOOST_CHECK_EQUAL(join(0, 12 * ulp, 0).up_to_rounding()->g_order, 1);
  BOOST_CHECK(!join(0, 17 * ulp, 0).up_to_rounding() && !join(17 * ulp, 0, 0).up_to_rounding());
  BOOST_CHECK(!join(0, 0, 17 * ulp).up_to_rounding() && !join(0, 0, 1).up_to_rounding());
  // it turns back
  BOOST_CHECK(!continuity(left, Curve{Point(0, 0), Point(-0.5, ulp), Point(-1, 0)}).up_to_rounding());
  // no tangent
  BOOST_CHECK(!continuity(left, Curve{Point(0, 0), Point(0, 0), Point(1, 0)}).up_to_rounding());
  BOOST_CHECK_EQUAL(continuity(left, Curve{Point(0, 0), Point(0.5, ulp), Point(1, 0)}, 1).up_to_rounding()->g_order, 1);
  BOOST_CHECK(!continuity(left, Curve{Point(0, 0), Point(0.5, ulp), Point(1, 0)}, 0).up_to_rounding());
  BOOST_CHECK(!continuity(left, Curve{Point(0, 0), Point(0, 0)}).up_to_rounding());
}

// The words depend neither on the unit of length nor on a common factor of the weights, however
// large or small they are.
BOOST_AUTO_TEST_CASE(powers_of_two) {
  typedef GC::Rational_bezier_curve<Traits> Rational;
  const double ulp = std::ldexp(1, -52);
  for (const int exponent : {-1020, -521, -520, 0, 512, 1000, 1022}) {
    const auto point = [exponent](double x, double y) {
      return Point(std::ldexp(x, exponent), std::ldexp(y, exponent));
    };
    const Curve left{point(-1, 0), point(-0.5, 0), point(0, 0)};
    const auto join = [&](double y, double bend) {
      return continuity(left, Curve{point(0, 0), point(0.5, y), point(1, bend)});
    };
    BOOST_CHECK(!join(0.5, 0).up_to_rounding()); // a corner of 45 degrees
    BOOST_CHECK(!join(0, 1).up_to_rounding());   // a jump of the curvature
    BOOST_CHECK_EQUAL(text(join(3 * ulp, 0)), "C0 G0 F0; G2 but for 6 units in the last place");
    // at right angles, with short legs
    const Curve far{point(0, 0), point(0, std::ldexp(1, -30)), point(0, 1)};
    BOOST_CHECK(!continuity(Curve{point(-1, 0), point(-std::ldexp(1, -30), 0), point(0, 0)}, far).up_to_rounding());
  }
  for (const double w : {1e-160, 1e-300, 1., 1e160, 1e300}) {
    const auto curve = [w](const std::vector<Point>& p, double middle) {
      const std::vector<double> weights{w, middle * w, 2 * w};
      return Rational(p.begin(), p.end(), weights.begin(), weights.end());
    };
    const Rational left = curve({Point(1, 0), Point(1, 1), Point(0, 1)}, 1);
    const auto join = [&](double y, double middle) {
      return continuity(left.reverse(), curve({Point(1, 0), Point(1 + y, -1), Point(0, -1)}, middle));
    };
    BOOST_CHECK(!join(1, 1).up_to_rounding()); // a corner of 45 degrees
    BOOST_CHECK_EQUAL(join(ulp, 1).up_to_rounding()->g_order, 2);
    BOOST_CHECK_EQUAL(join(ulp, 2).up_to_rounding()->g_order, 1); // another curvature
  }
}

// The examples of the manual: decimals on a line, and a blend by a kernel that rounds it.
BOOST_AUTO_TEST_CASE(examples_of_the_manual) {
  const auto segments = [](const Point& p, const Point& q) {
    return text(continuity(Curve{Point(0, 0), p}, Curve{p, q}));
  };
  BOOST_CHECK_EQUAL(segments(Point(0.1, 0.3), Point(0.3, 0.9)), "C0 G0 F0; G1 but for 0.2 units in the last place");
  BOOST_CHECK_EQUAL(segments(Point(0.1, 0.5), Point(0.5, 2.5)), "C0 G0 F0; G1 but for 0.1 units in the last place");
  typedef GC::Traits_3<CGAL::Epick> Space;
  const GC::Bezier_curve<Space> phi{{0, 0, 0}, {1, 2, 0}, {3, 2, 1}, {4, 0, 1}},
      psi{{7, 1, 0}, {8, 2, 2}, {9, 1, 1}, {11, 0, 3}};
  BOOST_CHECK_EQUAL(text(continuity(blend(phi, psi, GC::Fair()), psi)),
                    "C0 G0 F0; G2 but for 0.4 units in the last place");
}

// In space and with weights: two arcs of a circle, one point moved.
BOOST_AUTO_TEST_CASE(rational_curves) {
  typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Space;
  typedef Space::Point Point_3;
  typedef GC::Rational_bezier_curve<Space> Rational;
  const std::vector<double> weights = {1, 1, 2}, back = {2, 1, 1};
  const auto arc = [](const std::vector<Point_3>& p, const std::vector<double>& w) {
    return Rational(p.begin(), p.end(), w.begin(), w.end());
  };
  const Rational left = arc({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, weights);
  const double z = std::ldexp(1, -52);
  const auto join = continuity(left, arc({{0, 1, 0}, {-1, 1, z}, {-1, 0, 0}}, back));
  BOOST_CHECK_EQUAL(join.g_order, 0);
  BOOST_REQUIRE(join.up_to_rounding());
  BOOST_CHECK_EQUAL(join.up_to_rounding()->g_order, 2);
  // another circle
  const auto other = continuity(left, arc({{0, 1, 0}, {-1, 1, z}, {-1, 0.5, 0}}, back));
  BOOST_CHECK_EQUAL(other.up_to_rounding()->g_order, 1);
}

// A circle that has derivatives only.
struct Circle {
  typedef GC::Traits_2<CGAL::Epick> Traits;
  std::pair<double, double> domain() const { return {0, 1}; }
  GC::Curve_jet<Traits> jet(double t, int order) const {
    GC::Curve_jet<Traits> x(2, order);
    for (int k = 0; k <= order; ++k) {
      const double angle = t + k * std::acos(0.);
      x[k][0] = std::cos(angle), x[k][1] = std::sin(angle);
    }
    return x;
  }
};

BOOST_AUTO_TEST_CASE(curves_without_control_points) {
  const Curve line{Point(-1, 3), Point(-3, 3)};
  const auto join = continuity(Circle(), blend(Circle(), line));
  BOOST_CHECK_LT(join.g_order, 2);
  BOOST_REQUIRE(join.up_to_rounding());
  BOOST_CHECK_EQUAL(join.up_to_rounding()->g_order, 2);
  BOOST_CHECK(!continuity(Circle(), line).up_to_rounding());
}

BOOST_AUTO_TEST_SUITE_END()
