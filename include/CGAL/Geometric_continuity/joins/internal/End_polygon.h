// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_END_POLYGON_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_END_POLYGON_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_filter.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// Four control points of an end from the join inwards, x_0 to x_3; beyond the degree, and beyond
// the order k that is asked for, the last one is repeated or they are unspecified.
template <class T, int N> using End_polygon = std::array<std::array<T, N>, 4>;

// Numbers that become doubles without rounding.
template <class FT> constexpr bool is_double = std::is_floating_point_v<FT> && sizeof(FT) <= sizeof(double);

// The control point number j of an end with double coordinates, from the join inwards and at most
// the last one, whose coordinate number `first` is exchanged for the first one.
template <int N, class Points> CGAL_GC_FORCEINLINE std::array<double, N> point_of(const Points& end, int j, int first) {
  const int l = (std::min)(end.degree(), j), second = first == 1 ? 0 : 1, third = first == 2 ? 0 : 2;
  if constexpr (N == 2)
    return {end.coordinate(l, first), end.coordinate(l, second)};
  else
    return {end.coordinate(l, first), end.coordinate(l, second), end.coordinate(l, third)};
}

// The end of a curve with double coordinates, or its start, as given but for the order of the
// coordinates. `Points` is something with degree(), domain() and coordinate(j, i).
template <int k, int N, class Points>
CGAL_GC_FORCEINLINE End_polygon<double, N> points_of(const Points& end, int first = 0) {
  static_assert(k >= 1);
  if constexpr (k == 1)
    return {point_of<N>(end, 0, first), point_of<N>(end, 1, first)};
  else if constexpr (k == 2)
    return {point_of<N>(end, 0, first), point_of<N>(end, 1, first), point_of<N>(end, 2, first)};
  else
    return {point_of<N>(end, 0, first), point_of<N>(end, 1, first), point_of<N>(end, 2, first),
            point_of<N>(end, 3, first)};
}

// The first differences x_1 - x_0, x_2 - x_1, x_3 - x_2 of such a polygon.
template <class T, int N> using First_differences = std::array<std::array<T, N>, 3>;

// As many first differences as the order k needs.
template <int k, class T, std::size_t N>
CGAL_GC_FORCEINLINE First_differences<T, N> first_differences(const std::array<std::array<T, N>, 4>& x) {
  if constexpr (k == 1)
    return {internal::minus(x[1], x[0])};
  else if constexpr (k == 2)
    return {internal::minus(x[1], x[0]), internal::minus(x[2], x[1])};
  else
    return {internal::minus(x[1], x[0]), internal::minus(x[2], x[1]), internal::minus(x[3], x[2])};
}

// The differences a_k (left) or b_k (right) from the first differences: from the join inwards,
// those of odd order point backwards on the left.
template <int k, bool left, class T, std::size_t N>
CGAL_GC_FORCEINLINE Differences<T, N> differences_of(const std::array<std::array<T, N>, 3>& differences, int degree) {
  const std::array<T, N> zero = zero_vector<T, N>();
  Differences<T, N> d{};
  d[0] = left ? internal::minus(zero, differences[0]) : differences[0];
  if constexpr (k >= 2) {
    d[1] = internal::minus(differences[1], differences[0]);
    if constexpr (k >= 3) {
      const std::array<T, N> second = internal::minus(differences[2], differences[1]);
      d[2] = left ? internal::minus(d[1], second) : internal::minus(second, d[1]);
      if (degree < 3) d[2] = zero;
    }
    if (degree < 2) d[1] = zero;
  }
  return d;
}

// The index of the first coordinate with the largest absolute value.
template <class T> CGAL_GC_FORCEINLINE int largest_coordinate(const std::array<T, 2>& x) {
  return std::abs(x[0]) < std::abs(x[1]) ? 1 : 0;
}
template <class T> CGAL_GC_FORCEINLINE int largest_coordinate(const std::array<T, 3>& x) {
  const int i = std::abs(x[0]) < std::abs(x[1]) ? 1 : 0;
  // equivalent [0 -> 1, 1]: no answer depends on which coordinate that is not zero is the pivot
  return (std::max)(std::abs(x[0]), std::abs(x[1])) < std::abs(x[2]) ? 2 : i;
}

