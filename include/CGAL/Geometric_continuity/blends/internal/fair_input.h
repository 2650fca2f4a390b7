// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_INPUT_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_INPUT_H

#include <CGAL/Geometric_continuity/blends/internal/Fair_family.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

// The family of blends of two jets, in floating-point numbers: moved to the origin, scaled so that the chord has a length near 1,
// and in a dimension of at most 7. None of this changes what is fair.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// 2 and 3 are as they are. In other dimensions the vectors that are given, 2 order + 1, span the space that is needed.
template <int N, int order> constexpr int fair_dimension = N == 2 || N == 3 ? N : 2 * order + 1;

// The coordinates of vectors with respect to an orthonormal basis of the space that they span, by the method of Gram and Schmidt.
template <int M, int N, std::size_t n>
std::array<Coordinate_vector<double, M>, n>
orthonormal_coordinates(std::array<Coordinate_vector<double, N>, n> vectors) {
  std::array<Coordinate_vector<double, M>, n> result;
  std::vector<Coordinate_vector<double, N>> basis;
  for (std::size_t k = 0; k < n; ++k) {
    Coordinate_vector<double, N>& v = vectors[k];
    result[k] = Coordinate_vector<double, M>(M);
    const double length = std::sqrt(dot(v, v));
    for (int repetition = 0; repetition < 2; ++repetition) // once more for what rounding has left
      for (std::size_t j = 0; j < basis.size(); ++j) {
        const double c = dot(v, basis[j]);
        result[k][static_cast<int>(j)] += c;
        v -= c * basis[j];
      }
    const double rest = std::sqrt(dot(v, v));
    if (!(rest > 1e-12 * length)) continue;
    result[k][static_cast<int>(basis.size())] = rest;
    basis.push_back(v / rest);
  }
  return result;
}

// From the jets at the end of the first and at the start of the second curve, and the shape parameters for which a = 0.
template <Blend_kind kind, class FT, int N, class Jet>
Fair_family<kind, fair_dimension<N, Fair_end<kind, 2>::order>> fair_family(const Jet& phi, const Jet& psi, double beta,
                                                                           double eta) {
  constexpr int order = Fair_end<kind, 2>::order, M = fair_dimension<N, order>;
  const int dimension = phi[0].dimension();
  typedef Coordinate_vector<double, N> Given;
  std::array<Given, 2 * order + 1> v; // the chord, the derivatives of phi, those of psi
  v.fill(Given(dimension));
  // Returns the largest coordinate of the chord and of both tangents.
  const auto take = [&](const FT& scale) {
    double largest = 0;
    for (int i = 0; i < dimension; ++i) {
      v[0][i] = CGAL::to_double(FT(FT(psi[0][i] - phi[0][i]) * scale));
      double power_of_beta = 1, power_of_eta = 1;
      for (int k = 1; k <= order; ++k) {
        v[k][i] = CGAL::to_double(FT(phi[k][i] * scale)) * (power_of_beta *= beta);
        v[order + k][i] = CGAL::to_double(FT(psi[k][i] * scale)) * (power_of_eta *= eta);
      }
      for (int k : {0, 1, order + 1}) largest = (std::max)(largest, std::abs(v[k][i]));
    }
    return largest;
  };
  double largest = take(FT(1));
  if constexpr (!std::is_floating_point_v<FT>)
    if (!(1e-100 < largest && largest < 1e100)) { // exact numbers of any size
      FT sum(0);
      for (int i = 0; i < dimension; ++i)
        sum += CGAL::abs(FT(psi[0][i] - phi[0][i])) + CGAL::abs(FT(FT(beta) * phi[1][i]));
      largest = take(FT(FT(1) / sum));
    }
  if (largest > 0 && largest <= (std::numeric_limits<double>::max)())
    for (Given& x : v)
      for (int i = 0; i < dimension; ++i) x[i] = std::ldexp(x[i], -std::ilogb(largest));
  std::array<Coordinate_vector<double, M>, 2 * order + 1> x;
  if constexpr (M == N)
    x = v;
  else
    x = orthonormal_coordinates<M>(v);
  Fair_family<kind, M> family{x[0], {{}, 1}, {{}, -1}};
  for (int k = 0; k < order; ++k) {
    family.start.d[k] = x[1 + k];
    family.end.d[k] = x[1 + order + k];
  }
  if constexpr (order == 2) // the second derivative without its tangential part, which is free
    for (Fair_end<kind, M>* end : {&family.start, &family.end})
      end->d[1] -= (dot(end->d[1], end->d[0]) / dot(end->d[0], end->d[0])) * end->d[0];
  return family;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_INPUT_H
