// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVATURES_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVATURES_H

#include <CGAL/Geometric_continuity/algebra/determinant.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/sign_of.h>

#include <optional>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityLocal
/// A real number given without a root, by its sign and its square.
template <class FT> struct Signed_square {
  int sign;  ///< -1, 0 or 1
  FT square; ///< the square of the number

  friend bool operator==(const Signed_square& x, const Signed_square& y) {
    return x.sign == y.sign && x.square == y.square;
  }
  friend bool operator!=(const Signed_square& x, const Signed_square& y) { return !(x == y); }
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

// det(x', ..., x^(n)) in dimension n
template <class FT, int N> FT derivative_determinant(const Coordinate_jet<FT, N>& jet) {
  return determinant<FT>(jet.dimension(), [&](int row, int column) -> const FT& { return jet[row + 1][column]; });
}

// the Gram determinant G_count of (1.5)
template <class FT, int N> FT gram_of_derivatives(const Coordinate_jet<FT, N>& jet, int count) {
  std::vector<Coordinate_vector<FT, N>> d;
  for (int j = 1; j <= count; ++j) d.push_back(jet[j]);
  return gram_determinant(d);
}

template <class FT, int N> std::optional<Coordinate_vector<FT, N>> curvature_vector(const Coordinate_jet<FT, N>& jet) {
  require_order(jet, 2, "curvature_vector");
  const FT g = dot(jet[1], jet[1]);
  if (g == FT(0)) return std::nullopt;
  return orthogonal_component(jet[2], jet[1]) / g;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityLocal
/// The Gram determinants \f$ G_0 = 1, G_1, \dots, G_k \f$ of the first `k` derivatives,
/// \f$ G_i = \det(x^{(a)} \cdot x^{(b)})_{a,b \le i} \f$.
template <class FT, int N> std::vector<FT> gram_determinants(const Coordinate_jet<FT, N>& jet, int k) {
  internal::require_order(jet, k, "gram_determinants");
  std::vector<FT> g;
  for (int i = 0; i <= k; ++i) g.push_back(internal::gram_of_derivatives(jet, i));
  return g;
}

/// \ingroup PkgGeometricContinuityLocal
/// The curvature vector \f$ K = \kappa e_2 = d_2^\perp / |d_1|^2 \f$ in any dimension; it points to the centre of
/// curvature. Empty where the tangent is zero. Barsky and Beatty; Hagen, remark 5 after 2.1.
/// \throws Error `jet_order_too_low` with fewer than 2 derivatives
template <class Traits> std::optional<typename Traits::Vector> curvature_vector(const Curve_jet<Traits>& jet) {
  const std::optional<Geometric_continuity::Coordinates<Traits>> k = internal::curvature_vector(jet);
  if (!k) return std::nullopt;
  return Geometric_continuity::to_vector<Traits>(*k);
}

/// \ingroup PkgGeometricContinuityLocal
/// The squared curvature \f$ \kappa^2 = G_2 / G_1^3 \f$ in any dimension. Empty where the tangent is zero.
/// Hagen (1.11). \throws Error `jet_order_too_low` with fewer than 2 derivatives
template <class FT, int N> std::optional<FT> curvature_squared(const Coordinate_jet<FT, N>& jet) {
  const std::optional<Coordinate_vector<FT, N>> k = internal::curvature_vector(jet);
  if (!k) return std::nullopt;
  return dot(*k, *k);
}

/// \ingroup PkgGeometricContinuityLocal
/// The signed curvature \f$ \det(d_1, d_2) / |d_1|^3 \f$ of a planar curve, positive in a left turn. Empty where the
/// tangent is zero. Hagen (1.9).
/// \throws Error `jet_order_too_low` with fewer than 2 derivatives, `dimension_mismatch` unless in dimension 2
template <class FT, int N> std::optional<Signed_square<FT>> signed_curvature(const Coordinate_jet<FT, N>& jet) {
  internal::require_order(jet, 2, "signed_curvature");
  internal::require_dimension<2>(jet, "signed_curvature");
  const FT g1 = dot(jet[1], jet[1]);
  if (g1 == FT(0)) return std::nullopt;
  const FT det = internal::derivative_determinant(jet);
  return Signed_square<FT>{internal::sign_of(det), FT(det * det / (g1 * g1 * g1))};
}

/// \ingroup PkgGeometricContinuityLocal
/// The torsion \f$ \tau = \det(d_1, d_2, d_3) / |d_1 \times d_2|^2 \f$ of a space curve. Empty where the curvature is
/// zero or undefined. Hagen (1.12).
/// \throws Error `jet_order_too_low` with fewer than 3 derivatives, `dimension_mismatch` unless in dimension 3
template <class FT, int N> std::optional<FT> torsion(const Coordinate_jet<FT, N>& jet) {
  internal::require_order(jet, 3, "torsion");
  internal::require_dimension<3>(jet, "torsion");
  const FT g2 = internal::gram_of_derivatives(jet, 2);
  if (g2 == FT(0)) return std::nullopt;
  return FT(internal::derivative_determinant(jet) / g2);
}

/// \ingroup PkgGeometricContinuityLocal
/// The curvatures \f$ \kappa_1, \dots, \kappa_{n-1} \f$ of a curve in \f$ E^n \f$,
/// \f$ \kappa_i^2 = G_{i-1} G_{i+1} / (G_i^2 G_1) \f$, by Gram-Schmidt orthogonalisation; all are nonnegative but the last, which has the sign of
/// \f$ \det(d_1, \dots, d_n) \f$. Entries from the first `i` with \f$ G_i = 0 \f$ on are empty. Hagen (1.5).
/// \throws Error `jet_order_too_low` with fewer than `n` derivatives
template <class FT, int N>
std::vector<std::optional<Signed_square<FT>>> frenet_curvatures(const Coordinate_jet<FT, N>& jet) {
  const int n = jet.dimension();
  internal::require_order(jet, n, "frenet_curvatures");
  std::vector<std::optional<Signed_square<FT>>> kappa(n > 0 ? n - 1 : 0);
  std::vector<Coordinate_vector<FT, N>> q; // Gram-Schmidt: |q_i|^2 = G_i / G_{i-1}
  for (int i = 1; i <= n; ++i) {
    q.push_back(orthogonal_component(jet[i], q));
    const FT length = dot(q[i - 1], q[i - 1]);
    if (i > 1) { // kappa_{i-1}^2 = |q_i|^2 / (|q_{i-1}|^2 |q_1|^2)
      const FT square = length / (dot(q[i - 2], q[i - 2]) * dot(q[0], q[0]));
      const int sign = i < n ? internal::sign_of(square) : internal::sign_of(internal::derivative_determinant(jet));
      kappa[i - 2] = Signed_square<FT>{sign, square};
    }
    if (length == FT(0)) break;
  }
  return kappa;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVATURES_H
