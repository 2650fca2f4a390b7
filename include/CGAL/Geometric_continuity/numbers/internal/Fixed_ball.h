// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_FIXED_BALL_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_FIXED_BALL_H

#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <CGAL/Fraction_traits.h>

/// \file Fixed_ball.h
/// Enclosures of real numbers of any precision: a middle and a radius, both integers in units of
/// \f$ 2^{-bits} \f$. A product and a quotient are wrong by less than two units besides the radii
/// of what is multiplied.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The rational numbers in which alignments are given.
typedef Exact_field<double>::type Rational;

class Fixed_ball {
public:
  typedef CGAL::Fraction_traits<Rational>::Numerator_type Integer;

private:
  Integer middle_{0}, radius_{0};
  int bits_ = 0;

  Fixed_ball(const Integer& middle, const Integer& radius, int bits) : middle_(middle), radius_(radius), bits_(bits) {}

  static Integer shifted(const Integer& x, int by) { // rounded in some direction
    Integer y(x);
    if (by >= 0)
      y <<= by;
    else
      y >>= -by;
    return y;
  }
  static Integer absolute(const Integer& x) { return x < 0 ? Integer(-x) : x; }
  bool is_zero() const { return middle_ == 0 && radius_ == 0; }

public:
  Fixed_ball() = default;
  // Encloses a rational number.
  Fixed_ball(const Rational& x, int bits) : bits_(bits) {
    typedef CGAL::Fraction_traits<Rational> Fraction;
    Integer numerator, denominator;
    Fraction::Decompose()(x, numerator, denominator);
    numerator <<= bits;
    middle_ = Integer(numerator / denominator);
    radius_ = Integer(middle_ * denominator) == numerator ? 0 : 1;
  }
  // [-2^exponent, 2^exponent], or a larger one.
  static Fixed_ball symmetric(int exponent, int bits) {
    return {Integer(0), exponent + bits < 0 ? Integer(1) : shifted(Integer(1), exponent + bits), bits};
  }
  // A number in [lower, upper].
  static Fixed_ball hull(const Fixed_ball& lower, const Fixed_ball& upper) {
    const Integer a(lower.middle_ - lower.radius_), b(upper.middle_ + upper.radius_), m = shifted(Integer(a + b), -1);
    return {m, Integer(absolute(Integer(b - m)) + absolute(Integer(m - a))), lower.bits_};
  }

  int bits() const { return bits_; }
  // A bound below and above, exactly.
  Rational lower() const { return scaled(Integer(middle_ - radius_)); }
  Rational upper() const { return scaled(Integer(middle_ + radius_)); }
  Rational middle() const { return scaled(middle_); }
  bool contains_zero() const { return !(radius_ < absolute(middle_)); }
  bool is_positive() const { return radius_ < middle_; }
  bool is_negative() const { return middle_ < 0 && !contains_zero(); }
  // The middle rounded to an integer, up to one.
  Integer near_integer() const { return shifted(middle_, -bits_); }
  // Other units.
  Fixed_ball with_bits(int bits) const {
    if (bits >= bits_) return {shifted(middle_, bits - bits_), shifted(radius_, bits - bits_), bits};
    return {shifted(middle_, bits - bits_), Integer(shifted(radius_, bits - bits_) + 2), bits};
  }

  friend Fixed_ball operator-(const Fixed_ball& x) { return {Integer(-x.middle_), x.radius_, x.bits_}; }
  friend Fixed_ball operator+(const Fixed_ball& x, const Fixed_ball& y) {
    return {Integer(x.middle_ + y.middle_), Integer(x.radius_ + y.radius_), x.bits_};
  }
  friend Fixed_ball operator-(const Fixed_ball& x, const Fixed_ball& y) {
    return {Integer(x.middle_ - y.middle_), Integer(x.radius_ + y.radius_), x.bits_};
  }
  friend Fixed_ball operator*(const Fixed_ball& x, const Fixed_ball& y) {
    if (x.is_zero() || y.is_zero()) return {Integer(0), Integer(0), x.bits_};
    const Integer error(absolute(x.middle_) * y.radius_ + absolute(y.middle_) * x.radius_ + x.radius_ * y.radius_);
    return {shifted(Integer(x.middle_ * y.middle_), -x.bits_), Integer(shifted(error, -x.bits_) + 2), x.bits_};
  }
  // \pre zero is not in y
  friend Fixed_ball operator/(const Fixed_ball& x, const Fixed_ball& y) {
    if (x.is_zero()) return x;
    const Integer quotient(shifted(x.middle_, x.bits_) / y.middle_);
    const Integer error(shifted(x.radius_, x.bits_) + Integer(absolute(quotient) + 1) * y.radius_);
    return {quotient, Integer(error / Integer(absolute(y.middle_) - y.radius_) + 2), x.bits_};
  }
  friend Fixed_ball operator*(const Fixed_ball& x, int k) {
    return {Integer(x.middle_ * k), Integer(x.radius_ * (k < 0 ? -k : k)), x.bits_};
  }
  friend Fixed_ball operator*(int k, const Fixed_ball& x) { return x * k; }
  // \pre k > 0
  friend Fixed_ball operator/(const Fixed_ball& x, int k) {
    if (x.is_zero()) return x;
    return {Integer(x.middle_ / k), Integer(x.radius_ / k + 2), x.bits_};
  }

  // The square root of a number that is not negative, of which the ball may say less.
  Fixed_ball square_root() const {
    const auto root = [&](const Integer& y) {
      return y > 0 ? integer_square_root_below(shifted(y, bits_)) : Integer(0);
    };
    const Integer a = root(Integer(middle_ - radius_)), b(root(Integer(middle_ + radius_)) + (is_zero() ? 0 : 1));
    const Integer m = shifted(Integer(a + b), -1);
    return {m, Integer(Integer(b - m) + 1), bits_};
  }
  Fixed_ball absolute_value() const {
    if (!contains_zero()) return {absolute(middle_), radius_, bits_};
    const Integer b(absolute(middle_) + radius_), m = shifted(b, -1);
    return {m, Integer(b - m), bits_};
  }

private:
  Rational scaled(const Integer& x) const { return Rational(Rational(x) / Rational(shifted(Integer(1), bits_))); }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_FIXED_BALL_H
