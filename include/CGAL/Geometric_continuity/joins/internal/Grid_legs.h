// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_GRID_LEGS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_GRID_LEGS_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/internal/End_polygon.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_grid.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The legs of an end in units of 2^exponent, if its points lie on such a grid.
template <int N> struct Grid_legs {
  Legs<std::int64_t, N> legs;
  int exponent;
  int zeros; // trailing bits that are zero in all legs
  bool valid;
};

CGAL_GC_FORCEINLINE std::int64_t any_bits(const std::array<std::int64_t, 2>& x) { return x[0] | x[1]; }
CGAL_GC_FORCEINLINE std::int64_t any_bits(const std::array<std::int64_t, 3>& x) { return x[0] | x[1] | x[2]; }

// The number of trailing zeros of a number below 2^54, 53 for zero.
inline int trailing_zeros(std::int64_t x) {
  // the lowest bit, as a double
  return x == 0 ? 53 : binary_exponent(static_cast<double>(x & -x));
}

// The legs without `shift` trailing zeros.
CGAL_GC_FORCEINLINE std::array<std::int64_t, 2> without_zeros(const std::array<std::int64_t, 2>& x, int shift) {
  return {x[0] >> shift, x[1] >> shift};
}
CGAL_GC_FORCEINLINE std::array<std::int64_t, 3> without_zeros(const std::array<std::int64_t, 3>& x, int shift) {
  return {x[0] >> shift, x[1] >> shift, x[2] >> shift};
}
template <int k, std::size_t N>
CGAL_GC_FORCEINLINE Legs<std::int64_t, N> without_zeros(const std::array<std::array<std::int64_t, N>, 3>& x,
                                                        int shift) {
  if constexpr (k == 1)
    return {without_zeros(x[0], shift)};
  else if constexpr (k == 2)
    return {without_zeros(x[0], shift), without_zeros(x[1], shift)};
  else
    return {without_zeros(x[0], shift), without_zeros(x[1], shift), without_zeros(x[2], shift)};
}

template <int k, std::size_t N>
CGAL_GC_FORCEINLINE Grid_legs<N> grid_legs_of(const std::array<std::array<double, N>, 4>& points) {
  Grid grid(largest_coordinate_of<k>(points));
  if (!grid.valid()) return {{}, 0, 0, false};
  End_polygon<std::int64_t, N> x;
  x[0] = grid(points[0]);
  x[1] = grid(points[1]);
  if constexpr (k >= 2) x[2] = grid(points[2]);
  if constexpr (k >= 3) x[3] = grid(points[3]);
  const Legs<std::int64_t, N> legs = legs_of<k>(x);
  std::int64_t bits = any_bits(legs[0]);
  if constexpr (k >= 2) bits |= any_bits(legs[1]);
  if constexpr (k >= 3) bits |= any_bits(legs[2]);
  return {legs, grid.exponent(), trailing_zeros(bits), grid.valid()};
}

// The largest power of two of which all coordinates of two ends are multiples, if these have at most 52 bits and no difference is longer
// than 53: then each leg and each difference, of at most `largest`, is a multiple of the unit, hence a double, and was computed
// without rounding.
template <int k, std::size_t N>
CGAL_GC_FORCEINLINE bool find_common_unit(const std::array<std::array<double, N>, 4>& p,
                                          const std::array<std::array<double, N>, 4>& q, double largest, int& unit) {
  Common_grid grid((std::max)(largest_coordinate_of<k>(p), largest_coordinate_of<k>(q)));
  if (!grid.valid()) return false;
  grid.include<k>(p);
  grid.include<k>(q);
  unit = grid.exponent();
  return grid.valid() && largest <= 0x1p53 * power_of_two(unit);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_GRID_LEGS_H
