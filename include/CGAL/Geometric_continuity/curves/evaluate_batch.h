// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_EVALUATE_BATCH_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_EVALUATE_BATCH_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/internal/bernstein_jet.h>
#include <CGAL/Geometric_continuity/internal/for_each_block.h>
#include <CGAL/Geometric_continuity/internal/independent_iterations.h>
#include <CGAL/Geometric_continuity/local/Jet_arrays.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// One coordinate of the jets at parameters[begin], ..., parameters[end-1].
template <int n, int k, class FT>
void evaluate_coordinate(const std::array<FT, n + 1>& b, const FT& a, const FT& h, const FT* parameters,
                         const std::array<FT*, k + 1>& out, std::size_t begin, std::size_t end) {
  const std::array<FT, k + 1> factors = derivative_factors<k>(n, h);
  const FT scale = FT(FT(1) / h);
  CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
  for (std::size_t i = begin; i < end; ++i) {
    std::array<FT, n + 1> c = b;
    FT d[k + 1];
    bernstein_jet<n, k>(c, FT((parameters[i] - a) * scale), d);
    for (int j = 0; j <= k; ++j) out[j][i] = FT(factors[j] * d[j]);
  }
}

// The same for a degree that is known at run time: the unrolled code where the degree is at most `most`.
template <int n, int most, int k, class FT>
bool evaluate_coordinate_of_degree(int degree, const std::vector<FT>& b, const FT& a, const FT& h, const FT* parameters,
                                   const std::array<FT*, k + 1>& out, std::size_t begin, std::size_t end) {
  if constexpr (n > most)
    return false;
  else if (degree == n) {
    std::array<FT, n + 1> c;
    std::copy(b.begin(), b.end(), c.begin());
    evaluate_coordinate<n, k>(c, a, h, parameters, out, begin, end);
    return true;
  } else
    return evaluate_coordinate_of_degree<n + 1, most, k>(degree, b, a, h, parameters, out, begin, end);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// The jets of order `k` of a Bézier curve at many parameters, coordinate by coordinate: with floating-point numbers several
/// parameters are computed at a time. Results are those of `Bezier_curve::jet()` up to rounding. No memory is allocated when
/// `jets` has room, except a few numbers for each call and a run-time degree.
///
/// \param parameters the first of `n` parameters, which may lie outside of the domain
/// \param n their number; `jets` is resized to it
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
///
/// \f$ O(N n (m^2 + 2^k)) \f$ for degree `m`; degrees above 9 that are known at run time only take the way of `jet()`.
template <class Concurrency_tag = Sequential_tag, class Traits, int Degree, int N, int k>
void evaluate(const Bezier_curve<Traits, Degree>& curve, const typename Traits::FT* parameters, std::size_t n,
              Jet_arrays<typename Traits::FT, N, k>& jets) {
  typedef typename Traits::FT FT;
  static_assert(Bezier_curve<Traits, Degree>::N == 0 || Bezier_curve<Traits, Degree>::N == N, "the dimensions differ");
  if (curve.dimension() != N)
    throw Error(Error_code::dimension_mismatch, "evaluate: the dimension of the jets differs");
  constexpr int most_unrolled = 9;
  jets.resize(n);
  const FT a = curve.domain().first, h = FT(curve.domain().second - a);
  internal::for_each_block<Concurrency_tag>(n, [&](std::size_t begin, std::size_t end) {
    for (int i = 0; i < N; ++i) {
      std::array<FT*, k + 1> out;
      for (int j = 0; j <= k; ++j) out[j] = jets.array(j, i);
      const Bernstein_polynomial<FT> b = curve.coordinate_polynomial(i);
      if constexpr (Degree != dynamic_degree) {
        std::array<FT, Degree + 1> c;
        std::copy(b.coefficients().begin(), b.coefficients().end(), c.begin());
        internal::evaluate_coordinate<Degree, k>(c, a, h, parameters, out, begin, end);
      } else if (!internal::evaluate_coordinate_of_degree<0, most_unrolled, k>(curve.degree(), b.coefficients(), a, h,
                                                                               parameters, out, begin, end)) {
        for (std::size_t l = begin; l < end; ++l) jets.set(l, curve.jet(parameters[l], k));
        return;
      }
    }
  });
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_EVALUATE_BATCH_H
