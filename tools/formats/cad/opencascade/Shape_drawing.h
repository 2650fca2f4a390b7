// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_SHAPE_DRAWING_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_SHAPE_DRAWING_H

#include "formats/cad/Cad_model.h"

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_TShape.hxx>

#include <set>
#include <vector>

// Divides faces into triangles, which these hold then, fine enough to draw all of them in one
// picture.
class Shape_drawing {
  double distance_ = 0;                    // how far triangles may be from their face
  std::set<const TopoDS_TShape*> divided_; // faces, wherever they are placed

  void divide(const TopoDS_Face& face);

public:
  explicit Shape_drawing(const std::vector<TopoDS_Face>& faces);

  // Divides all of the faces at once, so that triangles on both sides of an edge have the same
  // points there. OpenCASCADE may not come to an end, nor with a single face, see draw_apart().
  void divide_together(const std::vector<TopoDS_Face>& faces);

  // Returns the triangles of one of the faces, which is divided now unless it has been. If it
  // cannot be divided, those of a healed copy are taken. A face that is infinite has none.
  Cad_mesh mesh(const TopoDS_Face& face);

  // Returns points along an edge: those where the triangles of a face have it, or if there are
  // none, on its curve. None for an edge that is a point or infinite.
  static std::vector<GC::Cad_point<3>> points(const TopoDS_Edge& edge);
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_SHAPE_DRAWING_H
