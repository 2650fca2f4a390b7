// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_FRENET_FRAME_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_FRENET_FRAME_H

#include <CGAL/Geometric_continuity/local/curvatures.h>
#include <CGAL/Geometric_continuity/numbers/internal/square_root.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The vector v with det(rows, v) = v.v that is orthogonal to the n-1 rows: the cofactors of the last row. O(n^4)
template <class FT, int N>
Coordinate_vector<FT, N> orthogonal_complement(const std::vector<Coordinate_vector<FT, N>>& rows) {
  const int n = static_cast<int>(rows.size()) + 1;
  Coordinate_vector<FT, N> v(n);
  for (int i = 0; i < n; ++i) {
    const FT minor = determinant<FT>(
        n - 1, [&](int row, int column) -> const FT& { return rows[row][column < i ? column : column + 1]; });
    v[i] = (n - 1 - i) % 2 == 0 ? minor : FT(FT(0) - minor);
  }
  return v;
}

// The Frenet frame of a curve with these first n-1 derivatives, empty where they are linearly dependent.
template <class FT, int N>
std::optional<std::vector<Coordinate_vector<FT, N>>>
frenet_vectors(const std::vector<Coordinate_vector<FT, N>>& derivatives) {
  std::vector<Coordinate_vector<FT, N>> e;
  for (const Coordinate_vector<FT, N>& d : derivatives) {
    e.push_back(orthogonal_component(d, e));
    if (is_zero(e.back())) return std::nullopt;
  }
  e.push_back(orthogonal_complement(derivatives));
  return e;
}

