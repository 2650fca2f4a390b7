// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_PACKED_NUMBERS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_PACKED_NUMBERS_H

#include "formats/font/Font_bytes.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// Runs of numbers in variation data. OpenType specification, "Packed point numbers" and "Packed
/// deltas".

namespace CGAL {
namespace Geometric_continuity {

// The numbers of points, ascending and less than `point_count`; empty when all points are meant.
inline std::optional<std::vector<int>> read_packed_points(Font_bytes& bytes, int point_count) {
  int count = bytes.u8();
  if (count == 0) return std::nullopt;
  if ((count & 0x80) != 0) count = (count & 0x7f) << 8 | bytes.u8();
  if (count > point_count) bytes.refuse("there are more numbers of points than points");
  std::vector<int> points;
  while (static_cast<int>(points.size()) < count) {
    const int control = bytes.u8(), run = (control & 0x7f) + 1;
    if (count - static_cast<int>(points.size()) < run) bytes.refuse("a run of numbers of points is too long");
    for (int i = 0; i < run; ++i) {
      const int step = (control & 0x80) != 0 ? bytes.u16() : bytes.u8();
      if (step == 0 && !points.empty()) bytes.refuse("the numbers of points do not ascend");
      points.push_back(points.empty() ? step : points.back() + step);
      if (points.back() >= point_count)
        bytes.refuse("there is no point " + std::to_string(points.back()) + " that could be moved");
    }
  }
  return points;
}

// So many numbers.
inline std::vector<int> read_packed_deltas(Font_bytes& bytes, std::size_t count) {
  std::vector<int> deltas;
  while (deltas.size() < count) {
    const int control = bytes.u8(), form = control & 0xc0;
    const std::size_t run = static_cast<std::size_t>(control & 0x3f) + 1;
    if (count - deltas.size() < run) bytes.refuse("a run of movements is too long");
    if (form == 0xc0) bytes.refuse("a run of movements is of an unknown form");
    for (std::size_t i = 0; i < run; ++i) deltas.push_back(form == 0x80 ? 0 : form == 0x40 ? bytes.i16() : bytes.i8());
  }
  return deltas;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_PACKED_NUMBERS_H
