// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_EQUATIONS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_EQUATIONS_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/internal/Degree_factors.h>
#include <CGAL/Geometric_continuity/joins/internal/join_forms.h>

#include <array>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The powers of a pair (q, p) with p/q = b1_0/a1_0. Products have longer types.
template <class T> struct Join_ratio {
  typedef Product<T, T> Square;
  typedef Product<T, T, T> Cube;
  T q, p;
  constexpr CGAL_GC_FORCEINLINE Square square(const T& x) const { return Square(x * x); }
  constexpr CGAL_GC_FORCEINLINE Cube cube(const T& x) const { return Cube(square(x) * x); }
  template <class V, class W>
  constexpr CGAL_GC_FORCEINLINE Scaled<Product<V, T>, W> p_times(const V& v, const W& w) const {
    return scaled(Product<V, T>(v * p), w);
  }
};

// Tells if an exact number is zero.
template <class T> struct Exact_zero {
  static constexpr bool exact = true;
  template <class X> bool operator()(Join_question, const X& x) const {
    if constexpr (std::is_same_v<X, T>)
      return bool(x == T(0));
    else
      return is_zero(x);
  }
};

// The residue of a number that is known to be smaller than the modulus.
struct Modular_zero {
  static constexpr bool exact = false;
  template <class X> bool operator()(Join_question, const X& x) const { return is_zero(x); }
};

