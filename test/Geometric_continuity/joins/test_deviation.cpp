// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The certified deviation of joins: the enclosures contain the exact value, are at most four units
// in the last place wide on well-scaled numbers, and lead to honest verdicts.

#include "support/enclosures.h"

#include <CGAL/Geometric_continuity.h>

BOOST_AUTO_TEST_SUITE(deviation)

typedef CGAL::Exact_rational Exact;
typedef GC::Traits_2<CGAL::Epick> Plane;
typedef GC::Traits_3<CGAL::Epick> Space;
typedef GC::Bezier_curve<Plane> Plane_curve;
typedef GC::Bezier_curve<Space> Space_curve;
using enclosures::angle_is;
using enclosures::encloses_root;
using enclosures::ulps;
using GC::Verdict;

template <class Jet> void check_angle(const GC::Enclosure& e, const Jet& x, const Jet& y) {
  const Exact product = dot(x[1], y[1]), lengths = dot(x[1], x[1]) * dot(y[1], y[1]);
  BOOST_CHECK(angle_is(true, e.lower, product, lengths));
  BOOST_CHECK(angle_is(false, e.upper, product, lengths));
}

Space_curve cubic(const std::vector<double>& c) {
  std::vector<Space::Point> points;
  for (int i = 0; i + 2 < static_cast<int>(c.size()); i += 3) points.emplace_back(c[i], c[i + 1], c[i + 2]);
  return Space_curve(points.begin(), points.end());
}

BOOST_AUTO_TEST_CASE(random_joins) {
  std::mt19937_64 random = seeded<std::mt19937_64>(2026);
  const auto number = [&](double scale) { return std::ldexp(double(random() >> 11), -52) * scale - scale; };
  for (int i = 0; i < 300; ++i) {
    const double scale = i % 3 == 0 ? 1e-3 : i % 3 == 1 ? 1 : 1e5, bend = std::ldexp(1.0, -(i % 40));
    std::vector<double> a, b;
    for (int k = 0; k < 12; ++k) a.push_back(number(scale));
    for (int k = 0; k < 12; ++k) b.push_back(number(scale));
    for (int k = 0; k < 3 && i % 2 == 0; ++k) { // a tangent that is turned little, or almost back
      b[k] = a[9 + k];
      b[3 + k] = b[k] + (i % 4 == 0 ? 1 : -1) * (a[9 + k] - a[6 + k]) + bend * number(scale);
    }
    const Space_curve left = cubic(a), right = cubic(b);
    const auto x = left.end_jet_over<Exact>(3), y = right.start_jet_over<Exact>(3);
    const GC::Join_deviation d = GC::deviation(left, right);

    const auto gap = y[0] - x[0];
    BOOST_CHECK(encloses_root(d.gap, dot(gap, gap)));
    BOOST_CHECK_LE(ulps(d.gap), 4);
    BOOST_REQUIRE(d.tangent_angle && d.curvature_jump && d.torsion_jump);
    check_angle(*d.tangent_angle, x, y);
    BOOST_CHECK_LE(ulps(*d.tangent_angle), 4);

    typedef GC::Coordinate_vector<Exact, 3> Vector;
    const auto cross = [](const Vector& v, const Vector& w) {
      Vector r(3);
      for (int k = 0; k < 3; ++k) r[k] = v[(k + 1) % 3] * w[(k + 2) % 3] - v[(k + 2) % 3] * w[(k + 1) % 3];
      return r;
    };
    const auto curvature = [&](const auto& jet) { // (x' x x'') x x' / |x'|^4
      const Exact g = dot(jet[1], jet[1]);
      return Vector(cross(cross(jet[1], jet[2]), jet[1]) / Exact(g * g));
    };
    const Vector kx = curvature(x), ky = curvature(y), jump = ky - kx;
    const Exact largest = std::max(Exact(dot(kx, kx)), Exact(dot(ky, ky)));
    BOOST_CHECK(encloses_root(*d.curvature_jump, Exact(dot(jump, jump) / largest)));
    BOOST_CHECK_LE(ulps(*d.curvature_jump), 4);

    const auto torsion = [&](const auto& jet) {
      const Vector n = cross(jet[1], jet[2]);
      return Exact(dot(n, jet[3]) / dot(n, n));
    };
    const Exact difference = abs(Exact(torsion(y) - torsion(x)));
    BOOST_CHECK(Exact(d.torsion_jump->lower) <= difference && difference <= Exact(d.torsion_jump->upper));
    BOOST_CHECK_LE(ulps(*d.torsion_jump), 4);
  }
}

