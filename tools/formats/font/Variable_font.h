// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_FONT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_FONT_H

#include "formats/font/Glyph_variations.h"
#include "formats/font/True_type_outlines.h"
#include "formats/font/Variation_axes.h"
#include "formats/font/interpolate_untouched.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// A variable font with TrueType outlines: its glyphs as functions of the axes.

namespace CGAL {
namespace Geometric_continuity {

/// An outline that depends on the instance: point `i` is `outline.points[i]` and the sum of `shifts[r][i]` times the scalar of
/// `regions[r]` over all regions.
struct Variable_outline {
  True_type_outline outline;
  std::vector<Variation_region> regions;
  std::vector<std::vector<Outline_vector>> shifts;

  /// Returns a point at an instance, which is given by its normalised values, exactly. \f$ O(rk) \f$ for `r` regions and `k`
  /// axes
  Outline_vector point(std::size_t i, const std::vector<CGAL::Exact_rational>& instance) const {
    Outline_vector p{outline.points[i].x, outline.points[i].y};
    for (std::size_t r = 0; r < regions.size(); ++r) {
      const CGAL::Exact_rational scalar = regions[r].scalar(instance);
      for (std::size_t c = 0; c < 2; ++c) p[c] += scalar * shifts[r][i][c];
    }
    return p;
  }
};

/// A variable font with TrueType outlines. It refers to the bytes of the font.
class Variable_font {
  std::vector<Variation_axis> axes_;
  True_type_outlines outlines_;
  Glyph_variations variations_;

public:
  /// Returns whether a font is a variable one with TrueType outlines, so that it can be read.
  static bool is_variable(const Font_tables& font) { return font.has("fvar") && font.has("gvar") && font.has("glyf"); }

  /// Reads what all glyphs have in common. \throws Error `malformed_input`, also for a font that `is_variable()` denies
  explicit Variable_font(const Font_tables& font)
      : axes_(read_variation_axes(font)), outlines_(font), variations_(font, axes_.size(), outlines_.glyph_count()) {}

  /// Returns the axes.
  const std::vector<Variation_axis>& axes() const { return axes_; }
  /// Returns the number of glyphs.
  int glyph_count() const { return outlines_.glyph_count(); }
  /// Returns the number of units of which the em consists.
  int units_per_em() const { return outlines_.units_per_em(); }

  /// Returns the outline of a glyph; that of a composite glyph has no points.
  /// \throws Error `malformed_input`, `work_limit` for more than `Glyph_variations::max_movements`,
  ///   `parameter_outside_domain` when there is no such glyph
  Variable_outline glyph(int index) const {
    Variable_outline glyph{outlines_.glyph(index), {}, {}};
    if (glyph.outline.points.empty()) return glyph;
    const int points = static_cast<int>(glyph.outline.points.size());
    for (Tuple_variation& tuple : variations_.glyph(index, points)) {
      glyph.shifts.push_back(interpolate_untouched(glyph.outline, tuple));
      glyph.regions.push_back(std::move(tuple.region));
    }
    return glyph;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_FONT_H
