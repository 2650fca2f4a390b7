// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_BERNSTEIN_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_BERNSTEIN_JET_H

#include <boost/config.hpp>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Degree and order are known at compile time, and everything is unrolled by templates: then a compiler keeps the
// coefficients in registers, and vectorises a loop over many parameters around it.

// c_0, ..., c_(m-1) at the next level of de Casteljau's algorithm
template <class FT, std::size_t... i>
BOOST_FORCEINLINE void de_casteljau_level(FT* c, const FT& s, const FT& t, std::index_sequence<i...>) {
  ((c[i] = FT(s * c[i] + t * c[i + 1])), ...);
}

// the forward difference of order j at c_0
template <int j, class FT> BOOST_FORCEINLINE FT forward_difference(const FT* c) {
  if constexpr (j == 0)
    return c[0];
  else
    return FT(forward_difference<j - 1>(c + 1) - forward_difference<j - 1>(c));
}

// The differences of order j of the level with j+1 coefficients, for j = k, ..., 0. c holds the level with m+1.
template <int m, int k, class FT> BOOST_FORCEINLINE void bernstein_differences(FT* c, const FT& s, const FT& t, FT* d) {
  if constexpr (m <= k) d[m] = forward_difference<m>(c);
  if constexpr (m > 0) {
    de_casteljau_level(c, s, t, std::make_index_sequence<m>());
    bernstein_differences<m - 1, k>(c, s, t, d);
  }
}

// The derivatives at t up to order k of the polynomial with the Bernstein coefficients c, each divided by n!/(n-j)!;
// those of higher order than n are zero. c is overwritten.
template <int n, int k, class FT> BOOST_FORCEINLINE void bernstein_jet(std::array<FT, n + 1>& c, const FT& t, FT* d) {
  for (int j = n + 1; j <= k; ++j) d[j] = FT(0);
  bernstein_differences<n, (k < n ? k : n)>(c.data(), FT(FT(1) - t), t, d);
}

// The factors n!/(n-j)! / h^j of the derivatives of order j = 0, ..., k with respect to a parameter on an interval of
// length h.
template <int k, class FT> std::array<FT, k + 1> derivative_factors(int n, const FT& h) {
  std::array<FT, k + 1> f;
  f[0] = FT(1);
  for (int j = 0; j < k; ++j) f[j + 1] = j < n ? FT(f[j] * FT(n - j) / h) : FT(0);
  return f;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_BERNSTEIN_JET_H