BOOST_AUTO_TEST_CASE(special_angles) {
  const double pi_below = 3.141592653589793; // the double below pi
  const auto angle = [](double x, double y) {
    const Plane_curve left{Plane::Point(-1, 0), Plane::Point(0, 0)}, right{Plane::Point(0, 0), Plane::Point(x, y)};
    return *GC::deviation(left, right).tangent_angle;
  };
  BOOST_CHECK_EQUAL(angle(1, 0), (GC::Enclosure{0, 0}));
  BOOST_CHECK_EQUAL(angle(1e-300, 0), (GC::Enclosure{0, 0}));
  for (double y : {1.0, -1.0}) {
    const GC::Enclosure right = angle(0, y), acute = angle(1, y), obtuse = angle(-1, y);
    BOOST_CHECK(right.lower == pi_below / 2 && right.upper == std::nextafter(pi_below / 2, 2));
    BOOST_CHECK(acute.lower == pi_below / 4 && acute.upper == std::nextafter(pi_below / 4, 2));
    BOOST_CHECK(obtuse.lower <= 2.356194490192345 && 2.356194490192345 <= obtuse.upper && ulps(obtuse) <= 2);
  }
  const GC::Enclosure back = angle(-2, 0);
  BOOST_CHECK(back.lower == pi_below && back.upper == std::nextafter(pi_below, 4));
  const GC::Enclosure tiny = angle(1, 1e-140); // arctan(y) < y, and y - y^3/3 is nearly y
  BOOST_CHECK(tiny.lower < 1e-140 && tiny.lower >= 1e-140 * (1 - 0x1p-51) && tiny.upper <= 1e-140 * (1 + 0x1p-51));
}

BOOST_AUTO_TEST_CASE(undefined_quantities) {
  const Space_curve line{Space::Point(0, 0, 0), Space::Point(1, 0, 0)},
      next{Space::Point(1, 0, 0), Space::Point(3, 0, 0)};
  GC::Join_deviation d = GC::deviation(line, next);
  BOOST_CHECK(d.gap == (GC::Enclosure{0, 0}) && *d.tangent_angle == (GC::Enclosure{0, 0}));
  BOOST_CHECK(*d.curvature_jump == (GC::Enclosure{0, 0}) && !d.torsion_jump);

  const Space_curve bent{Space::Point(1, 0, 0), Space::Point(2, 0, 0), Space::Point(3, 1, 0), Space::Point(4, 1, 1)};
  d = GC::deviation(line, bent);
  BOOST_CHECK(*d.curvature_jump == (GC::Enclosure{1, 1}) && !d.torsion_jump);

  const Space_curve cusp{Space::Point(1, 0, 0), Space::Point(1, 0, 0), Space::Point(3, 0, 0)};
  d = GC::deviation(line, cusp);
  BOOST_CHECK(!d.tangent_angle && !d.curvature_jump && !d.torsion_jump && d.gap == (GC::Enclosure{0, 0}));

  const auto told = [](const Space_curve& left, const Space_curve& right) { return text(GC::deviation(left, right)); };
  BOOST_CHECK_EQUAL(told(cusp.reverse(), next), "gap 0");
  BOOST_CHECK_EQUAL(told(line, bent), "gap 0, tangent angle 0 degrees, curvature jump 100%");
  BOOST_CHECK_EQUAL(told(bent.reverse(), next), "gap 0, tangent angle [179.999, 180] degrees, curvature jump 100%");
  BOOST_CHECK_EQUAL(told(bent.reverse(), bent),
                    "gap 0, tangent angle [179.999, 180] degrees, curvature jump 0%, torsion jump 0");

  const Plane_curve plane{Plane::Point(0, 0), Plane::Point(1, 0)};
  typedef GC::Traits_3<CGAL::Simple_cartesian<Exact>> Rational;
  const GC::Bezier_curve<Rational> rational{Rational::Point(0, 0, 0), Rational::Point(Exact(1) / 3, 0, 0)};
  BOOST_CHECK(GC::deviation(rational, rational).gap.lower < 1.0 / 3 + 1e-16);
  BOOST_CHECK_LE(ulps(GC::deviation(rational, rational).gap), 2);
}

