// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_OPEN_BOUNDARIES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_OPEN_BOUNDARIES_H

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <cstddef>
#include <optional>
#include <vector>

// An edge that only one face has.
struct Boundary_edge {
  TopoDS_Edge edge;
  TopoDS_Face face;
};

// Returns for each of these edges another one beside which it lies: along a part of one of them
// they are no farther apart than the gap, or than the tolerances of the edges. Edges that only meet
// at their ends, and both long sides of a narrow face, do not lie beside each other. Samples are
// compared.
std::vector<std::optional<std::size_t>> edges_beside(const std::vector<Boundary_edge>& edges, double gap);

// Returns whether the boundary of a face does not close.
bool is_boundary_open(const TopoDS_Face& face);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_OPEN_BOUNDARIES_H
