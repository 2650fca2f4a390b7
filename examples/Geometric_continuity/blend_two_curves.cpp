// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Blends two planar cubics by the quintic of least energy and proves that both joins have
// continuous curvature.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Geometric_continuity.h>

#include <iostream>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_2<CGAL::Exact_predicates_exact_constructions_kernel> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits> Curve;

int main() {
  const Curve phi{Point(-3, 0), Point(-3, 2), Point(-2, 3), Point(0, 3)};
  const Curve psi{Point(4, 0), Point(5, -1), Point(7, -1), Point(8, 1)};

  // The blend leads from the end of phi to the start of psi.
  const GC::Quintic_blend<Traits> gamma = GC::blend(phi, psi);

  std::cout << "control points of the blend:\n";
  for (const Point& p : gamma) std::cout << "  " << exact(p.x()) << "  " << exact(p.y()) << '\n';

  // The verdict is exact: nothing is sampled, and there is no tolerance.
  const auto start = GC::continuity(phi, gamma), end = GC::continuity(gamma, psi);
  std::cout << "start: " << start << "\nend:   " << end << '\n';

  // The squared curvature of the blend is that of phi.
  std::cout << "squared curvatures: " << exact(*GC::curvature_squared(phi.end_jet(2))) << " and "
            << exact(*GC::curvature_squared(gamma.start_jet(2))) << '\n';
  return start.g_order >= 2 && end.g_order >= 2 ? 0 : 1;
}
