// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_PLACEMENT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_PLACEMENT_H

#include <CGAL/Geometric_continuity/cad/Cad_geometry.h>

#include <TopLoc_Location.hxx>
#include <gp_Trsf.hxx>

#include <cstddef>

// Returns a placement by the numbers that OpenCASCADE holds.
inline CGAL::Geometric_continuity::Cad_placement placement(const TopLoc_Location& location) {
  const gp_Trsf& transformation = location.Transformation();
  CGAL::Geometric_continuity::Cad_placement result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j)
      result[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = transformation.Value(i + 1, j + 1);
  return result;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_PLACEMENT_H
