// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Counts, domains and numbers that curves refuse, and what large degrees and large coordinates do
// not disturb.

#include "support/test.h"

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Cubic_blended_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/curves/bezier_properties.h>
#include <CGAL/Geometric_continuity/curves/interpolate.h>
#include <CGAL/Geometric_continuity/curves/polyline.h>
#include <CGAL/Interval_nt.h>

BOOST_AUTO_TEST_SUITE(refused_curves)

typedef GC::Bezier_curve<Double_3> Curve;
typedef GC::Bezier_curve<Double_3, 3> Cubic;
typedef Double_3::Point Point;

namespace {

const double undefined = std::numeric_limits<double>::quiet_NaN();
const std::array<Point, 4> points{Point(0, 0, 0), Point(1, 2, 0), Point(3, 1, 1), Point(4, 0, 5)};

} // namespace

BOOST_AUTO_TEST_CASE(negative_counts) {
  const Curve c(points.begin(), points.end());
  const Cubic f(c);
  const GC::Composite_bezier_curve<Double_3> composite(points.begin(), points.end(), {0, 1});
  const GC::Bspline_curve<Double_3> spline(c);
  const GC::Cubic_blended_curve<Double_3, GC::Bezier_basis> blended(f);
  std::vector<Point> out;
  std::vector<GC::Curve_piece_box<Double_3, int>> boxes;
  for (int n : {-1, -2, -4, -5, std::numeric_limits<int>::min()}) {
    CHECK_ERROR(c.elevate(n), negative_count);
    CHECK_ERROR(f.elevate(n), negative_count);
    CHECK_ERROR(spline.elevate(n), negative_count);
    CHECK_ERROR(spline.insert(0.5, n), negative_count);
    CHECK_ERROR(spline.remove(0.5, n), negative_count);
    CHECK_ERROR(c.energy(n), negative_count);
    CHECK_ERROR(f.energy(n), negative_count);
    CHECK_ERROR(c.jet(0.5, n), negative_count);
    CHECK_ERROR(f.jet(0.5, n), negative_count);
    CHECK_ERROR(composite.jet(0.5, n), negative_count);
    CHECK_ERROR(composite.left_jet(0.5, n), negative_count);
    CHECK_ERROR(spline.jet(0.5, n), negative_count);
    CHECK_ERROR(blended.jet(0.5, n), negative_count);
    CHECK_ERROR(c.start_jet(n), negative_count);
    CHECK_ERROR(f.end_jet(n), negative_count);
    CHECK_ERROR(spline.start_jet(n), negative_count);
    CHECK_ERROR(composite.end_jet_over<Q>(n), negative_count);
    CHECK_ERROR(spline.end_jet_over<Q>(n), negative_count);
    CHECK_ERROR(blended.start_jet_over<Q>(n), negative_count);
    CHECK_ERROR(GC::repeat_control_point(c, 1, n), negative_count);
    CHECK_ERROR(GC::uniform_polyline(c, n, std::back_inserter(out)), negative_count);
    CHECK_ERROR(GC::bounding_boxes(c, n, 0, std::back_inserter(boxes)), negative_count);
  }
  BOOST_CHECK(out.empty() && boxes.empty());
  BOOST_CHECK(c.elevate(0) == c);
}

// [-1.7e308, 1.7e308] is a domain of finite numbers, but its length is not.
BOOST_AUTO_TEST_CASE(domains_of_infinite_length) {
  const double a = -1.7e308, b = 1.7e308;
  const Curve c(points.begin(), points.end());
  const Cubic f(c);
  typedef GC::Composite_bezier_curve<Double_3> Composite;
  CHECK_ERROR(Curve(points.begin(), points.end(), a, b), not_finite);
  CHECK_ERROR(Cubic(points.begin(), points.end(), a, b), not_finite);
  const std::array<Epick_3::Point, 2> epick_points{Epick_3::Point(0, 0, 0), Epick_3::Point(1, 2, 0)};
  CHECK_ERROR(GC::Bezier_curve<Epick_3>(epick_points.begin(), epick_points.end(), a, b), not_finite);
  CHECK_ERROR(c.with_domain(a, b), not_finite);
  CHECK_ERROR(f.with_domain(a, b), not_finite);
  CHECK_ERROR(Composite(points.begin(), points.end(), {a, b}), not_finite);
  CHECK_ERROR(Composite(points.begin(), points.end(), {a, 0, 1, b}), not_finite);
  CHECK_ERROR((GC::Cubic_blended_curve<Double_3, GC::Bezier_basis>(points).bezier(a, b)), not_finite);
  const std::vector<Curve> long_curves{c.with_domain(a, 0), c.reverse().with_domain(0, b)};
  CHECK_ERROR(Composite(long_curves.begin(), long_curves.end()), not_finite);
  const Curve half = c.with_domain(a / 2, b / 2); // and this one is evaluated
  BOOST_CHECK(half(0) == c(0.5));
  BOOST_CHECK(half(a / 2) == points[0] && half(b / 2) == points[3]);
  for (double bad : {infinity, undefined}) {
    BOOST_CHECK_THROW(c.with_domain(0, bad), GC::Error);
    BOOST_CHECK_THROW(c.with_domain(-infinity, bad), GC::Error);
    BOOST_CHECK_THROW(Composite(points.begin(), points.end(), {0, bad}), GC::Error);
    BOOST_CHECK_THROW(GC::start_control_points(c.start_jet(2), 3, bad), GC::Error);
    BOOST_CHECK_THROW(GC::end_control_points(c.start_jet(2), 3, bad), GC::Error);
  }
  CHECK_ERROR(GC::end_control_points(c.start_jet(2), 3, 1e200), not_finite);
}

