// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_NUMBER_TEXT_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_NUMBER_TEXT_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/text.h>
#include <CGAL/Geometric_continuity/numbers/internal/Rational_parts.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/zero_bits.h>
#include <CGAL/ipower.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>

/// \file number_text.h
/// Reads and writes numbers in texts. Nearly all numbers of files are decimals with few digits:
/// integers times powers of ten, for which no numbers of any length are needed.

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

  // Returns whether there are at most 18 places, as there are of nearly all numbers; then the value
  // is made at once. equivalent [<= -> <, 2]: the general road makes the same number
  bool is_short_fraction() const { return -max_digits <= exponent && exponent <= 0; }
  template <class FT> FT short_fraction() const {
    return Rational_parts<FT>::make_short(digits, CGAL::ipower(std::int64_t(10), -exponent));
  }
};

inline bool is_digit(char c) { return '0' <= c && c <= '9'; }

// Appends decimal digits to a number.
inline std::uint64_t append_digits(std::uint64_t value, const char* p, const char* end) {
  for (; p != end; ++p) value = 10 * value + static_cast<std::uint64_t>(*p - '0');
  return value;
}

// Eight characters in a word, the first one in the lowest byte.
inline std::uint64_t eight_characters(const char* p) {
  const auto byte = [p](int i) { return static_cast<std::uint64_t>(static_cast<unsigned char>(p[i])) << (8 * i); };
  return byte(0) | byte(1) | byte(2) | byte(3) | byte(4) | byte(5) | byte(6) | byte(7);
}

// Returns the differences of the high halves of eight characters from those of digits, zero for
// digits. After the first character that is no digit the result is unspecified, because of a carry.
inline std::uint64_t no_digits(std::uint64_t characters) {
  constexpr std::uint64_t high = 0xf0f0f0f0f0f0f0f0, digit = 0x3030303030303030;
  return ((characters & high) ^ digit) | (((characters + 0x0606060606060606) & high) ^ digit);
}

// The number that eight characters are, digits or zeros: neighbours make pairs, pairs make fours,
// and fours the number.
inline std::uint64_t number_of_eight(std::uint64_t characters) {
  std::uint64_t x = characters & 0x0f0f0f0f0f0f0f0f;
  x = (x * (10 * 0x100 + 1)) >> 8 & 0x00ff00ff00ff00ff;
  x = (x * (100 * 0x10000 + 1)) >> 16 & 0x0000ffff0000ffff;
  return (x * (10000 * std::uint64_t(0x100000000) + 1)) >> 32;
}

// These append all digits from `p` on to a number, modulo 2^64, and return where they end: one by
// one, for a few, or eight at once.
inline const char* take_few_digits(const char* p, const char* end, std::uint64_t& value) {
  for (; p != end && is_digit(*p); ++p) value = 10 * value + static_cast<std::uint64_t>(*p - '0');
  return p;
}
inline const char* take_many_digits(const char* p, const char* end, std::uint64_t& value) {
  static constexpr std::uint64_t powers[] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};
  while (end - p >= 8) {
    const std::uint64_t characters = eight_characters(p), behind = no_digits(characters);
    const int digits = behind == 0 ? 8 : trailing_zero_bits(behind) / 8;
    if (digits != 0) value = powers[digits] * value + number_of_eight(characters << (64 - 8 * digits));
    p += digits;
    if (digits != 8) return p;
  }
  return take_few_digits(p, end, value);
}

