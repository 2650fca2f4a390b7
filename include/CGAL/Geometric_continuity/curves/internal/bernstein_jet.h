// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_BERNSTEIN_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_BERNSTEIN_JET_H

#include <CGAL/Geometric_continuity/internal/for_each_index.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>

#include <array>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Degree and order are known at compile time, and everything is unrolled by templates: then a compiler keeps the
// coefficients in registers, and vectorises a loop over many parameters around it.

// The forward difference of order m of c_0, ..., c_m; c is overwritten.
template <int m, class FT> CGAL_GC_FORCEINLINE FT forward_difference(FT* c) {
  if constexpr (m > 0) {
    for_each_index<m>([&](int i) { c[i] = c[i + 1] - c[i]; });
    return forward_difference<m - 1, FT>(c);
  } else
    return c[0];
}

// Replaces the coefficient i of the level of de Casteljau's algorithm with m+1 coefficients by that of the next level, which is
// reckoned from e = c_(i+1) - c_i, on the left side as c_i + t e and on the right side as c_(i+1) - s e: rounded numbers give
// c_0 for t = 0 and c_m for t = 1, exactly.
template <class FT, class Coefficient>
CGAL_GC_FORCEINLINE void step_to_next_level(Coefficient* c, int i, int m, const FT& s, const FT& t,
                                            const Coefficient& e) {
  if (i < m / 2)
    c[i] += t * e;
  else
    c[i] = c[i + 1] - s * e;
}

// The same for all i. No lambda expression, which a compiler may refuse to inline.
template <class FT, int... i>
CGAL_GC_FORCEINLINE void steps_to_next_level(FT* c, const FT& s, const FT& t, const FT* e,
                                             std::integer_sequence<int, i...>) {
  (step_to_next_level(c, i, static_cast<int>(sizeof...(i)), s, t, e[i]), ...);
}

// The differences of order j of the level of de Casteljau's algorithm with j+1 coefficients, for j = k, ..., 0. c holds the
// level with m+1.
template <int m, int k, class FT>
CGAL_GC_FORCEINLINE void bernstein_differences(FT* c, const FT& s, const FT& t, FT* d) {
  if constexpr (m == 0)
    d[0] = c[0];
  else if constexpr (m == 1) {
    if constexpr (k > 0) d[1] = c[1] - c[0];
    d[0] = s * c[0] + t * c[1];
  } else {
    FT e[m];
    for_each_index<m>([&](int i) { e[i] = c[i + 1] - c[i]; });
    steps_to_next_level(c, s, t, e, std::make_integer_sequence<int, m>());
    if constexpr (m <= k) d[m] = forward_difference<m - 1, FT>(e);
    bernstein_differences<m - 1, k>(c, s, t, d);
  }
}

// The derivatives at t = 1-s up to order k of the polynomial with the Bernstein coefficients c, each divided by n!/(n-j)!;
// those of higher order than n are zero. c is overwritten.
template <int n, int k, class FT>
CGAL_GC_FORCEINLINE void bernstein_jet(std::array<FT, n + 1>& c, const FT& s, const FT& t, FT* d) {
  for (int j = n + 1; j <= k; ++j) d[j] = FT(0);
  bernstein_differences<n, (k < n ? k : n)>(c.data(), s, t, d);
}

// Splits the polynomial of degree n with the Bernstein coefficients c at t = 1-s: c becomes the right part. The numbers are those of
// bernstein_split() for a degree known at run time only, algebra/bernstein.h.
template <int n, class FT> CGAL_GC_FORCEINLINE void bernstein_split(FT* c, const FT& s, const FT& t, FT* left) {
  left[0] = c[0];
  if constexpr (n > 0) {
    for_each_index<n>([&](int j) { c[j] = s * c[j] + t * c[j + 1]; });
    bernstein_split<n - 1>(c, s, t, left + 1);
  }
}

// The factors n!/(n-j)! / h^j of the derivatives of order j = 0, ..., k with respect to a parameter on an interval of
// length h.
template <int k, class FT> CGAL_GC_FORCEINLINE std::array<FT, k + 1> derivative_factors(int n, const FT& h) {
  std::array<FT, k + 1> f;
  f[0] = FT(1);
  if constexpr (k > 0) {
    const FT inverse = FT(FT(1) / h);
    for_each_index<k>([&](int j) { f[j + 1] = j < n ? FT(f[j] * FT(FT(n - j) * inverse)) : FT(0); });
  }
  return f;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_BERNSTEIN_JET_H
