// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_WRITE_SHAPE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_WRITE_SHAPE_H

#include <TopoDS_Shape.hxx>

#include <string>
#include <utility>
#include <vector>

// Faces with names for them, which only STEP holds.
typedef std::vector<std::pair<TopoDS_Shape, std::string>> Named_faces;

// Writes a shape in the format that the ending of the name tells, STEP or BREP, so that the same
// doubles are read. Curves in the parameter planes of faces are written to STEP on demand, and not
// those on planes. Throws std::runtime_error.
void write_shape(const TopoDS_Shape& shape, const std::string& file, bool with_parameter_curves,
                 const Named_faces& names = {});

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_WRITE_SHAPE_H
