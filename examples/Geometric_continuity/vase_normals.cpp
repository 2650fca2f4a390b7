// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Turns a profile of three curves into a vase, and proves that the profile and the vase are smooth.
// The normals of the vase are exact, and the only place without a normal, the bottom on the axis,
// is found.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational FT;
typedef GC::Traits_3<CGAL::Simple_cartesian<FT>> Traits;
typedef Traits::Point Point;
typedef Traits::Vector Vector;
typedef GC::Bezier_curve<Traits> Curve;
typedef GC::Revolution_surface_3<Curve> Surface;

int main() {
  const Point a(0, 0, 0);
  const Vector z(0, 0, 1);
  const Curve belly{Point(0, 0, 0), Point(4, 0, 0), Point(6, 0, 2), Point(5, 0, 5)},
      lip{Point(2, 0, 8), Point(2, 0, 9), Point(3, 0, 10)};
  const Curve neck = GC::blend(belly, lip);
  const std::vector<Curve> profile{belly, neck, lip};

  bool smooth = true;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const auto join = GC::revolution_continuity(profile[i], profile[i + 1], a, z);
    std::cout << "profile G" << GC::continuity(profile[i], profile[i + 1]).g_order << ", vase " << join << '\n';
    smooth = smooth && join.g_order == 2;
  }

  // v = tan(theta/2): v = 1/2 is the point (3/5, 4/5) of the unit circle
  const Surface vase(lip, a, z);
  const FT u(FT(1) / FT(3)), v(FT(1) / FT(2));
  std::cout << "point (" << vase(u, v) << "), normal (" << vase.normal(u, v) << ")\n";
  smooth = smooth && vase.normal(u, v) * vase.jet(u, v, 1).partial(1, 0) == 0;

  for (const Curve& curve : profile)
    for (const auto& defect : GC::sweep_defects(Surface(curve, a, z)).points)
      std::cout << "no normal at the parameter " << defect.begin << (defect.on_axis ? ", on the axis" : "")
                << (defect.smooth_pole ? ", but a tangent plane" : "") << '\n';
  return smooth ? 0 : 1;
}
