// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Finds which of many lines cross, touch or miss which of many curves: box_intersection_d of CGAL
// finds the few pairs whose boxes meet, and signs of polynomials decide those exactly.
// (Box_intersection_d is under the GPL.)

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/curves/polyline.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/box_intersection_d.h>

#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef Traits::FT FT;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits> Curve;
typedef GC::Curve_piece_box<Traits, int> Box;

// The side of the line on which the curve is, as a polynomial: the coefficients are the sides of
// the control points.
GC::Sign_pattern sides(const Curve& curve, const Curve& line) {
  std::vector<FT> side;
  const Point &a = line.control_point(0), &b = line.control_point(1);
  for (const Point& p : curve) side.push_back(CGAL::determinant(b - a, p - a));
  return GC::sign_pattern(GC::Bernstein_polynomial<FT>(side));
}

int main() {
  // Parabolas that rise to 8/7 on [2 i, 2 i + 1], and horizontal lines, each over five of them.
  const int n = 30;
  std::vector<Curve> curves;
  std::vector<Box> curve_boxes, line_boxes;
  for (int i = 0; i < n; ++i) {
    curves.push_back({Point(2 * i, 0), Point(2 * i + FT(1) / 2, 2), Point(2 * i + 1, FT(1) / 2)});
    GC::bounding_boxes(curves.back(), 2, i, std::back_inserter(curve_boxes));
  }
  for (int i = 0; i < n; ++i) {
    const FT x = 14 * i % 46 - FT(1) / 2, y = FT(8 * (i + 1)) / FT(7 * 28);
    curves.push_back({Point(x, y), Point(x + 10, y)});
    GC::bounding_boxes(curves.back(), 0, n + i, std::back_inserter(line_boxes));
  }

  std::set<std::pair<int, int>> candidates; // a curve and a line
  CGAL::box_intersection_d(curve_boxes.begin(), curve_boxes.end(), line_boxes.begin(), line_boxes.end(),
                           [&](const Box& c, const Box& l) { candidates.emplace(c.handle(), l.handle()); });
  std::map<GC::Sign_pattern, int> found;
  for (const std::pair<int, int>& pair : candidates) ++found[sides(curves[pair.first], curves[pair.second])];

  const int cross = found[GC::Sign_pattern::mixed], touch = found[GC::Sign_pattern::nonpositive],
            miss = found[GC::Sign_pattern::negative];
  std::cout << n * n << " pairs, " << candidates.size() << " candidates: " << cross << " cross, " << touch << " touch, "
            << miss << " miss\n";
  return cross == 27 * 5 && touch == 5 && cross + touch + miss == int(candidates.size()) ? 0 : 1;
}
