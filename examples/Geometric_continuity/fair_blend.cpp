// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Blends of the same curves, of degree 5 with exactly G2 joins and of degree 7 with exactly G3
// joins: with the speed of the given curves, with the automatic shape, and the fair one, whose
// curvature varies least. Writes the picture fair_blend.svg.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>
#include <Geometric_continuity_figures/Svg_figure.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <string>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits> Curve;

int main() {
  const Curve phi{Point(0, 0), Point(2, 2), Point(2, 4), Point(4, 0)},
      psi{Point(8, 0), Point(10, 3), Point(10, 4), Point(13, 1)};
  const GC::Svg_style given{GC::Svg_role::given, false, true, "", true},
      result{GC::Svg_role::result, false, true, "blend", true};
  GC::Svg_figure figure("Blends with G2 joins, and below them with G3 joins", 3);
  bool proved = true;
  const auto add = [&](const char* caption, const Curve& gamma, int order) {
    proved = proved && GC::continuity(phi, gamma).g_order >= order && GC::continuity(gamma, psi).g_order >= order;
    const std::string join = "G" + std::to_string(order), e = std::to_string(std::lround(GC::fairness(gamma)));
    std::cout << join << ", " << caption << ": E = " << e << '\n';
    figure.add(GC::Svg_panel(caption + (", E = " + e))
                   .add(phi, given)
                   .join(join)
                   .add(gamma, result)
                   .join(join)
                   .add(psi, given));
  };
  const auto fair = GC::blend(phi, psi, GC::Fair());
  add("\u03b2 = \u03b7 = 1", GC::blend(phi, psi, GC::Minimal_energy<3>(), {1, 1}), 2);
  add("automatic shape", GC::blend(phi, psi), 2);
  add("fair", fair, 2);
  add("\u03b2 = \u03b7 = 1", GC::blend(phi, psi, GC::Minimal_energy_g3<4>(), {1, 1}), 3);
  add("automatic shape", GC::blend(phi, psi, GC::Minimal_energy_g3<4>()), 3);
  add("fair", GC::blend(phi, psi, GC::Fair_g3()), 3);
  std::ofstream("fair_blend.svg") << figure;
  std::cout << "fair, G2: beta = " << fair.shape.beta << ", eta = " << fair.shape.eta
            << (fair.report.converged ? ", converged" : "") << '\n'
            << (proved ? "all joins have their order" : "a join has broken") << '\n';
  return proved && fair.report.fairness < fair.report.automatic_fairness ? 0 : 1;
}
