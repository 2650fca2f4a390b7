// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVATURES_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVATURES_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/internal/independent_iterations.h>
#include <CGAL/Geometric_continuity/internal/parallel.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/local/internal/Scaled_vector.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/square_root.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file curvatures.h
/// Curvature, torsion and all curvatures of a curve in \f$ E^n \f$ from its jet, without roots, and
/// hence exact in every field: \f$ \kappa_i^2 = G_{i-1} G_{i+1} / (G_i^2 G_1) \f$ with the Gram
/// determinants \f$ G_i \f$ of the derivatives (Hagen (1.5), (1.9), (1.11), (1.12)); the Frenet
/// frame, and the Frenet equations, which take roots.
///
/// With floating-point numbers all these functions compute with derivatives that are scaled by
/// powers of two, so that no intermediate number overflows. A result that is too large for the
/// number type, and derivatives that are not finite, are refused (`Error`, `not_finite`); one that
/// is too small is rounded to 0.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityLocal
/// A real number given without a root, by its sign and its square.
template <class FT> struct Signed_square {
  int sign;  ///< -1, 0 or 1
  FT square; ///< the square of the number

  /// Returns whether the two numbers are equal.
  friend bool operator==(const Signed_square& x, const Signed_square& y) {
    return x.sign == y.sign && x.square == y.square;
  }
  /// Returns whether the two numbers differ.
  friend bool operator!=(const Signed_square& x, const Signed_square& y) { return !(x == y); }
  /// Writes the number with a root sign, e.g. `-sqrt(1/16)`.
  friend std::ostream& operator<<(std::ostream& os, const Signed_square& x) {
    return os << (x.sign < 0 ? "-" : "") << "sqrt(" << x.square << ')';
  }
};

