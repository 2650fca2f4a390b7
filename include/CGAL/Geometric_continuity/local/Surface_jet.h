// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_SURFACE_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_SURFACE_JET_H

#include <CGAL/Geometric_continuity/local/coordinates.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityLocal
/// A jet of order `k` of a surface: its point and all partial derivatives
/// \f$ \partial^{i+j} S / \partial u^i \partial v^j \f$, `i + j <= k`, at one pair of parameters.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> class Surface_jet {
public:
  typedef Traits_ Traits;
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  typedef typename Traits::Vector Vector;
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;

  /// The zero jet of order `k` in dimension `d`. \throws Error `jet_order_too_low` unless `k >= 0`
  Surface_jet(int d, int k) : order_(k) {
    if (k < 0) throw Error(Error_code::jet_order_too_low, "Surface_jet: a jet of negative order");
    partials_.assign((k + 1) * (k + 2) / 2, Coordinates(d));
  }

  int order() const { return order_; }
  int dimension() const { return partials_[0].dimension(); }

  /// The coordinates of the derivative of order `i` in `u` and `j` in `v`; of the point for `i = j = 0`.
  /// \pre `0 <= i`, `0 <= j`, `i + j <= order()`
  const Coordinates& operator()(int i, int j) const { return partials_[index(i, j)]; }
  Coordinates& operator()(int i, int j) { return partials_[index(i, j)]; }

  /// The point.
  Point point() const { return Geometric_continuity::to_point<Traits>(partials_[0]); }

  /// The derivative of order `i` in `u` and `j` in `v`, `0 < i + j <= order()`.
  Vector partial(int i, int j) const { return Geometric_continuity::to_vector<Traits>((*this)(i, j)); }

private:
  int order_;
  std::vector<Coordinates> partials_; // by total order, then by j

  static int index(int i, int j) { return (i + j) * (i + j + 1) / 2 + j; }
};

namespace internal {

template <class Traits> Coordinates<Traits> normal_coordinates(const Surface_jet<Traits>& jet) {
  static_assert(dimension_v<Traits> == 0 || dimension_v<Traits> == 3, "a surface has a normal in dimension 3");
  if (jet.dimension() != 3) throw Error(Error_code::dimension_mismatch, "normal: a surface has one in dimension 3");
  if (jet.order() < 1) throw Error(Error_code::jet_order_too_low, "normal reads the first derivatives");
  return cross_product(jet(1, 0), jet(0, 1));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityLocal
/// The normal \f$ S_u \times S_v \f$, not normalised and hence exact with an exact kernel. It is zero where the surface is
/// not regular. Lecture slides, "Normals".
/// \throws Error `dimension_mismatch` unless in dimension 3, `jet_order_too_low` for a jet of order 0
template <class Traits> typename Traits::Vector normal(const Surface_jet<Traits>& jet) {
  return Geometric_continuity::to_vector<Traits>(internal::normal_coordinates(jet));
}

/// \ingroup PkgGeometricContinuityLocal
/// The unit normal, empty where \f$ S_u \times S_v = 0 \f$; only for number types that have a square root.
/// \throws Error `dimension_mismatch` unless in dimension 3, `jet_order_too_low` for a jet of order 0
template <class Traits> std::optional<typename Traits::Vector> unit_normal(const Surface_jet<Traits>& jet) {
  typedef typename Traits::FT FT;
  Geometric_continuity::Coordinates<Traits> n = internal::normal_coordinates(jet);
  FT largest(0); // divided by it first, so that no square overflows or vanishes
  for (const FT& x : n) largest = std::max(largest, FT(CGAL::abs(x)));
  if (largest == FT(0)) return std::nullopt;
  n /= largest;
  n /= FT(CGAL::sqrt(FT(dot(n, n))));
  return Geometric_continuity::to_vector<Traits>(n);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_SURFACE_JET_H
