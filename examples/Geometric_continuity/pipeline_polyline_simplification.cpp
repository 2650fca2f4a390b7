// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Turns a closed outline of Bezier curves into a fine polyline, which the package
// Polyline_simplification_2 of CGAL thins out without letting it cross itself. Both errors are
// bounded, and the bounds add up. (The simplification is under the GPL.)

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/polyline.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polyline_simplification_2/Squared_distance_cost.h>
#include <CGAL/Polyline_simplification_2/Stop_above_cost_threshold.h>
#include <CGAL/Polyline_simplification_2/simplify.h>

#include <iostream>
#include <iterator>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
namespace PS = CGAL::Polyline_simplification_2;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_2 Point;
typedef CGAL::Polygon_2<Kernel> Polygon;

int main() {
  // A leaf with a tip at the origin.
  const std::vector<Point> points{Point(0, 0),  Point(6, -1), Point(8, 5), Point(8, 9),
                                  Point(4, 10), Point(1, 5),  Point(0, 0)};
  const GC::Composite_bezier_curve<GC::Traits_2<Kernel>> leaf(points.begin(), points.end(), {0, 1, 2});

  Polygon fine;
  GC::chord_polyline(leaf, 0.0001, std::back_inserter(fine));
  fine.erase(fine.vertices_end() - 1); // the last point is the first one again
  std::cout << std::boolalpha << "fine: " << fine.size() << " vertices, simple: " << fine.is_simple() << '\n';

  bool ok = leaf.is_closed() && fine.is_simple();
  for (double distance : {0.01, 0.1}) {
    const Polygon coarse =
        PS::simplify(fine, PS::Squared_distance_cost(), PS::Stop_above_cost_threshold(distance * distance));
    std::cout << "simplified to " << distance << ": " << coarse.size() << " vertices, simple: " << coarse.is_simple()
              << '\n';
    ok = ok && coarse.size() < fine.size() / 4 && coarse.is_simple();
  }
  return ok ? 0 : 1;
}
