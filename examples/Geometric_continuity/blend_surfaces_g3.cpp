// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Leads from one bent patch to another: by a surface of degree 5 across, which is G2 with both
// along the whole edges, and by one of degree 7, which is G3. Both are proved. The picture shows
// the second one: isophotes, which depend on first derivatives, cross the edges with the same
// curvature.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>
#include <CGAL/Geometric_continuity/surfaces/possible_fold.h>
#include <CGAL/Simple_cartesian.h>
#include <Geometric_continuity_figures/svg_surfaces.h>

#include <fstream>
#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational FT;
typedef GC::Traits_3<CGAL::Simple_cartesian<FT>> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_patch<Traits> Patch;
using GC::Patch_edge;

const Patch left({{Point(0, 0, 0), Point(0, 2, 2), Point(0, 4, 3), Point(0, 6, 3)},
                  {Point(3, 0, 1), Point(3, 2, 3), Point(3, 4, 5), Point(3, 6, 4)},
                  {Point(6, 0, 0), Point(6, 2, 1), Point(6, 4, 3), Point(6, 6, 4)}}),
    right({{Point(0, 11, 2), Point(0, 13, 2), Point(0, 15, 4)},
           {Point(3, 11, 1), Point(3, 13, 0), Point(3, 15, 3)},
           {Point(6, 11, 3), Point(6, 13, 2), Point(6, 15, 3)}});

// Is the blend G3 along both edges?
template <class Strategy> bool is_g3(const Strategy& strategy) {
  const Patch s = GC::blend(left, Patch_edge::v1, right, Patch_edge::v0, strategy);
  const bool g2 = is_g2_edge(left, Patch_edge::v1, s, Patch_edge::v0) &&
                  is_g2_edge(s, Patch_edge::v1, right, Patch_edge::v0),
             g3 = is_g3_edge(left, Patch_edge::v1, s, Patch_edge::v0) &&
                  is_g3_edge(s, Patch_edge::v1, right, Patch_edge::v0);
  std::cout << "degree " << s.degree_u() << " x " << s.degree_v() << ": "
            << (g3   ? "G3"
                : g2 ? "G2, not G3"
                     : "not G2")
            << (possible_fold(s) ? ", may be folded\n" : ", not folded\n");
  return g3;
}

int main() {
  const bool as_expected = !is_g3(GC::Minimal_energy<3>()) && is_g3(GC::Minimal_energy_g3<4>()) && is_g3(GC::Fair_g3());
  const std::vector<Patch> surfaces = {left, GC::blend(left, Patch_edge::v1, right, Patch_edge::v0, GC::Fair_g3()),
                                       right};
  std::ofstream picture("blend_surfaces_g3.svg");
  GC::Svg_surface_style style;
  style.azimuth = -30;
  style.elevation = 42;
  GC::write_svg_surfaces(picture, surfaces, style);
  return as_expected ? 0 : 1;
}
