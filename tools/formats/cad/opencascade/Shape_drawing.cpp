// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/Shape_drawing.h"

#include "formats/cad/opencascade/read_model.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <ShapeFix_Face.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

// How far triangles are from their face, in parts of the extent of the shape, and how far their
// normals turn, in radians.
constexpr double drawn_distance = 1e-3, drawn_angle = 0.2;

// A spline with more knots than this, such as measured ground, would be divided for minutes: the
// sides of its triangles are no shorter than this part of its extent. A face has no more triangles
// than this.
constexpr int most_fine_knots = 1000, most_triangles = 15000;
constexpr double coarse_side = 0.02;

// Divides a shape into triangles the sides of which are no shorter than `least`, or as short as is
// needed for 0.
void divide(const TopoDS_Shape& shape, double distance, double least) {
  IMeshTools_Parameters parameters;
  parameters.Deflection = distance;
  parameters.Angle = drawn_angle;
  if (least > 0) parameters.MinSize = least;
  BRepMesh_IncrementalMesh(shape, parameters);
}

double extent(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box);
  return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

bool has_many_knots(const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face, false);
  return surface.GetType() == GeomAbs_BSplineSurface && surface.NbUKnots() * surface.NbVKnots() > most_fine_knots;
}

bool has_many_triangles(const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, location);
  return !triangles.IsNull() && triangles->NbTriangles() > most_triangles;
}

// Divides a face that has many knots, or again, more coarsely, one that has become too many
// triangles.
void divide_coarsely(const TopoDS_Face& face, double distance) {
  const double size = extent(face);
  for (double part = coarse_side; part < 1; part *= 2) {
    BRepTools::Clean(face);
    divide(face, distance, part * size);
    if (!has_many_triangles(face)) return;
  }
}

GC::Cad_point<3> node(const Poly_Triangulation& triangles, int i, const TopLoc_Location& location) {
  const gp_Pnt p = triangles.Node(i).Transformed(location.Transformation());
  return {p.X(), p.Y(), p.Z()};
}

// So many segments are drawn of a curve.
constexpr int drawn_segments = 24;

std::vector<GC::Cad_point<3>> curve_points(const TopoDS_Edge& edge) {
  const BRepAdaptor_Curve curve(edge);
  const int n = curve.GetType() == GeomAbs_Line ? 1 : drawn_segments;
  const double begin = curve.FirstParameter(), end = curve.LastParameter();
  if (!is_finite(begin, end)) return {};
  std::vector<GC::Cad_point<3>> result;
  for (int i = 0; i <= n; ++i) {
    const gp_Pnt p = curve.Value(i == n ? end : begin + (end - begin) * i / n);
    result.push_back({p.X(), p.Y(), p.Z()});
  }
  return result;
}

// Returns whether those curves of an edge that there are begin and end at finite points, in space
// and in the parameter plane.
bool has_finite_ends(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  double begin, end;
  if (const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, begin, end); !curve.IsNull())
    for (const double t : {begin, end}) {
      const gp_Pnt p = curve->Value(t);
      if (!is_finite(p.X(), p.Y()) || !is_finite(p.Z(), 0)) return false;
    }
  if (const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, begin, end); !curve.IsNull())
    for (const double t : {begin, end}) {
      const gp_Pnt2d p = curve->Value(t);
      if (!is_finite(p.X(), p.Y())) return false;
    }
  return true;
}

