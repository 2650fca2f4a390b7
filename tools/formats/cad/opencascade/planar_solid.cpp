// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/planar_solid.h"

#include "formats/cad/opencascade/cad_surface.h"
#include "formats/cad/opencascade/spline_numbers.h"

#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

bool is_straight(const Handle(Geom_Curve) & curve) {
  const Standard_Transient* const c = curve.get();
  if (const auto* trimmed = dynamic_cast<const Geom_TrimmedCurve*>(c)) return is_straight(trimmed->BasisCurve());
  if (const auto* spline = dynamic_cast<const Geom_BSplineCurve*>(c)) return spline->NbPoles() == 2;
  if (const auto* bezier = dynamic_cast<const Geom_BezierCurve*>(c)) return bezier->NbPoles() == 2;
  return dynamic_cast<const Geom_Line*>(c) != nullptr;
}

std::string curve_name(const Handle(Geom_Curve) & curve) {
  std::string name = curve->DynamicType()->Name();
  name.erase(0, name.find('_') + 1);
  return name;
}

Handle(Geom_Plane) plane_of(const Handle(Geom_Surface) & surface) {
  if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface); !trimmed.IsNull())
    return plane_of(trimmed->BasisSurface());
  return Handle(Geom_Plane)::DownCast(surface);
}

class Solid_reader {
  const Shape_of_file& file_;
  TopTools_IndexedMapOfShape faces_, edges_, vertices_; // numbered from 1 on
  Planar_solid result_;

  static std::size_t index(const TopTools_IndexedMapOfShape& map, const TopoDS_Shape& shape) {
    return static_cast<std::size_t>(map.FindIndex(shape) - 1);
  }

  std::string label(const TopoDS_Shape& face) const {
    const auto found = file_.labels.faces.find(face.TShape().get());
    if (found == file_.labels.faces.end()) return "";
    const Cad_label& label = found->second;
    return label.id + (label.name.empty() ? "" : (label.id.empty() ? "\"" : " \"") + label.name + '"');
  }
  [[noreturn]] void fail(std::size_t face, const std::string& reason) const {
    const std::string label = this->label(faces_(static_cast<int>(face) + 1));
    throw std::runtime_error("face " + std::to_string(face) + (label.empty() ? "" : " (" + label + ")") + ": " +
                             reason);
  }

  void add_face(std::size_t number) {
    const TopoDS_Face face = TopoDS::Face(faces_(static_cast<int>(number) + 1));
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    if (surface.IsNull()) fail(number, "triangles, not a plane");
    const Handle(Geom_Plane) plane = plane_of(surface);
    if (plane.IsNull()) fail(number, surface_name(surface) + ", not a plane: only edges between planes are rounded");
    Planar_solid::Face result;
    const gp_Ax3& axes = plane->Position();
    result.point = checked(axes.Location().XYZ());
    result.normal = checked(axes.Direction().XYZ());
    result.name = label(face);
    add_loops(number, steps(number, face), result);
    result_.faces.push_back(std::move(result));
  }

  // An edge on its way round a face, to the vertex where the next one begins.
  struct Step {
    std::size_t edge, next;
  };
  typedef std::map<std::size_t, Step> Steps; // by the vertices where they begin

  Steps steps(std::size_t number, const TopoDS_Face& face) const {
    Steps result;
    for (TopExp_Explorer i(face, TopAbs_EDGE); i.More(); i.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(i.Current());
      const std::size_t e = index(edges_, edge);
      const std::string name = "edge " + std::to_string(e) + ' ';
      if (BRep_Tool::Degenerated(edge)) fail(number, name + "is said to be a point");
      double begin, end;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, begin, end);
      if (curve.IsNull()) fail(number, name + "has no curve in space");
      if (!is_straight(curve)) fail(number, name + "is no line, but a " + curve_name(curve));
      const TopoDS_Vertex from = TopExp::FirstVertex(edge, true), to = TopExp::LastVertex(edge, true);
      if (from.IsNull() || to.IsNull()) fail(number, name + "has no end");
      if (!result.emplace(index(vertices_, from), Step{e, index(vertices_, to)}).second)
        fail(number, "its boundary passes a vertex of edge " + std::to_string(e) + " twice");
    }
    return result;
  }

  void add_loops(std::size_t number, Steps steps, Planar_solid::Face& result) const {
    while (!steps.empty()) {
      const std::size_t first = steps.begin()->first;
      Planar_solid::Loop& loop = result.loops.emplace_back();
      std::size_t v = first;
      do {
        const auto step = steps.find(v);
        if (step == steps.end()) fail(number, "its boundary does not close");
        loop.vertices.push_back(v);
        loop.edges.push_back(step->second.edge);
        v = step->second.next;
        steps.erase(step);
      } while (v != first);
    }
  }

public:
  explicit Solid_reader(const Shape_of_file& file) : file_(file) {
    TopExp::MapShapes(file.shape, TopAbs_FACE, faces_);
    TopExp::MapShapes(file.shape, TopAbs_EDGE, edges_);
    TopExp::MapShapes(file.shape, TopAbs_VERTEX, vertices_);
  }

  Planar_solid read() {
    if (!file_.lost.empty()) throw std::runtime_error("not all of it can be read: " + file_.lost[0]);
    if (faces_.IsEmpty()) throw std::runtime_error("there is no face in this file: a solid is expected");
    for (int i = 1; i <= vertices_.Extent(); ++i) {
      const TopoDS_Vertex vertex = TopoDS::Vertex(vertices_(i));
      result_.vertices.push_back(checked(BRep_Tool::Pnt(vertex).XYZ()));
      result_.tolerance = (std::max)(result_.tolerance, BRep_Tool::Tolerance(vertex));
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(faces_.Extent()); ++i) add_face(i);
    return std::move(result_);
  }
};

} // namespace

Planar_solid planar_solid(const Shape_of_file& file) { return Solid_reader(file).read(); }
