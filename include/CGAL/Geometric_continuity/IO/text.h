// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_TEXT_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_TEXT_H

#include <CGAL/Geometric_continuity/IO/internal/utf8.h>

#include <cstddef>
#include <string>
#include <string_view>

/// \file IO/text.h
/// Text that comes from outside: how much of it is read, so that a few characters cannot fill the
/// memory, and how it is shown in messages.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// The longest text, in characters, that is read as a number.
constexpr std::size_t max_number_length = 4096;

/// \ingroup PkgGeometricContinuityIO
/// The largest absolute value of the exponent of a decimal.
constexpr int max_decimal_exponent = 4096;

/// \ingroup PkgGeometricContinuityIO
/// The highest order (degree + 1) of a curve or surface that is read from a `.g2` file.
constexpr int max_g2_order = 128;

/// \ingroup PkgGeometricContinuityIO
/// The highest dimension of a curve or surface that is read from a `.g2` file.
constexpr int max_g2_dimension = 16;

namespace internal {

// Returns whether a character controls a terminal, ends a line or changes the direction of the
// text.
inline bool is_control_character(char32_t c) {
  const auto between = [c](char32_t first, char32_t last) { return first <= c && c <= last; };
  return c < 0x20 || between(0x7F, 0x9F) || c == 0x061C || between(0x200E, 0x200F) || between(0x2028, 0x202E) ||
         between(0x2066, 0x2069);
}

inline std::string escaped_character(const Utf8_character& c) {
  constexpr char hex[] = "0123456789abcdef";
  switch (c.code) {
  case '\n': return "\\n";
  case '\r': return "\\r";
  case '\t': return "\\t";
  }
  std::string s;
  if (c.well_formed && 0x80 <= c.code) {
    s = "\\u";
    for (int shift = 12; shift >= 0; shift -= 4) s += hex[c.code >> shift & 0xF];
  } else
    for (char byte : c.bytes) s += {'\\', 'x', hex[static_cast<unsigned char>(byte) / 16], hex[byte & 0xF]};
  return s;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityIO
/// Returns a text as it can be shown on one line of a terminal, whatever it holds: names of files
/// and of elements come from outside. Control characters, line separators and characters that
/// change the direction of the text become `\n`, `\r`, `\t`, `\xhh` or `\uhhhh`, bytes that are not
/// UTF-8 `\xhh`. All else stays, also backslashes, so that a second call changes nothing.
inline std::string printable(std::string_view text) {
  std::string result;
  internal::for_each_utf8_character(text, [&](const internal::Utf8_character& c) {
    if (c.well_formed && !internal::is_control_character(c.code))
      result += c.bytes;
    else
      result += internal::escaped_character(c);
  });
  return result;
}

/// \ingroup PkgGeometricContinuityIO
/// Returns whether a text is well-formed UTF-8.
inline bool is_utf8(std::string_view text) {
  bool result = true;
  internal::for_each_utf8_character(text, [&](const internal::Utf8_character& c) { result = result && c.well_formed; });
  return result;
}

/// \ingroup PkgGeometricContinuityIO
/// Returns a text as messages show it: in single quotes, cut after 40 characters, and with bytes
/// that cannot be printed as `\xHH`.
inline std::string quoted_token(std::string_view text) {
  constexpr std::size_t longest = 40;
  constexpr char hex[] = "0123456789ABCDEF";
  std::string result = "'";
  for (char c : text.substr(0, longest)) {
    const unsigned char byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7F)
      result += c;
    else
      result += {'\\', 'x', hex[byte / 16], hex[byte % 16]};
  }
  return result + (text.size() > longest ? "...'" : "'");
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_TEXT_H
