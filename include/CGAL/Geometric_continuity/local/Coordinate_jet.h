// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_COORDINATE_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_COORDINATE_JET_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {
// Asks for numbers that are not initialised, for those who set them all.
struct Unspecified {};
} // namespace internal

/// \ingroup PkgGeometricContinuityLocal
/// A jet of order `k` in coordinates: the point and the first `k` derivatives of a curve at one parameter.
/// All functions that read a jet are written on this type; `Curve_jet` adds the types of a kernel.
///
/// The coordinates can be written, and are not checked: a function that needs finite numbers looks at them itself.
///
/// \tparam FT a field number type
/// \tparam N the dimension, or 0 when it is known at run time only
template <class FT_, int N> class Coordinate_jet {
public:
  typedef FT_ FT;                               ///< the field
  typedef Coordinate_vector<FT, N> Vector_type; ///< the point and the derivatives

  /// The empty jet, of order -1.
  Coordinate_jet() = default;

  /// The zero jet of order `k` in dimension `d`. No memory is allocated up to order 5.
  /// \throws Error `negative_count` unless `k >= 0` and `d >= 0`, `dimension_mismatch` unless `d == N` or `N == 0`
  Coordinate_jet(int d, int k) : order_(k) {
    check(d, k);
    for (int j = 0; j <= k && j < inlined; ++j) inlined_[j] = Vector_type(d);
    if (k >= inlined) more_.assign(k + 1 - inlined, Vector_type(d));
  }

  // The jet with numbers that are not initialised when N > 0.
  Coordinate_jet(int d, int k, internal::Unspecified) : order_(k) {
    check(d, k);
    if constexpr (N == 0)
      for (int j = 0; j <= k && j < inlined; ++j) inlined_[j] = Vector_type(d);
    if (k >= inlined) more_.assign(k + 1 - inlined, Vector_type(d));
  }

  /// Returns the number of derivatives; -1 for an empty jet.
  int order() const { return order_; }
  /// Returns the dimension; 0 for an empty jet.
  int dimension() const { return order_ < 0 ? 0 : inlined_[0].dimension(); }

  /// Returns the `j`-th derivative; the point for `j == 0`. \pre `0 <= j <= order()`
  const Vector_type& operator[](int j) const { return j < inlined ? inlined_[j] : more_[j - inlined]; }
  /// Gives access to the `j`-th derivative; to the point for `j == 0`. \pre `0 <= j <= order()`
  Vector_type& operator[](int j) { return j < inlined ? inlined_[j] : more_[j - inlined]; }

  /// Returns whether the orders and all coordinates are equal.
  friend bool operator==(const Coordinate_jet& x, const Coordinate_jet& y) {
    if (x.order() != y.order()) return false;
    for (int j = 0; j <= x.order(); ++j)
      if (x[j] != y[j]) return false;
    return true;
  }
  /// Returns whether the orders or some coordinates differ.
  friend bool operator!=(const Coordinate_jet& x, const Coordinate_jet& y) { return !(x == y); }

private:
  static constexpr int inlined = 6;
  int order_ = -1;
  std::array<Vector_type, inlined> inlined_;
  std::vector<Vector_type> more_;

  CGAL_GC_FORCEINLINE static void check(int d, int k) {
    internal::check_count(k, "jet: order");
    internal::check_count(d, "jet: dimension");
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_COORDINATE_JET_H
