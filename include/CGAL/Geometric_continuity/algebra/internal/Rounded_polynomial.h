// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_ROUNDED_POLYNOMIAL_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_ROUNDED_POLYNOMIAL_H

#include <CGAL/Geometric_continuity/algebra/internal/Bounded_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/internal/Homogeneous_polynomial.h>
#include <CGAL/Geometric_continuity/numbers/internal/Fixed_integer.h>
#include <CGAL/Geometric_continuity/numbers/internal/zero_bits.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

/// \file Rounded_polynomial.h
/// Polynomials on [0, 1] in integers of 128 bits that are rounded outwards: for bisection without
/// exact coefficients, which become longer.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// A polynomial on [0, 1] whose Bernstein coefficients lie between c[k] and c[k] + error, in units
// of 2^exponent.
class Rounded_polynomial {
public:
  static constexpr int most_degree = 40;

  int degree, exponent;
  Signed_128 error;
  Signed_128 c[most_degree + 1];

  // The polynomial with the coefficients c_k of its homogeneous form, times a number that depends
  // on its degree only. Returns nothing if the degree is too high, the numbers are too long, or the
  // polynomial is zero.
  template <class Ring> static std::optional<Rounded_polynomial> of(const Homogeneous_polynomial<Ring>& p) {
    if (p.degree() > most_degree) return std::nullopt;
    Rounded_polynomial r(p.degree());
    constexpr int parts = 3;
    double part[most_degree + 1][parts], size = 0;
    for (int k = 0; k <= r.degree; ++k) {
      Ring rest = Ring(p[k] * Ring(static_cast<double>(multiple(r.degree, k))));
      for (double& x : part[k]) {
        x = CGAL::to_double(rest);
        if (!std::isfinite(x)) return std::nullopt;
        rest -= Ring(x);
      }
      size = (std::max)(size, std::abs(part[k][0]));
    }
    if (size == 0) return std::nullopt;
    r.exponent = std::ilogb(size) - 124;
    r.error = 8; // each part is rounded by less than a unit, and so is what is left after them
    for (int k = 0; k <= r.degree; ++k) {
      r.c[k] = -4;
      for (double x : part[k]) r.c[k] += in_units(x, r.exponent);
    }
    return r;
  }
  template <int m, int bits> static std::optional<Rounded_polynomial> of(const Bounded_polynomial<m, bits>& p) {
    // unreachable: no type of polynomial that is asked has so high a degree
    if (p.degree > most_degree) return std::nullopt;
    Rounded_polynomial r(p.degree);
    constexpr int limbs = (bits + 53) / 64 + 1; // of Bernstein coefficients times less than 2^53
    Fixed_integer<limbs> b[most_degree + 1];
    int size = 0;
    for (int k = 0; k <= r.degree; ++k) {
      b[k] = product_in<limbs>(p.c[k], Fixed_integer<1>(multiple(r.degree, k)));
      size = (std::max)(size, bits_of(b[k]));
    }
    if (size == 0) return std::nullopt;
    r.exponent = (std::max)(size - 125, 0);
    r.error = 1;
    for (int k = 0; k <= r.degree; ++k) r.c[k] = shifted(b[k], r.exponent);
    return r;
  }

  // Makes this the part on [0, 1/2] and returns that on [1/2, 1]. Means are rounded downwards, by
  // half a unit.
  Rounded_polynomial split() {
    error += (degree + 1) / 2;
    Rounded_polynomial right(degree);
    right.exponent = exponent;
    right.error = error;
    for (int i = degree; i >= 0; --i) {
      right.c[i] = c[degree];
      for (int k = degree; k > degree - i; --k) c[k] = (c[k - 1] + c[k]) >> 1;
    }
    return right;
  }

  // Returns 1 or -1 if that is the sign of the polynomial on all of [0, 1], and a few bisections
  // prove it. Otherwise 0.
  template <class Polynomial> static int sign_of(const Polynomial& p) {
    const std::optional<Rounded_polynomial> rounded = of(p);
    return rounded ? rounded->sign(most_bisections) : 0;
  }

private:
  static constexpr int most_bisections = 6;

  explicit Rounded_polynomial(int n) : degree(n) {}

  int sign(int bisections) const {
    const bool positive = c[0] > 0;
    const auto has_sign = [&](Signed_128 x) { return positive ? x > 0 : x + error < 0; };
    if (!has_sign(c[0]) || !has_sign(c[degree])) return 0;
    if (std::all_of(c, c + degree + 1, has_sign)) return positive ? 1 : -1;
    if (bisections == 0) return 0;
    Rounded_polynomial left = *this, right = left.split();
    const int sign_of_left = left.sign(bisections - 1);
    return sign_of_left != 0 && right.sign(bisections - 1) == sign_of_left ? sign_of_left : 0;
  }

  // The least common multiple of the binomial coefficients of degree n, divided by that of k; less
  // than 2^53.
  static std::int64_t multiple(int n, int k) {
    struct Table {
      std::int64_t x[most_degree + 1][most_degree + 1];
      Table() {
        for (int n = 0; n <= most_degree; ++n) {
          std::int64_t binomial = 1, common = 1;
          for (int k = 1; k <= n; ++k) common = std::lcm(common, binomial = binomial * (n - k + 1) / k);
          binomial = 1;
          for (int k = 0; k <= n; binomial = binomial * (n - k) / (k + 1), ++k) x[n][k] = common / binomial;
        }
      }
    };
    static const Table table;
    return table.x[n][k];
  }

  static Signed_128 in_units(double x, int exponent) {
    int e;
    const std::int64_t mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &e), 53));
    const int shift = e - 53 - exponent;
    return shift <= -64 ? 0
           : shift < 0  ? Signed_128(mantissa >> -shift)
                        : Signed_128(mantissa) * (Signed_128(1) << shift);
  }

  // The least n with -2^n <= x < 2^n.
  template <int limbs> static int bits_of(const Fixed_integer<limbs>& x) {
    for (int i = limbs - 1; i >= 0; --i) {
      const std::uint64_t word = x.limb[i] ^ x.sign_mask();
      if (word != 0) return 64 * i + 64 - leading_zero_bits(word);
    }
    return 0;
  }
  // x 2^-n, rounded downwards, which must be less than 2^127
  template <int limbs> static Signed_128 shifted(const Fixed_integer<limbs>& x, int n) {
    // unreachable: protects memory; the types of these polynomials have a limb more
    const auto limb = [&](int i) { return i < limbs ? x.limb[i] : x.sign_mask(); };
    const int i = n / 64, bits = n % 64;
    std::uint64_t low = limb(i), high = limb(i + 1);
    if (bits > 0) {
      low = low >> bits | high << (64 - bits);
      high = high >> bits | limb(i + 2) << (64 - bits);
    }
    return static_cast<Signed_128>(static_cast<Unsigned_128>(high) << 64 | low);
  }
};

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_ROUNDED_POLYNOMIAL_H
