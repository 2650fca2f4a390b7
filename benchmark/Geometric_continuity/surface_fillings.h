// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BENCHMARK_SURFACE_FILLINGS_H
#define GEOMETRIC_CONTINUITY_BENCHMARK_SURFACE_FILLINGS_H

// OpenCASCADE and SISL fill the gap between the edge v1 of one patch and the edge v0 of another
// one, with given sides. A function measures how far a surface is from continuing both patches.

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT

#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepFill_Filling.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomFill_BoundWithSurf.hxx>
#include <GeomFill_ConstrainedFilling.hxx>
#include <GeomFill_SimpleBound.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <sisl.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ostream>
#include <utility>
#include <vector>

namespace peers {

namespace GC = CGAL::Geometric_continuity;

template <class Traits> Handle(Geom_BezierSurface) occt_patch(const GC::Bezier_patch<Traits>& s) {
  TColgp_Array2OfPnt poles(1, s.degree_u() + 1, 1, s.degree_v() + 1);
  for (int i = 0; i <= s.degree_u(); ++i)
    for (int j = 0; j <= s.degree_v(); ++j) {
      const auto& p = s.control_point(i, j);
      poles.SetValue(i + 1, j + 1, gp_Pnt(p.x(), p.y(), p.z()));
    }
  return new Geom_BezierSurface(poles);
}

// The curve u = constant at one end of the domain of a patch.
inline Handle(Geom_BezierCurve) side(const Handle(Geom_BezierSurface) & s, bool upper) {
  TColgp_Array1OfPnt poles(1, s->NbVPoles());
  for (int j = 1; j <= s->NbVPoles(); ++j) poles.SetValue(j, s->Pole(upper ? s->NbUPoles() : 1, j));
  return new Geom_BezierCurve(poles);
}

// The two patches, and the side curves between them.
struct Filling_input {
  Handle(Geom_BezierSurface) a, b;
  std::array<Handle(Geom_BezierCurve), 2> sides;
};

// By energies of a plate whose curvature is prescribed at points of the edges, and approximation by
// splines.
inline Handle(Geom_Surface) occt_filling(const Filling_input& x) {
  BRepFill_Filling filling;
  for (const bool first : {true, false}) {
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(first ? x.a : x.b, 1e-9);
    const double v = first ? 1 : 0;
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
      double from, to;
      const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, from, to);
      if (std::abs(curve->Value(from).Y() - v) < 1e-6 && std::abs(curve->Value(to).Y() - v) < 1e-6)
        filling.Add(edge, face, GeomAbs_G2);
    }
  }
  for (const Handle(Geom_BezierCurve) & curve : x.sides)
    filling.Add(TopoDS_Edge(BRepBuilderAPI_MakeEdge(curve)), GeomAbs_C0);
  filling.Build();
  return filling.IsDone() ? BRep_Tool::Surface(filling.Face()) : Handle(Geom_Surface)();
}

// By blending functions, with the tangent planes of the patches.
inline Handle(Geom_Surface) occt_constrained_filling(const Filling_input& x) {
  const auto along_edge = [](const Handle(Geom_BezierSurface) & s, double v) -> Handle(GeomFill_Boundary) {
    const Handle(Geom2d_Curve) line = new Geom2d_TrimmedCurve(new Geom2d_Line(gp_Pnt2d(0, v), gp_Dir2d(1, 0)), 0, 1);
    return new GeomFill_BoundWithSurf(
        Adaptor3d_CurveOnSurface(new Geom2dAdaptor_Curve(line), new GeomAdaptor_Surface(s)), 1e-4, 1e-2);
  };
  const auto along_side = [](const Handle(Geom_BezierCurve) & c) -> Handle(GeomFill_Boundary) {
    return new GeomFill_SimpleBound(new GeomAdaptor_Curve(c), 1e-4, 1e-2);
  };
  GeomFill_ConstrainedFilling filling(8, 9);
  filling.Init(along_edge(x.a, 1), along_side(x.sides[1]), along_edge(x.b, 0), along_side(x.sides[0]));
  return filling.Surface();
}

