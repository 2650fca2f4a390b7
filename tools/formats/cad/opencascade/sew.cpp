// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/read_model.h"

#include <BRepBuilderAPI_Sewing.hxx>
#include <TopExp_Explorer.hxx>

std::size_t sew(TopoDS_Shape& shape, double distance, std::vector<std::string>& lost, Shape_labels& labels) {
  BRepBuilderAPI_Sewing sewing(distance);
  sewing.Add(shape);
  sewing.Perform();
  if (sewing.SewedShape().IsNull()) return 0; // there is no face
  for (TopExp_Explorer i(shape, TopAbs_FACE); i.More(); i.Next())
    if (const auto label = labels.faces.find(i.Current().TShape().get()); label != labels.faces.end()) {
      const Cad_label copy = label->second;
      labels.faces[sewing.ModifiedSubShape(i.Current()).TShape().get()] = copy;
    }
  shape = sewing.SewedShape();
  if (sewing.NbDeletedFaces() > 0)
    lost.push_back("sewing: " + std::to_string(sewing.NbDeletedFaces()) + " of the faces, which are too small");
  return static_cast<std::size_t>(sewing.NbContigousEdges());
}
