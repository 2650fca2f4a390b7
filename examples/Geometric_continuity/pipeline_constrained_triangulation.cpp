// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Triangulates the area inside an outline of curves with a hole: polylines become constraints of a
// triangulation, and a flood fill from outside tells which triangles are inside.
// (Constrained_Delaunay_triangulation_2 is under the GPL.)

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/polyline.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <optional>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_2 Point;
// The information of a face is the number of outlines around it.
typedef CGAL::Triangulation_face_base_with_info_2<std::optional<int>, Kernel> Face_base;
typedef CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>,
                                             CGAL::Constrained_triangulation_face_base_2<Kernel, Face_base>>
    Data_structure;
typedef CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data_structure> Triangulation;

// Gives the depth to all faces that are reached from this one without crossing a constraint, and
// collects the constraints.
void mark(Triangulation::Face_handle face, int depth, std::vector<Triangulation::Edge>& border) {
  std::vector<Triangulation::Face_handle> stack{face};
  while (!stack.empty()) {
    face = stack.back();
    stack.pop_back();
    if (face->info()) continue;
    face->info() = depth;
    for (int i = 0; i < 3; ++i) {
      if (face->is_constrained(i))
        border.emplace_back(face, i);
      else
        stack.push_back(face->neighbor(i));
    }
  }
}

int main() {
  typedef GC::Composite_bezier_curve<GC::Traits_2<Kernel>> Curve;
  // The parabolas y = 4 - x^2 and y = x^2 - 4 bound the area, y = 1 - x^2 and y = x^2 - 1 bound the
  // hole.
  const std::vector<Point> outer{{-2, 0}, {0, 8}, {2, 0}, {0, -8}, {-2, 0}},
      inner{{-1, 0}, {0, 2}, {1, 0}, {0, -2}, {-1, 0}};
  Triangulation triangulation;
  for (const std::vector<Point>& polygon : {outer, inner}) {
    std::vector<Point> points;
    GC::chord_polyline(Curve(polygon.begin(), polygon.end(), {0, 1, 2}), 1e-4, std::back_inserter(points));
    triangulation.insert_constraint(points.begin(), points.end());
  }
  std::vector<Triangulation::Edge> border;
  mark(triangulation.infinite_face(), 0, border);
  for (std::size_t i = 0; i < border.size(); ++i) { // border grows meanwhile
    const Triangulation::Edge e = border[i];
    mark(e.first->neighbor(e.second), *e.first->info() + 1, border);
  }
  double area = 0;
  for (Triangulation::Face_handle face : triangulation.finite_face_handles())
    if (*face->info() == 1) area += triangulation.triangle(face).area();
  std::cout << std::setprecision(4) << "area of the triangles inside: " << area << ", of the curves: " << 56 / 3.
            << '\n';
  return std::abs(area - 56 / 3.) < 25 * 1e-4 ? 0 : 1; // all curves together are shorter than 25
}
