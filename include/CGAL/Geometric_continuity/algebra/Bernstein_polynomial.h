// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BERNSTEIN_POLYNOMIAL_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BERNSTEIN_POLYNOMIAL_H

#include <CGAL/Geometric_continuity/Error.h>

#include <algorithm>
#include <initializer_list>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Bernstein_polynomial.h
/// Polynomials on [0, 1] in Bernstein form: their coefficients are control points, and their signs tell much about the signs of
/// the polynomial. Farin, "Curves and Surfaces for CAGD", chapters 5 and 6.
///
/// The functions on coefficients \f$ c_0, \dots, c_n \f$ of \f$ \sum_i c_i B_i^n(t) \f$ in random-access containers `c` use
/// field arithmetic only. Curves run them on coordinates and on vectors of coordinates; `Bernstein_polynomial` wraps them for
/// scalar polynomials. The algorithms are de Casteljau's. They run in the innermost loops and do not check their arguments: it
/// is the caller's duty that `c` has the `n + 1` elements and, where this is said, the room that is needed, and that `n` and
/// `k` are not negative.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the row \f$ \binom{n}{0}, \dots, \binom{n}{n} \f$ of Pascal's triangle, `n >= 0`. \f$ O(n) \f$
/// \throws Error `negative_count` when `n` is negative
template <class FT> std::vector<FT> binomial_coefficients(int n) {
  if (n < 0) throw Error(Error_code::negative_count, "binomial_coefficients");
  std::vector<FT> row(1, FT(1));
  for (int i = 0; i < n; ++i) row.push_back(FT(row.back() * FT(n - i) / FT(i + 1)));
  return row;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Does one step of de Casteljau's algorithm at `t`: overwrites \f$ c_0, \dots, c_n \f$ by the `n` coefficients
/// \f$ (1-t) c_i + t c_{i+1} \f$ in the first places.
template <class FT, class Coefficients> void de_casteljau_step(Coefficients& c, int n, const FT& t) {
  const FT s = FT(1) - t;
  for (int i = 0; i < n; ++i) c[i] = s * c[i] + t * c[i + 1];
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Overwrites \f$ c_0, \dots, c_n \f$ by the forward differences \f$ c_{i+1} - c_i \f$ in the first `n` places.
template <class Coefficients> void difference_step(Coefficients& c, int n) {
  for (int i = 0; i < n; ++i) c[i] = c[i + 1] - c[i];
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the value at `t` by de Casteljau's algorithm; `c` is overwritten. \f$ O(n^2) \f$
template <class FT, class Coefficients> auto bernstein_value(Coefficients& c, int n, const FT& t) {
  for (; n > 0; --n) de_casteljau_step(c, n, t);
  return c[0];
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Computes the derivatives of order 0 to `k` at `t`, with respect to `t`: `out(j, value)` is called for each
/// `j`, in this order; `c` is overwritten. The coefficients are numbers or vectors of the same dimension.
/// \f$ O(n^2 + k^3) \f$
template <class FT, class Coefficients, class Output>
void bernstein_derivatives(Coefficients& c, int n, const FT& t, int k, Output out) {
  typedef std::decay_t<decltype(c[0])> Coefficient;
  const int last = k < n ? k : n;
  int m = n;
  for (; m > last; --m) de_casteljau_step(c, m, t);
  // now c holds last+1 coefficients whose j-th differences, evaluated at t, are the j-th
  // derivatives up to the factor n!/(n-j)!
  FT factor(1);
  Coefficients row = c;
  for (int j = 0; j <= last; ++j) {
    for (int i = 0; i <= m; ++i) row[i] = c[i];
    out(j, Coefficient(factor * bernstein_value(row, m, t)));
    difference_step(c, m--);
    factor *= FT(n - j);
  }
  for (int j = last + 1; j <= k; ++j)
    if constexpr (std::is_same_v<Coefficient, FT>)
      out(j, FT(0));
    else
      out(j, Coefficient(c[0].dimension()));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Computes the derivatives of order 0 to `k` at `t = 0` from the first `k + 1` coefficients, in `c`, which is
/// overwritten, and calls `out(j, value)` for each `j`, in this order: \f$ \frac{n!}{(n-j)!} \Delta^j c_0 \f$. The
/// coefficients in reverse order give the derivatives at `t = 1` up to the sign \f$ (-1)^j \f$. \f$ O(k^2) \f$
template <class FT, class Coefficients, class Output>
void bernstein_end_derivatives(Coefficients& c, int n, int k, Output out) {
  const int last = k < n ? k : n;
  FT factor(1);
  for (int j = 0; j <= last; ++j) {
    out(j, FT(factor * c[0]));
    difference_step(c, last - j);
    factor *= FT(n - j);
  }
  for (int j = last + 1; j <= k; ++j) out(j, FT(0));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Overwrites \f$ c_0, \dots, c_n \f$ by the coefficients on \f$ [t, 1] \f$ and writes those on \f$ [0, t] \f$ to
/// `left`, which has room for `n + 1`. \f$ O(n^2) \f$
template <class FT, class Coefficients> void bernstein_split(Coefficients& c, int n, const FT& t, Coefficients& left) {
  // curves/internal/bezier_jet.h has the same for a degree known at compile time; after i steps, c[0] is the next coefficient of the left part
  const FT s = FT(1) - t;
  left[0] = c[0];
  for (int i = 1; i <= n; ++i) {
    for (int j = 0; j <= n - i; ++j) c[j] = s * c[j] + t * c[j + 1];
    left[i] = c[0];
  }
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Raises the degree from `n` to `n + 1`; `c` has room for `n + 2` coefficients. \f$ O(n) \f$
template <class FT, class Coefficients> void bernstein_elevate(Coefficients& c, int n) {
  c[n + 1] = c[n];
  for (int i = n; i > 0; --i) c[i] = (FT(i) * c[i - 1] + FT(n + 1 - i) * c[i]) / FT(n + 1);
}

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
