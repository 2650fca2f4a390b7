// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_REPAIRS_GRID_VECTOR_H
#define CGAL_GEOMETRIC_CONTINUITY_REPAIRS_GRID_VECTOR_H

#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <ostream>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityExtensions
/// A point or a vector of the plane in whole units of a grid: the units of a font, or the last
/// decimals of a drawing.
struct Grid_vector {
  std::int64_t x; ///< the first coordinate
  std::int64_t y; ///< the second coordinate

  /// Decides whether both coordinates are equal.
  friend bool operator==(const Grid_vector& u, const Grid_vector& v) { return u.x == v.x && u.y == v.y; }
  /// Decides whether a coordinate is different.
  friend bool operator!=(const Grid_vector& u, const Grid_vector& v) { return !(u == v); }
  /// Returns the sum.
  friend Grid_vector operator+(const Grid_vector& u, const Grid_vector& v) { return {u.x + v.x, u.y + v.y}; }
  /// Returns the difference.
  friend Grid_vector operator-(const Grid_vector& u, const Grid_vector& v) { return {u.x - v.x, u.y - v.y}; }
  /// Returns a multiple.
  friend Grid_vector operator*(std::int64_t m, const Grid_vector& v) { return {m * v.x, m * v.y}; }
  /// Writes `(x, y)`.
  friend std::ostream& operator<<(std::ostream& os, const Grid_vector& v) {
    return os << '(' << v.x << ", " << v.y << ')';
  }
};

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the scalar product; the coordinates are at most \f$ 2^{30} \f$, so that it is exact.
inline std::int64_t dot(const Grid_vector& u, const Grid_vector& v) { return u.x * v.x + u.y * v.y; }

/// \ingroup PkgGeometricContinuityExtensions
/// Returns \f$ u_x v_y - u_y v_x \f$; the coordinates are at most \f$ 2^{30} \f$, so that it is
/// exact.
inline std::int64_t cross(const Grid_vector& u, const Grid_vector& v) { return u.x * v.y - u.y * v.x; }

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the squared length; the coordinates are at most \f$ 2^{30} \f$, so that it is exact.
inline std::int64_t squared_length(const Grid_vector& v) { return dot(v, v); }

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the shortest whole vector of the same direction; the zero vector for itself.
inline Grid_vector primitive(const Grid_vector& v) {
  const std::int64_t divisor = std::gcd(v.x, v.y);
  return divisor == 0 ? v : Grid_vector{v.x / divisor, v.y / divisor};
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_REPAIRS_GRID_VECTOR_H
