// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_ROUNDING_BOUND_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_ROUNDING_BOUND_H

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A bound of the absolute value of a number and one of the error of its floating-point
// approximation. The operations are those of floating-point arithmetic with relative error u =
// 2^-52 each, in every rounding mode, with or without fused multiplication and addition, provided
// that nothing overflows or underflows.
struct Rounding_bound {
  double value = 0, error = 0;

  constexpr Rounding_bound() = default;
  // unreachable: computed by the compiler a factor that is a whole number, in units of itself
  constexpr explicit Rounding_bound(int) : value(1) {}
  constexpr Rounding_bound(double v, double e) : value(v), error(e) {}

  // unreachable: computed by the compiler
  // equivalent [* -> +, 1]: computed by the compiler; the bounds are compared with those that
  //   Gappa proves
  static constexpr Rounding_bound rounded(double v, double e) { return {v, e + 0x1p-52 * (v + e)}; }
  friend constexpr Rounding_bound operator+(const Rounding_bound& x, const Rounding_bound& y) {
    return rounded(x.value + y.value, x.error + y.error);
  }
  friend constexpr Rounding_bound operator-(const Rounding_bound& x, const Rounding_bound& y) { return x + y; }
  friend constexpr Rounding_bound operator*(const Rounding_bound& x, const Rounding_bound& y) {
    return rounded(x.value * y.value, x.value * y.error + x.error * y.value + x.error * y.error);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_ROUNDING_BOUND_H
