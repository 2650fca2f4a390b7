// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Splines of fair quintics through points, beside cubic splines: their curvature varies less, and
// their joins are exactly G2, with floating-point numbers and a given tangent, too. Writes the
// picture interpolate_fair.svg.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity.h>
#include <Geometric_continuity_figures/Svg_figure.h>

#include <fstream>
#include <iostream>
#include <optional>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_2<CGAL::Exact_predicates_inexact_constructions_kernel> Traits;
typedef Traits::Point Point;
typedef Traits::Vector Vector;

int main() {
  const std::vector<Point> points = {Point(0, 0), Point(4, 3), Point(9, 3), Point(9, -1), Point(2, -2)};
  const std::vector<std::optional<Vector>> free(points.size()),
      one_given = {std::nullopt, std::nullopt, Vector(1, -1), std::nullopt, std::nullopt};
  const GC::Svg_style cubic_style{GC::Svg_role::given, false, false, "cubic"},
      fair_style{GC::Svg_role::result, false, true, "fair"};
  GC::Svg_figure figure("Through five points", 2);
  bool as_expected = true;
  for (const GC::Closure closure : {GC::Closure::open, GC::Closure::closed}) {
    const auto cubic = GC::interpolate<Traits>(points.begin(), points.end(), GC::Parametrisation::centripetal, closure);
    GC::Svg_panel panel(to_string(closure));
    for (const auto& piece : cubic.bezier_pieces()) panel.add(piece, cubic_style);
    for (const auto& tangents : {free, one_given}) {
      const auto curve = GC::interpolate_fair<Traits>(points.begin(), points.end(), closure, tangents);
      int smooth = 0;
      for (const auto& join : curve.joins()) // decided exactly on the coordinates
        smooth += continuity(curve.segment(join.left), curve.segment(join.right), 2).g_order >= 2 ? 1 : 0;
      const bool fairer = GC::fairness(curve) < GC::fairness(cubic);
      std::cout << to_string(closure) << (tangents[2] ? ", one tangent given: " : ", tangents free: ") << smooth
                << " of " << curve.number_of_joins() << " joins are G2, the curvature varies "
                << (fairer ? "less" : "not less") << " than that of the cubic spline\n";
      as_expected = as_expected && smooth == curve.number_of_joins() && fairer && curve.moved == 0;
      if (!tangents[2])
        for (const auto& piece : curve.segments()) panel.add(piece, fair_style).join();
    }
    figure.add(panel);
  }
  std::ofstream("interpolate_fair.svg") << figure;
  return as_expected ? 0 : 1;
}
