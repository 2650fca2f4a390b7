// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_CAD_CURVE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_CAD_CURVE_H

#include <CGAL/Geometric_continuity/cad/Cad_geometry.h>

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>

#include <stdexcept>
#include <string>

namespace GC = CGAL::Geometric_continuity;

// Is thrown for geometry that the types of Cad_geometry.h cannot express; the message names it,
// e.g. "Geom_OffsetCurve".
struct Not_covered : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The parameters where a curve, or a surface in one direction, is used: which periods of a spline
// are needed.
struct Used_range {
  double begin, end;
};

// Return the curve by the numbers that OpenCASCADE holds: nothing is computed, but the knots of
// further periods. Throw Not_covered, also for numbers that are not finite.
GC::Cad_curve<2> cad_curve(const Handle(Geom2d_Curve) & curve, const Used_range& used);
GC::Cad_curve<3> cad_curve(const Handle(Geom_Curve) & curve, const Used_range& used);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_CAD_CURVE_H
