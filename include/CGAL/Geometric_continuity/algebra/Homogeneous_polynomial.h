// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_HOMOGENEOUS_POLYNOMIAL_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_HOMOGENEOUS_POLYNOMIAL_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/numbers/internal/sign_of.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// A polynomial \f$ \sum_{k=0}^n c_k\, t^k (1-t)^{n-k} \f$ on [0, 1]. The coefficients are those of the Bernstein form
/// times \f$ \binom{n}{k} \f$; they have the same signs. In return a product is a convolution, and sums, products,
/// derivatives, elevation and bisection need no division: all operations but `bernstein()` and `sign_pattern()` are
/// those of a ring, e.g. of integers.
///
/// \tparam NT a ring number type, constructible from `int`
template <class NT_> class Homogeneous_polynomial {
public:
  typedef NT_ NT;

  /// Zero.
  Homogeneous_polynomial() : c_(1, NT(0)) {}

  /// From `n + 1 >= 1` coefficients \f$ c_k \f$. \throws Error `wrong_number_of_points` without coefficients
  explicit Homogeneous_polynomial(std::vector<NT> coefficients) : c_(std::move(coefficients)) {
    if (c_.empty()) throw Error(Error_code::wrong_number_of_points, "homogeneous polynomial without coefficients");
  }

  /// From `n + 1 >= 1` Bernstein coefficients. \throws Error `wrong_number_of_points` without coefficients
  static Homogeneous_polynomial from_bernstein(std::vector<NT> b) {
    const std::vector<NT> binomials = binomial_coefficients<NT>(static_cast<int>(b.size()) - 1);
    for (std::size_t k = 0; k < b.size(); ++k) b[k] *= binomials[k];
    return Homogeneous_polynomial(std::move(b));
  }

  int degree() const { return static_cast<int>(c_.size()) - 1; }
  const NT& operator[](int k) const { return c_[k]; }

  bool is_zero() const {
    return std::all_of(c_.begin(), c_.end(), [](const NT& x) { return bool(x == NT(0)); });
  }

  /// The derivative with respect to `t`, of degree `n - 1` (0 for a constant).
  Homogeneous_polynomial derivative() const {
    const int n = degree();
    if (n == 0) return Homogeneous_polynomial();
    std::vector<NT> d;
    for (int k = 0; k < n; ++k) d.push_back(NT(NT(k + 1) * c_[k + 1] - NT(n - k) * c_[k]));
    return Homogeneous_polynomial(std::move(d));
  }

  /// The same polynomial with the degree raised to `n`. \pre `n >= degree()`
  Homogeneous_polynomial elevated_to(int n) const {
    if (n == degree()) return *this;
    return *this * Homogeneous_polynomial(binomial_coefficients<NT>(n - degree()));
  }

  /// The product, of degree `n + m`.
  friend Homogeneous_polynomial operator*(const Homogeneous_polynomial& p, const Homogeneous_polynomial& q) {
    std::vector<NT> c(p.degree() + q.degree() + 1, NT(0));
    NT product(0); // its memory is used again and again
    for (int i = 0; i <= p.degree(); ++i)
      for (int j = 0; j <= q.degree(); ++j) {
        product = p[i] * q[j];
        c[i + j] += product;
      }
    return Homogeneous_polynomial(std::move(c));
  }

  /// Sum and difference, in the larger of the two degrees.
  friend Homogeneous_polynomial operator+(Homogeneous_polynomial p, const Homogeneous_polynomial& q) {
    p.combine(q, [](NT& x, const NT& y) { x += y; });
    return p;
  }
  friend Homogeneous_polynomial operator-(Homogeneous_polynomial p, const Homogeneous_polynomial& q) {
    p.combine(q, [](NT& x, const NT& y) { x -= y; });
    return p;
  }

  /// Equality of the functions, whatever the degrees.
  friend bool operator==(const Homogeneous_polynomial& p, const Homogeneous_polynomial& q) {
    if (p.degree() == q.degree()) return p.c_ == q.c_;
    const int n = std::max(p.degree(), q.degree());
    return p.elevated_to(n).c_ == q.elevated_to(n).c_;
  }
  friend bool operator!=(const Homogeneous_polynomial& p, const Homogeneous_polynomial& q) { return !(p == q); }

  /// The function \f$ t \mapsto p(1 - t) \f$.
  Homogeneous_polynomial reversed() const { return Homogeneous_polynomial(std::vector<NT>(c_.rbegin(), c_.rend())); }

  /// The parts on [0, 1/2] and [1/2, 1], each reparametrised to [0, 1] and multiplied by \f$ 2^n \f$. \f$ O(n^2) \f$
  std::pair<Homogeneous_polynomial, Homogeneous_polynomial> halves() const {
    return {reversed().second_half().reversed(), second_half()};
  }

  /// The number of factors `t` that can be split off, `degree() + 1` for zero.
  int order_at_0() const {
    int k = 0;
    while (k <= degree() && c_[k] == NT(0)) ++k;
    return k;
  }
  /// The number of factors `1 - t` that can be split off, `degree() + 1` for zero.
  int order_at_1() const { return reversed().order_at_0(); }

  /// The quotient by \f$ t^k (1-t)^l \f$. \pre `k <= order_at_0()`, `l <= order_at_1()`, `k + l <= degree()`
  Homogeneous_polynomial without_end_factors(int k, int l) const {
    return Homogeneous_polynomial(std::vector<NT>(c_.begin() + k, c_.end() - l));
  }

  /// The signs of the coefficients. Coefficients of one strict sign prove this sign on the closed interval.
  Sign_pattern coefficient_signs() const {
    bool negative = false, zero = false, positive = false;
    for (const NT& x : c_) {
      const int s = internal::sign_of<NT>(x);
      (s < 0 ? negative : s > 0 ? positive : zero) = true;
    }
    if (negative && positive) return Sign_pattern::mixed;
    if (positive) return zero ? Sign_pattern::nonnegative : Sign_pattern::positive;
    if (negative) return zero ? Sign_pattern::nonpositive : Sign_pattern::negative;
    return Sign_pattern::zero;
  }

  /// The Bernstein form over a field `FT` to which `NT` can be converted.
  template <class FT> Bernstein_polynomial<FT> bernstein() const {
    const std::vector<FT> binomials = binomial_coefficients<FT>(degree());
    std::vector<FT> b;
    for (int k = 0; k <= degree(); ++k) b.push_back(FT(FT(c_[k]) / binomials[k]));
    return Bernstein_polynomial<FT>(std::move(b));
  }

  /// The signs on the closed interval [0, 1], decided exactly: by bisection, and if that does not decide, as by
  /// `sign_pattern()`. `FT` is a field to which `NT` can be converted.
  template <class FT> Sign_pattern signs() const {
    constexpr int bisections = 4;
    const Sign_pattern s = strict_sign(bisections);
    return s == Sign_pattern::mixed ? Geometric_continuity::sign_pattern(bernstein<FT>()) : s;
  }

private:
  std::vector<NT> c_;

  // operation(c_k, q_k) in the larger of the two degrees
  template <class Operation> void combine(const Homogeneous_polynomial& q, Operation operation) {
    if (degree() < q.degree()) *this = elevated_to(q.degree());
    if (q.degree() < degree()) return combine(q.elevated_to(degree()), operation);
    for (int k = 0; k <= degree(); ++k) operation(c_[k], q[k]);
  }

  // Positive, negative or zero if bisection proves that, otherwise mixed.
  Sign_pattern strict_sign(int bisections) const {
    const Sign_pattern s = coefficient_signs();
    if (s == Sign_pattern::positive || s == Sign_pattern::negative || s == Sign_pattern::zero) return s;
    const int first = internal::sign_of<NT>(c_.front()), last = internal::sign_of<NT>(c_.back());
    if (bisections == 0 || first * last != 1) return Sign_pattern::mixed;
    const std::pair<Homogeneous_polynomial, Homogeneous_polynomial> h = halves();
    const Sign_pattern left = h.first.strict_sign(bisections - 1);
    if (left == Sign_pattern::mixed) return left;
    const Sign_pattern right = h.second.strict_sign(bisections - 1);
    return right == left ? left : Sign_pattern::mixed;
  }

  // t -> (1 + t)/2: in terms of y = t/(1-t) this is y -> 2y + 1, up to the factor 2^n
  Homogeneous_polynomial second_half() const {
    std::vector<NT> c = c_;
    const int n = degree();
    for (int i = 0; i < n; ++i)
      for (int k = n - 1; k >= i; --k) c[k] += c[k + 1];
    NT power(1);
    for (int k = 1; k <= n; ++k) {
      power *= NT(2);
      c[k] *= power;
    }
    return Homogeneous_polynomial(std::move(c));
  }
};

/// \ingroup PkgGeometricContinuityAlgebra
/// A space curve with polynomial coordinates, such as a derivative of a surface along an edge.
template <class NT> using Homogeneous_vector = std::array<Homogeneous_polynomial<NT>, 3>;

/// \ingroup PkgGeometricContinuityAlgebra
/// The cross product.
template <class NT>
Homogeneous_vector<NT> cross_product(const Homogeneous_vector<NT>& v, const Homogeneous_vector<NT>& w) {
  return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
}

/// \ingroup PkgGeometricContinuityAlgebra
/// The scalar product.
template <class NT>
Homogeneous_polynomial<NT> scalar_product(const Homogeneous_vector<NT>& v, const Homogeneous_vector<NT>& w) {
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_HOMOGENEOUS_POLYNOMIAL_H
