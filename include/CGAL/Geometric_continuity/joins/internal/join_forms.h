// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_FORMS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_FORMS_H

#include <CGAL/Geometric_continuity/numbers/internal/Fixed_integer.h>

#include <CGAL/Geometric_continuity/internal/force_inline.h>

#include <array>
#include <type_traits>

// The polynomials that decide a join, for every number type: field numbers, integers modulo 2^64,
// integers of fixed length, floating-point numbers, and the bounds of their errors. The differences
// of the polygons at the join are
//   a1 = p0 - p1,  a2 = p0 - 2 p1 + p2,  a3 = p0 - 3 p1 + 3 p2 - p3  of the left polygon ... p3 p2 p1 p0 of degree m,
//   b1 = q1 - q0,  b2 = q2 - 2 q1 + q0,  b3 = q3 - 3 q2 + 3 q1 - q0  of the right polygon q0 q1 q2 q3 ... of degree n.
// Where the tangents are parallel, (q, p) is a pair of numbers with p/q = b1/a1 and q not 0, e.g.
// (a1_0, b1_0).

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The type of the product of an X and a Y.
template <class X, class Y> struct Product_type {
  static_assert(std::is_same_v<X, Y>);
  typedef X type;
};
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
template <int m, int n, int most> struct Product_type<Fixed_integer<m, most>, Fixed_integer<n, most>> {
  typedef Fixed_product<m, n, most> type;
};
#endif
template <class X, class... Y> struct Product_of {
  typedef typename Product_type<X, typename Product_of<Y...>::type>::type type;
};
template <class X> struct Product_of<X> { typedef X type; };
template <class... X> using Product = typename Product_of<X...>::type;

// x w without a longer type; w is a small integer, or a factor of the same type
template <class T, class W> constexpr CGAL_GC_FORCEINLINE T scaled(const T& x, const W& w) { return T(x * T(w)); }

// The type of x w: longer when w is an integer of fixed length.
template <class T, class W> struct Scaled_type { typedef T type; };
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
template <int m, int n, int most>
CGAL_GC_FORCEINLINE Fixed_product<m, n, most> scaled(const Fixed_integer<m, most>& x, const Fixed_integer<n, most>& w) {
  return x * w;
}
template <int m, int n, int most> struct Scaled_type<Fixed_integer<m, most>, Fixed_integer<n, most>> {
  typedef Fixed_product<m, n, most> type;
};
#endif
template <class T, class W> using Scaled = typename Scaled_type<T, W>::type;

// Three differences in N coordinates. Vectors of two and three coordinates are written out: a loop
// that the compiler leaves as it is, or turns into other loads than stores, costs more than the
// arithmetic.
template <class T, int N> using Differences = std::array<std::array<T, N>, 3>;

// s x - t y
template <class S, class X>
constexpr CGAL_GC_FORCEINLINE Product<S, X> difference_form(const S& s, const X& x, const S& t, const X& y) {
  return Product<S, X>(Product<S, X>(s * x) - Product<S, X>(t * y));
}
// x_0 y_1 - x_1 y_0
template <class X, class Y>
constexpr CGAL_GC_FORCEINLINE Product<X, Y> parallel_form(const X& x0, const X& x1, const Y& y0, const Y& y1) {
  return difference_form(x0, y1, x1, y0);
}

template <class S, class X>
constexpr CGAL_GC_FORCEINLINE std::array<Product<S, X>, 2> difference_vector(const S& s, const std::array<X, 2>& x,
                                                                             const S& t, const std::array<X, 2>& y) {
  return {difference_form(s, x[0], t, y[0]), difference_form(s, x[1], t, y[1])};
}
template <class S, class X>
constexpr CGAL_GC_FORCEINLINE std::array<Product<S, X>, 3> difference_vector(const S& s, const std::array<X, 3>& x,
                                                                             const S& t, const std::array<X, 3>& y) {
  return {difference_form(s, x[0], t, y[0]), difference_form(s, x[1], t, y[1]), difference_form(s, x[2], t, y[2])};
}

template <class X, class Y>
constexpr CGAL_GC_FORCEINLINE Product<X, Y> dot_form(const std::array<X, 2>& x, const std::array<Y, 2>& y) {
  typedef Product<X, Y> P;
  return P(P(x[0] * y[0]) + P(x[1] * y[1]));
}
template <class X, class Y>
constexpr CGAL_GC_FORCEINLINE Product<X, Y> dot_form(const std::array<X, 3>& x, const std::array<Y, 3>& y) {
  typedef Product<X, Y> P;
  return P(P(P(x[0] * y[0]) + P(x[1] * y[1])) + P(x[2] * y[2]));
}

template <class X, class Y>
constexpr CGAL_GC_FORCEINLINE std::array<Product<X, Y>, 3> cross_form(const std::array<X, 3>& x,
                                                                      const std::array<Y, 3>& y) {
  return {parallel_form(x[1], x[2], y[1], y[2]), parallel_form(x[2], x[0], y[2], y[0]),
          parallel_form(x[0], x[1], y[0], y[1])};
}

template <class T>
constexpr CGAL_GC_FORCEINLINE std::array<T, 1> minus(const std::array<T, 1>& x, const std::array<T, 1>& y) {
  return {T(x[0] - y[0])};
}
template <class T>
constexpr CGAL_GC_FORCEINLINE std::array<T, 2> minus(const std::array<T, 2>& x, const std::array<T, 2>& y) {
  return {T(x[0] - y[0]), T(x[1] - y[1])};
}
template <class T>
constexpr CGAL_GC_FORCEINLINE std::array<T, 3> minus(const std::array<T, 3>& x, const std::array<T, 3>& y) {
  return {T(x[0] - y[0]), T(x[1] - y[1]), T(x[2] - y[2])};
}

// The vector of zeros, whatever a number is by default.
template <class T, int N> constexpr CGAL_GC_FORCEINLINE std::array<T, N> zero_vector() {
  if constexpr (N == 2)
    return {T(0), T(0)};
  else
    return {T(0), T(0), T(0)};
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_FORMS_H
