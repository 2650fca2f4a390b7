// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_NEAR_EDGES_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_NEAR_EDGES_H

#define CGAL_DEPRECATED_HEADER "<CGAL/Geometric_continuity/models/near_edges.h>"
#define CGAL_REPLACEMENT_HEADER "<CGAL/Geometric_continuity/models/model_continuity.h>"
#include <CGAL/Installation/internal/deprecation_warning.h>

#include <CGAL/Geometric_continuity/models/model_continuity.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_NEAR_EDGES_H
