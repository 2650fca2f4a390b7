// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_ERROR_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_ERROR_H

#include <cstdint>
#include <stdexcept>
#include <string>

// Why a font or a glyph cannot be read, in the words of FreeType where it has some.
struct Font_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Throws it for a coordinate that no font needs.
[[noreturn]] inline void refuse_coordinate(std::int64_t most) {
  throw Font_error("a coordinate beyond " + std::to_string(most) + " units of the font");
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_ERROR_H
