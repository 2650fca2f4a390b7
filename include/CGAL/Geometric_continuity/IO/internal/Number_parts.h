// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_NUMBER_PARTS_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_NUMBER_PARTS_H

#include <CGAL/Geometric_continuity/IO/limits.h>

#include <stdexcept>
#include <string>
#include <string_view>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Why a text is not read as a number; the text itself is added by those who know where it stands.
class Number_error : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The parts of the text of a number: a decimal, or a fraction when there is a denominator.
struct Number_parts {
  bool negative = false;
  std::string_view integer, fraction, denominator; // digits
  int exponent = 0;
};

inline bool take(std::string_view& text, char c) {
  const bool found = !text.empty() && text.front() == c;
  if (found) text.remove_prefix(1);
  return found;
}

// Takes an optional sign and tells whether it is a minus.
inline bool take_minus(std::string_view& text) {
  if (take(text, '+')) return false;
  return take(text, '-');
}

inline std::string_view take_digits(std::string_view& text) {
  const std::string_view digits = text.substr(0, text.find_first_not_of("0123456789"));
  text.remove_prefix(digits.size());
  return digits;
}

inline bool all_zero(std::string_view digits) { return digits.find_first_not_of('0') == std::string_view::npos; }

inline int decimal_exponent(std::string_view text) {
  const bool negative = take_minus(text);
  const std::string_view digits = take_digits(text);
  if (digits.empty() || !text.empty()) throw Number_error("not a number");
  int exponent = 0;
  for (char c : digits) {
    exponent = 10 * exponent + (c - '0');
    if (exponent > max_decimal_exponent)
      throw Number_error("decimal exponent beyond " + std::to_string(max_decimal_exponent));
  }
  return negative ? -exponent : exponent;
}

inline Number_parts number_parts(std::string_view text) {
  if (text.empty()) throw Number_error("empty number");
  Number_parts parts;
  parts.negative = take_minus(text);
  parts.integer = take_digits(text);
  if (!parts.integer.empty() && take(text, '/')) {
    parts.denominator = take_digits(text);
    if (parts.denominator.empty() || !text.empty()) throw Number_error("not a number");
    if (all_zero(parts.denominator)) throw Number_error("zero denominator");
    return parts;
  }
  if (take(text, '.')) parts.fraction = take_digits(text);
  if (parts.integer.empty() && parts.fraction.empty()) throw Number_error("not a number");
  if (take(text, 'e') || take(text, 'E'))
    parts.exponent = decimal_exponent(text);
  else if (!text.empty())
    throw Number_error("not a number");
  return parts;
}

inline void check_number_length(std::string_view text) {
  if (text.size() > max_number_length)
    throw Number_error("number longer than " + std::to_string(max_number_length) + " characters");
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_NUMBER_PARTS_H
