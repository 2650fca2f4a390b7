// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF_OUTLINES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF_OUTLINES_H

#include "formats/font/Cff_table.h"
#include "formats/font/Charstring_pen.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

// The outlines of a table 'CFF ' or 'CFF2', at the default instance, with all fractions of a unit;
// FreeType cuts them off. Names and characters are left to FreeType.
class Cff_outlines {
  const std::string bytes_;
  const CGAL::Geometric_continuity::Cff_table table_;

public:
  // Reads what all glyphs have in common from a table, of which this takes the bytes. Throws
  // Font_error.
  explicit Cff_outlines(std::string bytes);
  Cff_outlines(const Cff_outlines&) = delete; // it refers to its bytes
  Cff_outlines& operator=(const Cff_outlines&) = delete;

  // Reads a glyph. `glyph_of(code)` is the glyph of a code of Adobe's standard encoding, for
  // letters with accents. Throws Font_error.
  void read(int glyph, Glyph_outline& outline, const std::function<int(std::int64_t)>& glyph_of) const;

private:
  std::optional<Accented_letter> draw(int glyph, Glyph_outline& outline, const Glyph_point& origin = {0, 0}) const;
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF_OUTLINES_H