// Reads a decimal, as number_parts() describes it, from the text that begins at `p`, as far as it
// goes. Returns where it ends; `decimal` is changed if it is a short one.
inline const char* read_short_decimal(const char* p, const char* end, Short_decimal& decimal) {
  const bool negative = p != end && *p == '-';
  if (p != end && (*p == '-' || *p == '+')) ++p;
  std::uint64_t value = 0;
  const char* const integer = p;
  p = take_few_digits(p, end, value);
  const char *const point = p, *fraction = p;
  if (point != integer && point - integer <= Short_decimal::max_digits &&
      (p == end || (*p != '.' && *p != 'e' && *p != 'E'))) {
    decimal = {negative ? -static_cast<std::int64_t>(value) : static_cast<std::int64_t>(value), 0};
    return p;
  }
  if (p != end && *p == '.') {
    fraction = ++p;
    p = take_many_digits(p, end, value);
  }
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
  // that count: zeros at the ends do not
  std::ptrdiff_t digits = point - integer + (last - fraction);
  for (const char* zero = integer; digits > Short_decimal::max_digits && (*zero == '0' || zero == point); ++zero)
    digits -= zero != point;
  if (digits > Short_decimal::max_digits) return p;
  if (last != behind) value = append_digits(append_digits(0, integer, point), fraction, last);
  decimal.digits = negative ? -static_cast<std::int64_t>(value) : static_cast<std::int64_t>(value);
  decimal.exponent = value == 0 ? 0 : exponent - static_cast<int>(last - fraction);
  return p;
}

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

// Numbers that are evaluated on demand, such as those of Lazy_exact_nt, are read and written in the
// type of their exact values.
template <class FT, class = void> struct Evaluated { typedef FT type; };
template <class FT> struct Evaluated<FT, std::void_t<decltype(std::declval<const FT&>().exact())>> {
  typedef std::decay_t<decltype(std::declval<const FT&>().exact())> type;
};

// Appends decimal digits to a natural number, by Horner's rule on pieces that fit in an int.
template <class FT> FT append_digits(FT value, std::string_view digits) {
  while (!digits.empty()) {
    const std::string_view piece = digits.substr(0, 9);
    const int number = static_cast<int>(append_digits(0, piece.data(), piece.data() + piece.size()));
    value = FT(FT(value * FT(CGAL::ipower(10, static_cast<int>(piece.size())))) + FT(number));
    digits.remove_prefix(piece.size());
  }
  return value;
}

// Returns 10^n, by squares.
template <class FT> FT power_of_ten(int n) {
  if (n == 0) return FT(1);
  const FT half = power_of_ten<FT>(n / 2), square(half * half);
  return n % 2 == 0 ? square : FT(square * FT(10));
}

template <class FT> FT exact_value(const Number_parts& parts) {
  FT value = append_digits(append_digits(FT(0), parts.integer), parts.fraction);
  const int exponent = parts.exponent - static_cast<int>(parts.fraction.size());
  if (!parts.denominator.empty())
    value = FT(value / append_digits(FT(0), parts.denominator));
  else if (exponent < 0)
    value = FT(value / power_of_ten<FT>(-exponent));
  else if (exponent > 0)
    value = FT(value * power_of_ten<FT>(exponent));
  return parts.negative ? FT(FT(0) - value) : value;
}

// The floating-point number nearest to `x >= 0`, in a tie the even one. It is found by bisection,
// with exact comparisons: floating-point numbers that are not negative are ordered as their bit
// patterns.
template <class FT> FT nearest_floating_point(const Exact_rational& x) {
  typedef std::conditional_t<sizeof(FT) == sizeof(std::uint32_t), std::uint32_t, std::uint64_t> Bits;
  static_assert(sizeof(FT) == sizeof(Bits) && std::numeric_limits<FT>::is_iec559, "float or double is expected");
  const auto number = [](Bits bits) {
    FT result;
    std::memcpy(&result, &bits, sizeof bits);
    return result;
  };
  const FT largest = (std::numeric_limits<FT>::max)();
  if (Exact_rational(largest) < x) throw Number_error("outside the range of floating-point numbers");
  Bits low = 0, high; // number(low) <= x <= number(high)
  std::memcpy(&high, &largest, sizeof high);
  while (high - low > 1) {
    const Bits middle = low + (high - low) / 2;
    (x < Exact_rational(number(middle)) ? high : low) = middle;
  }
  const Exact_rational sum = Exact_rational(number(low)) + Exact_rational(number(high)), twice_x = x + x;
  if (twice_x == sum) return number(low % 2 == 0 ? low : high);
  return number(twice_x < sum ? low : high);
}

