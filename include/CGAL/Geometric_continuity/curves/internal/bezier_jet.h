// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_BEZIER_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_BEZIER_JET_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/bernstein.h>
#include <CGAL/Geometric_continuity/curves/internal/bernstein_jet.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/internal/independent_iterations.h>
#include <CGAL/Geometric_continuity/local/homogeneous_jets.h>
#include <CGAL/Geometric_continuity/local/internal/jet_of_legs.h>

#include <array>

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_OFF

/// \file bezier_jet.h
/// Jets of polynomial and of rational Bezier curves from their control points: coordinate(j, i) is the i-th coordinate of the j-th
/// point. They are written to `jet`, which has the dimension n.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Degree and order are known at compile time. N is n, or 0 when it is known at run time only.
template <int Degree, int k, int N, class FT, class Coordinate, class Jet>
CGAL_GC_FORCEINLINE void bezier_jet(int dimension, const FT& u, const FT& a, const FT& b, const Coordinate& coordinate,
                                    Jet& jet) {
  const FT h = FT(b - a), t = FT((u - a) / h), s = FT(FT(1) - t);
  const std::array<FT, k + 1> factors = derivative_factors<k>(Degree, h);
  const int n = N == 0 ? dimension : N;
  CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
  for (int i = 0; i < n; ++i) {
    std::array<FT, Degree + 1> c;
    for_each_index<Degree + 1>([&](int j) { c[j] = coordinate(j, i); });
    std::array<FT, k + 1> d;
    bernstein_jet<Degree, k>(c, s, t, d.data());
    jet[0][i] = d[0];
    for_each_index<k>([&](int j) { jet[j + 1][i] = FT(factors[j + 1] * d[j + 1]); });
  }
}

// The same for a rational curve: its homogeneous points are (w_j b_j, w_j), or (b_j, 0) for the weight 0.
template <int Degree, int k, int N, class FT, class Coordinate, class Jet>
CGAL_GC_FORCEINLINE void rational_bezier_jet(int dimension, const FT& u, const FT& a, const FT& b,
                                             const std::array<FT, Degree + 1>& weights, const Coordinate& coordinate,
                                             Jet& jet) {
  const FT h = FT(b - a), t = FT((u - a) / h), s = FT(FT(1) - t);
  const std::array<FT, k + 1> factors = derivative_factors<k>(Degree, h);
  const int n = N == 0 ? dimension : N;
  std::array<FT, Degree + 1> c = weights, scales;
  for_each_index<Degree + 1>([&](int j) { scales[j] = weights[j] == FT(0) ? FT(1) : weights[j]; });
  std::array<FT, k + 1> w;
  bernstein_jet<Degree, k>(c, s, t, w.data());
  for_each_index<k>([&](int j) { w[j + 1] *= factors[j + 1]; });
  require_denominator(w[0], "the denominator of a rational curve");
  const FT inverse = FT(FT(1) / w[0]);
  CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
  for (int i = 0; i < n; ++i) {
    std::array<FT, Degree + 1> p;
    for_each_index<Degree + 1>([&](int j) { p[j] = FT(scales[j] * coordinate(j, i)); });
    std::array<FT, k + 1> x;
    bernstein_jet<Degree, k>(p, s, t, x.data());
    for_each_index<k>([&](int j) { x[j + 1] *= factors[j + 1]; });
    divide_derivatives<k>(x.data(), w.data(), inverse);
    for_each_index<k + 1>([&](int j) { jet[j][i] = x[j]; });
  }
}

// All coordinates together where their number is known to the compiler, otherwise one after the other.
template <int Degree, int N, class FT, class Coordinate, class Jet>
void bezier_jet_of_any_order(int dimension, int degree, const FT& u, const FT& a, const FT& b, int k,
                             const Coordinate& coordinate, Jet& jet) {
  constexpr int width = N == 0 ? 1 : N;
  typedef Coordinate_vector<FT, width> Block;
  const FT h = FT(b - a), t = FT((u - a) / h), inverse = FT(FT(1) / h);
  for (int first = 0; first < dimension; first += width) {
    Bezier_coefficients<Degree, Block> c;
    if constexpr (Degree < 0) c.resize(degree + 1);
    for (int j = 0; j <= degree; ++j)
      for (int i = 0; i < width; ++i) c[j][i] = coordinate(j, first + i);
    FT scale(1);
    bernstein_derivatives(c, degree, t, k, [&](int j, const Block& x) {
      for (int i = 0; i < width; ++i) jet[j][first + i] = scale * x[i];
      scale *= inverse;
    });
  }
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_ON

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_BEZIER_JET_H
