// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF_OUTLINES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF_OUTLINES_H

#include "formats/font/Type_2_charstring.h"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The outlines of a table 'CFF ' (Adobe Technical Note 5176) or 'CFF2', at the default instance, with all fractions of a unit; FreeType cuts
// them off. Names and characters are left to FreeType.
class Cff_outlines {
  struct Part { // of the glyphs, a "font" of the table
    std::vector<std::string_view> subroutines = {};
    std::size_t variation_set = 0;
  };
  typedef std::map<int, std::vector<double>> Dictionary;

  std::string bytes_;
  std::vector<std::size_t> regions_; // how many each set of them has
  bool is_cff2_;
  std::vector<std::string_view> charstrings_, subroutines_;
  std::vector<Part> parts_;
  std::vector<std::size_t> selection_; // the part of each glyph

public:
  // Reads what all glyphs have in common from a table, of which this takes the bytes. Throws Font_error.
  explicit Cff_outlines(std::string bytes);
  Cff_outlines(const Cff_outlines&) = delete; // it refers to its bytes
  Cff_outlines& operator=(const Cff_outlines&) = delete;

  // Reads a glyph. `glyph_of(code)` is the glyph of a code of Adobe's standard encoding, for letters with accents. Throws Font_error.
  void read(int glyph, Glyph_outline& outline, const std::function<int(std::int64_t)>& glyph_of) const;

private:
  std::optional<Accented_letter> draw(int glyph, Glyph_outline& outline, const Glyph_point& origin = {0, 0}) const;
  void read_parts(const Dictionary& top);
  void read_regions(std::size_t begin);
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF_OUTLINES_H
