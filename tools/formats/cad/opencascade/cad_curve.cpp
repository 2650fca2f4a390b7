// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/cad_curve.h"
#include "formats/cad/opencascade/spline_numbers.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Hyperbola.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <Geom2d_Parabola.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <gp_Ax22d.hxx>
#include <gp_Dir.hxx>
#include <gp_Dir2d.hxx>

#include <memory>
#include <utility>

namespace {

// The names of the classes in the plane and in space.
struct Plane_classes {
  static constexpr int dimension = 2;
  typedef Geom2d_Line Line;
  typedef Geom2d_Circle Circle;
  typedef Geom2d_Ellipse Ellipse;
  typedef Geom2d_Hyperbola Hyperbola;
  typedef Geom2d_Parabola Parabola;
  typedef Geom2d_BezierCurve Bezier;
  typedef Geom2d_BSplineCurve Spline;
  typedef Geom2d_TrimmedCurve Trimmed;
  typedef Geom2d_OffsetCurve Offset;
  static GC::Cad_point<2> reference(const Offset&) { return {0, 0}; }
};
struct Space_classes {
  static constexpr int dimension = 3;
  typedef Geom_Line Line;
  typedef Geom_Circle Circle;
  typedef Geom_Ellipse Ellipse;
  typedef Geom_Hyperbola Hyperbola;
  typedef Geom_Parabola Parabola;
  typedef Geom_BezierCurve Bezier;
  typedef Geom_BSplineCurve Spline;
  typedef Geom_TrimmedCurve Trimmed;
  typedef Geom_OffsetCurve Offset;
  static GC::Cad_point<3> reference(const Offset& offset) { return checked(offset.Direction().XYZ()); }
};

const gp_XY& coordinates_of(const gp_Dir2d& d) { return d.XY(); }
const gp_XYZ& coordinates_of(const gp_Dir& d) { return d.XYZ(); }

template <class Classes> class Curve_reader {
  static constexpr int D = Classes::dimension;
  typedef GC::Cad_conic<D> Conic;
  typedef GC::Cad_spline_curve<D> Spline;

  template <class Source>
  static GC::Cad_curve<D> conic(typename Conic::Kind kind, const Source& source, double a, double b) {
    const auto axes = source.Position();
    return Conic{kind,
                 checked(axes.Location().Coord()),
                 checked(coordinates_of(axes.XDirection())),
                 checked(coordinates_of(axes.YDirection())),
                 checked(a),
                 checked(b)};
  }

  // The control points and weights; those of a periodic spline again for each period.
  template <class Source> static Spline with_points(const Source& source, Flat_knots flat) {
    Spline result{flat.degree, {}, {}, {}};
    const std::size_t n = static_cast<std::size_t>(source.NbPoles());
    for (std::size_t i = 0; i < flat.points(); ++i) {
      const int number = static_cast<int>(i % n) + 1;
      result.points.push_back(checked(source.Pole(number).Coord()));
      if (source.IsRational()) result.weights.push_back(checked(source.Weight(number)));
    }
    result.knots = std::move(flat.knots);
    return result;
  }

  static Spline spline(const typename Classes::Spline& source, const Used_range& used) {
    std::vector<double> knots;
    std::vector<int> multiplicities;
    for (int i = 1; i <= source.NbKnots(); ++i) {
      knots.push_back(source.Knot(i));
      multiplicities.push_back(source.Multiplicity(i));
    }
    return with_points(source, flat_knots(source.Degree(), source.IsPeriodic(), knots, multiplicities, used));
  }

  static Spline spline(const typename Classes::Bezier& source) {
    const int order = source.Degree() + 1;
    return with_points(source, flat_knots(source.Degree(), false, {0, 1}, {order, order}, {0, 1}));
  }

public:
  template <class Curve> static GC::Cad_curve<D> read(const Handle(Curve) & curve, const Used_range& used) {
    const Standard_Transient* const c = curve.get();
    if (const auto* line = dynamic_cast<const typename Classes::Line*>(c))
      return GC::Cad_line<D>{checked(line->Position().Location().Coord()),
                             checked(coordinates_of(line->Position().Direction()))};
    if (const auto* circle = dynamic_cast<const typename Classes::Circle*>(c))
      return conic(Conic::Kind::ellipse, *circle, circle->Radius(), circle->Radius());
    if (const auto* ellipse = dynamic_cast<const typename Classes::Ellipse*>(c))
      return conic(Conic::Kind::ellipse, *ellipse, ellipse->MajorRadius(), ellipse->MinorRadius());
    if (const auto* hyperbola = dynamic_cast<const typename Classes::Hyperbola*>(c))
      return conic(Conic::Kind::hyperbola, *hyperbola, hyperbola->MajorRadius(), hyperbola->MinorRadius());
    if (const auto* parabola = dynamic_cast<const typename Classes::Parabola*>(c)) {
      if (!(parabola->Focal() > 0)) throw Not_covered("a parabola without focal length");
      return conic(Conic::Kind::parabola, *parabola, parabola->Focal(), 0);
    }
    if (const auto* bezier = dynamic_cast<const typename Classes::Bezier*>(c)) return spline(*bezier);
    if (const auto* bspline = dynamic_cast<const typename Classes::Spline*>(c)) return spline(*bspline, used);
    if (const auto* trimmed = dynamic_cast<const typename Classes::Trimmed*>(c))
      return read(trimmed->BasisCurve(), used);
    if (const auto* offset = dynamic_cast<const typename Classes::Offset*>(c))
      return GC::Cad_offset_curve<D>{std::make_shared<const GC::Cad_curve<D>>(read(offset->BasisCurve(), used)),
                                     checked(offset->Offset()), Classes::reference(*offset)};
    throw Not_covered(curve->DynamicType()->Name());
  }
};

} // namespace

GC::Cad_curve<2> cad_curve(const Handle(Geom2d_Curve) & curve, const Used_range& used) {
  return Curve_reader<Plane_classes>::read(curve, used);
}
GC::Cad_curve<3> cad_curve(const Handle(Geom_Curve) & curve, const Used_range& used) {
  return Curve_reader<Space_classes>::read(curve, used);
}
