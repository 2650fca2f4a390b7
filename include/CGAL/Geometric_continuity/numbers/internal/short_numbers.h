// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_SHORT_NUMBERS_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_SHORT_NUMBERS_H

#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

/// \file short_numbers.h
/// Floating-point numbers with few digits, so that exact numbers that are made of them stay short,
/// and numbers of a field as `double`, also where the field has nothing but what the concept
/// `GeometricContinuityTraits` asks for: integers of type `int`, the four operations and
/// comparisons.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The number with so many binary digits nearest to x, or of two the one farther from 0, in every
// rounding mode: the other digits are cut off from the bits of x, which is not subnormal, and far
// below the largest number.
template <int digits> double short_double(double x) {
  static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);
  constexpr int dropped = 53 - digits;
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof x);
  bits = (bits + (std::uint64_t(1) << (dropped - 1))) >> dropped << dropped;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

// Tells whether CGAL rounds numbers of this type and makes them of numbers of type double. It knows
// nothing of the rounded numbers of others, such as cpp_bin_float, and what it says of these does
// not compile.
template <class FT, bool = std::is_floating_point_v<FT> || !std::numeric_limits<FT>::is_specialized ||
                           std::numeric_limits<FT>::is_exact>
constexpr bool has_interval_v = Real_embeddable_traits<FT>::Is_real_embeddable::value;
template <class FT> constexpr bool has_interval_v<FT, false> = false;

// A number of any size as a double, with an error of a few units in the last place.
template <class FT> double rounded_number(const FT& x) {
  if constexpr (has_interval_v<FT>)
    return CGAL::to_double(x);
  else {
    const FT zero(0), one(1), two(2);
    if (x == zero) return 0;
    FT rest = x < zero ? FT(-x) : x;
    int exponent = 0;
    for (; !(rest < two); ++exponent) rest /= two;
    for (; rest < one; --exponent) rest *= two;
    double digits = 0; // of the number between 1 and 2
    for (int k = 0; k < std::numeric_limits<double>::digits; ++k) {
      digits *= 2;
      if (!(rest < one)) {
        digits += 1;
        rest -= one;
      }
      rest *= two;
    }
    return std::ldexp(x < zero ? -digits : digits, exponent + 1 - std::numeric_limits<double>::digits);
  }
}

// A number with at most 24 binary digits in any field, also in one that is made from integers only.
template <class FT> FT short_number_in(double x) {
  if constexpr (has_interval_v<FT>)
    return FT(x);
  else {
    constexpr int digits = 24;
    int exponent;
    const double mantissa = std::frexp(x, &exponent);
    FT result(static_cast<int>(std::ldexp(mantissa, digits)));
    const FT two(2);
    for (exponent -= digits; exponent > 0; --exponent) result *= two;
    for (; exponent < 0; ++exponent) result /= two;
    return result;
  }
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_SHORT_NUMBERS_H
