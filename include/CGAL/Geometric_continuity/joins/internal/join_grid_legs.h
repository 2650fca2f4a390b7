// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_GRID_LEGS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_GRID_LEGS_H

#include <CGAL/Geometric_continuity/joins/internal/join_on_grids.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_grid.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The legs of an end in units of 2^exponent, if its points lie on such a grid.
template <int N> struct Grid_legs {
  Differences<std::int64_t, N> legs;
  int exponent;
  int zeros; // trailing bits that are zero in all legs
  bool valid;
};

BOOST_FORCEINLINE std::int64_t any_bits(const std::array<std::int64_t, 2>& x) { return x[0] | x[1]; }
BOOST_FORCEINLINE std::int64_t any_bits(const std::array<std::int64_t, 3>& x) { return x[0] | x[1] | x[2]; }

// The number of trailing zeros of a number below 2^54, 53 for zero.
inline int trailing_zeros(std::int64_t x) {
  // the lowest bit, as a double
  return x == 0 ? 53 : binary_exponent(static_cast<double>(x & -x));
}

// The legs without `shift` trailing zeros.
BOOST_FORCEINLINE std::array<std::int64_t, 2> without_zeros(const std::array<std::int64_t, 2>& x, int shift) {
  return {x[0] >> shift, x[1] >> shift};
}
BOOST_FORCEINLINE std::array<std::int64_t, 3> without_zeros(const std::array<std::int64_t, 3>& x, int shift) {
  return {x[0] >> shift, x[1] >> shift, x[2] >> shift};
}
template <int k, std::size_t N>
BOOST_FORCEINLINE Differences<std::int64_t, N> without_zeros(const std::array<std::array<std::int64_t, N>, 3>& x,
                                                             int shift) {
  if constexpr (k == 1)
    return {without_zeros(x[0], shift)};
  else if constexpr (k == 2)
    return {without_zeros(x[0], shift), without_zeros(x[1], shift)};
  else
    return {without_zeros(x[0], shift), without_zeros(x[1], shift), without_zeros(x[2], shift)};
}

template <int k, std::size_t N>
BOOST_FORCEINLINE Grid_legs<N> grid_legs_of(const std::array<std::array<double, N>, 4>& points) {
  Grid grid(largest_coordinate_of<k>(points));
  if (!grid.valid()) return {{}, 0, 0, false};
  End_points<std::int64_t, N> x;
  x[0] = grid(points[0]);
  x[1] = grid(points[1]);
  if constexpr (k >= 2) x[2] = grid(points[2]);
  if constexpr (k >= 3) x[3] = grid(points[3]);
  const Differences<std::int64_t, N> legs = legs_of<k>(x);
  std::int64_t bits = any_bits(legs[0]);
  if constexpr (k >= 2) bits |= any_bits(legs[1]);
  if constexpr (k >= 3) bits |= any_bits(legs[2]);
  return {legs, grid.exponent(), trailing_zeros(bits), grid.valid()};
}

// The decision on legs on grids, or `unknown`.
template <Join_question question, int N, class Weights, class Stages>
BOOST_FORCEINLINE Join_answer decide_on_grid_legs(const Grid_legs<N>& left, int m, const Grid_legs<N>& right, int n,
                                                  int pivot, Weights w, Stages& stages) {
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  constexpr int k = highest_difference(question);
  if (!left.valid || !right.valid) return Join_answer::unknown;
  // The coarsest grid that has all legs, as far as the legs of each end allow: short numbers leave residues that say more.
  const int e = std::min(left.exponent + left.zeros, right.exponent + right.zeros), x = std::max(e - left.exponent, 0),
            y = std::max(e - right.exponent, 0);
  if (take_up<question>(w, left.exponent + x - right.exponent - y))
    return decide_on_grids<question, N>(differences_of<k, true>(without_zeros<k>(rotated<k>(left.legs, pivot), x), m),
                                        differences_of<k, false>(without_zeros<k>(rotated<k>(right.legs, pivot), y), n),
                                        w, stages);
#endif
  return Join_answer::unknown;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_GRID_LEGS_H
