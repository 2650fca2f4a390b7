// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_SIGN_PATTERN_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_SIGN_PATTERN_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Homogeneous_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Power_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Sign_set.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// \file sign_pattern.h
/// The signs of a polynomial on an interval, decided exactly: by its coefficients if they suffice,
/// and otherwise by the roots of its square-free part, which are separated by Descartes' rule and bisection.

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

// How often the coefficients change the sign, of a polynomial in Bernstein or in homogeneous form.
template <class Polynomial> int sign_variations(const Polynomial& p) {
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

// The signs of a polynomial on [0, 1] if those of its coefficients decide: the basis functions are positive inside, so that
// without coefficients of both signs only the ends can be zero.
inline std::optional<Sign_pattern> decided_by_coefficients(Sign_pattern coefficients, bool zero_at_an_end) {
  switch (coefficients) {
  case Sign_pattern::mixed: return std::nullopt;
  case Sign_pattern::nonnegative: return zero_at_an_end ? coefficients : Sign_pattern::positive;
  case Sign_pattern::nonpositive: return zero_at_an_end ? coefficients : Sign_pattern::negative;
  default: return coefficients;
  }
}

// The work of halves(): about n^2 sums of numbers that are by n digits longer than the coefficients.
template <class NT> double bisection_steps(const Homogeneous_polynomial<NT>& p) {
  const double n = p.degree() + 1;
  return n * n * Work_meter::sum_steps((std::max)(number_words(p[0]), number_words(p[p.degree() / 2])));
}
template <class NT> void charge_bisection(const Homogeneous_polynomial<NT>& p) {
  work_meter().charge_sums(bisection_steps(p) / Work_meter::sum_steps(1), 1);
}

// Positive, negative or zero if bisection proves that, otherwise mixed.
template <class NT> Sign_pattern strict_sign(const Homogeneous_polynomial<NT>& p, int bisections) {
  const Sign_pattern s = p.coefficient_signs();
  if (s == Sign_pattern::positive || s == Sign_pattern::negative || s == Sign_pattern::zero) return s;
  if (bisections == 0 || sign_of(p[0]) * sign_of(p[p.degree()]) != 1) return Sign_pattern::mixed;
  charge_bisection(p);
  const std::pair<Homogeneous_polynomial<NT>, Homogeneous_polynomial<NT>> halves = p.halves();
  const Sign_pattern left = strict_sign(halves.first, bisections - 1);
  if (left == Sign_pattern::mixed) return left;
  return strict_sign(halves.second, bisections - 1) == left ? left : Sign_pattern::mixed;
}

// Adds the signs of p on the open interval (0, 1), where p is not zero at 0 and 1 and s is its square-free part.
// Bisection ends because the roots of s are simple.
template <class NT, class Ring>
void add_signs(const Homogeneous_polynomial<NT>& p, const Homogeneous_polynomial<Ring>& s, Sign_set& signs) {
  typedef Homogeneous_polynomial<NT> Polynomial;
  typedef Homogeneous_polynomial<Ring> Square_free;
  std::vector<std::pair<Polynomial, Square_free>> parts{{p, s}}; // p has one sign at all their ends
  const auto split = [&](const Polynomial& x, const Square_free& y) {
    const Without_end_roots<NT> inside(x);
    if (inside.root_at_0 || inside.root_at_1) signs.add(0);
    signs.add(sign_of(inside.rest[0]));
    signs.add(sign_of(inside.rest[inside.rest.degree()]));
    parts.push_back({inside.rest, Without_end_roots<Ring>(y).rest});
  };
  while (!parts.empty() && !signs.is_mixed()) {
    const std::pair<Polynomial, Square_free> part = std::move(parts.back());
    parts.pop_back();
    const int variations = sign_variations(part.second);
    if (variations == 1) signs.add(0); // one root
    if (variations <= 1) continue;
    charge_bisection(part.first);
    charge_bisection(part.second);
    const std::pair<Polynomial, Polynomial> x = part.first.halves();
    const std::pair<Square_free, Square_free> y = part.second.halves();
    split(x.first, y.first);
    split(x.second, y.second);
  }
}

// The signs of p on [0, 1], where Exact is a field without numbers that are evaluated on demand.
template <class Exact, class NT> Sign_pattern exact_sign_pattern(const Homogeneous_polynomial<NT>& p) {
  const bool zero_at_an_end = p[0] == NT(0) || p[p.degree()] == NT(0);
  if (const auto decided = decided_by_coefficients(p.coefficient_signs(), zero_at_an_end)) return *decided;
  const Without_end_roots<NT> inside(p);
  Sign_set signs;
  if (inside.root_at_0 || inside.root_at_1) signs.add(0);
  signs.add(sign_of(inside.rest[0]));
  signs.add(sign_of(inside.rest[inside.rest.degree()]));
  if (!signs.is_mixed())
    add_signs(inside.rest, whole_multiple(square_free_part(inside.rest.template bernstein<Exact>())), signs);
  return signs.pattern();
}

// The coefficients of a polynomial as exact numbers. \throws Error `not_finite`
template <class FT> auto exact_polynomial(const Bernstein_polynomial<FT>& p) {
  typedef typename Exact_field<FT>::type Field;
  typedef typename Exact_number<Field>::type Exact;
  std::vector<Exact> c;
  for (const FT& x : p.coefficients()) c.push_back(Exact_number<Field>::of(to_field<Field>(x)));
  return Bernstein_polynomial<Exact>(std::move(c));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Decides the signs of `p` on the closed interval [0, 1], exactly: floating-point coefficients are taken as the
/// rational numbers they are.
///
/// Coefficients of one sign decide in \f$ O(n) \f$. Otherwise the square-free part is computed, and \f$ O(n^2) \f$
/// additions are done for each bisection that separates its roots; there are about as many bisections as the distance
/// of the closest roots, complex ones included, has binary digits.
/// \throws Error `not_finite` when a coefficient is infinite or not a number, `work_limit`
template <class FT> Sign_pattern sign_pattern(const Bernstein_polynomial<FT>& p) {
  const auto exact = internal::exact_polynomial(p);
  typedef typename std::decay_t<decltype(exact)>::FT Exact;
  Sign_set signs;
  for (const Exact& x : exact.coefficients()) signs.add(internal::sign_of(x));
  const bool zero_at_an_end = exact[0] == Exact(0) || exact[exact.degree()] == Exact(0);
  if (const auto decided = internal::decided_by_coefficients(signs.pattern(), zero_at_an_end)) return *decided;
  const internal::Work_on_part work("sign_pattern");
  return internal::exact_sign_pattern<Exact>(internal::whole_multiple(exact));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Decides the signs of `p` on the closed interval [a, b], `a < b`, exactly, at the cost of `sign_pattern(p)` after
/// \f$ O(n^2) \f$ operations that restrict `p`.
/// \throws Error `empty_domain` unless `a < b`
/// \throws Error `not_finite` when a coefficient or an end of the interval is infinite or not a number, `work_limit`
template <class FT> Sign_pattern sign_pattern(const Bernstein_polynomial<FT>& p, const FT& a, const FT& b) {
  typedef typename Exact_field<FT>::type Field;
  if (!(a < b)) throw Error(Error_code::empty_domain, "sign_pattern: interval");
  std::vector<Field> c;
  for (const FT& x : p.coefficients()) c.push_back(internal::to_field<Field>(x));
  return sign_pattern(
      Bernstein_polynomial<Field>(std::move(c)).restricted(internal::to_field<Field>(a), internal::to_field<Field>(b)));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Decides the signs of `p` on the closed interval [0, 1], exactly: by up to four bisections, and if those do not
/// decide, by the square-free part and as many as are needed, see `sign_pattern(const Bernstein_polynomial<FT>&)`.
/// \tparam Exact a field with exact operations to which `NT` can be converted
/// \tparam NT a ring number type with exact operations
/// \throws Error `work_limit`
template <class Exact, class NT> Sign_pattern sign_pattern(const Homogeneous_polynomial<NT>& p) {
  const internal::Work_on_part work("sign_pattern");
  constexpr int bisections = 4;
  const Sign_pattern s = internal::strict_sign(p, bisections);
  return s == Sign_pattern::mixed ? internal::exact_sign_pattern<Exact>(p) : s;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_SIGN_PATTERN_H
