// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_ENCLOSING_ARITHMETIC_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_ENCLOSING_ARITHMETIC_H

#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Fixed_ball.h>
#include <CGAL/Geometric_continuity/numbers/internal/interval_functions.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

/// \file enclosing_arithmetic.h
/// Two arithmetics in which one text encloses real numbers: intervals of floating-point numbers,
/// and integers with a radius of as many bits as are wanted. Both have sine, cosine and the angle
/// of a vector.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// \pre rounding is upwards, as in the scope of `Protect_FPU_rounding`
struct Interval_arithmetic {
  typedef Interval_nt<false> Number;

  // Remainders below 2^-accuracy do not matter.
  static constexpr int accuracy() { return 60; }
  static void charge(double) {}

  Number operator()(const Rational& x) const { return Interval_nt<false>(exact_interval(x)); }
  Number operator()(int x) const { return Interval_nt<false>(x); }
  static Number symmetric(int exponent) { return internal::symmetric(std::ldexp(1., exponent)); }
  static Number hull(const Number& lower, const Number& upper) { return Interval_nt<false>(lower.inf(), upper.sup()); }
  static double magnitude(const Number& x) { return internal::magnitude(x); }
  static bool contains_zero(const Number& x) { return x.inf() <= 0 && 0 <= x.sup(); }
  static bool is_negative(const Number& x) { return x.sup() < 0; }
  static double middle(const Number& x) { return x.inf() / 2 + x.sup() / 2; }
  static Rational exact_middle(const Number& x) { return Rational(middle(x)); }
  static Number pi() { return Interval_nt<false>(0x1.921fb54442d18p+1, 0x1.921fb54442d19p+1); }
  static Cosine_and_sine cosine_and_sine(const Number& x) { return internal::cosine_and_sine(x); }
  static Number square_root(const Number& x) {
    return CGAL::sqrt(Interval_nt<false>((std::max)(x.inf(), 0.), x.sup()));
  }
  static Number absolute_value(const Number& x) { return CGAL::abs(x); }

  static Enclosure enclosure(const Number& x) { return {x.inf(), x.sup()}; }
  static Verdict at_most(const Number& x, const Rational& bound) {
    if (!(std::isfinite(x.inf()) && std::isfinite(x.sup()))) return Verdict::undecided;
    const std::pair<double, double> b = exact_interval(bound); // of which most decide
    if (x.sup() <= b.first) return Verdict::proved;
    return b.second < x.inf() ? Verdict::refuted : Verdict::undecided;
  }
};

class Ball_arithmetic {
  static constexpr int guard = 48; // bits of the largest multiples of pi/2

  int bits_;
  Fixed_ball long_pi_, pi_;

  // Machin: pi = 16 atan(1/5) - 4 atan(1/239).
  static Fixed_ball machin(int bits) {
    const auto arc_tangent = [&](int n) { // of 1/n
      Fixed_ball power = Fixed_ball(Rational(1), bits) / n, sum = power;
      for (int k = 3; k <= bits + 3; k += 2) { // the first term that is left out is below 4^-k
        power = power / (n * n);
        sum = k % 4 == 3 ? sum - power / k : sum + power / k;
      }
      return sum + Fixed_ball::symmetric(-bits, bits);
    };
    return arc_tangent(5) * 16 - arc_tangent(239) * 4;
  }

public:
  typedef Fixed_ball Number;
  struct Two {
    Number cosine, sine;
  };

  explicit Ball_arithmetic(int bits) : bits_(bits), long_pi_(machin(bits + guard)), pi_(long_pi_.with_bits(bits)) {}

  // Returns how many bits are right: 16 bits are for the rounding errors of sums.
  int accuracy() const { return bits_ - 16; }
  // Takes note of as many products, each with the radius and the memory that it needs.
  void charge(double products) const {
    const std::size_t words = static_cast<std::size_t>(bits_ / 64 + 1);
    work_meter().charge_products(5 * products, words);
    work_meter().charge_sums(60 * products, words);
  }

