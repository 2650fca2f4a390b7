// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/drawings/segment_joins.h"

#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/joins/path_continuity.h>

std::optional<GC::Join_continuity<Drawing_traits::FT>> segment_continuity(const Drawing_join& join, int max_order) {
  return GC::continuity(join, max_order);
}

std::optional<GC::Visual_class> segment_class(const Drawing_join& join, const GC::Corner_threshold& bound) {
  return GC::visual_class(join, bound);
}

std::optional<GC::Visual_class> segment_class(const GC::Bezier_curve<Drawing_traits>& left,
                                              const GC::Bezier_curve<Drawing_traits>& right,
                                              const GC::Corner_threshold& bound) {
  return GC::visual_class(left, right, bound);
}

std::optional<GC::Visual_class> segment_class(const GC::Bezier_curve<Grid_traits>& left,
                                              const GC::Bezier_curve<Grid_traits>& right,
                                              const GC::Corner_threshold& bound) {
  return GC::visual_class(left, right, bound);
}

std::optional<GC::Visual_class> segment_class(const GC::Path_segment<Drawing_traits>& left,
                                              const GC::Path_segment<Drawing_traits>& right,
                                              const GC::Corner_threshold& bound) {
  return GC::visual_class(left, right, bound);
}

std::optional<GC::Enclosure> segment_angle(const GC::Path_segment<Drawing_traits>& left,
                                           const GC::Path_segment<Drawing_traits>& right) {
  return GC::tangent_angle(left, right);
}

std::optional<GC::Kink_size> segment_kink(const GC::Bezier_curve<Drawing_traits>& left,
                                          const GC::Bezier_curve<Drawing_traits>& right) {
  return GC::kink_size(left, right);
}

std::optional<GC::Kink_size> segment_kink(const GC::Bezier_curve<Grid_traits>& left,
                                          const GC::Bezier_curve<Grid_traits>& right) {
  return GC::kink_size(left, right);
}

std::optional<GC::Enclosure> segment_curvature_jump(const GC::Bezier_curve<Drawing_traits>& left,
                                                    const GC::Bezier_curve<Drawing_traits>& right) {
  return GC::deviation(left, right).curvature_jump;
}
