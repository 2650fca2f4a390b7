// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_SEGMENT_CURVATURE_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_SEGMENT_CURVATURE_H

#include "commands/chains/curvature_bound.h"
#include "formats/svg/svg_drawing.h"

#include <CGAL/Geometric_continuity/curves/fairness.h>

#include <optional>

// Finds where the curvature of a segment of a drawing exceeds a bound, if it does. Returns false
// for arcs of ellipses that are no circles and have no rational numbers.
bool decide_curvature(const GC::Svg_segment<Drawing_traits>& segment, const Curvature_bound& bound,
                      std::optional<GC::Curvature_excess>& excess);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_SEGMENT_CURVATURE_H