  Number operator()(const Rational& x) const { return Fixed_ball(x, bits_); }
  Number operator()(int x) const { return Fixed_ball(Rational(x), bits_); }
  Number symmetric(int exponent) const { return Fixed_ball::symmetric(exponent, bits_); }
  static Number hull(const Number& lower, const Number& upper) { return Fixed_ball::hull(lower, upper); }
  static double magnitude(const Number& x) { return exact_interval(x.absolute_value().upper()).second; }
  static bool contains_zero(const Number& x) { return x.contains_zero(); }
  static bool is_negative(const Number& x) { return x.is_negative(); }
  static double middle(const Number& x) { return CGAL::to_double(x.middle()); }
  static Rational exact_middle(const Number& x) { return x.middle(); }
  const Number& pi() const { return pi_; }
  static Number square_root(const Number& x) { return x.square_root(); }
  static Number absolute_value(const Number& x) { return x.absolute_value(); }

  // Reduced by a multiple of pi/2 that is close to it, |y| < 2^1.3, then the series of Taylor.
  Two cosine_and_sine(const Number& x) const {
    charge(2. * bits_ / 8);
    const Number half_pi = long_pi_ / 2, longer = x.with_bits(bits_ + guard);
    const Fixed_ball::Integer n = (longer / half_pi + Fixed_ball(Rational(1), bits_ + guard) / 2).near_integer();
    const Number y = (longer - Fixed_ball(Rational(n), bits_ + guard) * half_pi).with_bits(bits_), square = y * y;
    if (!(magnitude(y) < 2.4)) return {symmetric(0), symmetric(0)}; // a ball too wide to tell anything
    int terms = 2;                                                  // |y|^terms / terms! < 2^-bits
    for (double size = 1.6; size > -bits_; ++terms) size += 1.3 - std::log2(terms + 1);
    Number cosine = (*this)(1), sine = cosine;
    for (int k = terms + terms % 2; k >= 2; k -= 2) {
      cosine = (*this)(1) - square * cosine / ((k - 1) * k);
      sine = (*this)(1) - square * sine / (k * (k + 1));
    }
    cosine = cosine + symmetric(-bits_);
    sine = y * (sine + symmetric(-bits_));
    const Fixed_ball::Integer four(4), quarter(n % four);
    switch ((static_cast<int>(CGAL::to_double(quarter)) + 4) % 4) {
    case 0: return {cosine, sine};
    case 1: return {-sine, cosine};
    case 2: return {-cosine, -sine};
    default: return {sine, -cosine};
    }
  }

  static Enclosure enclosure(const Number& x) {
    return {exact_interval(x.lower()).first, exact_interval(x.upper()).second};
  }
  static Verdict at_most(const Number& x, const Rational& bound) {
    if (!(bound < x.upper())) return Verdict::proved;
    return bound < x.lower() ? Verdict::refuted : Verdict::undecided;
  }
};

// The arc tangent of a number in [-1.5, 1.5]: it is halved by atan x = 2 atan(x / (1 + sqrt(1 +
// x^2))) until |x| < 1/16, and then |x|^k < 2^-4k.
template <class Arithmetic>
typename Arithmetic::Number arc_tangent(const Arithmetic& a, typename Arithmetic::Number x) {
  typedef typename Arithmetic::Number Number;
  for (int i = 0; i < 4; ++i) x = x / (a(1) + a.square_root(a(1) + x * x));
  const Number square = x * x;
  int k = 1;
  while (4 * k < a.accuracy()) k += 2;
  Number sum = a(0);
  for (; k >= 1; k -= 2) sum = a(1) / k - square * sum;
  return 16 * (x * sum + a.symmetric(-a.accuracy()));
}

// The angle of the vector (x, y), in [-pi, pi] up to a little. Everything that is possible when the
// vector may be zero.
template <class Arithmetic>
typename Arithmetic::Number angle_of_vector(const Arithmetic& a, const typename Arithmetic::Number& x,
                                            const typename Arithmetic::Number& y) {
  typedef typename Arithmetic::Number Number;
  a.charge(a.accuracy() / 4.);
  const Number pi = a.pi();
  const bool flat = std::fabs(a.middle(y)) <= std::fabs(a.middle(x));
  const Number &divisor = flat ? x : y, &dividend = flat ? y : x;
  if (a.contains_zero(divisor)) return a.hull(-pi, pi);
  const Number tangent = dividend / divisor;
  if (!(a.magnitude(tangent) < 1.5)) return a.hull(-pi, pi);
  const Number t = arc_tangent(a, tangent);
  if (!flat) return a.is_negative(y) ? -(pi / 2) - t : pi / 2 - t;
  return !a.is_negative(x) ? t : a.middle(y) < 0 ? t - pi : t + pi;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_ENCLOSING_ARITHMETIC_H
