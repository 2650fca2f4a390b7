// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_REPAIRS_ALIGN_HANDLES_H
#define CGAL_GEOMETRIC_CONTINUITY_REPAIRS_ALIGN_HANDLES_H

#include <CGAL/Geometric_continuity/Error.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <optional>
#include <ostream>
#include <tuple>
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

namespace internal {

// The least whole number whose square is not less than x.
inline std::int64_t root_ceiling(std::int64_t x) {
  std::int64_t r = static_cast<std::int64_t>(std::sqrt(static_cast<double>(x)));
  while (r * r < x) ++r; // the root is rounded by far less than 1
  return r;
}

// The m >= 1 for which m d is nearest to v.
inline std::int64_t nearest_multiple(const Grid_vector& v, const Grid_vector& d) {
  const std::int64_t along = dot(v, d), d2 = dot(d, d);
  return along <= 0 ? 1 : (std::max)(std::int64_t(1), (2 * along + d2 - 1) / (2 * d2));
}

// An interval whose ends are rounded; whole numbers in it are found with a margin.
struct Rounded_interval {
  double lower, upper;

  std::int64_t first() const { return static_cast<std::int64_t>(std::ceil(lower - margin)); }
  std::int64_t last() const { return static_cast<std::int64_t>(std::floor(upper + margin)); }

  friend Rounded_interval operator&(const Rounded_interval& x, const Rounded_interval& y) {
    return {(std::max)(x.lower, y.lower), (std::min)(x.upper, y.upper)};
  }

private:
  static constexpr double margin = 1. / 64; // rounding errors are far below
};

// Finds whole numbers m, n >= 1 and a whole vector d such that m d and n d are as near as possible
// to the vectors a and b, with an angle of at most 45 degrees between them and |a| <= |b|,
// b_x >= |b_y|. The larger distance counts first, then the smaller one.
//
// For a given d, the best m and n are those of the nearest points on its ray, each by itself:
// visit(). Let r be not less than the larger distance of the best so far, nor than the allowed one.
// A better d lies in the cones
//   |a x d| <= r |d|, |b x d| <= r |d|                                                                 (1)
// and for its m and n in two discs, of radius r/m about a/m and r/n about b/n, so that
//   |n a - m b| <= r (m + n)                                                                           (2)
// First all d with 0 < d_x <= s, where s is about sqrt(|a|), that (1) admits are visited. For all
// others m s < a_x + r. For each such m there are two ways, and the one of fewer steps is taken. By
// numbers: (2) is quadratic in n, and leaves the few n for which the discs have common points,
// which are visited; few if b is not much longer than a. By the disc: the columns of the grid in
// which the disc about a/m and the cone about b have common points are visited; near the best, a
// thin cap of the disc reaches into the cone, so that there are about sqrt(r) columns.
//
// Where d_x <= -1, n d is farther from b than b_x + 1, and the d that are visited first, with
// coordinates of at most 3, leave no such r.
class Grid_alignment {
  const Grid_vector a_, b_;
  Grid_vector d_{0, 0};
  std::int64_t m_ = 0, n_ = 0;
  // the squares of the distances
  std::int64_t larger_, smaller_ = (std::numeric_limits<std::int64_t>::max)();
  std::int64_t r_ = 0;

  void visit(const Grid_vector& d) {
    const std::int64_t n = nearest_multiple(b_, d), b2 = squared_length(n * d - b_);
    if (larger_ < b2) return;
    const std::int64_t m = nearest_multiple(a_, d), a2 = squared_length(m * d - a_);
    const std::int64_t larger = (std::max)(a2, b2), smaller = (std::min)(a2, b2);
    if (std::tie(larger_, smaller_) <= std::tie(larger, smaller)) return;
    d_ = d;
    std::tie(m_, n_, larger_, smaller_) = std::tie(m, n, larger, smaller);
    r_ = root_ceiling(larger);
  }

  void visit(std::int64_t x, const Rounded_interval& ys) {
    for (std::int64_t y = ys.first(), last = ys.last(); y <= last; ++y) visit({x, y});
  }

  // The slopes of all d in the cone about v, |v x d| <= r |d| and v d > 0, that have d_x > 0.
  Rounded_interval slopes(const Grid_vector& v) const {
    const double infinity = std::numeric_limits<double>::infinity();
    const std::int64_t squared = squared_length(v) - r_ * r_;
    if (squared <= 0) return {-infinity, infinity};
    const double sum = static_cast<double>(v.x) * static_cast<double>((std::abs)(v.y)) +
                       static_cast<double>(r_) * std::sqrt(static_cast<double>(squared)),
                 flat = static_cast<double>(v.y * v.y - r_ * r_) / sum,
                 steep = r_ < v.x ? sum / static_cast<double>(v.x * v.x - r_ * r_) : infinity;
    return v.y < 0 ? Rounded_interval{-steep, -flat} : Rounded_interval{flat, steep};
  }