// The pivot of a join: the largest coordinate of the tangent of its left end. Both ends are read
// with this coordinate as the first one.
template <int N, class Points> CGAL_GC_FORCEINLINE int pivot_of(const Points& left) {
  return largest_coordinate(first_differences<1>(points_of<1, N>(left))[0]);
}

// The numbers in another type.
template <class T, class S> CGAL_GC_FORCEINLINE std::array<T, 2> converted(const std::array<S, 2>& x) {
  return {static_cast<T>(x[0]), static_cast<T>(x[1])};
}
template <class T, class S> CGAL_GC_FORCEINLINE std::array<T, 3> converted(const std::array<S, 3>& x) {
  return {static_cast<T>(x[0]), static_cast<T>(x[1]), static_cast<T>(x[2])};
}
template <int k, class T, class S, std::size_t N>
CGAL_GC_FORCEINLINE Differences<T, N> converted(const std::array<std::array<S, N>, 3>& x) {
  if constexpr (k == 1)
    return {converted<T>(x[0])};
  else if constexpr (k == 2)
    return {converted<T>(x[0]), converted<T>(x[1])};
  else
    return {converted<T>(x[0]), converted<T>(x[1]), converted<T>(x[2])};
}

// Multiples of the inverse of `units` as whole numbers.
template <class T> CGAL_GC_FORCEINLINE std::array<T, 2> in_units(const std::array<double, 2>& x, double units) {
  return {T(static_cast<std::int64_t>(x[0] * units)), T(static_cast<std::int64_t>(x[1] * units))};
}
template <class T> CGAL_GC_FORCEINLINE std::array<T, 3> in_units(const std::array<double, 3>& x, double units) {
  return {T(static_cast<std::int64_t>(x[0] * units)), T(static_cast<std::int64_t>(x[1] * units)),
          T(static_cast<std::int64_t>(x[2] * units))};
}
template <int k, class T, std::size_t N>
CGAL_GC_FORCEINLINE Differences<T, N> in_units(const std::array<std::array<double, N>, 3>& x, double units) {
  if constexpr (k == 1)
    return {in_units<T>(x[0], units)};
  else if constexpr (k == 2)
    return {in_units<T>(x[0], units), in_units<T>(x[1], units)};
  else
    return {in_units<T>(x[0], units), in_units<T>(x[1], units), in_units<T>(x[2], units)};
}

// The largest absolute value of a coordinate.
template <int k, std::size_t N>
CGAL_GC_FORCEINLINE double largest_coordinate_of(const std::array<std::array<double, N>, 4>& x) {
  double size = (std::max)(largest(x[0]), largest(x[1]));
  if constexpr (k >= 2) size = (std::max)(size, largest(x[2]));
  if constexpr (k >= 3) size = (std::max)(size, largest(x[3]));
  return size;
}

// Bounds of the differences from the first differences; of the second one also if it is zero.
template <int k, std::size_t N>
CGAL_GC_FORCEINLINE Difference_bounds bounds_of_differences(const std::array<std::array<double, N>, 3>& differences) {
  const double first = largest(differences[0]), second = k >= 2 ? (std::max)(first, largest(differences[1])) : first,
               third = k >= 3 ? (std::max)(second, largest(differences[2])) : second;
  return {first, 2 * second, 4 * third};
}

// The differences b_i - b_0 from the end point inwards, in the direction of the curve, for k = 1,
// 2, 3.
template <int k, bool left, class T, std::size_t N>
CGAL_GC_FORCEINLINE Differences<T, N> chords_from_end(const std::array<std::array<T, N>, 4>& x) {
  Differences<T, N> d{};
  d[0] = left ? internal::minus(x[0], x[1]) : internal::minus(x[1], x[0]);
  if constexpr (k >= 2) d[1] = internal::minus(x[2], x[0]);
  if constexpr (k >= 3) d[2] = left ? internal::minus(x[0], x[3]) : internal::minus(x[3], x[0]);
  return d;
}

