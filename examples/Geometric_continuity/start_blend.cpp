// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Start here: a curve that leads from one curve to another with continuous curvature, and the
// proof. The README shows the last four lines.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>

int main() {
  //! [start]
  namespace GC = CGAL::Geometric_continuity;
  // exact: so the joins are, too
  typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
  typedef GC::Bspline_curve<Traits> Curve;
  typedef Traits::Point P;

  GC::Knot_vector<Traits::FT> knots(2, {0, 0, 0, 1, 3, 3, 3}); // degree 2, and all knots
  Curve phi({P(0, 0), P(1, 2), P(3, 3), P(5, 2)}, knots), psi({P(9, 0), P(11, 0), P(12, 2), P(14, 2)}, knots);
  auto gamma = GC::blend(phi, psi, GC::Fair()); // from the end of phi to the start of psi
  std::cout << GC::continuity(phi, gamma) << '\n' << GC::continuity(gamma, psi) << '\n';
  //! [start]
}