BOOST_AUTO_TEST_CASE(verdicts) {
  // kinks of exactly arctan(1/8), curvature from 0 to something
  const Space_curve line{Space::Point(0, 0, 0), Space::Point(8, 0, 0)},
      kink{Space::Point(8, 0, 0), Space::Point(16, 1, 0), Space::Point(24, 2, 0)};
  const double angle = std::atan(0.125);
  const auto order = [&](const GC::Join_tolerance& t) { return GC::order_within(line, kink, t); };
  BOOST_CHECK_EQUAL(order({angle * 1.001}).proved_order(), 2); // both are straight
  BOOST_CHECK_EQUAL(order({angle * 1.001})(3), Verdict::undecided);
  BOOST_CHECK_EQUAL(order({angle * 0.999})(1), Verdict::refuted);
  BOOST_CHECK_EQUAL(order({angle * 0.999})(2), Verdict::refuted);
  BOOST_CHECK_EQUAL(order({angle * 0.999}).proved_order(), 0);
  std::ostringstream text;
  text << order({angle * 0.999});
  BOOST_CHECK_EQUAL(text.str().substr(0, 58), "order 0 proved, 1 refuted, 2 refuted, 3 refuted; gap 0, ta");
  const GC::Enclosure e = *GC::deviation(line, kink).tangent_angle;
  BOOST_REQUIRE(e.lower < e.upper);
  BOOST_CHECK_EQUAL(order({e.lower})(1), Verdict::undecided);
  BOOST_CHECK_EQUAL(order({e.upper})(1), Verdict::proved);
  BOOST_CHECK_EQUAL(order({std::nextafter(e.lower, 0)})(1), Verdict::refuted);
  // a bound that is itself only enclosed: its lower end proves, its upper end refutes
  const double above = std::nextafter(e.upper, 4), below = std::nextafter(e.lower, 0);
  BOOST_CHECK_EQUAL(order({GC::Enclosure{e.upper, above}})(1), Verdict::proved);
  BOOST_CHECK_EQUAL(order({GC::Enclosure{e.lower, above}})(1), Verdict::undecided);
  BOOST_CHECK_EQUAL(order({GC::Enclosure{below, e.lower}})(1), Verdict::undecided);
  BOOST_CHECK_EQUAL(order({GC::Enclosure{0, below}})(1), Verdict::refuted);

  // what holds exactly is proved with the tolerance 0, also the torsion of straight lines
  const Space_curve next{Space::Point(8, 0, 0), Space::Point(9, 0, 0)};
  BOOST_CHECK_EQUAL(GC::order_within(line, next, {}).proved_order(), 3);
  // a gap refutes everything, unless it is tolerated
  const Space_curve away{Space::Point(8, 0, 0.5), Space::Point(9, 0, 0.5)};
  for (int k = 0; k <= 3; ++k) BOOST_CHECK_EQUAL(GC::order_within(line, away, {1, 1, 1})(k), Verdict::refuted);
  BOOST_CHECK_EQUAL(GC::order_within(line, away, {1, 1, 1}).proved_order(), -1);
  BOOST_CHECK_EQUAL(GC::order_within(line, away, {0, 0, 0, 0.5}).proved_order(), 2);
  // one number is the tolerance for all
  for (const auto* right : {&kink, &away})
    for (double t : {0., 0.125, 0.5, 4.})
      BOOST_CHECK(GC::order_within(line, *right, t).verdicts ==
                  GC::order_within(line, *right, {t, t, t, t, t}).verdicts);
  BOOST_CHECK_EQUAL(GC::order_within(line, away, 1).proved_order(), 2);
  // no tangent, no order 1
  const Space_curve cusp{Space::Point(8, 0, 0), Space::Point(8, 0, 0), Space::Point(9, 0, 0)};
  BOOST_CHECK_EQUAL(GC::order_within(line, cusp, {4, 4, 4})(1), Verdict::refuted);

  for (const GC::Join_tolerance& bad :
       {GC::Join_tolerance{-1, 0, 0, 0}, GC::Join_tolerance{0, -1, 0, 0},
        GC::Join_tolerance{0, 0, std::numeric_limits<double>::quiet_NaN(), 0}, GC::Join_tolerance{0, 0, 0, -1},
        GC::Join_tolerance{GC::Enclosure{2, 1}}, GC::Join_tolerance{GC::Enclosure{-1, 1}}})
    CHECK_ERROR(order(bad), unreachable_tolerance);
  BOOST_CHECK_EQUAL(Verdict::proved && Verdict::undecided, Verdict::undecided);
  BOOST_CHECK_EQUAL(Verdict::undecided && Verdict::refuted, Verdict::refuted);
}

