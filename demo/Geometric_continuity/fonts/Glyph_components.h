// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_DEMO_FONTS_GLYPH_COMPONENTS_H
#define GEOMETRIC_CONTINUITY_DEMO_FONTS_GLYPH_COMPONENTS_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

// The components of composite glyphs in the tables glyf and loca of a font: so many are used only by fonts that are made to
// keep a reader busy for ever, as FreeType would be.
class Glyph_components {
  static constexpr std::size_t most = 1000;
  std::string glyf_, loca_;
  bool long_offsets_ = false;

  // Numbers that lie behind the end of a table are 0.
  static std::size_t byte(const std::string& table, std::size_t at) {
    return at < table.size() ? static_cast<unsigned char>(table[at]) : 0;
  }
  static std::size_t word(const std::string& table, std::size_t at) {
    return byte(table, at) << 8 | byte(table, at + 1);
  }
  std::size_t offset(std::size_t glyph) const {
    return long_offsets_ ? word(loca_, 4 * glyph) << 16 | word(loca_, 4 * glyph + 2) : 2 * word(loca_, 2 * glyph);
  }

  // Counts the components of a glyph, and theirs, until there are more than allowed.
  void count(std::size_t glyph, std::size_t& number) const {
    std::size_t at = offset(glyph);
    if (at == offset(glyph + 1) || word(glyf_, at) < 0x8000) return; // an empty glyph, or contours
    std::size_t flags = 0x20;                                        // more components follow
    for (at += 10; (flags & 0x20) != 0 && at < glyf_.size() && ++number <= most;) {
      flags = word(glyf_, at);
      count(word(glyf_, at + 2), number);
      at += (flags & 1) != 0 ? 8 : 6;                                                     // words or bytes
      at += (flags & 8) != 0 ? 2 : (flags & 0x40) != 0 ? 4 : (flags & 0x80) != 0 ? 8 : 0; // scales
    }
  }

public:
  Glyph_components() = default; // of a font without composite glyphs
  Glyph_components(std::string glyf, std::string loca, bool long_offsets)
      : glyf_(std::move(glyf)), loca_(std::move(loca)), long_offsets_(long_offsets) {}

  bool are_too_many(int glyph) const {
    std::size_t number = 0;
    count(static_cast<std::size_t>(glyph), number);
    return number > most;
  }
};

#endif // GEOMETRIC_CONTINUITY_DEMO_FONTS_GLYPH_COMPONENTS_H
