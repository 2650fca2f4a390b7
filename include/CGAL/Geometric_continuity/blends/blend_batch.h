// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_BATCH_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_BATCH_H

#include <CGAL/Geometric_continuity/blends/automatic_shape.h>
#include <CGAL/Geometric_continuity/blends/quintic_strategies.h>
#include <CGAL/Geometric_continuity/internal/for_each_block.h>
#include <CGAL/Geometric_continuity/internal/independent_iterations.h>
#include <CGAL/Geometric_continuity/local/Jet_arrays.h>

#include <array>
#include <cstddef>
#include <string>

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_OFF

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// Many quintic blends as a structure of arrays: for each control point and each coordinate one array.
/// \tparam FT a field number type, usually `double` \tparam N the dimension
template <class FT, int N> class Blend_arrays {
  Jet_arrays<FT, N, 5> points_;

public:
  /// Changes the number of blends. The numbers are unspecified afterwards.
  void resize(std::size_t n) { points_.resize(n); }
  /// Returns the number of blends.
  std::size_t size() const { return points_.size(); }
  /// Returns the coordinates number `i` of the control points number `j`, 0 to 5, of all blends, an array of `size()` numbers.
  FT* array(int j, int i) { return points_.array(j, i); }
  /// Returns the coordinates number `i` of the control points number `j`, 0 to 5, of all blends, an array of `size()` numbers.
  const FT* array(int j, int i) const { return points_.array(j, i); }
};

namespace internal {

template <class FT, int N, int k> FT squared_tangent(const Jet_arrays<FT, N, k>& jets, std::size_t at) {
  FT square(0);
  for_each_index<N>([&](int i) { square += jets.array(1, i)[at] * jets.array(1, i)[at]; });
  return square;
}

template <class FT, int N, int k> void check_tangents(const Jet_arrays<FT, N, k>& jets, const char* place) {
  std::size_t zeros = 0; // counted first, which is done for several jets at a time
  for (std::size_t at = 0; at < jets.size(); ++at) zeros += squared_tangent(jets, at) == FT(0) ? 1 : 0;
  if (zeros == 0) return;
  std::size_t at = 0;
  while (!(squared_tangent(jets, at) == FT(0))) ++at;
  throw Error(Error_code::zero_tangent, place + std::to_string(at));
}

// `shape(at)` returns the shape parameters of the blend number `at`.
template <class Concurrency_tag, class FT, int N, int k, class Strategy, class Shape>
void blend_arrays(const Jet_arrays<FT, N, k>& phi, const Jet_arrays<FT, N, k>& psi, const Strategy& strategy,
                  const Shape& shape, Blend_arrays<FT, N>& gamma) {
  static_assert(k >= 2, "a quintic blend reads 2 derivatives");
  if (phi.size() != psi.size()) throw Error(Error_code::wrong_number_of_points, "blend: the numbers of jets differ");
  check_tangents(phi, "blend: end of the first curve number ");
  check_tangents(psi, "blend: start of the second curve number ");
  gamma.resize(phi.size());
  for_each_block<Concurrency_tag>(phi.size(), [&](std::size_t begin, std::size_t end) {
    typedef Coordinate_vector<FT, N> Vector;
    std::array<std::array<const FT*, N>, 3> x, y;
    std::array<std::array<FT*, N>, 6> out;
    for (int i = 0; i < N; ++i) {
      for (int j = 0; j < 3; ++j) {
        x[j][i] = phi.array(j, i);
        y[j][i] = psi.array(j, i);
      }
      for (int j = 0; j < 6; ++j) out[j][i] = gamma.array(j, i);
    }
    CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (std::size_t at = begin; at < end; ++at) {
      const auto read = [&](const std::array<const FT*, N>& arrays) {
        Vector v;
        for_each_index<N>([&](int i) { v[i] = arrays[i][at]; });
        return v;
      };
      const auto write = [&](const std::array<FT*, N>& arrays, const Vector& v) {
        for_each_index<N>([&](int i) { arrays[i][at] = v[i]; });
      };
      // compilers keep e and p in registers only when they are not const
      const std::array<Vector, 3> left = {read(x[0]), read(x[1]), read(x[2])},
                                  right = {read(y[0]), read(y[1]), read(y[2])};
      Quintic_ends<FT, N> e(left, right, shape(at));
      Quintic_parameters<FT> p = strategy(e);
      write(out[0], e.a1);
      write(out[1], e.b1());
      write(out[2], e.c1(p.s1));
      write(out[3], e.c2(p.s2));
      write(out[4], e.b2());
      write(out[5], e.a2);
    }
  });
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Computes the quintic blends of many pairs of jets with the same shape parameters, as `blend()` does one by one. The formulas
/// are those of the strategy, and the compiler computes several blends at a time. \f$ O(n) \f$. That the numbers are finite is the
/// caller's duty: a blend of others is not finite either.
///
/// \param phi,psi `n` jets of order at least 2 at the ends of the first and at the starts of the second curves
/// \param shape the shape parameters of all blends, both positive
/// \param gamma the blends, resized to `n`
/// \tparam Strategy a quintic strategy without branches, which excludes `Near_line` and `Fair`
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
/// \throws Error `nonpositive_beta` unless both shape parameters are positive; `wrong_number_of_points` when the numbers of jets
///   differ; `zero_tangent`, before anything is computed, when a first derivative is zero
template <class Concurrency_tag = Sequential_tag, class FT, int N, int k, class Strategy>
void blend(const Jet_arrays<FT, N, k>& phi, const Jet_arrays<FT, N, k>& psi, const Strategy& strategy,
           const Shape_parameters<FT>& shape, Blend_arrays<FT, N>& gamma) {
  if (!(FT(0) < shape.beta && FT(0) < shape.eta)) throw Error(Error_code::nonpositive_beta, "blend: of many jets");
  internal::blend_arrays<Concurrency_tag>(
      phi, psi, strategy, [&](std::size_t) { return shape; }, gamma);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Computes the quintic blends of many pairs of jets with the shape parameters of `automatic_shape()`, as `blend()` does one by
/// one. \f$ O(n) \f$. That the numbers are finite is the caller's duty.
///
/// \param phi,psi `n` jets of order at least 2 at the ends of the first and at the starts of the second curves
/// \param gamma the blends, resized to `n`
/// \tparam Strategy a quintic strategy for given shape parameters
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
/// \throws Error `wrong_number_of_points` when the numbers of jets differ; `zero_tangent`, before anything is computed, when
///   a first derivative is zero
template <class Concurrency_tag = Sequential_tag, class FT, int N, int k, class Strategy>
void blend(const Jet_arrays<FT, N, k>& phi, const Jet_arrays<FT, N, k>& psi, const Strategy& strategy,
           Blend_arrays<FT, N>& gamma) {
  internal::blend_arrays<Concurrency_tag>(
      phi, psi, strategy, [&](std::size_t at) { return internal::automatic_shape<FT, N>(phi.jet(at), psi.jet(at)); },
      gamma);
}

} // namespace Geometric_continuity
} // namespace CGAL

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_ON

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_BATCH_H
