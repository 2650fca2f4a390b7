// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/read_model.h"

#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

namespace {

// Where edges have no curves in parameter planes, sewing says that their ranges differ.
void mark_equal_ranges(const TopoDS_Shape& shape) {
  for (TopExp_Explorer i(shape, TopAbs_EDGE); i.More(); i.Next())
    if (const TopoDS_Edge& edge = TopoDS::Edge(i.Current()); !BRep_Tool::SameRange(edge)) BRepLib::SameRange(edge);
}

// Puts what sewing has made of them in the place of faces.
void replace_faces(const BRepBuilderAPI_Sewing& sewing, Shape_of_file& file) {
  for (TopExp_Explorer i(file.shape, TopAbs_FACE); i.More(); i.Next())
    if (const auto label = file.labels.faces.find(i.Current().TShape().get()); label != file.labels.faces.end()) {
      const Cad_label copy = label->second;
      file.labels.faces[sewing.ModifiedSubShape(i.Current()).TShape().get()] = copy;
    }
  for (Closed_shell& shell : file.closed_shells)
    for (TopoDS_Shape& face : shell.faces) face = sewing.ModifiedSubShape(face);
}

} // namespace

std::size_t sew(Shape_of_file& file, double distance) {
  // what lies beside an edge that one round has sewn can be left to the next one
  constexpr int most_rounds = 5;
  std::size_t sewn = 0;
  for (int round = 0, free = 0; round < most_rounds; ++round) {
    BRepBuilderAPI_Sewing sewing(distance);
    sewing.Add(file.shape);
    sewing.Perform();
    if (sewing.SewedShape().IsNull()) break; // there is no face
    replace_faces(sewing, file);
    file.shape = sewing.SewedShape();
    if (sewing.NbDeletedFaces() > 0)
      file.lost.push_back("sewing: " + std::to_string(sewing.NbDeletedFaces()) + " of the faces, which are too small");
    sewn += static_cast<std::size_t>(sewing.NbContigousEdges());
    if (sewing.NbFreeEdges() == 0 || (round > 0 && sewing.NbFreeEdges() == free)) break;
    free = sewing.NbFreeEdges();
  }
  mark_equal_ranges(file.shape);
  return sewn;
}