  // Some d next to the direction in which both distances agree, so that the radius comes down.
  void visit_middle(std::int64_t s) {
    const double slope = static_cast<double>(a_.y + b_.y) / static_cast<double>(a_.x + b_.x);
    for (std::int64_t x = 4; x <= s; x *= 2) {
      const std::int64_t y = static_cast<std::int64_t>(std::floor(slope * static_cast<double>(x)));
      visit({x, y});
      visit({x, y + 1});
    }
  }

  // All d with d_x from 1 to s, as far as a_x + r.
  void visit_short_directions(std::int64_t s) {
    Rounded_interval range{0, 0};
    std::int64_t r = -1; // that of the range
    for (std::int64_t x = 1; x <= s && x <= a_.x + r_; ++x) {
      if (r != r_) {
        r = r_;
        range = slopes(a_) & slopes(b_);
      }
      // by n >= 1
      const double f = static_cast<double>(x), highest = static_cast<double>((std::abs)(b_.y) + r_);
      visit(x, Rounded_interval{range.lower * f, range.upper * f} & Rounded_interval{-highest, highest});
    }
  }

  struct Disc {
    double x, y, radius;
    Rounded_interval chord(double at) const {
      const double h = std::sqrt((std::max)(0., radius * radius - (at - x) * (at - x)));
      return {y - h, y + h};
    }
  };

  // The disc for a multiple m, or n, a little larger.
  Disc disc(const Grid_vector& v, std::int64_t m) const {
    const double f = static_cast<double>(m);
    return {static_cast<double>(v.x) / f, static_cast<double>(v.y) / f, static_cast<double>(r_ + 1) / f};
  }

  // The n for which (2) holds with r + 1 in place of r; that must be less than |a|.
  Rounded_interval numbers_right(std::int64_t m) const {
    const double r = static_cast<double>(r_ + 1), sum = std::sqrt(static_cast<double>(squared_length(a_ + b_))) * r,
                 area = static_cast<double>((std::abs)(cross(a_, b_))),
                 root = std::sqrt((std::max)(0., (sum - area) * (sum + area))),
                 middle = static_cast<double>(dot(a_, b_)) + r * r, factor = static_cast<double>(m),
                 divisor = static_cast<double>(squared_length(a_) - (r_ + 1) * (r_ + 1));
    return {(std::max)(1., factor * (middle - root) / divisor), factor * (middle + root) / divisor};
  }

  // The whole points that the discs for m and n may have in common; first those next to the point
  // (a + b) / (m + n), which is in the middle of them all, so that the radius comes down.
  void visit_common_points(std::int64_t m, std::int64_t n) {
    const Grid_vector sum = a_ + b_, middle{sum.x / (m + n), sum.y / (m + n)};
    for (std::int64_t x = middle.x; x <= middle.x + 1; ++x)
      for (std::int64_t y = middle.y - 1; y <= middle.y + 1; ++y)
        // unreachable: short directions are visited before, and are not met again
        if (x > 0) visit({x, y});
    const Disc left = disc(a_, m), right = disc(b_, n);
    Rounded_interval xs = Rounded_interval{left.x - left.radius, left.x + left.radius} &
                          Rounded_interval{right.x - right.radius, right.x + right.radius};
    // where the chord through both circles lies between the centres, it is a diameter of a disc
    // about all common points
    const double dx = right.x - left.x, dy = right.y - left.y, d2 = dx * dx + dy * dy,
                 // 2 d2 times the part of the way
        at = d2 + left.radius * left.radius - right.radius * right.radius;
    // unreachable: the disc of the longer vector is not the larger one, but for rounding
    if (0 < at && at < 2 * d2) {
      const double part = at / (2 * d2), squared = left.radius * left.radius,
                   h = std::sqrt((std::max)(0., squared * (1 + 1e-14) - part * part * d2));
      const double x = left.x + part * dx;
      xs = xs & Rounded_interval{x - h, x + h};
    }
    for (std::int64_t x = (std::max)(std::int64_t(1), xs.first()), last = xs.last(); x <= last; ++x)
      visit(x, left.chord(static_cast<double>(x)) & right.chord(static_cast<double>(x)));
  }

