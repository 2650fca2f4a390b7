// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// A cylinder on a plane, with a fillet between them: surfaces of revolution as rational patches,
// exact along whole edges. The fillet is tangent to both, and not smoother: its curvature across
// the edges is that of its own circle. Then a profile with a G2 blend in place of the circle: now
// every edge is G2. Writes the models fillet.g2 and smooth_fillet.g2, and a picture of each.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/elementary_surfaces.h>
#include <CGAL/Simple_cartesian.h>
#include <Geometric_continuity_figures/svg_surfaces.h>

#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef Traits::FT FT;
typedef Traits::Point Point;
typedef GC::Rational_bezier_curve<Traits> Curve;
typedef GC::Rational_bspline_surface<Traits> Surface;

// The model of profiles that turn about the z-axis; prints what its edges have.
GC::Model_summary revolve(const std::vector<Curve>& profiles, const std::string& name) {
  std::vector<Surface> surfaces;
  for (const Curve& profile : profiles)
    surfaces.push_back(
        GC::full_revolution(GC::Rational_bspline_curve<Traits>(profile), Point(0, 0, 0), Traits::Vector(0, 0, 1)));
  const auto model = GC::model_continuity(surfaces);
  std::cout << name << ": " << model.summary << '\n';
  for (const auto& edge : model.edges)
    if (edge.kind == GC::Model_edge_kind::shared && edge.patch_a != edge.patch_b) std::cout << "  " << edge << '\n';

  std::ofstream g2(name + ".g2");
  for (const Surface& surface : surfaces) GC::write_g2(g2, surface);
  std::ofstream svg(name + ".svg");
  GC::Svg_surface_style style;
  style.title = name;
  GC::write_svg_surfaces(svg, surfaces, style);
  return model.summary;
}

int main() {
  const Curve ring = GC::Bezier_curve<Traits>{Point(4, 0, 0), Point(2, 0, 0)},
              quarter({Point(2, 0, 0), Point(1, 0, 0), Point(1, 0, 1)}, {FT(1), FT(1), FT(2)}),
              wall = GC::Bezier_curve<Traits>{Point(1, 0, 1), Point(1, 0, 3)};
  const GC::Model_summary fillet = revolve({ring, quarter, wall}, "fillet");
  const Curve blend = GC::blend(ring, wall, GC::Fair());
  const GC::Model_summary smooth = revolve({ring, blend, wall}, "smooth_fillet");
  return fillet.g1 == 2 && smooth.g1 == 0 && smooth.g2 == 5 ? 0 : 1;
}
