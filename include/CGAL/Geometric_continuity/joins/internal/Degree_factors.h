// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DEGREE_FACTORS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DEGREE_FACTORS_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_question.h>
#include <CGAL/Geometric_continuity/joins/internal/join_forms.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The integer factors of the geometric forms in the differences a_k of a polygon of degree m and
// b_k of one of degree n, to which the derivatives are proportional: x^(k) = m!/(m-k)! a_k / h^k.
// After the linear substitutions that make the first derivatives a_1 and b_1, x'' = (m-1)/m a_2 and
// x''' = (m-1)(m-2)/m^2 a_3; a common denominator gives the factors
//   a2 : b2 = (m-1)/m : (n-1)/n                        of the second derivatives,
//   a3 : b3 = (m-1)(m-2)/m^2 : (n-1)(n-2)/n^2          of the third derivatives, for the torsion (m-2)/m : (n-2)/n,
//   mix                                                of 3 beta_2 x'' in G3, in units of a3 and of the form for G2.
template <class W> struct Degree_factors {
  static constexpr bool parametric = false, rational = false;
  W a2, b2, a3, b3, mix;

  // `one` is that of a ring, if W does not tell.
  template <Join_question question>
  static CGAL_GC_FORCEINLINE Degree_factors geometric(int m, int n, const W& one = W(1)) {
    constexpr bool third = highest_difference(question) >= 3;
    const int m1 = (std::max)(m - 1, 0), n1 = (std::max)(n - 1, 0), m2 = (std::max)(m - 2, 0),
              n2 = (std::max)(n - 2, 0);
    if (m == n) {
      const bool mixed = question == Join_question::g3; // those below divided by m^2 (m-1)
      return {W(1), W(1), W(mixed ? m2 : 1), W(mixed ? m2 : 1), mixed ? W(W(3) * W(m1)) : W(1)};
    }
    const W a2(W(one * W(n)) * W(m1)), b2(W(one * W(m)) * W(n1));
    if constexpr (!third)
      return {a2, b2, W(1), W(1), W(1)};
    else {
      const W a3(W(one * W(n)) * W(m2)), b3(W(one * W(m)) * W(n2));
      if constexpr (question == Join_question::torsion)
        return {a2, b2, a3, b3, W(1)};
      else
        return {a2, b2, W(a2 * a3), W(b2 * b3), W(W(3) * a2)};
    }
  }
};

// The factors of the differences 1 to 3 for C^k, for domains whose lengths are as h to l.
template <class W> struct Parametric_degree_factors {
  static constexpr bool parametric = true, rational = false;
  W a1, b1, a2, b2, a3, b3;

  static CGAL_GC_FORCEINLINE Parametric_degree_factors of(int m, int n, const W& h, const W& l) {
    const W a1(W(m) * l), a2(W(a1 * W((std::max)(m - 1, 0))) * l), a3(W(a2 * W((std::max)(m - 2, 0))) * l);
    const W b1(W(n) * h), b2(W(b1 * W((std::max)(n - 1, 0))) * h), b3(W(b2 * W((std::max)(n - 2, 0))) * h);
    return {a1, b1, a2, b2, a3, b3};
  }
};

template <Join_question question, class W>
using Degree_factors_of = std::conditional_t<is_parametric(question), Parametric_degree_factors<W>, Degree_factors<W>>;

template <class V, class W> CGAL_GC_FORCEINLINE Degree_factors<V> converted(const Degree_factors<W>& w) {
  return {V(w.a2), V(w.b2), V(w.a3), V(w.b3), V(w.mix)};
}
template <class V, class W>
CGAL_GC_FORCEINLINE Parametric_degree_factors<V> converted(const Parametric_degree_factors<W>& w) {
  return {V(w.a1), V(w.b1), V(w.a2), V(w.b2), V(w.a3), V(w.b3)};
}

// Returns whether the factors are at most 2^40: exact as doubles, and with room for 20 bits more.
template <int k> CGAL_GC_FORCEINLINE bool weights_fit(const Parametric_degree_factors<std::int64_t>& w) {
  std::int64_t largest = (std::max)(w.a1, w.b1);
  if (k >= 2) largest = (std::max)(largest, (std::max)(w.a2, w.b2));
  if (k >= 3) largest = (std::max)(largest, (std::max)(w.a3, w.b3));
  return largest <= std::int64_t(1) << 40;
}

// Integers of fixed length allow factors below these.
template <Join_question question> constexpr Degree_factors<std::int64_t> factor_limits() {
  constexpr std::int64_t second = std::int64_t(1) << 19,
                         third = std::int64_t(1) << (question == Join_question::torsion ? 19 : 28),
                         mixed = std::int64_t(1) << 16;
  return {second, second, third, third, mixed};
}

