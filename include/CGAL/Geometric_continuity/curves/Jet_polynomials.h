// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_JET_POLYNOMIALS_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_JET_POLYNOMIALS_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/internal/independent_iterations.h>
#include <CGAL/Geometric_continuity/local/Jet_arrays.h>

#include <array>
#include <cstddef>

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_OFF

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// A Bézier curve prepared for its jets of order `k`: the coordinates of the point and of each derivative as polynomials in
/// powers of \f$ x = 2(u-a)/(b-a) - 1 \f$, which is in [-1, 1] on the domain, for Horner's rule.
///
/// With exact numbers the jets are those of `Bezier_curve::jet()`. With floating-point numbers of precision \f$ \varepsilon \f$
/// (\f$ 2^{-53} \f$ for `double`) the error of a coordinate of the `j`-th derivative is at most
/// \f$ 8(m+1)\, 2^m \varepsilon\, \frac{m!}{(m-j)!\,(b-a)^j} R_j \f$ in the domain, where `m` is the degree, \f$ R_0 \f$ the
/// largest control point in this coordinate and \f$ R_j \f$ the largest difference of successive ones for
/// \f$ j \ge 1 \f$, unless numbers overflow or underflow: the coefficients sum up to \f$ 2^m R_0 \f$ at most.
/// `Bezier_curve::jet()` is without the factor \f$ 2^m \f$ and gives the first and the last control point exactly.
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
      internal::for_each_index<k + 1>([&](int j) { jet[j][i] = value(coefficients_[j], j, i, x); });
    return jet;
  }

  /// Computes the jets at `parameters[begin]`, ..., `parameters[end-1]`, several at a time, and writes them to the places
  /// `begin`, ..., `end-1` of `jets`. \pre `begin <= end <= jets.size()`
  void evaluate(const FT* parameters, std::size_t begin, std::size_t end, Jet_arrays<FT, N, k>& jets) const {
    for (int i = 0; i < N; ++i) evaluate_coordinate(i, parameters, begin, end, jets);
  }

private:
  typedef std::array<std::array<FT, N>, degree + 1> Polynomials; // by power and coordinate

  FT local_parameter(const FT& u) const { return FT(FT(u - start_) * scale_ - FT(1)); }

  // the i-th coordinate of the derivative of order j, by Horner's rule
  CGAL_GC_FORCEINLINE static FT value(const Polynomials& p, int j, int i, const FT& x) {
    if (j > degree) return FT(0);
    FT sum = p[degree - j][i];
    internal::for_each_index<degree>([&](int l) {
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
      internal::for_each_index<k + 1>([&](int j) { out[j][at] = value(coefficients_[j], j, i, x); });
    }
  }

  FT start_, scale_;                            // x = scale_ (u - start_) - 1
  std::array<Polynomials, k + 1> coefficients_; // by order
};

} // namespace Geometric_continuity
} // namespace CGAL

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_ON

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_JET_POLYNOMIALS_H