#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
// A curve of SISL on [0, 1] with these control points.
inline SISLCurve* sisl_curve(const std::vector<gp_XYZ>& points) {
  const int n = static_cast<int>(points.size());
  std::vector<double> knots(2 * points.size()), numbers;
  std::fill(knots.begin() + n, knots.end(), 1.);
  for (const gp_XYZ& p : points) numbers.insert(numbers.end(), {p.X(), p.Y(), p.Z()});
  return newCurve(n, n, knots.data(), numbers.data(), 1, 3, 1);
}

// The edge of a patch, and its first two derivatives across the edge, with the sign that they are
// to have in SISL.
inline void add_edge(std::vector<SISLCurve*>& curves, const Handle(Geom_BezierSurface) & s, bool upper, int sign) {
  const int n = s->NbUPoles(), m = s->NbVPoles();
  std::array<std::vector<gp_XYZ>, 3> rows;
  for (int i = 1; i <= n; ++i) {
    const auto p = [&](int k) { return s->Pole(i, upper ? m - k : 1 + k).XYZ(); };
    rows[0].push_back(p(0));
    rows[1].push_back((p(0) - p(1)) * ((upper ? sign : -sign) * (m - 1)));
    rows[2].push_back((p(0) - p(1) * 2 + p(2)) * (sign * (m - 1) * (m - 2)));
  }
  for (const std::vector<gp_XYZ>& row : rows) curves.push_back(sisl_curve(row));
}
inline void add_side(std::vector<SISLCurve*>& curves, const Handle(Geom_BezierCurve) & c) {
  std::vector<gp_XYZ> points;
  for (int i = 1; i <= c->NbPoles(); ++i) points.push_back(c->Pole(i).XYZ());
  curves.push_back(sisl_curve(points));
}

// The surface of SISL, of which the control points of one row follow each other; frees it and what
// it was made of.
inline Handle(Geom_Surface) taken(SISLSurf* surface, int status, const std::vector<SISLCurve*>& curves) {
  for (SISLCurve* c : curves) freeCurve(c);
  if (status < 0) return Handle(Geom_Surface)();
  TColgp_Array2OfPnt poles(1, surface->in1, 1, surface->in2);
  for (int j = 0; j < surface->in2; ++j)
    for (int i = 0; i < surface->in1; ++i) {
      const double* p = surface->ecoef + 3 * (j * surface->in1 + i);
      poles.SetValue(i + 1, j + 1, gp_Pnt(p[0], p[1], p[2]));
    }
  const auto knots = [](const double* t, int n) {
    std::vector<double> values;
    std::vector<int> multiplicities;
    for (int i = 0; i < n; ++i)
      if (values.empty() || values.back() < t[i]) {
        values.push_back(t[i]);
        multiplicities.push_back(1);
      } else
        ++multiplicities.back();
    const int size = static_cast<int>(values.size());
    std::pair<TColStd_Array1OfReal, TColStd_Array1OfInteger> r{{1, size}, {1, size}};
    std::copy(values.begin(), values.end(), r.first.begin());
    std::copy(multiplicities.begin(), multiplicities.end(), r.second.begin());
    return r;
  };
  const auto u = knots(surface->et1, surface->in1 + surface->ik1), v = knots(surface->et2, surface->in2 + surface->ik2);
  const Handle(Geom_Surface) r =
      new Geom_BSplineSurface(poles, u.first, v.first, u.second, v.second, surface->ik1 - 1, surface->ik2 - 1);
  freeSurf(surface);
  return r;
}

// Between the four curves, of which the two edges have derivatives across them. It turns those at
// the third curve, the second ones, too. What length its parameter across them has is not told, so
// that derivatives and sides do not fit each other, and the sides are kept.
inline Handle(Geom_Surface) sisl_blend(const Filling_input& x) {
  std::vector<SISLCurve*> curves;
  add_edge(curves, x.a, true, 1);
  add_side(curves, x.sides[1]);
  add_edge(curves, x.b, false, -1);
  add_side(curves, x.sides[0]);
  int numbers[] = {3, 1, 3, 1}, status = 0;
  SISLSurf* surface = nullptr;
  s1390(curves.data(), &surface, numbers, &status);
  return taken(surface, status, curves);
}

