// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The six figures of Portnov's text, from the formulas: where the control points A, B, C of a blend lie, and what three of his
// choices look like. Writes the picture portnov_figures.svg.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Geometric_continuity/IO/figures/Svg_figure.h>
#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational FT;
typedef GC::Traits_2<CGAL::Simple_cartesian<FT>> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits> Curve;
typedef GC::Quintic_blend<Traits> Blend;

const Curve phi{Point(0, 0), Point(1, 4), Point(4, 6), Point(7, 5)},
    psi{Point(10, 1), Point(12, -1), Point(15, 0), Point(16, 4)};
const GC::Svg_style given{GC::Svg_role::given, false, true}, construction{GC::Svg_role::construction},
    result{GC::Svg_role::result, true, true, "blend"};
bool proved = true;

void mark(GC::Svg_panel& panel, const Point& p, const char* label) { panel.add(Curve{p}).join(label); }

// The line l of all points C for which the curvature is continuous, and the points A, B.
GC::Svg_panel construction_of(const char* caption, const Blend& gamma) {
  GC::Svg_panel panel(caption);
  const Point a = gamma.control_point(0), b = gamma.control_point(1), c = gamma.control_point(2);
  panel.add(phi, {GC::Svg_role::given, false, false}).add(Curve{a, a + FT(3) * (b - a)}, construction);
  panel.add(Curve{c - FT(2) * (b - a), c + FT(2) * (b - a)}, construction);
  mark(panel, a, "A");
  mark(panel, b, "B");
  mark(panel, c, "C");
  return panel;
}

GC::Svg_panel blend_of(const char* caption, const Blend& gamma) {
  proved = proved && GC::continuity(phi, gamma).g_order >= 2 && GC::continuity(gamma, psi).g_order >= 2;
  return GC::Svg_panel(caption).add(phi, given).join("G2").add(gamma, result).join("G2").add(psi, given);
}

int main() {
  const GC::Shape_parameters<FT> shape(1, 1);
  const Blend c2 = GC::blend(phi, psi, GC::Matching_second_derivative(), shape),
              least = GC::blend(phi, psi, GC::Minimal_second_derivative(), shape),
              near = GC::blend(phi, psi, GC::Near_line(), shape);
  GC::Svg_panel second = construction_of("2: |\u03b3\u2033| is least where C projects to A + 2 AB", least),
                third = construction_of("3: C nearest to the line through B\u2081 and B\u2082", near);
  const Point twice = least.control_point(0) + FT(2) * (least.control_point(1) - least.control_point(0));
  second.add(Curve{least.control_point(2), twice}, construction);
  mark(second, twice, "A + 2 AB");
  third.add(Curve{near.control_point(1), near.control_point(4)}, construction);
  mark(third, near.control_point(4), "B\u2082");

  GC::Svg_figure figure("Portnov's figures", 3);
  figure.add(construction_of("1: C lies on the line l, parallel to AB", c2)).add(second).add(third);
  figure.add(blend_of("4: equal second derivatives", c2)).add(blend_of("5: least second derivatives", least));
  figure.add(blend_of("6: C\u2081, C\u2082 near the line B\u2081B\u2082", near));
  std::ofstream("portnov_figures.svg") << figure;
  std::cout << figure.number_of_panels() << " figures, " << (proved ? "all joins are G2" : "a join is not G2") << '\n';
  return proved ? 0 : 1;
}
