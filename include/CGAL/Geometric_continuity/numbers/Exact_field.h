// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_EXACT_FIELD_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_EXACT_FIELD_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/numbers/internal/Exact_number.h>
#include <CGAL/Geometric_continuity/numbers/internal/Rational_parts.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/Quotient.h>
#include <CGAL/ipower.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

/// \file Exact_field.h
/// The numbers in which the package decides, and questions about rational numbers: the lengths of
/// their parts, rational square roots, and the angles with rational sines, which are the quarter
/// turns.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityTraits
/// The field in which numbers of type `FT` are decided exactly: `Exact_rational` for floating-point
/// numbers, every other field itself. Without GMP and LEDA, and with Boost up to 1.78, it is
/// `boost::multiprecision::cpp_rational` for floating-point numbers.
template <class FT> struct Exact_field {
  /// The exact field.
  typedef typename internal::Exact_field_of<FT>::type type;
};

namespace internal {

template <class FT> constexpr bool is_quotient = false;
template <class NT> constexpr bool is_quotient<CGAL::Quotient<NT>> = true;

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns whether the numerator and the denominator of a number have at most `bits` bits. Numbers
/// that are no fractions, such as those in floating point, do not grow, so the answer is always
/// true. So it is for numbers of `CGAL::Quotient`, which may never be cancelled.
template <int bits, class FT> bool has_short_parts(const FT& x) {
  typedef typename internal::Exact_number<FT>::type Exact;
  typedef CGAL::Fraction_traits<Exact> Fraction;
  if constexpr (std::is_same_v<typename Fraction::Is_fraction, CGAL::Tag_true> && !internal::is_quotient<Exact>) {
    typedef typename Fraction::Numerator_type Integer;
    static_assert(bits >= 60, "the numbers of Rational_parts are short");
    if constexpr (internal::Rational_parts<Exact>::value) {
      std::int64_t n, d;
      if (internal::Rational_parts<Exact>::short_parts(internal::Exact_number<FT>::of(x), n, d)) return true;
    }
    static const Integer bound = CGAL::ipower(Integer(2), bits);
    Integer numerator;
    typename Fraction::Denominator_type denominator;
    typename Fraction::Decompose()(internal::Exact_number<FT>::of(x), numerator, denominator);
    const Integer d(denominator);
    return numerator < bound && -bound < numerator && d < bound;
  } else
    return true;
}

namespace internal {

// A power of two that is at least the square root of n, and less than twice as large: the largest
// one whose square is less than n, doubled. Its exponent is found bit by bit, with as many products
// as it has bits.
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

// The square root of an integer n > 0, rounded down: Newton's iteration from above.
template <class Integer> Integer integer_square_root_below(const Integer& n) {
  Integer x = power_of_two_above_root(n);
  for (;;) {
    const Integer y = Integer(Integer(x + Integer(n / x)) / Integer(2));
    if (!(y < x)) return x;
    x = y;
  }
}

// The square root of an integer n > 0 when it is an integer.
template <class Integer> std::optional<Integer> integer_square_root(const Integer& n) {
  const Integer x = integer_square_root_below(n);
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

// Returns whether rational_square_root() takes numbers of this type and does not round.
template <class FT> constexpr bool has_rational_roots() {
  typedef typename Exact_number<FT>::type Exact;
  return std::is_same_v<typename CGAL::Fraction_traits<Exact>::Is_fraction, CGAL::Tag_true> && !is_quotient<Exact>;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the square root of `x` when it is rational, and nothing otherwise, for instance for a
/// negative `x`. The root of a floating-point number is rounded.
/// \tparam FT a floating-point type, or a fraction by `CGAL::Fraction_traits`, also one that is
///   evaluated on demand
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

/// \ingroup PkgGeometricContinuityAlgebra
/// An angle in degrees as a number of quarter turns, whose sines and cosines are rational, and the
/// rest.
template <class FT> struct Quarter_turns {
  int count; ///< the quarter turns, from 0 to 3: full turns are left out
  FT rest;   ///< the exact rest in degrees, from -45 to 45 up to rounding

  /// The largest angle that is taken, in degrees.
  static constexpr int max_degrees = 1000000000;

  /// Returns whether an angle of so many degrees is not too large.
  static bool is_allowed(const FT& degrees) { return !(FT(max_degrees) < degrees) && !(degrees < FT(-max_degrees)); }

  /// Splits an angle in degrees.
  /// \throws Error `parameter_outside_domain` unless `is_allowed(degrees)`
  explicit Quarter_turns(const FT& degrees) {
    if (!is_allowed(degrees)) throw Error(Error_code::parameter_outside_domain, "angle beyond 10^9 degrees");
    const int turns = static_cast<int>(std::lround(CGAL::to_double(degrees) / 90));
    rest = FT(degrees - FT(90) * FT(turns));
    count = (turns % 4 + 4) % 4;
  }
};

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns \f$ x + y \f$. Rational numbers whose numerators and denominators are below
/// \f$ 2^{30} \f$, like the numbers of most drawings, are added as integers of the machine.
template <class FT> FT short_sum(const FT& x, const FT& y) {
  typedef internal::Rational_parts<FT> Parts;
  if constexpr (Parts::value) {
    constexpr std::int64_t few = std::int64_t(1) << 30;
    const auto is_short = [](std::int64_t n, std::int64_t d) { return -few < n && n < few && d < few; };
    std::int64_t m, c, n, d;
    if (Parts::short_parts(x, m, c) && Parts::short_parts(y, n, d) && is_short(m, c) && is_short(n, d))
      return c == d ? Parts::make_short(m + n, c) : Parts::make_short(m * d + n * c, c * d);
  }
  return FT(x + y);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_EXACT_FIELD_H
