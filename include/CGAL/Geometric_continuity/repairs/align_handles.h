// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_REPAIRS_ALIGN_HANDLES_H
#define CGAL_GEOMETRIC_CONTINUITY_REPAIRS_ALIGN_HANDLES_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/repairs/Grid_vector.h>
#include <CGAL/Geometric_continuity/repairs/internal/Grid_alignment.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

/// \file align_handles.h
/// Handles of a drawing or a letter are moved on their grid: a kink between two curves becomes
/// exactly smooth, or curvatures agree.
///
/// `align_handles()`: a node and a handle on each side, with the vectors \f$ a = N - A \f$ and
/// \f$ b = B - N \f$. The join is G1 if and only if \f$ a = m d, b = n d \f$ for a whole vector `d`
/// and whole numbers \f$ m, n \ge 1 \f$.
///
/// `harmonise_handles()`: the curvatures at a node with parallel handles agree when the lengths of
/// the handles change on their grid. With the handles \f$ m d \f$ and \f$ n d \f$ of curves of
/// degrees `j` and `k`, and with \f$ u, v \f$ from the control point before the handle to the node
/// and from the node to the one behind the handle, the curvatures are
/// \f$ \frac{j-1}{j} \frac{u \times d}{m^2 |d|^3} \f$ and
/// \f$ \frac{k-1}{k} \frac{d \times v}{n^2 |d|^3} \f$: the control points next to the handles do
/// not depend on them.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityExtensions
/// The handles of a node, as vectors, after they have been moved: from the handle on the left to
/// the node, and from there to the handle on the right.
struct Aligned_handles {
  Grid_vector left;  ///< \f$ m d \f$
  Grid_vector right; ///< \f$ n d \f$
};

/// \ingroup PkgGeometricContinuityExtensions
/// The largest coordinate of a handle, as a vector, that `align_handles()` takes: \f$ 2^{28} \f$,
/// so that all its products are exact.
constexpr std::int64_t max_handle_coordinate = std::int64_t(1) << 28;

