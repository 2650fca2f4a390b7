// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Fills a gap between two patches that has a neighbour on one side: the blend is G2 with both
// patches, and G1 with the neighbour, whose edge and cross derivative it keeps. A side that does
// not fit is refused, with the corner and the condition.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>
#include <optional>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational FT;
typedef GC::Traits_3<CGAL::Simple_cartesian<FT>> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_patch<Traits> Patch;
typedef GC::Side_of_blend<Patch, Patch> Side;
using GC::Patch_edge;

// Two sheets of one height, and a neighbour that joins both of their corners and rises beyond.
const Patch left({{Point(0, 0, 0), Point(0, 4, 0)}, {Point(8, 0, 0), Point(8, 4, 0)}}),
    right({{Point(0, 12, 0), Point(0, 16, 0)}, {Point(8, 12, 0), Point(8, 16, 0)}}),
    neighbour({{Point(-8, 4, 4), Point(-8, 8, 6), Point(-8, 12, 4)},
               {Point(-4, 4, 0), Point(-4, 8, 0), Point(-4, 12, 0)},
               {Point(0, 4, 0), Point(0, 8, 0), Point(0, 12, 0)}});

Patch blend_with(const Side& side) {
  const auto shape =
      GC::surface_shape_with_sides(left, Patch_edge::v1, right, Patch_edge::v0, GC::Edge_direction::same,
                                   GC::automatic_surface_shape(left, Patch_edge::v1, right, Patch_edge::v0,
                                                               GC::Minimal_energy<3>(), GC::Edge_direction::same),
                                   std::optional<Side>(side), std::optional<Side>());
  std::cout << "beta at the left patch: " << shape.start.beta << '\n';
  return GC::blend(left, Patch_edge::v1, right, Patch_edge::v0, shape);
}

int main() {
  const Patch s = blend_with(Side(neighbour, Patch_edge::u1));
  const auto with_left = edge_continuity(left, Patch_edge::v1, s, Patch_edge::v0),
             with_right = edge_continuity(s, Patch_edge::v1, right, Patch_edge::v0);
  std::cout << "degree " << s.degree_u() << " x " << s.degree_v() << ": " << with_left << " with the left patch, "
            << with_right << " with the right one\n";
  // the blend has the edge of the neighbour in degree 5
  const auto with_neighbour = edge_continuity(s, Patch_edge::u0, neighbour, Patch_edge::u1);
  std::cout << with_neighbour << " with the neighbour\n";
  try {
    blend_with(Side(GC::Bezier_curve<Traits>{Point(0, 4, 0), Point(0, 8, 1), Point(0, 12, 0)}));
    return 1;
  } catch (const GC::Error& error) {
    std::cout << error.what() << '\n';
  }
  return with_left.g_order == 2 && with_right.g_order == 2 && with_neighbour.g_order >= 1 ? 0 : 1;
}
