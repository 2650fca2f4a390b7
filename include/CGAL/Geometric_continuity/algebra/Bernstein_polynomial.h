// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BERNSTEIN_POLYNOMIAL_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BERNSTEIN_POLYNOMIAL_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Bernstein_polynomial.h
/// Polynomials on [0, 1] in Bernstein form: their coefficients are control points, and their signs
/// tell much about the signs of the polynomial. Farin, "Curves and Surfaces for CAGD", chapters 5
/// and 6. And polynomials in powers over an exact field, for Euclid's algorithm: the greatest
/// common divisor, and the polynomial with the same roots, all of them simple.
///
/// The functions on coefficients \f$ c_0, \dots, c_n \f$ of \f$ \sum_i c_i B_i^n(t) \f$ in
/// random-access containers `c` use field arithmetic only. Curves run them on coordinates and on
/// vectors of coordinates; `Bernstein_polynomial` wraps them for scalar polynomials. The algorithms
/// are de Casteljau's. They run in the innermost loops and do not check their arguments: it is the
/// caller's duty that `c` has the `n + 1` elements and, where this is said, the room that is
/// needed, and that `n` and `k` are not negative.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the row \f$ \binom{n}{0}, \dots, \binom{n}{n} \f$ of Pascal's triangle, `n >= 0`.
/// \f$ O(n) \f$
/// \throws Error `negative_count` when `n` is negative
template <class FT> std::vector<FT> binomial_coefficients(int n) {
  if (n < 0) throw Error(Error_code::negative_count, "binomial_coefficients");
  std::vector<FT> row(1, FT(1));
  for (int i = 0; i < n; ++i) row.push_back(FT(row.back() * FT(n - i) / FT(i + 1)));
  return row;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Does one step of de Casteljau's algorithm at `t`: overwrites \f$ c_0, \dots, c_n \f$ by the `n`
/// coefficients \f$ (1-t) c_i + t c_{i+1} \f$ in the first places.
template <class FT, class Coefficients> void de_casteljau_step(Coefficients& c, int n, const FT& t) {
  const FT s = FT(1) - t;
  for (int i = 0; i < n; ++i) c[i] = s * c[i] + t * c[i + 1];
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Overwrites \f$ c_0, \dots, c_n \f$ by the forward differences \f$ c_{i+1} - c_i \f$ in the first
/// `n` places.
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
/// Computes the derivatives of order 0 to `k` at `t`, with respect to `t`: `out(j, value)` is
/// called for each `j`, in this order; `c` is overwritten. The coefficients are numbers or vectors
/// of the same dimension. \f$ O(n^2 + k^3) \f$
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
/// Computes the derivatives of order 0 to `k` at `t = 0` from the first `k + 1` coefficients, in
/// `c`, which is overwritten, and calls `out(j, value)` for each `j`, in this order:
/// \f$ \frac{n!}{(n-j)!} \Delta^j c_0 \f$. The coefficients in reverse order give the derivatives
/// at `t = 1` up to the sign \f$ (-1)^j \f$. \f$ O(k^2) \f$
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
/// Overwrites \f$ c_0, \dots, c_n \f$ by the coefficients on \f$ [t, 1] \f$ and writes those on
/// \f$ [0, t] \f$ to `left`, which has room for `n + 1`. \f$ O(n^2) \f$
template <class FT, class Coefficients> void bernstein_split(Coefficients& c, int n, const FT& t, Coefficients& left) {
  // curves/internal/bezier_jet.h has the same for a degree known at compile time; after i steps,
  // c[0] is the next coefficient of the left part
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

  /// Constructs a polynomial from `n + 1 >= 1` coefficients. \throws Error `wrong_number_of_points`
  /// without coefficients
  explicit Bernstein_polynomial(std::vector<FT> coefficients) : c_(std::move(coefficients)) { check(); }
  /// Constructs a polynomial from `n + 1 >= 1` coefficients. \throws Error `wrong_number_of_points`
  /// without coefficients
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

  /// Returns the same function with the degree raised by `times >= 0`.
  /// \f$ O(n\,times + times^2) \f$
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

  /// Returns the restriction to [a, b], reparametrised to [0, 1]:
  /// \f$ t \mapsto p(a + t (b - a)) \f$ for any `a` and `b`. \f$ O(n^2) \f$
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
/// Returns all values \f$ B_0^n(t), \dots, B_n^n(t) \f$ of the Bernstein basis of degree `n >= 0`.
/// \f$ O(n^2) \f$
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

namespace internal {

template <class FT> bool is_zero_coefficient(const FT& x) { return x == FT(0); }
template <class FT, int N> bool is_zero_coefficient(const Coordinate_vector<FT, N>& x) { return is_zero(x); }

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the coefficients \f$ a_k = \binom{n}{k} \Delta^k c_0 \f$ of the powers of `t`, up to the
/// last that is not zero but at least \f$ a_0 \f$, from the `n + 1` Bernstein coefficients
/// \f$ c_i \f$ on [0, 1], which are numbers or vectors. None from none. \f$ O(n^2) \f$
/// \tparam FT a field number type \tparam Row a `std::vector` of such numbers or of vectors over
///   them
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
/// A polynomial \f$ \sum_{k=0}^n a_k t^k \f$ with \f$ a_n \ne 0 \f$; the zero polynomial has no
/// coefficients and the degree -1.
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

  /// Divides by `d`, leaves the remainder here and returns the quotient. \f$ O((n-m+1) m) \f$ for
  /// degrees `n`, `m`
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

  /// Returns the same function in Bernstein form,
  /// \f$ c_i = \sum_k a_k \binom{i}{k} / \binom{n}{k} \f$, of the same degree; of degree 0 for
  /// zero. \f$ O(n^2) \f$
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
/// Returns the greatest common divisor, up to a factor that is not zero, by Euclid's algorithm;
/// zero if both are. \f$ O(nm) \f$ operations for degrees `n`, `m`, on numbers that grow in length
/// up to the order of `n + m`
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
/// Returns `p` divided by the greatest common divisor of `p` and its derivative: it has the same
/// roots, and all of them are simple. It costs as much as `greatest_common_divisor()`.
/// \throws Error `wrong_number_of_points` when `p` is zero, `work_limit`
template <class FT> Bernstein_polynomial<FT> square_free_part(const Bernstein_polynomial<FT>& p) {
  const internal::Work_on_part work("square_free_part");
  Power_polynomial<FT> f(p);
  return f.divide(greatest_common_divisor(f, f.derivative())).bernstein();
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BERNSTEIN_POLYNOMIAL_H
