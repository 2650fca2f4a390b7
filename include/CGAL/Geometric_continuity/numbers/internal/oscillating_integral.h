// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_OSCILLATING_INTEGRAL_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_OSCILLATING_INTEGRAL_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/numbers/internal/enclosing_arithmetic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

/// \file oscillating_integral.h
/// The displacement along a curve of which the curvature is known, for a length of 1: the integral
/// of \f$ e^{i \theta(w)} \f$ over [0, 1]. On a short piece it is a power series, and with
/// \f$ \theta' = \sum t_j w^j \f$ its coefficients are \f$ c_0 = 1 \f$ and
/// \f$ n c_n = i \sum_j t_j c_{n-1-j} \f$. By Cauchy's estimate \f$ |c_n| \le e^S R^{-n} \f$ for
/// each radius \f$ R \f$ and every bound \f$ S \f$ of \f$ |\theta| \f$ on the circle with this
/// radius; with \f$ R \ge 2 \f$ what is left out after \f$ N \f$ terms is at most
/// \f$ 2 e^S R^{-N} \f$.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class Number> struct Complex_number {
  Number re, im;

  friend Complex_number operator*(const Complex_number& x, const Complex_number& y) {
    return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
  }
  friend Complex_number operator+(const Complex_number& x, const Complex_number& y) {
    return {x.re + y.re, x.im + y.im};
  }
};

template <class Arithmetic>
Complex_number<typename Arithmetic::Number> unit_number(const Arithmetic& a, const typename Arithmetic::Number& angle) {
  const auto c = a.cosine_and_sine(angle);
  return {c.cosine, c.sine};
}

// The number of terms after which the rest is below 2^-accuracy, with the best of some radii.
// `bound(R)` is S.
template <class Bound_of_angle> int number_of_terms(int accuracy, const Bound_of_angle& bound) {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 1; k <= 8; ++k) least = (std::min)(least, (accuracy + 2 + 1.4427 * bound(std::ldexp(1., k))) / k);
  return static_cast<int>(std::ceil(least)) + 1;
}

// The integral of e^(i theta) over [0, 1], where theta' has the coefficients t, with as many terms.
template <class Arithmetic>
Complex_number<typename Arithmetic::Number>
integral_of_series(const Arithmetic& a, const std::vector<typename Arithmetic::Number>& t, int terms) {
  typedef typename Arithmetic::Number Number;
  a.charge(2. * terms * static_cast<double>((std::min)(t.size(), static_cast<std::size_t>(terms))));
  std::vector<Complex_number<Number>> c(1, {a(1), a(0)});
  Complex_number<Number> sum = c[0];
  for (int n = 1; n < terms; ++n) {
    Complex_number<Number> s{a(0), a(0)};
    const int used = (std::min)(n, static_cast<int>(t.size()));
    for (int j = 0; j < used; ++j) {
      const Complex_number<Number>& before = c[static_cast<std::size_t>(n - 1 - j)];
      s = {s.re - t[static_cast<std::size_t>(j)] * before.im, s.im + t[static_cast<std::size_t>(j)] * before.re};
    }
    c.push_back({s.re / n, s.im / n});
    sum = {sum.re + c.back().re / (n + 1), sum.im + c.back().im / (n + 1)};
  }
  const Number rest = a.symmetric(-a.accuracy());
  return {sum.re + rest, sum.im + rest};
}

// The derivative of the angle along a curve with the parameter w in [0, 1]:
// sum p_j w^j + c cos(pi w) + (s + r / (2 pi)) sin(2 pi w).
struct Angle_rate {
  std::vector<Rational> polynomial;
  Rational cosine = 0, sine = 0, sine_over_turn = 0;

  bool has_waves() const { return cosine != 0 || sine != 0 || sine_over_turn != 0; }
  bool is_zero() const {
    return !has_waves() && std::all_of(polynomial.begin(), polynomial.end(), [](const Rational& x) { return x == 0; });
  }
};

