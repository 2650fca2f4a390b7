// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_FONT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_FONT_H

#include "formats/font/Cff2_outlines.h"
#include "formats/font/Glyph_variations.h"
#include "formats/font/True_type_outlines.h"
#include "formats/font/Variable_outline.h"
#include "formats/font/Variation_axes.h"
#include "formats/font/interpolate_untouched.h"

#include <optional>
#include <utility>
#include <vector>

/// A variable font: its glyphs as functions of the axes.

namespace CGAL {
namespace Geometric_continuity {

/// A variable font with TrueType outlines, or with those of the table 'CFF2'. It refers to the
/// bytes of the font.
class Variable_font {
  std::vector<Variation_axis> axes_;
  std::vector<Variation_range> ranges_;
  std::optional<True_type_outlines> outlines_; // and
  std::optional<Glyph_variations> variations_; // or
  std::optional<Cff2_outlines> cff_;

  static bool is_true_type(const Font_tables& font) { return font.has("glyf") && font.has("gvar"); }

public:
  /// Returns whether a font is a variable one that can be read.
  static bool is_variable(const Font_tables& font) {
    return font.has("fvar") && (is_true_type(font) || font.has("CFF2"));
  }

  /// Reads what all glyphs have in common. \throws Error `malformed_input`, also for a font that
  /// `is_variable()` denies
  explicit Variable_font(const Font_tables& font) : axes_(read_variation_axes(font)) {
    for (const Variation_axis& axis : axes_) ranges_.push_back(axis.range());
    if (!is_true_type(font) && font.has("CFF2")) {
      cff_.emplace(font, axes_.size());
      return;
    }
    outlines_.emplace(font);
    variations_.emplace(font, axes_.size(), outlines_->glyph_count());
  }

  /// Returns the axes.
  const std::vector<Variation_axis>& axes() const { return axes_; }
  /// Returns the normalised values of the axes.
  const std::vector<Variation_range>& ranges() const { return ranges_; }
  /// Returns the number of glyphs.
  int glyph_count() const { return cff_ ? cff_->glyph_count() : outlines_->glyph_count(); }
  /// Returns the number of units of which the em consists.
  int units_per_em() const { return cff_ ? cff_->units_per_em() : outlines_->units_per_em(); }

  /// Returns the components of a glyph; none when it has an outline of its own. \throws Error as
  /// glyph()
  std::vector<Glyph_component> components(int index) const {
    return cff_ ? std::vector<Glyph_component>() : outlines_->glyph(index).components;
  }

  /// Returns the outline of a glyph; that of a composite glyph has no points.
  /// \throws Error `malformed_input`, `work_limit` for more than `Glyph_variations::max_movements`,
  ///   `parameter_outside_domain` when there is no such glyph
  Variable_outline glyph(int index) const {
    if (cff_) return cff_->glyph(index);
    const True_type_outline outline = outlines_->glyph(index);
    Variable_outline glyph{false, {}, outline.contour_ends, outline.components};
    if (outline.points.empty()) return glyph;
    glyph.points.reserve(outline.points.size());
    for (const Outline_point& p : outline.points) glyph.points.push_back({double(p.x), double(p.y), p.on_curve});
    const int points = static_cast<int>(outline.points.size());
    for (Tuple_variation& tuple : variations_->glyph(index, points)) {
      glyph.shifts.push_back(interpolate_untouched(outline, tuple));
      glyph.regions.push_back(std::move(tuple.region));
    }
    return glyph;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIABLE_FONT_H
