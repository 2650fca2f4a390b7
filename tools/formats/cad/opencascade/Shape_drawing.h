// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_SHAPE_DRAWING_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_SHAPE_DRAWING_H

#include "formats/cad/Cad_model.h"

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

// The faces of a shape divided into triangles, which the shape holds then, fine enough to draw it.
class Shape_drawing {
  double distance_ = 0; // how far triangles may be from their face

public:
  explicit Shape_drawing(const TopoDS_Shape& shape);

  // Returns the triangles of a face of the shape. If it cannot be divided, those of a healed copy are taken. A face that is infinite
  // has none.
  Cad_mesh mesh(const TopoDS_Face& face) const;

  // Returns points along an edge: those where the triangles of a face have it, or if there are none, on its curve. None for
  // an edge that is a point or infinite.
  static std::vector<GC::Cad_point<3>> points(const TopoDS_Edge& edge);
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_SHAPE_DRAWING_H
