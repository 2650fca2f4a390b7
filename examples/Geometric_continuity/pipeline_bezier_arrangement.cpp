// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Builds the exact arrangement of Bezier curves, without polylines: Arr_Bezier_curve_traits_2 of
// CGAL takes the control points as they are, and gives them back. Curves over its rational kernel
// need no conversion. (This part of CGAL is under the GPL.)

#include <CGAL/Arr_Bezier_curve_traits_2.h>
#include <CGAL/Arrangement_with_history_2.h>
#include <CGAL/CORE_algebraic_number_traits.h>
#include <CGAL/Cartesian.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>

#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::CORE_algebraic_number_traits Numbers;
typedef CGAL::Cartesian<Numbers::Rational> Rational_kernel;
typedef CGAL::Cartesian<Numbers::Algebraic> Algebraic_kernel;
typedef CGAL::Arr_Bezier_curve_traits_2<Rational_kernel, Algebraic_kernel, Numbers> Arr_traits;
typedef CGAL::Arrangement_with_history_2<Arr_traits> Arrangement;
typedef GC::Traits_2<Rational_kernel> Traits;
typedef GC::Bezier_curve<Traits> Curve;
typedef Rational_kernel::Point_2 Point;

Arr_traits::Curve_2 to_cgal(const Curve& c) { return Arr_traits::Curve_2(c.begin(), c.end()); }
Curve from_cgal(const Arr_traits::Curve_2& c) { return Curve(c.control_points_begin(), c.control_points_end()); }

int main() {
  const Curve phi{Point(-4, 0), Point(8, 8), Point(-8, 8), Point(4, 0)}; // with a loop
  const Curve psi{Point(-3, 5), Point(0, 1), Point(3, 5)};
  const Curve gamma = GC::blend(phi, psi);
  const std::vector<Arr_traits::Curve_2> curves{to_cgal(phi), to_cgal(gamma), to_cgal(psi)};
  Arrangement arrangement;
  insert(arrangement, curves.begin(), curves.end());
  std::cout << arrangement.number_of_vertices() << " vertices, " << arrangement.number_of_edges() << " edges, "
            << arrangement.number_of_faces() << " faces\n";

  // The curves that come back from the arrangement join as smoothly as before.
  std::vector<Curve> back;
  for (auto c = arrangement.curves_begin(); c != arrangement.curves_end(); ++c) back.push_back(from_cgal(*c));
  const auto start = GC::continuity(back[0], back[1]), end = GC::continuity(back[1], back[2]);
  std::cout << "start: " << start << "\nend:   " << end << '\n';
  return back[1] == gamma && start.g_order >= 2 && end.g_order >= 2 ? 0 : 1;
}
