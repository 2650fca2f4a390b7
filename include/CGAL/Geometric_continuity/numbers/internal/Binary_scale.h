// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_BINARY_SCALE_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_BINARY_SCALE_H

#include <CGAL/config.h>

// As Rational_parts, only where there are the functions of GMP for limbs.
#ifdef CGAL_USE_GMP
#include <CGAL/Geometric_continuity/numbers/internal/Inline_integer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Doubles of any size as whole numbers, in units of the largest power of two of which all that have been included are multiples:
// Common_denominator for doubles.
class Binary_scale {
  int exponent_ = (std::numeric_limits<int>::max)();

public:
  typedef Inline_integer Ring;

  // A number with the sign of x and the absolute value odd_part 2^exponent, or 0.
  class Number {
    friend Binary_scale;
    std::uint64_t odd_part_ = 0;
    int exponent_ = (std::numeric_limits<int>::max)();
    bool negative_ = false;

  public:
    Number() = default;
    explicit Number(double x) : negative_(x < 0) {
      if (x == 0) return;
      int e;
      const std::uint64_t n = static_cast<std::uint64_t>(std::frexp(std::abs(x), &e) * 0x1p53); // exact
      const int zeros = __builtin_ctzll(n);
      odd_part_ = n >> zeros;
      exponent_ = e - 53 + zeros;
    }
  };

  void include(const Number& x) { exponent_ = (std::min)(exponent_, x.exponent_); }

  // x in units. \pre x has been included
  Ring numerator(const Number& x) const {
    Ring y;
    y.assign(&x.odd_part_, 1, x.negative_);
    y <<= x.exponent_ - exponent_;
    return y;
  }

  // The same modulo 2^64.
  std::uint64_t residue(const Number& x) const {
    const int shift = x.exponent_ - exponent_;
    const std::uint64_t n = shift < 64 ? x.odd_part_ << shift : 0;
    return x.negative_ ? -n : n;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_USE_GMP

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_BINARY_SCALE_H
