// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_PLANE_CURVATURE_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_PLANE_CURVATURE_H

#include "commands/chains/curvature_bound.h"

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Simple_cartesian.h>

#include <optional>

// The place where a curve of a drawing, a glyph or a road is bent most, if it exceeds a bound.
std::optional<GC::Curvature_excess>
curvature_excess(const GC::Bezier_curve<GC::Traits_2<CGAL::Simple_cartesian<Exact>>>& curve,
                 const Curvature_bound& bound);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_PLANE_CURVATURE_H
