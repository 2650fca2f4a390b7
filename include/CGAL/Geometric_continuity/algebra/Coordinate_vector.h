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
#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Coordinate_vector.h
/// Columns of numbers, with which all formulas of the package are written, and their linear
/// algebra: determinants, without divisions where that is cheap, so that numbers stay short, and
/// otherwise by elimination; Gram determinants; and the coordinates in the plane of two vectors,
/// which are quotients of such. *Algebraic G1 connection*, (7) to (11).

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// A column of `N` field elements with the operations of a vector space and the dot product. All
/// formulas of the package are written on this type, so that one text serves every kernel and
/// every dimension.
///
/// The caller must ensure that two vectors whose dimension is known at run time only have the same
/// dimension, because these operations run in the innermost loops. The functions of the package
/// that read points and vectors check it.
///
/// \tparam FT a field number type
/// \tparam N the dimension, or 0 when it is known at run time only
template <class FT, int N> class Coordinate_vector {
  std::conditional_t<N == 0, std::vector<FT>, std::array<FT, N>> c_;

public:
  /// Constructs an empty (`N == 0`) vector, or one with unspecified coordinates.
  Coordinate_vector() = default;

  /// Constructs the zero vector of dimension `d`.
  /// \throws Error `dimension_mismatch` unless `N` is `d` or 0, `negative_count` when `d` is
  ///   negative
  explicit Coordinate_vector(int d) {
    if constexpr (N == 0) {
      if (d < 0) throw Error(Error_code::negative_count, "vector of negative dimension");
      c_.assign(d, FT(0));
    } else {
      if (d != N) refuse_dimension(d);
      for_each([&](int i) CGAL_GC_FORCEINLINE_LAMBDA { c_[i] = FT(0); });
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
    for_each([&](int i) CGAL_GC_FORCEINLINE_LAMBDA { c_[i] += v[i]; });
    return *this;
  }
  /// Subtracts a vector.
  Coordinate_vector& operator-=(const Coordinate_vector& v) {
    for_each([&](int i) CGAL_GC_FORCEINLINE_LAMBDA { c_[i] -= v[i]; });
    return *this;
  }
  /// Multiplies by a number.
  Coordinate_vector& operator*=(const FT& s) {
    for_each([&](int i) CGAL_GC_FORCEINLINE_LAMBDA { c_[i] *= s; });
    return *this;
  }
  /// Divides by a number.
  Coordinate_vector& operator/=(const FT& s) {
    for_each([&](int i) CGAL_GC_FORCEINLINE_LAMBDA { c_[i] /= s; });
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

  /// Writes the coordinates, e.g. `(1, 2)`.
  friend std::ostream& operator<<(std::ostream& os, const Coordinate_vector& v) {
    os << '(';
    for (int i = 0; i < v.dimension(); ++i) os << (i == 0 ? "" : ", ") << v[i];
    return os << ')';
  }

  /// Returns the dot product.
  friend FT dot(const Coordinate_vector& v, const Coordinate_vector& w) {
    if constexpr (N == 0) {
      FT sum(0);
      for (int i = 0; i < v.dimension(); ++i) sum += v[i] * w[i];
      return sum;
    } else {
      FT sum(v[0] * w[0]);
      internal::for_each_index<N - 1>([&](int i) CGAL_GC_FORCEINLINE_LAMBDA { sum += v[i + 1] * w[i + 1]; });
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
    internal::for_each_index<N>(dimension(), f);
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
/// Returns the component of `v` orthogonal to all `q`, which are orthogonal to each other: one step
/// of Gram and Schmidt.
/// \throws Error `zero_direction` when \f$ q \cdot q \f$ is zero for a vector `q`
template <class FT, int N>
Coordinate_vector<FT, N> orthogonal_component(Coordinate_vector<FT, N> v,
                                              const std::vector<Coordinate_vector<FT, N>>& q) {
  for (const Coordinate_vector<FT, N>& d : q) v = orthogonal_component(v, d);
  return v;
}

namespace internal {

// Without divisions, by Laplace expansion over the subsets of columns: n 2^(n-1) products.
template <class FT, class Entry> FT determinant_by_minors(int n, Entry entry) {
  // minors[columns]: determinant of the first |columns| rows restricted to these columns
  std::vector<FT> minors(std::size_t(1) << n, FT(0));
  minors[0] = FT(1);
  for (std::size_t columns = 1; columns < minors.size(); ++columns) {
    int row = -1;
    for (std::size_t rest = columns; rest != 0; rest &= rest - 1) ++row;
    int sign = 1;
    for (int j = n - 1; j >= 0; --j) {
      const std::size_t column = std::size_t(1) << j;
      if (!(columns & column)) continue;
      const FT term = entry(row, j) * minors[columns ^ column];
      if (sign > 0)
        minors[columns] += term;
      else
        minors[columns] -= term;
      sign = -sign;
    }
  }
  return minors.back();
}

// By Gaussian elimination in the field, O(n^3). The pivot is the largest number of a column, when
// they are rounded.
template <class FT, class Entry> FT determinant_by_elimination(int n, Entry entry) {
  std::vector<std::vector<FT>> rows(n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) rows[i].push_back(entry(i, j));
  FT product(1);
  for (int step = 0; step < n; ++step) {
    int pivot = step;
    for (int i = step + 1; i < n; ++i)
      if constexpr (std::is_floating_point_v<FT>) {
        if (std::abs(rows[pivot][step]) < std::abs(rows[i][step])) pivot = i;
      } else if (rows[pivot][step] == FT(0))
        pivot = i;
    if (rows[pivot][step] == FT(0)) return FT(0);
    if (pivot != step) {
      rows[pivot].swap(rows[step]);
      product = -product;
    }
    product *= rows[step][step];
    for (int i = step + 1; i < n; ++i) {
      if (rows[i][step] == FT(0)) continue;
      const FT factor = rows[i][step] / rows[step][step];
      for (int j = step + 1; j < n; ++j) rows[i][j] -= factor * rows[step][j];
    }
  }
  return product;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the determinant of the `n` x `n` matrix with entries `entry(row, column)`: up to
/// `n == 6` without divisions, by Laplace expansion; above, by elimination in the field, in
/// \f$ O(n^3) \f$. The determinant without rows is 1.
/// \throws Error `negative_count` when `n` is negative
template <class FT, class Entry> FT determinant(int n, Entry entry) {
  if (n < 0) throw Error(Error_code::negative_count, "determinant: rows");
  if (n == 1) return entry(0, 0);
  if (n == 2) return FT(entry(0, 0) * entry(1, 1) - entry(0, 1) * entry(1, 0));
  if (n <= 6) return internal::determinant_by_minors<FT>(n, entry);
  return internal::determinant_by_elimination<FT>(n, entry);
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the Gram determinant \f$ \det (v_a \cdot v_b) \f$ of the vectors: the squared volume
/// they span, zero if and only if they are linearly dependent. It costs the determinant of as many
/// rows as there are vectors.
template <class FT, int N> FT gram_determinant(const std::vector<Coordinate_vector<FT, N>>& v) {
  const int n = static_cast<int>(v.size());
  if (n == 0) return FT(1);
  std::vector<FT> products(n * n);
  for (int a = 0; a < n; ++a)
    for (int b = 0; b <= a; ++b) products[a * n + b] = products[b * n + a] = dot(v[a], v[b]);
  return determinant<FT>(n, [&](int a, int b) -> const FT& { return products[a * n + b]; });
}

/// \ingroup PkgGeometricContinuityAlgebra
/// The coordinates \f$ (\alpha, \beta) \f$ of vectors \f$ u = \alpha v + \beta w \f$ in the plane
/// of two independent vectors \f$ v, w \f$, by the normal equations
/// \f[ \left[\begin{array}{cc} v \cdot v & v \cdot w \\ v \cdot w & w \cdot w \end{array}\right]
///     \left[\begin{array}{c} \alpha \\ \beta \end{array}\right] = \left[\begin{array}{c} v \cdot u \\ w \cdot u \end{array}\right], \f]
/// in any dimension and without a root. *Algebraic G1 connection*, (7) to (11).
/// \tparam FT a field number type \tparam N the dimension, or 0 if it is known at run time only
template <class FT, int N> class Plane_coordinates {
public:
  typedef Coordinate_vector<FT, N> Vector; ///< the vectors

  /// Takes the two vectors. \f$ O(n) \f$ in dimension `n`
  /// \param place what the text of the error names
  /// \throws Error `singular_frame` when \f$ v \f$ and \f$ w \f$ are parallel, or one of them is
  ///   zero
  Plane_coordinates(const Coordinate_vector<FT, N>& v, const Coordinate_vector<FT, N>& w,
                    const char* place = "Plane_coordinates")
      : v_(v), w_(w), vv_(dot(v, v)), vw_(dot(v, w)), ww_(dot(w, w)), gram_(vv_ * ww_ - vw_ * vw_) {
    if (gram_ == FT(0)) throw Error(Error_code::singular_frame, place);
  }

  /// Returns the coordinates of `u`; empty if `u` is not in the plane. \f$ O(n) \f$
  std::optional<std::pair<FT, FT>> operator()(const Vector& u) const {
    const std::pair<FT, FT> c = multiples(u);
    if (gram_ * u != c.first * v_ + c.second * w_) return std::nullopt;
    return divided(c);
  }

  /// Returns the coordinates of the vector of the plane that is nearest to `u`: of `u` itself, if
  /// it is in the plane. \f$ O(n) \f$
  std::pair<FT, FT> nearest(const Vector& u) const { return divided(multiples(u)); }

private:
  Vector v_, w_;
  FT vv_, vw_, ww_, gram_;

  // the numerators of (11)
  std::pair<FT, FT> multiples(const Vector& u) const {
    const FT vu = dot(v_, u), wu = dot(w_, u);
    return {FT(ww_ * vu - vw_ * wu), FT(vv_ * wu - vw_ * vu)};
  }
  std::pair<FT, FT> divided(const std::pair<FT, FT>& c) const { return {FT(c.first / gram_), FT(c.second / gram_)}; }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_COORDINATE_VECTOR_H