// A curve of intervals is split within its domain, too.
BOOST_AUTO_TEST_CASE(curves_of_intervals_are_split_within) {
  typedef CGAL::Interval_nt<> Interval;
  typedef GC::Traits_3<CGAL::Simple_cartesian<Interval>> Intervals;
  const std::array<Intervals::Point, 2> ends{Intervals::Point(0, 0, 0), Intervals::Point(2, 4, 8)};
  const GC::Bezier_curve<Intervals> c(ends.begin(), ends.end(), 0, 4);
  for (const double u : {-1., 0., 4., 5.}) CHECK_ERROR(c.split(Interval(u)), parameter_outside_domain);
  const auto parts = c.split(Interval(2));
  BOOST_CHECK(parts.first.control_point(1).z().is_same(Interval(4)));
  BOOST_CHECK(parts.second.domain().first.is_same(Interval(2)));
}

// By the product of Bernstein polynomials, of which binomials are a part.
BOOST_AUTO_TEST_CASE(energy_is_the_integral_of_a_product) {
  std::mt19937 random(1);
  for (int m : {0, 1, 2, 3, 7, 20})
    for (int k = 0; k <= m + 1; ++k) {
      std::vector<Exact_3::Point> p;
      for (int j = 0; j <= m; ++j)
        p.push_back({Q(static_cast<int>(random() % 99)) / Q(7), -static_cast<int>(random() % 99), j * j});
      const GC::Bezier_curve<Exact_3> c(p.begin(), p.end(), Q(-1), Q(2) / Q(3));
      Q integral(0), length = Q(5) / Q(3);
      for (int i = 0; i < 3; ++i) {
        GC::Bernstein_polynomial<Q> x = c.coordinate_polynomial(i);
        for (int j = 0; j < k; ++j) x = x.derivative();
        integral += (x * x).integral();
      }
      for (int j = 0; j < k; ++j) integral /= length * length;
      BOOST_CHECK_EQUAL(c.energy(k), Q(integral * length));
    }
}

// C(2m, m) overflows above degree 514.
BOOST_AUTO_TEST_CASE(energy_of_high_degree) {
  for (int m : {514, 515, 521, 600, 1500}) {
    std::vector<Point> constant(m + 1, Point(2, 3, 6)), line, first(m + 1, Point(0, 0, 0));
    for (int j = 0; j <= m; ++j) line.emplace_back(double(j) / m, 0, 2 * double(j) / m);
    first[0] = first[m] = Point(0, 1, 0);
    const Curve c(constant.begin(), constant.end(), 1, 3), l(line.begin(), line.end(), 0, 2),
        f(first.begin(), first.end());
    // 4 m roundings in each of the quotients of binomials, all of them positive
    const double percent = 1e-9;
    BOOST_CHECK_CLOSE(c.energy(0), 98, percent);
    BOOST_CHECK_EQUAL(c.energy(1), 0);
    BOOST_CHECK_CLOSE(l.energy(0), 10. / 3, percent);
    BOOST_CHECK_CLOSE(l.energy(1), 2.5, percent);
    BOOST_CHECK_CLOSE(f.energy(0), 2. / (2 * m + 1), percent);
    BOOST_CHECK_EQUAL(f.energy(m + 1), 0);
  }
  const Curve large{Point(1e200, 0, 0), Point(0, 0, 0)};
  CHECK_ERROR(large.energy(0), not_finite);
  CHECK_ERROR(large.energy(1), not_finite);
  BOOST_CHECK_EQUAL(large.energy(2), 0);
}

