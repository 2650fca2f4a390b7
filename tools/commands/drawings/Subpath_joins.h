// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_SUBPATH_JOINS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_SUBPATH_JOINS_H

#include "formats/svg/svg_drawing.h"

#include <cstddef>
#include <optional>
#include <vector>

// The joins of a subpath, as they are meant.
//
// Coordinates are rounded to the decimals with which a path is written. Two roundings of one point
// differ by no more than one unit of the last decimal in each coordinate, and a line between them,
// as a command Z draws it, turns to and fro unintentionally. So segments that fit together into a
// square of one unit are *rounding*: they are looked through, and the join of their neighbours is
// decided as if they were one point. This is done only
// - between neighbours on which a unit turns a direction by no more than a degree, that are 57.3
//   units long: of what is smaller a unit is a part that is drawn, such as a step of a drawing on a
//   grid;
// - where the angles at the segments are, in sum, certainly larger than that between the
//   neighbours, or all are zero: a cap, or a curve, that turns one way is no rounding.
class Subpath_joins {
public:
  typedef GC::Svg_segment<Drawing_traits> Segment;

private:
  const Drawing_subpath& path_;
  std::vector<bool> is_rounding_; // of each segment; empty where none is

  std::size_t size() const { return path_.segments.size(); }
  std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }

public:
  // Takes a subpath in the coordinates to which the transform of the element leads.
  Subpath_joins(const Drawing_element& element, const Drawing_subpath& path);

  // Returns how many segments are looked through.
  std::size_t rounding() const;

  // Calls f(i, j, n, right) for the join behind segment i, where n segments are looked through up
  // to segment j. `right` is this segment, moved to the end of the left one if n is not 0.
  template <class Function> void for_each(Function f) const {
    for (std::size_t i = 0; i < path_.joins(); ++i) {
      if (!is_rounding_.empty() && is_rounding_[i]) continue;
      std::size_t j = next(i), n = 0;
      for (; !is_rounding_.empty() && is_rounding_[j]; j = next(j)) ++n;
      if (n == 0)
        f(i, j, n, path_.segments[j]);
      else
        f(i, j, n, moved(path_.segments[j], path_.segments[i].end()));
    }
  }

  // Returns a segment with this start.
  static Segment moved(const Segment& segment, const Drawing_traits::Point& start);
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_SUBPATH_JOINS_H
