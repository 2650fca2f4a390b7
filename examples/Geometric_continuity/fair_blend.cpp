// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Three blends of the same curves, all with exactly continuous curvature: with the speed of the given curves, with the
// automatic shape, and the fair one, whose curvature varies least. Writes the picture fair_blend.svg.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Geometric_continuity/IO/figures/Svg_figure.h>
#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <string>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits> Curve;

int main() {
  const Curve phi{Point(0, 0), Point(1, 2), Point(3, 3), Point(5, 2)},
      psi{Point(7, 0), Point(9, -1), Point(11, 1), Point(12, 3)};
  const auto equal_speed = GC::blend(phi, psi, GC::Minimal_energy<3>(), {1, 1});
  const auto automatic = GC::blend(phi, psi);
  const auto fair = GC::blend(phi, psi, GC::Fair());
  std::cout << "automatic shape: beta = " << automatic.shape.beta << ", eta = " << automatic.shape.eta << '\n'
            << "fair: beta = " << fair.shape.beta << ", eta = " << fair.shape.eta
            << (fair.report.converged ? ", converged" : "") << '\n';

  const GC::Svg_style given{GC::Svg_role::given, false, true, "", true},
      result{GC::Svg_role::result, false, true, "blend", true};
  GC::Svg_figure figure("Three blends with continuous curvature", 3);
  bool proved = true;
  const auto add = [&](const char* caption, const Curve& gamma) {
    proved = proved && GC::continuity(phi, gamma).g_order >= 2 && GC::continuity(gamma, psi).g_order >= 2;
    figure.add(GC::Svg_panel(caption).add(phi, given).join("G2").add(gamma, result).join("G2").add(psi, given));
  };
  add("\u03b2 = \u03b7 = 1", equal_speed);
  add("automatic shape", automatic);
  add("fair", fair);
  std::ofstream("fair_blend.svg") << figure;
  std::cout << (proved ? "all joins are G2" : "a join is not G2") << '\n';
  return proved && fair.report.fairness < fair.report.automatic_fairness ? 0 : 1;
}
