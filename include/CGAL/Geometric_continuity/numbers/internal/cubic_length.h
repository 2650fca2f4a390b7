// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_CUBIC_LENGTH_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_CUBIC_LENGTH_H

#include <CGAL/Geometric_continuity/numbers/internal/enclosing_arithmetic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// \file cubic_length.h
/// The arc length of planar parametric cubics, enclosed: the square \f$ q \f$ of the speed is a
/// polynomial of degree 4, and the Taylor series \f$ f \f$ of its root follows from
/// \f$ 2 f_0 f_n = q_n - \sum_{0 < j < n} f_j f_{n-j} \f$. The last coefficient over a whole piece
/// bounds what is left out.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

typedef std::array<Rational, 4> Cubic; // the coefficients of 1, t, t^2, t^3

inline Rational cubic_value(const Cubic& p, const Rational& t) {
  return Rational(p[0] + t * (p[1] + t * (p[2] + t * p[3])));
}
inline Rational first_derivative(const Cubic& p, const Rational& t) {
  return Rational(p[1] + t * (2 * p[2] + t * 3 * p[3]));
}
inline Rational second_derivative(const Cubic& p, const Rational& t) { return Rational(2 * p[2] + t * 6 * p[3]); }

// The square of the speed as a polynomial.
inline std::array<Rational, 5> squared_speed(const Cubic& u, const Cubic& v) {
  std::array<Rational, 5> q;
  for (std::size_t k = 0; k < 5; ++k) q[k] = 0;
  for (const Cubic* p : {&u, &v})
    for (int i = 1; i <= 3; ++i)
      for (int j = 1; j <= 3; ++j) {
        Rational& x = q[static_cast<std::size_t>(i + j - 2)];
        x = Rational(x + i * j * (*p)[static_cast<std::size_t>(i)] * (*p)[static_cast<std::size_t>(j)]);
      }
  return q;
}

template <class Arithmetic> class Cubic_length {
  typedef typename Arithmetic::Number Number;

  const Arithmetic& a_;
  const std::array<Rational, 5> square_;
  const int order_; // even
  double least_piece_ = 0;
  int pieces_ = 0;

  // The coefficients 0 to order_ of the root, from those of the square.
  std::vector<Number> root_series(const std::array<Number, 5>& q) const {
    a_.charge(order_ * order_ / 2.);
    std::vector<Number> f(1, a_.square_root(q[0]));
    const Number twice = f[0] * 2;
    for (int n = 1; n <= order_; ++n) {
      Number s = n < 5 ? q[static_cast<std::size_t>(n)] : a_(0);
      for (int j = 1; j < n; ++j) s = s - f[static_cast<std::size_t>(j)] * f[static_cast<std::size_t>(n - j)];
      f.push_back(s / twice);
    }
    return f;
  }

  Number over_piece(const Rational& from, const Rational& to) {
    ++pieces_;
    const Rational middle = Rational((from + to) / 2), half = Rational((to - from) / 2);
    std::array<Rational, 5> q = square_;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 4; j-- > i;) q[j] = Rational(q[j] + middle * q[j + 1]);
    const Number h = a_(half), x = a_.symmetric(0) * h;
    std::array<Number, 5> here, around; // at the middle, and everywhere in the piece
    static constexpr int binomial[5][5] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}};
    for (std::size_t k = 0; k < 5; ++k) {
      here[k] = a_(q[k]);
      around[k] = a_(0);
    }
    for (std::size_t k = 0; k < 5; ++k) {
      Number power = a_(1);
      for (std::size_t i = k; i < 5; ++i) {
        around[k] = around[k] + here[i] * power * binomial[i][k];
        power = power * x;
      }
    }
    if (!a_.contains_zero(around[0]) && !a_.contains_zero(here[0])) {
      const std::vector<Number> f = root_series(here), rest = root_series(around);
      const double size = CGAL::to_double(half);
      if (a_.magnitude(rest.back()) * std::pow(size, order_) < std::ldexp(a_.magnitude(f[0]), -a_.accuracy() + 4)) {
        Number sum = a_(0), power = h;
        for (int n = 0; n < order_; n += 2) {
          sum = sum + f[static_cast<std::size_t>(n)] * power / (n + 1);
          power = power * h * h;
        }
        return 2 * (sum + rest.back() * power * a_.symmetric(0) / (order_ + 1));
      }
    }
    if (CGAL::to_double(half) < least_piece_ || pieces_ > 20000) // near a stop
      return a_.hull(a_(0), a_.square_root(a_.absolute_value(around[0])) * h * 2);
    const Number first = over_piece(from, middle);
    return first + over_piece(middle, to);
  }

public:
  Cubic_length(const Arithmetic& a, const Cubic& u, const Cubic& v)
      : a_(a), square_(squared_speed(u, v)), order_(10 + (std::max)(0, a.accuracy() - 60) / 8 * 2) {}

  // \pre from <= to
  Number operator()(const Rational& from, const Rational& to) {
    if (from == to) return a_(0);
    least_piece_ = std::ldexp(CGAL::to_double(Rational(to - from)), -24);
    pieces_ = 0;
    return over_piece(from, to);
  }
};

// The parameter at which a graph (t, v(t)) has an arc length from t = 0: by Newton's iteration,
// proved because the speed is at least 1.
template <class Arithmetic>
typename Arithmetic::Number parameter_of_length(const Arithmetic& a, const Cubic& v, const Rational& length) {
  typedef typename Arithmetic::Number Number;
  const Cubic u = {Rational(0), Rational(1), Rational(0), Rational(0)};
  Cubic_length<Arithmetic> length_to(a, u, v);
  Rational low(0), high = length, t = length, best = length;
  Number error = a(length);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 200; ++i) {
    const Number e = length_to(Rational(0), t) - a(length);
    if (a.magnitude(e) < least) {
      least = a.magnitude(e);
      best = t;
      error = e;
    } else if (least < std::ldexp(CGAL::to_double(length), -40))
      break; // it does not become better
    (a.middle(e) > 0 ? high : low) = t;
    const double slope = CGAL::to_double(first_derivative(v, t));
    const int bits = a.accuracy() + 8;
    // rounded, so that the numbers stay short
    const Rational step = Rational(a.exact_middle(e) / Rational(std::sqrt(1 + slope * slope))),
                   next = Fixed_ball(Rational(t - step), bits).middle();
    t = low < next && next < high ? next : Rational((low + high) / 2);
  }
  return a(best) + a.symmetric(0) * a.absolute_value(error);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_CUBIC_LENGTH_H
