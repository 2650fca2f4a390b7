// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_DECIMAL_BOUND_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_DECIMAL_BOUND_H

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>

/// \file decimal_bound.h
/// Short decimals that are bounds: a floating-point number rounded downwards or upwards. All its digits are written out, so
/// that neither the rounding mode nor the locale matters.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The number 0.d1 d2 d3... * 10^(exponent + 1) as text, without an exponent where that is short, as `%g` does.
inline std::string decimal_text(const std::string& digits, int exponent, int precision) {
  const int n = static_cast<int>(digits.size());
  if (exponent < -4 || precision <= exponent) {
    const std::string e = std::to_string(std::abs(exponent));
    return digits.substr(0, 1) + (n > 1 ? "." + digits.substr(1) : "") + (exponent < 0 ? "e-" : "e+") +
           (e.size() < 2 ? "0" + e : e);
  }
  if (exponent < 0) return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
  if (n <= exponent + 1) return digits + std::string(static_cast<std::size_t>(exponent + 1 - n), '0');
  return digits.substr(0, static_cast<std::size_t>(exponent + 1)) + '.' +
         digits.substr(static_cast<std::size_t>(exponent + 1));
}

// A decimal with the sign of x that is at most |x|, or at least |x| when it is rounded away from zero. It is the closest one
// with `precision` significant digits, from 1 on.
inline std::string rounded_decimal(double x, bool away_from_zero, int precision) {
  constexpr int most = 767; // digits that a floating-point number can have
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x < 0 ? "-inf" : "inf";
  if (x == 0) return "0";
  std::array<char, most + 16> text;
  const char* const end =
      std::to_chars(text.data(), text.data() + text.size(), std::abs(x), std::chars_format::scientific, most - 1).ptr;
  std::string digits(1, text[0]);
  digits.append(text.data() + 2, most - 1);
  const char* const sign = text.data() + 2 + most; // after the point, the digits and the e
  int exponent = 0;
  std::from_chars(sign + 1, end, exponent);
  if (*sign == '-') exponent = -exponent;

  const std::size_t kept = static_cast<std::size_t>((std::min)((std::max)(precision, 1), most));
  const bool exact = digits.find_first_not_of('0', kept) == std::string::npos;
  digits.resize(kept);
  if (!exact && away_from_zero) {
    const std::size_t last = digits.find_last_not_of('9'); // which grows, and 0 follows
    if (last == std::string::npos) {
      digits = "1";
      ++exponent;
    } else {
      ++digits[last];
      digits.resize(last + 1);
    }
  }
  digits.resize(digits.find_last_not_of('0') + 1);
  return (x < 0 ? "-" : "") + decimal_text(digits, exponent, static_cast<int>(kept));
}

// The largest decimal with this many significant digits that is not larger than x.
inline std::string decimal_below(double x, int precision) { return rounded_decimal(x, x < 0, precision); }
// The least decimal with this many significant digits that is not less than x.
inline std::string decimal_above(double x, int precision) { return rounded_decimal(x, x > 0, precision); }

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_DECIMAL_BOUND_H
