// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVATURE_BATCH_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVATURE_BATCH_H

#include <CGAL/Geometric_continuity/internal/for_each_block.h>
#include <CGAL/Geometric_continuity/internal/independent_iterations.h>
#include <CGAL/Geometric_continuity/local/Jet_arrays.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityLocal
/// Computes the curvatures \f$ \kappa = |d_1 \times d_2| / |d_1|^3 \f$ and torsions
/// \f$ \tau = \det(d_1, d_2, d_3) / |d_1 \times d_2|^2 \f$ of many jets in space, in one pass.
///
/// Where a number is not defined it is set to 0: the curvature where \f$ d_1 = 0 \f$, the torsion where also
/// \f$ d_1 \times d_2 = 0 \f$. Compile with `-fno-math-errno`, or the square root is not vectorised.
///
/// In contrast to `curvature_squared()` and `torsion()`, derivatives are not scaled. In `double`, the largest coordinate of each
/// of the three derivatives must be 0 or between \f$ 2^{-200} \f$ and \f$ 2^{200} \f$; beyond, products of up to four of
/// them overflow or vanish, and the results are unspecified (too small, infinite, or not a number). It is the caller's duty to
/// scale such jets, or to ask for them one by one.
///
/// \param jets `n` jets of order at least 3
/// \param curvature,torsion arrays for `n` numbers
/// \return the number of jets whose torsion, or also curvature, is not defined
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
template <class Concurrency_tag = Sequential_tag, class FT, int k>
std::size_t curvature_and_torsion(const Jet_arrays<FT, 3, k>& jets, FT* curvature, FT* torsion) {
  static_assert(k >= 3, "torsion reads 3 derivatives");
  std::atomic<std::size_t> undefined(0);
  internal::for_each_block<Concurrency_tag>(jets.size(), [&](std::size_t begin, std::size_t end) {
    const FT *x1 = jets.array(1, 0), *y1 = jets.array(1, 1), *z1 = jets.array(1, 2);
    const FT *x2 = jets.array(2, 0), *y2 = jets.array(2, 1), *z2 = jets.array(2, 2);
    const FT *x3 = jets.array(3, 0), *y3 = jets.array(3, 1), *z3 = jets.array(3, 2);
    FT *kappa = curvature, *tau = torsion;
    // at a time: the square root stands alone, because -frounding-math keeps it from vectorisation
    constexpr std::size_t most = 256;
    FT squares[most];
    for (std::size_t first = begin; first < end; first += most) {
      const std::size_t last = (std::min)(first + most, end);
      CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
      for (std::size_t i = first; i < last; ++i) {
        const FT g = x1[i] * x1[i] + y1[i] * y1[i] + z1[i] * z1[i]; // |d1|^2
        const FT nx = y1[i] * z2[i] - z1[i] * y2[i], ny = z1[i] * x2[i] - x1[i] * z2[i],
                 nz = x1[i] * y2[i] - y1[i] * x2[i];
        const FT nn = nx * nx + ny * ny + nz * nz;                                  // |d1 x d2|^2
        const FT g_or_1 = g > FT(0) ? g : FT(1), nn_or_1 = nn > FT(0) ? nn : FT(1); // the numerators are 0 as well
        squares[i - first] = g_or_1;
        kappa[i] = nn / g_or_1;
        tau[i] = (nx * x3[i] + ny * y3[i] + nz * z3[i]) / nn_or_1;
      }
      for (std::size_t i = first; i < last; ++i) kappa[i] = std::sqrt(kappa[i]);
      CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
      for (std::size_t i = first; i < last; ++i) kappa[i] /= squares[i - first];
    }
    undefined += std::count(kappa + begin, kappa + end, FT(0));
  });
  return undefined;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVATURE_BATCH_H
