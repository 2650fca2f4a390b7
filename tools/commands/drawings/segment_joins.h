// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_SEGMENT_JOINS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_SEGMENT_JOINS_H

#include "formats/svg/svg_drawing.h"

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Path_segment.h>
#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <optional>

namespace CGAL {
namespace Geometric_continuity {
template <class Traits> class Path_join;
} // namespace Geometric_continuity
} // namespace CGAL

// Questions about the joins of the segments of a drawing, or of a grid, which are compiled once.

// The coordinates on a grid, in floating-point numbers, which hold them exactly.
typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Grid_traits;

typedef GC::Path_join<Drawing_traits> Drawing_join;

// Returns what GC::continuity() does.
std::optional<GC::Join_continuity<Drawing_traits::FT>> segment_continuity(const Drawing_join& join, int max_order);

// Returns what GC::visual_class() does.
std::optional<GC::Visual_class> segment_class(const Drawing_join& join, const GC::Corner_threshold& bound);
std::optional<GC::Visual_class> segment_class(const GC::Bezier_curve<Drawing_traits>& left,
                                              const GC::Bezier_curve<Drawing_traits>& right,
                                              const GC::Corner_threshold& bound);
std::optional<GC::Visual_class> segment_class(const GC::Bezier_curve<Grid_traits>& left,
                                              const GC::Bezier_curve<Grid_traits>& right,
                                              const GC::Corner_threshold& bound);
std::optional<GC::Visual_class> segment_class(const GC::Path_segment<Drawing_traits>& left,
                                              const GC::Path_segment<Drawing_traits>& right,
                                              const GC::Corner_threshold& bound);

// Returns what GC::tangent_angle() does.
std::optional<GC::Enclosure> segment_angle(const GC::Path_segment<Drawing_traits>& left,
                                           const GC::Path_segment<Drawing_traits>& right);

// Returns what GC::kink_size() does.
std::optional<GC::Kink_size> segment_kink(const GC::Bezier_curve<Drawing_traits>& left,
                                          const GC::Bezier_curve<Drawing_traits>& right);
std::optional<GC::Kink_size> segment_kink(const GC::Bezier_curve<Grid_traits>& left,
                                          const GC::Bezier_curve<Grid_traits>& right);

// Returns the jump of the curvature that GC::deviation() has.
std::optional<GC::Enclosure> segment_curvature_jump(const GC::Bezier_curve<Drawing_traits>& left,
                                                    const GC::Bezier_curve<Drawing_traits>& right);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_SEGMENT_JOINS_H
