// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_ROOT_COUNT_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_ROOT_COUNT_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Homogeneous_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Power_polynomial.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/numbers/internal/sign_of.h>

#include <utility>
#include <vector>

/// \file root_count.h
/// What the signs and the roots of a polynomial are found with: Descartes' rule in Bernstein form. A
/// polynomial has at most as many roots in (0, 1) as its coefficients change the sign, and exactly one if they do so
/// once. Bisection is done in whole numbers, which are added, where rational numbers would be cancelled.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A positive multiple of a polynomial over a field, in whole numbers where the field has a common denominator.
template <class Exact> using Whole_polynomial = Homogeneous_polynomial<typename Common_denominator<Exact>::Ring>;
template <class Exact> Whole_polynomial<Exact> whole_multiple(const Bernstein_polynomial<Exact>& p) {
  Common_denominator<Exact> denominator;
  for (const Exact& x : p.coefficients()) denominator.include(x);
  std::vector<typename Common_denominator<Exact>::Ring> c;
  for (const Exact& x : p.coefficients()) c.push_back(denominator.numerator(x));
  return Whole_polynomial<Exact>::from_bernstein(std::move(c));
}

// How often the coefficients change the sign.
template <class NT> int sign_variations(const Homogeneous_polynomial<NT>& p) {
  int variations = 0, last = 0;
  for (int k = 0; k <= p.degree(); ++k) {
    const int s = sign_of(p[k]);
    if (s != 0 && last != 0 && s != last) ++variations;
    if (s != 0) last = s;
  }
  return variations;
}

// A polynomial without the roots that it has at 0 and at 1. \pre p is not zero
template <class NT> struct Without_end_roots {
  bool root_at_0, root_at_1;
  Homogeneous_polynomial<NT> rest; // of the same sign as p inside

  explicit Without_end_roots(const Homogeneous_polynomial<NT>& p) {
    const int k = p.order_at_0(), l = p.order_at_1();
    root_at_0 = k > 0;
    root_at_1 = l > 0;
    rest = k + l > 0 ? p.without_end_factors(k, l) : p;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_ROOT_COUNT_H
