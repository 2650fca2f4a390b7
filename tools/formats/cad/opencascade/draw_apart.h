// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_DRAW_APART_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_DRAW_APART_H

#include "formats/cad/Cad_model.h"

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Face.hxx>

#include <vector>

// The seconds of processor time that the drawing may take.
struct Drawing_limits {
  double face; // each of them
  double all;
};

// The drawing of a model: the triangles of each face, or the reason why there are none, and the
// points of each edge.
struct Model_drawing {
  std::vector<Cad_mesh> meshes;
  std::vector<std::vector<GC::Cad_point<3>>> edges;
};

// Draws faces in a process apart, which divides all of them together. If OpenCASCADE crashes, or
// does not come to an end in half of the time, a new process draws them one after the other; a face
// that ends that process is left out, and another one goes on behind it. Edges are numbered from 1
// on.
Model_drawing draw_apart(const std::vector<TopoDS_Face>& faces, const TopTools_IndexedMapOfShape& edges,
                         const Drawing_limits& limits);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_DRAW_APART_H
