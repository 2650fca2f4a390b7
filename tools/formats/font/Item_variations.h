// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_ITEM_VARIATIONS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_ITEM_VARIATIONS_H

#include "formats/font/Font_bytes.h"
#include "formats/font/Variation_region.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

/// The regions in which values of a font vary. OpenType specification, "Item variation store".

namespace CGAL {
namespace Geometric_continuity {

// For each set of data the regions of its deltas, in their order. The axes are those of the font,
// if they are known.
inline std::vector<std::vector<Variation_region>> read_variation_store(std::string_view store,
                                                                       std::optional<std::size_t> axes) {
  Font_bytes bytes(store, "table 'CFF2', the regions"), data = bytes;
  if (bytes.u16() != 1) bytes.refuse("their format is not 1");
  const std::size_t begin = bytes.u32();
  const int sets = bytes.u16();
  data.seek(begin);
  const std::size_t own_axes = static_cast<std::size_t>(data.u16());
  if (axes && own_axes != *axes) data.refuse("their number of axes is not that of 'fvar'");
  const std::size_t count = static_cast<std::size_t>(data.u16());
  if (own_axes != 0 && data.left() / (6 * own_axes) < count) data.refuse("there are more of them than bytes");
  std::vector<Variation_region> regions;
  for (std::size_t r = 0; r < count; ++r) {
    std::vector<Region_axis> region;
    for (std::size_t k = 0; k < own_axes; ++k) {
      Region_axis axis{};
      for (double* x : {&axis.start, &axis.peak, &axis.end}) *x = data.f2dot14();
      region.push_back(axis);
    }
    regions.emplace_back(std::move(region));
  }
  std::vector<std::vector<Variation_region>> result;
  for (int i = 0; i < sets; ++i) {
    // the numbers of items and of long deltas, of which charstrings have none
    data.seek(bytes.u32()).skip(4);
    const int size = data.u16();
    std::vector<Variation_region> set;
    for (int j = 0; j < size; ++j) {
      const std::size_t r = static_cast<std::size_t>(data.u16());
      if (regions.size() <= r) data.refuse("there is no region " + std::to_string(r));
      set.push_back(regions[r]);
    }
    result.push_back(std::move(set));
  }
  return result;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_ITEM_VARIATIONS_H
