// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Limits of the work of constructions, and of what is said about their results: ordinary input is far below the default, long
// numbers are refused by a typed error, and floating-point numbers are never.

#include <boost/test/unit_test.hpp>

#include "support/errors.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Geometric_continuity/algebra/isolate_roots.h>
#include <CGAL/Geometric_continuity/curves/curvature_extrema.h>
#include <CGAL/Geometric_continuity/edges/connect_g1.h>
#include <CGAL/Geometric_continuity/extensions/extend.h>
#include <CGAL/Geometric_continuity/joins/order_within.h>
#include <CGAL/Simple_cartesian.h>

#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(construction_limits)

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational Q;

namespace {

template <class FT> using Space = GC::Traits_3<CGAL::Simple_cartesian<FT>>;
template <class FT> using Bezier = GC::Bezier_curve<Space<FT>>;
template <class FT> using Spline = GC::Bspline_curve<Space<FT>>;

constexpr unsigned seed = 20261122;
const GC::Work_limit one_step(1), default_limit;

// A curve whose coordinates are integers plus fractions of so many random digits.
template <class FT> Bezier<FT> random_curve(int degree, int digits) {
  std::mt19937 random(seed);
  std::vector<typename Space<FT>::Point> points;
  const auto number = [&] {
    FT x(0), y(1);
    for (int i = 0; i < digits; ++i) {
      x = FT(FT(10) * x + FT(static_cast<int>(random() % 10)));
      y = FT(FT(10) * y + FT(static_cast<int>(random() % 10)));
    }
    return FT(FT(static_cast<int>(random() % 99)) + x / y);
  };
  for (int i = 0; i <= degree; ++i) points.emplace_back(number(), number(), number());
  return Bezier<FT>(points.begin(), points.end());
}

// A cubic along the x-axis, moved by y.
template <class FT> Spline<FT> straight(int y) {
  typedef typename Space<FT>::Point Point;
  return Spline<FT>(Bezier<FT>{Point(0, y, 0), Point(1, y, 0), Point(2, y, 0), Point(3, y, 0)});
}

} // namespace

BOOST_AUTO_TEST_CASE(exact_numbers) {
  BOOST_TEST_MESSAGE("seed " << seed);
  const Bezier<Q> c = random_curve<Q>(5, 8), longer = random_curve<Q>(5, 2000), high = random_curve<Q>(60, 200);
  const auto curvature = GC::Frenet_order::curvature;

  BOOST_CHECK_EQUAL(GC::continuity(c, GC::extend(c, curvature, {}, default_limit)).g_order, 3);
  CHECK_ERROR(GC::extend(c, curvature, {}, one_step), work_limit);
  CHECK_ERROR(GC::extend(high, curvature), work_limit);
  const Spline<Q> spline(c);
  BOOST_CHECK(GC::extend(spline, curvature, {}, default_limit) == GC::extend(spline, curvature));
  CHECK_ERROR(GC::extend(spline, curvature, {}, one_step), work_limit);
  const GC::Composite_bezier_curve<Space<Q>> chain(&c, &c + 1);
  BOOST_CHECK_EQUAL(GC::extend(chain, curvature, {}, default_limit).number_of_segments(), 2);
  CHECK_ERROR(GC::extend(chain, curvature, {}, one_step), work_limit);

  const GC::Curvature_extrema extrema = GC::curvature_extrema(c, default_limit);
  BOOST_CHECK_EQUAL(extrema.extrema.size(), GC::curvature_extrema(c).extrema.size());
  CHECK_ERROR(GC::curvature_extrema(c, one_step), work_limit);
  CHECK_ERROR(GC::curvature_extrema(longer), work_limit);

  const Bezier<Q> right = GC::extend(c, GC::Frenet_order::tangent, {Q(1), {}, {}, {}});
  BOOST_CHECK_EQUAL(GC::deviation(c, right, default_limit).gap.upper, 0);
  CHECK_ERROR(GC::deviation(c, right, GC::Work_limit(10000)), work_limit);
  BOOST_CHECK_EQUAL(GC::order_within(c, c, {4, 2, 1e9, 1e9}, default_limit).verdicts[2], GC::Verdict::proved);
  CHECK_ERROR(GC::order_within(c, c, {4, 2, 1e9, 1e9}, one_step), work_limit);

  const GC::Bernstein_polynomial<Q> p{Q(-1), Q(2), Q(-2), Q(1)};
  const Q width = Q(1) / Q(1024);
  BOOST_CHECK_EQUAL(GC::isolate_roots(p, width, GC::default_bisections, default_limit).size(), 3);
  CHECK_ERROR(GC::isolate_roots(p, width, GC::default_bisections, one_step), work_limit);

  BOOST_CHECK(GC::connect_g1(straight<Q>(0), straight<Q>(1), straight<Q>(-1), Q(0), default_limit).g1());
  CHECK_ERROR(GC::connect_g1(straight<Q>(0), straight<Q>(1), straight<Q>(-1), Q(0), one_step), work_limit);
}

BOOST_AUTO_TEST_CASE(floating_point_numbers) {
  const Bezier<double> c = random_curve<double>(5, 3);
  BOOST_CHECK_EQUAL(GC::extend(c, GC::Frenet_order::curvature, {}, one_step).degree(), 5);
  BOOST_CHECK(GC::connect_g1(straight<double>(0), straight<double>(1), straight<double>(-1), 0., one_step).g1());
}

BOOST_AUTO_TEST_SUITE_END()