// An exact number as the nearest one of a floating-point type, or as it is.
template <class FT, class Exact> FT nearest_number(const Exact& x) {
  if constexpr (std::is_same_v<FT, Exact>)
    return x;
  else if constexpr (std::is_floating_point_v<FT>) {
    const FT size = nearest_floating_point<FT>(x < Exact(0) ? Exact(-x) : x);
    return x < Exact(0) ? -size : size;
  } else
    return FT(x);
}

template <class FT> FT floating_point_value(std::string_view text, const Number_parts& parts) {
  FT value(0);
  if (!parts.denominator.empty()) {
    Number_parts absolute = parts;
    absolute.negative = false;
    value = nearest_floating_point<FT>(exact_value<Exact_rational>(absolute));
    if (value == FT(0) && !all_zero(parts.integer)) throw Number_error("outside the range of floating-point numbers");
    if (parts.negative) value = -value;
  } else {
    take(text, '+'); // which from_chars() does not know
    const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc()) throw Number_error("outside the range of floating-point numbers");
  }
  return value;
}

// The value of a text. Throws Number_error, so that the caller can say where the text stands.
template <class FT> FT number_value(std::string_view text) {
  typedef typename Evaluated<FT>::type Value;
  if constexpr (Rational_parts<Value>::value) {
    Short_decimal decimal;
    const char* const end = text.data() + text.size();
    if (text.size() <= max_number_length && read_short_decimal(text.data(), end, decimal) == end &&
        decimal.is_short_fraction())
      return FT(decimal.short_fraction<Value>());
  }
  check_number_length(text);
  const Number_parts parts = number_parts(text);
  if constexpr (std::is_floating_point_v<FT>)
    return floating_point_value<FT>(text, parts);
  else
    return FT(exact_value<typename Evaluated<FT>::type>(parts));
}

template <class FT> std::string floating_point_text(FT x) {
  check_finite(x, "write_number");
  char text[64];
  return std::string(text, std::to_chars(text, text + sizeof text, x).ptr);
}

// The text of a rational number whose numerator and denominator are short; empty for others.
template <class FT> std::string short_rational_text(const FT& x) {
  if constexpr (Rational_parts<FT>::value) {
    std::int64_t n, d;
    if (!Rational_parts<FT>::short_parts(x, n, d)) return {};
    char digits[32];
    std::string text(digits, std::to_chars(digits, digits + sizeof digits, n).ptr);
    if (d != 1) (text += '/').append(digits, std::to_chars(digits, digits + sizeof digits, d).ptr);
    return text;
  } else
    return {};
}

// Returns the text that the number type itself prints, with the sign in front and without a
// denominator 1. The text is read back, because some number types print approximations only.
template <class FT> std::string exact_text(const FT& x) {
  const std::string short_text = short_rational_text(x);
  if (!short_text.empty()) return short_text;
  std::ostringstream os;
  os.imbue(std::locale::classic());
  os << x;
  std::string text = os.str();
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    std::string numerator = text.substr(0, slash), denominator = text.substr(slash + 1);
    if (denominator[0] == '-') {
      denominator.erase(0, 1);
      numerator = numerator[0] == '-' ? numerator.substr(1) : '-' + numerator;
    }
    text = denominator == "1" ? numerator : numerator + '/' + denominator;
  }
  bool exact = false;
  try {
    exact = exact_value<FT>(number_parts(text)) == x;
  } catch (const Number_error&) {
  }
  if (!exact)
    throw Error(Error_code::cannot_write_file, "the number type does not print exact numbers: " + quoted_token(text));
  return text;
}

// The text that write_number() writes.
template <class FT> std::string number_text(const FT& x) {
  if constexpr (std::is_floating_point_v<FT>)
    return floating_point_text(x);
  else if constexpr (std::is_same_v<typename Evaluated<FT>::type, FT>)
    return exact_text(x);
  else
    return exact_text(x.exact());
}

// A text that is complete is written at once, whatever the width, the flags and the locale of the
// stream.
inline void write_text(std::ostream& os, const std::string& text) {
  os.write(text.data(), static_cast<std::streamsize>(text.size()));
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_NUMBER_TEXT_H
