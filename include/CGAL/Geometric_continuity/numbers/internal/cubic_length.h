// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_CUBIC_LENGTH_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_CUBIC_LENGTH_H

#include <CGAL/Geometric_continuity/numbers/internal/enclosing_arithmetic.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

/// \file cubic_length.h
/// The arc length of planar parametric cubics, enclosed: the square \f$ q \f$ of the speed is a
/// polynomial of degree 4, and the Taylor series \f$ f \f$ of its root follows from
/// \f$ 2 f_0 f_n = q_n - \sum_{0 < j < n} f_j f_{n-j} \f$. On a piece with the half width \f$ h \f$ on
/// which \f$ q_0 > \sum_{k > 0} |q_k| (8h)^k \f$ the root is analytic in the circle with the radius
/// \f$ 8h \f$ and at most \f$ \sqrt{2 q_0} \f$ there. Then by Cauchy \f$ |f_n h^n| \f$ is at most
/// \f$ \sqrt{2 q_0}\, 8^{-n} \f$. Other pieces are halved.

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
  const int terms_; // 8^-terms < 2^-accuracy
  double least_piece_ = 0;
  int pieces_ = 0;

  // The integral of the root over [-1, 1].
  Number integral_of_root(const std::array<Number, 5>& q) const {
    a_.charge(terms_ * terms_ / 2.);
    std::vector<Number> f(1, a_.square_root(q[0]));
    const Number twice = f[0] * 2;
    Number sum = f[0];
    for (int n = 1; n < terms_; ++n) {
      Number s = n < 5 ? q[static_cast<std::size_t>(n)] : a_(0);
      for (int j = 1; j < n; ++j) s = s - f[static_cast<std::size_t>(j)] * f[static_cast<std::size_t>(n - j)];
      f.push_back(s / twice);
      if (n % 2 == 0) sum = sum + f.back() / (n + 1);
    }
    return 2 * (sum + twice * a_.symmetric(-a_.accuracy()));
  }

  Number over_piece(const Rational& from, const Rational& to) {
    ++pieces_;
    a_.charge(20);
    const Rational middle = Rational((from + to) / 2), half = Rational((to - from) / 2);
    std::array<Rational, 5> q = square_; // at middle + half w
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 4; j-- > i;) q[j] = Rational(q[j] + middle * q[j + 1]);
    std::array<Number, 5> here;
    double rest = 0;
    Rational power(1);
    for (std::size_t k = 0; k < 5; ++k) {
      here[k] = a_(Rational(q[k] * power));
      if (k > 0) rest += std::ldexp(a_.magnitude(here[k]), 3 * static_cast<int>(k));
      power = Rational(power * half);
    }
    if (rest < CGAL::to_double(q[0]) * (1 - 1e-9) && !a_.contains_zero(here[0]))
      return a_(half) * integral_of_root(here);
    if (CGAL::to_double(half) < least_piece_ || pieces_ > 2000) { // near a stop
      Number largest = a_(0);
      for (const Number& x : here) largest = largest + a_.absolute_value(x);
      return a_.hull(a_(0), a_.square_root(largest) * a_(half) * 2);
    }
    const Number first = over_piece(from, middle);
    return first + over_piece(middle, to);
  }

public:
  Cubic_length(const Arithmetic& a, const Cubic& u, const Cubic& v)
      : a_(a), square_(squared_speed(u, v)), terms_(a.accuracy() / 3 + 1) {}

  // \pre from <= to
  Number operator()(const Rational& from, const Rational& to) {
    if (from == to) return a_(0);
    least_piece_ = std::ldexp(CGAL::to_double(Rational(to - from)), -24);
    pieces_ = 0;
    return over_piece(from, to);
  }
};

// A parameter at which a graph (t, v(t)) has about an arc length from t = 0, and the error of that
// length there: by Newton's iteration from a parameter in [0, length], which stays there.
template <class Arithmetic>
std::pair<Rational, typename Arithmetic::Number> near_parameter(const Arithmetic& a, const Cubic& v,
                                                                const Rational& length, Rational t) {
  typedef typename Arithmetic::Number Number;
  Cubic_length<Arithmetic> length_to(a, {Rational(0), Rational(1), Rational(0), Rational(0)}, v);
  std::pair<Rational, Number> best(t, a(length));
  Rational low(0), high = length;
  for (int i = 0; i < 100; ++i) {
    const Number error = length_to(Rational(0), t) - a(length);
    if (i == 0 || a.magnitude(error) < a.magnitude(best.second))
      best = {t, error};
    else if (a.magnitude(best.second) < std::ldexp(CGAL::to_double(length), -40))
      break; // it does not become better
    (a.middle(error) > 0 ? high : low) = t;
    const Rational before = t;
    const double speed = std::hypot(1., CGAL::to_double(first_derivative(v, t)));
    t = Rational((low + high) / 2);
    if (!(std::isfinite(speed) && std::isfinite(a.middle(error)))) continue;
    const Rational step = Rational(a.exact_middle(error) / Rational(speed)),
                   next = Fixed_ball(Rational(before - step), a.accuracy() + 8).middle(); // few digits
    if (low < next && next < high) t = next;
  }
  return best;
}

// The parameter at which a graph has an arc length: the speed is at least 1, so that the parameter
// is not farther away than the length.
template <class Arithmetic>
typename Arithmetic::Number parameter_of_length(const Arithmetic& a, const Cubic& v, const Rational& length) {
  Rational start;
  {
    const Protect_FPU_rounding<true> upwards;
    start = near_parameter(Interval_arithmetic(), v, length, length).first;
  }
  const auto near = near_parameter(a, v, length, start);
  return a(near.first) + a.symmetric(0) * a.absolute_value(near.second);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_CUBIC_LENGTH_H
