// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Writes CAD models whose edges are known, with OpenCASCADE, to the current folder.

#include "write_model.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <GeomConvert.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetSurface.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <gp_Circ.hxx>
#include <gp_Pnt2d.hxx>

namespace {

TopoDS_Compound compound(const std::vector<TopoDS_Shape>& shapes) {
  BRep_Builder builder;
  TopoDS_Compound result;
  builder.MakeCompound(result);
  for (const TopoDS_Shape& shape : shapes) builder.Add(result, shape);
  return result;
}

// The faces of a shape, each with edges of its own.
TopoDS_Compound separated(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer i(shape, TopAbs_FACE); i.More(); i.Next())
    faces.push_back(BRepBuilderAPI_Copy(i.Current()).Shape());
  return compound(faces);
}

// A box with one edge rounded.
TopoDS_Shape filleted(const TopoDS_Shape& box, double radius) {
  BRepFilletAPI_MakeFillet fillet(box);
  fillet.Add(radius, TopoDS::Edge(TopExp_Explorer(box, TopAbs_EDGE).Current()));
  return fillet.Shape();
}

// A ring, all edges of which are rounded: four cylinders and planes and four tori, by turning its
// section.
TopoDS_Shape washer() {
  const gp_Ax1 axis(gp_Pnt(), gp_Dir(0, 0, 1));
  BRepBuilderAPI_MakeWire section;
  const auto line = [&](double x, double z, double to_x, double to_z) {
    section.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(x, 0, z), gp_Pnt(to_x, 0, to_z)).Edge());
  };
  const auto arc = [&](double x, double z, double begin) { // of the radius 1
    const gp_Circ circle(gp_Ax2(gp_Pnt(x, 0, z), gp_Dir(0, -1, 0), gp_Dir(1, 0, 0)), 1);
    section.Add(BRepBuilderAPI_MakeEdge(circle, begin, begin + M_PI / 2).Edge());
  };
  line(10, 1, 10, 4);
  arc(9, 4, 0);
  line(9, 5, 7, 5);
  arc(7, 4, M_PI / 2);
  line(6, 4, 6, 1);
  arc(7, 1, M_PI);
  line(7, 0, 9, 0);
  arc(9, 1, 3 * M_PI / 2);
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(section.Wire(), true).Shape(), axis).Shape();
}

// The wall above a polyline through points (x, y).
TopoDS_Shape wall(const std::vector<gp_Pnt>& points) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const gp_Pnt& p : points) polygon.Add(p);
  return BRepPrimAPI_MakePrism(polygon.Wire(), gp_Vec(0, 0, 5)).Shape();
}

// A smooth closed spline of a period.
Handle(Geom_BSplineCurve) periodic_spline() {
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 7);
  for (int i = 0; i < 7; ++i) {
    const double angle = 2 * M_PI * i / 7, radius = 4 + std::cos(3. * i);
    points->SetValue(i + 1, gp_Pnt(radius * std::cos(angle), radius * std::sin(angle), 0));
  }
  GeomAPI_Interpolate interpolation(points, true, 1e-9);
  interpolation.Perform();
  require(interpolation.IsDone() && interpolation.Curve()->IsPeriodic(), "periodic spline");
  return interpolation.Curve();
}

// Three faces that share an edge.
TopoDS_Shape three_faces() {
  const TopoDS_Edge shared = BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(0, 0, 1));
  const TopoDS_Vertex low = TopExp::FirstVertex(shared), high = TopExp::LastVertex(shared);
  std::vector<TopoDS_Shape> faces;
  for (const gp_Pnt& p : {gp_Pnt(1, 0, 0), gp_Pnt(-1, 2, 0), gp_Pnt(-1, -1, 0)}) {
    const TopoDS_Edge up = BRepBuilderAPI_MakeEdge(p, gp_Pnt(p.X(), p.Y(), 1));
    const TopoDS_Edge a = BRepBuilderAPI_MakeEdge(low, TopExp::FirstVertex(up)),
                      b = BRepBuilderAPI_MakeEdge(TopExp::LastVertex(up), high);
    BRepBuilderAPI_MakeWire wire(shared, a, up, b);
    faces.push_back(BRepBuilderAPI_MakeFace(wire.Wire(), true).Shape());
  }
  return compound(faces);
}