// Bounds of these.
template <int k, std::size_t N>
CGAL_GC_FORCEINLINE Difference_bounds bounds_of_chords(const std::array<std::array<double, N>, 3>& d) {
  const double first = largest(d[0]), second = k >= 2 ? (std::max)(first, largest(d[1])) : first;
  return {first, second, k >= 3 ? (std::max)(second, largest(d[2])) : second};
}

// The first differences of an end in units of 2^exponent, if its points lie on such a grid.
template <int N> struct Grid_differences {
  First_differences<std::int64_t, N> differences;
  int exponent;
  int zeros; // trailing bits that are zero in all first differences
  bool valid;
};

CGAL_GC_FORCEINLINE std::int64_t any_bits(const std::array<std::int64_t, 2>& x) { return x[0] | x[1]; }
CGAL_GC_FORCEINLINE std::int64_t any_bits(const std::array<std::int64_t, 3>& x) { return x[0] | x[1] | x[2]; }

// The number of trailing zeros of a number below 2^54, 53 for zero.
inline int trailing_zeros(std::int64_t x) {
  // the lowest bit, as a double
  return x == 0 ? 53 : binary_exponent(static_cast<double>(x & -x));
}

// The first differences without `shift` trailing zeros.
CGAL_GC_FORCEINLINE std::array<std::int64_t, 2> without_zeros(const std::array<std::int64_t, 2>& x, int shift) {
  return {x[0] >> shift, x[1] >> shift};
}
CGAL_GC_FORCEINLINE std::array<std::int64_t, 3> without_zeros(const std::array<std::int64_t, 3>& x, int shift) {
  return {x[0] >> shift, x[1] >> shift, x[2] >> shift};
}
template <int k, std::size_t N>
CGAL_GC_FORCEINLINE First_differences<std::int64_t, N>
without_zeros(const std::array<std::array<std::int64_t, N>, 3>& x, int shift) {
  if constexpr (k == 1)
    return {without_zeros(x[0], shift)};
  else if constexpr (k == 2)
    return {without_zeros(x[0], shift), without_zeros(x[1], shift)};
  else
    return {without_zeros(x[0], shift), without_zeros(x[1], shift), without_zeros(x[2], shift)};
}

template <int k, std::size_t N>
CGAL_GC_FORCEINLINE Grid_differences<N> grid_differences_of(const std::array<std::array<double, N>, 4>& points) {
  Grid grid(largest_coordinate_of<k>(points));
  if (!grid.valid()) return {{}, 0, 0, false};
  End_polygon<std::int64_t, N> x;
  x[0] = grid(points[0]);
  x[1] = grid(points[1]);
  if constexpr (k >= 2) x[2] = grid(points[2]);
  if constexpr (k >= 3) x[3] = grid(points[3]);
  const First_differences<std::int64_t, N> differences = first_differences<k>(x);
  std::int64_t bits = any_bits(differences[0]);
  if constexpr (k >= 2) bits |= any_bits(differences[1]);
  if constexpr (k >= 3) bits |= any_bits(differences[2]);
  return {differences, grid.exponent(), trailing_zeros(bits), grid.valid()};
}

#if defined(__GNUC__)

// The largest power of two of which all coordinates of two ends are multiples, if these have at
// most 52 bits and no difference is longer than 53: then each first difference and each difference,
// of at most `largest`, is a multiple of the unit, hence a double, and was computed without
// rounding.
template <int k, std::size_t N>
CGAL_GC_FORCEINLINE bool find_common_unit(const std::array<std::array<double, N>, 4>& p,
                                          const std::array<std::array<double, N>, 4>& q, double largest, int& unit) {
  const Common_grid<k, N> grid(p, q);
  unit = grid.exponent();
  return grid.valid() && largest <= 0x1p53 * power_of_two(unit);
}

#endif // __GNUC__

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_END_POLYGON_H
