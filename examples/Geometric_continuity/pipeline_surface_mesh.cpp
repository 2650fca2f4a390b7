// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Turns a G1 ribbon along a curve into a Surface_mesh, which the package Polygon_mesh_processing of
// CGAL orients, checks for self-intersections and remeshes. (Surface_mesh and most of
// Polygon_mesh_processing are under the GPL.)

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/models/tessellate.h>
#include <CGAL/Geometric_continuity/surface_blends/connect_g1.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef GC::Traits_3<Kernel> Traits;
typedef GC::Bezier_curve<Traits> Curve;
typedef GC::Bspline_curve<Traits> Spline;
typedef CGAL::Surface_mesh<Point> Mesh;

const char* intersections(const Mesh& mesh) {
  return PMP::does_self_intersect(mesh) ? "intersects itself" : "does not intersect itself";
}

int main() {
  const Curve middle{Point(0, 0, 0), Point(2, 0, 1), Point(4, 0, 1), Point(6, 0, 0)};
  const Curve left{Point(0, 2, -1), Point(2, 2, 1), Point(4, 3, 1), Point(6, 3, 0)};
  const Curve right{Point(0, -2, 1), Point(2, -3, 1), Point(4, -2, 1), Point(6, -2, 0)};
  const GC::G1_ribbon<Traits> ribbon = GC::connect_g1(Spline(middle), Spline(left), Spline(right));

  GC::Tessellation<Traits> triangles =
      GC::tessellate(std::vector{ribbon.side1, ribbon.side2}, GC::Chord_tolerance{0.01});
  // Both sides start at the curve, so that one of them is upside down.
  PMP::orient_polygon_soup(triangles.points, triangles.triangles);
  Mesh mesh;
  GC::to_face_graph(triangles, mesh);
  const double area = PMP::area(mesh);
  std::cout << mesh.number_of_faces() << " triangles, " << intersections(mesh) << '\n';

  PMP::isotropic_remeshing(mesh.faces(), 0.5, mesh);
  const int euler = int(mesh.number_of_vertices()) - int(mesh.number_of_edges()) + int(mesh.number_of_faces());
  const bool same_area = std::abs(PMP::area(mesh) - area) < 0.01 * area;
  std::cout << "remeshed: Euler characteristic " << euler << ", " << intersections(mesh) << ", area "
            << (same_area ? "kept" : "changed") << '\n';
  return euler == 1 && same_area ? 0 : 1;
}
