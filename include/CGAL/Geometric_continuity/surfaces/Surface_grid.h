// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_SURFACE_GRID_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_SURFACE_GRID_H

#include <CGAL/Geometric_continuity/Error.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// The points and normals of a surface at the vertices of a grid of parameters, as a structure of arrays: for each
/// coordinate one array with the numbers of all vertices, where the vertex of the `i`-th parameter `u` and the `j`-th
/// parameter `v` has the index \f$ i\,n_v + j \f$.
template <class FT> class Surface_grid {
  std::size_t size_u_ = 0, size_v_ = 0;
  std::vector<FT> numbers_;

public:
  /// Changes the numbers of parameters. The numbers of the vertices are unspecified afterwards; no memory is allocated when
  /// there is enough.
  /// \throws Error `work_limit` when the numbers of the vertices would be more than a `std::size_t` counts
  void resize(std::size_t size_u, std::size_t size_v) {
    if (size_v > 0 && size_u > (std::numeric_limits<std::size_t>::max)() / 6 / size_v)
      throw Error(Error_code::work_limit, "Surface_grid: too many vertices");
    numbers_.resize(6 * size_u * size_v);
    size_u_ = size_u;
    size_v_ = size_v;
  }
  std::size_t size_u() const { return size_u_; }         ///< Returns the number of parameters `u`.
  std::size_t size_v() const { return size_v_; }         ///< Returns the number \f$ n_v \f$ of parameters `v`.
  std::size_t size() const { return size_u_ * size_v_; } ///< Returns the number of vertices.

  /// Returns the array of the coordinates number `i` of all points. \pre `0 <= i < 3`
  FT* points(int i) { return numbers_.data() + i * size(); }
  /// Returns the array of the coordinates number `i` of all points. \pre `0 <= i < 3`
  const FT* points(int i) const { return numbers_.data() + i * size(); }
  /// Returns the array of the coordinates number `i` of all normals. \pre `0 <= i < 3`
  FT* normals(int i) { return numbers_.data() + (3 + i) * size(); }
  /// Returns the array of the coordinates number `i` of all normals. \pre `0 <= i < 3`
  const FT* normals(int i) const { return numbers_.data() + (3 + i) * size(); }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Which normals `evaluate_grid()` computes.
enum class Grid_normals {
  unnormalised, ///< \f$ S_u \times S_v \f$, without roots
  unit          ///< of length 1, or zero where \f$ S_u \times S_v = 0 \f$
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_SURFACE_GRID_H
