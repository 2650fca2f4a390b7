// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BERNSTEIN_POLYNOMIAL_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BERNSTEIN_POLYNOMIAL_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/bernstein.h>

#include <algorithm>
#include <initializer_list>
#include <ostream>
#include <utility>
#include <vector>

/// \file Bernstein_polynomial.h
/// Polynomials on [0, 1] in Bernstein form: their coefficients are control points, and
/// their signs tell much about the signs of the polynomial. Farin, "Curves and Surfaces for CAGD", chapter 6.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// A polynomial \f$ \sum_i c_i B_i^n(t) \f$ in Bernstein form on [0, 1]. The degree is that of the
/// representation: the number of coefficients minus one.
/// \tparam FT a field number type
template <class FT_> class Bernstein_polynomial {
public:
  typedef FT_ FT; ///< the number type

  /// Constructs a polynomial from `n + 1 >= 1` coefficients. \throws Error `wrong_number_of_points` without
  /// coefficients
  explicit Bernstein_polynomial(std::vector<FT> coefficients) : c_(std::move(coefficients)) { check(); }
  /// Constructs a polynomial from `n + 1 >= 1` coefficients. \throws Error `wrong_number_of_points` without
  /// coefficients
  Bernstein_polynomial(std::initializer_list<FT> coefficients) : c_(coefficients) { check(); }
  /// Constructs a polynomial from a range of `n + 1 >= 1` coefficients.
  /// \throws Error `wrong_number_of_points` without coefficients
  template <class InputIterator> Bernstein_polynomial(InputIterator first, InputIterator last) : c_(first, last) {
    check();
  }

  /// Returns the degree `n`.
  int degree() const { return static_cast<int>(c_.size()) - 1; }
  /// Returns all coefficients.
  const std::vector<FT>& coefficients() const { return c_; }
  /// Returns \f$ c_i \f$, `0 <= i <= n`.
  const FT& operator[](int i) const { return c_[i]; }

  /// Returns the value at `t`, which may lie outside [0, 1]. \f$ O(n^2) \f$
  FT operator()(const FT& t) const {
    std::vector<FT> c = c_;
    return bernstein_value(c, degree(), t);
  }

  /// Returns the derivative, of degree `n - 1` (0 for a constant).
  Bernstein_polynomial derivative() const {
    if (degree() == 0) return Bernstein_polynomial{FT(0)};
    std::vector<FT> c = c_;
    difference_step(c, degree());
    c.pop_back();
    for (FT& x : c) x *= FT(degree());
    return Bernstein_polynomial(std::move(c));
  }

  /// Returns the antiderivative that vanishes at 0, of degree `n + 1`.
  Bernstein_polynomial antiderivative() const {
    std::vector<FT> c(1, FT(0));
    for (const FT& x : c_) c.push_back(FT(c.back() + x / FT(degree() + 1)));
    return Bernstein_polynomial(std::move(c));
  }

  /// Returns \f$ \int_0^1 p(t)\,dt \f$, the mean of the coefficients.
  FT integral() const {
    FT sum(0);
    for (const FT& x : c_) sum += x;
    return FT(sum / FT(degree() + 1));
  }

  /// Returns the same function with the degree raised by `times >= 0`. \f$ O(n\,times + times^2) \f$
  /// \throws Error `negative_count` when `times` is negative
  Bernstein_polynomial elevated(int times = 1) const {
    if (times < 0) throw Error(Error_code::negative_count, "Bernstein_polynomial::elevated");
    std::vector<FT> c = c_;
    c.resize(c_.size() + times, FT(0));
    for (int i = 0; i < times; ++i) bernstein_elevate<FT>(c, degree() + i);
    return Bernstein_polynomial(std::move(c));
  }

  /// Returns the parts on [0, t] and [t, 1], each reparametrised to [0, 1]. \f$ O(n^2) \f$
  std::pair<Bernstein_polynomial, Bernstein_polynomial> split(const FT& t) const {
    std::vector<FT> right = c_, left(c_.size());
    bernstein_split(right, degree(), t, left);
    return {Bernstein_polynomial(std::move(left)), Bernstein_polynomial(std::move(right))};
  }

  /// Returns the restriction to [a, b], reparametrised to [0, 1]: \f$ t \mapsto p(a + t (b - a)) \f$ for any `a` and
  /// `b`. \f$ O(n^2) \f$
  Bernstein_polynomial restricted(const FT& a, const FT& b) const {
    if (a == FT(1)) { // split from the other side: [b, 1] reversed
      Bernstein_polynomial r = split(b).second;
      std::reverse(r.c_.begin(), r.c_.end());
      return r;
    }
    const Bernstein_polynomial right = split(a).second;
    return right.split(FT((b - a) / (FT(1) - a))).first;
  }

  /// Returns the product, of degree `n + m`. \f$ O(n m) \f$
  friend Bernstein_polynomial operator*(const Bernstein_polynomial& p, const Bernstein_polynomial& q) {
    const int n = p.degree(), m = q.degree();
    const std::vector<FT> bn = binomial_coefficients<FT>(n), bm = binomial_coefficients<FT>(m),
                          bnm = binomial_coefficients<FT>(n + m);
    std::vector<FT> c(n + m + 1, FT(0));
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= m; ++j) c[i + j] += bn[i] * p[i] * bm[j] * q[j];
    for (int k = 0; k <= n + m; ++k) c[k] /= bnm[k];
    return Bernstein_polynomial(std::move(c));
  }

  /// Returns the sum, in the larger of the two degrees.
  friend Bernstein_polynomial operator+(const Bernstein_polynomial& p, const Bernstein_polynomial& q) {
    return combined(p, q, FT(1));
  }
  /// Returns the difference, in the larger of the two degrees.
  friend Bernstein_polynomial operator-(const Bernstein_polynomial& p, const Bernstein_polynomial& q) {
    return combined(p, q, FT(-1));
  }

  /// Decides whether degree and coefficients are equal.
  friend bool operator==(const Bernstein_polynomial& p, const Bernstein_polynomial& q) { return p.c_ == q.c_; }
  /// Decides whether the degree or a coefficient is different.
  friend bool operator!=(const Bernstein_polynomial& p, const Bernstein_polynomial& q) { return !(p == q); }

  /// Writes the coefficients, separated by spaces.
  friend std::ostream& operator<<(std::ostream& os, const Bernstein_polynomial& p) {
    for (int i = 0; i <= p.degree(); ++i) os << (i == 0 ? "" : " ") << p[i];
    return os;
  }

