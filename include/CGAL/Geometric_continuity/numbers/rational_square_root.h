// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_RATIONAL_SQUARE_ROOT_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_RATIONAL_SQUARE_ROOT_H

#include <CGAL/Fraction_traits.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <cmath>
#include <optional>
#include <type_traits>
#include <vector>

/// \file rational_square_root.h
/// Square roots that are rational numbers, found exactly.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A power of two that is at least the square root of n, and less than twice as large: the largest one whose square is
// less than n, doubled. Its exponent is found bit by bit, with as many products as it has bits.
template <class Integer> Integer power_of_two_above_root(const Integer& n) {
  std::vector<Integer> powers(1, Integer(2)); // 2, 4, 16, 256, ...
  while (Integer(powers.back() * powers.back()) < n) powers.push_back(Integer(powers.back() * powers.back()));
  Integer x(1);
  for (; !powers.empty(); powers.pop_back()) {
    const Integer y = Integer(x * powers.back());
    if (Integer(y * y) < n) x = y;
  }
  return Integer(x + x);
}

// The square root of an integer n >= 0 when it is an integer: Newton's iteration from above.
template <class Integer> std::optional<Integer> integer_square_root(const Integer& n) {
  Integer x = power_of_two_above_root(n);
  for (;;) {
    const Integer y = Integer(Integer(x + Integer(n / x)) / Integer(2));
    if (!(y < x)) break;
    x = y;
  }
  if (Integer(x * x) != n) return std::nullopt;
  return x;
}

template <class FT> std::optional<FT> fraction_square_root(const FT& x) {
  typedef CGAL::Fraction_traits<FT> Fraction;
  typename Fraction::Numerator_type numerator;
  typename Fraction::Denominator_type denominator;
  typename Fraction::Decompose()(x, numerator, denominator);
  // of p/q it is sqrt(p q)/|q|, also of a fraction that is not in lowest terms
  typedef typename Fraction::Numerator_type Integer;
  const std::optional<Integer> root = integer_square_root(Integer(numerator * denominator));
  if (!root) return std::nullopt;
  const FT r(FT(*root) / FT(denominator));
  return r < FT(0) ? FT(-r) : r;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the square root of `x` when it is rational, and nothing otherwise, for instance for a negative `x`. The root
/// of a floating-point number is rounded.
/// \tparam FT a floating-point type, or a fraction by `CGAL::Fraction_traits`, also one that is evaluated on demand
/// \throws Error `not_finite` for an infinite or undefined floating-point number
template <class FT> std::optional<FT> rational_square_root(const FT& x) {
  internal::check_finite(x, "rational_square_root");
  if (x < FT(0)) return std::nullopt;
  if (x == FT(0)) return FT(0);
  if constexpr (std::is_floating_point_v<FT>)
    return std::sqrt(x);
  else {
    const auto root = internal::fraction_square_root(internal::Exact_number<FT>::of(x));
    if (!root) return std::nullopt;
    return FT(*root);
  }
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_RATIONAL_SQUARE_ROOT_H
