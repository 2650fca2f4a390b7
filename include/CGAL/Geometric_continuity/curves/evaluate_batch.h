// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_EVALUATE_BATCH_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_EVALUATE_BATCH_H

#include <CGAL/Geometric_continuity/curves/Jet_polynomials.h>
#include <CGAL/Geometric_continuity/internal/for_each_block.h>

#include <cstddef>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The degree of the curve is n, or it is tried whether it is higher.
template <class Concurrency_tag, int n, int most, class Curve, class FT, int N, int k>
void evaluate_degree(const Curve& curve, const FT* parameters, Jet_arrays<FT, N, k>& jets) {
  if constexpr (n > most)
    for_each_block<Concurrency_tag>(jets.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t at = begin; at < end; ++at) jets.set(at, curve.jet(parameters[at], k));
    });
  else if (curve.degree() == n) {
    const Jet_polynomials<FT, N, n, k> polynomials{Bezier_curve<typename Curve::Traits, n>(curve)};
    for_each_block<Concurrency_tag>(
        jets.size(), [&](std::size_t begin, std::size_t end) { polynomials.evaluate(parameters, begin, end, jets); });
  } else
    evaluate_degree<Concurrency_tag, n + 1, most>(curve, parameters, jets);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// Computes the jets of order `k` of a Bézier curve at many parameters: the curve is prepared as `Jet_polynomials` once, and with
/// floating-point numbers several parameters are computed at a time. With exact numbers the results are those of
/// `Bezier_curve::jet()`; else see `Jet_polynomials` for the bound of the error. No memory is allocated when `jets` has room.
///
/// \param curve the curve
/// \param parameters the first of `n` finite parameters, which may lie outside of the domain
/// \param n their number
/// \param jets takes the results; it is resized to `n`
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
///
/// \f$ O(N (m^3 + n k m)) \f$ for degree `m`; degrees above 9 that are known at run time only go through `jet()`.
/// \throws Error `dimension_mismatch` unless the curve has the dimension `N`
template <class Concurrency_tag = Sequential_tag, class Traits, int Degree, int N, int k>
void evaluate(const Bezier_curve<Traits, Degree>& curve, const typename Traits::FT* parameters, std::size_t n,
              Jet_arrays<typename Traits::FT, N, k>& jets) {
  static_assert(Bezier_curve<Traits, Degree>::N == 0 || Bezier_curve<Traits, Degree>::N == N, "the dimensions differ");
  if (curve.dimension() != N)
    throw Error(Error_code::dimension_mismatch, "evaluate: the dimension of the jets differs");
  jets.resize(n);
  if constexpr (Degree == dynamic_degree)
    internal::evaluate_degree<Concurrency_tag, 0, 9>(curve, parameters, jets);
  else
    internal::evaluate_degree<Concurrency_tag, Degree, Degree>(curve, parameters, jets);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_EVALUATE_BATCH_H