// Returns whether the factors that a question needs are below their limits.
template <Join_question question> CGAL_GC_FORCEINLINE bool factors_fit(const Degree_factors<std::int64_t>& w) {
  constexpr Degree_factors<std::int64_t> limits = factor_limits<question>();
  return highest_difference(question) < 2 ||
         ((w.a2 | w.b2) < limits.a2 && (w.a3 | w.b3) < limits.a3 && w.mix < limits.mix);
}

// The end of a rational Bezier curve of degree m from its end point b_0 inwards, in the differences
// D_i = b_i - b_0. Divided by (1-t)^m, numerator and denominator are polynomials of s = t/(1-t),
//
//   x - b_0 = sum_i e_i s^i / sum_i d_i s^i,  e_i = C(m, i) w_i/w_0 D_i,  d_i = C(m, i) w_i/w_0,
//
// and in the parameter r with s = r + d_1/2 r^2 + ..., whose third coefficient removes a multiple
// of e_1, this is
//
//   x - b_0 = e_1 r + (e_2 - d_1/2 e_1) r^2 + e_3 r^3 + ...
//
// With r in units of w_0 / (m w_1) the derivatives are, up to a change of the parameter,
//
//   x' = D_1,       x'' = alpha D_2 - D_1,   x''' = gamma D_3,
//   alpha = (m-1)/m w_0 w_2 / w_1^2,   gamma = (m-1)(m-2)/m^2 w_0^2 w_3 / w_1^3.
//
// So geometric continuity, curvature and torsion are decided by the equations of polynomials, with
// these differences and with factors into which the weights enter. In x'' the multiple of D_1
// counts in G3 only. Weights w_i c^i in place of w_i change nothing.
//
// From a common denominator, with beta and delta on the right (degree n, weights v_i) and all
// factors of one power of a product of w_1 and v_1,
//   a2 : b2 : first = alpha : beta : 1     of the second derivatives,
//   a3 : b3         = gamma : delta        of the third ones; for the torsion gamma/alpha : delta/beta,
//   mix             = 3 alpha              in G3, in units of a3 and of the form for G2.
// X is the type of the weights, of which products have longer types.
template <Join_question question, class X> struct Weighted_degree_factors {
  typedef Product<X, X, X, X> Second;
  typedef std::conditional_t<question == Join_question::g3, Product<X, X, X, Second>,
                             std::conditional_t<question == Join_question::f3, Product<X, X, Second>, Second>>
      Third;
  typedef Product<X, X, X> Mix;
  static constexpr bool parametric = false, rational = true;

  Second a2, b2, first;
  Third a3, b3;
  Mix mix;

  // From the weights w of the left end and v of the right one, as many as the question needs.
  static CGAL_GC_FORCEINLINE Weighted_degree_factors of(const std::array<X, 4>& w, int m, const std::array<X, 4>& v,
                                                        int n) {
    typedef Product<X, X> Square;
    const int m1 = (std::max)(m - 1, 0), n1 = (std::max)(n - 1, 0), m2 = (std::max)(m - 2, 0),
              n2 = (std::max)(n - 2, 0);
    Weighted_degree_factors f{};
    if constexpr (question == Join_question::torsion) {
      f.a3 = times(Second(Square(w[0] * w[3]) * Square(v[1] * v[2])), n, m2);
      f.b3 = times(Second(Square(v[0] * v[3]) * Square(w[1] * w[2])), m, n2);
    } else {
      const Square ww = Square(w[1] * w[1]), vv = Square(v[1] * v[1]), w02 = Square(w[0] * w[2]),
                   v02 = Square(v[0] * v[2]);
      f.a2 = Second(w02 * vv);
      f.b2 = Second(v02 * ww);
      if (question != Join_question::g2 || m != n) { // else the factor is common
        f.a2 = times(f.a2, n, m1);
        f.b2 = times(f.b2, m, n1);
      }
      if constexpr (highest_difference(question) >= 3) {
        const Mix w003 = Mix(Square(w[0] * w[0]) * w[3]), v003 = Mix(Square(v[0] * v[0]) * v[3]);
        if constexpr (question == Join_question::f3) {
          f.a3 = times(times(Third(w003 * Mix(vv * v[1])), n, n), m1, m2);
          f.b3 = times(times(Third(v003 * Mix(ww * w[1])), m, m), n1, n2);
        } else {
          f.first = times(Second(ww * vv), m, n);
          f.a3 = times(times(Third(w003 * Second(Square(w[1] * v[1]) * vv)), n, n), m1, m2);
          f.b3 = times(times(Third(v003 * Second(ww * ww)), m, m), n1, n2);
          f.mix = times(times(Mix(w02 * v[1]), n, m1), 3, 1);
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

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DEGREE_FACTORS_H
