// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_ALIGN_HANDLES_H
#define CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_ALIGN_HANDLES_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/extensions/Grid_vector.h>
#include <CGAL/Geometric_continuity/extensions/internal/Grid_alignment.h>

#include <cstdint>
#include <limits>
#include <optional>

/// \file align_handles.h
/// Makes a kink between two curves of a drawing or a letter exactly smooth by moving handles on their grid. A node and a
/// handle on each side, with legs \f$ a = N - A \f$ and \f$ b = B - N \f$: the join is G1 if and only if
/// \f$ a = m d, b = n d \f$ for a whole vector `d` and whole numbers \f$ m, n \ge 1 \f$.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityExtensions
/// The legs at a node after its handles have been moved: from the handle on the left to the node, and from there to the
/// handle on the right.
struct Aligned_handles {
  Grid_vector left;  ///< \f$ m d \f$
  Grid_vector right; ///< \f$ n d \f$
};

/// \ingroup PkgGeometricContinuityExtensions
/// The largest coordinate of a leg that `align_handles()` takes: \f$ 2^{28} \f$, so that all its products are exact.
constexpr std::int64_t max_leg = std::int64_t(1) << 28;

namespace internal {

inline void check_leg(const Grid_vector& v, const char* place) {
  if (v == Grid_vector{0, 0}) throw Error(Error_code::zero_tangent, place);
  if (v.x < -max_leg || max_leg < v.x || v.y < -max_leg || max_leg < v.y)
    throw Error(Error_code::work_limit, std::string(place) + ": a leg is longer than 2^28 units");
}

// The image under the symmetry of the square, its own inverse, that takes `b` to b_x >= |b_y|.
struct Octant {
  bool swapped, negative;
  explicit Octant(const Grid_vector& b)
      : swapped((std::abs)(b.x) < (std::abs)(b.y)), negative((swapped ? b.y : b.x) < 0) {}
  Grid_vector operator()(const Grid_vector& v) const {
    const Grid_vector u = negative ? Grid_vector{-v.x, -v.y} : v;
    return swapped ? Grid_vector{u.y, u.x} : u;
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityExtensions
/// Returns legs of one direction as near as possible to those given: among all pairs of parallel whole vectors of one
/// direction, the larger of both moves is the least, and of those pairs the smaller move is the least. That is proved, see
/// the comments of the search; no rounding decides. For legs of length `L` in a general direction the moves are about
/// \f$ L^{1/3} \f$ units, even where the kink is much smaller.
///
/// The search takes about \f$ \sqrt{L} \f$ steps, where `L` is the length of the shorter leg, and looks no farther than
/// \f$ \sqrt{\mathrm{bound}} \f$ units, with `bound = max_squared_move`. For legs of letters that is a few
/// microseconds; for the longest ones, some milliseconds.
///
/// Empty for legs that form an angle of more than 45 degrees, which is no kink, and where a handle would have to move
/// farther than the bound.
/// \throws Error `zero_tangent` for a leg of no length, `work_limit` for one with a coordinate of more than `max_leg`
inline std::optional<Aligned_handles>
align_handles(const Grid_vector& left, const Grid_vector& right,
              std::int64_t max_squared_move = (std::numeric_limits<std::int64_t>::max)()) {
  internal::check_leg(left, "align_handles: on the left");
  internal::check_leg(right, "align_handles: on the right");
  const std::int64_t sine = cross(left, right), cosine = dot(left, right);
  if (cosine < (std::abs)(sine)) return std::nullopt;
  if (sine == 0) return Aligned_handles{left, right};
  if (max_squared_move < 1) return std::nullopt;
  const bool left_is_longer = squared_length(right) < squared_length(left);
  const Grid_vector &a = left_is_longer ? right : left, &b = left_is_longer ? left : right;
  const internal::Octant turn(b);
  const internal::Grid_alignment best(turn(a), turn(b), max_squared_move);
  if (!best.found()) return std::nullopt;
  const Grid_vector x = turn(best.left()), y = turn(best.right());
  return left_is_longer ? Aligned_handles{y, x} : Aligned_handles{x, y};
}

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the leg nearest to the one given that has the direction of a vector which must stay as it is: that of a line,
/// or of a handle that belongs to another node, too. It is a multiple of the primitive vector of that direction.
/// \throws Error `zero_tangent` for a leg or a direction of no length, `work_limit` for one with a coordinate of more than
///   `max_leg`
inline Grid_vector align_handle(const Grid_vector& leg, const Grid_vector& direction) {
  internal::check_leg(leg, "align_handle: the leg");
  internal::check_leg(direction, "align_handle: the direction");
  const Grid_vector d = primitive(direction);
  return internal::nearest_multiple(leg, d) * d;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_ALIGN_HANDLES_H
