// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_REPAIRS_GRID_VECTOR_H
#define CGAL_GEOMETRIC_CONTINUITY_REPAIRS_GRID_VECTOR_H

#define CGAL_DEPRECATED_HEADER "<CGAL/Geometric_continuity/repairs/Grid_vector.h>"
#define CGAL_REPLACEMENT_HEADER "<CGAL/Geometric_continuity/repairs/align_handles.h>"
#include <CGAL/Installation/internal/deprecation_warning.h>

#include <CGAL/Geometric_continuity/repairs/align_handles.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_REPAIRS_GRID_VECTOR_H
