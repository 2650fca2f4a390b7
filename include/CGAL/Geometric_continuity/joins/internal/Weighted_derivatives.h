// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_WEIGHTED_DERIVATIVES_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_WEIGHTED_DERIVATIVES_H

#include <CGAL/Geometric_continuity/joins/internal/End_polygon.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_equations.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_filter.h>

#include <algorithm>
#include <array>
#include <cmath>

// The end of a rational Bezier curve of degree m from its end point b_0 inwards, in the differences D_i = b_i - b_0. Divided by
// (1-t)^m, numerator and denominator are polynomials of s = t/(1-t),
//
//   x - b_0 = sum_i e_i s^i / sum_i d_i s^i,  e_i = C(m, i) w_i/w_0 D_i,  d_i = C(m, i) w_i/w_0,
//
// and in the parameter r with s = r + d_1 r^2 + ..., whose third coefficient removes a multiple of e_1, this is
//
//   x - b_0 = e_1 r + e_2 r^2 + (e_3 + d_1 e_2) r^3 + ...
//
// With r in units of w_0 / (m w_1) the derivatives are, up to a change of the parameter,
//
//   x' = D_1,       x'' = alpha D_2,   x''' = gamma D_3 + 3 alpha D_2,
//   alpha = (m-1)/m w_0 w_2 / w_1^2,   gamma = (m-1)(m-2)/m^2 w_0^2 w_3 / w_1^3,
//
// and in units of 1 / (m w_1^2) of those, without fractions, what is computed here. Geometric continuity, curvature and torsion
// do not depend on the parameter.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class T, int N> struct Weighted_derivatives {
  // From the points and weights 0 to k. Those beyond the degree have the factor 0. The bounds are those of the derivatives before
  // anything cancels.
  template <int k>
  static Differences<T, N> of(const End_polygon<T, N>& x, const std::array<T, 4>& w, int degree,
                              std::array<T, 3>* bounds = nullptr) {
    const T m(degree), m1((std::max)(degree - 1, 0)), m2((std::max)(degree - 2, 0)), first = T(m * T(w[1] * w[1]));
    Differences<T, N> d{};
    d[0] = times(first, internal::minus(x[1], x[0]));
    if (bounds) (*bounds)[0] = size(d[0]);
    if constexpr (k >= 2) {
      const T second = T(T(first * m1) * T(w[0] * w[2]));
      const std::array<T, N> leg = internal::minus(x[2], x[0]);
      d[1] = times(second, leg);
      if (bounds) (*bounds)[1] = size(d[1]);
      if constexpr (k >= 3) {
        const T third = T(T(T(first * w[1]) * T(m1 * m2)) * T(T(w[0] * w[0]) * w[3])),
                mixed = T(T(T(3) * first) * second);
        const std::array<T, N> y = times(third, internal::minus(x[3], x[0])), z = times(mixed, leg);
        for (int i = 0; i < N; ++i) d[2][i] = T(y[i] + z[i]);
        if (bounds) (*bounds)[2] = T(size(y) + size(z));
      }
    }
    return d;
  }

private:
  static std::array<T, N> times(const T& s, std::array<T, N> x) {
    for (T& xi : x) xi = T(s * xi);
    return x;
  }
  static T size(const std::array<T, N>& x) {
    T largest(0);
    for (const T& xi : x) {
      if (largest < xi) largest = xi;
      if (largest < -xi) largest = T(-xi);
    }
    return largest;
  }
};

// Of the curve that runs in the other direction.
template <int k, class T, std::size_t N> std::array<std::array<T, N>, 3> backwards(std::array<std::array<T, N>, 3> d) {
  for (int j = 0; j < k; j += 2)
    for (T& x : d[j]) x = T(-x);
  return d;
}

// The errors of these derivatives in floating-point arithmetic, each in units of its bound: a difference, and products of at most 13
// factors.
struct Rounding_of_weighted_derivatives {
  static constexpr Join_rounding value() {
    return {Rounding_bound(1, 8 * 0x1p-52), Rounding_bound(1, 16 * 0x1p-52), Rounding_bound(1, 24 * 0x1p-52)};
  }
};

// The derivatives at an end with double coordinates and weights. Returns false where the weights differ so much that products of them
// could underflow.
template <int k, int N, class End>
bool weighted_derivatives_in_doubles(const End& end, Differences<double, N>& d, Difference_bounds& bounds) {
  End_polygon<double, N> x{};
  std::array<double, 4> w{};
  const int unit = std::ilogb(end.weight((std::min)(1, end.degree())));
  for (int j = 0; j <= k; ++j) {
    const int l = (std::min)(j, end.degree());
    for (int i = 0; i < N; ++i) x[j][i] = end.coordinate(l, i);
    w[j] = std::ldexp(end.weight(l), -unit);
    if (!(0x1p-20 <= w[j] && w[j] <= 0x1p20)) return false;
  }
  std::array<double, 3> sizes{};
  d = Weighted_derivatives<double, N>::template of<k>(x, w, end.degree(), &sizes);
  bounds.d1 = sizes[0];
  bounds.d2 = (std::max)(bounds.d1, sizes[1]);
  bounds.d3 = (std::max)(bounds.d2, sizes[2]);
  return true;
}

// Whether a form is larger than its rounding error, so that the answer is no. Otherwise nothing is decided.
template <Join_question question, int N, class Left, class Right>
bool weighted_forms_exclude(const Left& left, const Right& right) {
  constexpr int k = highest_difference(question);
  Differences<double, N> a, b;
  Difference_bounds A, B;
  if ((std::max)(left.degree(), right.degree()) > 1000 || !weighted_derivatives_in_doubles<k, N>(left, a, A) ||
      !weighted_derivatives_in_doubles<k, N>(right, b, B))
    return false;
  typedef Join_filter<Join_weights<double>, Rounding_of_weighted_derivatives> Filter;
  const Join_weights<double> w{1, 1, 1, 1, 3};
  const Filter filter{A, B, w};
  if (!filter.in_range()) return false;
  a = backwards<k>(a);
  const int pivot = largest_coordinate(a[0]);
  const Join_equations<double, N, Join_weights<double>, const Filter> equations(a, b, w, filter, pivot);
  if constexpr (question == Join_question::torsion) // undefined without curvature
    if (!equations.both_have_curvature()) return false;
  return !equations_hold<question>(equations, equations.ratio());
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_WEIGHTED_DERIVATIVES_H
