// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BENCHMARK_SAMPLED_CONTINUITY_H
#define GEOMETRIC_CONTINUITY_BENCHMARK_SAMPLED_CONTINUITY_H

#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <optional>
#include <vector>

// An edge and the faces of both its sides, which for a seam are the same.
struct Sampled_edge {
  TopoDS_Edge edge;
  TopoDS_Face faces[2];
};

// Returns, for each edge of a shape that a face has, the edge and its faces if there are two sides:
// in the order of cad_model().
inline std::vector<std::optional<Sampled_edge>> sampled_edges(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  std::vector<std::optional<Sampled_edge>> result;
  for (int i = 1; i <= faces.Extent(); ++i) {
    if (faces(i).IsEmpty()) continue;
    const TopoDS_Edge edge = TopoDS::Edge(faces.FindKey(i));
    const TopoDS_Face a = TopoDS::Face(faces(i).First()), b = TopoDS::Face(faces(i).Last());
    result.emplace_back();
    if (faces(i).Extent() == 2 || (faces(i).Extent() == 1 && BRep_Tool::IsClosed(edge, a)))
      result.back() = Sampled_edge{edge, {a, b}};
  }
  return result;
}

// The verdict of OpenCASCADE on an edge: whether the tangent planes agree within an angle at 21
// parameters, of which the first and the last one leave out a hundredth of the edge.
inline bool is_sampled_g1(const Sampled_edge& e, double angle) {
  try {
    return BRepLib::ContinuityOfFaces(e.edge, e.faces[0], e.faces[1], angle) != GeomAbs_C0;
  } catch (const Standard_Failure&) { // where it finds no normal
    return false;
  }
}

#endif // GEOMETRIC_CONTINUITY_BENCHMARK_SAMPLED_CONTINUITY_H
