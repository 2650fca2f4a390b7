// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_COMMON_GRID_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_COMMON_GRID_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/numbers/internal/zero_bits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// 2^e for -1022 <= e <= 1023
CGAL_GC_FORCEINLINE double power_of_two(int e) {
  const std::uint64_t bits = static_cast<std::uint64_t>(e + 1023) << 52;
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

CGAL_GC_FORCEINLINE std::uint64_t bits_of(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof x);
  return bits;
}

// floor(log2(x)) for a finite x >= 2^-1022; less than that for a smaller one
CGAL_GC_FORCEINLINE int binary_exponent(double x) { return static_cast<int>(bits_of(x) >> 52) - 1023; }

CGAL_GC_FORCEINLINE double largest(const std::array<double, 2>& x) {
  return (std::max)(std::abs(x[0]), std::abs(x[1]));
}
CGAL_GC_FORCEINLINE double largest(const std::array<double, 3>& x) {
  return (std::max)((std::max)(std::abs(x[0]), std::abs(x[1])), std::abs(x[2]));
}

// Units of 2^exponent in which numbers of at most 2^(exponent + 53) are at most 2^53.
class Grid {
  double units_ = 1, unit_ = 1;
  // equivalent [0 -> 1, 1]: assigned by the constructor
  int exponent_ = 0;
  bool valid_ = false;

public:
  // Makes a grid for numbers up to `largest`; it is not valid beyond 2^500 or below 2^-400.
  CGAL_GC_FORCEINLINE explicit Grid(double largest) {
    const int e = binary_exponent(largest);
    valid_ = -400 <= e && e <= 500;
    exponent_ = valid_ ? e - 52 : 0;
    units_ = power_of_two(-exponent_);
    unit_ = power_of_two(exponent_);
  }

  CGAL_GC_FORCEINLINE int exponent() const { return exponent_; }
  // All numbers that have been converted lie on the grid.
  CGAL_GC_FORCEINLINE bool valid() const { return valid_; }

  // \pre the number is not larger than `largest`, and the grid was valid for this
  CGAL_GC_FORCEINLINE std::int64_t operator()(double x) {
    const std::int64_t n = static_cast<std::int64_t>(x * units_); // at most 2^53
    valid_ &= static_cast<double>(n) * unit_ == x;
    return n;
  }
  CGAL_GC_FORCEINLINE std::array<std::int64_t, 2> operator()(const std::array<double, 2>& x) {
    return {(*this)(x[0]), (*this)(x[1])};
  }
  CGAL_GC_FORCEINLINE std::array<std::int64_t, 3> operator()(const std::array<double, 3>& x) {
    return {(*this)(x[0]), (*this)(x[1]), (*this)(x[2])};
  }
};

#if defined(__GNUC__)

// The coarsest grid of units 2^exponent that has all coordinates of the first k + 1 points of two
// ends.
//
// Let 2^e <= |x| < 2^(e+1) for the largest coordinate and G = 2^(e-51), then |x| < 2^52 G for all
// of them. Between 2^52 G and 2^53 G the doubles are the multiples of G: so 2^52 G + |x| is exact
// if x is a multiple of G, and so is (2^52 G + |x|) - 2^52 G =
// |x|; and otherwise, in every rounding mode, this is a multiple of G, so it is not |x|. The last
// 52 bits of the sum are |x|/G: the zeros at the end that all of them have go into the unit.
//
// One register has a coordinate of both ends.
template <int k, std::size_t N> class Common_grid {
  typedef double Numbers __attribute__((vector_size(16)));
  typedef std::int64_t Bits __attribute__((vector_size(16)));
  typedef std::array<std::array<double, N>, 4> Points;
  static constexpr std::size_t size = (k + 1) * N;

  Numbers sizes_[size];
  int first_exponent_ = 0;
  std::int64_t bits_ = 0;
  bool valid_ = false;

public:
  // Not valid beyond 2^500 or below 2^-400.
  CGAL_GC_FORCEINLINE Common_grid(const Points& x, const Points& y)
      : Common_grid(x, y, std::make_index_sequence<size>()) {}

  // All coordinates lie on a grid of 52 bits.
  CGAL_GC_FORCEINLINE bool valid() const { return valid_; }
  CGAL_GC_FORCEINLINE int exponent() const {
    return first_exponent_ + trailing_zero_bits(static_cast<std::uint64_t>(bits_) | std::uint64_t(1) << 51);
  }

private:
  template <std::size_t... i>
  CGAL_GC_FORCEINLINE Common_grid(const Points& x, const Points& y, std::index_sequence<i...>)
      : sizes_{absolute_values(x[i / N][i % N], y[i / N][i % N])...} {
    const Numbers most = largest();
    const int e = binary_exponent((std::max)(most[0], most[1]));
    if (!(-400 <= e && e <= 500)) return;
    const Numbers offset = {power_of_two(e + 1), power_of_two(e + 1)};
    const Numbers sums[] = {offset + sizes_[i]...};
    const Bits bits = (reinterpret_cast<Bits>(sums[i]) | ...),
               wrong = ((reinterpret_cast<Bits>(sums[i] - offset) ^ reinterpret_cast<Bits>(sizes_[i])) | ...);
    first_exponent_ = e - 51;
    bits_ = bits[0] | bits[1];
    valid_ = (wrong[0] | wrong[1]) == 0;
  }
  static CGAL_GC_FORCEINLINE Numbers absolute_values(double x, double y) {
    return reinterpret_cast<Numbers>(reinterpret_cast<Bits>(Numbers{x, y}) & INT64_MAX);
  }
  // unreachable: of registers with two numbers: no branch
  static CGAL_GC_FORCEINLINE Numbers larger(const Numbers& x, const Numbers& y) { return x < y ? y : x; }
  // Returns the largest exponents of the point j.
  CGAL_GC_FORCEINLINE Numbers largest(std::size_t j) const {
    const Numbers most = larger(sizes_[N * j], sizes_[N * j + 1]);
    if constexpr (N == 2)
      return most;
    else
      return larger(most, sizes_[N * j + 2]);
  }
  CGAL_GC_FORCEINLINE Numbers largest() const {
    const Numbers most = larger(largest(0), largest(1));
    if constexpr (k == 1)
      return most;
    else if constexpr (k == 2)
      return larger(most, largest(2));
    else
      return larger(most, larger(largest(2), largest(3)));
  }
};

#endif // __GNUC__

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_COMMON_GRID_H