// There the derivatives of the curvature with respect to arc length are compared.
BOOST_AUTO_TEST_CASE(order_3_in_the_plane) {
  const auto within = [](const Plane_curve& left, const Plane_curve& right, double tolerance) {
    return GC::order_within(left, right, {0, 0, 0, 0, tolerance});
  };
  // the parabola 6 (t, t^2), continued with beta = (1, 2, 0)
  const Plane_curve parabola{Plane::Point(-6, 6), Plane::Point(-3, 0), Plane::Point(0, 0)},
      next{Plane::Point(0, 0), Plane::Point(2, 0), Plane::Point(6, 2), Plane::Point(12, 18)};
  BOOST_CHECK_EQUAL(GC::continuity(parabola, next).g_order, 3);
  BOOST_CHECK_EQUAL(GC::continuity(parabola, next).f_order, 2);
  for (const double tolerance : {0., 1e-300, 1., 1e300})
    BOOST_CHECK_EQUAL(within(parabola, next, tolerance).proved_order(), 3);
  // another third derivative: the jump is 1/72
  const Plane_curve off{Plane::Point(0, 0), Plane::Point(2, 0), Plane::Point(6, 2), Plane::Point(12, 18.5)};
  BOOST_CHECK_EQUAL(within(parabola, off, 0)(3), Verdict::refuted);
  BOOST_CHECK_EQUAL(within(parabola, off, 0).proved_order(), 2);
  BOOST_CHECK_EQUAL(within(parabola, off, 0.01388)(3), Verdict::refuted);
  BOOST_CHECK_EQUAL(within(parabola, off, 0.01389)(3), Verdict::proved);
  // the curve (3 t, 9 t^3) has the derivative 2 at 0
  const Plane_curve line{Plane::Point(-1, 0), Plane::Point(0, 0)},
      cubic{Plane::Point(0, 0), Plane::Point(1, 0), Plane::Point(2, 0), Plane::Point(3, 9)};
  BOOST_CHECK_EQUAL(within(line, cubic, 2)(3), Verdict::proved);
  BOOST_CHECK_EQUAL(within(line, cubic, std::nextafter(2, 0))(3), Verdict::refuted);
  // from the other side it falls by 2
  BOOST_CHECK_EQUAL(within(cubic.reverse(), line.reverse(), 2)(3), Verdict::proved);
  BOOST_CHECK_EQUAL(within(cubic.reverse(), line.reverse(), std::nextafter(2, 0))(3), Verdict::refuted);
  // what lower orders refute stays refuted
  const Plane_curve kink{Plane::Point(0, 0), Plane::Point(1, 1)};
  BOOST_CHECK_EQUAL(within(line, kink, 1)(3), Verdict::refuted);
  // without a tangent there is no such derivative
  const Plane_curve cusp{Plane::Point(0, 0), Plane::Point(0, 0), Plane::Point(1, 0)};
  const GC::Order_within none = GC::order_within(line, cusp, {4, 4, 4, 4, 4});
  BOOST_CHECK(none(1) == Verdict::refuted && none(3) == Verdict::refuted && none.proved_order() == 0);
  BOOST_CHECK(!none.deviation.tangent_angle && !none.deviation.curvature_jump);
  CHECK_ERROR(within(line, cubic, -1), unreachable_tolerance);
  CHECK_ERROR(within(line, cubic, 0)(-1), negative_count);
}

// Rounding a blend breaks its joins by about one unit in the last place, and that is what is
// proved.
BOOST_AUTO_TEST_CASE(rounded_blend) {
  const Space_curve left{Space::Point(0, 0, 0), Space::Point(1, 0.3, 0.1), Space::Point(2, 0.7, -0.4),
                         Space::Point(3, 1.1, 0.3)},
      right{Space::Point(7, 2, 1), Space::Point(8, 1.7, 0.9), Space::Point(9, 0.1, 0.3), Space::Point(10, 0, 0.2)};
  const auto blend = GC::blend(left, right);
  BOOST_CHECK_LT(GC::continuity(left, blend).g_order, 2);
  const GC::Order_within within = GC::order_within(left, blend, {1e-14, 1e-13, 1e-13});
  BOOST_CHECK_EQUAL(within(2), Verdict::proved);
  BOOST_CHECK_EQUAL(GC::order_within(left, blend, {1e-14, 1e-20, 0})(2), Verdict::refuted);
}

BOOST_AUTO_TEST_SUITE_END()
