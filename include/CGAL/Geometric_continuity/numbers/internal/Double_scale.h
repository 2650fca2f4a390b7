// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_DOUBLE_SCALE_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_DOUBLE_SCALE_H

#include <CGAL/config.h>

#ifdef CGAL_USE_GMP
#include <CGAL/Geometric_continuity/numbers/internal/Binary_parts.h>
#include <CGAL/Geometric_continuity/numbers/internal/Inline_integer.h>

#include <algorithm>
#include <limits>
#else
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#endif

/// \file Double_scale.h
/// Floating-point numbers in a common unit, in which homogeneous expressions of them are computed
/// without fractions. All numbers are included first; then each has a numerator.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

#ifdef CGAL_USE_GMP

// Floating-point numbers of any size as whole numbers, in units of the largest power of two of
// which all that have been included are multiples.
class Binary_scale {
  int exponent_ = (std::numeric_limits<int>::max)();

public:
  typedef Inline_integer Ring;
  typedef Binary_parts Number;
  template <class FT> static Number number(const FT& x) { return Number(x); }

  void include(const Number& x) { exponent_ = (std::min)(exponent_, x.exponent); }
  // x in units. \pre x has been included
  Ring numerator(const Number& x) const {
    Ring y;
    y.assign(&x.odd_part, 1, x.negative);
    y <<= x.exponent - exponent_;
    return y;
  }
};

typedef Binary_scale Double_scale;
#else
typedef Field_scale<Exact_field_of<double>::type> Double_scale;
#endif // CGAL_USE_GMP

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_DOUBLE_SCALE_H
