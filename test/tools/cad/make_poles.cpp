// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Writes CAD models with OpenCASCADE to the current folder: surfaces that reach the axis about
// which they are rotated, poles_*, and what has a kink next to a pole, kinks_*.

#include "write_model.h"

#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <gp_Ax3.hxx>
#include <gp_GTrsf.hxx>

namespace {

// Returns the shape that a profile in the half plane x >= 0, y = 0 makes around the axis of z.
TopoDS_Shape revolved(const Handle(Geom_Curve) & profile, double angle = 2 * M_PI) {
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeEdge(profile).Shape(), gp_Ax1(gp_Pnt(), gp_Dir(0, 0, 1)), angle)
      .Shape();
}
// A part of an ellipse with the half axes a along x and b along z, about a centre on the axis of x.
Handle(Geom_Curve) arc(double a, double b, double centre, double begin, double end) {
  const bool is_wide = a >= b;
  const gp_Ax2 axes(gp_Pnt(centre, 0, 0), gp_Dir(0, -1, 0), is_wide ? gp_Dir(1, 0, 0) : gp_Dir(0, 0, 1));
  const double turn = is_wide ? 0 : -M_PI / 2; // the parameter begins at the larger axis
  if (a == b) return new Geom_TrimmedCurve(new Geom_Circle(axes, a), begin, end);
  return new Geom_TrimmedCurve(new Geom_Ellipse(axes, (std::max)(a, b), (std::min)(a, b)), begin + turn, end + turn);
}
// Through points (x, z), with a tangent at the last one in the direction (-sine, cosine) of the
// angle at which it meets the axis.
Handle(Geom_Curve) through(const std::vector<std::array<double, 2>>& profile, double degrees) {
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, static_cast<int>(profile.size()));
  for (std::size_t i = 0; i < profile.size(); ++i)
    points->SetValue(static_cast<int>(i) + 1, gp_Pnt(profile[i][0], 0, profile[i][1]));
  GeomAPI_Interpolate interpolation(points, false, 1e-9);
  const double angle = degrees * M_PI / 180;
  interpolation.Load(gp_Vec(0, 0, 1), gp_Vec(-std::sin(angle), 0, std::cos(angle)));
  interpolation.Perform();
  require(interpolation.IsDone(), "profile");
  return Handle(Geom_Curve)(interpolation.Curve());
}
Handle(Geom_Curve) bezier(const std::vector<std::array<double, 2>>& profile) {
  TColgp_Array1OfPnt points(1, static_cast<int>(profile.size()));
  for (std::size_t i = 0; i < profile.size(); ++i)
    points.SetValue(static_cast<int>(i) + 1, gp_Pnt(profile[i][0], 0, profile[i][1]));
  return Handle(Geom_Curve)(new Geom_BezierCurve(points));
}
// Three thirds of what a profile makes around the axis, with common edges.
TopoDS_Shape thirds(const Handle(Geom_Curve) & profile) {
  BRepBuilderAPI_Sewing sewing;
  for (const int i : {0, 1, 2}) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(), gp_Dir(0, 0, 1)), 2 * M_PI / 3 * i);
    sewing.Add(BRepBuilderAPI_Transform(revolved(profile, 2 * M_PI / 3), turn, true).Shape());
  }
  sewing.Perform();
  return sewing.SewedShape();
}
// The solid that the area between the axis and a profile from the plane z = 0 to the axis makes.
TopoDS_Shape solid(const Handle(Geom_Curve) & profile, double angle) {
  const gp_Pnt low = profile->Value(profile->FirstParameter()), top = profile->Value(profile->LastParameter());
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(profile).Edge(), BRepBuilderAPI_MakeEdge(top, gp_Pnt()).Edge(),
                               BRepBuilderAPI_MakeEdge(gp_Pnt(), low).Edge());
  const TopoDS_Face area = BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(), gp_Dir(0, 1, 0)), wire.Wire()).Face();
  return BRepPrimAPI_MakeRevol(area, gp_Ax1(gp_Pnt(), gp_Dir(0, 0, 1)), angle).Shape();
}
// A part of a torus: its circle, of the radius r about a centre at the distance R of the axis, from
// one angle to another.
TopoDS_Shape part_of_torus(double R, double r, double begin, double end) {
  return BRepBuilderAPI_MakeFace(new Geom_ToroidalSurface(gp_Ax3(), R, r), 0, 2 * M_PI, begin, end, 1e-7).Shape();
}
// Two triangles with the common edge from (0, 0, 0) to (0, 10, 0), in the planes z = 0 and, at x =
// 9 t, y = 10 t, at these heights (t, z): the angle along the edge is the arc tangent of z / (9 t).
TopoDS_Shape triangles(const std::vector<std::array<double, 2>>& heights) {
  const int n = static_cast<int>(heights.size());
  TColStd_Array1OfReal u(1, 2), v(1, n);
  TColStd_Array1OfInteger of_u(1, 2), of_v(1, n);
  u(1) = 0;
  u(2) = 1;
  of_u.Init(2);
  for (int i = 1; i <= n; ++i) {
    v(i) = heights[static_cast<std::size_t>(i - 1)][0];
    of_v(i) = i == 1 || i == n ? 2 : 1;
  }
  BRepBuilderAPI_Sewing sewing;
  for (const bool flat : {true, false}) {
    TColgp_Array2OfPnt points(1, 2, 1, n);
    for (int i = 1; i <= n; ++i) {
      const auto& [t, z] = heights[static_cast<std::size_t>(i - 1)];
      points(flat ? 2 : 1, i) = gp_Pnt(0, 10 * t, 0);
      points(flat ? 1 : 2, i) = flat ? gp_Pnt(-9 * t, 10 * t, 0) : gp_Pnt(9 * t, 10 * t, z);
    }
    sewing.Add(face(new Geom_BSplineSurface(points, u, v, of_u, of_v, 1, 1)));
  }
  sewing.Perform();
  return sewing.SewedShape();
}
// Half of a cone about the axis of z, and the other half turned about their common ruling: both
// meet at the apex.
TopoDS_Shape two_cones(double degrees) {
  const Handle(Geom_Surface) cone = new Geom_ConicalSurface(gp_Ax3(), M_PI / 6, 0);
  const TopoDS_Shape first = BRepBuilderAPI_MakeFace(cone, 0, M_PI / 2, 0, 10, 1e-7).Shape(),
                     second = BRepBuilderAPI_MakeFace(cone, -M_PI / 2, 0, 0, 10, 1e-7).Shape();
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(), gp_Dir(std::sin(M_PI / 6), 0, std::cos(M_PI / 6))), degrees * M_PI / 180);
  BRepBuilderAPI_Sewing sewing;
  sewing.Add(first);
  sewing.Add(BRepBuilderAPI_Transform(second, turn, true).Shape());
  sewing.Perform();
  return sewing.SewedShape();
}

} // namespace

