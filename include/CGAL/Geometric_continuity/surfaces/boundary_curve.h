// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_BOUNDARY_CURVE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_BOUNDARY_CURVE_H

#define CGAL_DEPRECATED_HEADER "<CGAL/Geometric_continuity/surfaces/boundary_curve.h>"
#define CGAL_REPLACEMENT_HEADER "<CGAL/Geometric_continuity/surfaces/Rational_surface.h>"
#include <CGAL/Installation/internal/deprecation_warning.h>

#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_BOUNDARY_CURVE_H
