// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_ENCLOSURE_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_ENCLOSURE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/certified_bounds.h>
#include <CGAL/Geometric_continuity/numbers/internal/decimal_bound.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <utility>

/// \file Enclosure.h
/// Guaranteed enclosures of numbers, of square roots and of angles by floating-point numbers: what is
/// reported about joins and edges that are nearly smooth. Nothing else in the package takes a root.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// A guaranteed enclosure of a real number by two floating-point numbers. For numbers that are neither tiny nor huge
/// the functions that make enclosures give at most four units in the last place.
struct Enclosure {
  double lower; ///< not larger than the number; finite
  double upper; ///< not less than the number; infinite when the number is larger than all floating-point numbers

  /// Decides whether both ends are equal.
  friend bool operator==(const Enclosure& x, const Enclosure& y) { return x.lower == y.lower && x.upper == y.upper; }
  /// Decides whether an end is different.
  friend bool operator!=(const Enclosure& x, const Enclosure& y) { return !(x == y); }

  /// Writes `[lower, upper]` rounded outwards: the decimals enclose the number, too. They have as many significant digits as
  /// the stream has precision, whatever its locale and its flags. Writes the number alone when both decimals are the same.
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
  if (!std::isfinite(i.first) || std::isnan(i.second)) throw Error(Error_code::not_finite, "enclosure");
  return i;
}

// The interval of a number that is not negative.
template <class FT> std::pair<double, double> nonnegative_interval(const FT& x, const char* place) {
  const std::pair<double, double> i = exact_interval(x);
  if (i.second < 0) throw Error(Error_code::parameter_outside_domain, place);
  return {i.first < 0 ? 0 : i.first, i.second};
}

// The angle in [0, pi], above pi/2 if it is obtuse, whose squared sine and cosine have this ratio.
template <class FT> Enclosure angle_of_squares(const FT& sine_squared, const FT& cosine_squared, bool obtuse) {
  const bool steep = cosine_squared < sine_squared; // the squared tangent, or cotangent, that is at most 1
  const FT &dividend = steep ? cosine_squared : sine_squared, &divisor = steep ? sine_squared : cosine_squared;
  if (divisor == FT(0)) throw Error(Error_code::zero_direction, "angle_enclosure");
  const std::pair<double, double> i = nonnegative_interval(FT(dividend / divisor), "angle_enclosure");
  const Angle_of_square::Function function = steep ? Angle_of_square::cotangent : Angle_of_square::tangent;
  const Angle_of_square first{function, obtuse, i.first}, second{function, obtuse, i.second};
  const bool falling = steep != obtuse;
  return falling ? Enclosure{second.below(), first.above()} : Enclosure{first.below(), second.above()};
}

// The product of two numbers that are not negative. In every rounding mode the rounded one is a neighbour of the exact one.
inline Enclosure nonnegative_product(const Enclosure& x, const Enclosure& y) {
  if (x.upper == 0 || y.upper == 0) return {0, 0};
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
/// Returns an enclosure of \f$ \sqrt{x} \f$ for `x >= 0`. \tparam FT a number type with `CGAL::to_interval()`
/// \throws Error `parameter_outside_domain` for a negative number
/// \throws Error `not_finite` for an infinite or undefined floating-point number
template <class FT> Enclosure root_enclosure(const FT& x) {
  const std::pair<double, double> i = internal::nonnegative_interval(x, "root_enclosure: a negative number");
  return {internal::root_below(i.first), std::isinf(i.second) ? i.second : internal::root_above(i.second)};
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns an enclosure, in radians, of the angle in \f$ [0, \pi] \f$ whose cosine has the sign of `cosine` and whose
/// sine and cosine have the squares \f$ s / (s + c^2) \f$ and \f$ c^2 / (s + c^2) \f$ with `s = sine_squared >= 0` and
/// `c = cosine`. It is exact for parallel vectors of one direction. \tparam FT a field number type with
/// `CGAL::to_interval()`
/// \throws Error `zero_direction` when both are zero, `parameter_outside_domain` when `sine_squared` is negative
/// \throws Error `not_finite` for an infinite or undefined floating-point number
template <class FT> Enclosure angle_enclosure(const FT& sine_squared, const FT& cosine) {
  return internal::angle_of_squares(sine_squared, FT(cosine * cosine), cosine < FT(0));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns an enclosure, in degrees, of an angle in \f$ [0, \pi] \f$ that is given in radians. Its upper end is at most 180.
inline Enclosure in_degrees(const Enclosure& angle) {
  // 180/pi = 57.2957795130823208... lies between these neighbours
  const Enclosure degrees = internal::nonnegative_product(angle, {57.29577951308232 - 0x1p-47, 57.29577951308232});
  return {degrees.lower, (std::min)(degrees.upper, 180.)};
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_ENCLOSURE_H
