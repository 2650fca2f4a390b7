// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_ENCLOSURE_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_ENCLOSURE_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/certified_bounds.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <ostream>
#include <string>
#include <utility>

/// \file Enclosure.h
/// Guaranteed enclosures of numbers, of square roots and of angles by floating-point numbers, also
/// in degrees and percent. They are reported about joins and edges that are nearly smooth, and a
/// comparison with a bound proves a `Verdict`. Nothing else in the package takes a root.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// Short decimals that are bounds: a floating-point number rounded downwards or upwards. All its
// digits are written out, so that neither the rounding mode nor the locale matters.

// The number 0.d1 d2 d3... * 10^(exponent + 1) as text, without an exponent where that is short, as
// `%g` does.
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

// A decimal with the sign of x that is at most |x|, or at least |x| when it is rounded away from
// zero. It is the closest one with `precision` significant digits, from 1 on.
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

/// \ingroup PkgGeometricContinuityAlgebra
/// A guaranteed enclosure of a real number by two floating-point numbers. For numbers that are
/// neither tiny nor huge the functions that make enclosures give at most four units in the last
/// place.
struct Enclosure {
  double lower; ///< not larger than the number; finite
  /// not less than the number; infinite when the number is larger than all floating-point numbers
  double upper;

  /// Decides whether both ends are equal.
  friend bool operator==(const Enclosure& x, const Enclosure& y) { return x.lower == y.lower && x.upper == y.upper; }
  /// Decides whether an end is different.
  friend bool operator!=(const Enclosure& x, const Enclosure& y) { return !(x == y); }

  /// Writes `[lower, upper]` rounded outwards: the decimals enclose the number, too. They have as
  /// many significant digits as the stream has precision, whatever its locale and its flags. Writes
  /// the number alone when both decimals are the same.
  friend std::ostream& operator<<(std::ostream& os, const Enclosure& x) {
    const int digits = static_cast<int>(os.precision());
    const std::string below = internal::decimal_below(x.lower, digits),
                      above = internal::decimal_above(x.upper, digits);
    return os << (below == above ? below : '[' + below + ", " + above + ']');
  }
};

