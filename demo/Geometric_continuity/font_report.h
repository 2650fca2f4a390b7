// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_DEMO_FONT_REPORT_H
#define GEOMETRIC_CONTINUITY_DEMO_FONT_REPORT_H

#include "Graded_joins.h"

#include <cstddef>
#include <string>
#include <vector>

// What was found in a font, or in several.
struct Font_counts {
  std::size_t glyphs = 0; // that were read
  std::size_t empty = 0;  // those of them that draw nothing, such as the space
  Join_counts joins;

  Font_counts& operator+=(const Font_counts& x) {
    glyphs += x.glyphs;
    empty += x.empty;
    joins += x.joins;
    return *this;
  }
};

// Returns e.g. "3 glyphs, 84 joins: 20 corners, 2 kinks (1 off by more than one unit), 30 G1, 32 G2 or more".
std::string counts_text(const Font_counts& counts);

// Returns the members of a JSON object, e.g. "joins":84,"corners":20,"kinks":2,"G1":30,"G2":32.
std::string counts_json(const Join_counts& counts);

// Returns the lines of a table, each behind `indentation`: the glyph, the place and, of a kink, its size. Names the fonts if they are
// several.
std::string joins_table(const std::vector<Shown_join>& joins, const std::string& indentation, bool names_fonts);

// Returns a JSON array of objects.
std::string joins_json(const std::vector<Shown_join>& joins);

#endif // GEOMETRIC_CONTINUITY_DEMO_FONT_REPORT_H
