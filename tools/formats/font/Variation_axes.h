// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIATION_AXES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIATION_AXES_H

#include "formats/font/Font_tables.h"
#include "formats/font/Variation_region.h"
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// The axes of a variable font, and what their normalised values mean to its users. OpenType
/// specification, tables 'fvar' and 'avar', and "Coordinate scales and normalization".

namespace CGAL {
namespace Geometric_continuity {

/// An axis of a variable font. Its normalised values are -1 at the minimum, 0 at the default and 1
/// at the maximum, and between these piecewise linear.
struct Variation_axis {
  typedef CGAL::Exact_rational FT; ///< the number type

  std::string tag;              ///< e.g. "wght"
  FT minimum, initial, maximum; ///< in the units of its users; `initial` is the default
  /// The map of 'avar': the pairs of normalised values before and after, ascending; none for the
  /// identity.
  std::vector<std::pair<FT, FT>> map;

  /// Returns the least normalised value, -1 or 0 when the default is the minimum, and the largest
  /// one, 1 or 0.
  Variation_range range() const { return {minimum < initial ? -1. : 0., initial < maximum ? 1. : 0.}; }

  /// Returns the value for users whose normalised value this is, from -1 to 1: exact, not rounded
  /// to the 14 bits that a rasteriser may keep. It is the least one where several have the same
  /// normalised value.
  FT user_value(const FT& normalised) const {
    FT x = normalised;
    for (std::size_t i = 1; i < map.size(); ++i)
      if (map[i - 1].second <= normalised && normalised <= map[i].second) {
        const FT rise = map[i].second - map[i - 1].second;
        x = map[i - 1].first;
        if (rise != FT(0)) x += FT((normalised - map[i - 1].second) * (map[i].first - map[i - 1].first) / rise);
        break;
      }
    return x < FT(0) ? FT(initial + x * (initial - minimum)) : FT(initial + x * (maximum - initial));
  }
};

// Reads the map of 'avar' for one axis. A map without -1, 0 and 1 has no effect.
inline std::vector<std::pair<CGAL::Exact_rational, CGAL::Exact_rational>> read_axis_map(Font_bytes& bytes) {
  std::vector<std::pair<int, int>> units;
  const int count = bytes.u16();
  for (int i = 0; i < count; ++i) {
    const int from = bytes.i16(), to = bytes.i16();
    if (!units.empty() && (from <= units.back().first || to < units.back().second))
      bytes.refuse("a map does not ascend");
    units.emplace_back(from, to);
  }
  std::vector<std::pair<CGAL::Exact_rational, CGAL::Exact_rational>> map;
  for (int end : {-0x4000, 0, 0x4000})
    if (std::find(units.begin(), units.end(), std::make_pair(end, end)) == units.end()) return map;
  for (const std::pair<int, int>& pair : units)
    map.emplace_back(CGAL::Exact_rational(pair.first) / 0x4000, CGAL::Exact_rational(pair.second) / 0x4000);
  return map;
}

/// Returns the version of the table 'avar', of which 1 can be read; 1 without that table. \throws
/// Error `malformed_input`
inline int axis_map_version(const Font_tables& font) {
  return font.has("avar") ? Font_bytes(font.table("avar"), "table 'avar'").u16() : 1;
}

/// Reads the axes of a font; there are none when it is not a variable one. \f$ O(k) \f$ for `k`
/// bytes
/// \throws Error `malformed_input`, also for a version of the table 'avar' other than 1
inline std::vector<Variation_axis> read_variation_axes(const Font_tables& font) {
  std::vector<Variation_axis> axes;
  if (!font.has("fvar")) return axes;
  Font_bytes bytes(font.table("fvar"), "table 'fvar'");
  const std::size_t begin = static_cast<std::size_t>(bytes.seek(4).u16());
  const int count = bytes.seek(8).u16(), size = bytes.u16();
  if (size < 20) bytes.refuse("its records of axes are too short");
  for (int i = 0; i < count; ++i) {
    bytes.seek(begin + static_cast<std::size_t>(i) * static_cast<std::size_t>(size));
    Variation_axis axis;
    axis.tag = std::string(bytes.take(4));
    for (Variation_axis::FT* value : {&axis.minimum, &axis.initial, &axis.maximum})
      *value = Variation_axis::FT(static_cast<double>(bytes.i32()) / 65536); // exact
    if (axis.initial < axis.minimum || axis.maximum < axis.initial)
      bytes.refuse("the default of axis " + std::to_string(i) + " does not lie between its minimum and its maximum");
    axes.push_back(std::move(axis));
  }
  if (!font.has("avar")) return axes;
  Font_bytes maps(font.table("avar"), "table 'avar'");
  if (maps.u16() != 1) maps.refuse("its version is not 1");
  if (static_cast<std::size_t>(maps.seek(6).u16()) != axes.size()) maps.refuse("it has not one map for each axis");
  for (Variation_axis& axis : axes) axis.map = read_axis_map(maps);
  return axes;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIATION_AXES_H
