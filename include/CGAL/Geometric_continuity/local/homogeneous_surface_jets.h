// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_HOMOGENEOUS_SURFACE_JETS_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_HOMOGENEOUS_SURFACE_JETS_H

#include <CGAL/Geometric_continuity/local/Surface_jet.h>
#include <CGAL/Geometric_continuity/local/homogeneous_jets.h>

#include <array>
#include <vector>

/// \file homogeneous_surface_jets.h
/// From the derivatives of homogeneous points \f$ (P, w) = (w S, w) \f$ of a surface to those of \f$ S = P / w \f$.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The partial derivatives s(k, l) from those of homogeneous points, p(k, l), with as many coordinates, the last of which is of no use in
// s; k + l <= order. factor(k, i, l, j) is the product of two binomial coefficients.
template <class FT, class Derivatives, class Factor, class Partials>
CGAL_GC_FORCEINLINE void project_partials(const Derivatives& p, int order, const Factor& factor, Partials& s) {
  const int n = p(0, 0).dimension() - 1;
  require_denominator(p(0, 0)[n], "the denominator of a rational surface");
  const FT inverse = FT(FT(1) / p(0, 0)[n]);
  for (int k = 0; k <= order; ++k)
    for (int l = 0; k + l <= order; ++l) {
      auto sum = p(k, l);
      for (int i = 0; i <= k; ++i)
        for (int j = 0; j <= l; ++j)
          if (i + j > 0) sum -= FT(factor(k, i, l, j) * p(i, j)[n]) * s[k - i][l - j];
      s[k][l] = inverse * sum;
    }
}

// The same for an order up to 2 that is known at compile time, with local variables.
template <int order, class Traits>
void project_short(const Surface_jet<Homogeneous_traits<Traits>>& p, Surface_jet<Traits>& s) {
  typedef typename Traits::FT FT;
  static_assert(order <= 2);
  constexpr int binomials[3][3] = {{1, 0, 0}, {1, 1, 0}, {1, 2, 1}};
  std::array<std::array<Coordinates<Homogeneous_traits<Traits>>, order + 1>, order + 1> x;
  project_partials<FT>(
      p, order, [&](int k, int i, int l, int j) { return FT(binomials[k][i] * binomials[l][j]); }, x);
  for (int k = 0; k <= order; ++k)
    for (int l = 0; k + l <= order; ++l)
      for (int i = 0; i < s.dimension(); ++i) s(k, l)[i] = x[k][l][i];
}

} // namespace internal

/// \ingroup PkgGeometricContinuityLocal
/// Returns the jet of the surface \f$ S = P / w \f$ from that of its homogeneous points \f$ (P, w) \f$:
/// \f$ S_{kl} = (P_{kl} - \sum_{(i,j) \ne (0,0)} \binom{k}{i} \binom{l}{j} w_{ij} S_{k-i,l-j}) / w_{00} \f$.
/// \f$ O(n k^4) \f$ for the order `k`
/// \throws Error `zero_weight` when \f$ w_{00} = 0 \f$
template <class Traits> Surface_jet<Traits> project(const Surface_jet<Homogeneous_traits<Traits>>& p) {
  typedef typename Traits::FT FT;
  const int order = p.order();
  Surface_jet<Traits> s(p.dimension() - 1, order);
  switch (order) {
  case 0: internal::project_short<0>(p, s); break;
  case 1: internal::project_short<1>(p, s); break;
  case 2: internal::project_short<2>(p, s); break;
  default: {
    std::vector<std::vector<FT>> binomials;
    internal::for_each_binomial_row<FT>(
        order, [&](int k, const auto& row) { binomials.emplace_back(row.begin(), row.begin() + k + 1); });
    std::vector<std::vector<Coordinates<Homogeneous_traits<Traits>>>> x;
    for (int k = 0; k <= order; ++k) x.emplace_back(order + 1 - k, p(0, 0));
    internal::project_partials<FT>(
        p, order, [&](int k, int i, int l, int j) { return FT(binomials[k][i] * binomials[l][j]); }, x);
    for (int k = 0; k <= order; ++k)
      for (int l = 0; k + l <= order; ++l)
        for (int i = 0; i < s.dimension(); ++i) s(k, l)[i] = x[k][l][i];
  }
  }
  internal::check_jet(s, "the jet of a rational surface");
  return s;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_HOMOGENEOUS_SURFACE_JETS_H
