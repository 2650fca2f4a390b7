// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_SELECTION_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_SELECTION_H

#include "formats/font/Font_face.h"

#include <cstddef>
#include <string>
#include <vector>

// The glyphs that --glyphs names, e.g. "a-z,U+00E9,ampersand,#12": characters and ranges of them,
// as they are or as U+XXXX, names of glyphs, and numbers of glyphs. Without names it is all glyphs.
class Glyph_selection {
  enum class Kind { characters, name, numbers };
  struct Item {
    std::string text;
    Kind kind;
    char32_t first, last; // of characters and numbers
    bool found = false;   // in a font
  };
  std::vector<Item> items_;

  static Item parsed(const std::string& text);

public:
  Glyph_selection() = default;
  // Throws std::invalid_argument for what is nothing of this kind.
  explicit Glyph_selection(const std::string& text);

  bool is_all() const { return items_.empty(); }

  // Returns the numbers of the glyphs of a font, in increasing order, and appends the names of what
  // it does not have to `missing`.
  std::vector<int> glyphs(const Font_face& font, std::vector<std::string>& missing);

  // Throws std::invalid_argument, which names what none of the fonts had.
  void check_all_found() const;
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_SELECTION_H
