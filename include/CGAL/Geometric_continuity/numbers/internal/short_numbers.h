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

/// \file short_numbers.h
/// Floating-point numbers with few digits, so that exact numbers that are made of them stay short.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The number with so many binary digits nearest to x, or of two the one farther from 0, in every rounding mode: the other
// digits are cut off from the bits of x, which is not subnormal, and far below the largest number.
template <int digits> double short_double(double x) {
  static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);
  constexpr int dropped = 53 - digits;
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof x);
  bits = (bits + (std::uint64_t(1) << (dropped - 1))) >> dropped << dropped;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

template <class FT> constexpr bool has_interval_v = Real_embeddable_traits<FT>::Is_real_embeddable::value;

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
