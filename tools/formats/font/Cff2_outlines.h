// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF2_OUTLINES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF2_OUTLINES_H

#include "formats/font/Cff_table.h"
#include "formats/font/Font_tables.h"
#include "formats/font/Glyph_variations.h"
#include "formats/font/Variable_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// The outlines of a font with cubic curves that vary. OpenType specification, table 'CFF2'.

namespace CGAL {
namespace Geometric_continuity {

// Draws the outline of a glyph, all of whose numbers may vary, see Type_2_charstring. They are
// those of the file, multiples of 2^-16, and their sums are exact.
class Variable_pen {
public:
  // A number, which moves by `deltas[r]` times the scalar of region r; without deltas it stays.
  struct Number {
    double value = 0;
    std::vector<double> deltas = {};

    Number& operator+=(const Number& x) {
      value += x.value;
      if (deltas.size() < x.deltas.size()) deltas.resize(x.deltas.size(), 0);
      for (std::size_t r = 0; r < x.deltas.size(); ++r) deltas[r] += x.deltas[r];
      return *this;
    }
    Number operator-() const {
      Number x{-value, deltas};
      for (double& delta : x.deltas) delta = -delta;
      return x;
    }
  };

private:
  static constexpr double max_coordinate = 1 << 20;

  Number x_, y_;
  std::vector<std::array<Number, 2>> points_;
  Variable_outline outline_{true, {}, {}};
  const std::size_t most_points_;

  void add(const Number& dx, const Number& dy, bool on_curve) {
    x_ += dx;
    y_ += dy;
    if (!(std::abs(x_.value) <= max_coordinate && std::abs(y_.value) <= max_coordinate))
      charstring::refuse("a coordinate beyond 2^20");
    if (most_points_ <= points_.size())
      throw Error(Error_code::work_limit, "table 'CFF2': more than " + std::to_string(Glyph_variations::max_movements) +
                                              " movements of points");
    points_.push_back({x_, y_});
    outline_.points.push_back({x_.value, y_.value, on_curve});
  }

public:
  // `regions` is the largest number of regions in which a point may vary.
  explicit Variable_pen(std::size_t regions) : most_points_(Glyph_variations::max_movements / (regions + 1)) {}

  static Number number(std::int64_t x) { return {static_cast<double>(x) / 0x10000}; }
  static std::int64_t value(const Number& x) {
    if (!x.deltas.empty()) charstring::refuse("a number that varies, where it must not");
    return static_cast<std::int64_t>(x.value * 0x10000);
  }
  static void blend(Number& x, const Number* deltas, std::size_t count) {
    if (!x.deltas.empty()) charstring::refuse("a blend of blends");
    for (std::size_t r = 0; r < count; ++r) {
      if (!deltas[r].deltas.empty()) charstring::refuse("a blend of blends");
      x.deltas.push_back(deltas[r].value);
    }
  }

  void move(const Number& dx, const Number& dy) {
    close();
    add(dx, dy, true);
  }
  void line(const Number& dx, const Number& dy) { add(dx, dy, true); }
  void curve(const Number& ax, const Number& ay, const Number& bx, const Number& by, const Number& cx,
             const Number& cy) {
    add(ax, ay, false);
    add(bx, by, false);
    add(cx, cy, true);
  }
  void close() {
    const int end = static_cast<int>(points_.size());
    if (end > (outline_.contour_ends.empty() ? 0 : outline_.contour_ends.back())) outline_.contour_ends.push_back(end);
  }

  // The outline, which varies in these regions.
  Variable_outline outline(const std::vector<Variation_region>& regions) && {
    if (points_.empty()) return std::move(outline_);
    outline_.regions = regions;
    typedef Variable_vector::FT FT;
    outline_.shifts.assign(regions.size(), std::vector<Outline_vector>(points_.size(), {FT(0), FT(0)}));
    for (std::size_t i = 0; i < points_.size(); ++i)
      for (std::size_t c = 0; c < 2; ++c)
        for (std::size_t r = 0; r < points_[i][c].deltas.size(); ++r)
          outline_.shifts[r][i][c] = FT(points_[i][c].deltas[r]);
    return std::move(outline_);
  }
};

/// The table 'CFF2' of a font. It refers to the bytes of the font.
class Cff2_outlines {
  Cff_table table_;
  int units_per_em_;
  std::size_t most_regions_ = 0;

public:
  /// Reads what all glyphs have in common. \throws Error `malformed_input`
  Cff2_outlines(const Font_tables& font, std::size_t axes) : table_(font.table("CFF2"), axes) {
    Font_bytes head(font.table("head"), "table 'head'");
    units_per_em_ = head.seek(18).u16();
    if (units_per_em_ == 0) head.refuse("the em has no units");
    if (!table_.is_cff2()) throw Error(Error_code::malformed_input, "table 'CFF2': its version is not 2");
    for (const auto& set : table_.regions()) most_regions_ = (std::max)(most_regions_, set.size());
  }

  /// Returns the number of glyphs.
  int glyph_count() const { return static_cast<int>(table_.glyph_count()); }
  /// Returns the number of units of which the em consists.
  int units_per_em() const { return units_per_em_; }

  /// Reads a glyph. \throws Error `malformed_input`, `work_limit`, `parameter_outside_domain` when
  /// there is no such glyph
  Variable_outline glyph(int index) const {
    if (index < 0 || glyph_count() <= index)
      throw Error(Error_code::parameter_outside_domain, "there is no glyph " + std::to_string(index));
    const std::size_t i = static_cast<std::size_t>(index);
    const Type_2_context context = table_.context(i);
    Variable_pen pen(most_regions_);
    Type_2_charstring<Variable_pen> charstring(context, pen);
    try {
      charstring.draw(table_.charstring(i));
    } catch (const Font_error& e) {
      throw Error(Error_code::malformed_input, "table 'CFF2', glyph " + std::to_string(index) + ": " + e.what());
    }
    const Cff_table::Regions& regions = table_.regions();
    return std::move(pen).outline(charstring.set() < regions.size() ? regions[charstring.set()]
                                                                    : std::vector<Variation_region>());
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF2_OUTLINES_H
