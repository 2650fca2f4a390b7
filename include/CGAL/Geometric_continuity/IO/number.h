// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_NUMBER_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_NUMBER_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/internal/number_text.h>
#include <CGAL/Geometric_continuity/IO/text.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>

/// \file IO/number.h
/// Numbers as text, read and written without loss: decimals, and fractions p/q for exact fields;
/// and numbers that are kept as they are written. What is longer than the limits of text.h is
/// refused.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// Returns the number that is written in a text. This is an optional sign, then a decimal (`12`,
/// `-.5`, `3.`, `1e-3`, `1.5E+4`) or a fraction `p/q` of two integers of which the second is
/// positive and has no sign.
///
/// In a field other than the floating-point types the number is exactly what is written: `0.1` is
/// 1/10. In `float` and `double` decimals and fractions are rounded to the nearest number, to the
/// even one in a tie; a number that would become infinite, a fraction beyond the largest finite
/// number, and a number that is not zero and would become zero are refused. A number that becomes
/// subnormal is read.
///
/// Linear many operations of the field in the number of characters.
///
/// \tparam FT a field number type: `float`, `double`, or a type constructible from `int` with `+`,
///   `-`, `*` and `/`. When it has a member function `exact()`, it must be constructible from the
///   result.
/// \throws Error `malformed_input`, with the text (shortened) and the reason, for everything else:
///   an empty text, `nan`, `inf`, hexadecimal numbers, trailing characters, more than
///   `max_number_length` characters, an exponent beyond `max_decimal_exponent`
template <class FT> FT parse_number(std::string_view token) {
  try {
    return internal::number_value<FT>(token);
  } catch (const internal::Number_error& error) {
    throw Error(Error_code::malformed_input, std::string(error.what()) + ": " + quoted_token(token));
  }
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a number without loss: `parse_number()` of the text gives the number back, provided that
/// the text is not longer than `max_number_length`. Floating-point numbers are written as their
/// shortest decimal, numbers of other fields as `p` or `p/q`. Locale, precision, width and flags of
/// the stream are ignored.
///
/// \tparam FT `float`, `double`, or a field number type as for `parse_number()` with `==` and an
///   `operator<<` that prints `p` or `p/q`; when it has a member function `exact()`, that is asked
///   of the result
/// \throws Error `not_finite` for an infinite or undefined floating-point number;
///   `cannot_write_file` when the number type prints something else than the number, as does
///   `Quotient<MP_Float>`; nothing is written then
template <class FT> void write_number(std::ostream& os, const FT& x) {
  internal::write_text(os, internal::number_text(x));
}

/// \ingroup PkgGeometricContinuityIO
/// A number as it stands in a text, exactly: a decimal with at most 18 digits as an integer times a
/// power of ten, for which no memory is allocated, and everything else that `parse_number()`
/// accepts as a rational number. It is for storing and comparing; whoever computes takes `value()`,
/// or brings several numbers on a common grid with `on_grid()`.
class Decimal {
  std::int64_t digits_ = 0;
  int exponent_ = 0;
  std::shared_ptr<const Exact_rational> exact_; // in place of the decimal

public:
  /// Constructs 0.
  Decimal() = default;
  /// Constructs `digits` \f$ \cdot 10^{exponent} \f$. \pre at most 18 digits, and an exponent of at
  /// most `max_decimal_exponent`
  explicit Decimal(std::int64_t digits, int exponent = 0) : digits_(digits), exponent_(digits == 0 ? 0 : exponent) {}
  /// Constructs any rational number.
  explicit Decimal(const Exact_rational& x) : exact_(std::make_shared<const Exact_rational>(x)) {}
  /// Reads a number. \throws Error `malformed_input` as `parse_number()` does
  explicit Decimal(std::string_view text) {
    internal::Short_decimal decimal;
    if (!text.empty() && text.size() <= max_number_length &&
        internal::read_short_decimal(text.data(), text.data() + text.size(), decimal) == text.data() + text.size() &&
        decimal.exists())
      *this = Decimal(decimal.digits, decimal.exponent);
    else
      *this = Decimal(parse_number<Exact_rational>(text));
  }

  /// Returns whether the number is kept as a decimal.
  bool is_decimal() const { return !exact_; }

  /// Returns the exponent of the power of ten of which the number is a multiple; 0 for the
  /// number 0. \pre `is_decimal()`
  int exponent() const { return exponent_; }

  /// Returns the number.
  Exact_rational value() const {
    if (exact_) return *exact_;
    if constexpr (internal::Rational_parts<Exact_rational>::value) {
      const internal::Short_decimal decimal{digits_, exponent_};
      if (decimal.is_short_fraction()) return decimal.short_fraction<Exact_rational>();
    }
    internal::Number_parts parts;
    const std::string digits = std::to_string(digits_ < 0 ? -digits_ : digits_);
    parts.negative = digits_ < 0;
    parts.integer = digits;
    parts.exponent = exponent_;
    return internal::exact_value<Exact_rational>(parts);
  }

  /// Computes the integer `x` with the number \f$ x \cdot 10^{exponent} \f$. Returns false, and
  /// leaves `x`, if there is none below \f$ 2^{60} \f$ in absolute value, for an exponent above
  /// `exponent()` unless the number is 0, and for a number that is not kept as a decimal.
  bool on_grid(int exponent, std::int64_t& x) const {
    if (exact_) return false;
    if (digits_ == 0) {
      x = 0;
      return true;
    }
    if (exponent > exponent_ || exponent_ - exponent > 18) return false;
    const std::int64_t power = powers[exponent_ - exponent], largest = largest_digits[exponent_ - exponent];
    if (digits_ > largest || digits_ < -largest) return false;
    x = digits_ * power;
    return true;
  }

  /// Returns an enclosure of the number. \pre rounding is upwards, as in the scope of
  /// `Protect_FPU_rounding`
  Interval_nt<false> enclosure() const {
    typedef Interval_nt<false> Interval;
    if (exact_) return Interval(CGAL::to_interval(*exact_));
    Interval x(-static_cast<double>(-digits_), static_cast<double>(digits_));
    constexpr int most = static_cast<int>(powers.size()) - 1;
    for (int e = exponent_; e != 0;) {
      const int step = (std::min)((std::max)(e, -most), most);
      const Interval power(static_cast<double>(powers[step < 0 ? -step : step])); // exact
      x = step < 0 ? x / power : x * power;
      e -= step;
    }
    return x;
  }

  friend bool operator==(const Decimal& x, const Decimal& y) {
    if (x.exponent_ == y.exponent_ && !x.exact_ && !y.exact_) return x.digits_ == y.digits_;
    return x.compare(y) == 0;
  }
  friend bool operator!=(const Decimal& x, const Decimal& y) { return !(x == y); }
  friend bool operator<(const Decimal& x, const Decimal& y) {
    if (x.exponent_ == y.exponent_ && !x.exact_ && !y.exact_) return x.digits_ < y.digits_;
    return x.compare(y) < 0;
  }

private:
  // 10^k, and the largest integers whose product with it is below 2^60.
  static constexpr std::array<std::int64_t, 19> powers = [] {
    std::array<std::int64_t, 19> p{1};
    for (int k = 1; k < 19; ++k) p[k] = 10 * p[k - 1];
    return p;
  }();
  static constexpr std::array<std::int64_t, 19> largest_digits = [] {
    std::array<std::int64_t, 19> largest{(std::int64_t(1) << 60) - 1};
    for (int k = 1; k < 19; ++k) largest[k] = largest[k - 1] / 10;
    return largest;
  }();

  // The sign of the difference.
  int compare(const Decimal& other) const {
    std::int64_t x, y;
    const int exponent = (std::min)(exponent_, other.exponent_);
    // equivalent [1 -> 2, 2]: any positive number says that it is greater
    if (on_grid(exponent, x) && other.on_grid(exponent, y)) return x < y ? -1 : y < x ? 1 : 0;
    const Exact_rational a = value(), b = other.value();
    return a < b ? -1 : b < a ? 1 : 0;
  }
};

#ifndef CGAL_NO_DEPRECATED_CODE
// Old names, for one release.
using Text_number CGAL_DEPRECATED = Decimal;
#endif

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_NUMBER_H
