// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_DETERMINANT_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_DETERMINANT_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// \file determinant.h
/// Determinants: without divisions where that is cheap, so that numbers stay short, and otherwise by elimination; Gram determinants,
/// and the coordinates in the plane of two vectors, which are quotients of such. *Algebraic G1 connection*, (7) to (11).

namespace CGAL {
namespace Geometric_continuity {

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

// By Gaussian elimination in the field, O(n^3). The pivot is the largest number of a column, when they are rounded.
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
/// Returns the determinant of the `n` x `n` matrix with entries `entry(row, column)`: up to `n == 6` without divisions,
/// by Laplace expansion; above, by elimination in the field, in \f$ O(n^3) \f$. The determinant without rows is 1.
/// \throws Error `negative_count` when `n` is negative
template <class FT, class Entry> FT determinant(int n, Entry entry) {
  if (n < 0) throw Error(Error_code::negative_count, "determinant: rows");
  if (n == 1) return entry(0, 0);
  if (n == 2) return FT(entry(0, 0) * entry(1, 1) - entry(0, 1) * entry(1, 0));
  if (n <= 6) return internal::determinant_by_minors<FT>(n, entry);
  return internal::determinant_by_elimination<FT>(n, entry);
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the Gram determinant \f$ \det (v_a \cdot v_b) \f$ of the vectors: the squared volume they span,
/// zero if and only if they are linearly dependent. It costs the determinant of as many rows as there are vectors.
template <class FT, int N> FT gram_determinant(const std::vector<Coordinate_vector<FT, N>>& v) {
  const int n = static_cast<int>(v.size());
  if (n == 0) return FT(1);
  std::vector<FT> products(n * n);
  for (int a = 0; a < n; ++a)
    for (int b = 0; b <= a; ++b) products[a * n + b] = products[b * n + a] = dot(v[a], v[b]);
  return determinant<FT>(n, [&](int a, int b) -> const FT& { return products[a * n + b]; });
}

/// \ingroup PkgGeometricContinuityAlgebra
/// The coordinates \f$ (\alpha, \beta) \f$ of vectors \f$ u = \alpha v + \beta w \f$ in the plane of two independent vectors
/// \f$ v, w \f$, by the normal equations
/// \f[ \left[\begin{array}{cc} v \cdot v & v \cdot w \\ v \cdot w & w \cdot w \end{array}\right]
///     \left[\begin{array}{c} \alpha \\ \beta \end{array}\right] = \left[\begin{array}{c} v \cdot u \\ w \cdot u \end{array}\right], \f]
/// in any dimension and without a root. *Algebraic G1 connection*, (7) to (11).
/// \tparam FT a field number type \tparam N the dimension, or 0 if it is known at run time only
template <class FT, int N> class Plane_coordinates {
public:
  typedef Coordinate_vector<FT, N> Vector; ///< the vectors

  /// Takes the two vectors. \f$ O(n) \f$ in dimension `n`
  /// \param place what the text of the error names
  /// \throws Error `singular_frame` when \f$ v \f$ and \f$ w \f$ are parallel, or one of them is zero
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

  /// Returns the coordinates of the vector of the plane that is nearest to `u`: of `u` itself, if it is in the plane.
  /// \f$ O(n) \f$
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

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_DETERMINANT_H
