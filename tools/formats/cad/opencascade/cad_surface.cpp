// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/cad_surface.h"
#include "formats/cad/opencascade/spline_numbers.h"

#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <gp_Ax3.hxx>

#include <memory>
#include <utility>

namespace {

typedef GC::Cad_elementary_surface Elementary;

Elementary elementary(Elementary::Kind kind, const Geom_ElementarySurface& surface, double radius = 0,
                      double other = 0) {
  const gp_Ax3& axes = surface.Position();
  return {kind,
          {checked(axes.Location().XYZ()), checked(axes.XDirection().XYZ()), checked(axes.YDirection().XYZ()),
           checked(axes.Direction().XYZ())},
          checked(radius),
          checked(other)};
}

// The control points and weights; those of a periodic spline again for each period.
template <class Source> GC::Cad_spline_surface with_points(const Source& source, Flat_knots u, Flat_knots v) {
  GC::Cad_spline_surface result{u.degree, v.degree, {}, {}, {}, {}};
  const std::size_t m = static_cast<std::size_t>(source.NbUPoles()), n = static_cast<std::size_t>(source.NbVPoles());
  const bool rational = source.IsURational() || source.IsVRational();
  for (std::size_t i = 0; i < u.points(); ++i)
    for (std::size_t j = 0; j < v.points(); ++j) {
      const int a = static_cast<int>(i % m) + 1, b = static_cast<int>(j % n) + 1;
      result.points.push_back(checked(source.Pole(a, b).XYZ()));
      if (rational) result.weights.push_back(checked(source.Weight(a, b)));
    }
  result.u_knots = std::move(u.knots);
  result.v_knots = std::move(v.knots);
  return result;
}

GC::Cad_spline_surface spline(const Geom_BSplineSurface& s, const Used_range& u, const Used_range& v) {
  std::vector<double> u_knots, v_knots;
  std::vector<int> u_multiplicities, v_multiplicities;
  for (int i = 1; i <= s.NbUKnots(); ++i) {
    u_knots.push_back(s.UKnot(i));
    u_multiplicities.push_back(s.UMultiplicity(i));
  }
  for (int i = 1; i <= s.NbVKnots(); ++i) {
    v_knots.push_back(s.VKnot(i));
    v_multiplicities.push_back(s.VMultiplicity(i));
  }
  return with_points(s, flat_knots(s.UDegree(), s.IsUPeriodic(), u_knots, u_multiplicities, u),
                     flat_knots(s.VDegree(), s.IsVPeriodic(), v_knots, v_multiplicities, v));
}

GC::Cad_spline_surface spline(const Geom_BezierSurface& s) {
  const auto knots = [](int degree) { return flat_knots(degree, false, {0, 1}, {degree + 1, degree + 1}, {0, 1}); };
  return with_points(s, knots(s.UDegree()), knots(s.VDegree()));
}

} // namespace

GC::Cad_surface cad_surface(const Handle(Geom_Surface) & surface, const Used_range& u, const Used_range& v) {
  const Standard_Transient* const s = surface.get();
  typedef Elementary::Kind Kind;
  if (const auto* plane = dynamic_cast<const Geom_Plane*>(s)) return elementary(Kind::plane, *plane);
  if (const auto* cylinder = dynamic_cast<const Geom_CylindricalSurface*>(s))
    return elementary(Kind::cylinder, *cylinder, cylinder->Radius());
  if (const auto* cone = dynamic_cast<const Geom_ConicalSurface*>(s))
    return elementary(Kind::cone, *cone, cone->RefRadius(), cone->SemiAngle());
  if (const auto* sphere = dynamic_cast<const Geom_SphericalSurface*>(s))
    return elementary(Kind::sphere, *sphere, sphere->Radius());
  if (const auto* torus = dynamic_cast<const Geom_ToroidalSurface*>(s))
    return elementary(Kind::torus, *torus, torus->MajorRadius(), torus->MinorRadius());
  if (const auto* bspline = dynamic_cast<const Geom_BSplineSurface*>(s)) return spline(*bspline, u, v);
  if (const auto* bezier = dynamic_cast<const Geom_BezierSurface*>(s)) return spline(*bezier);
  if (const auto* extrusion = dynamic_cast<const Geom_SurfaceOfLinearExtrusion*>(s))
    return GC::Cad_extrusion{cad_curve(extrusion->BasisCurve(), u), checked(extrusion->Direction().XYZ())};
  if (const auto* revolution = dynamic_cast<const Geom_SurfaceOfRevolution*>(s))
    return GC::Cad_revolution{cad_curve(revolution->BasisCurve(), v), checked(revolution->Location().XYZ()),
                              checked(revolution->Direction().XYZ())};
  if (const auto* offset = dynamic_cast<const Geom_OffsetSurface*>(s))
    return GC::Cad_offset_surface{std::make_shared<const GC::Cad_surface>(cad_surface(offset->BasisSurface(), u, v)),
                                  checked(offset->Offset())};
  if (const auto* trimmed = dynamic_cast<const Geom_RectangularTrimmedSurface*>(s))
    return cad_surface(trimmed->BasisSurface(), u, v);
  throw Not_covered(surface->DynamicType()->Name());
}

std::string surface_name(const Handle(Geom_Surface) & surface) {
  const Standard_Transient* const s = surface.get();
  if (const auto* trimmed = dynamic_cast<const Geom_RectangularTrimmedSurface*>(s))
    return surface_name(trimmed->BasisSurface());
  static const std::pair<Handle(Standard_Type), const char*> names[] = {
      {STANDARD_TYPE(Geom_Plane), "plane"},
      {STANDARD_TYPE(Geom_CylindricalSurface), "cylinder"},
      {STANDARD_TYPE(Geom_ConicalSurface), "cone"},
      {STANDARD_TYPE(Geom_SphericalSurface), "sphere"},
      {STANDARD_TYPE(Geom_ToroidalSurface), "torus"},
      {STANDARD_TYPE(Geom_BSplineSurface), "B-spline surface"},
      {STANDARD_TYPE(Geom_BezierSurface), "Bezier surface"},
      {STANDARD_TYPE(Geom_SurfaceOfLinearExtrusion), "extrusion"},
      {STANDARD_TYPE(Geom_SurfaceOfRevolution), "revolution"},
      {STANDARD_TYPE(Geom_OffsetSurface), "offset surface"}};
  for (const auto& [type, name] : names)
    if (surface->IsKind(type)) return name;
  return surface->DynamicType()->Name();
}