namespace internal {

// The closest interval of a number, also of one that is evaluated on demand.
template <class FT> std::pair<double, double> exact_interval(const FT& x) {
  const std::pair<double, double> i = CGAL::to_interval(Exact_number<FT>::of(x));
  if (!std::isfinite(i.first)) throw Error(Error_code::not_finite, "enclosure");
  return i;
}

// The interval of a number that is not negative.
template <class FT> std::pair<double, double> nonnegative_interval(const FT& x, const char* place) {
  const std::pair<double, double> i = exact_interval(x);
  if (x < FT(0)) throw Error(Error_code::parameter_outside_domain, place);
  return {(std::max)(i.first, 0.), i.second};
}

// The angle in [0, pi], above pi/2 if it is obtuse, whose squared sine and cosine have this ratio.
template <class FT> Enclosure angle_of_squares(const FT& sine_squared, const FT& cosine_squared, bool obtuse) {
  // the squared tangent, or cotangent, that is at most 1
  const bool steep = cosine_squared < sine_squared;
  const FT &dividend = steep ? cosine_squared : sine_squared, &divisor = steep ? sine_squared : cosine_squared;
  if (divisor == FT(0)) throw Error(Error_code::zero_direction, "angle_enclosure");
  const std::pair<double, double> i = nonnegative_interval(FT(dividend / divisor), "angle_enclosure");
  const Angle_of_square::Function function = steep ? Angle_of_square::cotangent : Angle_of_square::tangent;
  const Angle_of_square first{function, obtuse, i.first}, second{function, obtuse, i.second};
  const bool falling = steep != obtuse;
  return falling ? Enclosure{second.below(), first.above()} : Enclosure{first.below(), second.above()};
}

// The product of two numbers that are not negative. In every rounding mode the rounded one is a
// neighbour of the exact one.
inline Enclosure nonnegative_product(const Enclosure& x, const Enclosure& y) {
  if (x.upper == 0) return {0, 0};
  return {(std::max)(0., next_below(x.lower * y.lower)), next_above(x.upper * y.upper)};
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns an enclosure of a number. \tparam FT a number type with `CGAL::to_interval()`
/// \throws Error `not_finite` for an infinite or undefined floating-point number
template <class FT> Enclosure enclosure(const FT& x) {
  const std::pair<double, double> i = internal::exact_interval(x);
  return {i.first, i.second};
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns an enclosure of \f$ \sqrt{x} \f$ for `x >= 0`. \tparam FT a number type with
/// `CGAL::to_interval()`
/// \throws Error `parameter_outside_domain` for a negative number
/// \throws Error `not_finite` for an infinite or undefined floating-point number
template <class FT> Enclosure sqrt_enclosure(const FT& x) {
  const std::pair<double, double> i = internal::nonnegative_interval(x, "sqrt_enclosure: a negative number");
  return {internal::root_below(i.first), std::isinf(i.second) ? i.second : internal::root_above(i.second)};
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns an enclosure, in radians, of the angle in \f$ [0, \pi] \f$ whose cosine has the sign of
/// `cosine` and whose sine and cosine have the squares \f$ s / (s + c^2) \f$ and
/// \f$ c^2 / (s + c^2) \f$ with `s = sine_squared >= 0` and `c = cosine`. It is exact for parallel
/// vectors of one direction. \tparam FT a field number type with `CGAL::to_interval()`
/// \throws Error `zero_direction` when both are zero, `parameter_outside_domain` when
///   `sine_squared` is negative
/// \throws Error `not_finite` for an infinite or undefined floating-point number
template <class FT> Enclosure angle_enclosure(const FT& sine_squared, const FT& cosine) {
  return internal::angle_of_squares(sine_squared, FT(cosine * cosine), cosine < FT(0));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns an enclosure, in degrees, of an angle in \f$ [0, \pi] \f$ that is given in radians. Its
/// upper end is at most 180.
inline Enclosure in_degrees(const Enclosure& angle) {
  // 180/pi = 57.2957795130823208... lies between these neighbours
  const Enclosure degrees = internal::nonnegative_product(angle, {57.29577951308232 - 0x1p-47, 57.29577951308232});
  return {degrees.lower, (std::min)(degrees.upper, 180.)};
}

namespace internal {

// pi/180 = 0.017453292519943295769236... lies between these numbers.
struct Radians_of_degree {
  Exact_rational lower, upper;
  Radians_of_degree() {
    // both are exact
    const Exact_rational billion(1e9), unit = Exact_rational(1) / (Exact_rational(1e20));
    lower = (Exact_rational(1745329251.) * billion + Exact_rational(994329576.)) * unit;
    upper = lower + unit;
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns an enclosure, in radians, of an angle of so many degrees.
inline Enclosure in_radians(const Exact_rational& degrees) {
  const internal::Radians_of_degree one;
  const bool negative = degrees < 0;
  return {enclosure(Exact_rational(degrees * (negative ? one.upper : one.lower))).lower,
          enclosure(Exact_rational(degrees * (negative ? one.lower : one.upper))).upper};
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns an enclosure of a ratio in percent.
/// \throws Error `not_finite` when the lower bound is infinite or not a number
inline Enclosure in_percent(const Enclosure& ratio) {
  const auto times_100 = [](double x) { return enclosure(Exact_rational(Exact_rational(x) * Exact_rational(100))); };
  if (!std::isfinite(ratio.lower)) throw Error(Error_code::not_finite, "in_percent");
  return {times_100(ratio.lower).lower, std::isfinite(ratio.upper) ? times_100(ratio.upper).upper : ratio.upper};
}

/// \ingroup PkgGeometricContinuityContinuity
/// The answer to a question about a real number of which an enclosure is known.
enum class Verdict {
  proved,    ///< true
  refuted,   ///< false
  undecided, ///< the enclosure does not tell
};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns `proved`, `refuted` or `undecided`.
inline std::string to_string(Verdict verdict) {
  return verdict == Verdict::proved ? "proved" : verdict == Verdict::refuted ? "refuted" : "undecided";
}

/// \ingroup PkgGeometricContinuityContinuity
/// Writes `to_string(verdict)`.
inline std::ostream& operator<<(std::ostream& os, Verdict verdict) { return os << to_string(verdict); }

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether both are true: refuted if one of them is, proved if both are.
inline Verdict operator&&(Verdict x, Verdict y) {
  if (x == Verdict::refuted || y == Verdict::refuted) return Verdict::refuted;
  return x == Verdict::proved && y == Verdict::proved ? Verdict::proved : Verdict::undecided;
}

/// \ingroup PkgGeometricContinuityContinuity
/// A bound of a tolerance: a floating-point number, or a real number of which an enclosure is
/// known, such as a decimal or an angle that is given in degrees, see `in_radians()`.
class Bound {
  Enclosure value_;

public:
  /// Makes a bound of a number, 0 if none is given.
  Bound(double value = 0) : value_{value, value} {}
  /// Makes a bound of the number in an enclosure.
  Bound(const Enclosure& value) : value_(value) {}

  /// Returns a number that is not larger than the bound.
  double lower() const { return value_.lower; }
  /// Returns a number that is not less than the bound.
  double upper() const { return value_.upper; }
};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns whether the number in an enclosure is at most `bound`. Neither answer can be wrong: the
/// enclosure is compared with the lower end of the bound to prove it, and with the upper end to
/// refute it.
inline Verdict at_most(const Enclosure& x, const Bound& bound) {
  return x.upper <= bound.lower() ? Verdict::proved : bound.upper() < x.lower ? Verdict::refuted : Verdict::undecided;
}

namespace internal {

// Refuses a tolerance that is negative or not a number.
inline void check_bound(const Bound& bound) {
  if (!(0 <= bound.lower() && bound.lower() <= bound.upper()))
    throw Error(Error_code::unreachable_tolerance, "order_within: " + std::to_string(bound.lower()));
}

} // namespace internal

#ifndef CGAL_NO_DEPRECATED_CODE
// Old names, for one release.
template <class FT> CGAL_DEPRECATED Enclosure root_enclosure(const FT& x) { return sqrt_enclosure(x); }
#endif

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_ENCLOSURE_H