// 2^e v, or times a power of two with which no number overflows, and not all vanish.
template <class FT, int N> Coordinate_vector<FT, N> scaled_within_range(const Coordinate_vector<FT, N>& v, int e) {
  if constexpr (std::is_floating_point_v<FT>) {
    typedef std::numeric_limits<FT> Limits;
    const int exponent = exponent_of(v, "frenet_frame");
    const int target = (std::max)(Limits::min_exponent, (std::min)(exponent + e, Limits::max_exponent - 2));
    return times_power_of_two(v, target - exponent, "frenet_frame");
  } else
    return v;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityLocal
/// The Frenet frame of a curve in \f$ E^n \f$ as `n` orthogonal vectors \f$ e_1, \dots, e_n \f$ with positive
/// orientation: \f$ e_i \f$ is the component of \f$ x^{(i)} \f$ orthogonal to the earlier ones for `i < n`, and
/// \f$ e_n \f$ completes them, so that no root is needed. Hagen 1.2, 1.3.
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> class Frenet_frame {
public:
  typedef Traits_ Traits;                                        ///< the traits class
  typedef typename Traits::FT FT;                                ///< the field
  typedef typename Traits::Vector Vector;                        ///< the vectors of the kernel
  typedef Geometric_continuity::Coordinates<Traits> Coordinates; ///< their coordinates

  /// Takes the coordinates of `n` vectors of dimension `n`. That they are orthogonal is not checked.
  /// \throws Error `dimension_mismatch` when a vector does not have the dimension `n`
  explicit Frenet_frame(std::vector<Coordinates> e) : e_(std::move(e)) {
    for (const Coordinates& v : e_)
      if (v.dimension() != dimension())
        throw Error(Error_code::dimension_mismatch, "Frenet_frame: " + std::to_string(e_.size()) +
                                                        " vectors, one of them of dimension " +
                                                        std::to_string(v.dimension()));
  }

  /// Returns the dimension `n`, which is the number of vectors.
  int dimension() const { return static_cast<int>(e_.size()); }

  /// Returns the vector \f$ e_i \f$: \f$ e_1 \f$ is the tangent, \f$ e_2 \f$ the principal normal, in space
  /// \f$ e_3 \f$ the binormal. \pre `1 <= i <= dimension()`
  Vector vector(int i) const { return Geometric_continuity::to_vector<Traits>(e_[i - 1]); }

  /// Returns the coordinates of \f$ e_i \f$. \pre `1 <= i <= dimension()`
  const Coordinates& coordinates(int i) const { return e_[i - 1]; }

  /// Returns the frame with unit vectors; only for number types that have a square root.
  /// \throws Error `zero_direction` when a vector is zero, `not_finite` when one is infinite or undefined
  Frenet_frame normalized() const {
    std::vector<Coordinates> unit;
    for (const Coordinates& v : e_) {
      const internal::Scaled_vector<FT, dimension_v<Traits>> x(v, "Frenet_frame::normalized");
      const FT square = dot(*x, *x);
      if (square == FT(0)) throw Error(Error_code::zero_direction, "Frenet_frame::normalized");
      unit.push_back(*x / internal::square_root(square));
    }
    return Frenet_frame(std::move(unit));
  }

private:
  std::vector<Coordinates> e_;
};

/// \ingroup PkgGeometricContinuityLocal
/// Returns the Frenet frame at a jet; empty where the first `n - 1` derivatives are linearly dependent. With floating-point
/// numbers a power of two keeps \f$ e_n \f$, whose length is the volume that these derivatives span, within the range of
/// the number type. \f$ O(n^4) \f$
/// \throws Error `jet_order_too_low` with fewer than `n - 1` derivatives, and for an empty jet
/// \throws Error `not_finite` when a derivative is infinite or undefined
template <class Traits> std::optional<Frenet_frame<Traits>> frenet_frame(const Curve_jet<Traits>& jet) {
  typedef typename Traits::FT FT;
  constexpr int N = dimension_v<Traits>;
  const int n = jet.dimension();
  internal::require_order(jet, (std::max)(n - 1, 0), "frenet_frame");
  std::vector<Coordinate_vector<FT, N>> derivatives;
  std::vector<int> exponents;
  int sum = 0;
  for (int i = 1; i < n; ++i) {
    const internal::Scaled_vector<FT, N> x(jet[i], "frenet_frame");
    derivatives.push_back(*x);
    exponents.push_back(x.exponent());
    sum += x.exponent();
  }
  std::optional<std::vector<Coordinate_vector<FT, N>>> e = internal::frenet_vectors(derivatives);
  if (!e) return std::nullopt;
  for (int i = 0; i + 1 < n; ++i) (*e)[i] = internal::times_power_of_two((*e)[i], exponents[i], "frenet_frame");
  (*e)[n - 1] = internal::scaled_within_range((*e)[n - 1], sum);
  return Frenet_frame<Traits>(std::move(*e));
}

/// \ingroup PkgGeometricContinuityLocal
/// The matrix `w` of the Frenet equations \f$ e_i' = \sum_j w_{ij} e_j \f$ for the \em orthonormal Frenet frame. It is skew
/// and tridiagonal, with \f$ w_{i,i+1} = |X'| \kappa_i = -w_{i+1,i} \f$. Hagen (1.6), in the plane (1.8), in space (1.10).
/// \tparam FT a field number type
template <class FT> class Frenet_matrix {
  std::vector<FT> w_; // w_{12}, ..., w_{n-1,n}

public:
  /// Takes the speed \f$ |X'| \f$ and the `n - 1` curvatures \f$ \kappa_1, \dots, \kappa_{n-1} \f$.
  Frenet_matrix(const FT& speed, std::vector<FT> curvatures) : w_(std::move(curvatures)) {
    for (FT& w : w_) w *= speed;
  }

  /// Returns the dimension `n`, one more than the number of curvatures.
  int dimension() const { return static_cast<int>(w_.size()) + 1; }

  /// Returns the entry \f$ w_{ij} \f$. \pre `1 <= i <= dimension()`, `1 <= j <= dimension()`
  FT operator()(int i, int j) const { return j == i + 1 ? FT(w_[i - 1]) : j + 1 == i ? FT(-w_[j - 1]) : FT(0); }

  /// Returns the derivatives \f$ e_1', \dots, e_n' \f$ of the orthonormal vectors \f$ e_1, \dots, e_n \f$. \f$ O(n^2) \f$
  /// \throws Error `dimension_mismatch` unless there are `n` vectors of dimension `n`
  template <int N>
  std::vector<Coordinate_vector<FT, N>> operator()(const std::vector<Coordinate_vector<FT, N>>& e) const {
    const int n = dimension();
    if (static_cast<int>(e.size()) != n || e[0].dimension() != n)
      throw Error(Error_code::dimension_mismatch, "Frenet_matrix: " + std::to_string(e.size()) + " vectors");
    std::vector<Coordinate_vector<FT, N>> d(n, Coordinate_vector<FT, N>(n));
    for (int i = 0; i + 1 < n; ++i) {
      d[i] += w_[i] * e[i + 1];
      d[i + 1] -= w_[i] * e[i];
    }
    return d;
  }

  /// Writes the rows, one to a line.
  friend std::ostream& operator<<(std::ostream& os, const Frenet_matrix& w) {
    for (int i = 1; i <= w.dimension(); ++i)
      for (int j = 1; j <= w.dimension(); ++j) os << w(i, j) << (j < w.dimension() ? ' ' : '\n');
    return os;
  }
};

/// \ingroup PkgGeometricContinuityLocal
/// Returns the matrix of the Frenet equations at a jet; empty where the first `n - 1` derivatives are linearly dependent. Only for
/// number types that have a square root; `frenet_curvatures()` gives the squares of the curvatures in any field.
/// \throws Error `jet_order_too_low` with fewer than `n` derivatives, `not_finite` when the square of a curvature overflows
template <class Traits> std::optional<Frenet_matrix<typename Traits::FT>> frenet_matrix(const Curve_jet<Traits>& jet) {
  typedef typename Traits::FT FT;
  std::vector<FT> kappa;
  for (const std::optional<Signed_square<FT>>& k : frenet_curvatures(jet)) {
    if (!k) return std::nullopt;
    const FT root = internal::square_root(k->square);
    kappa.push_back(k->sign < 0 ? FT(-root) : root);
  }
  const internal::Scaled_vector<FT, dimension_v<Traits>> d1(jet[1], "frenet_matrix");
  const FT speed = internal::square_root(FT(dot(*d1, *d1)));
  return Frenet_matrix<FT>(internal::times_power_of_two(speed, d1.exponent(), "frenet_matrix"), std::move(kappa));
}

/// \ingroup PkgGeometricContinuityLocal
/// Returns the derivatives \f$ e_1', \dots, e_n' \f$, with respect to the parameter, of the orthonormal Frenet frame at a jet;
/// empty where the first `n - 1` derivatives are linearly dependent. Only for number types that have a square root.
/// Hagen (1.6).
/// \throws Error `jet_order_too_low` with fewer than `n` derivatives, `not_finite` when the square of a curvature overflows
template <class Traits>
std::optional<std::vector<typename Traits::Vector>> frenet_frame_derivatives(const Curve_jet<Traits>& jet) {
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;
  const std::optional<Frenet_matrix<typename Traits::FT>> w = frenet_matrix(jet);
  const std::optional<Frenet_frame<Traits>> frame = frenet_frame(jet);
  if (!w || !frame) return std::nullopt;
  const Frenet_frame<Traits> unit = frame->normalized();
  std::vector<Coordinates> e;
  for (int i = 1; i <= unit.dimension(); ++i) e.push_back(unit.coordinates(i));
  std::vector<typename Traits::Vector> derivatives;
  for (const Coordinates& d : (*w)(e)) derivatives.push_back(Geometric_continuity::to_vector<Traits>(d));
  return derivatives;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_FRENET_FRAME_H
