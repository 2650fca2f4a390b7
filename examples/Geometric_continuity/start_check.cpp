// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Start here: how smooth is the join of two curves? Decided for the doubles as they are given.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity.h>

#include <iostream>

int main() {
  //! [start]
  namespace GC = CGAL::Geometric_continuity;
  typedef GC::Traits_2<CGAL::Exact_predicates_inexact_constructions_kernel> Traits;
  typedef Traits::Point Point;

  const GC::Bezier_curve<Traits> left{Point(0, 0), Point(1, 2), Point(3, 2), Point(4, 1)},
      right{Point(4, 1), Point(6, -1), Point(8, -1)};
  std::cout << GC::continuity(left, right) << '\n';
  std::cout << "relative jump of the curvature: " << *GC::deviation(left, right).curvature_jump << '\n';
  //! [start]
}
