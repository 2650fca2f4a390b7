// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_UNREDUCED_FRACTION_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_UNREDUCED_FRACTION_H

#include <CGAL/Geometric_continuity/numbers/internal/Rational_parts.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The denominator d 2^k of fractions, d > 0 and odd. Powers of two are apart because those of
// doubles and of the formulas then cost a shift.
struct Unreduced_denominator {
  Inline_integer d = Inline_integer(1);
  long k = 0;

  Unreduced_denominator& operator*=(const Unreduced_denominator& e) {
    if (d.is_one())
      d = e.d;
    else if (!e.d.is_one())
      d *= e.d;
    k += e.k;
    return *this;
  }
};

// Two numerators are multiplied by these numbers when their fractions get a common denominator. It
// is the denominator that is a multiple of the other, or the product: no greatest common divisor is
// computed.
class Equal_denominators {
  struct Factor {
    Inline_integer d;
    long k = 0;
    bool is_one = true;

    void scale(Inline_integer& n) const {
      if (!is_one) n *= d;
      if (k != 0) n <<= k;
    }
  };
  Factor first_, second_;

public:
  // a becomes the common denominator
  Equal_denominators(Unreduced_denominator& a, const Unreduced_denominator& b) {
    // equivalent [< -> <=, 1]: a shift by nothing
    if (a.k < b.k) {
      first_.k = b.k - a.k;
      a.k = b.k;
    } else
      second_.k = a.k - b.k;
    const int order = compare_absolute(a.d, b.d);
    if (order == 0) return;
    if (order < 0 && divides(a.d, b.d, first_.d)) {
      first_.is_one = false;
      a.d = b.d;
    } else if (order > 0 && divides(b.d, a.d, second_.d))
      second_.is_one = false;
    else {
      first_.is_one = second_.is_one = false;
      first_.d = b.d;
      second_.d = a.d;
      a.d *= b.d;
    }
  }
  // n / a + m / b
  void add(Inline_integer& n, const Inline_integer& m) const {
    first_.scale(n);
    if (second_.is_one && second_.k == 0)
      n += m;
    else {
      Inline_integer t = m;
      second_.scale(t);
      n += t;
    }
  }
  void subtract(Inline_integer& n, const Inline_integer& m) const {
    n.negate();
    add(n, m);
    n.negate();
  }
};

// A rational number with the operations of a field that does not look for common divisors of
// numerator and denominator, which is most of the time of a construction on rational numbers. To be
// used for constructions of bounded length only, whose results are reduced once.
template <class Rational> class Unreduced_fraction {
  Inline_integer n_;
  Unreduced_denominator d_;

public:
  typedef Unreduced_denominator Denominator;

  Unreduced_fraction() = default;
  Unreduced_fraction(int x) : n_(x) {}
  Unreduced_fraction(Inline_integer n, Denominator d) : n_(std::move(n)), d_(std::move(d)) {}
  template <class T, class = std::enable_if_t<std::is_constructible_v<Rational, const T&>>>
  explicit Unreduced_fraction(const T& x) {
    Rational_parts<Rational>::split(Rational(x), n_, d_.d);
    d_.k = d_.d.remove_twos();
  }

  const Inline_integer& numerator() const { return n_; }
  const Denominator& denominator() const { return d_; }
  Rational reduced() const { return Rational_parts<Rational>::make(n_, d_.d, d_.k); }

  Unreduced_fraction& operator+=(const Unreduced_fraction& y) {
    const Equal_denominators c(d_, y.d_);
    c.add(n_, y.n_);
    return *this;
  }
  Unreduced_fraction& operator-=(const Unreduced_fraction& y) {
    const Equal_denominators c(d_, y.d_);
    c.subtract(n_, y.n_);
    return *this;
  }
  Unreduced_fraction& operator*=(const Unreduced_fraction& y) {
    n_ *= y.n_;
    d_ *= y.d_;
    return *this;
  }
  // y is not zero
  Unreduced_fraction& operator/=(const Unreduced_fraction& y) {
    Denominator m{y.n_, -y.d_.k};
    m.k += m.d.remove_twos();
    if (m.d.sign() < 0) {
      m.d.negate();
      n_.negate();
    }
    Inline_integer q;
    if (divides(y.d_.d, d_.d, q))
      d_.d = q;
    else
      n_ *= y.d_.d;
    d_ *= m;
    if (d_.d.size() > 10) *this = Unreduced_fraction(reduced());
    return *this;
  }

  friend Unreduced_fraction operator-(Unreduced_fraction x) {
    x.n_.negate();
    return x;
  }
  friend Unreduced_fraction operator+(Unreduced_fraction x, const Unreduced_fraction& y) {
    x += y;
    return x;
  }
  friend Unreduced_fraction operator-(Unreduced_fraction x, const Unreduced_fraction& y) {
    x -= y;
    return x;
  }
  friend Unreduced_fraction operator*(Unreduced_fraction x, const Unreduced_fraction& y) {
    x *= y;
    return x;
  }
  friend Unreduced_fraction operator/(Unreduced_fraction x, const Unreduced_fraction& y) {
    x /= y;
    return x;
  }
  friend bool operator==(const Unreduced_fraction& x, const Unreduced_fraction& y) { return (x - y).n_.is_zero(); }
  friend bool operator<(const Unreduced_fraction& x, const Unreduced_fraction& y) { return (x - y).n_.sign() < 0; }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_UNREDUCED_FRACTION_H
