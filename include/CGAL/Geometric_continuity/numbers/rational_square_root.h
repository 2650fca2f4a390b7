// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_RATIONAL_SQUARE_ROOT_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_RATIONAL_SQUARE_ROOT_H

#include <CGAL/Fraction_traits.h>

#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The square root of an integer when it is an integer: Newton's iteration from above.
template <class Integer> std::optional<Integer> integer_square_root(const Integer& n) {
  Integer x(1);
  while (Integer(x * x) < n) x = Integer(x + x);
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
  const auto p = integer_square_root(numerator);
  const auto q = integer_square_root(denominator);
  if (!p || !q) return std::nullopt;
  return FT(FT(*p) / FT(*q));
}

// Numbers that are evaluated on demand are read in the type of their exact values.
template <class FT, class = void> struct Has_exact_value : std::false_type {};
template <class FT>
struct Has_exact_value<FT, std::void_t<decltype(std::declval<const FT&>().exact())>> : std::true_type {};

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// The square root of `x >= 0` when it is rational, otherwise empty; of a floating-point number the rounded root. The
/// fractions of the number type must be in lowest terms.
template <class FT> std::optional<FT> rational_square_root(const FT& x) {
  if (x == FT(0)) return FT(0);
  if constexpr (std::is_floating_point_v<FT>)
    return std::sqrt(x);
  else if constexpr (internal::Has_exact_value<FT>::value) {
    const auto root = internal::fraction_square_root(x.exact());
    if (!root) return std::nullopt;
    return FT(*root);
  } else
    return internal::fraction_square_root(x);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_RATIONAL_SQUARE_ROOT_H