// Legs of any size, by powers of two bit by bit.
BOOST_AUTO_TEST_CASE(invariants_of_any_size) {
  std::mt19937 random(2);
  for (int a : {-500, -254, -100, 0, 100, 254, 500})
    for (int round = 0; round < 10; ++round) {
      std::vector<Point> p, q;
      for (int j = 0; j <= 4; ++j) {
        const int x = j * 7 + static_cast<int>(random() % 5), y = static_cast<int>(random() % 9), z = j * j;
        p.emplace_back(x, y, z);
        q.emplace_back(std::ldexp(x, a), std::ldexp(y, a), std::ldexp(z, a));
      }
      const Curve c(p.begin(), p.end()), d(q.begin(), q.end());
      const auto i = GC::end_invariants(c), j = GC::end_invariants(d), k = GC::start_invariants(d);
      BOOST_REQUIRE(i.curvature_squared && i.torsion && j.curvature_squared && j.torsion);
      BOOST_CHECK_EQUAL(*j.curvature_squared, std::ldexp(*i.curvature_squared, -2 * a));
      BOOST_CHECK_EQUAL(*j.torsion, std::ldexp(*i.torsion, -a));
      BOOST_CHECK_EQUAL(*k.torsion, std::ldexp(*GC::start_invariants(c).torsion, -a));
    }
  const Curve far{Point(-1.7e308, 0, 0), Point(1.7e308, 0, 0), Point(0, 1, 0)};
  CHECK_ERROR(GC::start_invariants(far), not_finite);
  CHECK_ERROR(GC::start_tangent(far), not_finite);
  CHECK_ERROR(GC::end_tangent(far.reverse()), not_finite);
}

BOOST_AUTO_TEST_CASE(numbers_that_enter) {
  for (double bad : {infinity, -infinity, undefined}) {
    CHECK_ERROR(GC::Cardinal_basis<double>{bad}.matrix<double>(), not_finite);
    CHECK_ERROR(GC::Cardinal_basis<double>{bad}.matrix<Q>(), not_finite);
    GC::Basis_matrix<double>::Rows rows{};
    rows[1][2] = bad;
    CHECK_ERROR(GC::Matrix_basis<double>{GC::Basis_matrix<double>(rows)}.matrix<double>(), not_finite);
    std::array<Point, 4> p = points;
    p[2] = Point(0, bad, 0);
    CHECK_ERROR((GC::Cubic_blended_curve<Double_3, GC::Bezier_basis>(p)), not_finite);
    CHECK_ERROR((GC::Composite_bezier_curve<Double_3>(p.begin(), p.end(), {0, 1})), not_finite);
    CHECK_ERROR(GC::Bspline_curve<Double_3>(p.begin(), p.end(), GC::Knot_vector<double>(3, 0., 1.)), not_finite);
    std::vector<GC::Coordinates<Double_3>> columns(4, GC::Coordinates<Double_3>(3));
    columns[3][1] = bad;
    CHECK_ERROR(
        GC::Bspline_curve<Double_3>(GC::Bspline_curve<Double_3>::Function(GC::Knot_vector<double>(3, 0., 1.), columns)),
        not_finite);
  }
}

// Messages name what was asked for.
BOOST_AUTO_TEST_CASE(names) {
  BOOST_CHECK_EQUAL(to_string(GC::Closing::open), "open");
  BOOST_CHECK_EQUAL(to_string(GC::Closing::smooth), "smooth");
  BOOST_CHECK_EQUAL(to_string(GC::Closing::cusp), "cusp");
  BOOST_CHECK_EQUAL(to_string(GC::Closing::corner), "corner");
  BOOST_CHECK_EQUAL(to_string(GC::Closing::singular), "singular");
  BOOST_CHECK_EQUAL(to_string(GC::Closure::open) + ' ' + to_string(GC::Closure::closed), "open closed");
  BOOST_CHECK_EQUAL(text(GC::Parametrisation::uniform), "uniform");
  BOOST_CHECK_EQUAL(text(GC::Parametrisation::chordal), "chordal");
  BOOST_CHECK_EQUAL(text(GC::Parametrisation::centripetal), "centripetal");
  const GC::Rational_bezier_curve<Exact_3> conic(
      {Exact_3::Point(0, 0, 0), Exact_3::Point(1, 2, 0), Exact_3::Point(3, 2, 1)}, {Q(1), Q(3) / Q(2), Q(1)});
  BOOST_CHECK_EQUAL(text(conic), "Rational " +
                                     text(GC::Bezier_curve<Exact_3>{Exact_3::Point(0, 0, 0), Exact_3::Point(1, 2, 0),
                                                                    Exact_3::Point(3, 2, 1)}) +
                                     ", weights 1 3/2 1");
}

BOOST_AUTO_TEST_SUITE_END()
