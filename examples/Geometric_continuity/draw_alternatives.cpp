// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Hagen's line of alternatives: all third points of the next segment that keep the curvature
// continuous. One member makes the join C2; the others are as smooth to the eye. Writes the picture
// alternatives.svg.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>
#include <Geometric_continuity_figures/Svg_figure.h>

#include <fstream>
#include <iostream>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits> Curve;

int main() {
  const Curve left{Point(0, 0), Point(1, 2), Point(3, 3), Point(5, 2)};
  const GC::Curvature_alternatives<Traits> line = GC::curvature_alternatives(left);
  const GC::Midpoint_construction<Traits> construction = GC::midpoint_construction(left);

  // the two reflections of Hagen's construction are members of the line
  std::cout << "C0 of the C2 member " << *line.parameter_of(construction.b2_tilde) << ", of the other reflection "
            << *line.parameter_of(construction.b2_bar) << '\n';

  const GC::Svg_style given{GC::Svg_role::given, true, true}, next{GC::Svg_role::result, true, true, "next segment"};
  GC::Svg_figure figure("The next segment for different members of the line", 3);
  bool proved = true;
  for (int c0 : {2, 4, 6}) {
    const Curve right = GC::extend(left, GC::Frenet_order::curvature, {1, c0, {}, {}});
    const auto join = GC::continuity(left, right);
    std::cout << "C0 = " << c0 << ": b2 = (" << line.point_at(c0) << "), " << join << '\n';
    proved = proved && join.g_order >= 2 && right.control_point(2) == line.point_at(c0);
    figure.add(GC::Svg_panel("C0 = " + std::to_string(c0)).add(left, given).join("G2").add(right, next));
  }
  std::ofstream("alternatives.svg") << figure;
  return proved ? 0 : 1;
}
