// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/write_shell.h"

#include "formats/cad/add_seams.h"
#include "formats/cad/opencascade/Distinct_knots.h"
#include "formats/cad/opencascade/write_shape.h"
#include "formats/cad/run_along_v.h"

#include <BRepCheck.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_ListOfStatus.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax3.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

gp_Pnt in_space(const std::array<double, 3>& p) { return gp_Pnt(p[0], p[1], p[2]); }
gp_Pnt2d in_plane(const std::array<double, 2>& p) { return gp_Pnt2d(p[0], p[1]); }

// Curves have TColgp_Array1OfPnt, those in parameter planes TColgp_Array1OfPnt2d.
template <class Curve, class Array, class Spline, class Convert>
opencascade::handle<Curve> spline_curve(const Spline& spline, const Convert& convert) {
  const Distinct_knots knots(spline.degree, spline.knots);
  Array points(1, static_cast<int>(spline.points.size()));
  for (std::size_t i = 0; i < spline.points.size(); ++i) points(static_cast<int>(i) + 1) = convert(spline.points[i]);
  if (spline.weights.empty()) return new Curve(points, knots.knots(), knots.counts(), spline.degree);
  return new Curve(points, TColStd_Array1OfReal(spline.weights.front(), 1, static_cast<int>(spline.weights.size())),
                   knots.knots(), knots.counts(), spline.degree);
}

opencascade::handle<Geom_Surface> spline_surface(const Shell_model::Surface& surface) {
  const Distinct_knots u(surface.degree_u, surface.knots_u), v(surface.degree_v, surface.knots_v);
  const std::size_t m = surface.points.size(), n = surface.points.front().size();
  TColgp_Array2OfPnt points(1, static_cast<int>(m), 1, static_cast<int>(n));
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
      points(static_cast<int>(i) + 1, static_cast<int>(j) + 1) = in_space(surface.points[i][j]);
  if (surface.weights.empty())
    return new Geom_BSplineSurface(points, u.knots(), v.knots(), u.counts(), v.counts(), surface.degree_u,
                                   surface.degree_v);
  TColStd_Array2OfReal weights(1, static_cast<int>(m), 1, static_cast<int>(n));
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
      weights(static_cast<int>(i) + 1, static_cast<int>(j) + 1) = surface.weights[i][j];
  return new Geom_BSplineSurface(points, weights, u.knots(), v.knots(), u.counts(), v.counts(), surface.degree_u,
                                 surface.degree_v);
}

opencascade::handle<Geom_Surface> plane(const Shell_model::Surface& surface) {
  const gp_Vec x(in_space(surface.x).XYZ()), y(in_space(surface.y).XYZ());
  return new Geom_Plane(gp_Ax3(in_space(surface.origin), gp_Dir(x.Crossed(y)), gp_Dir(x)));
}

// The solid of a shell, and what its parts are.
class Solid_builder {
  static constexpr double tolerance = 1e-7; // mm
  const Shell_model& shell_;
  BRep_Builder builder_;
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<TopoDS_Edge> edges_;
  std::vector<bool> is_straight_; // edges, that are lines
  std::vector<TopoDS_Face> faces_;
  TopoDS_Solid solid_;

  [[noreturn]] static void fail(const char* kind, std::size_t number, const std::string& reason) {
    throw std::runtime_error(std::string("no solid: ") + kind + ' ' + std::to_string(number) + ": " + reason);
  }
  std::string name(std::size_t face) const {
    const std::string& name = shell_.faces[face].name;
    return name.empty() ? "" : "(" + name + ") ";
  }

