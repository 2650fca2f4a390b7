// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_RATIONAL_JOIN_WEIGHTS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_RATIONAL_JOIN_WEIGHTS_H

#include <CGAL/Geometric_continuity/joins/internal/End_polygon.h>
#include <CGAL/Geometric_continuity/joins/internal/join_forms.h>

#include <CGAL/Geometric_continuity/internal/force_inline.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The end of a rational Bezier curve of degree m from its end point b_0 inwards, in the differences D_i = b_i - b_0. Divided by
// (1-t)^m, numerator and denominator are polynomials of s = t/(1-t),
//
//   x - b_0 = sum_i e_i s^i / sum_i d_i s^i,  e_i = C(m, i) w_i/w_0 D_i,  d_i = C(m, i) w_i/w_0,
//
// and in the parameter r with s = r + d_1/2 r^2 + ..., whose third coefficient removes a multiple of e_1, this is
//
//   x - b_0 = e_1 r + (e_2 - d_1/2 e_1) r^2 + e_3 r^3 + ...
//
// With r in units of w_0 / (m w_1) the derivatives are, up to a change of the parameter,
//
//   x' = D_1,       x'' = alpha D_2 - D_1,   x''' = gamma D_3,
//   alpha = (m-1)/m w_0 w_2 / w_1^2,   gamma = (m-1)(m-2)/m^2 w_0^2 w_3 / w_1^3.
//
// So geometric continuity, curvature and torsion are decided by the equations of polynomials, with these differences and with factors
// into which the weights enter. In x'' the multiple of D_1 counts in G3 only. Weights w_i c^i in place of w_i change nothing.
//
// From a common denominator, with beta and delta on the right (degree n, weights v_i) and all factors of one power of a product of
// w_1 and v_1,
//   a2 : b2 : first = alpha : beta : 1     of the second derivatives,
//   a3 : b3         = gamma : delta        of the third ones; for the torsion gamma/alpha : delta/beta,
//   mix             = 3 alpha              in G3, in units of a3 and of the form for G2.
// X is the type of the weights, of which products have longer types.
template <Join_question question, class X> struct Rational_join_weights {
  typedef Product<X, X, X, X> Second;
  typedef std::conditional_t<question == Join_question::g3, Product<X, X, X, Second>,
                             std::conditional_t<question == Join_question::f3, Product<X, X, Second>, Second>>
      Third;
  typedef Product<X, X, X> Mix;
  static constexpr bool rational = true;

  Second a2, b2, first;
  Third a3, b3;
  Mix mix;

  // From the weights w of the left end and v of the right one, as many as the question needs.
  static CGAL_GC_FORCEINLINE Rational_join_weights of(const std::array<X, 4>& w, int m, const std::array<X, 4>& v,
                                                      int n) {
    typedef Product<X, X> Square;
    const int m1 = (std::max)(m - 1, 0), n1 = (std::max)(n - 1, 0), m2 = (std::max)(m - 2, 0),
              n2 = (std::max)(n - 2, 0);
    Rational_join_weights f{};
    if constexpr (question == Join_question::torsion) {
      f.a3 = times(Second(Square(w[0] * w[3]) * Square(v[1] * v[2])), n, m2);
      f.b3 = times(Second(Square(v[0] * v[3]) * Square(w[1] * w[2])), m, n2);
    } else {
      const Square ww = Square(w[1] * w[1]), vv = Square(v[1] * v[1]), w02 = Square(w[0] * w[2]),
                   v02 = Square(v[0] * v[2]);
      f.a2 = times(Second(w02 * vv), n, m1);
      f.b2 = times(Second(v02 * ww), m, n1);
      if constexpr (highest_difference(question) >= 3) {
        const Mix w003 = Mix(Square(w[0] * w[0]) * w[3]), v003 = Mix(Square(v[0] * v[0]) * v[3]);
        if constexpr (question == Join_question::f3) {
          f.a3 = times(times(Third(w003 * Mix(vv * v[1])), n, n), m1, m2);
          f.b3 = times(times(Third(v003 * Mix(ww * w[1])), m, m), n1, n2);
        } else {
          f.first = times(Second(ww * vv), m, n);
          f.a3 = times(times(Third(w003 * Second(Square(w[1] * v[1]) * vv)), n, n), m1, m2);
          f.b3 = times(times(Third(v003 * Second(ww * ww)), m, m), n1, n2);
          f.mix = times(Mix(w02 * v[1]), 3 * n, m1);
        }
      }
    }
    return f;
  }

  // How many weights of the left and of the right end are factors of each term of a form.
  static constexpr int left_degree(Join_question form) { return form == Join_question::g3 ? 4 : right_degree(form); }
  static constexpr int right_degree(Join_question form) {
    return form == Join_question::g3 || form == Join_question::f3 ? 3 : 2;
  }

private:
  // x i j, without a longer type
  template <class T> static CGAL_GC_FORCEINLINE T times(const T& x, int i, int j) { return scaled(scaled(x, i), j); }
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  template <int limbs, int most>
  static CGAL_GC_FORCEINLINE Fixed_integer<limbs, most> times(const Fixed_integer<limbs, most>& x, int i, int j) {
    return scaled(x, static_cast<std::int64_t>(i) * j);
  }
#endif
};

// The differences b_i - b_0 from the end point inwards, in the direction of the curve, for k = 1, 2, 3.
template <int k, bool left, class T, std::size_t N>
CGAL_GC_FORCEINLINE Differences<T, N> fan_of(const std::array<std::array<T, N>, 4>& x) {
  Differences<T, N> d{};
  d[0] = left ? internal::minus(x[0], x[1]) : internal::minus(x[1], x[0]);
  if constexpr (k >= 2) d[1] = internal::minus(x[2], x[0]);
  if constexpr (k >= 3) d[2] = left ? internal::minus(x[0], x[3]) : internal::minus(x[3], x[0]);
  return d;
}

// Bounds of these.
template <int k, std::size_t N>
CGAL_GC_FORCEINLINE Difference_bounds bounds_of_fan(const std::array<std::array<double, N>, 3>& d) {
  const double first = largest(d[0]), second = k >= 2 ? (std::max)(first, largest(d[1])) : first;
  return {first, second, k >= 3 ? (std::max)(second, largest(d[2])) : second};
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_RATIONAL_JOIN_WEIGHTS_H