namespace internal {

inline void check_handle(const Grid_vector& v, const char* place) {
  if (v == Grid_vector{0, 0}) throw Error(Error_code::zero_tangent, place);
  if (v.x < -max_handle_coordinate || max_handle_coordinate < v.x || v.y < -max_handle_coordinate ||
      max_handle_coordinate < v.y)
    throw Error(Error_code::work_limit, std::string(place) + ": a handle is longer than 2^28 units");
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
/// Returns handles of one direction, as vectors, as near as possible to those given: among all
/// pairs of parallel whole vectors of one direction, the larger of both moves is the least, and of
/// those pairs the smaller move is the least. This is proved, see the comments of the search; no
/// rounding decides. For handles of length `L` in a general direction the moves are about
/// \f$ L^{1/3} \f$ units, even where the kink is much smaller.
///
/// The search takes about \f$ \sqrt{L} \f$ steps, where `L` is the length of the shorter handle,
/// and looks no farther than \f$ \sqrt{\mathrm{bound}} \f$ units, with `bound = max_squared_move`.
/// For handles of letters that is a few microseconds; for the longest ones, some milliseconds.
///
/// Empty for handles that form an angle of more than 45 degrees, which is no kink, and where a
/// handle would have to move farther than the bound.
/// \throws Error `zero_tangent` for a handle of no length, `work_limit` for one with a coordinate
///   of more than `max_handle_coordinate`
inline std::optional<Aligned_handles>
align_handles(const Grid_vector& left, const Grid_vector& right,
              std::int64_t max_squared_move = (std::numeric_limits<std::int64_t>::max)()) {
  internal::check_handle(left, "align_handles: on the left");
  internal::check_handle(right, "align_handles: on the right");
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
/// Returns the handle nearest to the one given that has the direction of a vector which must stay
/// as it is: that of a line, or of a handle that belongs to another node, too. It is a multiple of
/// the primitive vector of that direction.
/// \throws Error `zero_tangent` for a handle or a direction of no length, `work_limit` for one with
///   a coordinate of more than `max_handle_coordinate`
inline Grid_vector align_handle(const Grid_vector& handle, const Grid_vector& direction) {
  internal::check_handle(handle, "align_handle: the handle");
  internal::check_handle(direction, "align_handle: the direction");
  const Grid_vector d = primitive(direction);
  return internal::nearest_multiple(handle, d) * d;
}

/// \ingroup PkgGeometricContinuityExtensions
/// One side of a node: the curve that ends or starts there.
struct Handle_side {
  Grid_vector handle; ///< from the handle to the node, or from the node to the handle
  /// from the control point next to the handle to the node, or from the node to that control point
  Grid_vector second;
  int degree;   ///< the degree of the curve, at least 2
  bool movable; ///< whether the handle may move
};

/// \ingroup PkgGeometricContinuityExtensions
/// The largest coordinate of a handle that `harmonise_handles()` takes.
constexpr std::int64_t max_harmonised_coordinate = std::int64_t(1) << 25;

/// \ingroup PkgGeometricContinuityExtensions
/// The largest degree of a curve that `harmonise_handles()` takes.
constexpr std::int64_t max_harmonised_degree = 32;

namespace internal {

// The square root of a square; nothing for other numbers.
inline std::optional<std::int64_t> exact_root(std::int64_t x) {
  const std::int64_t r = static_cast<std::int64_t>(std::llround(std::sqrt(static_cast<double>(x))));
  if (r * r != x) return std::nullopt;
  return r;
}

// Lengths m, n >= 1 for which p / m^2 = q / n^2, or nearly so, with p, q > 0, as near as possible
// to the given ones.
struct Handle_lengths {
  std::int64_t m, n;
  bool left_movable, right_movable;

  typedef std::pair<std::int64_t, std::int64_t> Lengths;

  std::int64_t steps(const Lengths& x) const { return (std::max)((std::abs)(x.first - m), (std::abs)(x.second - n)); }
  bool allows(const Lengths& x) const {
    return x.first >= 1 && x.second >= 1 && (left_movable || x.first == m) && (right_movable || x.second == n);
  }

  // The nearest of those that are exact.
  std::optional<Lengths> exact(std::int64_t p, std::int64_t q) const {
    const std::int64_t divisor = std::gcd(p, q);
    const std::optional<std::int64_t> i = exact_root(p / divisor), j = exact_root(q / divisor);
    if (!i || !j) return std::nullopt;
    std::optional<Lengths> best;
    for (const std::int64_t t : {(m + n) / (*i + *j), (m + n) / (*i + *j) + 1, m / *i, n / *j}) {
      const Lengths x(t * *i, t * *j);
      if (allows(x) && (!best || steps(x) < steps(*best))) best = x;
    }
    return best;
  }

  // Near the nearest real ones, those with the least jump of the curvature.
  Lengths nearly(std::int64_t p, std::int64_t q) const {
    const double ratio = std::sqrt(static_cast<double>(q) / static_cast<double>(p)), // n : m
        x = !left_movable    ? static_cast<double>(m)
            : !right_movable ? static_cast<double>(n) / ratio
                             : static_cast<double>(m + n) / (1 + ratio);
    const auto jump = [p, q](const Lengths& lengths) {
      const double s = static_cast<double>(lengths.first), t = static_cast<double>(lengths.second);
      const double left = static_cast<double>(p) * t * t, right = static_cast<double>(q) * s * s;
      return (std::abs)(left - right) / (std::max)(left, right);
    };
    Lengths best(m, n);
    for (std::int64_t i = -3; i <= 3; ++i)
      for (std::int64_t j = -3; j <= 3; ++j) {
        const Lengths lengths(std::llround(x) + i, std::llround(x * ratio) + j);
        if (allows(lengths) && jump(lengths) < jump(best)) best = lengths;
      }
    return best;
  }
};

inline void check_side(const Handle_side& side, const char* place) {
  check_handle(side.handle, place);
  for (const std::int64_t x : {side.handle.x, side.handle.y, side.second.x, side.second.y})
    if (x < -max_harmonised_coordinate || max_harmonised_coordinate < x)
      throw Error(Error_code::work_limit, std::string(place) + ": a handle is longer than 2^25 units");
  if (side.degree < 2 || max_harmonised_degree < side.degree)
    throw Error(Error_code::wrong_number_of_points, std::string(place) + ": a degree that is not from 2 to 32");
}

} // namespace internal

/// \ingroup PkgGeometricContinuityExtensions
/// Returns handles of the direction that the given ones have, with such lengths that the curvatures
/// of both curves at the node agree: exactly, if the grid has such lengths for which no handle
/// moves by more than \f$ \sqrt{\mathrm{bound}} \f$ units, with `bound = max_squared_move`;
/// otherwise those of the least jump of the curvature within three steps of the nearest real
/// lengths, which may be further away than that. `is_g2_join()` decides if the join is G2, and
/// `deviation()` how far it is from that. Each handle that moves also changes the curvature at the
/// other end of its curve, if that is a cubic.
///
/// Empty when no lengths make the curvatures agree: they have different signs, or one of them is
/// zero.
/// \throws Error `zero_tangent` for a handle of no length, `zero_direction` for handles that have
///   not one direction, `work_limit` for coordinates of more than `max_harmonised_coordinate`,
///   `wrong_number_of_points` for degrees that are not from 2 to 32
inline std::optional<Aligned_handles> harmonise_handles(const Handle_side& left, const Handle_side& right,
                                                        std::int64_t max_squared_move) {
  internal::check_side(left, "harmonise_handles: on the left");
  internal::check_side(right, "harmonise_handles: on the right");
  if (cross(left.handle, right.handle) != 0 || dot(left.handle, right.handle) < 0)
    throw Error(Error_code::zero_direction, "harmonise_handles: the handles have not one direction");
  const Grid_vector d = primitive(left.handle);
  const std::int64_t j = left.degree, k = right.degree, p = (j - 1) * k * cross(left.second, d),
                     q = (k - 1) * j * cross(d, right.second);
  if (p == 0 && q == 0) return Aligned_handles{left.handle, right.handle};
  if ((p <= 0 || q <= 0) && (p >= 0 || q >= 0)) return std::nullopt;
  const internal::Handle_lengths given{dot(left.handle, d) / squared_length(d),
                                       dot(right.handle, d) / squared_length(d), left.movable, right.movable};
  std::optional<internal::Handle_lengths::Lengths> lengths = given.exact((std::abs)(p), (std::abs)(q));
  if (lengths && given.steps(*lengths) > 0 &&
      max_squared_move / squared_length(d) / given.steps(*lengths) < given.steps(*lengths))
    lengths.reset();
  if (!lengths) lengths = given.nearly((std::abs)(p), (std::abs)(q));
  return Aligned_handles{lengths->first * d, lengths->second * d};
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_REPAIRS_ALIGN_HANDLES_H
