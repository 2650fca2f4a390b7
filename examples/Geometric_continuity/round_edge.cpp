// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// A quarter of a cylinder stands on a plane. The edge in which they meet, an arc, is rounded: G2
// with both along the whole new edges.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/models/round_edges.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational FT;
typedef GC::Traits_3<CGAL::Simple_cartesian<FT>> Traits;
typedef Traits::Point Point;
typedef GC::Rational_bezier_patch<Traits> Patch;
constexpr GC::Patch_edge v0 = GC::Patch_edge::v0, v1 = GC::Patch_edge::v1;

int main() {
  // the axis is the z-axis; u runs along the arc of the radius 1, v upwards or outwards, to the
  // height 4 and the radius 3
  const Patch cylinder(
      {{Point(1, 0, 0), Point(1, 0, 4)}, {Point(1, 1, 0), Point(1, 1, 4)}, {Point(0, 1, 0), Point(0, 1, 4)}},
      {{1, 1}, {1, 1}, {2, 2}});
  const Patch plane(
      {{Point(1, 0, 0), Point(3, 0, 0)}, {Point(1, 1, 0), Point(3, 3, 0)}, {Point(0, 1, 0), Point(0, 3, 0)}},
      {{1, 1}, {1, 1}, {2, 2}});
  std::cout << "before: " << edge_continuity(cylinder, v0, plane, v0) << '\n';

  // the new edges are at the height 1 and at the distance 1
  const FT up = set_back_parameter(cylinder, v0, 1), out = set_back_parameter(plane, v0, 1);
  const auto rounded = GC::round_edge(cylinder, v0, plane, v0, up, out);
  const auto above = edge_continuity(rounded.first, v0, rounded.blend, v0),
             below = edge_continuity(rounded.blend, v1, rounded.second, v0);
  std::cout << "trimmed back by " << up << " and " << out << " in the parameters\n"
            << "after: " << above << " with the cylinder, " << below << " with the plane\n"
            << "the blend has the degree " << rounded.blend.degree_u() << " x " << rounded.blend.degree_v()
            << (rounded.fold ? " and may be folded\n" : " and is not folded\n");
  return above.g_order == 2 && below.g_order == 2 && !rounded.fold ? 0 : 1;
}