// The faces z = 0 and z = -x y: the angle along the axis of x grows from 0 to 45 degrees.
TopoDS_Shape fading_crease() {
  BRepBuilderAPI_Sewing sewing;
  for (const double y : {1., -1.}) {
    TColgp_Array2OfPnt points(1, 2, 1, 2);
    for (const int x : {0, 1}) {
      points.SetValue(x + 1, y > 0 ? 1 : 2, gp_Pnt(x, 0, 0));
      points.SetValue(x + 1, y > 0 ? 2 : 1, gp_Pnt(x, y, y < 0 ? x : 0));
    }
    sewing.Add(face(new Geom_BezierSurface(points)));
  }
  sewing.Perform();
  return sewing.SewedShape();
}

// Ground that has been measured, as it were: a bicubic spline surface of many knots, up and down.
TopoDS_Shape rough() {
  constexpr int n = 90;
  TColgp_Array2OfPnt points(1, n, 1, n);
  for (int i = 1; i <= n; ++i)
    for (int j = 1; j <= n; ++j) points(i, j) = gp_Pnt(i, j, 3 * std::sin(double(i * i + 3 * j * j)));
  TColStd_Array1OfReal knots(1, n - 2);
  TColStd_Array1OfInteger multiplicities(1, n - 2);
  for (int i = 1; i <= n - 2; ++i) {
    knots(i) = i;
    multiplicities(i) = i == 1 || i == n - 2 ? 4 : 1;
  }
  const Handle(Geom_BSplineSurface) surface =
      new Geom_BSplineSurface(points, knots, knots, multiplicities, multiplicities, 3, 3);
  return BRepBuilderAPI_MakeFace(surface, 1e-7).Shape();
}

// A box and, beside it, the face that a curve of many waves makes around an axis: OpenCASCADE
// divides it into triangles for minutes.
TopoDS_Shape slow() {
  constexpr int n = 1500;
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, n);
  for (int i = 1; i <= n; ++i) points->SetValue(i, gp_Pnt(20 + 3 * std::sin(double(i * i)), 0, 0.01 * i));
  GeomAPI_Interpolate interpolation(points, false, 1e-9);
  interpolation.Perform();
  require(interpolation.IsDone(), "slow spline");
  const TopoDS_Shape face = BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeEdge(interpolation.Curve()).Shape(),
                                                  gp_Ax1(gp_Pnt(), gp_Dir(0, 0, 1)), true)
                                .Shape();
  return compound({BRepPrimAPI_MakeBox(gp_Pnt(60, 0, 0), 10, 10, 10).Shape(), face});
}

// A strip of these points (x, z), as many as the degree and the spans, from y = 0 to 10; there the
// last one is `high` higher.
Handle(Geom_BSplineSurface) strip(const std::vector<std::array<double, 2>>& profile, int degree, double high) {
  const int n = static_cast<int>(profile.size()), spans = n - degree;
  TColgp_Array2OfPnt points(1, n, 1, 2);
  for (int i = 1; i <= n; ++i)
    for (int j = 1; j <= 2; ++j) {
      const auto& [x, z] = profile[static_cast<std::size_t>(i - 1)];
      points(i, j) = gp_Pnt(x, 10 * (j - 1), z + (i == n && j == 2 ? high : 0));
    }
  TColStd_Array1OfReal u(1, spans + 1), v(1, 2);
  TColStd_Array1OfInteger u_multiplicities(1, spans + 1), v_multiplicities(1, 2);
  for (int i = 1; i <= spans + 1; ++i) {
    u(i) = i - 1;
    u_multiplicities(i) = i == 1 || i == spans + 1 ? degree + 1 : 1;
  }
  v(1) = 0;
  v(2) = 1;
  v_multiplicities.Init(2);
  return new Geom_BSplineSurface(points, u, v, u_multiplicities, v_multiplicities, degree, 1);
}

// A face that has a part of a crease only, from v = 0 to 0.6: there it is of 31.3 degrees, and
// beyond up to 45.
TopoDS_Shape trimmed_crease() {
  const Handle(Geom_Surface) surface = strip({{0, 0}, {10, 0}, {20, 10 * std::tan(M_PI / 180)}}, 1, 9.8254);
  const std::vector<gp_Pnt2d> corners{{0, 0}, {2, 0}, {2, 0.7}, {0.5, 0.55}, {0.5, 1}, {0, 1}};
  BRepBuilderAPI_MakeWire wire;
  for (std::size_t i = 0; i < corners.size(); ++i)
    wire.Add(
        BRepBuilderAPI_MakeEdge(GCE2d_MakeSegment(corners[i], corners[(i + 1) % corners.size()]).Value(), surface));
  TopoDS_Shape face = BRepBuilderAPI_MakeFace(surface, wire.Wire(), true).Shape();
  BRepLib::BuildCurves3d(face);
  return face;
}

