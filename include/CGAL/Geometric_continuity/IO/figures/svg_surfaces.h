// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_SVG_SURFACES_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_SVG_SURFACES_H

#define CGAL_DEPRECATED_HEADER "<CGAL/Geometric_continuity/IO/figures/svg_surfaces.h>"
#define CGAL_REPLACEMENT_HEADER "<Geometric_continuity_figures/svg_surfaces.h>"
#include <CGAL/Installation/internal/deprecation_warning.h>

#include <Geometric_continuity_figures/svg_surfaces.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_SVG_SURFACES_H