// The equations of the join of two polygons with nonzero first differences. `Zero` says whether the
// value of a form may be zero: with exact numbers whether it is; otherwise only `false` is a proof.
//
// The first coordinate of a1 is the pivot: it does not vanish, unless the question is parametric.
// Therefore only the two coordinates of x times a1 = 0 that contain x_0 need be tested.
template <class T, int N, class Weights, class Zero> class Join_equations {
  typedef std::array<T, N> Vector;
  const Vector &a1, &a2, &a3, &b1, &b2, &b3;
  const Weights& w;
  Zero& zero;

public:
  typedef Join_ratio<T> Ratio;

  constexpr CGAL_GC_FORCEINLINE Join_equations(const Differences<T, N>& a, const Differences<T, N>& b,
                                               const Weights& weights, Zero& z)
      : a1(a[0]), a2(a[1]), a3(a[2]), b1(b[0]), b2(b[1]), b3(b[2]), w(weights), zero(z) {}

  // (q, p)
  constexpr CGAL_GC_FORCEINLINE Ratio ratio() const { return {a1[0], b1[0]}; }

  // The k-th derivatives are equal.
  template <int k> constexpr CGAL_GC_FORCEINLINE bool derivatives_equal() const {
    if constexpr (k == 1)
      return is_zero_vector(Join_question::c1, difference_vector(T(w.a1), a1, T(w.b1), b1));
    else if constexpr (k == 2)
      return is_zero_vector(Join_question::c2, difference_vector(T(w.a2), a2, T(w.b2), b2));
    else
      return is_zero_vector(Join_question::c3, difference_vector(T(w.a3), a3, T(w.b3), b3));
  }

  // b1 is a multiple of a1.
  constexpr CGAL_GC_FORCEINLINE bool tangents_parallel() const { return is_parallel(Join_question::g1, b1); }

  // The condition for G2 besides G1: V = q^2 b2 - p^2 a2 is a multiple of a1.
  constexpr CGAL_GC_FORCEINLINE bool g2(const Ratio& r) const {
    typedef Scaled<typename Ratio::Square, decltype(w.b2)> Square;
    const Square x = scaled(r.square(r.q), w.b2), y = scaled(r.square(r.p), w.a2);
    // short products first
    return zero(Join_question::g2, difference_form(x, beside_tangent(b2, 1), y, beside_tangent(a2, 1))) &&
           (N == 2 ||
            zero(Join_question::g2, difference_form(x, beside_tangent(b2, N - 1), y, beside_tangent(a2, N - 1))));
  }

  // The condition for G3 besides G2: q^3 a1_0 b3 - p^3 a1_0 a3 - 3 p V_0 a2 is a multiple of a1,
  // where beta_2 is V_0 / (q^2 a1_0). The second derivatives of rational curves have -b1 and +a1
  // added, so V has -(q^2 p + p^2 q).
  constexpr CGAL_GC_FORCEINLINE bool g3(const Ratio& r) const {
    typedef typename Ratio::Square Square;
    typedef Product<Scaled<typename Ratio::Cube, decltype(w.b3)>, T> Fourth;
    typedef Product<Scaled<Square, decltype(w.b2)>, T> Third;
    const Fourth x = Fourth(scaled(r.cube(r.q), w.b3) * a1[0]), y = Fourth(scaled(r.cube(r.p), w.a3) * a1[0]);
    Third v = difference_form(scaled(r.square(r.q), w.b2), b2[0], scaled(r.square(r.p), w.a2), a2[0]);
    if constexpr (Weights::rational) v = Third(v - Third(scaled(Square(r.q * r.p), w.first) * T(r.q + r.p)));
    const Fourth z = r.p_times(v, w.mix);
    return is_parallel(Join_question::g3, internal::minus(difference_vector(x, b3, y, a3), multiplied(z, a2)));
  }

  // The condition for F3 besides G2: q^3 b3 - p^3 a3 lies in the span of a1 and a2, which has the
  // normal n = a1 x a2; when this is zero, in that of a1.
  constexpr CGAL_GC_FORCEINLINE bool f3(const Ratio& r) const {
    typedef Scaled<typename Ratio::Cube, decltype(w.b3)> Cube;
    const Cube x = scaled(r.cube(r.q), w.b3), y = scaled(r.cube(r.p), w.a3);
    const std::array<Product<T, T>, 3> n = cross_form(a1, a2);
    if constexpr (Zero::exact)
      if (is_zero_vector(Join_question::f3, n)) return is_parallel(Join_question::f3, difference_vector(x, b3, y, a3));
    return zero(Join_question::f3, difference_form(x, dot_form(n, b3), y, dot_form(n, a3)));
  }

  // Not for parallel tangents only: K = (g a2 - (a1.a2) a1) / g^2 with g = a1.a1, and the same of b
  // on the right.
  constexpr CGAL_GC_FORCEINLINE bool curvature_vectors_equal() const {
    typedef Product<T, T> Second;
    typedef Product<Second, Second> Fourth;
    typedef Scaled<Fourth, decltype(w.b2)> Factor;
    const Second g = dot_form(a1, a1), h = dot_form(b1, b1);
    const Factor x = scaled(Fourth(h * h), w.a2), y = scaled(Fourth(g * g), w.b2);
    return is_zero_vector(Join_question::curvature_vector,
                          difference_vector(x, difference_vector(g, a2, dot_form(a1, a2), a1), y,
                                            difference_vector(h, b2, dot_form(b1, b2), b1)));
  }

  // (n.a3) / n.n is the torsion, with n = a1 x a2. \pre neither normal is zero; a proof of `false`
  // holds without
  constexpr CGAL_GC_FORCEINLINE bool torsions_equal() const {
    const std::array<Product<T, T>, 3> n = cross_form(a1, a2), o = cross_form(b1, b2);
    return zero(Join_question::torsion, difference_form(scaled(dot_form(n, a3), w.a3), dot_form(o, o),
                                                        scaled(dot_form(o, b3), w.b3), dot_form(n, n)));
  }

  constexpr CGAL_GC_FORCEINLINE bool left_has_curvature() const {
    return !is_zero_vector(Join_question::g2, cross_form(a1, a2));
  }
  constexpr CGAL_GC_FORCEINLINE bool right_has_curvature() const {
    return !is_zero_vector(Join_question::g2, cross_form(b1, b2));
  }
  constexpr CGAL_GC_FORCEINLINE bool both_have_curvature() const {
    return left_has_curvature() && right_has_curvature();
  }

private:
  template <class X>
  constexpr CGAL_GC_FORCEINLINE bool is_zero_vector(Join_question form, const std::array<X, N>& v) const {
    if constexpr (N == 2)
      return zero(form, v[0]) && zero(form, v[1]);
    else
      return zero(form, v[0]) && zero(form, v[1]) && zero(form, v[2]);
  }

  // A coordinate of v times a1, of which two tell whether v is a multiple of a1.
  constexpr CGAL_GC_FORCEINLINE Product<T, T> beside_tangent(const Vector& v, int i) const {
    return parallel_form(v[0], v[i], a1[0], a1[i]);
  }

  template <class X>
  constexpr CGAL_GC_FORCEINLINE bool is_parallel(Join_question form, const std::array<X, N>& v) const {
    if constexpr (N == 2)
      return zero(form, parallel_form(v[0], v[1], a1[0], a1[1]));
    else
      return zero(form, parallel_form(v[0], v[1], a1[0], a1[1])) && zero(form, parallel_form(v[0], v[2], a1[0], a1[2]));
  }

  template <class X>
  static constexpr CGAL_GC_FORCEINLINE std::array<Product<X, T>, N> multiplied(const X& x, const Vector& v) {
    if constexpr (N == 2)
      return {Product<X, T>(x * v[0]), Product<X, T>(x * v[1])};
    else
      return {Product<X, T>(x * v[0]), Product<X, T>(x * v[1]), Product<X, T>(x * v[2])};
  }
};

// All equations of one question; the geometric ones ask whether the tangents are parallel first.
template <Join_question question, class Equations> constexpr CGAL_GC_FORCEINLINE bool all_hold(const Equations& e) {
  if constexpr (is_parametric(question)) {
    if constexpr (highest_difference(question) >= 2)
      if (!e.template derivatives_equal<2>()) return false;
    if constexpr (highest_difference(question) >= 3)
      if (!e.template derivatives_equal<3>()) return false;
    return e.template derivatives_equal<1>();
  } else if constexpr (question == Join_question::curvature_vector)
    return e.curvature_vectors_equal();
  else if constexpr (question == Join_question::torsion)
    return e.torsions_equal();
  else {
    if (!e.tangents_parallel()) return false;
    const typename Equations::Ratio r = e.ratio();
    if constexpr (highest_difference(question) >= 2)
      if (!e.g2(r)) return false;
    if constexpr (question == Join_question::g3)
      if (!e.g3(r)) return false;
    if constexpr (question == Join_question::f3)
      if (!e.f3(r)) return false;
    return true;
  }
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_EQUATIONS_H
