// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_PLANAR_SOLID_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_PLANAR_SOLID_H

#include "formats/cad/Planar_solid.h"
#include "formats/cad/opencascade/read_model.h"

// Returns the faces of a file. Throws std::runtime_error, with the face and the edge, for a surface
// that is no plane, and an edge that is not straight.
Planar_solid planar_solid(const Shape_of_file& file);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_PLANAR_SOLID_H
