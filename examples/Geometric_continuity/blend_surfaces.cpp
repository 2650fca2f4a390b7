// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Leads from a quarter of a cylinder down to a plane, by surfaces that are G2 with both along the
// whole edges: with a shape that is chosen, and with functions along the edges. What is proved is
// proved of the control points as they are: when one of them moves by a billionth, the order falls.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational FT;
typedef GC::Traits_3<CGAL::Simple_cartesian<FT>> Traits;
typedef Traits::Point Point;
typedef GC::Rational_bezier_patch<Traits> Patch;
using GC::Patch_edge;

// Prints the continuity along both edges, and returns whether both are G2.
bool prove(const Patch& cylinder, const Patch& blend, const Patch& plane) {
  const auto start = edge_continuity(cylinder, Patch_edge::u1, blend, Patch_edge::v0),
             end = edge_continuity(blend, Patch_edge::v1, plane, Patch_edge::u0);
  std::cout << "degree " << blend.degree_u() << " x " << blend.degree_v() << ": " << start << " with the cylinder, "
            << end << " with the plane\n";
  return start.g_order == 2 && end.g_order == 2;
}

// Moves the control point b_12 by a billionth.
Patch moved(const Patch& s) {
  std::vector<std::vector<Point>> net(s.number_of_points_u());
  std::vector<std::vector<FT>> weights(s.number_of_points_u());
  for (int i = 0; i < s.number_of_points_u(); ++i)
    for (int j = 0; j < s.number_of_points_v(); ++j) {
      const Point p = s.control_point(i, j);
      net[i].push_back(i == 1 && j == 2 ? Point(p.x() + FT(1) / FT(1000000000), p.y(), p.z()) : p);
      weights[i].push_back(s.weight(i, j));
    }
  return Patch(net, weights);
}

int main() {
  // the axis is the y-axis, the radius 1; the edge u = 1 is the line x = 1, z = 0
  const Patch cylinder(
      {{Point(0, 0, 1), Point(0, 4, 1)}, {Point(1, 0, 1), Point(1, 4, 1)}, {Point(1, 0, 0), Point(1, 4, 0)}},
      {{1, 1}, {1, 1}, {2, 2}});
  const Patch plane =
      GC::Bezier_patch<Traits>({{Point(3, 0, -2), Point(3, 4, -2)}, {Point(5, 0, -2), Point(5, 4, -2)}});

  const auto shape = GC::automatic_surface_shape(cylinder, Patch_edge::u1, plane, Patch_edge::u0,
                                                 GC::Minimal_energy<3>(), GC::Edge_direction::same);
  std::cout << "beta = " << shape.start.beta << ", delta = " << shape.start.delta
            << " at the cylinder; beta = " << shape.end.beta << ", delta = " << shape.end.delta << " at the plane\n";
  const Patch blend = GC::blend(cylinder, Patch_edge::u1, plane, Patch_edge::u0, shape);
  bool as_expected = prove(cylinder, blend, plane);

  // longer and longer tangents at the cylinder, a blend that leans to one side at the plane
  GC::Rational_surface_blend_shape<FT> functions = shape;
  functions.start.beta = {FT(1), FT(3)};
  functions.end.alpha = {FT(-1), FT(0), FT(2)};
  as_expected =
      prove(cylinder, GC::blend(cylinder, Patch_edge::u1, plane, Patch_edge::u0, functions), plane) && as_expected;

  as_expected = !prove(cylinder, moved(blend), plane) && as_expected;
  return as_expected ? 0 : 1;
}
