// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_POWER_POLYNOMIAL_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_POWER_POLYNOMIAL_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Power_polynomial.h
/// Polynomials \f$ \sum_k a_k t^k \f$ over an exact field, and Euclid's algorithm: the greatest common divisor, and the
/// polynomial with the same roots, all of them simple.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <class FT> bool is_zero_coefficient(const FT& x) { return x == FT(0); }
template <class FT, int N> bool is_zero_coefficient(const Coordinate_vector<FT, N>& x) { return is_zero(x); }

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the coefficients \f$ a_k = \binom{n}{k} \Delta^k c_0 \f$ of the powers of `t`, up to the last that is not
/// zero but at least \f$ a_0 \f$, from the `n + 1` Bernstein coefficients \f$ c_i \f$ on [0, 1], which are numbers or
/// vectors. None from none. \f$ O(n^2) \f$
/// \tparam FT a field number type \tparam Row a `std::vector` of such numbers or of vectors over them
template <class FT, class Row> Row powers_from_bernstein(Row c) {
  const int n = static_cast<int>(c.size()) - 1;
  Row a;
  if (n < 0) return a;
  const std::vector<FT> binomials = binomial_coefficients<FT>(n);
  for (int k = 0; k <= n; ++k) {
    a.push_back(typename Row::value_type(binomials[k] * c[0]));
    difference_step(c, n - k);
  }
  while (a.size() > 1 && internal::is_zero_coefficient(a.back())) a.pop_back();
  return a;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// A polynomial \f$ \sum_{k=0}^n a_k t^k \f$ with \f$ a_n \ne 0 \f$; the zero polynomial has no coefficients and the
/// degree -1.
/// \tparam FT a field number type with exact operations
template <class FT_> class Power_polynomial {
public:
  typedef FT_ FT; ///< the number type

  /// Constructs zero.
  Power_polynomial() = default;

  /// Constructs a polynomial from \f$ a_0, a_1, \dots \f$; leading zeros are dropped.
  explicit Power_polynomial(std::vector<FT> coefficients) : a_(std::move(coefficients)) { drop_leading_zeros(); }

  /// Constructs the same function as a polynomial in Bernstein form. \f$ O(n^2) \f$
  explicit Power_polynomial(const Bernstein_polynomial<FT>& p)
      : Power_polynomial(powers_from_bernstein<FT>(p.coefficients())) {}

  /// Decides whether all coefficients are zero.
  bool is_zero() const { return a_.empty(); }
  /// Returns the degree, -1 for zero.
  int degree() const { return static_cast<int>(a_.size()) - 1; }
  /// Returns \f$ a_k \f$, `0 <= k <= degree()`.
  const FT& operator[](int k) const { return a_[k]; }

  /// Returns the derivative.
  Power_polynomial derivative() const {
    std::vector<FT> d;
    for (int k = 1; k <= degree(); ++k) d.push_back(FT(FT(k) * a_[k]));
    return Power_polynomial(std::move(d));
  }

  /// Divides by the leading coefficient; zero stays zero.
  void make_monic() {
    if (is_zero()) return;
    const FT leading = a_.back();
    for (FT& x : a_) x /= leading;
  }

  /// Divides by `d`, leaves the remainder here and returns the quotient. \f$ O((n-m+1) m) \f$ for degrees `n`, `m`
  /// \throws Error `wrong_number_of_points` when `d` is zero
  Power_polynomial divide(const Power_polynomial& d) {
    if (d.is_zero()) throw Error(Error_code::wrong_number_of_points, "Power_polynomial: division by zero");
    const int m = d.degree();
    std::vector<FT> q(degree() < m ? 0 : degree() - m + 1, FT(0));
    for (int k = static_cast<int>(q.size()) - 1; k >= 0; --k) {
      q[k] = a_[k + m] / d.a_.back();
      for (int i = 0; i <= m; ++i) a_[k + i] -= q[k] * d.a_[i];
    }
    drop_leading_zeros();
    return Power_polynomial(std::move(q));
  }

  /// Returns the same function in Bernstein form, \f$ c_i = \sum_k a_k \binom{i}{k} / \binom{n}{k} \f$, of the same
  /// degree; of degree 0 for zero. \f$ O(n^2) \f$
  Bernstein_polynomial<FT> bernstein() const {
    if (is_zero()) return Bernstein_polynomial<FT>{FT(0)};
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

  /// Decides whether all coefficients are equal.
  friend bool operator==(const Power_polynomial& p, const Power_polynomial& q) { return p.a_ == q.a_; }
  /// Decides whether a coefficient is different.
  friend bool operator!=(const Power_polynomial& p, const Power_polynomial& q) { return !(p == q); }

private:
  std::vector<FT> a_;

  void drop_leading_zeros() {
    while (!a_.empty() && a_.back() == FT(0)) a_.pop_back();
  }
};

namespace internal {

template <class FT> std::size_t most_words(const Power_polynomial<FT>& p) {
  std::size_t words = 1;
  for (int k = 0; k <= p.degree(); ++k) words = (std::max)(words, number_words(p[k]));
  return words;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the greatest common divisor, up to a factor that is not zero, by Euclid's algorithm; zero if both are.
/// \f$ O(nm) \f$ operations for degrees `n`, `m`, on numbers that grow in length up to the order of `n + m`
/// \throws Error `work_limit`
template <class FT> Power_polynomial<FT> greatest_common_divisor(Power_polynomial<FT> a, Power_polynomial<FT> b) {
  static_assert(!std::is_floating_point_v<FT>, "divisibility is decided in an exact field");
  const internal::Work_on_part work("greatest_common_divisor");
  while (!b.is_zero()) {
    const double quotients = (std::max)(a.degree() - b.degree() + 1, 1);
    const std::size_t words = (std::max)(internal::most_words(a), internal::most_words(b));
    internal::work_meter().charge_fractions(quotients * (b.degree() + 1), words);
    b.make_monic();
    a.divide(b);
    std::swap(a, b);
  }
  return a;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns `p` divided by the greatest common divisor of `p` and its derivative: it has the same roots, and all of them
/// are simple. It costs as much as `greatest_common_divisor()`.
/// \throws Error `wrong_number_of_points` when `p` is zero, `work_limit`
template <class FT> Bernstein_polynomial<FT> square_free_part(const Bernstein_polynomial<FT>& p) {
  const internal::Work_on_part work("square_free_part");
  Power_polynomial<FT> f(p);
  return f.divide(greatest_common_divisor(f, f.derivative())).bernstein();
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_POWER_POLYNOMIAL_H
