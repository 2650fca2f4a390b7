// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_NUMBER_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_NUMBER_H

/// \file IO/number.h
/// Numbers as text, read and written without loss: decimals, and fractions p/q for exact fields.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/internal/Number_parts.h>
#include <CGAL/Geometric_continuity/IO/internal/Short_decimal.h>
#include <CGAL/Geometric_continuity/IO/limits.h>
#include <CGAL/Geometric_continuity/IO/quoted_token.h>
#include <CGAL/Geometric_continuity/numbers/internal/Rational_parts.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/ipower.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// Numbers that are evaluated on demand, such as those of Lazy_exact_nt, are read and written in the type of their exact
// values.
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

// 10^n, by squares.
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

// The floating-point number nearest to `x >= 0`, in a tie the even one. It is found by bisection, with exact
// comparisons: floating-point numbers that are not negative are ordered as their bit patterns.
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
    if (parts.negative) value = -value;
  } else {
    take(text, '+'); // which from_chars() does not know
    const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || !std::isfinite(value))
      throw Number_error("outside the range of floating-point numbers");
  }
  if (value == FT(0) && !(all_zero(parts.integer) && all_zero(parts.fraction)))
    throw Number_error("outside the range of floating-point numbers");
  return value;
}

// The value of a short decimal with at most 18 places, as nearly all numbers are; returns false for others.
template <class FT> bool short_decimal_value(const Short_decimal& decimal, FT& value) {
  if constexpr (Rational_parts<FT>::value) {
    if (!decimal.exists() || decimal.exponent < -Short_decimal::max_digits || decimal.exponent > 0) return false;
    value = Rational_parts<FT>::make_short(decimal.digits, CGAL::ipower(std::int64_t(10), -decimal.exponent));
    return true;
  } else
    return false;
}

// The value of a text. Throws Number_error, so that the caller can say where the text stands.
template <class FT> FT number_value(std::string_view text) {
  if constexpr (Rational_parts<typename Evaluated<FT>::type>::value) {
    Short_decimal decimal;
    typename Evaluated<FT>::type value;
    const char* const end = text.data() + text.size();
    if (text.size() <= max_number_length && read_short_decimal(text.data(), end, decimal) == end &&
        short_decimal_value(decimal, value))
      return FT(value);
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

// What the number type itself prints, with the sign in front and without a denominator 1. It is read back, because
// some number types print approximations only.
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

// A text that is complete is written at once, whatever the width, the flags and the locale of the stream.
inline void write_text(std::ostream& os, const std::string& text) {
  os.write(text.data(), static_cast<std::streamsize>(text.size()));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityIO
/// Returns the number that is written in a text. This is an optional sign, then a decimal (`12`, `-.5`, `3.`, `1e-3`,
/// `1.5E+4`) or a fraction `p/q` of two integers of which the second is positive and has no sign.
///
/// In a field other than the floating-point types the number is exactly what is written: `0.1` is 1/10. In `float` and
/// `double` decimals and fractions are rounded to the nearest number, to the even one in a tie; a number that would
/// become infinite, a fraction beyond the largest finite number, and a number that is not zero and would become zero
/// are refused. A number that becomes subnormal is read.
///
/// Linear many operations of the field in the number of characters.
///
/// \tparam FT a field number type: `float`, `double`, or a type constructible from `int` with `+`, `-`, `*` and `/`.
///   When it has a member function `exact()`, it must be constructible from the result.
/// \throws Error `malformed_input`, with the text (shortened) and the reason, for everything else: an empty text,
///   `nan`, `inf`, hexadecimal numbers, trailing characters, more than `max_number_length` characters, an exponent
///   beyond `max_decimal_exponent`
template <class FT> FT parse_number(std::string_view token) {
  try {
    return internal::number_value<FT>(token);
  } catch (const internal::Number_error& error) {
    throw Error(Error_code::malformed_input, std::string(error.what()) + ": " + quoted_token(token));
  }
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a number without loss: `parse_number()` of the text gives the number back, provided that the text is not
/// longer than `max_number_length`. Floating-point numbers are written as their shortest decimal, numbers of other
/// fields as `p` or `p/q`. Locale, precision, width and flags of the stream are ignored.
///
/// \tparam FT `float`, `double`, or a field number type as for `parse_number()` with `==` and an `operator<<` that
///   prints `p` or `p/q`; when it has a member function `exact()`, that is asked of the result
/// \throws Error `not_finite` for an infinite or undefined floating-point number; `cannot_write_file` when the number
///   type prints something else than the number, as does `Quotient<MP_Float>`; nothing is written then
template <class FT> void write_number(std::ostream& os, const FT& x) {
  internal::write_text(os, internal::number_text(x));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_NUMBER_H
