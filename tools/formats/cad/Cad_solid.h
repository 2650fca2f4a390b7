// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_SOLID_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_SOLID_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

// The planes and walls that a CAD model consists of, by the doubles of the file. They need not be
// closed. Edges and faces have the numbers by which `verify` names them.
struct Cad_solid {
  // As the file orients it: edge i leads from vertex i to the next one, against its direction if it
  // is reversed. The edges of a wall may be in any order.
  struct Loop {
    std::vector<std::size_t> vertices, edges;
    std::vector<char> reversed;
  };
  // A plane, or a wall: a cylinder, or a curve that is extruded along a direction.
  struct Face {
    std::array<double, 3> point, normal; // of a plane, in either direction; of a wall its direction
    bool wall;
    bool turned; // the normal of the plane points into the solid
    std::vector<Loop> loops;
    std::string name; // e.g. `#17 "top"`; empty if the file gives it none
    std::string kind; // e.g. "cylinder"
  };
  // A straight edge has no control points. An arc of a circle has none either, but a radius, a
  // centre and an axis, about which it runs counterclockwise by an angle.
  struct Edge {
    std::array<std::size_t, 2> ends; // the vertices, in its direction
    std::string kind;                // e.g. "circle"; "line" if it is straight
    double radius, angle;            // 0 if it is no circle
    std::array<double, 3> centre, axis;
    int degree;
    std::vector<double> knots; // each as often as its multiplicity
    std::vector<std::array<double, 3>> points;
    std::vector<double> weights; // none if it is not rational
  };
  std::vector<std::array<double, 3>> vertices;
  std::vector<Edge> edges;
  std::vector<Face> faces;
  double tolerance = 0; // the largest one of the vertices, as the file says

  bool is_polyhedron() const {
    for (const Face& f : faces)
      if (f.wall) return false;
    for (const Edge& e : edges)
      if (e.kind != "line") return false;
    return true;
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_SOLID_H