// Three times two plane faces that share two edges of one line: in one plane; the same, one of them
// inside out; bent.
TopoDS_Shape pairs() {
  const auto point = [](double x, double y, double angle) {
    return gp_Pnt(x, y * std::cos(angle), y * std::sin(angle));
  };
  const Handle(Geom_Line) line = new Geom_Line(gp_Pnt(), gp_Dir(1, 0, 0));
  std::vector<TopoDS_Vertex> ends;
  for (int x = 0; x < 4; ++x) ends.push_back(BRepBuilderAPI_MakeVertex(gp_Pnt(x, 0, 0)).Vertex());
  const TopoDS_Edge first = BRepBuilderAPI_MakeEdge(line, ends[0], ends[1], 0, 1).Edge(),
                    second = BRepBuilderAPI_MakeEdge(line, ends[2], ends[3], 2, 3).Edge();
  const auto side = [&](double y, double angle) { // y = 1 or -1
    std::vector<TopoDS_Vertex> v;
    for (const auto& [x, d] : {std::array<double, 2>{1, 0.5}, {2, 0.5}, {3, 1}, {0, 1}})
      v.push_back(BRepBuilderAPI_MakeVertex(point(x, d * y, angle)).Vertex());
    BRepBuilderAPI_MakeWire wire(first);
    for (const auto& [a, b] : {std::array<TopoDS_Vertex, 2>{ends[1], v[0]}, {v[0], v[1]}, {v[1], ends[2]}})
      wire.Add(BRepBuilderAPI_MakeEdge(a, b));
    wire.Add(second);
    for (const auto& [a, b] : {std::array<TopoDS_Vertex, 2>{ends[3], v[2]}, {v[2], v[3]}, {v[3], ends[0]}})
      wire.Add(BRepBuilderAPI_MakeEdge(a, b));
    const gp_Pln plane(gp_Ax3(gp_Pnt(), gp_Dir(0, -std::sin(angle), std::cos(angle)), gp_Dir(1, 0, 0)));
    return BRepBuilderAPI_MakeFace(plane, wire.Wire(), true).Face();
  };
  const auto shell = [](const TopoDS_Shape& a, const TopoDS_Shape& b) {
    TopoDS_Shell result;
    BRep_Builder().MakeShell(result);
    BRep_Builder().Add(result, a);
    BRep_Builder().Add(result, b);
    return result;
  };
  const TopoDS_Face near = side(-1, 0), far = side(1, 0), bent = side(1, M_PI / 6);
  return compound({shell(near, far), moved(shell(near, far.Reversed())), moved(moved(shell(near, bent)))});
}

// A part at eleven places, and another one; in STEP with the structure of the assembly.
void write_assembly(const TopoDS_Shape& part, const TopoDS_Shape& other) {
  TopoDS_Compound assembly;
  BRep_Builder().MakeCompound(assembly);
  BRep_Builder().Add(assembly, other);
  TopoDS_Shape next = part;
  for (int i = 0; i < 11; ++i) {
    BRep_Builder().Add(assembly, next);
    next = moved(next);
  }
  write(assembly, "assembly.brep");
  STEPControl_Writer writer;
  Interface_Static::SetIVal("write.step.assembly", 1);
  require(writer.Transfer(assembly, STEPControl_AsIs) == IFSelect_RetDone &&
              writer.Write("assembly.step") == IFSelect_RetDone,
          "assembly.step");
  Interface_Static::SetIVal("write.step.assembly", 0);
}

TopoDS_Shape arc(const gp_Pnt& centre, double radius, double from, double to) {
  return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(centre, gp_Dir(0, 0, 1)), radius), from, to).Edge();
}
TopoDS_Shape line(const gp_Pnt& a, const gp_Pnt& b) { return BRepBuilderAPI_MakeEdge(a, b).Edge(); }

// The spline of these control points, with these knots besides those at the ends 0 and 1.
TopoDS_Shape spline(const std::vector<gp_Pnt>& points, int degree, const std::vector<std::pair<double, int>>& inner) {
  TColgp_Array1OfPnt poles(1, static_cast<int>(points.size()));
  for (int i = 0; i < poles.Length(); ++i) poles.SetValue(i + 1, points[static_cast<std::size_t>(i)]);
  const int n = static_cast<int>(inner.size()) + 2;
  TColStd_Array1OfReal knots(1, n);
  TColStd_Array1OfInteger times(1, n);
  knots.SetValue(1, 0), knots.SetValue(n, 1);
  times.SetValue(1, degree + 1), times.SetValue(n, degree + 1);
  for (int i = 2; i < n; ++i) {
    knots.SetValue(i, inner[static_cast<std::size_t>(i) - 2].first);
    times.SetValue(i, inner[static_cast<std::size_t>(i) - 2].second);
  }
  return BRepBuilderAPI_MakeEdge(new Geom_BSplineCurve(poles, knots, times, degree)).Edge();
}

