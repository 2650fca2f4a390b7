// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// A minimal program on top of it: two curves, and one question about their join.

#ifdef WITH_FILTERED_KERNEL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
#else
#include <CGAL/Simple_cartesian.h>
typedef CGAL::Simple_cartesian<double> Kernel;
#endif

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>

#include <iostream>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<Kernel> Traits;
typedef Traits::Point Point;

int main() {
  const GC::Bezier_curve<Traits> phi{Point(0, 0, 0), Point(1, 0, 0), Point(2, 1, 0), Point(3, 1, 1)},
      psi{Point(3, 1, 1), Point(4, 1, 2), Point(6, 1, 1), Point(7, 0, 0)};
  std::cout << GC::is_g2_join(phi, psi) << '\n';
}
