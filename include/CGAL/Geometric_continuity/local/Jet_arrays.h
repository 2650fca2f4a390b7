// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_JET_ARRAYS_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_JET_ARRAYS_H

#include <CGAL/Geometric_continuity/local/Coordinate_jet.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityLocal
/// Many jets of order `k` in dimension `N` as a structure of arrays: for each derivative and each coordinate one array with
/// the numbers of all jets. This is the layout in which a processor computes several jets at a time.
/// \tparam FT a field number type, usually `double`
template <class FT_, int N, int k> class Jet_arrays {
  static_assert(N > 0 && k >= 0);
  std::size_t size_ = 0, stride_ = 0;
  std::vector<FT_> numbers_;

public:
  typedef FT_ FT; ///< the field

  /// No jets.
  Jet_arrays() = default;
  /// `n` jets with unspecified numbers.
  explicit Jet_arrays(std::size_t n) { resize(n); }

  /// Changes the number of jets. The numbers are unspecified afterwards; no memory is allocated when there is enough.
  void resize(std::size_t n) {
    size_ = n;
    // An odd number of cache lines lies between two arrays: else their numbers would compete for a few lines of the cache.
    constexpr std::size_t line = 8;
    stride_ = line * ((n + line - 1) / line | 1);
    numbers_.resize(stride_ * (k + 1) * N);
  }
  /// Returns the number of jets.
  std::size_t size() const { return size_; }

  /// Gives access to the coordinates number `i` of the derivatives of order `j` of all jets, an array of `size()` numbers.
  /// \pre `0 <= j <= k`, `0 <= i < N`
  FT* array(int j, int i) { return numbers_.data() + (j * N + i) * stride_; }
  /// Returns the coordinates number `i` of the derivatives of order `j` of all jets, an array of `size()` numbers.
  /// \pre `0 <= j <= k`, `0 <= i < N`
  const FT* array(int j, int i) const { return numbers_.data() + (j * N + i) * stride_; }

  /// Returns the jet number `at`. \pre `at < size()`
  Coordinate_jet<FT, N> jet(std::size_t at) const {
    Coordinate_jet<FT, N> r(N, k);
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i < N; ++i) r[j][i] = array(j, i)[at];
    return r;
  }

  /// Replaces the jet number `at`. \pre `at < size()`
  /// \throws Error `jet_order_too_low` unless the jet has at least the order `k`
  /// \throws Error `dimension_mismatch` unless it has the dimension `N`
  template <int M> void set(std::size_t at, const Coordinate_jet<FT, M>& jet) {
    if (jet.order() < k) throw Error(Error_code::jet_order_too_low, "Jet_arrays::set");
    if (jet.dimension() != N) throw Error(Error_code::dimension_mismatch, "Jet_arrays::set");
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i < N; ++i) array(j, i)[at] = jet[j][i];
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_JET_ARRAYS_H
