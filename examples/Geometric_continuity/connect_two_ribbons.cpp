// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Makes two surfaces, one on each side of a cubic spline, with given cross derivatives and twists
// at its ends. They meet with G1 continuity, which is proved for the whole edge. With other twists
// the surfaces fold, and the report says where.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/surface_blends/connect_g1.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational FT;
typedef GC::Traits_3<CGAL::Simple_cartesian<FT>> Traits;
typedef Traits::Point Point;
typedef GC::Bspline_curve<Traits> Curve;

// A spline on [0, 4] with a knot of multiplicity 2 at 2.
Curve spline(const std::vector<Point>& points) {
  return Curve(points.begin(), points.end(), GC::Knot_vector<FT>(3, FT(0), FT(4), {{FT(2), 2}}));
}

// Connects two surfaces along c, prints a report, and returns whether they are G1 along the whole
// edge.
bool connect(const Curve& c, const Curve& c1, const Curve& c2) {
  const GC::G1_ribbon<Traits> ribbon = GC::connect_g1(c, c1, c2);
  std::cout << ribbon << '\n';
  for (const auto& span : ribbon.continuity()) {
    std::cout << "  span: " << span;
    if (span.g_order == 0) std::cout << ", e.g. on [" << span.deviation->begin << ", " << span.deviation->end << ']';
    std::cout << '\n';
  }
  std::cout << "degree " << ribbon.side1.degree_u() << " x " << ribbon.side1.degree_v() << ", knots "
            << ribbon.side1.knots_u() << "\n\n";
  return ribbon.g1();
}

int main() {
  const Curve c =
      spline({Point(0, 0, 0), Point(2, 0, 0), Point(4, 0, 3), Point(6, 0, 3), Point(8, 0, 0), Point(10, 0, 0)});
  // The cross derivatives C1 - C, C2 - C and the twists C1' - C', C2' - C' at the ends can be
  // attained.
  const Curve left =
      spline({Point(1, 3, 0), Point(3, 4, 1), Point(4, 5, 4), Point(6, 5, 4), Point(9, 4, -1), Point(11, 3, 0)});
  const Curve right =
      spline({Point(1, -3, 0), Point(3, -2, 1), Point(4, -4, 4), Point(6, -4, 4), Point(9, -2, -1), Point(11, -3, 0)});
  const bool smooth = connect(c, left, right);

  // The left neighbour leans over to the right after the start and before the end.
  const Curve leaning =
      spline({Point(1, 3, 0), Point(3, -9, 1), Point(4, 5, 4), Point(6, 5, 4), Point(9, -9, -1), Point(11, 3, 0)});
  const bool folded = !connect(c, leaning, right);
  return smooth && folded ? 0 : 1;
}
