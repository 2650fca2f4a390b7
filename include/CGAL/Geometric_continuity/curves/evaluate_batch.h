// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_EVALUATE_BATCH_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_EVALUATE_BATCH_H

#include <CGAL/Geometric_continuity/curves/Jet_polynomials.h>
#include <CGAL/Geometric_continuity/curves/internal/Rational_jet_polynomials.h>
#include <CGAL/Geometric_continuity/internal/for_each_block.h>

#include <cstddef>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The curve of degree n, prepared for its jets.
template <int n, int k, int N, class Traits, int Degree>
Jet_polynomials<typename Traits::FT, N, n, k> prepared(const Bezier_curve<Traits, Degree>& curve) {
  return Jet_polynomials<typename Traits::FT, N, n, k>(Bezier_curve<Traits, n>(curve));
}
template <int n, int k, int N, class Traits, int Degree>
Rational_jet_polynomials<typename Traits::FT, N, n, k> prepared(const Rational_bezier_curve<Traits, Degree>& curve) {
  return Rational_jet_polynomials<typename Traits::FT, N, n, k>(Rational_bezier_curve<Traits, n>(curve));
}

// The degree of the curve is n, or it is tried whether it is higher.
template <class Concurrency_tag, int n, int most, class Curve, class FT, int N, int k>
void evaluate_degree(const Curve& curve, const FT* parameters, Jet_arrays<FT, N, k>& jets) {
  if constexpr (n > most)
    for_each_block<Concurrency_tag>(jets.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t at = begin; at < end; ++at) jets.set(at, curve.jet(parameters[at], k));
    });
  else if (curve.degree() == n) {
    const auto polynomials = prepared<n, k, N>(curve);
    for_each_block<Concurrency_tag>(
        jets.size(), [&](std::size_t begin, std::size_t end) { polynomials.evaluate(parameters, begin, end, jets); });
  } else
    evaluate_degree<Concurrency_tag, n + 1, most>(curve, parameters, jets);
}

// From the degree m on, when it is known, or else from 0 to 9.
template <class Concurrency_tag, int m, class Curve, class FT, int N, int k>
void evaluate_curve(const Curve& curve, const FT* parameters, std::size_t n, Jet_arrays<FT, N, k>& jets) {
  static_assert(Curve::N == 0 || Curve::N == N, "the dimensions differ");
  if (curve.dimension() != N)
    throw Error(Error_code::dimension_mismatch, "evaluate: the dimension of the jets differs");
  jets.resize(n);
  if constexpr (m == dynamic_degree)
    evaluate_degree<Concurrency_tag, 0, 9>(curve, parameters, jets);
  else
    evaluate_degree<Concurrency_tag, m, m>(curve, parameters, jets);
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
  internal::evaluate_curve<Concurrency_tag, Degree>(curve, parameters, n, jets);
}

/// \ingroup PkgGeometricContinuityCurves
/// Computes the jets of order `k` of a rational Bézier curve at many parameters: those of its homogeneous points as for a
/// `Bezier_curve`, and then the quotient rule, see `project()`. With exact numbers the results are those of
/// `Rational_bezier_curve::jet()`. Memory is allocated for 128 jets of homogeneous points, besides that of `jets`.
///
/// \param curve the curve
/// \param parameters the first of `n` finite parameters, which may lie outside of the domain
/// \param n their number
/// \param jets takes the results; it is resized to `n`
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
///
/// \f$ O(N (m^3 + n k m + n k^2)) \f$ for degree `m`; degrees above 9 that are known at run time only go through `jet()`.
/// \throws Error `dimension_mismatch` unless the curve has the dimension `N`, `zero_weight` when the denominator is zero at a
///   parameter, `not_finite` when a product of floating-point numbers overflows
template <class Concurrency_tag = Sequential_tag, class Traits, int Degree, int N, int k>
void evaluate(const Rational_bezier_curve<Traits, Degree>& curve, const typename Traits::FT* parameters, std::size_t n,
              Jet_arrays<typename Traits::FT, N, k>& jets) {
  internal::evaluate_curve<Concurrency_tag, Degree>(curve, parameters, n, jets);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_EVALUATE_BATCH_H