// Curves without faces, whose ends meet, or nearly.
void write_wires() {
  const gp_Pnt a(0, 5, 0), b(30, 5, 0), c(30, -5, 0), d(0, -5, 0);
  const TopoDS_Shape slot = compound({line(a, b), arc(gp_Pnt(30, 0, 0), 5, -M_PI / 2, M_PI / 2), line(d, c),
                                      arc(gp_Pnt(0, 0, 0), 5, M_PI / 2, 1.5 * M_PI)});
  for (const char* name : {"slot.brep", "slot.step", "slot.igs"}) write(slot, name);
  write(moved(slot), "slot_moved.brep");
  write(line(a, b), "line.brep");
  // with a solid beside it
  write(compound({BRepPrimAPI_MakeBox(1, 1, 1).Shape(), slot}), "slot_and_box.brep");
  // kinks of 1 and of 44.5 degrees, a gap of 0.1, and an end that is free
  const gp_Pnt e(10, 0, 0), f(20, std::tan(M_PI / 180) * 10, 0), g(30, 10 + std::tan(M_PI / 180) * 20, 0);
  const gp_Vec further(gp_Vec(f, g).Normalized());
  write(compound({line(gp_Pnt(0, 0, 0), e), line(e, f), line(g, f),
                  line(g.Translated(0.1 * further), g.Translated(20 * further))}),
        "kinked_wire.brep");
  write(compound({line(gp_Pnt(0, 0, 0), e), line(gp_Pnt(0, 0, 0), f), line(g, gp_Pnt(0, 0, 0))}), "tree.brep");
  // a parabola, and behind the knot 1/2 its continuation with one more in the second derivative; a
  // polygon; a circle
  write(compound({spline({{0, 0, 0}, {1, 1, 0}, {2, 1, 0}, {3, 3, 0}}, 2, {{0.5, 1}}),
                  spline({{5, 0, 0}, {6, 0, 0}, {7, 1, 0}, {8, 1, 0}}, 1, {{0.25, 1}, {0.5, 1}}),
                  arc(a, 2, 0, 2 * M_PI)}),
        "knots.brep");
  // the second derivatives agree: two halves of one cubic, cut at 1/2
  write(compound({spline({{0, 0, 0}, {1, 2, 0}, {2.5, 2, 1}, {4, 1, 1.5}}, 3, {}),
                  spline({{4, 1, 1.5}, {5.5, 0, 2}, {7, -2, 2}, {8, -7, -1}}, 3, {})}),
        "cubics.brep");
}

} // namespace

