// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// One curve and five ways to go on from its end: a corner, a kink, G1, G2, and G3. Writes the
// picture orders_of_continuity.svg, where the curvature combs show what the curves alone hide.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>
#include <Geometric_continuity_figures/Svg_figure.h>

#include <fstream>
#include <iostream>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational Q;
typedef GC::Traits_2<CGAL::Simple_cartesian<Q>> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_curve<Traits> Curve;

// In tenths.
Point point(int x, int y) { return Point(Q(Q(x) / Q(10)), Q(Q(y) / Q(10))); }

int main() {
  const Curve left{point(0, 0), point(10, 10), point(22, 16), point(35, 16)};
  // the cubic goes on
  const Point end = point(35, 16), b1 = point(48, 16), b2 = point(62, 10), b3 = point(76, -4);
  const GC::Svg_style given{GC::Svg_role::given, false, true}, result{GC::Svg_role::result, false, true};
  GC::Svg_figure figure("One curve and five ways to go on", 5);
  int orders = 0;
  const auto add = [&](const char* caption, const Curve& right) {
    const auto join = GC::continuity(left, right);
    std::cout << caption << ": G" << join.g_order << '\n';
    orders = 10 * orders + join.g_order;
    figure.add(GC::Svg_panel(caption).add(left, given).add(right, result));
  };
  add("corner", Curve{end, point(46, 9), b2, b3});
  add("kink", Curve{end, point(48, 15), b2, b3});
  add("G1", Curve{end, b1, point(62, 14), b3});
  add("G2", Curve{end, b1, b2, point(76, 2)});
  add("G3", Curve{end, b1, b2, b3});
  std::ofstream("orders_of_continuity.svg") << figure;
  return orders == 123 ? 0 : 1;
}