// Returns whether the edges of a face have finite parameters and ends, and the face a finite
// extent; includes it in a box then.
bool include(const TopoDS_Shape& face, Bnd_Box& all) {
  for (TopExp_Explorer i(face, TopAbs_EDGE); i.More(); i.Next()) {
    double begin, end;
    BRep_Tool::Range(TopoDS::Edge(i.Current()), begin, end);
    if (!is_finite(begin, end) || !has_finite_ends(TopoDS::Edge(i.Current()), TopoDS::Face(face))) return false;
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

// The point of a triangle that is nearest to the origin, by its squared distance: inside, or on a
// side.
double square_from_origin(const gp_XYZ& a, const gp_XYZ& b, const gp_XYZ& c) {
  const gp_XYZ normal = (b - a).Crossed(c - a);
  const auto is_inside = [&](const gp_XYZ& p, const gp_XYZ& q) { return p.Crossed(q).Dot(normal) >= 0; };
  if (normal.SquareModulus() > 0 && is_inside(a, b) && is_inside(b, c) && is_inside(c, a))
    return a.Dot(normal) * a.Dot(normal) / normal.SquareModulus();
  const auto from_side = [](const gp_XYZ& p, const gp_XYZ& q) {
    const double length = (q - p).SquareModulus();
    const double t = length > 0 ? (std::min)(1., (std::max)(0., -p.Dot(q - p) / length)) : 0;
    return (p + (q - p) * t).SquareModulus();
  };
  return (std::min)({from_side(a, b), from_side(b, c), from_side(c, a)});
}

// How far the edges of a face are from triangles, at some points.
double distance(const TopoDS_Face& face, const Cad_mesh& mesh) {
  const auto vector = [](const GC::Cad_point<3>& p) { return gp_XYZ(p[0], p[1], p[2]); };
  double most = 0;
  for (TopExp_Explorer i(face, TopAbs_EDGE); i.More(); i.Next()) {
    if (BRep_Tool::Degenerated(TopoDS::Edge(i.Current()))) continue;
    for (const GC::Cad_point<3>& point : curve_points(TopoDS::Edge(i.Current()))) {
      double least = infinite * infinite;
      for (const auto& [a, b, c] : mesh.triangles)
        least = (std::min)(least, square_from_origin(vector(mesh.points[a]) - vector(point),
                                                     vector(mesh.points[b]) - vector(point),
                                                     vector(mesh.points[c]) - vector(point)));
      most = (std::max)(most, least);
    }
  }
  return mesh.triangles.empty() ? 0 : std::sqrt(most);
}

// Returns whether the edges of a face lie in the box of its triangles, up to this distance.
// OpenCASCADE may divide a part of a face only.
bool has_edges(const TopoDS_Face& face, const Cad_mesh& mesh, double distance) {
  Bnd_Box box;
  for (const auto& triangle : mesh.triangles)
    for (const std::size_t i : triangle) box.Add(gp_Pnt(mesh.points[i][0], mesh.points[i][1], mesh.points[i][2]));
  if (box.IsVoid()) return false;
  box.Enlarge(distance);
  for (TopExp_Explorer i(face, TopAbs_EDGE); i.More(); i.Next()) {
    if (BRep_Tool::Degenerated(TopoDS::Edge(i.Current()))) continue;
    for (const GC::Cad_point<3>& p : curve_points(TopoDS::Edge(i.Current())))
      if (box.IsOut(gp_Pnt(p[0], p[1], p[2]))) return false;
  }
  return true;
}

// A copy of a face with its boundary repaired, e.g. moved by periods of its surface.
TopoDS_Shape healed(const TopoDS_Face& face) {
  ShapeFix_Face fix(TopoDS::Face(BRepBuilderAPI_Copy(face).Shape()));
  fix.Perform();
  return fix.Result();
}

} // namespace

Shape_drawing::Shape_drawing(const std::vector<TopoDS_Face>& faces) {
  Bnd_Box all;
  for (const TopoDS_Face& face : faces) try {
      include(face, all);
    } catch (const Standard_Failure&) { // it cannot be drawn
    }
  if (!all.IsVoid()) distance_ = drawn_distance * std::sqrt(all.SquareExtent());
}

void Shape_drawing::divide_together(const std::vector<TopoDS_Face>& faces) {
  try {
    BRep_Builder builder;
    TopoDS_Compound finite;
    builder.MakeCompound(finite);
    std::vector<TopoDS_Face> included;
    for (const TopoDS_Face& face : faces) {
      divided_.insert(face.TShape().get());
      Bnd_Box box;
      if (!include(face, box)) continue;
      included.push_back(face);
      if (!has_many_knots(face)) builder.Add(finite, face);
    }
    if (included.empty()) return;
    ::divide(finite, distance_, 0);
    for (const TopoDS_Face& face : included)
      if (has_many_knots(face) || has_many_triangles(face)) divide_coarsely(face, distance_);
  } catch (const Standard_Failure&) { // what has been divided until now is drawn
  }
}

void Shape_drawing::divide(const TopoDS_Face& face) {
  if (!divided_.insert(face.TShape().get()).second) return; // it is placed again
  const bool is_coarse = has_many_knots(face);
  if (!is_coarse) ::divide(face, distance_, 0);
  if (is_coarse || has_many_triangles(face)) divide_coarsely(face, distance_);
}

Cad_mesh Shape_drawing::mesh(const TopoDS_Face& face) {
  Cad_mesh result;
  result.reason = "it cannot be divided into triangles";
  try {
    Bnd_Box box;
    const bool is_finite = include(face, box) && !BRep_Tool::Surface(face).IsNull();
    if (is_finite)
      divide(face);
    else
      result.reason = "it is not finite";
    append_triangles(face, result);
    const double near = 20 * distance_; // what nobody takes for another face
    if (is_finite && !has_edges(face, result, near)) {
      result.points.clear();
      result.triangles.clear();
      const TopoDS_Shape copy = healed(face);
      ::divide(copy, distance_, has_many_knots(face) ? coarse_side * extent(face) : 0);
      for (TopExp_Explorer i(copy, TopAbs_FACE); i.More(); i.Next())
        append_triangles(TopoDS::Face(i.Current()), result);
      result.healed = distance(face, result);
      if (!result.triangles.empty() && !has_edges(face, result, near)) {
        result.triangles.clear();
        result.reason = "the triangles into which it is divided do not reach its edges";
      }
    }
  } catch (const Standard_Failure&) { // it cannot be drawn
  }
  if (!result.triangles.empty()) result.reason.clear();
  return result;
}

std::vector<GC::Cad_point<3>> Shape_drawing::points(const TopoDS_Edge& edge) {
  if (BRep_Tool::Degenerated(edge)) return {};
  try {
    TopLoc_Location location;
    Handle(Poly_PolygonOnTriangulation) polygon;
    Handle(Poly_Triangulation) triangles;
    BRep_Tool::PolygonOnTriangulation(edge, polygon, triangles, location);
    if (polygon.IsNull() || triangles.IsNull()) return curve_points(edge);
    std::vector<GC::Cad_point<3>> result;
    for (int i = 1; i <= polygon->NbNodes(); ++i) result.push_back(node(*triangles, polygon->Node(i), location));
    return result;
  } catch (const Standard_Failure&) { // it cannot be drawn
    return {};
  }
}
