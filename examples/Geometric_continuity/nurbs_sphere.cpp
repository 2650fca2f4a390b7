// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// A sphere of rational patches: all its points lie on it exactly, and along whole edges it is G2,
// but for the poles, where whole edges are single points and the normals of the patches vanish.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/models/tessellate.h>
#include <CGAL/Geometric_continuity/surfaces/elementary_surfaces.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef Traits::FT FT;
typedef Traits::Point Point;
typedef Traits::Vector Vector;

int main() {
  const Point centre(1, 2, 3);
  const GC::Rational_bspline_surface<Traits> sphere =
      GC::ellipsoid(centre, Vector(2, 0, 0), Vector(0, 2, 0), Vector(0, 0, 2));
  const FT u = FT(FT(1) / FT(3)), v = FT(FT(13) / FT(7));
  std::cout << "S(1/3, 13/7) = " << sphere(u, v) << ", squared distance from the centre "
            << (sphere(u, v) - centre).squared_length() << '\n';

  const auto patches = sphere.bezier_patches();
  const auto model = GC::model_continuity(patches);
  std::cout << patches.size() << " patches: " << model.summary << '\n';
  for (const auto& edge : model.edges)
    if (edge.kind == GC::Model_edge_kind::shared) std::cout << edge << '\n';

  const auto mesh = GC::tessellate(patches, GC::Chord_tolerance{0.01});
  bool exact = true;
  for (const Point& p : mesh.points) exact = exact && (p - centre).squared_length() == 4;
  std::cout << mesh.triangles.size() << " triangles, nowhere farther than 0.01 from the sphere"
            << (exact ? "; all corners lie on it exactly" : "") << '\n';
  return model.summary.g2 == 4 && model.summary.vanishing_normals == 8 && exact ? 0 : 1;
}
