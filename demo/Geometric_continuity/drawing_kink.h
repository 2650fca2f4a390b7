// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_DEMO_DRAWING_KINK_H
#define GEOMETRIC_CONTINUITY_DEMO_DRAWING_KINK_H

#include "svg_drawing.h"

#include <CGAL/Geometric_continuity/joins/Join_grade.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <optional>
#include <ostream>
#include <string>

// Words and JSON for how a join of a subpath is drawn: as a corner or a kink, of how many degrees, and by how much a handle is off.
class Drawing_kink {
  typedef GC::Svg_segment<Drawing_traits> Segment;

  const Drawing_element& element_;
  const Drawing_subpath& path_;
  mutable std::optional<int>
      decimals_; // of the numbers of the subpath as they are written; -1 when they are no decimals

public:
  // Both must live on.
  Drawing_kink(const Drawing_element& element, const Drawing_subpath& path) : element_(element), path_(path) {}

  // Returns e.g. "kink of 0.573 degrees, a handle is off by 0.2 (2 units of the last decimal)".
  std::string text(const Segment& left, const Segment& right, GC::Join_grade grade) const;

  // Writes `,"grade":…,"angle_degrees":[…,…]`, and for a kink `"handle_offset":[…,…]` in units of the drawing.
  void write_json(std::ostream& os, const Segment& left, const Segment& right,
                  const std::optional<GC::Join_grade>& grade) const;

private:
  // Multiplied by `unit`.
  GC::Svg_transform<Drawing_traits> to_own_coordinates(const Drawing_traits::FT& unit) const;
  int decimals() const;
};

// The number that is enclosed, to four digits where they are certain, otherwise both bounds.
std::string four_certain_digits(const GC::Enclosure& x);

#endif // GEOMETRIC_CONTINUITY_DEMO_DRAWING_KINK_H
