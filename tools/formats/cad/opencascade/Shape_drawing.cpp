// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/Shape_drawing.h"

#include "formats/cad/opencascade/read_model.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <ShapeFix_Face.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <array>
#include <cmath>
#include <cstddef>

namespace {

// How far triangles are from their face, in parts of the extent of the shape, and how far their normals turn, in radians.
constexpr double drawn_distance = 1e-3, drawn_angle = 0.2;

GC::Given_point<3> node(const Poly_Triangulation& triangles, int i, const TopLoc_Location& location) {
  const gp_Pnt p = triangles.Node(i).Transformed(location.Transformation());
  return {p.X(), p.Y(), p.Z()};
}

// So many segments are drawn of a curve.
constexpr int drawn_segments = 24;

std::vector<GC::Given_point<3>> curve_points(const TopoDS_Edge& edge) {
  const BRepAdaptor_Curve curve(edge);
  const int n = curve.GetType() == GeomAbs_Line ? 1 : drawn_segments;
  const double begin = curve.FirstParameter(), end = curve.LastParameter();
  if (!is_finite(begin, end)) return {};
  std::vector<GC::Given_point<3>> result;
  for (int i = 0; i <= n; ++i) {
    const gp_Pnt p = curve.Value(i == n ? end : begin + (end - begin) * i / n);
    result.push_back({p.X(), p.Y(), p.Z()});
  }
  return result;
}

// Whether the edges of a face have finite parameters, and the face a finite extent; includes it in a box then.
bool include(const TopoDS_Shape& face, Bnd_Box& all) {
  for (TopExp_Explorer i(face, TopAbs_EDGE); i.More(); i.Next()) {
    double begin, end;
    BRep_Tool::Range(TopoDS::Edge(i.Current()), begin, end);
    if (!is_finite(begin, end)) return false;
  }
  Bnd_Box box;
  BRepBndLib::Add(face, box);
  if (box.IsVoid() || box.IsOpen() || !(box.SquareExtent() < infinite * infinite)) return false;
  all.Add(box);
  return true;
}

void append_triangles(const TopoDS_Face& face, Cad_mesh& mesh) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, location);
  if (triangles.IsNull()) return;
  const std::size_t before = mesh.points.size();
  for (int i = 1; i <= triangles->NbNodes(); ++i) mesh.points.push_back(node(*triangles, i, location));
  for (int i = 1; i <= triangles->NbTriangles(); ++i) {
    std::array<int, 3> numbers; // from 1 on
    triangles->Triangle(i).Get(numbers[0], numbers[1], numbers[2]);
    std::array<std::size_t, 3>& triangle = mesh.triangles.emplace_back();
    for (std::size_t j = 0; j < 3; ++j) triangle[j] = before + static_cast<std::size_t>(numbers[j] - 1);
  }
}

// A copy of a face with its boundary repaired, e.g. moved by periods of its surface.
TopoDS_Shape healed(const TopoDS_Face& face) {
  ShapeFix_Face fix(TopoDS::Face(BRepBuilderAPI_Copy(face).Shape()));
  fix.Perform();
  return fix.Result();
}

} // namespace

Shape_drawing::Shape_drawing(const TopoDS_Shape& shape) {
  try {
    BRep_Builder builder;
    TopoDS_Compound finite;
    builder.MakeCompound(finite);
    Bnd_Box all;
    for (TopExp_Explorer i(shape, TopAbs_FACE); i.More(); i.Next())
      if (include(i.Current(), all)) builder.Add(finite, i.Current());
    if (all.IsVoid()) return;
    distance_ = drawn_distance * std::sqrt(all.SquareExtent());
    BRepMesh_IncrementalMesh(finite, distance_, false, drawn_angle);
  } catch (const Standard_Failure&) { // what has been divided until now is drawn
  }
}

Cad_mesh Shape_drawing::mesh(const TopoDS_Face& face) const {
  Cad_mesh result;
  append_triangles(face, result);
  if (!result.triangles.empty()) return result;
  try {
    Bnd_Box box;
    if (!include(face, box) || BRep_Tool::Surface(face).IsNull()) return result;
    const TopoDS_Shape copy = healed(face);
    BRepMesh_IncrementalMesh(copy, distance_, false, drawn_angle);
    for (TopExp_Explorer i(copy, TopAbs_FACE); i.More(); i.Next()) append_triangles(TopoDS::Face(i.Current()), result);
  } catch (const Standard_Failure&) { // it cannot be drawn
  }
  return result;
}

std::vector<GC::Given_point<3>> Shape_drawing::points(const TopoDS_Edge& edge) {
  if (BRep_Tool::Degenerated(edge)) return {};
  try {
    TopLoc_Location location;
    Handle(Poly_PolygonOnTriangulation) polygon;
    Handle(Poly_Triangulation) triangles;
    BRep_Tool::PolygonOnTriangulation(edge, polygon, triangles, location);
    if (polygon.IsNull() || triangles.IsNull()) return curve_points(edge);
    std::vector<GC::Given_point<3>> result;
    for (int i = 1; i <= polygon->NbNodes(); ++i) result.push_back(node(*triangles, polygon->Node(i), location));
    return result;
  } catch (const Standard_Failure&) { // it cannot be drawn
    return {};
  }
}
