// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The fundamental theorem of curves: curvature and torsion determine a curve up to its position.
// Here a helix is rebuilt from its two constant curvatures, as a composite Bezier curve with
// continuous curvature, and compared with the formula.

#include <CGAL/Geometric_continuity/curves/curve_from_curvatures.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Traits;
typedef Traits::Point Point;

int main() {
  const double r = 4, h = 3, c = 5; // (r cos t, r sin t, h t) with t = s/c and c^2 = r^2 + h^2
  const std::vector<std::function<double(double)>> curvatures = {[&](double) { return r / (c * c); },
                                                                 [&](double) { return h / (c * c); }};
  // The frame of the helix at t = 0.
  const GC::Curve_jet<Traits> start(Point(r, 0, 0), {Traits::Vector(0, r, h), Traits::Vector(-r, 0, 0)});
  const double length = 40;
  const GC::Integrated_curve<Traits> curve =
      GC::curve_from_curvatures<Traits>(curvatures, start.point(), *GC::frenet_frame(start), length, 1e-12);
  const GC::Composite_bezier_curve<Traits, 5> bezier = curve.bezier_curve();

  double error = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double s = length * i / 1000, t = s / c;
    const Point p = bezier(s), q(r * std::cos(t), r * std::sin(t), h * t);
    error = (std::max)(error, std::sqrt(CGAL::squared_distance(p, q)));
  }
  std::cout << (curve.error_bound < 1e-6 ? "integrated within 1e-6" : "the integration is too coarse") << '\n'
            << (error < 2e-6 ? "the Bezier curve is within 2e-6 of the helix" : "the Bezier curve is off") << '\n';
  return curve.error_bound < 1e-6 && error < 2e-6 ? 0 : 1;
}
