// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Extends a space curve several times so that the Frenet frame, the curvature and the torsion are
// continuous, while each new segment heads for a given point. The plane of alternatives leaves room
// for that; C3 would not.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits> Curve;

int main() {
  // The degree is 5: three points serve the torsion, and the last one is free.
  std::vector<Curve> chain{
      Curve{Point(0, 0, 0), Point(1, 0, 0), Point(2, 1, 0), Point(3, 2, 1), Point(3, 3, 2), Point(2, 4, 4)}};
  for (const Point& target : {Point(-3, 4, 5), Point(-4, -2, 7), Point(3, -3, 9)})
    chain.push_back(GC::extend_toward(chain.back(), GC::Frenet_order::torsion, target));

  bool proved = true;
  GC::Chain_accumulator<Curve> analysis;
  for (const Curve& segment : chain)
    analysis.add(segment, [&](const GC::Chain_join<Curve>& join) {
      const auto tau = GC::torsion(join.right_curve.start_jet(3));
      std::cout << "join " << join.left << ": F" << join.continuity.f_order << ", torsion " << CGAL::to_double(*tau)
                << " on both sides, next end (" << join.right_curve.control_point(5) << ")\n";
      proved = proved && *join.continuity.torsion_equal;
    });
  std::cout << analysis.summary() << '\n';
  return proved && *analysis.summary().f_order() == 3 ? 0 : 1;
}
