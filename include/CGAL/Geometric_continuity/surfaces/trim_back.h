// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_TRIM_BACK_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_TRIM_BACK_H

#define CGAL_DEPRECATED_HEADER "<CGAL/Geometric_continuity/surfaces/trim_back.h>"
#define CGAL_REPLACEMENT_HEADER "<CGAL/Geometric_continuity/surfaces/cut_back.h>"
#include <CGAL/Installation/internal/deprecation_warning.h>

#include <CGAL/Geometric_continuity/surfaces/cut_back.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_TRIM_BACK_H
