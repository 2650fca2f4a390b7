// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_UNCOVERED_FONT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_UNCOVERED_FONT_H

#include "formats/font/Variable_font.h"

#include <string>
#include <string_view>

namespace GC = CGAL::Geometric_continuity;

// Why a file cannot be covered, as far as its first bytes tell; empty if they do not.
inline std::string uncovered_form(std::string_view bytes) {
  const std::string_view begin = bytes.substr(0, 4);
  if (begin == "wOFF" || begin == "wOF2") return "not covered: a packed font (WOFF)";
  if (begin == "ttcf" || begin == "true" || begin == "OTTO" || begin == std::string_view("\0\1\0\0", 4)) return "";
  return "not covered: no OpenType or TrueType font";
}

// The same of its tables.
inline std::string uncovered_tables(const GC::Font_tables& font) {
  if (!font.has("fvar")) return "not covered: not a variable font";
  return GC::Variable_font::is_variable(font) ? "" : "not covered: a variable font without TrueType outlines";
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_UNCOVERED_FONT_H
