// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Checks that the curves and surfaces of CAD files, as the program reads them, have the points that
// OpenCASCADE computes: at random parameters, also in other periods.
// Usage: check_conversion FILE...

#include "formats/cad/opencascade/cad_surface.h"
#include "formats/cad/opencascade/read_model.h"
#include "tools/cad/evaluate.h"

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace {

std::mt19937 random_numbers(20);
std::size_t checks = 0, failures = 0;

double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_numbers); }

template <std::size_t D>
void check(const std::string& what, const std::array<double, D>& p, const std::array<double, D>& expected,
           bool is_offset) {
  ++checks;
  double error = 0, size = 1;
  for (std::size_t i = 0; i < D; ++i) {
    error = (std::max)(error, std::abs(p[i] - expected[i]));
    size = (std::max)(size, std::abs(expected[i]));
  }
  if (error <= (is_offset ? 1e-8 : 1e-12) * size) return;
  if (++failures <= 20) std::cout << what << ": wrong by " << error << '\n';
}

void check_surface(const std::string& file, const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location);
  Used_range u, v;
  BRepTools::UVBounds(face, u.begin, u.end, v.begin, v.end);
  for (int periods = 0; periods < 3; ++periods) {
    if (periods > 0) { // other ones
      const double du = surface->IsUPeriodic() ? surface->UPeriod() : 0,
                   dv = surface->IsVPeriodic() ? surface->VPeriod() : 0;
      const int a = periods == 1 ? -2 : 1, b = periods == 1 ? 1 : 3;
      u = {u.begin + a * du, u.end + b * du};
      v = {v.begin + b * dv, v.end + b * dv};
    }
    const GC::Cad_surface given = cad_surface(surface, u, v);
    const bool is_offset = std::holds_alternative<GC::Cad_offset_surface>(given);
    for (int i = 0; i < 20; ++i) {
      const double s = between(u.begin, u.end), t = between(v.begin, v.end);
      const gp_Pnt p = surface->Value(s, t);
      check(file + ": " + surface_name(surface), value(given, s, t), {p.X(), p.Y(), p.Z()}, is_offset);
    }
  }
}

void check_curves(const std::string& file, const TopoDS_Face& face) {
  for (TopExp_Explorer i(face, TopAbs_EDGE); i.More(); i.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(i.Current());
    double begin = 0, end = 0;
    const Handle(Geom2d_Curve) plane_curve = BRep_Tool::CurveOnSurface(edge, face, begin, end);
    if (!plane_curve.IsNull()) {
      const GC::Cad_curve<2> given = cad_curve(plane_curve, {begin, end});
      for (int k = 0; k < 10; ++k) {
        const double t = between(begin, end);
        const gp_Pnt2d p = plane_curve->Value(t);
        check(file + ": curve in the plane", value<2>(given, t), {p.X(), p.Y()}, given.index() == 3);
      }
    }
    TopLoc_Location location;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, begin, end);
    if (curve.IsNull()) continue;
    const double period = curve->IsPeriodic() ? curve->Period() : 0;
    begin -= period;
    end += 2 * period;
    const GC::Cad_curve<3> given = cad_curve(curve, {begin, end});
    for (int k = 0; k < 10; ++k) {
      const double t = between(begin, end);
      const gp_Pnt p = curve->Value(t);
      check(file + ": curve", value<3>(given, t), {p.X(), p.Y(), p.Z()}, given.index() == 3);
    }
  }
}

} // namespace

int main(int argc, char* argv[]) {
  for (int i = 1; i < argc; ++i) {
    try {
      for (TopExp_Explorer f(read_shape(argv[i], {}).shape, TopAbs_FACE); f.More(); f.Next()) {
        const TopoDS_Face face = TopoDS::Face(f.Current());
        check_surface(argv[i], face);
        check_curves(argv[i], face);
      }
    } catch (const Standard_Failure& e) {
      std::cout << argv[i] << ": " << e.DynamicType()->Name() << ": " << e.GetMessageString() << '\n';
      ++failures;
    } catch (const std::exception& e) {
      std::cout << argv[i] << ": " << e.what() << '\n';
      ++failures;
    }
  }
  std::cout << checks << " points, " << failures << " wrong\n";
  return failures == 0 && checks > 0 ? 0 : 1;
}
