// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_FACE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_FACE_H

#include "formats/font/Glyph_outline.h"

#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

struct FT_FaceRec_;

// Why a font or a glyph cannot be read, in the words of FreeType where it has some.
struct Font_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A font of a file, read by FreeType: TrueType, OpenType with TrueType or CFF outlines, Type 1, WOFF. Of a variable font it
// is the default instance. The points are what FreeType says in units of the font: those of scaled or rotated components, and
// fractions in CFF, are rounded to integers there, as they are for every program that reads outlines by FreeType.
class Font_face {
  struct Close {
    void operator()(FT_FaceRec_* face) const;
  };
  std::unique_ptr<FT_FaceRec_, Close> face_;
  bool has_names_;
  mutable std::vector<bool> is_simple_; // glyphs that are known to have no components

public:
  // Opens font number `index` of a file, whose bytes must stay as long as this object. Throws
  // Font_error.
  explicit Font_face(std::string_view bytes, int index = 0);

  // The number of fonts in the file.
  int fonts_of_file() const;

  // Whether it has outlines at all, and not only pictures of letters.
  bool has_outlines() const;

  // The names of family and style, e.g. "DejaVu Sans Bold".
  std::string name() const;

  // The bytes of this font without the container that packs it (WOFF, WOFF2). Throws Font_error.
  std::string unpacked() const;

  int units_per_em() const;
  int glyphs() const;

  // The name of a glyph; "glyph00012" for number 12 if the font has no names.
  std::string glyph_name(int glyph) const;

  // Calls take(character, glyph) for the characters of the font from the first to the last one, in order.
  template <class Take> void for_characters(char32_t first, char32_t last, Take take) const {
    char32_t character = first;
    for (int glyph = glyph_from(character); glyph != 0 && character <= last; glyph = glyph_from(++character))
      take(character, glyph);
  }

  // Reads the outline of a glyph. Throws Font_error, also when the glyph has no outline but a picture, or coordinates that no
  // font needs.
  void read(int glyph, Glyph_outline& outline) const;

  // The glyphs without components of which a glyph consists; none if it has no components. Throws Font_error.
  std::set<int> components(int glyph) const;

private:
  // Moves on to the first character from this one on that the font has, and returns its glyph, or 0.
  int glyph_from(char32_t& character) const;

  // Loads a glyph. FreeType reads a component as often as it is used, so that a TrueType font of a few hundred bytes can keep it
  // busy for ever: components are counted before, those of components included. What damaged tables say depends on the reader;
  // so FreeType itself is asked for them.
  void load(int glyph) const;

  // Loads a glyph without components, or the list of its components, and returns whether it has some.
  bool load_components(int glyph) const;

  // Adds the number of components that the composite glyph has whose list has been loaded. Throws Font_error when there are
  // too many.
  void count_components(int& number) const;
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_FACE_H
