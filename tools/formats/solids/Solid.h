// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_SOLID_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_SOLID_H

#include <CGAL/Exact_rational.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

// A closed polyhedron over fractions, the faces of which are exactly planar.
struct Solid {
  typedef std::array<CGAL::Exact_rational, 3> Point;
  // Edge i leads from vertex i to the next one. Edges have the numbers by which `verify` names
  // them, where it reads the format. Seen from outside, boundaries of faces run counterclockwise,
  // and those of holes in faces clockwise.
  struct Loop {
    std::vector<std::size_t> vertices, edges;
  };
  struct Face {
    std::vector<Loop> loops;
    std::string name; // the label of the file, e.g. `#17 "top"`, or empty
  };
  std::vector<Point> vertices;
  std::vector<Face> faces;
  // The longest way, rounded, that a vertex has been moved to be exactly in its planes, and its
  // number.
  double largest_move = 0;
  std::size_t most_moved = 0;
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_SOLID_H
