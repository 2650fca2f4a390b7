// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_SCALED_VECTOR_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_SCALED_VECTOR_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Products of several derivatives leave the range of floating-point numbers long before the
// derivatives do: the torsion is a quotient of products of six. So each derivative is divided by a
// power of two first, and the result is multiplied by one. Powers of two are exact: as long as
// nothing overflows or underflows, the result is the same bit by bit.

// The largest e with 2^e <= |x| for the largest coordinate x; 0 for the zero vector.
template <class FT, int N> int exponent_of(const Coordinate_vector<FT, N>& v, const char* place) {
  FT largest(0);
  for (const FT& x : v) {
    const FT size = std::abs(x);
    // also an undefined number
    if (!(size <= (std::numeric_limits<FT>::max)())) refuse_infinite(place);
    if (largest < size) largest = size;
  }
  return largest == FT(0) ? 0 : std::ilogb(largest);
}

// A vector of floating-point numbers, divided by the power of two that makes its largest coordinate
// lie in [1, 2). A vector of other numbers is itself, and must live on. `place` is the message of
// the error for coordinates that are not finite.
template <class FT, int N> class Scaled_vector {
  typedef Coordinate_vector<FT, N> Vector;
  std::conditional_t<std::is_floating_point_v<FT>, Vector, const Vector&> v_;
  int exponent_ = 0;

public:
  Scaled_vector(const Vector& v, const char* place) : v_(v) {
    if constexpr (std::is_floating_point_v<FT>) {
      exponent_ = exponent_of(v, place);
      for (int i = 0; i < v_.dimension(); ++i) v_[i] = std::ldexp(v_[i], -exponent_);
    }
  }

  const Vector& operator*() const { return v_; }
  int exponent() const { return exponent_; }
};

// 2^e x. For numbers that are not scaled, e is 0. \throws Error `not_finite` when the number
// overflows
template <class FT> FT times_power_of_two(const FT& x, int e, const char* place) {
  if constexpr (std::is_floating_point_v<FT>) {
    const FT r = std::ldexp(x, e);
    check_finite(r, place);
    return r;
  } else
    return x;
}
template <class FT, int N>
Coordinate_vector<FT, N> times_power_of_two(Coordinate_vector<FT, N> v, int e, const char* place) {
  if constexpr (std::is_floating_point_v<FT>)
    for (int i = 0; i < v.dimension(); ++i) v[i] = times_power_of_two(v[i], e, place);
  return v;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_SCALED_VECTOR_H
