// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <CGAL/Fraction_traits.h>
#include <CGAL/ipower.h>

#include <cstdlib>

// Rational numbers of any type.

// 2^k, also for numbers without shifts
template <class FT> FT power_of_two(int k) {
  const FT power = CGAL::ipower(FT(2), std::abs(k));
  return k < 0 ? FT(FT(1) / power) : power;
}

// In lowest terms, with a positive denominator.
template <class FT> bool is_canonical(const FT& x) {
  typedef CGAL::Fraction_traits<FT> Fraction;
  typename Fraction::Numerator_type n;
  typename Fraction::Denominator_type d;
  typename Fraction::Decompose()(x, n, d);
  return d > 0 && typename Fraction::Common_factor()(n, d) == 1;
}
