// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// A line runs into an arc of a circle. Where both have one tangent the curvature jumps, exactly by
// 1/r. A fair blend in place of the last part of the line and the first part of the arc makes the
// curvature continuous, as in the easement of a railway. Writes the picture line_and_arc.svg.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>
#include <Geometric_continuity_figures/Svg_figure.h>

#include <fstream>
#include <iostream>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef Traits::Point Point;
typedef Traits::FT FT;
typedef GC::Rational_bezier_curve<Traits> Curve;

int main() {
  const Curve line = GC::Bezier_curve<Traits>{Point(-8, 0), Point(0, 0)};
  // 106 degrees of the radius 4
  const Curve arc = GC::circular_arc(Point(0, 4), Point(0, 0), FT(FT(1) / FT(2)));
  std::cout << "line and arc: " << GC::continuity(line, arc)
            << "\ncurvature of the arc, squared: " << *GC::curvature_squared(arc.start_jet(2)) << '\n';

  const Curve before = line.split(FT(FT(5) / FT(8))).first, after = arc.split(FT(FT(3) / FT(8))).second;
  const auto gamma = GC::blend(before, after, GC::Fair());
  const auto start = GC::continuity(before, gamma), end = GC::continuity(gamma, after);
  std::cout << "line and blend: G" << start.g_order << "\nblend and arc: G" << end.g_order << '\n';

  const GC::Svg_style given{GC::Svg_role::given, false, true, "line and arc", true},
      result{GC::Svg_role::result, false, true, "blend", true};
  GC::Svg_figure figure("From a line to a circle", 2);
  figure.add(GC::Svg_panel("one tangent: the curvature jumps").add(line, given).join("G1").add(arc, given));
  figure.add(GC::Svg_panel("a fair blend: the curvature runs through, and has to overshoot")
                 .add(before, given)
                 .join("G2")
                 .add(gamma, result)
                 .join("G2")
                 .add(after, given));
  std::ofstream("line_and_arc.svg") << figure;
  return start.g_order >= 2 && end.g_order >= 2 ? 0 : 1;
}
