// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_WIRES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_WIRES_H

#include "formats/cad/Cad_model.h"

#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

// Returns the edges of a shape that no face has, each once, run through in their own directions.
std::vector<TopoDS_Edge> edges_without_face(const TopoDS_Shape& shape);

// Returns the joins of such edges. Ends meet where they have a vertex in common, or are as near as
// `gap`, in mm, or the tolerances of their vertices; where three or more would, none does. An end
// without a partner meets the next one if that is nearer than a hundredth of both curves. Knots
// inside of a curve are joins where it need not be `order` times continuously differentiable.
Cad_wires wires(const std::vector<TopoDS_Edge>& edges, double gap, int order);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_WIRES_H
