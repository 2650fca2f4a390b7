// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_DRAWING_KINK_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_DRAWING_KINK_H

#include "commands/drawings/segment_joins.h"
#include "formats/svg/svg_drawing.h"

#include <CGAL/Geometric_continuity/joins/path_continuity.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <optional>
#include <ostream>
#include <string>

// Says how the joins of an element are drawn, e.g. "corner of 90 degrees" or "kink of 0.573
// degrees, a handle is off by 0.2 (2 units of the last decimal)". Four digits of each number are
// certain; where they are not, both bounds are given.
class Drawing_kink_words {
  // From the drawing to the coordinates of the element in units of their last decimal; empty where
  // there are no decimals.
  std::optional<GC::Svg_transform<Drawing_traits>> to_units_;
  std::array<CGAL::Interval_nt<false>, 4> enclosed_to_units_; // of vectors

public:
  explicit Drawing_kink_words(const Drawing_element& element);

  std::string operator()(const Drawing_join& join, GC::Visual_class grade) const;
};

// Returns the angle of the tangents in degrees; nothing where a segment has no length.
std::optional<GC::Enclosure> angle_bounds(const GC::Path_segment<Drawing_traits>& left,
                                          const GC::Path_segment<Drawing_traits>& right);

// Writes `,"grade":…,"angle_degrees":[…,…]`, and for a kink `"handle_offset":[…,…]` in units of the
// drawing.
void write_drawing_kink(std::ostream& os, const GC::Svg_segment<Drawing_traits>& left,
                        const GC::Svg_segment<Drawing_traits>& right, const std::optional<GC::Visual_class>& grade);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_DRAWING_KINK_H
