// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Blends in floating-point numbers. Rounding the control points of a G2 blend breaks its joins; a
// representable blend is exactly G2, and still is after it has been written to a file and read
// again. One of surfaces is so along whole edges.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Geometric_continuity/IO/g2.h>

#include <iostream>
#include <sstream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<CGAL::Exact_predicates_inexact_constructions_kernel> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits> Curve;

// The order of a join, decided exactly on the coordinates as they are.
const char* order(const Curve& left, const Curve& right) {
  return GC::is_g2_join(left, right) ? "G2" : GC::is_g1_join(left, right) ? "G1" : "a corner";
}

int main() {
  const Curve phi{Point(0, 0, 0), Point(1.1, 0.2, 0), Point(2.3, 1.7, 0.3), Point(3.1, 1.9, 1.2)},
      psi{Point(6.4, 1.3, 1.1), Point(7.2, 0.6, 1.3), Point(8.1, 0.4, 0.2), Point(9.7, 0, 0)};

  const auto rounded = GC::blend(phi, psi);
  const Curve gamma(rounded.begin(), rounded.end());
  std::cout << "blend(): " << order(phi, gamma) << " and " << order(gamma, psi) << '\n';

  const GC::Representable_blend<Traits> exact = GC::representable_blend(phi, psi);
  std::stringstream file;
  GC::write_g2(file, exact.phi);
  GC::write_g2(file, exact);
  GC::write_g2(file, exact.psi);
  const std::vector<Curve> chain = GC::read_g2_curves<Traits>(file, "three curves");
  std::cout << "representable_blend(), written and read: " << order(chain[0], chain[1]) << " and "
            << order(chain[1], chain[2]) << '\n'
            << "control points of the curves moved by at most " << exact.start_join.moved << " and "
            << exact.end_join.moved << '\n';

  // the same from an edge of one patch to an edge of another one
  const GC::Bezier_patch<Traits> a({{Point(0, 0, 0), Point(1.1, 0.2, 0.3), Point(2.3, 0.7, 0.4)},
                                    {Point(0, 3.3, 0.1), Point(1.2, 3.4, 0), Point(2.7, 3.1, 0.9)}}),
      b({{Point(6.4, 0.1, 1.1), Point(7.2, 0.3, 1.3)}, {Point(6.1, 3.6, 0.8), Point(7.3, 3.2, 1.7)}});
  //! [surfaces]
  // control points are double
  const auto r = GC::representable_blend(a, GC::Patch_edge::v1, b, GC::Patch_edge::v0);
  const auto start = edge_continuity(r.first, GC::Patch_edge::v1, r.blend, GC::Patch_edge::v0),
             end = edge_continuity(r.blend, GC::Patch_edge::v1, r.second, GC::Patch_edge::v0);
  std::cout << "of surfaces: " << start << " and " << end << ", control points moved by at most " << r.start_join.moved
            << " and " << r.end_join.moved << '\n';
  //! [surfaces]
  return GC::is_g2_join(chain[0], chain[1]) && GC::is_g2_join(chain[1], chain[2]) && start.g_order == 2 &&
                 end.g_order == 2
             ? 0
             : 1;
}
