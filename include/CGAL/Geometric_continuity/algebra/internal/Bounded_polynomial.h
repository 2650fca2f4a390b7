// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_BOUNDED_POLYNOMIAL_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_BOUNDED_POLYNOMIAL_H

#include <CGAL/Geometric_continuity/numbers/internal/Fixed_integer.h>

#include <algorithm>
#include <cstdint>

/// \file Bounded_polynomial.h
/// Polynomials whose coefficients are integers of fixed length, without allocation. A bound of the
/// coefficients is part of the type, and the compiler finds from it how long they are: sums and
/// products of polynomials have the bounds of sums and products.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// The least k with n <= 2^k.
// unreachable: computed by the compiler
constexpr int binary_logarithm_above(int n) { return n <= 1 ? 0 : 1 + binary_logarithm_above((n + 1) / 2); }

// The binomial coefficients up to a degree.
template <int most> struct Binomial_table {
  std::int64_t x[most + 1][most + 1] = {};

  constexpr Binomial_table() {
    for (int n = 0; n <= most; ++n)
      for (int k = 0; k <= n; ++k) x[n][k] = k == 0 || k == n ? 1 : x[n - 1][k - 1] + x[n - 1][k];
  }
  constexpr std::int64_t operator()(int n, int k) const { return x[n][k]; }
};

// A product is assigned to a polynomial, added to it or subtracted from it.
enum class Accumulation { assign, add, subtract };

// A polynomial sum_k c_k t^k (1-t)^(n-k), see Homogeneous_polynomial, of a degree 0 <= n <=
// most_degree, whose Bernstein coefficients c_k / C(n,k) are at most 2^bits.
//
// Those of a product are means of products of coefficients of the factors: so its bound is the
// product of theirs, whatever the degrees are. As C(n,k) < 2^n for n > 0 the c_k are less than
// 2^(bits + n), and need one more bit for the sign.
template <int most_degree_, int bits_> struct Bounded_polynomial {
  static_assert(1 <= most_degree_ && 0 <= bits_);
  static constexpr int most_degree = most_degree_, bits = bits_, limbs = (bits + most_degree) / 64 + 1;
  typedef Fixed_integer<limbs> Coefficient;

  int degree;
  Coefficient c[most_degree + 1];

  Bounded_polynomial() = default; // without a value
  template <int m, int b> explicit Bounded_polynomial(const Bounded_polynomial<m, b>& p) : degree(p.degree) {
    static_assert(m <= most_degree && b <= bits, "the bound does not become less");
    for (int k = 0; k <= degree; ++k) c[k] = extended<limbs>(p.c[k]);
  }

  static CGAL_GC_FORCEINLINE std::int64_t binomial(int n, int k) {
    static constexpr Binomial_table<most_degree> table;
    return table(n, k);
  }
  // Gives it a Bernstein coefficient, an integer, times its binomial coefficient.
  CGAL_GC_FORCEINLINE void set_bernstein(int k, std::int64_t binomial, Signed_128 b) {
    static_assert(bits + most_degree <= 126);
    if constexpr (limbs == 1)
      c[k] = Coefficient(binomial * static_cast<std::int64_t>(b));
    else
      c[k] = from_128_bits<limbs>(binomial * b);
  }
  template <class Bernstein> static Bounded_polynomial from_bernstein(int n, Bernstein b) {
    Bounded_polynomial p;
    p.degree = n;
    for (int k = 0; k <= n; ++k) p.set_bernstein(k, binomial(n, k), b(k));
    return p;
  }

  // Adds or subtracts a product of the same degree, or makes it the product. Sums in between may be
  // too long: they are right modulo the powers of two that decide, and the last one fits, see
  // first_of_products().
  template <Accumulation operation, int m, int b, int n, int d>
  void accumulate(const Bounded_polynomial<m, b>& p, const Bounded_polynomial<n, d>& q) {
    static_assert(b + d <= bits && m + n <= most_degree, "there is room for the product");
    const auto product = [&](int i, int j) { return product_in<limbs>(p.c[i], q.c[j]); };
    if constexpr (operation == Accumulation::assign) {
      degree = p.degree + q.degree;
      if (q.degree < 0) { // zero, as a second derivative of a line
        std::fill(c, c + degree + 1, Coefficient(0));
        return;
      }
      for (int j = 0; j <= q.degree; ++j) c[j] = product(0, j);
      for (int i = 1; i <= p.degree; ++i) {
        for (int j = 0; j < q.degree; ++j) c[i + j] = c[i + j] + product(i, j);
        c[i + q.degree] = product(i, q.degree);
      }
    } else
      for (int i = 0; i <= p.degree; ++i)
        for (int j = 0; j <= q.degree; ++j)
          c[i + j] = operation == Accumulation::subtract ? c[i + j] - product(i, j) : c[i + j] + product(i, j);
  }

  bool vanishes() const {
    return std::all_of(c, c + degree + 1, [](const Coefficient& x) { return is_zero(x); });
  }

  // Returns 1 or -1 when all coefficients have this sign, otherwise 0.
  int strict_sign() const {
    const auto sign = [](const Coefficient& x) { return x.top() < 0 ? -1 : is_zero(x) ? 0 : 1; };
    const int first = sign(c[0]);
    return std::all_of(c, c + degree + 1, [&](const Coefficient& x) { return sign(x) == first; }) ? first : 0;
  }
};

