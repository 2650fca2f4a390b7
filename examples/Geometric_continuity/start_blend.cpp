// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Start here: a curve that leads from one curve to another with continuous curvature, and the
// proof.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>

int main() {
  //! [start]
  namespace GC = CGAL::Geometric_continuity;
  // exact: so the joins are, too
  typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
  typedef Traits::Point Point;

  const GC::Bezier_curve<Traits> phi{Point(0, 0, 0), Point(1, 2, 0), Point(3, 2, 1), Point(4, 0, 1)},
      psi{Point(7, 1, 0), Point(8, 2, 2), Point(9, 1, 1), Point(11, 0, 3)};
  const auto gamma = GC::blend(phi, psi, GC::Fair());
  std::cout << GC::continuity(phi, gamma) << '\n' << GC::continuity(gamma, psi) << '\n';
  //! [start]
}
