// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_FUNCTION_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_FUNCTION_H

#define CGAL_DEPRECATED_HEADER "<CGAL/Geometric_continuity/edges/Edge_function.h>"
#define CGAL_REPLACEMENT_HEADER "<CGAL/Geometric_continuity/splines/Bspline_function.h>"
#include <CGAL/Installation/internal/deprecation_warning.h>

#include <CGAL/Geometric_continuity/splines/Bspline_function.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_FUNCTION_H