// The product, with room for so many in all that are added to it or subtracted from it.
template <int terms, int m, int b, int n, int d>
Bounded_polynomial<m + n, b + d + binary_logarithm_above(terms)> first_of_products(const Bounded_polynomial<m, b>& p,
                                                                                   const Bounded_polynomial<n, d>& q) {
  typedef Bounded_polynomial<m + n, b + d + binary_logarithm_above(terms)> Sum;
  Sum r;
  r.template accumulate<Accumulation::assign>(p, q);
  return r;
}
template <int m, int b, int n, int d>
Bounded_polynomial<m + n, b + d> operator*(const Bounded_polynomial<m, b>& p, const Bounded_polynomial<n, d>& q) {
  return first_of_products<1>(p, q);
}
template <int m, int b, int n, int d, int l, int e>
void add_product(Bounded_polynomial<m, b>& r, const Bounded_polynomial<n, d>& p, const Bounded_polynomial<l, e>& q) {
  r.template accumulate<Accumulation::add>(p, q);
}
template <int m, int b, int n, int d, int l, int e>
void subtract_product(Bounded_polynomial<m, b>& r, const Bounded_polynomial<n, d>& p,
                      const Bounded_polynomial<l, e>& q) {
  r.template accumulate<Accumulation::subtract>(p, q);
}

// Takes polynomials of one degree.
template <int m, int b, int n, int d>
Bounded_polynomial<(std::max)(m, n), (std::max)(b, d) + 1> operator+(const Bounded_polynomial<m, b>& p,
                                                                     const Bounded_polynomial<n, d>& q) {
  Bounded_polynomial<(std::max)(m, n), (std::max)(b, d) + 1> sum(p);
  for (int k = 0; k <= p.degree; ++k) sum.c[k] = sum.c[k] + extended<sum.limbs>(q.c[k]);
  return sum;
}
template <int m, int b, int n, int d>
Bounded_polynomial<(std::max)(m, n), (std::max)(b, d) + 1> operator-(const Bounded_polynomial<m, b>& p,
                                                                     const Bounded_polynomial<n, d>& q) {
  Bounded_polynomial<(std::max)(m, n), (std::max)(b, d) + 1> difference(p);
  for (int k = 0; k <= p.degree; ++k) difference.c[k] = difference.c[k] - extended<difference.limbs>(q.c[k]);
  return difference;
}

// An integer with |value| < 2^bits as a factor.
template <int bits> struct Bounded_factor {
  static_assert(0 <= bits && bits <= 63);
  std::int64_t value;
};
template <int m, int b, int n>
Bounded_polynomial<m, b + n> operator*(const Bounded_factor<n>& w, const Bounded_polynomial<m, b>& p) {
  Bounded_polynomial<m, b + n> r;
  r.degree = p.degree;
  for (int k = 0; k <= p.degree; ++k) r.c[k] = product_in<r.limbs>(p.c[k], Fixed_integer<1>(w.value));
  return r;
}

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_BOUNDED_POLYNOMIAL_H
