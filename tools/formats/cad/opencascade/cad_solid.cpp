// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/cad_solid.h"

#include "formats/cad/opencascade/cad_surface.h"
#include "formats/cad/opencascade/spline_numbers.h"

#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BoundedCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Conic.hxx>
#include <Geom_Curve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
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

Handle(Geom_Curve) basis_of(const Handle(Geom_Curve) & curve) {
  const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve);
  return trimmed.IsNull() ? curve : basis_of(trimmed->BasisCurve());
}
Handle(Geom_Surface) basis_of(const Handle(Geom_Surface) & surface) {
  const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
  return trimmed.IsNull() ? surface : basis_of(trimmed->BasisSurface());
}

// The control points of the part of a curve between two parameters.
void add_spline(const Handle(Geom_Curve) & curve, double begin, double end, Cad_solid::Edge& edge) {
  const Handle(Geom_BSplineCurve) spline = GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(curve, begin, end));
  if (spline->IsPeriodic()) spline->SetNotPeriodic();
  edge.degree = spline->Degree();
  for (int i = 1; i <= spline->NbKnots(); ++i)
    edge.knots.insert(edge.knots.end(), static_cast<std::size_t>(spline->Multiplicity(i)), checked(spline->Knot(i)));
  for (int i = 1; i <= spline->NbPoles(); ++i) {
    edge.points.push_back(checked(spline->Pole(i).XYZ()));
    if (spline->IsRational()) edge.weights.push_back(checked(spline->Weight(i)));
  }
}

