// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_EVALUATE_BATCH_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_EVALUATE_BATCH_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/internal/independent_iterations.h>
#include <CGAL/Geometric_continuity/internal/parallel.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>

#include <algorithm>
#include <array>
#include <cstddef>

/// \file evaluate_batch.h
/// Many jets of one curve at once, in the layout of `Jet_arrays`: polynomials in powers, for
/// several parameters at a time.

namespace CGAL {
namespace Geometric_continuity {

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_OFF

/// \ingroup PkgGeometricContinuityCurves
/// A Bézier curve prepared for its jets of order `k`: the coordinates of the point and of each
/// derivative as polynomials in powers of \f$ x = 2(u-a)/(b-a) - 1 \f$, which is in [-1, 1] on the
/// domain, for Horner's rule.
///
/// With exact numbers the jets are those of `Bezier_curve::jet()`. With floating-point numbers of
/// precision \f$ \varepsilon \f$ (\f$ 2^{-53} \f$ for `double`) the error of a coordinate of the
/// `j`-th derivative is at most \f$ 8(m+1)\, 2^m \varepsilon\, \frac{m!}{(m-j)!\,(b-a)^j} R_j \f$
/// in the domain, where `m` is the degree, \f$ R_0 \f$ the largest control point in this coordinate
/// and \f$ R_j \f$ the largest difference of successive ones for \f$ j \ge 1 \f$, unless numbers
/// overflow or underflow: the coefficients sum up to \f$ 2^m R_0 \f$ at most. `Bezier_curve::jet()`
/// is without the factor \f$ 2^m \f$ and gives the first and the last control point exactly.
/// Outside of the domain the error grows with \f$ |x|^{m-j} \f$.
///
/// \tparam FT a field number type
/// \tparam N the dimension
/// \tparam degree the degree `m` of the curve
/// \tparam k the order of the jets
template <class FT_, int N, int degree, int k> class Jet_polynomials {
  static_assert(N > 0 && degree >= 0 && k >= 0);
  static constexpr int last = k < degree ? k : degree; // the derivatives of higher order are zero

public:
  typedef FT_ FT; ///< the field

  /// Prepares a curve. \f$ O(N m^3) \f$
  /// \throws Error `dimension_mismatch` unless the curve has the dimension `N`
  template <class Traits> explicit Jet_polynomials(const Bezier_curve<Traits, degree>& curve) {
    if (curve.dimension() != N)
      throw Error(Error_code::dimension_mismatch, "Jet_polynomials: the dimension of the jets differs");
    start_ = curve.domain().first;
    scale_ = FT(FT(2) / FT(curve.domain().second - start_));
    const FT half = FT(FT(1) / FT(2));
    for (int i = 0; i < N; ++i) {
      std::array<FT, degree + 1> c, at_half; // the derivatives with respect to (u-a)/(b-a) at 1/2
      for (int j = 0; j <= degree; ++j) c[j] = FT(curve.coordinates(j)[i]);
      bernstein_derivatives(c, degree, half, degree, [&](int j, const FT& value) { at_half[j] = value; });
      FT power(1); // 1 / (b-a)^j
      for (int j = 0; j <= last; ++j) {
        FT divisor(1); // l! 2^l
        for (int l = 0; j + l <= degree; ++l) {
          coefficients_[j][l][i] = FT(at_half[j + l] * FT(power / divisor));
          divisor *= FT(2 * (l + 1));
        }
        power *= FT(scale_ * half);
      }
    }
  }

  /// Returns the jet at `u`. \f$ O(N k m) \f$
  Coordinate_jet<FT, N> jet(const FT& u) const {
    const FT x = local_parameter(u);
    Coordinate_jet<FT, N> jet(N, k, internal::Unspecified());
    CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (int i = 0; i < N; ++i)
      internal::for_each_index<k + 1>([&](int j)
                                          CGAL_GC_FORCEINLINE_LAMBDA { jet[j][i] = value(coefficients_[j], j, i, x); });
    return jet;
  }

  /// Computes the jets at `parameters[begin]`, ..., `parameters[end-1]`, several at a time, and
  /// writes them to the places `begin`, ..., `end-1` of `jets`. \pre `begin <= end <= jets.size()`
  void evaluate(const FT* parameters, std::size_t begin, std::size_t end, Jet_arrays<FT, N, k>& jets) const {
    for (int i = 0; i < N; ++i) evaluate_coordinate(i, parameters, begin, end, jets);
  }

private:
  typedef std::array<std::array<FT, N>, degree + 1> Polynomials; // by power and coordinate

  CGAL_GC_FORCEINLINE FT local_parameter(const FT& u) const { return FT(FT(u - start_) * scale_ - FT(1)); }

  // the i-th coordinate of the derivative of order j, by Horner's rule
  CGAL_GC_FORCEINLINE static FT value(const Polynomials& p, int j, int i, const FT& x) {
    if (j > degree) return FT(0);
    FT sum = p[degree - j][i];
    internal::for_each_index<degree>([&](int l) CGAL_GC_FORCEINLINE_LAMBDA {
      if (l + j < degree) sum = FT(sum * x + p[degree - j - l - 1][i]);
    });
    return sum;
  }

  void evaluate_coordinate(int i, const FT* parameters, std::size_t begin, std::size_t end,
                           Jet_arrays<FT, N, k>& jets) const {
    std::array<FT*, k + 1> out;
    for (int j = 0; j <= k; ++j) out[j] = jets.array(j, i);
    CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (std::size_t at = begin; at < end; ++at) {
      const FT x = local_parameter(parameters[at]);
      internal::for_each_index<k + 1>(
          [&](int j) CGAL_GC_FORCEINLINE_LAMBDA { out[j][at] = value(coefficients_[j], j, i, x); });
    }
  }

  FT start_, scale_;                            // x = scale_ (u - start_) - 1
  std::array<Polynomials, k + 1> coefficients_; // by order
};

namespace internal {

// A rational Bezier curve prepared for its jets of order k: `Jet_polynomials` of the homogeneous
// points (p, w), and then the quotient rule x_j = (p_j - sum_{l=1}^j C(j,l) w_l x_{j-l}) / w_0 of
// Curve_jet.h for several parameters at a time.
template <class FT, int N, int degree, int k> class Rational_jet_polynomials {
  Jet_polynomials<FT, N + 1, degree, k> homogeneous_;

  // jets of homogeneous points that stay in the first cache
  static constexpr std::size_t part = 128;

public:
  template <class Traits>
  explicit Rational_jet_polynomials(const Rational_bezier_curve<Traits, degree>& curve)
      : homogeneous_(curve.homogeneous()) {}

  // Writes the jets at parameters[begin], ..., parameters[end-1] to these places of `jets`.
  void evaluate(const FT* parameters, std::size_t begin, std::size_t end, Jet_arrays<FT, N, k>& jets) const {
    Jet_arrays<FT, N + 1, k> p((std::min)(part, end - begin));
    for (std::size_t first = begin; first < end; first += part) {
      const std::size_t size = (std::min)(part, end - first);
      homogeneous_.evaluate(parameters + first, 0, size, p);
      require_denominators(p.array(0, N), size);
      for (int i = 0; i < N; ++i) project(p, i, first, size, jets);
    }
  }

private:
  static void require_denominators(const FT* w, std::size_t size) {
    bool zero = false;
    for (std::size_t at = 0; at < size; ++at) zero |= bool(w[at] == FT(0));
    require_denominator(FT(zero ? 0 : 1), "evaluate: the denominator of a rational curve");
  }

  // The i-th coordinates.
  static void project(const Jet_arrays<FT, N + 1, k>& p, int i, std::size_t first, std::size_t size,
                      Jet_arrays<FT, N, k>& jets) {
    std::array<const FT*, k + 1> numerator, w;
    std::array<FT*, k + 1> out;
    for (int j = 0; j <= k; ++j) {
      numerator[j] = p.array(j, i);
      w[j] = p.array(j, N);
      out[j] = jets.array(j, i) + first;
    }
    CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (std::size_t at = 0; at < size; ++at) {
      std::array<FT, k + 1> x, denominator;
      for_each_index<k + 1>([&](int j) CGAL_GC_FORCEINLINE_LAMBDA {
        x[j] = numerator[j][at];
        denominator[j] = w[j][at];
      });
      divide_derivatives<k>(x.data(), denominator.data(), FT(FT(1) / denominator[0]));
      for_each_index<k + 1>([&](int j) CGAL_GC_FORCEINLINE_LAMBDA { out[j][at] = x[j]; });
    }
  }
};

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_ON

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
/// Computes the jets of order `k` of a Bézier curve at many parameters: the curve is prepared as
/// `Jet_polynomials` once, and with floating-point numbers several parameters are computed at a
/// time. With exact numbers the results are those of `Bezier_curve::jet()`; else see
/// `Jet_polynomials` for the bound of the error. No memory is allocated when `jets` has room.
///
/// \param curve the curve
/// \param parameters the first of `n` finite parameters, which may lie outside of the domain
/// \param n their number
/// \param jets takes the results; it is resized to `n`
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
///
/// \f$ O(N (m^3 + n k m)) \f$ for degree `m`; degrees above 9 that are known at run time only go
/// through `jet()`.
/// \throws Error `dimension_mismatch` unless the curve has the dimension `N`
template <class Concurrency_tag = Sequential_tag, class Traits, int Degree, int N, int k>
void evaluate(const Bezier_curve<Traits, Degree>& curve, const typename Traits::FT* parameters, std::size_t n,
              Jet_arrays<typename Traits::FT, N, k>& jets) {
  internal::evaluate_curve<Concurrency_tag, Degree>(curve, parameters, n, jets);
}

/// \ingroup PkgGeometricContinuityCurves
/// Computes the jets of order `k` of a rational Bézier curve at many parameters: those of its
/// homogeneous points as for a `Bezier_curve`, and then the quotient rule, see `project()`. With
/// exact numbers the results are those of `Rational_bezier_curve::jet()`. Memory is allocated for
/// 128 jets of homogeneous points, besides that of `jets`.
///
/// \param curve the curve
/// \param parameters the first of `n` finite parameters, which may lie outside of the domain
/// \param n their number
/// \param jets takes the results; it is resized to `n`
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
///
/// \f$ O(N (m^3 + n k m + n k^2)) \f$ for degree `m`; degrees above 9 that are known at run time
/// only go through `jet()`.
/// \throws Error `dimension_mismatch` unless the curve has the dimension `N`, `zero_weight` when
///   the denominator is zero at a parameter, `not_finite` when a product of floating-point numbers
///   overflows
template <class Concurrency_tag = Sequential_tag, class Traits, int Degree, int N, int k>
void evaluate(const Rational_bezier_curve<Traits, Degree>& curve, const typename Traits::FT* parameters, std::size_t n,
              Jet_arrays<typename Traits::FT, N, k>& jets) {
  internal::evaluate_curve<Concurrency_tag, Degree>(curve, parameters, n, jets);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_EVALUATE_BATCH_H
