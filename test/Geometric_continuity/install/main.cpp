// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Simple_cartesian.h>
#include <Geometric_continuity_figures/Svg_figure.h>

#include <iostream>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef Traits::Point Point;

int main() {
  const GC::Bezier_curve<Traits> phi{Point(0, 0), Point(1, 0), Point(2, 1)}, psi{Point(4, 1), Point(5, 0), Point(6, 0)};
  const GC::Quintic_blend<Traits> gamma = GC::blend(phi, psi);
  GC::write_g2(std::cout, gamma);
  std::cout << GC::Svg_figure().add(GC::Svg_panel().add(gamma));
  return GC::continuity(phi, gamma).g_order >= 2 ? 0 : 1;
}
