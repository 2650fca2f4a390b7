// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_COMMON_GRID_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_COMMON_GRID_H

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// 2^e for -1022 <= e <= 1023
BOOST_FORCEINLINE double power_of_two(int e) {
  const std::uint64_t bits = static_cast<std::uint64_t>(e + 1023) << 52;
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

// floor(log2(x)) for a finite x >= 2^-1022; less than that for a smaller one
BOOST_FORCEINLINE int binary_exponent(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof x);
  return static_cast<int>(bits >> 52) - 1023;
}

BOOST_FORCEINLINE double largest(const std::array<double, 2>& x) { return std::max(std::abs(x[0]), std::abs(x[1])); }
BOOST_FORCEINLINE double largest(const std::array<double, 3>& x) {
  return std::max(std::max(std::abs(x[0]), std::abs(x[1])), std::abs(x[2]));
}

// Units of 2^exponent in which numbers of at most 2^(exponent + 53) are at most 2^53.
class Grid {
  double units_ = 1, unit_ = 1;
  int exponent_ = 0;
  bool valid_ = false;

public:
  // For numbers up to `largest`; not valid beyond 2^500 or below 2^-400.
  BOOST_FORCEINLINE explicit Grid(double largest) {
    const int e = binary_exponent(largest);
    valid_ = -400 <= e && e <= 500;
    exponent_ = valid_ ? e - 52 : 0;
    units_ = power_of_two(-exponent_);
    unit_ = power_of_two(exponent_);
  }

  BOOST_FORCEINLINE int exponent() const { return exponent_; }
  // All numbers that have been converted lie on the grid.
  BOOST_FORCEINLINE bool valid() const { return valid_; }

  // \pre the number is not larger than `largest`, and the grid was valid for this
  BOOST_FORCEINLINE std::int64_t operator()(double x) {
    const std::int64_t n = static_cast<std::int64_t>(x * units_); // at most 2^53
    valid_ &= static_cast<double>(n) * unit_ == x;
    return n;
  }
  BOOST_FORCEINLINE std::array<std::int64_t, 2> operator()(const std::array<double, 2>& x) {
    return {(*this)(x[0]), (*this)(x[1])};
  }
  BOOST_FORCEINLINE std::array<std::int64_t, 3> operator()(const std::array<double, 3>& x) {
    return {(*this)(x[0]), (*this)(x[1]), (*this)(x[2])};
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_COMMON_GRID_H
