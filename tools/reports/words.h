// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_WORDS_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_WORDS_H

#include <CGAL/Geometric_continuity/IO/json.h>

#include <charconv>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

// Numbers and texts as reports write them.

// Returns a number and its noun, e.g. "1 join" or "2 joins".
inline std::string counted(std::size_t n, const std::string& noun) {
  return std::to_string(n) + ' ' + noun + (n == 1 ? "" : "s");
}

// Returns a number with this many significant digits.
inline std::string rounded(double x, int digits) {
  char text[64]; // as printf() does with %g, but zero has no sign
  return std::string(text,
                     std::to_chars(text, text + sizeof text, x == 0 ? 0.0 : x, std::chars_format::general, digits).ptr);
}

// Returns a text, an enclosure, ... in JSON.
template <class T> std::string json_text(const T& x) {
  std::ostringstream os;
  CGAL::Geometric_continuity::write_json(os, x);
  return os.str();
}

// Returns an array of values that are JSON already.
inline std::string json_array(const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : ",") + value;
  return '[' + text + ']';
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_REPORTS_WORDS_H
