// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Limits of the work of constructions, and of what is said about their results: ordinary input is
// far below the default, long numbers are refused by a typed error, and floating-point numbers are
// never.

#include "support/limited.h"
#include "support/test.h"

#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>
#include <CGAL/Geometric_continuity/blends/interpolate_fair.h>
#include <CGAL/Geometric_continuity/curves/fairness.h>
#include <CGAL/Geometric_continuity/curves/fit.h>
#include <CGAL/Geometric_continuity/curves/interpolate.h>
#include <CGAL/Geometric_continuity/extensions/extend.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/models/tessellate.h>
#include <CGAL/Geometric_continuity/surface_blends/connect_g1.h>
#include <thread>

BOOST_AUTO_TEST_SUITE(construction_limits)

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
  for (int i = 0; i <= degree; ++i) points.push_back({number(), number(), number()});
  return Bezier<FT>(points.begin(), points.end());
}

// A cubic along the x-axis, moved by y.
template <class FT> Spline<FT> straight(int y) {
  typedef typename Space<FT>::Point Point;
  return Spline<FT>(Bezier<FT>{Point(0, y, 0), Point(1, y, 0), Point(2, y, 0), Point(3, y, 0)});
}

BOOST_AUTO_TEST_CASE(exact_numbers) {
  BOOST_TEST_MESSAGE("seed " << seed);
  const Bezier<Q> c = random_curve<Q>(5, 8), longer = random_curve<Q>(5, 2000), high = random_curve<Q>(60, 200);
  const auto curvature = GC::Frenet_order::curvature;

  BOOST_CHECK_EQUAL(GC::continuity(c, GC::extend(c, curvature, {})).g_order, 3);
  CHECK_ERROR(limited(one_step, [&] { return GC::extend(c, curvature, {}); }), work_limit);
  CHECK_ERROR(GC::extend(high, curvature), work_limit);
  const Spline<Q> spline(c);
  BOOST_CHECK(GC::extend(spline, curvature, {}) == GC::extend(spline, curvature));
  CHECK_ERROR(limited(one_step, [&] { return GC::extend(spline, curvature, {}); }), work_limit);
  const GC::Composite_bezier_curve<Space<Q>> chain(&c, &c + 1);
  BOOST_CHECK_EQUAL(GC::extend(chain, curvature, {}).number_of_segments(), 2);
  CHECK_ERROR(limited(one_step, [&] { return GC::extend(chain, curvature, {}); }), work_limit);

  const GC::Curvature_extrema extrema = GC::curvature_extrema(c);
  BOOST_CHECK_EQUAL(extrema.extrema.size(), GC::curvature_extrema(c).extrema.size());
  CHECK_ERROR(limited(one_step, [&] { return GC::curvature_extrema(c); }), work_limit);
  CHECK_ERROR(GC::curvature_extrema(longer), work_limit);

  const Bezier<Q> right = GC::extend(c, GC::Frenet_order::tangent, {Q(1), {}, {}, {}});
  BOOST_CHECK_EQUAL(GC::deviation(c, right).gap.upper, 0);
  CHECK_ERROR(limited(GC::Work_limit(10000), [&] { return GC::deviation(c, right); }), work_limit);
  BOOST_CHECK_EQUAL(GC::order_within(c, c, {4, 2, 1e9, 1e9}).verdicts[2], GC::Verdict::proved);
  CHECK_ERROR(limited(one_step, [&] { return GC::order_within(c, c, {4, 2, 1e9, 1e9}); }), work_limit);

  const GC::Bernstein_polynomial<Q> p{Q(-1), Q(2), Q(-2), Q(1)};
  const Q width = Q(1) / Q(1024);
  BOOST_CHECK_EQUAL(GC::isolate_roots(p, width, GC::default_bisections).size(), 3);
  CHECK_ERROR(limited(one_step, [&] { return GC::isolate_roots(p, width, GC::default_bisections); }), work_limit);

  BOOST_CHECK(GC::connect_g1(straight<Q>(0), straight<Q>(1), straight<Q>(-1), Q(0)).g1());
  CHECK_ERROR(limited(one_step, [&] { return GC::connect_g1(straight<Q>(0), straight<Q>(1), straight<Q>(-1), Q(0)); }),
              work_limit);
}

