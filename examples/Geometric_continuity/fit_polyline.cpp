// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Few curves near a polyline with many vertices, in floating-point numbers: the joins are exactly
// G1 or G2 nevertheless, and the distance is proved.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity.h>

#include <algorithm>
#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_2<CGAL::Exact_predicates_inexact_constructions_kernel> Traits;
typedef Traits::Point Point;

// The upper half of a circle by 500 lines, closed by its diameter: two corners.
std::vector<Point> half_a_circle() {
  std::vector<Point> points;
  for (int i = 0; i <= 500; ++i) {
    const double t = i / 250. - 1, w = 1 + t * t;
    points.emplace_back(-200 * t / w, 100 * (1 - t * t) / w);
  }
  return points;
}

int main() {
  const std::vector<Point> points = half_a_circle();
  bool as_expected = true;
  for (const int order : {1, 2})
    for (const double tolerance : {1., 0.01}) {
      const GC::Fitted_curve<Traits> curve =
          GC::fit<Traits>(points.begin(), points.end(), tolerance, GC::Closure::closed, order);
      int smooth = 0;
      for (const auto& join : curve.joins()) // decided exactly on the coordinates
        smooth += continuity(curve.segment(join.left), curve.segment(join.right), order).g_order >= order ? 1 : 0;
      const int corners = static_cast<int>(curve.corners.size());
      std::cout << points.size() << " points, tolerance " << tolerance << ": " << curve.number_of_segments()
                << " curves of degree " << curve.degree() << ", " << corners << " corners, " << smooth
                << " joins that are G" << order << ", the tolerance is "
                << (curve.distance <= tolerance ? "kept" : "exceeded") << '\n';
      as_expected = as_expected && curve.distance <= tolerance && corners + smooth == curve.number_of_joins();
    }
  return as_expected ? 0 : 1;
}
