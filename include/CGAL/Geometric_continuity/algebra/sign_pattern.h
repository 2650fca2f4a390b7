// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_SIGN_PATTERN_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_SIGN_PATTERN_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_conversion.h>
#include <CGAL/Geometric_continuity/numbers/internal/sign_of.h>

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// The signs that a function takes on a closed interval: only +; only -; + and 0; - and 0; both + and -;
/// only 0.
enum class Sign_pattern { positive, negative, nonnegative, nonpositive, mixed, zero };

/// \ingroup PkgGeometricContinuityAlgebra
inline std::string to_string(Sign_pattern pattern) {
  switch (pattern) {
  case Sign_pattern::positive: return "positive";
  case Sign_pattern::negative: return "negative";
  case Sign_pattern::nonnegative: return "nonnegative";
  case Sign_pattern::nonpositive: return "nonpositive";
  case Sign_pattern::mixed: return "mixed";
  case Sign_pattern::zero: return "zero";
  }
  return "unknown";
}

inline std::ostream& operator<<(std::ostream& os, Sign_pattern pattern) { return os << to_string(pattern); }

namespace internal {

// Polynomials in power form, highest coefficient last and not zero; the zero polynomial is empty.
template <class FT> class Power_polynomial {
  std::vector<FT> a_;

  void trim() {
    while (!a_.empty() && a_.back() == FT(0)) a_.pop_back();
  }

public:
  // a_k = C(n,k) (k-th difference of the Bernstein coefficients)
  explicit Power_polynomial(const Bernstein_polynomial<FT>& p) {
    std::vector<FT> c = p.coefficients();
    const std::vector<FT> binomials = binomial_coefficients<FT>(p.degree());
    for (int k = 0; k <= p.degree(); ++k) {
      a_.push_back(FT(binomials[k] * c[0]));
      difference_step(c, p.degree() - k);
    }
    trim();
  }

  bool is_zero() const { return a_.empty(); }
  int degree() const { return static_cast<int>(a_.size()) - 1; }

  Power_polynomial derivative() const {
    Power_polynomial d(*this);
    for (int k = 1; k <= degree(); ++k) d.a_[k - 1] = FT(k) * a_[k];
    d.a_.pop_back();
    return d;
  }

  void make_monic() {
    const FT leading = a_.back();
    for (FT& x : a_) x /= leading;
  }

  // divides by d, leaves the remainder here and returns the quotient
  Power_polynomial divide(const Power_polynomial& d) {
    Power_polynomial q(*this);
    q.a_.assign(degree() < d.degree() ? 0 : degree() - d.degree() + 1, FT(0));
    for (int k = static_cast<int>(q.a_.size()) - 1; k >= 0; --k) {
      q.a_[k] = a_[k + d.degree()] / d.a_.back();
      for (int i = 0; i <= d.degree(); ++i) a_[k + i] -= q.a_[k] * d.a_[i];
    }
    trim();
    return q;
  }

  Bernstein_polynomial<FT> bernstein() const { // c_i = sum_k C(i,k)/C(n,k) a_k
    const int n = degree();
    const std::vector<FT> bn = binomial_coefficients<FT>(n);
    std::vector<FT> c;
    for (int i = 0; i <= n; ++i) {
      const std::vector<FT> bi = binomial_coefficients<FT>(i);
      FT sum(0);
      for (int k = 0; k <= i; ++k) sum += bi[k] / bn[k] * a_[k];
      c.push_back(sum);
    }
    return Bernstein_polynomial<FT>(std::move(c));
  }
};

// By Euclid's algorithm; zero if both are.
template <class FT> Power_polynomial<FT> greatest_common_divisor(Power_polynomial<FT> a, Power_polynomial<FT> b) {
  while (!b.is_zero()) {
    b.make_monic();
    a.divide(b);
    std::swap(a, b);
  }
  return a;
}

// p divided by the greatest common divisor of p and p': the same roots, all simple. \pre p is not zero
template <class FT> Bernstein_polynomial<FT> square_free_part(const Bernstein_polynomial<FT>& p) {
  Power_polynomial<FT> f(p);
  return f.divide(greatest_common_divisor(f, f.derivative())).bernstein();
}

template <class FT> int sign_variations(const Bernstein_polynomial<FT>& p) {
  int variations = 0, last = 0;
  for (const FT& x : p.coefficients()) {
    const int s = sign_of(x);
    if (s != 0 && last != 0 && s != last) ++variations;
    if (s != 0) last = s;
  }
  return variations;
}

struct Signs {
  bool negative = false, zero = false, positive = false;
  void add(int sign) { (sign < 0 ? negative : sign > 0 ? positive : zero) = true; }
  bool mixed() const { return negative && positive; }
};

// The signs of p on the open interval (0,1), where p is not zero at 0 and 1 and s is its square-free
// part. Descartes' rule in Bernstein form counts the roots of s; bisection ends because they are simple.
template <class FT> void add_signs(const Bernstein_polynomial<FT>& p, const Bernstein_polynomial<FT>& s, Signs& signs) {
  signs.add(sign_of(p[0]));
  signs.add(sign_of(p[p.degree()]));
  if (signs.mixed()) {
    signs.zero = true;
    return;
  }
  const int variations = sign_variations(s);
  if (variations == 0) return;
  if (variations == 1) { // one root, and p has the same sign on both sides
    signs.zero = true;
    return;
  }
  FT t = FT(1) / FT(2);
  while (p(t) == FT(0)) t /= FT(2);
  const std::pair<Bernstein_polynomial<FT>, Bernstein_polynomial<FT>> ps = p.split(t), ss = s.split(t);
  add_signs(ps.first, ss.first, signs);
  if (!signs.mixed()) add_signs(ps.second, ss.second, signs);
}

// Removes the factors t and 1-t of p, which are positive inside, and records the zeros.
template <class FT> Bernstein_polynomial<FT> without_end_roots(const Bernstein_polynomial<FT>& p, Signs& signs) {
  std::vector<FT> c = p.coefficients();
  int n = p.degree();
  while (c.front() == FT(0)) { // c_i B_i^n / t = c_i n/i B_{i-1}^{n-1}
    for (int i = 1; i <= n; ++i) c[i - 1] = c[i] * FT(n) / FT(i);
    c.resize(n--);
    signs.zero = true;
  }
  while (c.back() == FT(0)) {
    for (int i = 0; i < n; ++i) c[i] = c[i] * FT(n) / FT(n - i);
    c.resize(n--);
    signs.zero = true;
  }
  return Bernstein_polynomial<FT>(std::move(c));
}

template <class FT> Sign_pattern exact_sign_pattern(const Bernstein_polynomial<FT>& p) {
  Signs signs;
  for (const FT& x : p.coefficients()) signs.add(sign_of(x));
  if (!signs.positive && !signs.negative) return Sign_pattern::zero;
  if (!signs.mixed()) // the basis functions are positive inside: only the ends can be zero
    signs.zero = p[0] == FT(0) || p[p.degree()] == FT(0);
  else {
    signs = Signs();
    const Bernstein_polynomial<FT> q = without_end_roots(p, signs);
    add_signs(q, square_free_part(q), signs);
  }
  if (signs.mixed()) return Sign_pattern::mixed;
  if (signs.positive) return signs.zero ? Sign_pattern::nonnegative : Sign_pattern::positive;
  return signs.zero ? Sign_pattern::nonpositive : Sign_pattern::negative;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// The signs of `p` on the closed interval [0, 1], decided exactly: floating-point coefficients are
/// taken as the rational numbers they are. Coefficients of one sign decide at once; otherwise the
/// roots of the square-free part are separated by Descartes' rule and bisection.
/// \throws Error `not_finite` when a coefficient is infinite or not a number
template <class FT> Sign_pattern sign_pattern(const Bernstein_polynomial<FT>& p) {
  typedef typename Exact_field<FT>::type Field;
  std::vector<Field> c;
  for (const FT& x : p.coefficients()) c.push_back(internal::to_field<Field>(x));
  return internal::exact_sign_pattern(Bernstein_polynomial<Field>(std::move(c)));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// The signs of `p` on the closed interval [a, b], decided exactly. \pre `a < b`
/// \throws Error `empty_domain` unless `a < b`
template <class FT> Sign_pattern sign_pattern(const Bernstein_polynomial<FT>& p, const FT& a, const FT& b) {
  typedef typename Exact_field<FT>::type Field;
  if (!(a < b)) throw Error(Error_code::empty_domain, "sign_pattern: interval");
  std::vector<Field> c;
  for (const FT& x : p.coefficients()) c.push_back(internal::to_field<Field>(x));
  return internal::exact_sign_pattern(
      Bernstein_polynomial<Field>(std::move(c)).restricted(internal::to_field<Field>(a), internal::to_field<Field>(b)));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_SIGN_PATTERN_H