  // The part of the disc about a, with r + 1 in place of r, that reaches into the cone about b:
  // where |x - middle| <= extent.
  struct Disc_in_cone {
    std::int64_t r;
    Rounded_interval slopes;
    double middle, extent, height;
  };

  Disc_in_cone disc_in_cone() const {
    const bool above = cross(b_, a_) > 0;
    const Rounded_interval cone = slopes(b_);
    const double x = static_cast<double>(a_.x), y = static_cast<double>(a_.y), r = static_cast<double>(r_ + 1),
                 slope = above ? cone.upper : cone.lower, // of the side next to a
        length = std::sqrt(1 + slope * slope), distance = (above ? y - slope * x : slope * x - y) / length;
    // equivalent [2 -> 3, 1]: a larger part is looked at
    if (!(distance > 0)) return {r_, cone, x, r, 2 * r}; // or infinite slopes
    if (distance > r) return {r_, cone, x, 0, 0};
    const double height = r - distance, half_chord = std::sqrt(height * (r + distance));
    return {r_, cone, (x + slope * y) / (length * length), (half_chord + height * (std::abs)(slope)) / length, height};
  }

  // All d with d_x > s in the disc about a / m and in the cone about b, from the middle on.
  void visit_disc(std::int64_t m, std::int64_t s) {
    Disc_in_cone part = disc_in_cone();
    const double f = static_cast<double>(m);
    const auto visit_column = [&](std::int64_t x) {
      if (x <= s) return;
      if (part.r != r_) part = disc_in_cone();
      const double at = static_cast<double>(x);
      visit(x, Rounded_interval{part.slopes.lower * at, part.slopes.upper * at} & disc(a_, m).chord(at));
    };
    const double middle = part.middle;
    const std::int64_t first = static_cast<std::int64_t>(middle / f);
    visit_column(first);
    for (std::int64_t i = 1; static_cast<double>(i - 1) <= ((std::abs)(part.middle - middle) + part.extent) / f + 1;
         ++i) {
      visit_column(first - i);
      visit_column(first + i);
    }
  }

  // About how many steps both ways take up to a multiple of a.
  double steps_by_discs(std::int64_t last) const {
    const Disc_in_cone part = disc_in_cone();
    const double m = static_cast<double>(last),
                 ratio = std::sqrt(static_cast<double>(squared_length(a_)) / static_cast<double>(squared_length(b_))),
                 column = 2 * (std::min)(part.height, 2 * static_cast<double>(r_) * ratio);
    return m + 2 * part.extent * (1 + std::log(m) + column);
  }
  double steps_by_numbers(std::int64_t last) const {
    const double m = static_cast<double>(last);
    const Rounded_interval n = numbers_right(1);
    return 6 * (m + (n.upper - n.lower) * m * (m + 1) / 2);
  }

public:
  // The coordinates are at most 2^28, and the square of the allowed distance is at least 1.
  Grid_alignment(const Grid_vector& a, const Grid_vector& b, std::int64_t max_squared_distance)
      : a_(a), b_(b), larger_(max_squared_distance) {
    for (std::int64_t x = -3; x <= 3; ++x)
      // equivalent [3 -> 4, 2]: more pairs are visited first
      for (std::int64_t y = -3; y <= 3; ++y)
        if (x != 0 || y != 0) visit({x, y});
    if (!found()) r_ = root_ceiling(larger_);
    const std::int64_t all = (std::numeric_limits<std::int64_t>::max)(), s = 2 + root_ceiling(a.x + (std::abs)(a.y));
    visit_middle(s);
    visit_short_directions(s);
    // equivalent [<= -> <, 1]: both roads visit all pairs
    if (squared_length(a) <= (r_ + 1) * (r_ + 1)) {
      visit_short_directions(all);
      return;
    }
    const auto last = [&] { return (a_.x + r_) / (s + 1); };
    if (last() < 1) return;
    if (steps_by_discs(last()) < steps_by_numbers(last()))
      for (std::int64_t m = 1; m <= last(); ++m) visit_disc(m, s);
    else
      for (std::int64_t m = 1; m <= last(); ++m)
        for (std::int64_t n = numbers_right(m).first(); n <= numbers_right(m).last(); ++n) visit_common_points(m, n);
  }

  bool found() const { return m_ != 0; }
  Grid_vector left() const { return m_ * d_; }
  Grid_vector right() const { return n_ * d_; }
};

} // namespace internal

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