private:
  std::vector<FT> c_;

  void check() const {
    if (c_.empty()) throw Error(Error_code::wrong_number_of_points, "Bernstein polynomial without coefficients");
  }
  static Bernstein_polynomial combined(const Bernstein_polynomial& p, const Bernstein_polynomial& q, const FT& sign) {
    const int n = (std::max)(p.degree(), q.degree());
    Bernstein_polynomial r = p.elevated(n - p.degree());
    const Bernstein_polynomial s = q.elevated(n - q.degree());
    for (int i = 0; i <= n; ++i) r.c_[i] += sign * s[i];
    return r;
  }
};

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns all values \f$ B_0^n(t), \dots, B_n^n(t) \f$ of the Bernstein basis of degree `n >= 0`. \f$ O(n^2) \f$
/// \throws Error `negative_count` when `n` is negative
template <class FT> std::vector<FT> bernstein_basis(int n, const FT& t) {
  if (n < 0) throw Error(Error_code::negative_count, "bernstein_basis: degree");
  const FT s = FT(1) - t;
  std::vector<FT> b(1, FT(1));
  for (int k = 1; k <= n; ++k) {
    b.push_back(FT(t * b.back()));
    for (int i = k - 1; i > 0; --i) b[i] = s * b[i] + t * b[i - 1];
    b[0] *= s;
  }
  return b;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BERNSTEIN_POLYNOMIAL_H
