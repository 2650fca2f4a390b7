// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_TAYLOR_MODEL_H
#define CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_TAYLOR_MODEL_H

#include <CGAL/Geometric_continuity/numbers/internal/interval_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

/// \file Taylor_model.h
/// Functions on a range by a polynomial and a bound of what it leaves out: differences of functions
/// that nearly agree keep their digits, where intervals would lose all. (Makino, Berz: Taylor
/// models and other validated functional inclusion methods, 2003.)

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

typedef Interval_nt<false> Interval;

// The functions f on [-1, 1] with |f(s) - (c_0 + c_1 s + ... + c_7 s^7)| <= r. When r is infinite
// or not a number nothing is known.
//
// Coefficients are rounded in any mode, by less than e = 2^-52 of each result; what all roundings
// of an operation come to is added to r. The sums of numbers that are not negative, of which r is
// made, are less than 2^-44 too small relatively, whatever the mode, and are enlarged by that.
struct Taylor_model {
  static constexpr int size = 8;
  static constexpr double epsilon = 0x1p-52, tiny = 1e-300 /* more than all underflow */, enlarged = 1 + 0x1p-44,
                          // with which sums and quotients of intervals are still finite
      largest = 1e300;
  std::array<double, size> c{};
  double r = 0;

  Taylor_model() = default;
  Taylor_model(double constant) { c[0] = constant; }
  static Taylor_model unknown() {
    Taylor_model f;
    f.r = (std::numeric_limits<double>::infinity)();
    return f;
  }

  bool known() const { return r <= largest; }
  // Bounds the absolute value of the polynomial.
  double norm() const {
    double sum = 0;
    for (double x : c) sum += std::fabs(x);
    return sum;
  }

  friend Taylor_model operator-(Taylor_model x) {
    for (double& y : x.c) y = -y;
    return x;
  }
  friend Taylor_model operator+(const Taylor_model& x, const Taylor_model& y) {
    Taylor_model z;
    for (int k = 0; k < size; ++k) z.c[k] = x.c[k] + y.c[k];
    z.r = (x.r + y.r + z.norm() * epsilon) * enlarged;
    return z;
  }
  friend Taylor_model operator-(const Taylor_model& x, const Taylor_model& y) {
    Taylor_model z;
    for (int k = 0; k < size; ++k) z.c[k] = x.c[k] - y.c[k];
    z.r = (x.r + y.r + z.norm() * epsilon) * enlarged;
    return z;
  }
  // Each coefficient is a sum of at most 8 products: at most 9 e of the sum of their magnitudes are
  // rounded off. Products of the degrees 8 to 14 are bounded by their magnitudes.
  friend Taylor_model operator*(const Taylor_model& x, const Taylor_model& y) {
    Taylor_model z;
    for (int i = 0; i < size; ++i)
      for (int j = 0; i + j < size; ++j) z.c[i + j] += x.c[i] * y.c[j];
    double x_norm = std::fabs(x.c[0]), y_tail = 0, above = 0;
    for (int i = 1; i < size; ++i) {
      y_tail += std::fabs(y.c[size - i]);
      above += std::fabs(x.c[i]) * y_tail;
      x_norm += std::fabs(x.c[i]);
    }
    const double y_norm = y_tail + std::fabs(y.c[0]);
    z.r = (above + x_norm * y.r + x.r * (y_norm + y.r) + x_norm * y_norm * (9 * epsilon) + tiny) * enlarged;
    return z;
  }

  // Encloses the values.
  Interval range() const;
  // Encloses the value at the parameters in a subset of [-1, 1].
  Interval operator()(const Interval& s) const {
    if (!known()) return Interval::largest();
    Interval y = c[size - 1];
    for (int k = size - 2; k >= 0; --k) y = y * s + Interval(c[k]);
    return y + symmetric(r);
  }
};

// The coefficients of 35 * 3 = 105 times s^k in the Bernstein polynomials of degree 7 on [-1, 1]:
// with s = t - (1 - t), sum over i of (-1)^(k-i) (k over i) (7-k over j-i) / (7 over j) for the
// j-th.
inline const std::array<std::array<double, Taylor_model::size>, Taylor_model::size>& bernstein_of_powers() {
  constexpr int n = Taylor_model::size;
  typedef std::array<std::array<double, n>, n> Matrix;
  static const Matrix matrix = [] {
    const auto choose = [](int a, int b) {
      double c = b < 0 || b > a ? 0 : 1;
      for (int i = 0; i < b && c != 0; ++i) c = c * (a - i) / (i + 1);
      return c;
    };
    Matrix m;
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j) {
        double sum = 0;
        for (int i = 0; i <= k; ++i) sum += ((k - i) % 2 ? -1 : 1) * choose(k, i) * choose(n - 1 - k, j - i);
        m[k][j] = sum * (105 / choose(n - 1, j)); // an integer, as 7, 21 and 35 divide 105
      }
    return m;
  }();
  return matrix;
}

