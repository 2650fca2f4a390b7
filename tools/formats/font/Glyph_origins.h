// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_ORIGINS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_ORIGINS_H

#include <cstddef>
#include <string>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_TRUETYPE_TABLES_H
#include FT_TRUETYPE_TAGS_H

// Where FreeType puts the origin of the glyphs of a TrueType font: at their left edge, as the head of the glyph says, less their left side
// bearing. It moves each outline so that this point has x = 0, where the table 'glyf' need not have it. Numbers that are missing are 0, as to
// FreeType.
class Glyph_origins {
  FT_Face face_;
  std::string places_, metrics_; // tables 'loca' and 'hmtx'
  std::size_t place_size_ = 2, advances_ = 0;
  FT_ULong glyphs_size_ = 0;

  std::string table(FT_ULong tag) const {
    FT_ULong size = 0;
    if (FT_Load_Sfnt_Table(face_, tag, 0, nullptr, &size) != 0) return {};
    std::string bytes(size, '\0');
    if (size == 0 || FT_Load_Sfnt_Table(face_, tag, 0, reinterpret_cast<FT_Byte*>(bytes.data()), &size) != 0) return {};
    return bytes;
  }

  static FT_ULong number(const std::string& bytes, std::size_t at, std::size_t size) {
    FT_ULong x = 0;
    if (at + size > bytes.size()) return 0;
    for (std::size_t i = 0; i < size; ++i) x = x << 8 | static_cast<unsigned char>(bytes[at + i]);
    return x;
  }
  static FT_Pos signed_number(const std::string& bytes, std::size_t at) {
    return (static_cast<FT_Pos>(number(bytes, at, 2)) ^ 0x8000) - 0x8000;
  }

  FT_ULong place(std::size_t glyph) const {
    return number(places_, place_size_ * glyph, place_size_) * (place_size_ == 2 ? 2 : 1);
  }

  FT_Pos left_edge(std::size_t glyph) const {
    const FT_ULong begin = place(glyph), end = place(glyph + 1);
    std::string head(4, '\0'); // the number of contours, and the edge
    FT_ULong size = head.size();
    if (begin == end || glyphs_size_ < begin + size ||
        FT_Load_Sfnt_Table(face_, TTAG_glyf, static_cast<FT_Long>(begin), reinterpret_cast<FT_Byte*>(head.data()),
                           &size) != 0)
      return 0;
    return signed_number(head, 0) == 0 ? 0 : signed_number(head, 2);
  }

  FT_Pos left_side_bearing(std::size_t glyph) const {
    return signed_number(metrics_, glyph < advances_ ? 4 * glyph + 2 : 4 * advances_ + 2 * (glyph - advances_));
  }

public:
  explicit Glyph_origins(FT_Face face) : face_(face), places_(table(TTAG_loca)), metrics_(table(TTAG_hmtx)) {
    if (const auto* head = static_cast<const TT_Header*>(FT_Get_Sfnt_Table(face, FT_SFNT_HEAD)))
      place_size_ = head->Index_To_Loc_Format == 0 ? 2 : 4;
    if (const auto* head = static_cast<const TT_HoriHeader*>(FT_Get_Sfnt_Table(face, FT_SFNT_HHEA)))
      advances_ = head->number_Of_HMetrics;
    FT_Load_Sfnt_Table(face, TTAG_glyf, 0, nullptr, &glyphs_size_);
  }

  // The x of the origin in the coordinates of the table.
  FT_Pos x(int glyph) const {
    const std::size_t i = static_cast<std::size_t>(glyph);
    return left_edge(i) - left_side_bearing(i);
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_GLYPH_ORIGINS_H
