// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_FACE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_FACE_H

#include "formats/font/Font_error.h"
#include "formats/font/Glyph_outline.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

struct FT_FaceRec_;

class Cff_outlines;
class True_type_glyphs;

// A font of a file, opened by FreeType: TrueType, OpenType with TrueType or CFF outlines, Type 1,
// WOFF. Of a variable font it is the default instance. The points are exactly those of the font:
// outlines, which FreeType rounds and moves, are read here.
class Font_face {
  struct Close {
    void operator()(FT_FaceRec_* face) const;
  };
  std::unique_ptr<FT_FaceRec_, Close> face_;
  bool has_names_;
  std::unique_ptr<const Cff_outlines> cff_;           // of a font with charstrings of type 2
  std::unique_ptr<std::vector<std::string>> type_1_;  // the subroutines of a font with charstrings of type 1
  std::unique_ptr<const True_type_glyphs> true_type_; // of a font with the table 'glyf'

public:
  // Opens font number `index` of a file, whose bytes must stay as long as this object. Throws
  // Font_error.
  explicit Font_face(std::string_view bytes, int index = 0);
  ~Font_face();

  // The number of fonts in the file.
  int fonts_of_file() const;

  // Returns whether it has outlines at all, and not only pictures of letters.
  bool has_outlines() const;

  // The names of family and style, e.g. "DejaVu Sans Bold".
  std::string name() const;

  // The bytes of this font without the container that packs it (WOFF, WOFF2). Throws Font_error.
  std::string unpacked() const;

  int units_per_em() const;
  int glyphs() const;

  // The name of a glyph; "glyph00012" for number 12 if the font has no names.
  std::string glyph_name(int glyph) const;

  // Calls take(character, glyph) for the characters of the font from the first to the last one, in
  // order.
  template <class Take> void for_characters(char32_t first, char32_t last, Take take) const {
    char32_t character = first;
    for (int glyph = glyph_from(character); glyph != 0 && character <= last; glyph = glyph_from(++character))
      take(character, glyph);
  }

  // Reads the outline of a glyph. Throws Font_error, also when the glyph has no outline but a
  // picture, or coordinates that no font needs. Components that have changed, glyphs without
  // components in halves of a unit, are taken as they are now.
  typedef std::map<int, Glyph_outline> Changed_glyphs;
  void read(int glyph, Glyph_outline& outline, const Changed_glyphs* changed = nullptr) const;

  // The glyphs without components of which a glyph consists; none if it has no components. Throws
  // Font_error.
  std::set<int> components(int glyph) const;

private:
  // Moves on to the first character from this one on that the font has, and returns its glyph, or
  // 0.
  int glyph_from(char32_t& character) const;

  void read_type_1(int glyph, Glyph_outline& outline) const;
  std::string charstring(int glyph) const;

  // The glyph of a letter or an accent in Adobe's standard encoding.
  int glyph_of_code(std::int64_t code) const;
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_FACE_H
