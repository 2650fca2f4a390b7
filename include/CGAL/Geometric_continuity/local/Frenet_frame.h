// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_FRENET_FRAME_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_FRENET_FRAME_H

#include <CGAL/Geometric_continuity/local/curvatures.h>
#include <CGAL/number_utils.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityLocal
/// The Frenet frame of a curve in \f$ E^n \f$ as `n` orthogonal vectors \f$ e_1, \dots, e_n \f$ with positive
/// orientation: \f$ e_i \f$ is the component of \f$ x^{(i)} \f$ orthogonal to the earlier ones for `i < n`, and
/// \f$ e_n \f$ completes them, so that no root is needed. Hagen 1.2, 1.3.
template <class Traits_> class Frenet_frame {
public:
  typedef Traits_ Traits;
  typedef typename Traits::FT FT;
  typedef typename Traits::Vector Vector;
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;

  explicit Frenet_frame(std::vector<Coordinates> e) : e_(std::move(e)) {}

  int dimension() const { return static_cast<int>(e_.size()); }

  /// The vector \f$ e_i \f$, `1 <= i <= dimension()`: \f$ e_1 \f$ the tangent, \f$ e_2 \f$ the principal normal, in space
  /// \f$ e_3 \f$ the binormal.
  Vector vector(int i) const { return Geometric_continuity::to_vector<Traits>(e_[i - 1]); }

  /// The coordinates of \f$ e_i \f$.
  const Coordinates& coordinates(int i) const { return e_[i - 1]; }

  /// The frame with unit vectors; only for number types that have a square root.
  Frenet_frame normalized() const {
    std::vector<Coordinates> unit = e_;
    for (Coordinates& v : unit) v /= FT(CGAL::sqrt(dot(v, v)));
    return Frenet_frame(std::move(unit));
  }

private:
  std::vector<Coordinates> e_;
};

/// \ingroup PkgGeometricContinuityLocal
/// The Frenet frame at a jet; empty where the first `n - 1` derivatives are linearly dependent.
/// \throws Error `jet_order_too_low` with fewer than `n - 1` derivatives
template <class Traits> std::optional<Frenet_frame<Traits>> frenet_frame(const Curve_jet<Traits>& jet) {
  typedef typename Traits::FT FT;
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;
  const int n = jet.dimension();
  internal::require_order(jet, n - 1, "frenet_frame");
  std::vector<Coordinates> e;
  for (int i = 1; i < n; ++i) {
    e.push_back(orthogonal_component(jet[i], e));
    if (is_zero(e.back())) return std::nullopt;
  }
  // e_n: the cofactors of the last row, so that det(e_1, ..., e_n) = |e_n|^2 > 0
  Coordinates last(n);
  for (int i = 0; i < n; ++i) {
    Coordinates unit(n);
    unit[i] = FT(1);
    last[i] = determinant<FT>(
        n, [&](int row, int column) -> const FT& { return row < n - 1 ? e[row][column] : unit[column]; });
  }
  e.push_back(last);
  return Frenet_frame<Traits>(std::move(e));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_FRENET_FRAME_H
