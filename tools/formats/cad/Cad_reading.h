// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_READING_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_READING_H

#include <optional>

// The parts of a CAD file that are read besides the geometry that decides.
enum class Cad_drawing { none, faces_and_edges };

// How a file is read.
struct Cad_reading {
  Cad_drawing drawing = Cad_drawing::none;
  // boundary edges of two faces that are so near to each other become one, in mm
  std::optional<double> sewing;
  double time_limit = 60; // seconds
  // boundary edges that are so near to each other, in mm, would be edges of two sides if they
  // were joined
  double gap = 0;
  // knot lines are those where a surface need not be continuously differentiable so many times
  int order = 1;
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_READING_H
