// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CONSTRUCTION_BLEND_BATCH_H
#define CGAL_GEOMETRIC_CONTINUITY_CONSTRUCTION_BLEND_BATCH_H

#include <CGAL/Geometric_continuity/construction/quintic_strategies.h>
#include <CGAL/Geometric_continuity/internal/for_each_block.h>
#include <CGAL/Geometric_continuity/internal/independent_iterations.h>
#include <CGAL/Geometric_continuity/local/Jet_arrays.h>

#include <cstddef>
#include <string>

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
  /// The number of blends.
  std::size_t size() const { return points_.size(); }
  /// The coordinates number `i` of the control points number `j`, 0 to 5, of all blends, an array of `size()` numbers.
  FT* array(int j, int i) { return points_.array(j, i); }
  const FT* array(int j, int i) const { return points_.array(j, i); }
};

namespace internal {

template <class FT, int N, int k> void check_tangents(const Jet_arrays<FT, N, k>& jets, const char* place) {
  for (std::size_t at = 0; at < jets.size(); ++at) {
    FT square(0);
    for (int i = 0; i < N; ++i) square += jets.array(1, i)[at] * jets.array(1, i)[at];
    if (square == FT(0)) throw Error(Error_code::zero_tangent, place + std::to_string(at));
  }
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// The quintic blends of many pairs of jets, as `blend()` computes them one by one, with the shape parameters
/// \f$ \beta = \eta = 1 \f$. The formulas are those of the strategy, and the compiler computes several blends at a time.
///
/// \param phi,psi `n` jets of order at least 2 at the ends of the first and at the starts of the second curves
/// \param gamma the blends, resized to `n`
/// \tparam Strategy a quintic strategy without branches, which excludes `Near_line`
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
/// \throws Error `wrong_number_of_points` when the numbers of jets differ; `zero_tangent`, before anything is computed, when
///   a first derivative is zero
template <class Concurrency_tag = Sequential_tag, class FT, int N, int k, class Strategy>
void blend(const Jet_arrays<FT, N, k>& phi, const Jet_arrays<FT, N, k>& psi, const Strategy& strategy,
           Blend_arrays<FT, N>& gamma) {
  static_assert(k >= 2, "a quintic blend reads 2 derivatives");
  if (phi.size() != psi.size()) throw Error(Error_code::wrong_number_of_points, "blend: the numbers of jets differ");
  internal::check_tangents(phi, "blend: end of the first curve number ");
  internal::check_tangents(psi, "blend: start of the second curve number ");
  gamma.resize(phi.size());
  internal::for_each_block<Concurrency_tag>(phi.size(), [&](std::size_t begin, std::size_t end) {
    typedef Coordinate_vector<FT, N> Vector;
    const FT *x[3][N], *y[3][N];
    FT* out[6][N];
    for (int i = 0; i < N; ++i) {
      for (int j = 0; j < 3; ++j) {
        x[j][i] = phi.array(j, i);
        y[j][i] = psi.array(j, i);
      }
      for (int j = 0; j < 6; ++j) out[j][i] = gamma.array(j, i);
    }
    const auto vector = [](const FT* const* arrays, std::size_t at) {
      Vector v;
      for (int i = 0; i < N; ++i) v[i] = arrays[i][at];
      return v;
    };
    CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (std::size_t at = begin; at < end; ++at) {
      const Quintic_ends<FT, N> e(vector(x[0], at), vector(y[0], at), vector(x[1], at), vector(y[1], at),
                                  vector(x[2], at), vector(y[2], at));
      const Quintic_parameters<FT> p = strategy(e);
      const Vector b1 = e.b1(), c1 = e.c1(p.s1), c2 = e.c2(p.s2), b2 = e.b2();
      for (int i = 0; i < N; ++i) {
        out[0][i][at] = e.a1[i];
        out[1][i][at] = b1[i];
        out[2][i][at] = c1[i];
        out[3][i][at] = c2[i];
        out[4][i][at] = b2[i];
        out[5][i][at] = e.a2[i];
      }
    }
  });
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CONSTRUCTION_BLEND_BATCH_H
