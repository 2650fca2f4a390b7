// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_UTF8_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_UTF8_H

#include <cstddef>
#include <string_view>

/// \file utf8.h
/// The characters of a text that should be UTF-8 but may hold any bytes, such as the name of a
/// file. Well-formed are the sequences of table 3-7 of the Unicode Standard: no overlong forms, no
/// surrogates, nothing beyond U+10FFFF.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

struct Utf8_character {
  char32_t code;          // U+FFFD for what is ill-formed
  std::string_view bytes; // as they stand in the text
  bool well_formed;
};

constexpr char32_t replacement_character = 0xFFFD;
constexpr std::string_view replacement_bytes = "\xEF\xBF\xBD";

// The first character of a text that is not empty. Ill-formed text is taken as far as it could
// begin a character, at least one byte ("maximal subpart").
inline Utf8_character first_utf8_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {lead, text.substr(0, 1), true};
  const std::size_t more = 0xC2 <= lead && lead <= 0xDF ? 1 : (lead & 0xF0) == 0xE0 ? 2 : (lead & 0xF8) == 0xF0 ? 3 : 0;
  if (more == 0 || 0xF4 < lead) return {replacement_character, text.substr(0, 1), false};
  // the second byte tells overlong forms, surrogates and what is too large
  unsigned least = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
  unsigned most = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
  char32_t code = lead & (0x3Fu >> more);
  for (std::size_t i = 1; i <= more; ++i) {
    if (i == text.size() || byte(i) < least || most < byte(i)) return {replacement_character, text.substr(0, i), false};
    code = code << 6 | (byte(i) & 0x3Fu);
    least = 0x80;
    most = 0xBF;
  }
  return {code, text.substr(0, more + 1), true};
}

// Calls f(character) for each Utf8_character of a text.
template <class Function> void for_each_utf8_character(std::string_view text, Function f) {
  while (!text.empty()) {
    const Utf8_character c = first_utf8_character(text);
    f(c);
    text.remove_prefix(c.bytes.size());
  }
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_UTF8_H
