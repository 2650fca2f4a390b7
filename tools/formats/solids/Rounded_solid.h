// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_ROUNDED_SOLID_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_ROUNDED_SOLID_H

#include <CGAL/Geometric_continuity/models/round_polyhedron.h>
#include <CGAL/Simple_cartesian.h>

// A solid with rounded edges, in floating point.
typedef CGAL::Geometric_continuity::Rounded_polyhedron<
    CGAL::Geometric_continuity::Traits_3<CGAL::Simple_cartesian<double>>>
    Rounded_solid;

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_ROUNDED_SOLID_H