namespace internal {

template <class FT, int N> void require_order(const Coordinate_jet<FT, N>& jet, int order, const char* function) {
  if (jet.order() < order)
    throw Error(Error_code::jet_order_too_low, std::string(function) + " reads " + std::to_string(order) +
                                                   " derivatives, the jet has " + std::to_string(jet.order()));
}

template <int d, class FT, int N> void require_dimension(const Coordinate_jet<FT, N>& jet, const char* function) {
  static_assert(N == 0 || N == d, "the function is not defined in this dimension");
  if (jet.dimension() != d)
    throw Error(Error_code::dimension_mismatch, std::string(function) + " is defined in dimension " +
                                                    std::to_string(d) + ", the jet has " +
                                                    std::to_string(jet.dimension()));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityLocal
/// Returns the Gram determinants \f$ G_0 = 1, G_1, \dots, G_k \f$ of the first `k` derivatives,
/// \f$ G_i = \det(x^{(a)} \cdot x^{(b)})_{a,b \le i} \f$: the squared volumes that they span.
/// \f$ O(n k^3 + k^4) \f$ in dimension `n`
/// \throws Error `negative_count` unless `k >= 0`, `jet_order_too_low` with fewer than `k`
///   derivatives
/// \throws Error `not_finite` when a floating-point result overflows
template <class FT, int N> std::vector<FT> gram_determinants(const Coordinate_jet<FT, N>& jet, int k) {
  internal::check_count(k, "gram_determinants: number of derivatives");
  internal::require_order(jet, k, "gram_determinants");
  std::vector<FT> g(1, FT(1));
  std::vector<Coordinate_vector<FT, N>> d;
  int exponent = 0;
  for (int i = 1; i <= k; ++i) {
    const internal::Scaled_vector<FT, N> x(jet[i], "gram_determinants");
    d.push_back(*x);
    exponent += 2 * x.exponent();
    g.push_back(internal::times_power_of_two(gram_determinant(d), exponent, "gram_determinants"));
  }
  return g;
}

/// \ingroup PkgGeometricContinuityLocal
/// Returns the coordinates of the curvature vector \f$ K = \kappa e_2 = d_2^\perp / |d_1|^2 \f$ in
/// any dimension; it points to the centre of curvature. Empty where the tangent is zero. Barsky and
/// Beatty; Hagen, remark 5 after 2.1.
/// \throws Error `jet_order_too_low` with fewer than 2 derivatives, `not_finite` when a
///   floating-point result overflows
template <class FT, int N> std::optional<Coordinate_vector<FT, N>> curvature_vector(const Coordinate_jet<FT, N>& jet) {
  internal::require_order(jet, 2, "curvature_vector");
  const internal::Scaled_vector<FT, N> d1(jet[1], "curvature_vector"), d2(jet[2], "curvature_vector");
  const FT g = dot(*d1, *d1);
  if (g == FT(0)) return std::nullopt;
  return internal::times_power_of_two(orthogonal_component(*d2, *d1) / g, d2.exponent() - 2 * d1.exponent(),
                                      "curvature_vector");
}

/// \ingroup PkgGeometricContinuityLocal
/// Returns the curvature vector \f$ K = \kappa e_2 = d_2^\perp / |d_1|^2 \f$ as a vector of the
/// kernel, in any dimension; it points to the centre of curvature. Empty where the tangent is zero.
/// Barsky and Beatty; Hagen, remark 5 after 2.1.
/// \throws Error `jet_order_too_low` with fewer than 2 derivatives, `not_finite` when a
///   floating-point result overflows
template <class Traits> std::optional<typename Traits::Vector> curvature_vector(const Curve_jet<Traits>& jet) {
  const Coordinate_jet<typename Traits::FT, dimension_v<Traits>>& coordinates = jet;
  const std::optional<Geometric_continuity::Coordinates<Traits>> k = curvature_vector(coordinates);
  if (!k) return std::nullopt;
  return Geometric_continuity::to_vector<Traits>(*k);
}

/// \ingroup PkgGeometricContinuityLocal
/// Returns the squared curvature \f$ \kappa^2 = G_2 / G_1^3 = |d_2^\perp|^2 / |d_1|^4 \f$ in any
/// dimension. Empty where the tangent is zero. Hagen (1.11).
/// \throws Error `jet_order_too_low` with fewer than 2 derivatives, `not_finite` when a
///   floating-point result overflows
template <class FT, int N> std::optional<FT> curvature_squared(const Coordinate_jet<FT, N>& jet) {
  internal::require_order(jet, 2, "curvature_squared");
  const internal::Scaled_vector<FT, N> d1(jet[1], "curvature_squared"), d2(jet[2], "curvature_squared");
  const FT g = dot(*d1, *d1);
  if (g == FT(0)) return std::nullopt;
  const Coordinate_vector<FT, N> k = orthogonal_component(*d2, *d1) / g;
  return internal::times_power_of_two(FT(dot(k, k)), 2 * d2.exponent() - 4 * d1.exponent(), "curvature_squared");
}

/// \ingroup PkgGeometricContinuityLocal
/// Returns the signed curvature \f$ \det(d_1, d_2) / |d_1|^3 \f$ of a planar curve, positive in a
/// left turn. Empty where the tangent is zero. Hagen (1.9).
/// \throws Error `jet_order_too_low` with fewer than 2 derivatives, `dimension_mismatch` unless in
///   dimension 2, `not_finite` when a floating-point result overflows
template <class FT, int N> std::optional<Signed_square<FT>> signed_curvature(const Coordinate_jet<FT, N>& jet) {
  internal::require_order(jet, 2, "signed_curvature");
  internal::require_dimension<2>(jet, "signed_curvature");
  const internal::Scaled_vector<FT, N> d1(jet[1], "signed_curvature"), d2(jet[2], "signed_curvature");
  const FT g = dot(*d1, *d1);
  if (g == FT(0)) return std::nullopt;
  const FT det = (*d1)[0] * (*d2)[1] - (*d1)[1] * (*d2)[0];
  return Signed_square<FT>{internal::sign_of(det),
                           internal::times_power_of_two(FT(det * det / (g * g * g)),
                                                        2 * d2.exponent() - 4 * d1.exponent(), "signed_curvature")};
}

/// \ingroup PkgGeometricContinuityLocal
/// Returns the curvature \f$ \kappa \ge 0 \f$ of a curve at `u`, rounded to `double`;
/// `curvature_squared(curve.jet(u, 2))` is its square in the field of the curve.
/// \tparam Curve a model of `ParametricCurve`
/// \throws Error `zero_tangent` where the tangent is zero, and as `Curve::jet()` and
///   `curvature_squared()` do
template <class Curve> double curvature(const Curve& curve, const typename Curve::FT& u) {
  const std::optional<typename Curve::FT> square = curvature_squared(curve.jet(u, 2));
  if (!square) throw Error(Error_code::zero_tangent, "curvature: the curve has no curvature where its tangent is zero");
  return std::sqrt(CGAL::to_double(*square));
}

/// \ingroup PkgGeometricContinuityLocal
/// Returns the torsion \f$ \tau = \det(d_1, d_2, d_3) / |d_1 \times d_2|^2 \f$ of a space curve.
/// Empty where the curvature is zero or undefined. Hagen (1.12).
/// \throws Error `jet_order_too_low` with fewer than 3 derivatives, `dimension_mismatch` unless in
///   dimension 3, `not_finite` when a floating-point result overflows
template <class FT, int N> std::optional<FT> torsion(const Coordinate_jet<FT, N>& jet) {
  internal::require_order(jet, 3, "torsion");
  internal::require_dimension<3>(jet, "torsion");
  const internal::Scaled_vector<FT, N> d1(jet[1], "torsion"), d2(jet[2], "torsion"), d3(jet[3], "torsion");
  const Coordinate_vector<FT, N> normal = cross_product(*d1, *d2);
  const FT g2 = dot(normal, normal);
  if (g2 == FT(0)) return std::nullopt;
  return internal::times_power_of_two(FT(dot(normal, *d3) / g2), d3.exponent() - d1.exponent() - d2.exponent(),
                                      "torsion");
}

/// \ingroup PkgGeometricContinuityLocal
/// Returns the torsion of a space curve at `u`.
/// \tparam Curve a model of `ParametricCurve`
/// \throws Error `nonpositive_curvature` where the curvature is zero or undefined, and as
///   `Curve::jet()` and `torsion()` of a jet do
template <class Curve> typename Curve::FT torsion(const Curve& curve, const typename Curve::FT& u) {
  const std::optional<typename Curve::FT> t = torsion(curve.jet(u, 3));
  if (!t)
    throw Error(Error_code::nonpositive_curvature, "torsion: the curve has no torsion where its curvature is zero");
  return *t;
}

/// \ingroup PkgGeometricContinuityLocal
/// Returns the `n - 1` curvatures \f$ \kappa_1, \dots, \kappa_{n-1} \f$ of a curve in \f$ E^n \f$,
/// \f$ \kappa_i^2 = G_{i-1} G_{i+1} / (G_i^2 G_1) \f$, by Gram-Schmidt orthogonalisation; all are
/// nonnegative but the last, which has the sign of \f$ \det(d_1, \dots, d_n) \f$. Entries from the
/// first `i` with \f$ G_i = 0 \f$ on are empty. \f$ O(n^3) \f$. Hagen (1.5).
/// \throws Error `jet_order_too_low` with fewer than `n` derivatives, `not_finite` when a
///   floating-point result overflows
template <class FT, int N>
std::vector<std::optional<Signed_square<FT>>> frenet_curvatures(const Coordinate_jet<FT, N>& jet) {
  const int n = jet.dimension();
  internal::require_order(jet, n, "frenet_curvatures");
  std::vector<std::optional<Signed_square<FT>>> kappa(n > 0 ? n - 1 : 0);
  std::vector<Coordinate_vector<FT, N>> d, q; // Gram-Schmidt: |q_i|^2 = G_i / G_{i-1}
  std::vector<int> exponents;
  for (int i = 1; i <= n; ++i) {
    const internal::Scaled_vector<FT, N> x(jet[i], "frenet_curvatures");
    exponents.push_back(x.exponent());
    d.push_back(*x);
    q.push_back(orthogonal_component(*x, q));
    const FT length = dot(q[i - 1], q[i - 1]);
    if (i > 1) { // kappa_{i-1}^2 = |q_i|^2 / (|q_{i-1}|^2 |q_1|^2)
      const FT square = length / (dot(q[i - 2], q[i - 2]) * dot(q[0], q[0]));
      const int sign =
          i < n
              ? internal::sign_of(square)
              : internal::sign_of(determinant<FT>(n, [&](int row, int column) -> const FT& { return d[row][column]; }));
      const int exponent = 2 * (exponents[i - 1] - exponents[i - 2] - exponents[0]);
      kappa[i - 2] = Signed_square<FT>{sign, internal::times_power_of_two(FT(square), exponent, "frenet_curvatures")};
    }
    if (length == FT(0)) break;
  }
  return kappa;
}

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_OFF

/// \ingroup PkgGeometricContinuityLocal
/// Computes the curvatures \f$ \kappa = |d_1 \times d_2| / |d_1|^3 \f$ and torsions
/// \f$ \tau = \det(d_1, d_2, d_3) / |d_1 \times d_2|^2 \f$ of many jets in space, in one pass.
///
/// Where a number is not defined it is set to 0: the curvature where \f$ d_1 = 0 \f$, the torsion
/// where also \f$ d_1 \times d_2 = 0 \f$. Compile with `-fno-math-errno`, or the square root is not
/// vectorised.
///
/// In contrast to `curvature_squared()` and `torsion()`, derivatives are not scaled. In `double`,
/// the largest coordinate of each of the three derivatives must be 0 or between \f$ 2^{-200} \f$
/// and \f$ 2^{200} \f$; beyond, products of up to four of them overflow or vanish, and the results
/// are unspecified (too small, infinite, or not a number). It is the caller's duty to scale such
/// jets, or to ask for them one by one.
///
/// \param jets `n` jets of order at least 3
/// \param curvature,torsion arrays for `n` numbers
/// \return the number of jets whose torsion, or also curvature, is not defined
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
template <class Concurrency_tag = Sequential_tag, class FT, int k>
std::size_t curvature_and_torsion(const Jet_arrays<FT, 3, k>& jets, FT* curvature, FT* torsion) {
  static_assert(k >= 3, "torsion reads 3 derivatives");
  std::atomic<std::size_t> undefined(0);
  internal::for_each_block<Concurrency_tag>(jets.size(), [&](std::size_t begin, std::size_t end) {
    const FT *x1 = jets.array(1, 0), *y1 = jets.array(1, 1), *z1 = jets.array(1, 2);
    const FT *x2 = jets.array(2, 0), *y2 = jets.array(2, 1), *z2 = jets.array(2, 2);
    const FT *x3 = jets.array(3, 0), *y3 = jets.array(3, 1), *z3 = jets.array(3, 2);
    FT *kappa = curvature, *tau = torsion;
    // at a time: the square root stands alone, because -frounding-math keeps it from vectorisation
    constexpr std::size_t most = 256;
    FT squares[most];
    std::size_t zeros = 0;
    // equivalent [< -> <=, 1]: a block without a jet
    for (std::size_t first = begin; first < end; first += most) {
      const std::size_t last = (std::min)(first + most, end);
      CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
      for (std::size_t i = first; i < last; ++i) {
        const FT g = x1[i] * x1[i] + y1[i] * y1[i] + z1[i] * z1[i]; // |d1|^2
        const FT nx = y1[i] * z2[i] - z1[i] * y2[i], ny = z1[i] * x2[i] - x1[i] * z2[i],
                 nz = x1[i] * y2[i] - y1[i] * x2[i];
        const FT nn = nx * nx + ny * ny + nz * nz; // |d1 x d2|^2
        // the numerators are 0 as well
        const FT g_or_1 = g > FT(0) ? g : FT(1), nn_or_1 = nn > FT(0) ? nn : FT(1);
        squares[i - first] = g_or_1;
        kappa[i] = nn / g_or_1;
        tau[i] = (nx * x3[i] + ny * y3[i] + nz * z3[i]) / nn_or_1;
      }
      for (std::size_t i = first; i < last; ++i) kappa[i] = std::sqrt(kappa[i]);
      CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
      for (std::size_t i = first; i < last; ++i) kappa[i] /= squares[i - first];
      zeros += static_cast<std::size_t>(std::count(kappa + first, kappa + last, FT(0)));
    }
    undefined += zeros;
  });
  return undefined;
}

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_ON

namespace internal {

// The vector v with det(rows, v) = v.v that is orthogonal to the n-1 rows: the cofactors of the
// last row. O(n^4)
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

// The Frenet frame of a curve with these first n-1 derivatives, empty where they are linearly
// dependent.
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
/// The Frenet frame of a curve in \f$ E^n \f$ as `n` orthogonal vectors \f$ e_1, \dots, e_n \f$
/// with positive orientation: \f$ e_i \f$ is the component of \f$ x^{(i)} \f$ orthogonal to the
/// earlier ones for `i < n`, and \f$ e_n \f$ completes them, so that no root is needed. Hagen 1.2,
/// 1.3.
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> class Frenet_frame {
public:
  typedef Traits_ Traits;                                        ///< the traits class
  typedef typename Traits::FT FT;                                ///< the field
  typedef typename Traits::Vector Vector;                        ///< the vectors of the kernel
  typedef Geometric_continuity::Coordinates<Traits> Coordinates; ///< their coordinates

  /// Takes the coordinates of `n` vectors of dimension `n`. They must be orthogonal; this is not
  /// checked.
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

  /// Returns the vector \f$ e_i \f$: \f$ e_1 \f$ is the tangent, \f$ e_2 \f$ the principal normal,
  /// in space \f$ e_3 \f$ the binormal. \pre `1 <= i <= dimension()`
  Vector vector(int i) const { return Geometric_continuity::to_vector<Traits>(e_[i - 1]); }

  /// Returns the coordinates of \f$ e_i \f$. \pre `1 <= i <= dimension()`
  const Coordinates& coordinates(int i) const { return e_[i - 1]; }

  /// Returns the frame with unit vectors; only for number types that have a square root.
  /// \throws Error `zero_direction` when a vector is zero, `not_finite` when one is infinite or
  ///   undefined
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

  /// Writes the vectors, one in a line.
  friend std::ostream& operator<<(std::ostream& os, const Frenet_frame& frame) {
    for (const Coordinates& v : frame.e_)
      for (int i = 0; i < v.dimension(); ++i) os << v[i] << (i + 1 < v.dimension() ? ' ' : '\n');
    return os;
  }

private:
  std::vector<Coordinates> e_;
};

/// \ingroup PkgGeometricContinuityLocal
/// Returns the Frenet frame at a jet; empty where the first `n - 1` derivatives are linearly
/// dependent. With floating-point numbers a power of two keeps \f$ e_n \f$, whose length is the
/// volume that these derivatives span, within the range of the number type. \f$ O(n^4) \f$
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
/// The matrix `w` of the Frenet equations \f$ e_i' = \sum_j w_{ij} e_j \f$ for the \em orthonormal
/// Frenet frame. It is skew and tridiagonal, with \f$ w_{i,i+1} = |X'| \kappa_i = -w_{i+1,i} \f$.
/// Hagen (1.6), in the plane (1.8), in space (1.10).
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

  /// Returns the derivatives \f$ e_1', \dots, e_n' \f$ of the orthonormal vectors
  /// \f$ e_1, \dots, e_n \f$. \f$ O(n^2) \f$
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
/// Returns the matrix of the Frenet equations at a jet; empty where the first `n - 1` derivatives
/// are linearly dependent. Only for number types that have a square root; `frenet_curvatures()`
/// gives the squares of the curvatures in any field.
/// \throws Error `jet_order_too_low` with fewer than `n` derivatives, `not_finite` when the square
///   of a curvature overflows
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
/// Returns the derivatives \f$ e_1', \dots, e_n' \f$, with respect to the parameter, of the
/// orthonormal Frenet frame at a jet; empty where the first `n - 1` derivatives are linearly
/// dependent. Only for number types that have a square root. Hagen (1.6).
/// \throws Error `jet_order_too_low` with fewer than `n` derivatives, `not_finite` when the square
///   of a curvature overflows
template <class Traits>
std::optional<std::vector<typename Traits::Vector>> frenet_frame_derivatives(const Curve_jet<Traits>& jet) {
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;
  const std::optional<Frenet_matrix<typename Traits::FT>> w = frenet_matrix(jet);
  const std::optional<Frenet_frame<Traits>> frame = frenet_frame(jet);
  // unreachable: by rounding only: both are empty for dependent derivatives
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

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVATURES_H
