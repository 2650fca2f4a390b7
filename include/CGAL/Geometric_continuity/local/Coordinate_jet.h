// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_COORDINATE_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_COORDINATE_JET_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {
struct Unspecified {};
} // namespace internal

/// \ingroup PkgGeometricContinuityLocal
/// A jet of order `k` in coordinates: the point and the first `k` derivatives of a curve at one parameter.
/// All functions that read a jet are written on this type; `Curve_jet` adds the types of a kernel.
///
/// \tparam FT a field number type
/// \tparam N the dimension, or 0 when it is known at run time only
template <class FT_, int N> class Coordinate_jet {
public:
  typedef FT_ FT;
  typedef Coordinate_vector<FT, N> Vector_type;

  Coordinate_jet() = default;

  /// The zero jet of order `k` in dimension `d`. No memory is allocated up to order 5.
  Coordinate_jet(int d, int k) : order_(k) {
    for (int j = 0; j <= k && j < inlined; ++j) inlined_[j] = Vector_type(d);
    if (k >= inlined) more_.assign(k + 1 - inlined, Vector_type(d));
  }

  /// The same with unspecified coordinates when `N > 0`, for those who set them all.
  Coordinate_jet(int d, int k, internal::Unspecified) : order_(k) {
    if constexpr (N == 0)
      for (int j = 0; j <= k && j < inlined; ++j) inlined_[j] = Vector_type(d);
    if (k >= inlined) more_.assign(k + 1 - inlined, Vector_type(d));
  }

  /// The number of derivatives; -1 for an empty jet.
  int order() const { return order_; }
  int dimension() const { return order_ < 0 ? 0 : inlined_[0].dimension(); }

  /// The `j`-th derivative; the point for `j == 0`.
  const Vector_type& operator[](int j) const { return j < inlined ? inlined_[j] : more_[j - inlined]; }
  Vector_type& operator[](int j) { return j < inlined ? inlined_[j] : more_[j - inlined]; }

  friend bool operator==(const Coordinate_jet& x, const Coordinate_jet& y) {
    if (x.order() != y.order()) return false;
    for (int j = 0; j <= x.order(); ++j)
      if (x[j] != y[j]) return false;
    return true;
  }
  friend bool operator!=(const Coordinate_jet& x, const Coordinate_jet& y) { return !(x == y); }

private:
  static constexpr int inlined = 6;
  int order_ = -1;
  std::array<Vector_type, inlined> inlined_;
  std::vector<Vector_type> more_;
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_COORDINATE_JET_H
