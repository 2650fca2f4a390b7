// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_READ_MODEL_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_READ_MODEL_H

#include "formats/cad/Cad_model.h"
#include "formats/cad/Cad_reading.h"
#include "formats/cad/opencascade/closed_shells.h"
#include "formats/cad/opencascade/labels.h"

#include <TopoDS_Shape.hxx>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

// From here on parameters and lengths count as infinite: for OpenCASCADE from 2e100 on, but it
// counts periods one by one.
constexpr double infinite = 1e9;
inline bool is_finite(double begin, double end) { return std::abs(begin) < infinite && std::abs(end) < infinite; }

// The geometry of a file as it is given, without healing.
struct Shape_of_file {
  TopoDS_Shape shape;
  std::vector<std::string> lost; // what of it could not be translated, each with the reason
  Shape_labels labels;
  std::vector<Closed_shell> closed_shells; // that the file says to be closed
};

// Reads a STEP, IGES or BREP file, by its extension. If it is to be sewn, the curves in space of
// IGES are preferred to those in parameter planes. Throws std::runtime_error with the reason,
// without the name of the file, and what OpenCASCADE throws.
Shape_of_file read_shape(const std::string& file, const Cad_reading& reading);

// Joins boundary edges that are at most `distance` mm apart, and returns how many edges there are
// of two. Surfaces stay as they are; of a joined edge one curve in space remains, and its curves in
// the parameter planes are adapted to that. Appends faces that disappear to what is lost; the
// others keep their labels and shells.
std::size_t sew(Shape_of_file& file, double distance);

// Returns the faces and edges of a shape. Curves in the parameter planes that it lacks are added to
// it: projections of those in space. To be drawn, faces are divided into triangles at the end.
Cad_model cad_model(const TopoDS_Shape& shape, const Cad_reading& reading);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_READ_MODEL_H