// The range of a polynomial lies between its smallest and its largest Bernstein coefficient.
inline Interval Taylor_model::range() const {
  if (!known() || !(norm() <= largest)) return Interval::largest();
  const auto& m = bernstein_of_powers();
  double lower = c[0], upper = c[0];
  std::array<double, size> b{};
  for (int k = 0; k < size; ++k)
    for (int j = 0; j < size; ++j) b[j] += m[k][j] * c[k];
  // |entries| <= 105: the sums of 8 products are wrong by at most 9 e 105 norm, the quotients by e
  // norm more
  lower = upper = b[0] / 105;
  for (double x : b) {
    lower = (std::min)(lower, x / 105);
    upper = (std::max)(upper, x / 105);
  }
  return Interval(lower, upper) + symmetric((r + norm() * (10 * epsilon) + tiny) * enlarged);
}

// The terms of a long sum with factors that are given by intervals, and all of its rounding errors.
class Taylor_sum {
  Taylor_model f_;
  double magnitudes_ = 0;
  int terms_ = 0;

public:
  // Adds a multiple of x, of which the norm is known, and whose coefficients below `from` are zero.
  void add(const Interval& factor, const Taylor_model& x, double norm, int from = 0) {
    if (is_exact_zero(factor)) return;
    const double m = factor.inf() / 2 + factor.sup() / 2,
                 radius = (std::max)(factor.sup() - m, m - factor.inf()) * Taylor_model::enlarged;
    for (int k = from; k < Taylor_model::size; ++k) f_.c[k] += m * x.c[k];
    magnitudes_ += std::fabs(m) * norm;
    f_.r += radius * norm + (std::fabs(m) + radius) * x.r;
    ++terms_;
  }
  // In all partial sums, and products, the sum of the magnitudes bounds the coefficients.
  Taylor_model value() const {
    Taylor_model f = f_;
    f.r = (f_.r + magnitudes_ * ((terms_ + 1) * Taylor_model::epsilon) + Taylor_model::tiny * (terms_ > 0)) *
          Taylor_model::enlarged;
    return f;
  }
};

// 1/x or 1/sqrt(x). The series p of the polynomial of x is computed without care; then with e = p
// x - 1 or p^2 x - 1 and |e| <= 1/2
// |1/x - p| = |p| |1/(1+e) - 1| <= 2 |p| |e| and |1/sqrt(x) - p| = |p| |1/sqrt(1+e) -
// 1| <= |p| |e|, as x > 0 where p^2 x > 0.
inline Taylor_model reciprocal(const Taylor_model& x) {
  constexpr int n = Taylor_model::size;
  if (!x.known() || x.c[0] == 0) return Taylor_model::unknown();
  Taylor_model p(1 / x.c[0]);
  for (int k = 1; k < n; ++k) {
    double sum = 0;
    for (int j = 1; j <= k; ++j) sum += x.c[j] * p.c[k - j];
    p.c[k] = -sum * p.c[0];
  }
  const double e = magnitude((p * x - Taylor_model(1)).range());
  if (!(e <= 0.5)) return Taylor_model::unknown();
  p.r = 2 * p.norm() * e * Taylor_model::enlarged;
  return p;
}
inline Taylor_model reciprocal_root(const Taylor_model& x) { // p' x = -p x' / 2
  constexpr int n = Taylor_model::size;
  if (!x.known() || !(x.c[0] > 0)) return Taylor_model::unknown();
  Taylor_model p(1 / std::sqrt(x.c[0]));
  for (int k = 1; k < n; ++k) {
    double sum = 0;
    for (int j = 1; j <= k; ++j) sum += (0.5 * j + (k - j)) * x.c[j] * p.c[k - j];
    p.c[k] = -sum / (k * x.c[0]);
  }
  const double e = magnitude((p * p * x - Taylor_model(1)).range());
  if (!(e <= 0.5)) return Taylor_model::unknown();
  p.r = p.norm() * e * Taylor_model::enlarged;
  return p;
}

typedef std::array<Taylor_model, 3> Taylor_vector;

inline Taylor_model dot(const Taylor_vector& x, const Taylor_vector& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
inline Taylor_vector cross(const Taylor_vector& x, const Taylor_vector& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}
inline Taylor_vector operator-(const Taylor_vector& x, const Taylor_vector& y) {
  return {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
}
inline Taylor_vector operator*(const Taylor_vector& x, const Taylor_model& y) { return {x[0] * y, x[1] * y, x[2] * y}; }

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_TAYLOR_MODEL_H