  // Each edge of a closed shell is passed once in both directions.
  void check_uses() const {
    std::vector<std::array<int, 2>> uses(shell_.edges.size(), {0, 0});
    for (const Shell_model::Face& face : shell_.faces)
      for (const auto& loop : face.loops)
        for (const Shell_model::Use& use : loop)
          ++uses.at(static_cast<std::size_t>(use.edge))[use.reversed != face.reversed ? 1 : 0];
    for (std::size_t i = 0; i < uses.size(); ++i)
      if (uses[i] != std::array<int, 2>{1, 1})
        fail("edge", i,
             "faces pass it " + std::to_string(uses[i][0]) + " times forwards and " + std::to_string(uses[i][1]) +
                 " times backwards, not once each");
  }

  // An edge between planes is a line if it is one.
  void find_straight_edges() {
    is_straight_.resize(shell_.edges.size());
    for (std::size_t i = 0; i < shell_.edges.size(); ++i) {
      const Shell_model::Spline_curve& curve = shell_.edges[i].curve;
      is_straight_[i] = curve.degree == 1 && curve.points.size() == 2;
    }
    for (const Shell_model::Face& face : shell_.faces)
      if (!face.surface.plane)
        for (const auto& loop : face.loops)
          for (const Shell_model::Use& use : loop) is_straight_[static_cast<std::size_t>(use.edge)] = false;
  }

  void add_edge(std::size_t number) {
    const Shell_model::Edge& edge = shell_.edges[number];
    const Shell_model::Spline_curve& c = edge.curve;
    TopoDS_Edge result;
    std::array<double, 2> ends{c.knots[static_cast<std::size_t>(c.degree)],
                               c.knots[c.knots.size() - static_cast<std::size_t>(c.degree) - 1]};
    if (is_straight_[number]) {
      const gp_Pnt first = in_space(c.points[0]), last = in_space(c.points[1]);
      ends = {0, first.Distance(last)};
      builder_.MakeEdge(result, new Geom_Line(first, gp_Dir(gp_Vec(first, last))), tolerance);
    } else
      builder_.MakeEdge(result, spline_curve<Geom_BSplineCurve, TColgp_Array1OfPnt>(c, in_space), tolerance);
    builder_.Range(result, ends[0], ends[1]);
    builder_.Add(result, vertices_.at(static_cast<std::size_t>(edge.start)).Oriented(TopAbs_FORWARD));
    builder_.Add(result, vertices_.at(static_cast<std::size_t>(edge.end)).Oriented(TopAbs_REVERSED));
    edges_.push_back(result);
  }

  // The curves of an edge in the parameter plane of a face: two at a seam. A plane needs none.
  void add_curves(const Shell_model::Face& face, const TopoDS_Face& made) {
    std::map<int, std::array<opencascade::handle<Geom2d_BSplineCurve>, 2>> curves;
    for (const auto& loop : face.loops)
      for (const Shell_model::Use& use : loop)
        curves[use.edge][use.reversed ? 1 : 0] =
            spline_curve<Geom2d_BSplineCurve, TColgp_Array1OfPnt2d>(use.curve, in_plane);
    for (const auto& [number, pair] : curves) {
      const TopoDS_Edge& edge = edges_[static_cast<std::size_t>(number)];
      if (!pair[0].IsNull() && !pair[1].IsNull()) {
        builder_.UpdateEdge(edge, pair[0], pair[1], made, tolerance);
        builder_.Continuity(edge, made, made, GeomAbs_C2);
      } else
        builder_.UpdateEdge(edge, pair[pair[0].IsNull() ? 1 : 0], made, tolerance);
    }
  }

