// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_RATIONAL_JET_POLYNOMIALS_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_RATIONAL_JET_POLYNOMIALS_H

#include <CGAL/Geometric_continuity/curves/Jet_polynomials.h>
#include <CGAL/Geometric_continuity/curves/Rational_bezier_curve.h>

#include <algorithm>
#include <array>
#include <cstddef>

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_OFF

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A rational Bezier curve prepared for its jets of order k: `Jet_polynomials` of the homogeneous points (p, w), and then the
// quotient rule x_j = (p_j - sum_{l=1}^j C(j,l) w_l x_{j-l}) / w_0 of homogeneous_jets.h for several parameters at a time.
template <class FT, int N, int degree, int k> class Rational_jet_polynomials {
  Jet_polynomials<FT, N + 1, degree, k> homogeneous_;

  static constexpr std::size_t part = 128; // jets of homogeneous points that stay in the first cache

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
      for_each_index<k + 1>([&](int j) {
        x[j] = numerator[j][at];
        denominator[j] = w[j][at];
      });
      divide_derivatives<k>(x.data(), denominator.data(), FT(FT(1) / denominator[0]));
      for_each_index<k + 1>([&](int j) { out[j][at] = x[j]; });
    }
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_ON

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_RATIONAL_JET_POLYNOMIALS_H
