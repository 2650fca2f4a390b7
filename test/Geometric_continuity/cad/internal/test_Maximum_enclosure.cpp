// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search for the largest value on a range, for functions of which the bounds are given: what
// ends it, and what is left open.

#include "support/test.h"

#include <CGAL/Geometric_continuity/cad/internal/Maximum_enclosure.h>

BOOST_AUTO_TEST_SUITE(Maximum_enclosure)

using CGAL::Geometric_continuity::internal::Bounds_on_range;
typedef CGAL::Geometric_continuity::internal::Maximum_enclosure Largest;
typedef CGAL::Geometric_continuity::internal::Largest_options Options;
typedef std::vector<std::pair<double, double>> Ranges;

Options options(int ranges, double relative = 0.01) {
  return {relative, 0, [](double x) { return x; }, ranges, std::numeric_limits<int>::max()};
}
const auto nowhere = [](double, double) { return false; };
const auto everywhere = [](double, double) { return true; };

// The function t, but for points where it is not defined.
auto without(std::vector<double> points) {
  return [points](double from, double to) {
    for (double x : points)
      if (from <= x && x <= to) return Bounds_on_range{0, 0, from, false};
    return Bounds_on_range{from, to, from, true};
  };
}
bool hold(const Ranges& ranges, const std::vector<double>& points, double length) {
  if (ranges.size() != points.size()) return false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [first, last] = ranges[i];
    if (!(first <= points[i] && points[i] <= last && last - first <= length)) return false;
  }
  return true;
}

BOOST_AUTO_TEST_CASE(a_function_that_rises) {
  const Largest f({0, 1, 3}, options(1000), without({}), nowhere);
  BOOST_TEST((f.defined && !f.exhausted && f.upper == 3 && f.lower >= 2.97 && f.parameter == f.lower));
  // in the middle of the last part
  BOOST_TEST((f.upper_at > f.lower && f.upper_at < 3));
  const Largest few({0, 1, 3}, options(0, 1e-14), without({}), nowhere); // 24 ranges
  BOOST_TEST((few.exhausted && few.upper == 3 && few.lower < 3 && few.evaluated >= 24 && few.evaluated <= 26));
  // what nothing improves is not halved beyond the last digit
  const double tiny = std::numeric_limits<double>::denorm_min();
  const Largest wide(
      {0, tiny}, options(1000),
      [](double from, double) {
        return Bounds_on_range{0, 1, from, true};
      },
      nowhere);
  BOOST_TEST((wide.upper == 1 && wide.lower == 0 && wide.evaluated == 1 && !wide.exhausted));
}

BOOST_AUTO_TEST_CASE(points_without_a_value) {
  for (const std::vector<double>& points :
       {std::vector<double>{0.3}, std::vector<double>{0.3, 0.7}, std::vector<double>{0, 0.3, 0.7, 1}}) {
    const Largest f({0, 1}, options(4000), without(points), everywhere);
    BOOST_TEST((hold(f.undefined, points, 0x1p-18) && f.unresolved.empty() && f.upper >= 0.99));
    // where that is not proved
    const Largest open({0, 1}, options(4000), without(points), nowhere);
    BOOST_TEST((open.undefined.empty() && hold(open.unresolved, points, 0x1p-46)));
    // with so few ranges that the search ends when the parts are tiny
    const Largest few({0, 1}, options(240 * static_cast<int>(points.size())), without(points), nowhere);
    BOOST_TEST((few.undefined.empty() && hold(few.unresolved, points, 0x1p-18)));
  }
  // no length, and that of the last digit, which is no small part of it
  BOOST_TEST((Largest({1}, options(100), without({1}), everywhere).undefined == Ranges{{1, 1}}));
  BOOST_TEST((Largest({1}, options(100), without({1}), nowhere).unresolved == Ranges{{1, 1}}));
  const double next = 1 + std::numeric_limits<double>::epsilon();
  BOOST_TEST((Largest({1, next}, options(100), without({1}), everywhere).unresolved == Ranges{{1, next}}));
}

BOOST_AUTO_TEST_CASE(nowhere_a_value) {
  const auto nothing = [](double from, double) { return Bounds_on_range{0, 0, from, false}; };
  const Largest f({0, 1}, options(4000), nothing, nowhere);
  BOOST_TEST((!f.defined && f.exhausted && f.undefined.empty() && f.unresolved == Ranges{{0, 1}}));
  Options most = options(4000);
  most.most_ranges = 5; // all are evaluated, and none is left to halve one
  const Largest g({0, 1, 2, 3, 4, 5}, most, nothing, nowhere);
  BOOST_TEST((!g.defined && g.exhausted && g.evaluated == 5 && g.unresolved == Ranges{{0, 5}}));
  const Largest part({0, 1, 2, 3, 4, 5, 6, 7}, most, without({2.5}), nowhere);
  BOOST_TEST((part.exhausted && part.unresolved == Ranges{{2, 3}, {5, 7}} && part.upper == 5));
}

BOOST_AUTO_TEST_SUITE_END()
