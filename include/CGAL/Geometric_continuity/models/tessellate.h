// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_TESSELLATE_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_TESSELLATE_H

#include <CGAL/Geometric_continuity/models/internal/Model_mesh.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// The largest number of cells, each of two triangles or more, that `tessellate()` makes, so that a wrong tolerance cannot
/// fill the memory.
constexpr int max_tessellation_cells = 1 << 24;

/// \ingroup PkgGeometricContinuitySurfaces
/// The largest number of cells into which `tessellate()` cuts a Bézier patch in one direction.
constexpr int max_cells_in_one_direction = 1 << 12;

/// \ingroup PkgGeometricContinuitySurfaces
/// Each Bézier patch is cut into `n` times `n` cells, equal in its parameters.
struct Uniform_grid {
  int n; ///< from 1 to `max_cells_in_one_direction`
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Each Bézier patch is cut into as few equal cells as suffice that it is nowhere farther from its triangles than the
/// tolerance, by the proof in `Patch_flatness`. The numbers of cells in `u` and in `v` are powers of two.
struct Chord_tolerance {
  double distance; ///< positive, in the unit of the coordinates
};

namespace internal {

template <class Traits> Patch_cells cells_of_patch(const Uniform_grid& grid, const Bezier_patch<Traits>&, int) {
  return {grid.n, grid.n};
}

template <class Traits>
Patch_cells cells_of_patch(const Chord_tolerance& tolerance, const Bezier_patch<Traits>& patch, int least) {
  constexpr int most = max_cells_in_one_direction;
  const Patch_flatness flatness(patch);
  const std::optional<Patch_cells> cells = flatness.cells(tolerance.distance, least, most);
  if (!cells && std::isfinite(flatness.distance({most, most})))
    throw Error(Error_code::work_limit,
                "tessellate: more than " + std::to_string(most) + " cells of a patch in one direction");
  if (!cells) throw Error(Error_code::unreachable_tolerance, "tessellate: the second derivatives of a patch overflow");
  return *cells;
}

inline void check_mode(const Uniform_grid& grid) {
  check_count(grid.n, "tessellate: a grid");
  if (grid.n == 0) throw Error(Error_code::wrong_number_of_points, "tessellate: a grid of no cells");
  if (grid.n > max_cells_in_one_direction)
    throw Error(Error_code::work_limit, "tessellate: a grid of " + std::to_string(grid.n) + " cells where at most " +
                                            std::to_string(max_cells_in_one_direction) + " are made");
}

inline void check_mode(const Chord_tolerance& tolerance) {
  check_finite(tolerance.distance, "tessellate: the tolerance");
  if (!(tolerance.distance > 0))
    throw Error(Error_code::unreachable_tolerance, "tessellate: the tolerance must be positive");
}

// All numbers of cells are known, and few enough, before the first point is computed.
template <class Traits, class Mode>
Tessellation<Traits> tessellate_patches(const std::vector<const Bezier_patch<Traits>*>& patches,
                                        const std::vector<std::size_t>& numbers, const Mode& mode) {
  check_mode(mode);
  for (const Bezier_patch<Traits>* patch : patches) require_space(*patch, "tessellate");
  int cells_left = max_tessellation_cells;
  return Model_mesh<Traits>(patches, numbers)([&](const Bezier_patch<Traits>& patch, int least) {
    const Patch_cells cells = cells_of_patch(mode, patch, least);
    cells_left -= cells.u * cells.v;
    if (cells_left < 0)
      throw Error(Error_code::work_limit, "tessellate: more than " + std::to_string(max_tessellation_cells) + " cells");
    return cells;
  });
}

// The Bezier patches of one or more surfaces, each with the number of its surface.
template <class Traits> struct Numbered_patches {
  std::vector<Bezier_patch<Traits>> patches;
  std::vector<std::size_t> numbers;

  void add(const Bezier_patch<Traits>& patch, std::size_t number) {
    patches.push_back(patch);
    numbers.push_back(number);
  }
  void add(const Bspline_surface<Traits>& surface, std::size_t number) {
    for (const Bezier_patch<Traits>& patch : surface.bezier_patches()) add(patch, number);
  }
  template <class Mode> Tessellation<Traits> tessellate(const Mode& mode) const {
    std::vector<const Bezier_patch<Traits>*> pointers;
    for (const Bezier_patch<Traits>& patch : patches) pointers.push_back(&patch);
    return tessellate_patches(pointers, numbers, mode);
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Tessellates a model: makes triangles from the patches or surfaces of a range, welded along their common edges.
///
/// Edges are the same when `model_continuity()` says so: by exact comparison of their curves, in either direction and
/// also if their degrees differ. A point on a common edge is computed once, so that there are no cracks, with rounded
/// numbers neither. It has as many points as the patch with the most cells along it needs; the other patch takes them into
/// the triangles of its outermost cells. A collapsed edge gives one point. The numbers of the triangles are those in the
/// range, for the Bézier patches of a B-spline surface that of the surface.
///
/// The triangles are those of an oriented manifold if the patches are, with one exception: a patch of which two adjacent
/// edges are the same curve. With `Uniform_grid` this needs `n >= 3` where patches close up or have two edges in common.
/// With an exact kernel all points lie on the surface exactly.
///
/// \f$ O(n \log n) \f$ comparisons of edges of `n` patches, and \f$ O(p^2) \f$ operations for each point on a patch of
/// degree `p`.
///
/// \tparam SurfaceRange a forward range of `Bezier_patch` or of `Bspline_surface`
/// \tparam Mode `Uniform_grid` or `Chord_tolerance`
/// \throws Error `unreachable_tolerance` for a tolerance that is not positive, or when the bounds in `Patch_flatness`
///   overflow; `not_finite` for a tolerance that is infinite or not a number; `work_limit` for a grid or a tolerance that
///   would need more than `max_tessellation_cells` cells, or more than `max_cells_in_one_direction` in a direction of a
///   patch; `negative_count` and `wrong_number_of_points` for a grid with a negative number of cells and with none;
///   `dimension_mismatch` unless in dimension 3. No point is computed before
template <class SurfaceRange, class Mode>
auto tessellate(const SurfaceRange& surfaces, const Mode& mode)
    -> Tessellation<typename std::decay_t<decltype(*std::begin(surfaces))>::Traits> {
  typedef std::decay_t<decltype(*std::begin(surfaces))> Surface;
  internal::Numbered_patches<typename Surface::Traits> patches;
  std::size_t number = 0;
  for (const Surface& surface : surfaces) patches.add(surface, number++);
  return patches.tessellate(mode);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Tessellates a patch, welded where it closes up, as a model of one patch.
/// \throws Error as the function that tessellates a model
template <class Traits, class Mode>
Tessellation<Traits> tessellate(const Bezier_patch<Traits>& patch, const Mode& mode) {
  return internal::tessellate_patches<Traits>({&patch}, {0}, mode);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Tessellates a surface, Bézier patch by Bézier patch, welded also where it closes up, as a model of one surface.
/// \throws Error as the function that tessellates a model
template <class Traits, class Mode>
Tessellation<Traits> tessellate(const Bspline_surface<Traits>& surface, const Mode& mode) {
  return tessellate(std::array<Bspline_surface<Traits>, 1>{surface}, mode);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_TESSELLATE_H
