// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_DOUBLE_SCALE_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_DOUBLE_SCALE_H

#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/zero_bits.h>

#include <CGAL/config.h>

#include <boost/config.hpp>

#ifdef CGAL_USE_GMP
#include <CGAL/Geometric_continuity/numbers/internal/Inline_integer.h>
#else
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

/// \file Double_scale.h
/// Numbers in a common unit, in which homogeneous expressions of them are computed without fractions: of a field, or floating-point
/// numbers. All numbers are included first; then each has a numerator.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The numbers of an exact field.
template <class Field> class Field_scale : Common_denominator<Field> {
public:
  typedef Field Number;
  typedef typename Common_denominator<Field>::Ring Ring;
  using Common_denominator<Field>::include;
  using Common_denominator<Field>::numerator;

  template <class FT> static Number number(const FT& x) { return to_field<Field>(x); }
};

#ifdef CGAL_USE_GMP

// Floating-point numbers of any size as whole numbers, in units of the largest power of two of which all that have been included are multiples.
class Binary_scale {
  int exponent_ = (std::numeric_limits<int>::max)();

public:
  typedef Inline_integer Ring;

  // A number with the sign of x and the absolute value odd_part 2^exponent, or 0.
  struct Number {
    std::uint64_t odd_part = 0;
    int exponent = (std::numeric_limits<int>::max)();
    bool negative = false;

    friend bool operator==(const Number& x, const Number& y) {
      return x.odd_part == y.odd_part && x.exponent == y.exponent && x.negative == y.negative;
    }
  };
  template <class FT> static BOOST_NOINLINE Number number(FT x) {
    constexpr int digits = std::numeric_limits<FT>::digits;
    static_assert(std::is_floating_point_v<FT> && digits <= 64);
    check_finite(x, "conversion to an exact number");
    if (x == 0) return Number();
    int e;
    const std::uint64_t n = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(x), &e), digits)); // exact
    const int zeros = trailing_zero_bits(n);
    return {n >> zeros, e - digits + zeros, x < 0};
  }

  void include(const Number& x) { exponent_ = (std::min)(exponent_, x.exponent); }
  // x in units. \pre x has been included
  Ring numerator(const Number& x) const {
    Ring y;
    y.assign(&x.odd_part, 1, x.negative);
    y <<= x.exponent - exponent_;
    return y;
  }
  // The same modulo 2^64.
  std::uint64_t residue(const Number& x) const {
    const int shift = x.exponent - exponent_;
    const std::uint64_t n = shift < 64 ? x.odd_part << shift : 0;
    return x.negative ? -n : n;
  }
};

typedef Binary_scale Double_scale;
#else
typedef Field_scale<Exact_field_of<double>::type> Double_scale;
#endif // CGAL_USE_GMP

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_DOUBLE_SCALE_H
