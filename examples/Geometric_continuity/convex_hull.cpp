// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// A Bezier curve stays in the convex hull of its control points. The hull itself comes from CGAL
// (that part is under the GPL); whether a point is inside is decided by this package as well, in
// any dimension, and proved by weights.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity/curves/bezier_properties.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/convex_hull_2.h>

#include <iostream>
#include <iterator>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef GC::Traits_2<Kernel> Traits;
typedef Traits::Point Point;

int main() {
  const GC::Bezier_curve<Traits> curve{Point(0, 0), Point(1, 4), Point(2, 1), Point(6, 4), Point(6, 0)};
  std::vector<Point> hull;
  CGAL::convex_hull_2(curve.begin(), curve.end(), std::back_inserter(hull));
  std::cout << "the hull has " << hull.size() << " of the " << curve.degree() + 1 << " control points\n";

  bool agree = true;
  int inside = 0;
  for (int i = -4; i <= 12; ++i) { // t from -1/2 to 3/2: the curve is extended beyond its ends
    const Point p = curve(i / 8.);
    const bool here = GC::is_in_convex_hull(curve, p);
    agree = agree && here == (CGAL::bounded_side_2(hull.begin(), hull.end(), p, Kernel()) != CGAL::ON_UNBOUNDED_SIDE);
    inside += here;
  }
  std::cout << inside << " of 17 points of the extended curve are inside\n";

  const Point p(2, 2);
  std::cout << "(" << p << ") is inside:";
  const auto weights = GC::convex_hull_weights(curve, p);
  for (int j = 0; weights && j <= curve.degree(); ++j)
    if ((*weights)[j] != 0) std::cout << "  " << (*weights)[j] << " of (" << curve.control_point(j) << ")";
  std::cout << '\n';

  const auto crossings = GC::count_crossings(curve, Point(0, 2), Traits::Vector(0, 1));
  std::cout << "the line y = 2 crosses the polygon " << crossings->polygon << " times, the curve " << crossings->curve
            << " times\n";
  return agree && inside == 9 && crossings->diminished() ? 0 : 1;
}
