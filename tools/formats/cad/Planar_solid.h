// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_PLANAR_SOLID_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_PLANAR_SOLID_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

// The planes with straight edges that a CAD model consists of, by the doubles of the file. They
// need not be closed. Edges and faces have the numbers by which `verify` names them.
struct Planar_solid {
  // As the file orients it: edge i leads from vertex i to the next one.
  struct Loop {
    std::vector<std::size_t> vertices, edges;
  };
  struct Face {
    std::array<double, 3> point, normal; // of its plane, in either direction
    std::vector<Loop> loops;
    std::string name; // e.g. `#17 "top"`; empty if the file gives it none
  };
  std::vector<std::array<double, 3>> vertices;
  std::vector<Face> faces;
  double tolerance = 0; // the largest one of the vertices, as the file says
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_PLANAR_SOLID_H
