// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_ISOMETRY_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_ISOMETRY_H

#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityLocal
/// A map \f$ x \mapsto B x + t \f$ of points of \f$ E^n \f$ with an orthogonal matrix `B` of determinant 1. Vectors are
/// mapped by `B`, jets as a whole. Floating-point images are rounded, and not checked for overflow.
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> class Isometry {
public:
  typedef Traits_ Traits;                                        ///< the traits class
  typedef typename Traits::FT FT;                                ///< the field
  typedef typename Traits::Point Point;                          ///< the points of the kernel
  typedef typename Traits::Vector Vector;                        ///< the vectors of the kernel
  typedef Geometric_continuity::Coordinates<Traits> Coordinates; ///< their coordinates

  /// Takes the `n` rows of `B`, whose orthogonality is not checked, and `t`.
  /// \throws Error `dimension_mismatch` unless all rows and `t` have the dimension `n`
  /// \throws Error `not_finite` for an infinite or undefined floating-point number
  Isometry(std::vector<Coordinates> rows, const Coordinates& t) : rows_(std::move(rows)), t_(t) {
    check(t_);
    for (const Coordinates& row : rows_) check(row);
  }

  /// Returns the dimension `n`.
  int dimension() const { return static_cast<int>(rows_.size()); }

  /// Returns the entry of `B` in row `i` and column `j`. \pre `0 <= i < dimension()`, `0 <= j < dimension()`
  const FT& entry(int i, int j) const { return rows_[i][j]; }

  /// Returns the vector `t`.
  Vector translation() const { return Geometric_continuity::to_vector<Traits>(t_); }

  /// Returns the image \f$ B p + t \f$ of a point. \f$ O(n^2) \f$ \throws Error `dimension_mismatch`
  Point operator()(const Point& p) const {
    return Geometric_continuity::to_point<Traits>(linear(Geometric_continuity::coordinates<Traits>(p)) + t_);
  }
  /// Returns the image \f$ B v \f$ of a vector. \f$ O(n^2) \f$ \throws Error `dimension_mismatch`
  Vector operator()(const Vector& v) const {
    return Geometric_continuity::to_vector<Traits>(linear(Geometric_continuity::coordinates<Traits>(v)));
  }
  /// Returns the jet of the moved curve. \f$ O(n^2 k) \f$ for order `k` \throws Error `dimension_mismatch`
  Curve_jet<Traits> operator()(const Curve_jet<Traits>& x) const {
    Curve_jet<Traits> y = x;
    for (int j = 0; j <= x.order(); ++j) y[j] = linear(x[j]);
    if (x.order() >= 0) y[0] += t_;
    return y;
  }

  /// Writes the rows of `(B | t)`, one to a line.
  friend std::ostream& operator<<(std::ostream& os, const Isometry& map) {
    for (int i = 0; i < map.dimension(); ++i) {
      for (const FT& x : map.rows_[i]) os << x << ' ';
      os << map.t_[i] << '\n';
    }
    return os;
  }

private:
  std::vector<Coordinates> rows_;
  Coordinates t_;

  void check_dimension(const Coordinates& v) const {
    if (v.dimension() != dimension())
      throw Error(Error_code::dimension_mismatch, "Isometry of dimension " + std::to_string(dimension()));
  }
  void check(const Coordinates& v) const {
    check_dimension(v);
    for (const FT& x : v) internal::check_finite(x, "Isometry");
  }

  Coordinates linear(const Coordinates& v) const {
    check_dimension(v);
    Coordinates r(dimension());
    for (int i = 0; i < dimension(); ++i) r[i] = dot(rows_[i], v);
    return r;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_ISOMETRY_H
