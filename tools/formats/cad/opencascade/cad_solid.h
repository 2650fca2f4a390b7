// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_CAD_SOLID_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_CAD_SOLID_H

#include "formats/cad/Cad_solid.h"
#include "formats/cad/opencascade/read_model.h"

// Returns the faces of a file. Throws std::runtime_error, with the face or the edge, for a surface
// that is neither a plane nor a wall, and a curve that is neither a line, a conic nor a spline.
Cad_solid cad_solid(const Shape_of_file& file);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_CAD_SOLID_H
