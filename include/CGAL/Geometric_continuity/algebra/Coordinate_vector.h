// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_COORDINATE_VECTOR_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_COORDINATE_VECTOR_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/internal/for_each_index.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>
#include <vector>

/// \file Coordinate_vector.h
/// Columns of numbers, with which all formulas of the package are written.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// A column of `N` field elements with the operations of a vector space and the dot product. All
/// formulas of the package are written on this type, so that one text serves every kernel and
/// every dimension.
///
/// That two vectors of a dimension known at run time only have the same dimension when they meet is the caller's duty:
/// these operations run in the innermost loops. The functions of the package that read points and vectors check it.
///
/// \tparam FT a field number type
/// \tparam N the dimension, or 0 when it is known at run time only
template <class FT, int N> class Coordinate_vector {
  std::conditional_t<N == 0, std::vector<FT>, std::array<FT, N>> c_;

public:
  /// Constructs an empty (`N == 0`) vector, or one with unspecified coordinates.
  Coordinate_vector() = default;

  /// Constructs the zero vector of dimension `d`.
  /// \throws Error `dimension_mismatch` unless `N` is `d` or 0, `negative_count` when `d` is negative
  explicit Coordinate_vector(int d) {
    if constexpr (N == 0) {
      if (d < 0) throw Error(Error_code::negative_count, "vector of negative dimension");
      c_.assign(d, FT(0));
    } else {
      if (d != N) refuse_dimension(d);
      for_each([&](int i) { c_[i] = FT(0); });
    }
  }

  /// Returns the number of coordinates.
  int dimension() const { return static_cast<int>(c_.size()); }
  /// Returns the coordinate number `i`, `0 <= i < dimension()`.
  FT& operator[](int i) { return c_[i]; }
  /// Returns the coordinate number `i`, `0 <= i < dimension()`.
  const FT& operator[](int i) const { return c_[i]; }
  /// Returns an iterator to the first coordinate.
  auto begin() const { return c_.begin(); }
  /// Returns the iterator behind the last coordinate.
  auto end() const { return c_.end(); }

  /// Adds a vector.
  Coordinate_vector& operator+=(const Coordinate_vector& v) {
    for_each([&](int i) { c_[i] += v[i]; });
    return *this;
  }
  /// Subtracts a vector.
  Coordinate_vector& operator-=(const Coordinate_vector& v) {
    for_each([&](int i) { c_[i] -= v[i]; });
    return *this;
  }
  /// Multiplies by a number.
  Coordinate_vector& operator*=(const FT& s) {
    for_each([&](int i) { c_[i] *= s; });
    return *this;
  }
  /// Divides by a number.
  Coordinate_vector& operator/=(const FT& s) {
    for_each([&](int i) { c_[i] /= s; });
    return *this;
  }

  /// Returns the sum.
  friend Coordinate_vector operator+(Coordinate_vector v, const Coordinate_vector& w) {
    v += w;
    return v;
  }
  /// Returns the difference.
  friend Coordinate_vector operator-(Coordinate_vector v, const Coordinate_vector& w) {
    v -= w;
    return v;
  }
  /// Returns the product with a number.
  friend Coordinate_vector operator*(const FT& s, Coordinate_vector v) {
    v *= s;
    return v;
  }
  /// Returns the quotient by a number.
  friend Coordinate_vector operator/(Coordinate_vector v, const FT& s) {
    v /= s;
    return v;
  }
  /// Decides whether dimension and coordinates are equal.
  friend bool operator==(const Coordinate_vector& v, const Coordinate_vector& w) {
    return std::equal(v.begin(), v.end(), w.begin(), w.end(), [](const FT& x, const FT& y) { return bool(x == y); });
  }
  /// Decides whether the dimension or a coordinate is different.
  friend bool operator!=(const Coordinate_vector& v, const Coordinate_vector& w) { return !(v == w); }

  /// Returns the dot product.
  friend FT dot(const Coordinate_vector& v, const Coordinate_vector& w) {
    if constexpr (N == 0) {
      FT sum(0);
      for (int i = 0; i < v.dimension(); ++i) sum += v[i] * w[i];
      return sum;
    } else {
      FT sum(v[0] * w[0]);
      internal::for_each_index<N - 1>([&](int i) { sum += v[i + 1] * w[i + 1]; });
      return sum;
    }
  }
  /// Decides whether all coordinates are zero.
  friend bool is_zero(const Coordinate_vector& v) {
    return std::all_of(v.begin(), v.end(), [](const FT& x) { return bool(x == FT(0)); });
  }

private:
  static void refuse_dimension(int d) {
    throw Error(Error_code::dimension_mismatch,
                "vector of dimension " + std::to_string(d) + " where " + std::to_string(N) + " is expected");
  }

  // f(i) for each coordinate number i
  template <class Function> CGAL_GC_FORCEINLINE void for_each(const Function& f) const {
    if constexpr (N == 0)
      for (int i = 0; i < dimension(); ++i) f(i);
    else
      internal::for_each_index<N>(f);
  }
};

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the cross product of two vectors of dimension 3.
/// \throws Error `dimension_mismatch` when a vector has another dimension
template <class FT, int N>
Coordinate_vector<FT, N> cross_product(const Coordinate_vector<FT, N>& v, const Coordinate_vector<FT, N>& w) {
  static_assert(N == 0 || N == 3, "the cross product is defined in dimension 3");
  if constexpr (N == 0)
    if (v.dimension() != 3 || w.dimension() != 3) throw Error(Error_code::dimension_mismatch, "cross_product");
  Coordinate_vector<FT, N> n(3);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    n[i] = FT(v[j] * w[k] - v[k] * w[j]);
  }
  return n;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the component of `v` orthogonal to `d`, \f$ v - \frac{v \cdot d}{d \cdot d}\, d \f$.
/// \throws Error `zero_direction` when \f$ d \cdot d \f$ is zero
template <class FT, int N>
Coordinate_vector<FT, N> orthogonal_component(const Coordinate_vector<FT, N>& v, const Coordinate_vector<FT, N>& d) {
  const FT square = dot(d, d);
  if (CGAL::certainly(square == FT(0))) throw Error(Error_code::zero_direction, "orthogonal_component");
  return v - FT(dot(v, d) / square) * d;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the component of `v` orthogonal to all `q`, which are orthogonal to each other: one step of Gram and
/// Schmidt.
/// \throws Error `zero_direction` when \f$ q \cdot q \f$ is zero for a vector `q`
template <class FT, int N>
Coordinate_vector<FT, N> orthogonal_component(Coordinate_vector<FT, N> v,
                                              const std::vector<Coordinate_vector<FT, N>>& q) {
  for (const Coordinate_vector<FT, N>& d : q) v = orthogonal_component(v, d);
  return v;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_COORDINATE_VECTOR_H
