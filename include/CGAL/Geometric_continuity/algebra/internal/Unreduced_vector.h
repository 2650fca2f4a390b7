// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_UNREDUCED_VECTOR_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_UNREDUCED_VECTOR_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/numbers/internal/Unreduced_fraction.h>

#include <boost/operators.hpp>

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

// A vector of unreduced fractions has one denominator. This is a specialisation of a public
// template, and so it must stand in the namespace of the template; it is internal like its number
// type.
template <class Rational, int N>
class Coordinate_vector<internal::Unreduced_fraction<Rational>, N>
    : boost::additive<Coordinate_vector<internal::Unreduced_fraction<Rational>, N>>,
      boost::multiplicative<Coordinate_vector<internal::Unreduced_fraction<Rational>, N>,
                            internal::Unreduced_fraction<Rational>> {
  typedef internal::Unreduced_fraction<Rational> FT;
  typedef internal::Inline_integer Integer;
  template <class T> using Per_coordinate = std::conditional_t<N == 0, std::vector<T>, std::array<T, N>>;

  Per_coordinate<Integer> n_;
  typename FT::Denominator d_;

public:
  Coordinate_vector() = default;
  explicit Coordinate_vector(int d) {
    if constexpr (N == 0) n_.resize(d);
  }

  // Clears the denominators: the least common denominator.
  explicit Coordinate_vector(const Coordinate_vector<Rational, N>& v) : Coordinate_vector(v.dimension()) {
    const int n = dimension();
    Per_coordinate<typename FT::Denominator> d;
    if constexpr (N == 0) d.resize(n);
    for (int i = 0; i < n; ++i) {
      internal::Rational_parts<Rational>::split(v[i], n_[i], d[i].d);
      d[i].k = d[i].d.remove_twos();
      d_.k = (std::max)(d_.k, d[i].k);
      if (d[i].d != d_.d) d_.d *= quotient(d[i].d, gcd_of_odd(d_.d, d[i].d));
    }
    for (int i = 0; i < n; ++i) {
      if (d[i].k != d_.k) n_[i] <<= d_.k - d[i].k;
      if (d[i].d != d_.d) n_[i] *= quotient(d_.d, d[i].d);
    }
  }

  Coordinate_vector<Rational, N> reduced() const {
    Coordinate_vector<Rational, N> v;
    if constexpr (N == 0) v = Coordinate_vector<Rational, N>(dimension());
    for (int i = 0; i < dimension(); ++i) v[i] = internal::Rational_parts<Rational>::make(n_[i], d_.d, d_.k);
    return v;
  }

  int dimension() const { return static_cast<int>(n_.size()); }
  FT operator[](int i) const { return FT(n_[i], d_); }

  Coordinate_vector& operator+=(const Coordinate_vector& v) {
    const internal::Equal_denominators c(d_, v.d_);
    for (int i = 0; i < dimension(); ++i) c.add(n_[i], v.n_[i]);
    return *this;
  }
  Coordinate_vector& operator-=(const Coordinate_vector& v) {
    const internal::Equal_denominators c(d_, v.d_);
    for (int i = 0; i < dimension(); ++i) c.subtract(n_[i], v.n_[i]);
    return *this;
  }
  // A common divisor of a long scalar is divided out before it gets into all coordinates.
  Coordinate_vector& operator*=(const FT& s) {
    if (s.denominator().d.size() > 3) return scale(FT(s.reduced()));
    return scale(s);
  }
  Coordinate_vector& operator/=(const FT& s) { return *this *= FT(1) / s; }

  friend FT dot(const Coordinate_vector& v, const Coordinate_vector& w) {
    Integer sum;
    for (int i = 0; i < v.dimension(); ++i) sum += v.n_[i] * w.n_[i];
    typename FT::Denominator d = v.d_;
    d *= w.d_;
    return FT(sum, d);
  }
  friend bool is_zero(const Coordinate_vector& v) {
    return std::all_of(v.n_.begin(), v.n_.end(), [](const Integer& n) { return n.is_zero(); });
  }

private:
  static Integer quotient(const Integer& x, const Integer& divisor) {
    Integer q;
    divides(divisor, x, q);
    return q;
  }
  Coordinate_vector& scale(const FT& s) {
    if (!s.numerator().is_one())
      for (Integer& n : n_) n *= s.numerator();
    d_ *= s.denominator();
    return *this;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_UNREDUCED_VECTOR_H
