// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_HARMONISE_HANDLES_H
#define CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_HARMONISE_HANDLES_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/extensions/align_handles.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

/// \file harmonise_handles.h
/// Makes the curvatures at a node with parallel handles agree by changing the lengths of the handles on their grid. With the legs
/// \f$ m d \f$ and \f$ n d \f$ of curves of degrees `j` and `k`, and with \f$ u, v \f$ from the control point before the handle
/// to the node and from the node to the one behind the handle, the curvatures are
/// \f$ \frac{j-1}{j} \frac{u \times d}{m^2 |d|^3} \f$ and \f$ \frac{k-1}{k} \frac{d \times v}{n^2 |d|^3} \f$: the control
/// points next to the handles do not depend on them.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityExtensions
/// One side of a node: the curve that ends or starts there.
struct Handle_side {
  Grid_vector leg; ///< from the handle to the node, or from the node to the handle
  Grid_vector
      far_leg;  ///< from the control point next to the handle to the node, or from the node to that control point
  int degree;   ///< of the curve, at least 2
  bool movable; ///< whether the handle may move
};

/// \ingroup PkgGeometricContinuityExtensions
/// The largest coordinate of a leg that `harmonise_handles()` takes, and the largest degree.
constexpr std::int64_t max_harmonised_leg = std::int64_t(1) << 25, max_harmonised_degree = 32;

namespace internal {

// The square root of a square; nothing for other numbers.
inline std::optional<std::int64_t> exact_root(std::int64_t x) {
  const std::int64_t r = static_cast<std::int64_t>(std::llround(std::sqrt(static_cast<double>(x))));
  if (r * r != x) return std::nullopt;
  return r;
}

// Lengths m, n >= 1 for which p / m^2 = q / n^2, or nearly so, with p, q > 0, as near as possible to the given ones.
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
  check_leg(side.leg, place);
  for (const std::int64_t x : {side.leg.x, side.leg.y, side.far_leg.x, side.far_leg.y})
    if (x < -max_harmonised_leg || max_harmonised_leg < x)
      throw Error(Error_code::work_limit, std::string(place) + ": a leg is longer than 2^25 units");
  if (side.degree < 2 || max_harmonised_degree < side.degree)
    throw Error(Error_code::wrong_number_of_points, std::string(place) + ": a degree that is not from 2 to 32");
}

} // namespace internal

/// \ingroup PkgGeometricContinuityExtensions
/// Returns legs of the direction that the given ones have, with such lengths that the curvatures of both curves at the node agree:
/// exactly, if the grid has such lengths for which no handle moves by more than \f$ \sqrt{\mathrm{bound}} \f$ units, with
/// `bound = max_squared_move`; otherwise those of the least jump of the curvature within three steps of the nearest real
/// lengths, which may be further away than that. Whether the join is G2 is for `is_g2_join()` to say, and how far it is
/// from that for `deviation()`. Each handle that moves also changes the curvature at the other end of its curve, if that is a cubic.
///
/// Empty when no lengths make the curvatures agree: they have different signs, or one of them is zero.
/// \throws Error `zero_tangent` for a leg of no length, `zero_direction` for legs that have not one direction, `work_limit` for
///   coordinates of more than `max_harmonised_leg`, `wrong_number_of_points` for degrees that are not from 2 to 32
inline std::optional<Aligned_handles> harmonise_handles(const Handle_side& left, const Handle_side& right,
                                                        std::int64_t max_squared_move) {
  internal::check_side(left, "harmonise_handles: on the left");
  internal::check_side(right, "harmonise_handles: on the right");
  if (cross(left.leg, right.leg) != 0 || dot(left.leg, right.leg) < 0)
    throw Error(Error_code::zero_direction, "harmonise_handles: the legs have not one direction");
  const Grid_vector d = primitive(left.leg);
  const std::int64_t j = left.degree, k = right.degree, p = (j - 1) * k * cross(left.far_leg, d),
                     q = (k - 1) * j * cross(d, right.far_leg);
  if (p == 0 && q == 0) return Aligned_handles{left.leg, right.leg};
  if ((p <= 0 || q <= 0) && (p >= 0 || q >= 0)) return std::nullopt;
  const internal::Handle_lengths given{dot(left.leg, d) / squared_length(d), dot(right.leg, d) / squared_length(d),
                                       left.movable, right.movable};
  std::optional<internal::Handle_lengths::Lengths> lengths = given.exact((std::abs)(p), (std::abs)(q));
  if (lengths && given.steps(*lengths) > 0 &&
      max_squared_move / squared_length(d) / given.steps(*lengths) < given.steps(*lengths))
    lengths.reset();
  if (!lengths) lengths = given.nearly((std::abs)(p), (std::abs)(q));
  return Aligned_handles{lengths->first * d, lengths->second * d};
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_HARMONISE_HANDLES_H
