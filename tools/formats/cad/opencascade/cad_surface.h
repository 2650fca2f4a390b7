// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_CAD_SURFACE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_CAD_SURFACE_H

#include "formats/cad/opencascade/cad_curve.h"

#include <Geom_Surface.hxx>

#include <string>

// Returns the surface by the numbers that OpenCASCADE holds, for the parameters in these ranges.
// Throws Not_covered.
GC::Cad_surface cad_surface(const Handle(Geom_Surface) & surface, const Used_range& u, const Used_range& v);

// Returns what a surface is, e.g. "cylinder"; the name of its class in OpenCASCADE when it is none
// of those that are covered.
std::string surface_name(const Handle(Geom_Surface) & surface);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_CAD_SURFACE_H