int main() {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  IGESControl_Controller::Init();
  const double quarter = M_PI / 2;
  const std::vector<std::array<double, 2>> dome{{5, 0}, {4.5, 3}, {3, 4.5}, {0, 5}},
      bow{{4, 0}, {4, 3}, {2, 4}, {0, 4}};
  const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(5).Shape();
  gp_GTrsf stretch;
  stretch.SetValue(1, 1, 2);
  stretch.SetValue(2, 2, 1.3);
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(20, 30, 40).Shape();
  BRepFilletAPI_MakeFillet rounded(box);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(box, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) rounded.Add(3, TopoDS::Edge(edges(i)));
  const std::vector<std::pair<std::string, TopoDS_Shape>> smooth{
      {"arc", revolved(arc(5, 5, 0, 0, quarter))},
      {"ogive", revolved(arc(8, 8, -4, 0, M_PI / 3))},
      {"lens", revolved(arc(8, 8, -4, -M_PI / 3, M_PI / 3))},
      {"apple", revolved(arc(5, 5, 2, -quarter - 0.4, std::acos(-0.4)))},
      {"flat_ellipse", revolved(arc(7, 2, 0, -quarter, quarter))},
      {"high_ellipse", revolved(arc(2, 7, 0, -quarter, quarter))},
      {"spline", revolved(through(dome, 90))},
      {"tip", revolved(through(dome, 80))},
      {"blunt_tip", revolved(through(dome, 89.99))},
      {"bezier", revolved(bezier(bow))},
      {"nurbs_sphere", BRepBuilderAPI_NurbsConvert(sphere).Shape()},
      {"ellipsoid", BRepBuilderAPI_GTransform(sphere, stretch).Shape()},
      {"half_horn", part_of_torus(5, 5, 0, M_PI)},
      {"lemon", part_of_torus(3, 5, std::acos(-0.6), 2 * M_PI - std::acos(-0.6))},
      {"spindle", part_of_torus(3, 5, -std::acos(-0.6), std::acos(-0.6))},
      {"whole_spindle", part_of_torus(3, 5, 0, 2 * M_PI)},
      {"thirds_of_ellipse", thirds(arc(7, 3, 0, 0, quarter))},
      {"thirds_of_spline", thirds(through(dome, 90))},
      {"thirds_of_tip", thirds(through(dome, 80))},
      {"thirds_of_bezier", thirds(bezier(bow))},
      {"solid_arc", solid(arc(5, 5, 0, 0, quarter), 1.2)},
      {"solid_ellipse", solid(arc(3, 7, 0, 0, quarter), 4)},
      {"solid_spline", solid(through(dome, 90), 2)},
      {"solid_bezier", solid(bezier(bow), 2 * M_PI)},
      {"rounded_box", rounded.Shape()}};
  for (const auto& [name, shape] : smooth) {
    for (const char* extension : {".brep", ".step", ".igs"}) write(shape, "poles_" + name + extension);
    for (const char* extension : {".step", ".igs"}) write(moved(shape), "poles_moved_" + name + extension);
  }
  write(part_of_torus(5, 5, -M_PI, M_PI), "poles_horn.igs"); // in STEP it has no edge
  // Without curves in parameter planes: an eighth of a sphere, whose sides end in the pole.
  Interface_Static::SetIVal("write.surfacecurve.mode", 0);
  const TopoDS_Shape octant = BRepPrimAPI_MakeSphere(gp_Ax2(), 7, 0, quarter, quarter).Shape();
  write(octant, "poles_octant.step");
  write(moved(octant), "poles_moved_octant.step");
  Interface_Static::SetIVal("write.surfacecurve.mode", 1);

  write(two_cones(3), "kinks_cones.step");
  // The knot line of a double cone is its apex.
  TColgp_Array1OfPnt zigzag(1, 3);
  TColStd_Array1OfReal knots(1, 3);
  TColStd_Array1OfInteger multiplicities(1, 3);
  for (int i = 1; i <= 3; ++i) {
    zigzag(i) = gp_Pnt(i == 2 ? 0 : 3, 0, 4 * i);
    knots(i) = i;
    multiplicities(i) = i == 2 ? 1 : 2;
  }
  write(face(new Geom_SurfaceOfRevolution(new Geom_BSplineCurve(zigzag, knots, multiplicities, 1),
                                          gp_Ax1(gp_Pnt(), gp_Dir(0, 0, 1)))),
        "kinks_hourglass.brep");
  const double slope = 9 * std::tan(2 * M_PI / 180); // of an angle of 2 degrees, times t
  // a kink from 0.021 to 0.06 mm from the pole only, one of which most lies within 0.02 mm, and one
  // that fades towards the pole
  write(triangles({{0, 0}, {0.0022, 0}, {0.004, 0.004 * slope}, {0.006, 0}, {1, 0}}), "kinks_beside.brep");
  write(triangles({{0, 0}, {0.0005, 0.0005 * slope}, {0.0015, 0}, {1, 0}}), "kinks_within.brep");
  write(triangles({{0, 0}, {0.0022, 0}, {1, 9}}), "kinks_fading.brep");
}
