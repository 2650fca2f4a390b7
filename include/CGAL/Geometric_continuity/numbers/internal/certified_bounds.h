// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_CERTIFIED_BOUNDS_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_CERTIFIED_BOUNDS_H

#include <CGAL/Geometric_continuity/numbers/internal/Wide_integer.h>

#include <cmath>
#include <cstdint>
#include <limits>

/// \file certified_bounds.h
/// Floating-point numbers below and above a square root and an angle. The functions of the
/// processor and of the C++ library propose; integers of fixed length prove: a bound that is not
/// proved moves on to the next floating-point number. So the result holds in every rounding mode
/// and with every mathematical library.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A number mantissa 2^exponent, mantissa >= 0.
struct Binary_number {
  Wide_integer mantissa;
  int exponent;

  // A finite x >= 0: the mantissa is less than 2^53.
  static Binary_number of(double x) {
    int e;
    const double m = std::frexp(x, &e);
    return {Wide_integer(static_cast<std::int64_t>(std::ldexp(m, 53))), e - 53};
  }

  friend Binary_number operator*(const Binary_number& x, const Binary_number& y) {
    return {x.mantissa * y.mantissa, x.exponent + y.exponent};
  }
  friend bool operator<=(const Binary_number& x, const Binary_number& y) {
    if (x.mantissa.is_zero() || y.mantissa.is_zero()) return x.mantissa.is_zero();
    const int x_size = x.mantissa.bits() + x.exponent, y_size = y.mantissa.bits() + y.exponent;
    if (x_size != y_size) return x_size < y_size;
    const int shift = x.exponent - y.exponent; // to the length of the longer of the two mantissas
    return shift < 0 ? x.mantissa <= (y.mantissa << -shift) : (x.mantissa << shift) <= y.mantissa;
  }
};

inline double next_below(double x) { return std::nextafter(x, -(std::numeric_limits<double>::infinity)()); }
inline double next_above(double x) { return std::nextafter(x, (std::numeric_limits<double>::infinity)()); }

// The largest floating-point number that is not larger than sqrt(x), for a finite x >= 0, and the
// least that is not smaller.
inline double root_below(double x) {
  const Binary_number square = Binary_number::of(x);
  double root = std::sqrt(x);
  for (;; root = next_below(root)) {
    const Binary_number r = Binary_number::of(root);
    if (r * r <= square) return root;
  }
}
inline double root_above(double x) {
  const Binary_number square = Binary_number::of(x);
  double root = std::sqrt(x);
  for (;; root = next_above(root)) {
    const Binary_number r = Binary_number::of(root);
    if (square <= r * r) return root;
  }
}

// cos(a) and sin(a)/a for 0 <= a <= 3.2, given a^2 rounded downwards, all in units of 2^-w, w >=
// 120, wrong by less than `error` units.
//
// The terms a^2k / (2k)! are rounded downwards twice each, and so is a^2. With Y = a^2 <= 10.3 and
// terms of at most 5.2 their errors are e_0 = 0 and e_k <= (Y e_{k-1} + 7) / (2k (2k-1)) + 1: at
// most 5, 6, 4, 2, and less than 1.4 from then on. There are less than w/3 before the first that is
// 0, with which the alternating series is left: less than 40 for w = 120, and from there on a term
// is less than 2^-9 times the one before. So the error is less than 17 + 1.4 (w/3 - 4) + 3 for the
// cosine, and less than 1 more for each term of sin(a)/a, all of which are divided by 2k + 1.
template <class Integer> struct Cosine_and_sinc {
  const int error;
  Integer cosine, sinc;

  Cosine_and_sinc(const Integer& square, int w) : error(w + 8), cosine(Integer(1) << w), sinc(cosine) {
    Integer term = cosine;
    for (int k = 1; Integer(0) < term; ++k) {
      term *= square;
      term >>= w;
      term /= 2 * k * (2 * k - 1);
      if (k % 2 == 0) {
        cosine += term;
        sinc += term / (2 * k + 1);
      } else {
        cosine -= term;
        sinc -= term / (2 * k + 1);
      }
    }
  }
};

// An angle in [0, pi] that is given by the square of its tangent or its cotangent, which is finite.
struct Angle_of_square {
  enum Function { tangent, cotangent };

  Function function;
  bool obtuse; // in [pi/2, pi], otherwise in [0, pi/2]
  double square;

  // Near the angle, without a proof.
  double approximation() const {
    constexpr double pi = 3.141592653589793;
    const double x = std::atan(std::sqrt(square)), acute = function == tangent ? x : pi / 2 - x;
    return obtuse ? pi - acute : acute;
  }

  struct Order {
    bool not_larger, not_smaller; // what is proved about a number
  };

  // The order of a number in [0, 3.2] and the angle.
  Order operator()(double a) const {
    const Binary_number x = Binary_number::of(a), q = Binary_number::of(square);
    constexpr int bits = 120;
    const int shift = 2 * x.exponent + bits;
    const Wide_integer mantissa = x.mantissa * x.mantissa;
    const Cosine_and_sinc<Wide_integer> c(shift < 0 ? mantissa >> -shift : mantissa << shift, bits);
    const Wide_integer error(c.error);
    if (c.sinc < -error) return {false, true}; // a > pi
    const bool right_of_quarter = c.cosine < -error;
    // unreachable: no double is so near to a right angle
    if (!right_of_quarter && !(error < c.cosine)) return {false, false};
    if (right_of_quarter != obtuse) return {obtuse, !obtuse};
    const auto squared = [](const Wide_integer& y) {
      // unreachable: no double is so near to a multiple of a right angle
      return y < Wide_integer(0) ? Binary_number{Wide_integer(0), 0} : Binary_number{y * y, 0};
    };
    // |a| sin(a)/|a| and |cos(a)|, squared, from below and above, in the same units
    Binary_number sine_low = x * x * squared(abs(c.sinc) - error), sine_high = x * x * squared(abs(c.sinc) + error),
                  cosine_low = squared(abs(c.cosine) - error), cosine_high = squared(abs(c.cosine) + error);
    if (function == tangent) {
      cosine_low = cosine_low * q;
      cosine_high = cosine_high * q;
    } else {
      sine_low = sine_low * q;
      sine_high = sine_high * q;
    }
    const bool less_steep = sine_high <= cosine_low, steeper = cosine_high <= sine_low;
    return obtuse ? Order{steeper, less_steep} : Order{less_steep, steeper};
  }

  // Floating-point numbers that are certainly not larger and not smaller than the angle.
  double below() const {
    double a = approximation();
    while (0 < a && !(*this)(a).not_larger) a = next_below(a);
    return 0 < a ? a : 0;
  }
  double above() const {
    double a = approximation();
    while (!(*this)(a).not_smaller) a = next_above(a);
    return a;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_CERTIFIED_BOUNDS_H
