// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_KINK_BOUND_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_KINK_BOUND_H

#define CGAL_DEPRECATED_HEADER "<CGAL/Geometric_continuity/joins/Kink_bound.h>"
#define CGAL_REPLACEMENT_HEADER "<CGAL/Geometric_continuity/joins/Corner_threshold.h>"
#include <CGAL/Installation/internal/deprecation_warning.h>

#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_KINK_BOUND_H
