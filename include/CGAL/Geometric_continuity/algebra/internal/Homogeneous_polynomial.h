// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_HOMOGENEOUS_POLYNOMIAL_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_HOMOGENEOUS_POLYNOMIAL_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

/// \file Homogeneous_polynomial.h
/// Polynomials on [0, 1] in homogeneous form, which are computed with by additions and products
/// only.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A polynomial sum_k c_k t^k (1-t)^(n-k) on [0, 1]. The coefficients are those of the Bernstein
// form times C(n, k); they have the same signs. In return a product is a convolution, and sums,
// products, derivatives, elevation and bisection need no division: all operations but bernstein()
// are those of a ring, e.g. of integers.
//
// \tparam NT a ring number type, constructible from int
template <class NT_> class Homogeneous_polynomial {
public:
  typedef NT_ NT; // the number type

  // Constructs zero.
  Homogeneous_polynomial() : c_(1, NT(0)) {}

  // Constructs a polynomial from n + 1 >= 1 coefficients c_k. \throws Error wrong_number_of_points
  // without coefficients
  explicit Homogeneous_polynomial(std::vector<NT> coefficients) : c_(std::move(coefficients)) {
    // unreachable: an error of the package itself
    if (c_.empty()) throw Error(Error_code::wrong_number_of_points, "homogeneous polynomial without coefficients");
  }

  // Returns the polynomial with n + 1 >= 1 Bernstein coefficients.
  // \throws Error wrong_number_of_points without coefficients
  static Homogeneous_polynomial from_bernstein(std::vector<NT> b) {
    if (b.empty()) throw Error(Error_code::wrong_number_of_points, "homogeneous polynomial without coefficients");
    const std::vector<NT> binomials = binomial_coefficients<NT>(static_cast<int>(b.size()) - 1);
    for (std::size_t k = 0; k < b.size(); ++k) b[k] *= binomials[k];
    return Homogeneous_polynomial(std::move(b));
  }

  // Returns the degree n.
  int degree() const { return static_cast<int>(c_.size()) - 1; }
  // Returns c_k, 0 <= k <= n.
  const NT& operator[](int k) const { return c_[k]; }

  // Decides whether all coefficients are zero.
  bool is_zero() const {
    return std::all_of(c_.begin(), c_.end(), [](const NT& x) { return bool(x == NT(0)); });
  }

  // Returns the derivative with respect to t, of degree n - 1 (0 for a constant).
  Homogeneous_polynomial derivative() const {
    const int n = degree();
    if (n == 0) return Homogeneous_polynomial();
    std::vector<NT> d;
    for (int k = 0; k < n; ++k) d.push_back(NT(NT(k + 1) * c_[k + 1] - NT(n - k) * c_[k]));
    return Homogeneous_polynomial(std::move(d));
  }

  // Returns the same function with the degree raised to n >= degree().
  // \throws Error negative_count when n is less than the degree
  Homogeneous_polynomial elevated_to(int n) const {
    if (n == degree()) return *this;
    return *this * Homogeneous_polynomial(binomial_coefficients<NT>(n - degree()));
  }

  // Returns the product, of degree n + m. O(n m)
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

  // Returns the sum, in the larger of the two degrees.
  friend Homogeneous_polynomial operator+(Homogeneous_polynomial p, const Homogeneous_polynomial& q) {
    p.combine(q, [](NT& x, const NT& y) { x += y; });
    return p;
  }
  // Returns the difference, in the larger of the two degrees.
  friend Homogeneous_polynomial operator-(Homogeneous_polynomial p, const Homogeneous_polynomial& q) {
    p.combine(q, [](NT& x, const NT& y) { x -= y; });
    return p;
  }

  // Decides whether both are the same function, whatever the degrees.
  friend bool operator==(const Homogeneous_polynomial& p, const Homogeneous_polynomial& q) {
    if (p.degree() == q.degree()) return p.c_ == q.c_;
    const int n = (std::max)(p.degree(), q.degree());
    return p.elevated_to(n).c_ == q.elevated_to(n).c_;
  }

  // Returns the function t -> p(1 - t).
  Homogeneous_polynomial reversed() const { return Homogeneous_polynomial(std::vector<NT>(c_.rbegin(), c_.rend())); }

  // Returns the parts on [0, 1/2] and [1/2, 1], each reparametrised to [0, 1] and multiplied by
  // 2^n. O(n^2)
  std::pair<Homogeneous_polynomial, Homogeneous_polynomial> halves() const {
    return {reversed().second_half().reversed(), second_half()};
  }

  // Returns the number of factors t that can be split off, degree() + 1 for zero.
  int order_at_0() const {
    int k = 0;
    while (k <= degree() && c_[k] == NT(0)) ++k;
    return k;
  }
  // Returns the number of factors 1 - t that can be split off, degree() + 1 for zero.
  int order_at_1() const {
    int l = 0;
    while (l <= degree() && c_[degree() - l] == NT(0)) ++l;
    return l;
  }

  // Returns the quotient by t^k (1-t)^l, 0 <= k <= order_at_0(), 0 <= l <= order_at_1(),
  // k + l <= degree().
  // \throws Error negative_count when k or l is negative, wrong_number_of_points when there are not
  //   as many factors
  Homogeneous_polynomial without_end_factors(int k, int l) const {
    if (k < 0 || l < 0) throw Error(Error_code::negative_count, "without_end_factors");
    const auto is_zero = [](const NT& x) { return bool(x == NT(0)); };
    if (k > degree() - l || !std::all_of(c_.begin(), c_.begin() + k, is_zero) ||
        !std::all_of(c_.end() - l, c_.end(), is_zero))
      throw Error(Error_code::wrong_number_of_points, "without_end_factors: the polynomial has fewer factors");
    return Homogeneous_polynomial(std::vector<NT>(c_.begin() + k, c_.end() - l));
  }

  // Returns the Bernstein form over a field FT to which NT can be converted.
  template <class FT> Bernstein_polynomial<FT> bernstein() const {
    const std::vector<FT> binomials = binomial_coefficients<FT>(degree());
    std::vector<FT> b;
    for (int k = 0; k <= degree(); ++k) b.push_back(FT(FT(c_[k]) / binomials[k]));
    return Bernstein_polynomial<FT>(std::move(b));
  }

private:
  std::vector<NT> c_;

  // operation(c_k, q_k) in the larger of the two degrees
  template <class Operation> void combine(const Homogeneous_polynomial& q, Operation operation) {
    if (degree() < q.degree()) *this = elevated_to(q.degree());
    if (q.degree() < degree()) return combine(q.elevated_to(degree()), operation);
    for (int k = 0; k <= degree(); ++k) operation(c_[k], q[k]);
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

// A space curve with polynomial coordinates, such as a derivative of a surface along an edge.
template <class NT> using Homogeneous_vector = std::array<Homogeneous_polynomial<NT>, 3>;

// Returns the cross product, a curve whose degree is the sum of both degrees.
template <class NT>
Homogeneous_vector<NT> cross_product(const Homogeneous_vector<NT>& v, const Homogeneous_vector<NT>& w) {
  return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
}

// Returns the scalar product, a polynomial whose degree is the sum of both degrees.
template <class NT, std::size_t n>
Homogeneous_polynomial<NT> scalar_product(const std::array<Homogeneous_polynomial<NT>, n>& v,
                                          const std::array<Homogeneous_polynomial<NT>, n>& w) {
  Homogeneous_polynomial<NT> sum = v[0] * w[0];
  for (std::size_t i = 1; i < n; ++i) sum = sum + v[i] * w[i];
  return sum;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_HOMOGENEOUS_POLYNOMIAL_H