// Writes the models, and that of a file placed again, if one is given.
int main(int argc, char** argv) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  IGESControl_Controller::Init();
  const TopoDS_Shape fillet = filleted(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), 2);
  for (const char* name : {"fillet.brep", "fillet.step", "fillet.igs", "fillet_apart.igs"}) write(fillet, name);
  for (const char* name : {"washer.step", "washer_apart.igs"}) write(washer(), name);
  write(compound({fillet, moved(fillet)}), "moved.brep");
  for (const char* name : {"separated.brep", "separated.igs"}) write(separated(fillet), name);
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(3, 10).Shape();
  write_assembly(fillet, cylinder);
  write(rough(), "rough.brep");
  write(slow(), "slow.step");
  for (const char* name : {"cylinder.brep", "cylinder.step"}) write(cylinder, name);
  // The radius 5, cut 2.5 above the centre: the normals there are 60 degrees apart.
  const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(gp_Ax2(), 5, -M_PI / 2, M_PI / 6).Shape();
  for (const char* name : {"sphere.brep", "sphere.step"}) write(sphere, name);
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(3, 0, 4).Shape();
  for (const char* name : {"cone.brep", "cone.step"}) write(cone, name);
  const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(5, 2).Shape();
  for (const char* name : {"torus.brep", "torus.step"}) write(torus, name);
  write(wall({gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0), gp_Pnt(2, std::tan(M_PI / 180), 0), gp_Pnt(2, 3, 0)}), "wall.brep");
  const std::vector<gp_Pnt> kinks{gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0), gp_Pnt(2, std::tan(M_PI / 180), 0),
                                  gp_Pnt(3, 0.1, 0)};
  // Narrow, and two faces that part slowly.
  write(wall({gp_Pnt(0, 0, 0), gp_Pnt(0.01, 0, 0)}), "sliver.brep");
  write(wall({gp_Pnt(3, 0, 0), gp_Pnt(0, 0, 0), gp_Pnt(3, 0.05, 0)}), "wedge.brep");
  // 1 degree, and nearly 4
  for (const char* name : {"kinks.brep", "kinks.step"}) write(wall(kinks), name);
  // Beside each other, 0.03 and 0.05 off their planes, each with edges of its own.
  const auto piece = [](double begin, double off) { return wall({gp_Pnt(begin, off, 0), gp_Pnt(begin + 1, off, 0)}); };
  write(compound({piece(0, 0), piece(1, 0.03), piece(2, 0.08)}), "apart.brep");
  std::vector<TopoDS_Shape> tori; // too many to be drawn
  for (int i = 0; i < 25; ++i)
    tori.push_back(BRepPrimAPI_MakeTorus(gp_Ax2(gp_Pnt(20 * i, 0, 0), gp_Dir(0, 0, 1)), 5, 2).Shape());
  write(compound(tori), "tori.brep");
  write(three_faces(), "three.brep");
  write(fading_crease(), "fading.brep");
  const Handle(Geom_BSplineCurve) spline = periodic_spline();
  const TopoDS_Edge ring = BRepBuilderAPI_MakeEdge(spline);
  const TopoDS_Shape disc = BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(ring).Wire(), true).Shape();
  const TopoDS_Shape prism = BRepPrimAPI_MakePrism(disc, gp_Vec(0, 0, 5)).Shape();
  for (const char* name : {"prism.brep", "prism.step"}) write(prism, name);
  write(BRepPrimAPI_MakeRevol(disc, gp_Ax1(gp_Pnt(9, 0, 0), gp_Dir(0, 1, 0))).Shape(), "revolution.brep");
  write(face(GeomConvert::SurfaceToBSplineSurface(new Geom_ToroidalSurface(gp_Ax3(), 5, 2))), "periodic.brep");
  write(face(new Geom_OffsetSurface(new Geom_ToroidalSurface(gp_Ax3(), 5, 2), 0.5)), "offset.brep");
  TColgp_Array2OfPnt points(1, 3, 1, 4);
  for (int i = 1; i <= 3; ++i)
    for (int j = 1; j <= 4; ++j) points.SetValue(i, j, gp_Pnt(i, j + 0.1 * i * i, (i * j) % 3));
  write(face(new Geom_BezierSurface(points)), "bezier.brep");
  write(ring, "wire.brep");
  write_wires();
  // A face that cannot be divided into triangles: it has a boundary that crosses itself.
  BRepBuilderAPI_MakePolygon crossing(gp_Pnt(0, 0, 0), gp_Pnt(2, 2, 0), gp_Pnt(2, 0, 0), gp_Pnt(0, 2, 0), true);
  const TopoDS_Shape crossed = BRepBuilderAPI_MakeFace(gp_Pln(), crossing.Wire()).Shape();
  write(compound({moved(fillet), crossed}), "crossed.brep");
  // An infinite face.
  write(compound({moved(fillet), BRepBuilderAPI_MakeFace(gp_Pln()).Shape()}), "infinite.brep");
  write(trimmed_crease(), "trimmed.brep");
  // the curvature jumps in the middle
  write(face(strip({{0, 0}, {5, 0}, {15, 0}, {20, 5}}, 2, 0)), "bending.brep");
  write(pairs(), "pairs.brep");
  // Two flat faces side by side, each with edges of its own and a knot line in the middle.
  const TopoDS_Shape flat = face(strip({{0, 0}, {5, 0}, {10, 0}}, 1, 0));
  gp_Trsf aside;
  aside.SetTranslation(gp_Vec(0, 10, 0));
  const TopoDS_Shape flats = compound({flat, BRepBuilderAPI_Copy(flat).Shape().Moved(TopLoc_Location(aside))});
  for (const char* name : {"flats.brep", "flats_apart.igs"}) write(flats, name);
  // This model cannot be compared at equal parameters.
  TopoDS_Shape differing = BRepPrimAPI_MakeCylinder(3, 10).Shape();
  BRep_Builder().SameParameter(TopoDS::Edge(TopExp_Explorer(differing, TopAbs_EDGE).Current()), false);
  write(differing, "differing.brep");
  if (argc < 2) return 0;
  TopoDS_Shape given;
  require(BRepTools::Read(given, argv[1], BRep_Builder()), argv[1]);
  write(compound({given, moved(given)}), "again.brep");
}
