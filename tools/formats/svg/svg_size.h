// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SIZE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SIZE_H

#include <CGAL/Fraction_traits.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/Exact_number.h>
#include <CGAL/Geometric_continuity/numbers/internal/Rational_parts.h>
#include <CGAL/Quotient.h>

#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {

/// The longest numerator or denominator, in bits, of a number or a coordinate in the path data, lengths and transforms
/// of SVG. Every finite `double` is shorter.
constexpr int max_svg_number_bits = 1280;

/// The longest numerator or denominator, in bits, of the ratio of the radii of an arc of SVG.
constexpr int max_svg_ratio_bits = 640;

/// The longest numerator or denominator, in bits, of the number `Svg_arc::radicand()` of an arc of SVG.
constexpr int max_svg_radicand_bits = 1536;

/// The longest numerator or denominator, in bits, in an exact product of transforms of SVG; see `Svg_transform`.
constexpr int max_svg_transform_bits = 1024;
namespace internal {

template <class Integer> Integer power_of_two(int exponent) {
  Integer power(1), square(2);
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) power = Integer(power * square);
    if (exponent > 1) square = Integer(square * square);
  }
  return power;
}

template <class FT> constexpr bool is_quotient = false;
template <class NT> constexpr bool is_quotient<CGAL::Quotient<NT>> = true;

// Whether the numerator and the denominator of a number have at most `bits` bits. Numbers that are no fractions, such
// as those in floating point, do not grow; the length of a `Quotient` says nothing, because it may never be cancelled.
template <int bits, class FT> bool is_svg_short(const FT& x) {
  typedef typename Exact_number<FT>::type Exact;
  typedef CGAL::Fraction_traits<Exact> Fraction;
  if constexpr (std::is_same_v<typename Fraction::Is_fraction, CGAL::Tag_true> && !is_quotient<Exact>) {
    typedef typename Fraction::Numerator_type Integer;
    static_assert(bits >= 60, "the numbers of Rational_parts are short");
    if constexpr (Rational_parts<Exact>::value) {
      std::int64_t n, d;
      if (Rational_parts<Exact>::short_parts(Exact_number<FT>::of(x), n, d)) return true;
    }
    static const Integer bound = power_of_two<Integer>(bits);
    Integer numerator;
    typename Fraction::Denominator_type denominator;
    typename Fraction::Decompose()(Exact_number<FT>::of(x), numerator, denominator);
    const Integer d(denominator);
    return numerator < bound && -bound < numerator && d < bound && -bound < d;
  } else
    return true;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_SIZE_H
