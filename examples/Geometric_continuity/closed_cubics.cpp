// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Makes closed curves through points (Catmull-Rom) and near them (uniform B-spline), and proves how
// smooth they are. Points may coincide; the proof shows what that does to the curve.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef Traits::Point Point;

// Prints the orders of continuity of a closed curve, and returns the least G order.
template <class Basis> int least_g_order(const char* name, const std::vector<Point>& points, const Basis& basis) {
  const GC::Composite_bezier_curve<Traits, 3> curve =
      GC::piecewise_cubic<Traits>(points.begin(), points.end(), basis, GC::Closure::closed);
  const auto result = GC::chain_continuity(curve);
  std::cout << name << ", starts at (" << curve.control_point(0) << "): " << result.summary << '\n';
  for (const auto& join : result.failing(GC::Continuity_kind::G, 1))
    std::cout << "  corner at (" << curve(join.knot) << ")\n";
  return *result.summary.g_order();
}

int main() {
  const std::vector<Point> points{Point(0, 0), Point(4, -1), Point(6, 2), Point(3, 5), Point(-1, 3)};
  const int through = least_g_order("Catmull-Rom", points, GC::Catmull_rom_basis()),
            tight = least_g_order("tension 1/2", points, GC::Cardinal_basis<Traits::FT>{Traits::FT(1) / 2}),
            near = least_g_order("B-spline", points, GC::Uniform_bspline_basis());

  std::vector<Point> tripled = points;
  tripled.insert(tripled.begin() + 2, 2, points[2]);
  const int corner = least_g_order("B-spline with a tripled point", tripled, GC::Uniform_bspline_basis());

  // One segment, converted exactly to another basis.
  const GC::Cubic_blended_curve<Traits, GC::Catmull_rom_basis> segment({points[0], points[1], points[2], points[3]});
  const auto hermite = segment.in_basis(GC::Hermite_basis()).geometry();
  std::cout << "from (" << hermite.p1 << ") to (" << hermite.p4 << ") with the derivatives (" << hermite.r1 << ") and ("
            << hermite.r4 << ")\n";
  return through == 1 && tight == 1 && near == 2 && corner == 0 ? 0 : 1;
}
