// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_SHORT_DECIMAL_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_SHORT_DECIMAL_H

#include <CGAL/Geometric_continuity/IO/limits.h>

#include <cstdint>

/// \file Short_decimal.h
/// Numbers in a text as integers times powers of ten. Nearly all numbers of files are such decimals with few digits, which
/// needs no numbers of any length.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// digits * 10^exponent with at most 18 digits, or nothing of this kind.
struct Short_decimal {
  static constexpr int none = 1 << 30; // the exponent of nothing
  static constexpr int max_digits = 18;

  std::int64_t digits = 0;
  int exponent = none;

  bool exists() const { return exponent != none; }
};

inline bool is_digit(char c) { return '0' <= c && c <= '9'; }

// Appends decimal digits to a number.
inline std::uint64_t append_digits(std::uint64_t value, const char* p, const char* end) {
  for (; p != end; ++p) value = 10 * value + static_cast<std::uint64_t>(*p - '0');
  return value;
}

// Reads a decimal, as number_parts() describes it, from the text that begins at `p`, as far as it goes. Returns where it ends; `decimal`
// is changed if it is a short one.
inline const char* read_short_decimal(const char* p, const char* end, Short_decimal& decimal) {
  const bool negative = p != end && *p == '-';
  if (p != end && (*p == '-' || *p == '+')) ++p;
  const char* const integer = p;
  while (p != end && is_digit(*p)) ++p;
  const char* const point = p;
  if (p != end && *p == '.') ++p;
  const char* const fraction = p;
  while (p != end && is_digit(*p)) ++p;
  const char *const behind = p, *first = integer, *last = behind; // digits that count
  if (point - integer + (behind - fraction) == 0) return p;
  if (fraction != point) {
    while (last != fraction && last[-1] == '0') --last;
    if (last == fraction) last = point;
  }
  while (first != last && (*first == '0' || first == point)) ++first;
  int exponent = 0;
  if (p != end && (*p == 'e' || *p == 'E')) {
    const char* q = p + 1;
    const bool down = q != end && *q == '-';
    if (q != end && (*q == '-' || *q == '+')) ++q;
    if (q == end || !is_digit(*q)) return p;
    for (; q != end && is_digit(*q); ++q) {
      exponent = 10 * exponent + (*q - '0');
      if (exponent > max_decimal_exponent) return p;
    }
    if (down) exponent = -exponent;
    p = q;
  }
  const bool has_point = first < point && point < last;
  if (last - first - has_point > Short_decimal::max_digits) return p;
  const std::uint64_t value =
      has_point ? append_digits(append_digits(0, first, point), fraction, last) : append_digits(0, first, last);
  decimal.digits = negative ? -static_cast<std::int64_t>(value) : static_cast<std::int64_t>(value);
  if (value == 0)
    exponent = 0;
  else if (last > point)
    exponent -= static_cast<int>(last - fraction);
  decimal.exponent = exponent;
  return p;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_SHORT_DECIMAL_H
