// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_POLYGON_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_POLYGON_H

#define CGAL_DEPRECATED_HEADER "<CGAL/Geometric_continuity/curves/Bezier_polygon.h>"
#define CGAL_REPLACEMENT_HEADER "<CGAL/Geometric_continuity/curves/Bezier_curve.h>"
#include <CGAL/Installation/internal/deprecation_warning.h>

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_POLYGON_H
