// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_VARIATIONS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_VARIATIONS_H

#include "formats/font/Font_tables.h"
#include "formats/font/Variation_region.h"
#include "formats/font/packed_numbers.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// How the points of TrueType glyphs move, as it is written. OpenType specification, table 'gvar'
/// and "Tuple variation store".

namespace CGAL {
namespace Geometric_continuity {

/// How some points of a glyph move in a region: point `points[i]` by `(dx[i], dy[i])` times the
/// scalar of the region; without `points` all of them, in their order. Behind the points of the
/// outline there are four that are no part of it.
struct Tuple_variation {
  Variation_region region;
  std::optional<std::vector<int>> points; ///< ascending
  std::vector<int> dx, dy;                ///< in units of the font
};

/// The table 'gvar' of a font. It refers to the bytes of the font.
class Glyph_variations {
  std::string_view table_;
  std::size_t axes_, shared_count_, shared_begin_, data_begin_;
  int glyphs_;
  bool long_places_;

  enum { has_shared_points = 0x8000, count_mask = 0xfff };
  enum { has_peak = 0x8000, is_intermediate = 0x4000, has_points = 0x2000, index_mask = 0xfff };

public:
  /// How many movements of points a glyph may have in all its regions together, untouched points
  /// included. The largest glyphs that designers draw have some ten thousand; a few bytes can stand
  /// for millions.
  static constexpr std::size_t max_movements = std::size_t(1) << 18;

  /// Reads what all glyphs have in common. \throws Error `malformed_input`, also when it is made
  /// for another number of axes or of glyphs
  Glyph_variations(const Font_tables& font, std::size_t axes, int glyphs)
      : table_(font.table("gvar")), axes_(axes), glyphs_(glyphs) {
    Font_bytes bytes(table_, "table 'gvar'");
    if (bytes.u16() != 1) bytes.refuse("its version is not 1");
    bytes.skip(2);
    if (static_cast<std::size_t>(bytes.u16()) != axes) bytes.refuse("its number of axes is not that of 'fvar'");
    shared_count_ = static_cast<std::size_t>(bytes.u16());
    shared_begin_ = bytes.u32();
    if (bytes.u16() != glyphs) bytes.refuse("its number of glyphs is not that of 'maxp'");
    long_places_ = (bytes.u16() & 1) != 0;
    data_begin_ = bytes.u32();
    bytes.skip((static_cast<std::size_t>(glyphs) + 1) * (long_places_ ? 4 : 2));
    bytes.seek(shared_begin_).skip(shared_count_ * axes * 2);
  }

  /// Reads how the `point_count` points of the outline of a glyph move, and the four behind them.
  /// \throws Error `malformed_input`, `work_limit` for more than `max_movements`,
  ///   `parameter_outside_domain` when there is no such glyph
  std::vector<Tuple_variation> glyph(int index, int point_count) const {
    if (index < 0 || glyphs_ <= index)
      throw Error(Error_code::parameter_outside_domain, "there is no glyph " + std::to_string(index));
    const std::string name = "table 'gvar', glyph " + std::to_string(index);
    const std::size_t begin = place(index), end = place(index + 1);
    Font_bytes whole(table_, name);
    if (end < begin || table_.size() < data_begin_ || table_.size() - data_begin_ < end)
      whole.refuse("it lies outside of the table");
    std::vector<Tuple_variation> tuples;
    if (begin == end) return tuples;
    const std::string_view glyph = table_.substr(data_begin_ + begin, end - begin);
    Font_bytes headers(glyph, name), data(glyph, name);
    const int flags = headers.u16();
    data.seek(static_cast<std::size_t>(headers.u16()));
    const int all_points = point_count + 4;
    const std::size_t count = static_cast<std::size_t>(flags & count_mask);
    if (max_movements / static_cast<std::size_t>(all_points) < count)
      throw Error(Error_code::work_limit,
                  name + ": more than " + std::to_string(max_movements) + " movements of points");
    std::optional<std::vector<int>> shared;
    if ((flags & has_shared_points) != 0) shared = read_packed_points(data, all_points);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t size = static_cast<std::size_t>(headers.u16());
      const int form = headers.u16();
      Variation_region region = read_region(headers, form);
      Font_bytes part(data.take(size), name);
      Tuple_variation tuple{std::move(region), shared, {}, {}};
      if ((form & has_points) != 0) tuple.points = read_packed_points(part, all_points);
      const std::size_t moved = tuple.points ? tuple.points->size() : static_cast<std::size_t>(all_points);
      std::vector<int> deltas = read_packed_deltas(part, 2 * moved);
      tuple.dy.assign(deltas.begin() + static_cast<std::ptrdiff_t>(moved), deltas.end());
      deltas.resize(moved);
      tuple.dx = std::move(deltas);
      tuples.push_back(std::move(tuple));
    }
    return tuples;
  }

private:
  std::size_t place(int index) const {
    Font_bytes bytes(table_, "table 'gvar'");
    const std::size_t i = static_cast<std::size_t>(index);
    return long_places_ ? bytes.seek(20 + 4 * i).u32() : 2 * static_cast<std::size_t>(bytes.seek(20 + 2 * i).u16());
  }

  std::vector<double> read_point(Font_bytes& bytes) const {
    std::vector<double> point;
    for (std::size_t k = 0; k < axes_; ++k) point.push_back(bytes.f2dot14());
    return point;
  }

  Variation_region read_region(Font_bytes& headers, int form) const {
    std::vector<double> peak;
    if ((form & has_peak) != 0)
      peak = read_point(headers);
    else {
      const std::size_t number = static_cast<std::size_t>(form & index_mask);
      if (shared_count_ <= number) headers.refuse("there is no shared tuple " + std::to_string(number));
      Font_bytes bytes(table_, "table 'gvar'");
      peak = read_point(bytes.seek(shared_begin_ + 2 * axes_ * number));
    }
    std::vector<Region_axis> axes;
    for (double p : peak) axes.push_back({(std::min)(p, 0.), p, (std::max)(p, 0.)});
    if ((form & is_intermediate) != 0) {
      const std::vector<double> start = read_point(headers), end = read_point(headers);
      for (std::size_t k = 0; k < axes_; ++k) axes[k] = {start[k], peak[k], end[k]};
    }
    return Variation_region(std::move(axes));
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_VARIATIONS_H
