// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CERTIFICATE_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CERTIFICATE_H

#define CGAL_DEPRECATED_HEADER "<CGAL/Geometric_continuity/edges/Edge_certificate.h>"
#define CGAL_REPLACEMENT_HEADER "<CGAL/Geometric_continuity/edges/edge_continuity.h>"
#include <CGAL/Installation/internal/deprecation_warning.h>

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_EDGE_CERTIFICATE_H
