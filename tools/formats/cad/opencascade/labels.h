// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_LABELS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_LABELS_H

#include "formats/cad/Cad_model.h"

#include <TopoDS_Shape.hxx>
#include <TopoDS_TShape.hxx>
#include <XSControl_Reader.hxx>

#include <map>
#include <string>
#include <utility>
#include <vector>

// The labels that a file gives faces, wherever they are placed, the ids of its edges, and the names
// of the parts of an assembly.
struct Shape_labels {
  std::map<const TopoDS_TShape*, Cad_label> faces;
  std::map<const TopoDS_TShape*, std::string> edges;
  // as they are placed in what they are parts of
  std::vector<std::pair<TopoDS_Shape, std::string>> parts;
};

// Returns the labels of what has been translated.
Shape_labels read_labels(XSControl_Reader& reader);

// Adds labels and instances to the model of a shape.
void add_labels(const TopoDS_Shape& shape, const Shape_labels& labels, Cad_model& model);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_LABELS_H