// Between the two edges, whatever the sides are: interpolation across them. The types say: a curve,
// its derivative, its second derivative.
inline Handle(Geom_Surface) sisl_loft(const Filling_input& x) {
  std::vector<SISLCurve*> curves;
  add_edge(curves, x.a, true, 1);
  add_edge(curves, x.b, false, 1);
  int types[] = {1, 4, 6, 1, 4, 6}, status = 0;
  SISLSurf* surface = nullptr;
  double* parameters = nullptr;
  s1538(6, curves.data(), types, 0, 1, 6, 0, &surface, &parameters, &status);
  std::free(parameters);
  return taken(surface, status, curves);
}
#endif

// The largest differences along both edges, at a hundred points of each.
struct Filling_error {
  double gap = 0, angle = 0,
         // in degrees; of curvature across the edges, relative to the largest one there
      curvature = 0;

  friend std::ostream& operator<<(std::ostream& os, const Filling_error& e) {
    return os << "gap " << e.gap << ", angle " << e.angle << " degrees, jump of the curvature across "
              << 100 * e.curvature << " % of the largest";
  }
};

// The normal and, in a direction of the tangent plane, the normal curvature.
struct Surface_at {
  gp_Vec u, v, uu, vv, uv, normal;

  Surface_at(const Handle(Geom_Surface) & s, double at_u, double at_v) {
    gp_Pnt p;
    s->D2(at_u, at_v, p, u, v, uu, vv, uv);
    normal = u.Crossed(v).Normalized();
  }
  double curvature(const gp_Vec& direction) const {
    const double e = u.Dot(u), f = u.Dot(v), g = v.Dot(v), x = u.Dot(direction), y = v.Dot(direction),
                 det = e * g - f * f, a = (g * x - f * y) / det, b = (e * y - f * x) / det;
    return (a * a * uu.Dot(normal) + 2 * a * b * uv.Dot(normal) + b * b * vv.Dot(normal)) /
           (a * a * e + 2 * a * b * f + b * b * g);
  }
};

inline Filling_error error_of(const Filling_input& x, const Handle(Geom_Surface) & s) {
  Filling_error worst;
  double largest = 0, jump = 0;
  for (const bool first : {true, false})
    for (int i = 0; i <= 100; ++i) {
      const double t = i / 100., v = first ? 1 : 0;
      const Handle(Geom_BezierSurface)& given = first ? x.a : x.b;
      const gp_Pnt p = given->Value(t, v);
      GeomAPI_ProjectPointOnSurf foot(p, s, 1e-12);
      if (foot.NbPoints() == 0) continue;
      double foot_u, foot_v;
      foot.LowerDistanceParameters(foot_u, foot_v);
      const Surface_at g(given, t, v), r(s, foot_u, foot_v);
      const double sign = g.normal.Dot(r.normal) < 0 ? -1 : 1;
      const gp_Vec across = g.normal.Crossed(g.u).Normalized();
      worst.gap = std::max(worst.gap, foot.LowerDistance());
      worst.angle =
          std::max(worst.angle, std::atan2(g.normal.Crossed(r.normal).Magnitude(), sign * g.normal.Dot(r.normal)) * 45 /
                                    std::atan(1.));
      largest = std::max(largest, std::abs(g.curvature(across)));
      jump = std::max(jump, std::abs(g.curvature(across) - sign * r.curvature(across)));
    }
  worst.curvature = jump / largest;
  return worst;
}

} // namespace peers

#endif // GEOMETRIC_CONTINUITY_WITH_OCCT

#endif // GEOMETRIC_CONTINUITY_BENCHMARK_SURFACE_FILLINGS_H
