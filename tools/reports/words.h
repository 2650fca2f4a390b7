// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_WORDS_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_WORDS_H

#include <CGAL/Geometric_continuity/IO/json.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

// Numbers and texts as reports write them.

// Returns a number and its noun, e.g. "1 join" or "2 joins".
inline std::string counted(std::size_t n, const std::string& noun) {
  return std::to_string(n) + ' ' + noun + (n == 1 ? "" : "s");
}

// Returns e.g. "rounding has broken 1 of 2 joins".
inline std::string broken_joins(std::size_t broken, std::size_t joins) {
  return "rounding has broken " + std::to_string(broken) + " of " + counted(joins, "join");
}

// Returns the text that rounded() has for both of two numbers, for most that are written without an
// exponent; empty for others. A number times an exact power of ten has a relative error below
// 2^-51, which matters only next to the middle between two integers.
inline std::string rounded_by_product(double x, double y, int digits) {
  static constexpr double powers[] = {1, 10, 100, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10};
  constexpr int most_digits = 6;
  const double size = std::abs(x);
  if (digits > most_digits || !(1e-4 < size && size < powers[digits])) return {};
  int places = 0; // behind the point: at most three zeros and the digits
  while (size * powers[places] < powers[digits - 1]) ++places;
  const double product = size * powers[places], low = std::floor(product), rest = product - low;
  const double other = std::abs(y) * powers[places] - low;
  if (std::abs(rest - 0.5) < 1e-6 || !(low + 1 < powers[digits])) return {};
  if (x != y && ((x < 0) != (y < 0) || !(0 <= other && other < 1) || std::abs(other - 0.5) < 1e-6 ||
                 (rest > 0.5) != (other > 0.5)))
    return {};
  int figures = static_cast<int>(low) + (rest > 0.5);
  for (; places > 0 && figures % 10 == 0; figures /= 10) --places;
  char text[24], *const end = text + sizeof text, *begin = end; // from the last figure on
  for (int i = 0; figures > 0 || i <= places; ++i, figures /= 10) {
    if (i > 0 && i == places) *--begin = '.';
    *--begin = static_cast<char>('0' + figures % 10);
  }
  if (x < 0) *--begin = '-';
  return std::string(begin, end);
}

// Appends texts, characters and whole numbers.
template <class... Parts> void append(std::string& text, const Parts&... parts) {
  const auto add = [&text](const auto& part) {
    typedef std::decay_t<decltype(part)> Part;
    if constexpr (std::is_integral_v<Part> && !std::is_same_v<Part, char>) {
      char digits[24];
      text.append(digits, std::to_chars(digits, digits + sizeof digits, part).ptr);
    } else
      text += part;
  };
  (add(parts), ...);
}

// Returns a number with this many significant digits, as printf() does with %g, but zero has no
// sign.
inline std::string rounded(double x, int digits) {
  std::string text = rounded_by_product(x, x, digits);
  if (!text.empty()) return text;
  char figures[64];
  const double y = x == 0 ? 0.0 : x;
  return std::string(figures,
                     std::to_chars(figures, figures + sizeof figures, y, std::chars_format::general, digits).ptr);
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
