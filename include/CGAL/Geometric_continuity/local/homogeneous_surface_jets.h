// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_HOMOGENEOUS_SURFACE_JETS_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_HOMOGENEOUS_SURFACE_JETS_H

#include <CGAL/Geometric_continuity/local/Surface_jet.h>
#include <CGAL/Geometric_continuity/local/homogeneous_jets.h>

#include <boost/container/small_vector.hpp>

/// \file homogeneous_surface_jets.h
/// From the derivatives of homogeneous points \f$ (P, w) = (w S, w) \f$ of a surface to those of \f$ S = P / w \f$.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityLocal
/// Returns the jet of the surface \f$ S = P / w \f$ from that of its homogeneous points \f$ (P, w) \f$:
/// \f$ S_{kl} = (P_{kl} - \sum_{(i,j) \ne (0,0)} \binom{k}{i} \binom{l}{j} w_{ij} S_{k-i,l-j}) / w_{00} \f$.
/// \f$ O(n k^4) \f$ for the order `k`
/// \throws Error `zero_weight` when \f$ w_{00} = 0 \f$
template <class Traits> Surface_jet<Traits> project(const Surface_jet<Homogeneous_traits<Traits>>& p) {
  typedef typename Traits::FT FT;
  const int n = p.dimension() - 1, order = p.order();
  internal::require_denominator(p(0, 0)[n], "the denominator of a rational surface");
  const FT inverse = FT(FT(1) / p(0, 0)[n]);
  boost::container::small_vector<boost::container::small_vector<FT, 4>, 4> binomial;
  internal::for_each_binomial_row<FT>(
      order, [&](int k, const auto& row) { binomial.emplace_back(row.begin(), row.begin() + k + 1); });
  Surface_jet<Traits> s(n, order);
  for (int k = 0; k <= order; ++k)
    for (int l = 0; k + l <= order; ++l)
      for (int x = 0; x < n; ++x) {
        FT sum = p(k, l)[x];
        for (int i = 0; i <= k; ++i)
          for (int j = 0; j <= l; ++j)
            if (i + j > 0) sum -= FT(binomial[k][i] * binomial[l][j]) * p(i, j)[n] * s(k - i, l - j)[x];
        s(k, l)[x] = FT(sum * inverse);
      }
  internal::check_jet(s, "the jet of a rational surface");
  return s;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_HOMOGENEOUS_SURFACE_JETS_H
