// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_SVG_PANEL_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_SVG_PANEL_H

#define CGAL_DEPRECATED_HEADER "<CGAL/Geometric_continuity/IO/figures/Svg_panel.h>"
#define CGAL_REPLACEMENT_HEADER "<Geometric_continuity_figures/Svg_panel.h>"
#include <CGAL/Installation/internal/deprecation_warning.h>

#include <Geometric_continuity_figures/Svg_panel.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_SVG_PANEL_H
