// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tells how far a join is from smooth: guaranteed bounds, and orders of continuity within a
// tolerance. The curves resemble quarters of a circle; their coordinates have been rounded when
// they were turned.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity.h>

#include <iostream>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<CGAL::Exact_predicates_inexact_constructions_kernel> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits> Curve;

// The point (x, y, 0), turned by 30 degrees about the z-axis.
Point turned(double x, double y) {
  const double c = 0.8660254037844386, s = 0.5;
  return Point(c * x - s * y, s * x + c * y, 0);
}

int main() {
  const double h = 0.5522847498307936;
  const Curve first{turned(1, 0), turned(1, h), turned(h, 1), turned(0, 1)},
      second{turned(0, 1), turned(-h, 1), turned(-1, h), turned(-1, 0)};

  std::cout << "exactly:            G" << GC::continuity(first, second).g_order << '\n'
            << "deviation:          " << GC::deviation(first, second) << '\n';

  GC::Join_tolerance tolerance;
  tolerance.tangent_angle = 1e-12;  // radians
  tolerance.curvature_jump = 1e-12; // relative
  tolerance.torsion_jump = 1e-12;   // in units of 1/length
  const GC::Order_within within = GC::order_within(first, second, tolerance);
  for (int order = 0; order <= 3; ++order) std::cout << "order " << order << " within 1e-12: " << within(order) << '\n';
  return within.proved_order() >= 2 ? 0 : 1;
}
