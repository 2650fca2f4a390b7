// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_READ_FONTS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_READ_FONTS_H

#include "commands/commands.h"
#include "commands/fonts/Graded_joins.h"
#include "formats/font/Font_face.h"
#include "formats/font/Glyph_selection.h"
#include "formats/font/font_files.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// How much was found in a font, or in several.
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

// A glyph that could not be read.
struct Unread_glyph {
  int index;
  std::string name, reason;
};

// A font, and what was found in it.
struct Font_result {
  std::string file;          // as messages name it
  std::optional<int> number; // among several of the file
  bool is_alone;             // nothing else was to be read
  std::string name;          // of family and style
  int units_per_em;
  Font_counts counts = {};
  std::vector<Unread_glyph> unread = {};
  Arguments missing = {}; // glyphs that were asked for
  std::vector<Shown_join> worst = {};

  // As rows name it.
  const std::string& shown_name() const { return name.empty() ? file : name; }
};

// The results of all fonts.
struct Fonts_result {
  std::size_t fonts = 0;
  Font_counts counts = {};
  std::vector<Unread_file> unread = {};
  std::vector<Shown_join> worst = {};
};

// Visits fonts and their glyphs.
class Font_visitor {
public:
  virtual ~Font_visitor() = default;
  virtual void begin_font(const Font_face& font, const Font_result& result) = 0;
  // Grades the joins of a glyph.
  virtual Join_counts glyph(const Font_face& font, int glyph, const Glyph_outline& outline,
                            const Font_result& result) = 0;
  virtual void end_font(const Font_face& font, Font_result& result) = 0;
};

// Reads fonts, which are files and those in folders, and their glyphs, one after the other; only
// one font is in memory at a time. The results name the files of a folder and the glyphs that
// cannot be read. Throws GC::Error for a file that is an argument and cannot be read,
// std::invalid_argument for glyphs that no font has.
Fonts_result read_fonts(const Arguments& arguments, const Glyph_selection& glyphs, Font_visitor& visitor);

// The name of the component of a glyph; empty for what the glyph draws itself.
inline std::string part_name(const Font_face& font, int part) {
  return part == Glyph_outline::own ? std::string() : font.glyph_name(part);
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_READ_FONTS_H
