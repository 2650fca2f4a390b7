// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_BLEND_SIDES_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_BLEND_SIDES_H

#define CGAL_DEPRECATED_HEADER "<CGAL/Geometric_continuity/surface_blends/blend_sides.h>"
#define CGAL_REPLACEMENT_HEADER "<CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>"
#include <CGAL/Installation/internal/deprecation_warning.h>

#include <CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_BLEND_SIDES_H