  void add_face(std::size_t number) {
    const Shell_model::Face& face = shell_.faces[number];
    TopoDS_Face result;
    builder_.MakeFace(result, face.surface.plane ? plane(face.surface) : spline_surface(face.surface), tolerance);
    if (!face.surface.plane) add_curves(face, result);
    for (const auto& loop : face.loops) {
      TopoDS_Wire wire;
      builder_.MakeWire(wire);
      for (const Shell_model::Use& use : loop)
        builder_.Add(
            wire, edges_[static_cast<std::size_t>(use.edge)].Oriented(use.reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
      wire.Closed(true);
      builder_.Add(result, wire);
    }
    if (face.reversed) result.Reverse();
    faces_.push_back(result);
  }

  // The words of OpenCASCADE for what is wrong with a part.
  static std::string reasons(const BRepCheck_Analyzer& analyzer, const TopoDS_Shape& part,
                             const TopoDS_Shape* context) {
    const opencascade::handle<BRepCheck_Result>& result = analyzer.Result(part);
    if (result.IsNull()) return "";
    std::set<BRepCheck_Status> found;
    const auto add = [&](const BRepCheck_ListOfStatus& list) {
      for (const BRepCheck_Status status : list)
        if (status != BRepCheck_NoError) found.insert(status);
    };
    if (context == nullptr)
      add(result->Status());
    else if (result->IsStatusOnShape(*context))
      add(result->StatusOnShape(*context));
    std::string text;
    for (const BRepCheck_Status status : found) {
      std::ostringstream os;
      BRepCheck::Print(status, os);
      std::string word = os.str();
      word.erase(word.find_last_not_of(" \n") + 1);
      text += (text.empty() ? "" : ", ") + word;
    }
    return text;
  }

  // Tells what is wrong with a part, or with what belongs to it as seen from it.
  void check(const BRepCheck_Analyzer& analyzer, const char* kind, std::size_t number, const TopoDS_Shape& part) const {
    std::string text = reasons(analyzer, part, nullptr);
    for (const TopAbs_ShapeEnum kind_of_part : {TopAbs_WIRE, TopAbs_EDGE, TopAbs_VERTEX})
      for (TopExp_Explorer i(part, kind_of_part); text.empty() && i.More(); i.Next())
        text = reasons(analyzer, i.Current(), &part);
    if (!text.empty()) fail(kind, number, (kind == std::string("face") ? name(number) : "") + text);
  }

  [[noreturn]] void explain(const BRepCheck_Analyzer& analyzer) const {
    for (std::size_t i = 0; i < edges_.size(); ++i) check(analyzer, "edge", i, edges_[i]);
    for (std::size_t i = 0; i < faces_.size(); ++i) check(analyzer, "face", i, faces_[i]);
    throw std::runtime_error("no solid: OpenCASCADE does not find it valid");
  }

public:
  explicit Solid_builder(const Shell_model& shell) : shell_(shell) {
    check_uses();
    find_straight_edges();
    for (const std::array<double, 3>& p : shell.vertices)
      builder_.MakeVertex(vertices_.emplace_back(), in_space(p), tolerance);
    for (std::size_t i = 0; i < shell.edges.size(); ++i) add_edge(i);
    for (std::size_t i = 0; i < shell.faces.size(); ++i) add_face(i);
    TopoDS_Shell all;
    builder_.MakeShell(all);
    for (const TopoDS_Face& face : faces_) builder_.Add(all, face);
    all.Closed(true);
    builder_.MakeSolid(solid_);
    builder_.Add(solid_, all);
  }

  const TopoDS_Solid& checked() const {
    const BRepCheck_Analyzer analyzer(solid_);
    if (!analyzer.IsValid()) explain(analyzer);
    for (TopExp_Explorer shell(solid_, TopAbs_SHELL); shell.More(); shell.Next())
      if (!BRep_Tool::IsClosed(shell.Current())) throw std::runtime_error("no solid: its shell is not closed");
    GProp_GProps properties;
    BRepGProp::VolumeProperties(solid_, properties);
    if (!(properties.Mass() > 0))
      throw std::runtime_error("no solid: its volume is not positive, its faces are inside out");
    return solid_;
  }

  Named_faces names() const {
    Named_faces result;
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (!shell_.faces[i].name.empty()) result.emplace_back(faces_[i], shell_.faces[i].name);
    return result;
  }
};

} // namespace

void write_shell(Shell_model shell, const std::string& model_file) {
  run_along_v(shell);
  add_seams(shell);
  const Solid_builder builder(shell);
  write_shape(builder.checked(), model_file, true, builder.names());
}
