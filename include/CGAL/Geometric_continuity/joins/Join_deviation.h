// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_DEVIATION_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_DEVIATION_H

#define CGAL_DEPRECATED_HEADER "<CGAL/Geometric_continuity/joins/Join_deviation.h>"
#define CGAL_REPLACEMENT_HEADER "<CGAL/Geometric_continuity/joins/deviation.h>"
#include <CGAL/Installation/internal/deprecation_warning.h>

#include <CGAL/Geometric_continuity/joins/deviation.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_DEVIATION_H