// A function without a limit of its own counts in a scope, and so does a function with one.
BOOST_AUTO_TEST_CASE(scopes) {
  const Bezier<Q> left = random_curve<Q>(5, 8), long_left = random_curve<Q>(5, 600);
  const Bezier<Q> right = left.reverse(), long_right = long_left.reverse();
  const GC::Rational_bezier_curve<Space<Q>> rational(long_left);
  const Space<Q>::Point wished(1, 2, 3);
  const auto within = [](GC::Work_limit limit, auto work) {
    const GC::Work_scope scope(limit, "a scope");
    work();
  };
  const auto is_counted = [&](auto work, std::uint64_t steps) {
    within(default_limit, work);
    CHECK_ERROR(within(GC::Work_limit(steps), work), work_limit);
    work(); // the scope has ended
  };
  is_counted([&] { GC::blend(long_left, long_right); }, 1000000);
  is_counted([&] { GC::blend(long_left, long_right, GC::Minimal_energy_g3<4>()); }, 1000000);
  is_counted([&] { GC::blend(left, right).energy(3); }, 1000);
  is_counted([&] { GC::extend_toward(left, GC::Frenet_order::curvature, wished); }, 1000);
  is_counted([&] { rational.end_jet(32); }, 3300000); // without the quotients a third less
  is_counted([&] { long_left.end_jet(3); }, 100000);
  is_counted([&] { GC::continuity(long_left, long_right); }, 1000000);
  is_counted([&] { GC::extend(left, GC::Frenet_order::curvature, {}); }, 1000);
  const std::vector<Space<Q>::Point> points(left.control_points().begin(), left.control_points().end());
  const std::vector<std::vector<Space<Q>::Point>> net = {{points[0], points[1], points[2]},
                                                         {points[3], points[4], points[5]}};
  const GC::Bezier_patch<Space<Q>> patch(net);
  is_counted([&] { GC::tessellate(patch, GC::Uniform_grid{64}); }, 100000);
  // the jets count within the limit of a decision, in one sum with it
  CHECK_ERROR(limited(GC::Work_limit(1000000), [&] { return GC::continuity(rational, rational, 32); }), work_limit);

  // of two scopes the inner one may end first, and both count
  within(default_limit, [&] {
    CHECK_ERROR(within(one_step, [&] { GC::blend(long_left, long_right); }), work_limit);
    GC::blend(long_left, long_right);
  });
  CHECK_ERROR(
      within(GC::Work_limit(1000000), [&] { within(default_limit, [&] { GC::blend(long_left, long_right); }); }),
      work_limit);
  // another thread has scopes of its own
  within(one_step, [&] { std::thread([&] { GC::blend(long_left, long_right); }).join(); });
}

BOOST_AUTO_TEST_CASE(floating_point_numbers) {
  const Bezier<double> c = random_curve<double>(5, 3);
  const GC::Work_scope each(one_step);
  BOOST_CHECK_EQUAL(GC::extend(c, GC::Frenet_order::curvature, {}).degree(), 5);
  BOOST_CHECK(GC::connect_g1(straight<double>(0), straight<double>(1), straight<double>(-1), 0.).g1());
  const GC::Work_scope scope(one_step, "floating-point numbers");
  BOOST_CHECK_EQUAL(GC::blend(c, c.reverse(), GC::Minimal_energy_g3<4>()).degree(), 7);
  BOOST_CHECK_GT(GC::extend_toward(c, GC::Frenet_order::curvature, c.control_point(0)).energy(2), 0);
}

// A scope with a function can interrupt long work, whatever its numbers are.
BOOST_AUTO_TEST_CASE(interruption) {
  struct Interrupted {};
  const auto is_interruptible = [](auto work) {
    int pauses = 0;
    {
      const GC::Work_scope scope("a scope", [&pauses] { ++pauses; });
      const GC::Work_scope each(default_limit); // without a function
      work();
    }
    BOOST_CHECK_GT(pauses, 10);
    const int all = pauses;
    const auto interrupted = [&](int after) {
      pauses = 0;
      const GC::Work_scope outer("outside", [&] {
        if (++pauses == after) throw Interrupted();
      });
      const GC::Work_scope inner(GC::Work_limit(GC::Work_limit::default_steps), "inside");
      work();
    };
    for (const int after : {1, all / 2, all}) {
      BOOST_CHECK_THROW(interrupted(after), Interrupted);
      BOOST_CHECK_EQUAL(pauses, after);
    }
    work(); // the scope has ended
    BOOST_CHECK_EQUAL(pauses, all);
  };
  const Bezier<Q> c = random_curve<Q>(5, 300);
  is_interruptible([&] { GC::blend(c, c.reverse()); });
  is_interruptible([&] { GC::continuity(c, GC::extend(c, GC::Frenet_order::curvature)); });
  std::mt19937 random(seed);
  std::vector<Space<double>::Point> points;
  for (int i = 0; i < 100; ++i)
    points.emplace_back(i + static_cast<double>(random() % 64) / 128, random() % 64, random() % 64);
  is_interruptible([&] { GC::fit(points, 0.01); });
  is_interruptible([&] { GC::interpolate(points); });
  is_interruptible([&] { GC::interpolate_fair(points); });
  is_interruptible([&] { GC::blend(random_curve<double>(5, 3), random_curve<double>(4, 3), GC::Fair()); });
  int own = 0;
  const GC::Work_scope scope("a scope", [&own] { ++own; });
  GC::Work_scope::pause();
  BOOST_CHECK_EQUAL(own, 1);
}

BOOST_AUTO_TEST_SUITE_END()
