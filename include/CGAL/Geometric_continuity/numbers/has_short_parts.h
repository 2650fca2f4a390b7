// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_HAS_SHORT_PARTS_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_HAS_SHORT_PARTS_H

#include <CGAL/Fraction_traits.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/Exact_number.h>
#include <CGAL/Geometric_continuity/numbers/internal/Rational_parts.h>
#include <CGAL/Quotient.h>
#include <CGAL/ipower.h>

#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <class FT> constexpr bool is_quotient = false;
template <class NT> constexpr bool is_quotient<CGAL::Quotient<NT>> = true;

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns whether the numerator and the denominator of a number have at most `bits` bits. Numbers that are no fractions, such as those
/// in floating point, do not grow: they always have. So have those of `CGAL::Quotient`, which may never be cancelled.
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
    return numerator < bound && -bound < numerator && d < bound && -bound < d;
  } else
    return true;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_HAS_SHORT_PARTS_H