class Solid_reader {
  const Shape_of_file& file_;
  TopTools_IndexedMapOfShape faces_, edges_, vertices_; // numbered from 1 on
  Cad_solid result_;

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
    if (BRep_Tool::Surface(face).IsNull()) fail(number, "triangles, not a plane");
    const Handle(Geom_Surface) surface = basis_of(BRep_Tool::Surface(face));
    Cad_solid::Face result{};
    result.kind = surface_name(surface);
    result.name = label(face);
    if (const auto plane = Handle(Geom_Plane)::DownCast(surface); !plane.IsNull()) {
      const gp_Ax3& axes = plane->Position();
      result.point = checked(axes.Location().XYZ());
      result.normal = checked(axes.Direction().XYZ());
      result.turned = (face.Orientation() == TopAbs_REVERSED) != !axes.Direct();
      add_loops(number, steps(number, face), result);
    } else {
      result.wall = true;
      if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface); !cylinder.IsNull())
        result.normal = checked(cylinder->Axis().Direction().XYZ());
      else if (const auto extrusion = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface); !extrusion.IsNull())
        result.normal = checked(extrusion->Direction().XYZ());
      else
        fail(number, result.kind + ", neither a plane nor a wall (a cylinder or an extrusion): only edges between "
                                   "planes, and between planes and walls are rounded");
      result.loops.emplace_back();
      for (TopExp_Explorer i(face, TopAbs_EDGE); i.More(); i.Next()) add_step(number, i.Current(), result.loops[0]);
    }
    result_.faces.push_back(std::move(result));
  }

  void add_step(std::size_t face, const TopoDS_Shape& shape, Cad_solid::Loop& loop) const {
    const TopoDS_Edge edge = TopoDS::Edge(shape);
    const std::size_t e = index(edges_, edge);
    if (BRep_Tool::Degenerated(edge)) fail(face, "edge " + std::to_string(e) + " is said to be a point");
    const bool reversed = edge.Orientation() == TopAbs_REVERSED;
    loop.vertices.push_back(result_.edges[e].ends[reversed ? 1 : 0]);
    loop.edges.push_back(e);
    loop.reversed.push_back(reversed);
  }

  void add_edge(std::size_t number) {
    const TopoDS_Edge edge = TopoDS::Edge(edges_(static_cast<int>(number) + 1).Oriented(TopAbs_FORWARD));
    const auto fail_edge = [&](const std::string& reason) {
      throw std::runtime_error("edge " + std::to_string(number) + ' ' + reason);
    };
    Cad_solid::Edge result{};
    if (BRep_Tool::Degenerated(edge)) { // no face may have it, see add_step()
      result_.edges.push_back(std::move(result));
      return;
    }
    double begin, end;
    Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, begin, end);
    if (curve.IsNull()) fail_edge("has no curve in space");
    curve = basis_of(curve);
    const TopoDS_Vertex from = TopExp::FirstVertex(edge), to = TopExp::LastVertex(edge);
    if (from.IsNull() || to.IsNull()) fail_edge("has no end");
    result.ends = {index(vertices_, from), index(vertices_, to)};
    result.kind = is_straight(curve) ? "line" : curve_name(curve);
    if (!curve->IsKind(STANDARD_TYPE(Geom_BoundedCurve)) && !curve->IsKind(STANDARD_TYPE(Geom_Conic)) &&
        !curve->IsKind(STANDARD_TYPE(Geom_Line)))
      fail_edge("is neither a line, a conic nor a spline, but a " + curve_name(curve));
    if (const auto circle = Handle(Geom_Circle)::DownCast(curve); !circle.IsNull()) {
      result.kind = "circle";
      result.radius = checked(circle->Radius());
      result.angle = checked(end - begin);
      result.centre = checked(circle->Location().XYZ());
      result.axis = checked(circle->Axis().Direction().XYZ());
    } else if (result.kind != "line")
      add_spline(curve, begin, end, result);
    result_.edges.push_back(std::move(result));
  }

  // An edge on its way round a face, to the vertex where the next one begins.
  struct Step {
    std::size_t edge, next;
    bool reversed;
  };
  typedef std::map<std::size_t, Step> Steps; // by the vertices where they begin

  Steps steps(std::size_t number, const TopoDS_Face& face) const {
    Steps result;
    for (TopExp_Explorer i(face, TopAbs_EDGE); i.More(); i.Next()) {
      Cad_solid::Loop one;
      add_step(number, i.Current(), one);
      const Cad_solid::Edge& edge = result_.edges[one.edges[0]];
      const bool reversed = one.reversed[0] != 0;
      if (!result.emplace(one.vertices[0], Step{one.edges[0], edge.ends[reversed ? 0 : 1], reversed}).second)
        fail(number, "its boundary passes a vertex of edge " + std::to_string(one.edges[0]) + " twice");
    }
    return result;
  }

  void add_loops(std::size_t number, Steps steps, Cad_solid::Face& result) const {
    while (!steps.empty()) {
      const std::size_t first = steps.begin()->first;
      Cad_solid::Loop& loop = result.loops.emplace_back();
      std::size_t v = first;
      do {
        const auto step = steps.find(v);
        if (step == steps.end()) fail(number, "its boundary does not close");
        loop.vertices.push_back(v);
        loop.edges.push_back(step->second.edge);
        loop.reversed.push_back(step->second.reversed);
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

  Cad_solid read() {
    if (!file_.lost.empty()) throw std::runtime_error("not all of it can be read: " + file_.lost[0]);
    if (faces_.IsEmpty()) throw std::runtime_error("there is no face in this file: a solid is expected");
    for (int i = 1; i <= vertices_.Extent(); ++i) {
      const TopoDS_Vertex vertex = TopoDS::Vertex(vertices_(i));
      result_.vertices.push_back(checked(BRep_Tool::Pnt(vertex).XYZ()));
      result_.tolerance = (std::max)(result_.tolerance, BRep_Tool::Tolerance(vertex));
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(edges_.Extent()); ++i) add_edge(i);
    for (std::size_t i = 0; i < static_cast<std::size_t>(faces_.Extent()); ++i) add_face(i);
    return std::move(result_);
  }
};

} // namespace

Cad_solid cad_solid(const Shape_of_file& file) { return Solid_reader(file).read(); }