// The integral for one rate of the angle, piece by piece.
template <class Arithmetic> class Oscillating_integral {
  typedef typename Arithmetic::Number Number;
  typedef Complex_number<Number> Complex;

  const Arithmetic& a_;
  const Angle_rate& rate_;

  // theta(w) - theta(0) without the waves.
  Rational turn(const Rational& w) const {
    Rational sum(0);
    for (std::size_t j = rate_.polynomial.size(); j-- > 0;)
      sum = Rational(w * (Rational(rate_.polynomial[j] / Rational(static_cast<int>(j + 1))) + sum));
    return sum;
  }
  // The rest of it: c sin(pi w) / pi + (s + r / (2 pi)) (1 - cos(2 pi w)) / (2 pi).
  Number wave(const Rational& w) const {
    const Number pi = a_.pi(), x = pi * a_(w);
    const auto once = a_.cosine_and_sine(x), twice = a_.cosine_and_sine(Number(x * 2));
    return a_(rate_.cosine) * once.sine / pi +
           (a_(rate_.sine) + a_(rate_.sine_over_turn) / (2 * pi)) * (a_(1) - twice.cosine) / (2 * pi);
  }

  // Adds the coefficients of h amplitude f(a + h w) where f is cosine or sine with the frequency
  // omega pi, and its value and the one of its derivative / (omega pi) are given.
  void add_wave(std::vector<Number>& t, std::size_t terms, const Number& amplitude, const Number& step, Number value,
                Number derivative) const {
    if (t.size() < terms) t.resize(terms, a_(0));
    Number power = amplitude; // amplitude step^j / j!
    for (std::size_t j = 0; j < terms; ++j) {
      t[j] = t[j] + power * value;
      const Number next = -value;
      value = derivative;
      derivative = next;
      power = power * step / static_cast<int>(j + 1);
    }
  }

public:
  Oscillating_integral(const Arithmetic& a, const Angle_rate& rate) : a_(a), rate_(rate) {}

  // How many pieces are integrated one by one, each turned by about a radian at most; infinite for
  // what is refused.
  static double pieces(const Angle_rate& rate) {
    double sum = 0;
    for (const Rational& p : rate.polynomial) sum += std::fabs(CGAL::to_double(p));
    for (const Rational& p : {rate.cosine, rate.sine, rate.sine_over_turn}) sum += std::fabs(CGAL::to_double(p));
    return sum <= 20000 ? (std::max)(1., std::ceil(sum)) : std::numeric_limits<double>::infinity();
  }

  // Returns the integral with theta(0) = 0.
  Complex operator()() const {
    const double number = pieces(rate_);
    if (!std::isfinite(number))
      throw Error(Error_code::parameter_outside_domain,
                  "a piece of an alignment that turns by more than 20000 radians");
    const int n = static_cast<int>(number);
    Complex sum{a_(0), a_(0)};
    for (int i = 0; i < n; ++i) {
      const Rational start = Rational(Rational(i) / Rational(n));
      Complex part = piece(start, Rational(Rational(1) / Rational(n)));
      Number angle = a_(turn(start));
      if (rate_.has_waves() && i != 0) angle = angle + wave(start);
      if (i != 0) part = unit_number(a_, angle) * part;
      sum = sum + part;
    }
    return n == 1 ? sum : Complex{sum.re / n, sum.im / n};
  }

private:
  // The mean of e^(i (theta(a + h w) - theta(a))).
  Complex piece(const Rational& a, const Rational& h) const {
    // the polynomial at a + h w, by Horner's scheme again and again
    std::vector<Rational> p = rate_.polynomial;
    if (a != 0)
      for (std::size_t i = 0; i + 1 < p.size(); ++i)
        for (std::size_t j = p.size() - 1; j-- > i;) p[j] = Rational(p[j] + a * p[j + 1]);
    std::vector<Number> t;
    std::vector<double> sizes;
    Rational power = h;
    for (const Rational& x : p) {
      t.push_back(h == 1 ? a_(x) : a_(Rational(x * power)));
      if (h != 1) power = Rational(power * h);
      sizes.push_back(a_.magnitude(t.back()));
    }
    const double step = CGAL::to_double(h), once = std::fabs(CGAL::to_double(rate_.cosine)),
                 twice = std::fabs(CGAL::to_double(rate_.sine)) + std::fabs(CGAL::to_double(rate_.sine_over_turn));
    const int terms = number_of_terms(a_.accuracy(), [&](double radius) {
      double sum = 0, r = radius;
      for (std::size_t j = 0; j < sizes.size(); ++j, r *= radius) sum += sizes[j] * r / static_cast<double>(j + 1);
      const double x = step * radius; // |cos(pi z)| and |sin(pi z)| are at most cosh(pi |z|), and pi < 3.15
      return (sum + x * (once * std::cosh(3.15 * x) + twice * std::cosh(6.3 * x))) * (1 + 1e-9) +
             (once + twice) * 1e-9 * radius;
    });
    if (rate_.has_waves()) {
      const Number pi = a_.pi(), x = pi * a_(a), hn = a_(h);
      const auto one = a_.cosine_and_sine(x), two = a_.cosine_and_sine(Number(x * 2));
      const std::size_t n = static_cast<std::size_t>(terms);
      add_wave(t, n, a_(rate_.cosine) * hn, pi * hn, one.cosine, -one.sine);
      add_wave(t, n, (a_(rate_.sine) + a_(rate_.sine_over_turn) / (2 * pi)) * hn, 2 * (pi * hn), two.sine, two.cosine);
    }
    return integral_of_series(a_, t, terms);
  }
};

// Adds the charge of one integral and returns it.
template <class Arithmetic>
Complex_number<typename Arithmetic::Number> oscillating_integral(const Arithmetic& a, const Angle_rate& rate) {
  return Oscillating_integral<Arithmetic>(a, rate)();
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_OSCILLATING_INTEGRAL_H
