// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_SHORT_DECIMAL_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_SHORT_DECIMAL_H

#include <CGAL/Geometric_continuity/IO/limits.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

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

// Whether the next eight characters are digits.
inline bool are_eight_digits(const char* p) {
  std::uint64_t x;
  std::memcpy(&x, p, 8);
  constexpr std::uint64_t high = 0xf0f0f0f0f0f0f0f0;
  return (x & high) == 0x3030303030303030 && ((x + 0x0606060606060606) & high) == 0x3030303030303030;
}

// Appends all digits from `p` on to a number, modulo 2^64. Returns where they end.
inline const char* take_digits(const char* p, const char* end, std::uint64_t& value) {
  const auto pair = [&p](int i) { return static_cast<std::uint64_t>(10 * (p[i] - '0') + (p[i + 1] - '0')); };
  for (; end - p >= 8 && are_eight_digits(p); p += 8)
    value = 100000000 * value + (10000 * (100 * pair(0) + pair(2)) + (100 * pair(4) + pair(6)));
  for (; p != end && is_digit(*p); ++p) value = 10 * value + static_cast<std::uint64_t>(*p - '0');
  return p;
}

// Reads a decimal, as number_parts() describes it, from the text that begins at `p`, as far as it goes. Returns where it ends; `decimal`
// is changed if it is a short one.
inline const char* read_short_decimal(const char* p, const char* end, Short_decimal& decimal) {
  const bool negative = p != end && *p == '-';
  if (p != end && (*p == '-' || *p == '+')) ++p;
  std::uint64_t value = 0;
  const char* const integer = p;
  p = take_digits(p, end, value);
  const char* const point = p;
  if (p != end && *p == '.') ++p;
  const char* const fraction = p;
  p = take_digits(p, end, value);
  const char *const behind = p, *last = behind;
  if (point - integer + (behind - fraction) == 0) return p;
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
  while (last != fraction && last[-1] == '0') --last;
  std::ptrdiff_t digits = point - integer + (last - fraction); // that count: zeros at the ends do not
  for (const char* zero = integer; digits > Short_decimal::max_digits && (*zero == '0' || zero == point); ++zero)
    digits -= zero != point;
  if (digits > Short_decimal::max_digits) return p;
  if (last != behind) value = append_digits(append_digits(0, integer, point), fraction, last);
  decimal.digits = negative ? -static_cast<std::int64_t>(value) : static_cast<std::int64_t>(value);
  decimal.exponent = value == 0 ? 0 : exponent - static_cast<int>(last - fraction);
  return p;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_SHORT_DECIMAL_H
