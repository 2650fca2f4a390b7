// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_ERROR_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_ERROR_H

#include <stdexcept>

// Why a font or a glyph cannot be read, in the words of FreeType where it has some.
struct Font_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_ERROR_H
