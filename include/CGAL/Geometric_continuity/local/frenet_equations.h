// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_FRENET_EQUATIONS_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_FRENET_EQUATIONS_H

#include <CGAL/Geometric_continuity/local/Frenet_frame.h>
#include <CGAL/number_utils.h>

#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

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
    const FT root = CGAL::sqrt(k->square);
    kappa.push_back(k->sign < 0 ? FT(-root) : root);
  }
  const internal::Scaled_vector<FT, dimension_v<Traits>> d1(jet[1], "frenet_matrix");
  const FT speed = CGAL::sqrt(FT(dot(*d1, *d1)));
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

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_FRENET_EQUATIONS_H
