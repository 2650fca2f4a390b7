// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_CAD_EDGE_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_CAD_EDGE_CONTINUITY_H

#define CGAL_DEPRECATED_HEADER "<CGAL/Geometric_continuity/edges/cad_edge_continuity.h>"
#define CGAL_REPLACEMENT_HEADER "<CGAL/Geometric_continuity/cad/cad_edge_continuity.h>"
#include <CGAL/Installation/internal/deprecation_warning.h>

#include <CGAL/Geometric_continuity/cad/cad_edge_continuity.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_CAD_EDGE_CONTINUITY_H
