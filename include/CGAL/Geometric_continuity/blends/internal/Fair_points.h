// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_POINTS_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_POINTS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_turns.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Fair_points.h
/// The points through which a fair spline leads, in an order that does not depend on how they are
/// given, and rounded so that there is room for exact joins.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The coordinates of the point number i, or of the tangent there, rounded to doubles.
template <class Traits>
Coordinate_vector<double, dimension_v<Traits>> rounded_column(const Coordinates<Traits>& x, int dimension, int i) {
  if (x.dimension() != dimension)
    throw Error(Error_code::dimension_mismatch, "interpolate_fair: at the point " + std::to_string(i));
  Coordinate_vector<double, dimension_v<Traits>> y(dimension);
  for (int k = 0; k < dimension; ++k) {
    check_finite(x[k], "interpolate_fair: a coordinate");
    y[k] = rounded_number(x[k]);
    check_finite(y[k], "interpolate_fair: a coordinate");
  }
  return y;
}

// The points through which a fair spline leads, with the tangents that are given. They are in an
// order that does not depend on the direction of the given ones: an open curve starts at the lesser
// of its ends, a closed one at the least of its points and towards the lesser of the next ones. So
// reversed points get the reversed curve, whatever is rounded.
template <class Traits> struct Fair_points {
  std::vector<Coordinates<Traits>> points;
  std::vector<std::optional<Coordinates<Traits>>> tangents;
  bool closed;
  int start = 0; // the number of the first one, of those that are given
  bool is_reversed = false;
  double size = 0;   // the largest coordinate
  double extent = 0; // that seen from the first point

  int exponent() const { return extent > 0 ? std::ilogb(extent) : 0; }
  Coordinates<Traits> from_first(int i) const { return points[i] - points[0]; }
  int number() const { return static_cast<int>(points.size()); }
  int next(int i) const { return (i + 1) % number(); }
  int pieces() const { return closed ? number() : number() - 1; }
  // The numbers of a point and of a piece among those that are given.
  int given(int i) const { return (is_reversed ? start - i + number() : start + i) % number(); }
  int given_piece(int i) const { return is_reversed ? given(next(i)) : given(i); }

  void order() {
    const int n = number();
    const auto is_less = [](const Coordinates<Traits>& a, const Coordinates<Traits>& b) {
      for (int k = 0; k < a.dimension(); ++k) {
        if (a[k] < b[k]) return true;
        if (b[k] < a[k]) return false;
      }
      return false;
    };
    if (closed) {
      start = static_cast<int>(std::min_element(points.begin(), points.end(), is_less) - points.begin());
      is_reversed = is_less(points[(start + n - 1) % n], points[next(start)]);
    } else {
      is_reversed = is_less(points.back(), points.front());
      start = is_reversed ? n - 1 : 0;
    }
    std::vector<Coordinates<Traits>> ordered;
    std::vector<std::optional<Coordinates<Traits>>> ordered_tangents;
    for (int i = 0; i < n; ++i) {
      ordered.push_back(points[given(i)]);
      if (tangents.empty()) continue;
      ordered_tangents.push_back(tangents[given(i)]);
      if (is_reversed && ordered_tangents.back())
        *ordered_tangents.back() = typename Traits::FT(-1) * *ordered_tangents.back();
    }
    points = std::move(ordered);
    tangents = std::move(ordered_tangents);
  }
};

template <class Traits, class InputIterator>
Fair_points<Traits> points_of_fair_spline(InputIterator first, InputIterator last, Closure closure,
                                          const std::vector<std::optional<typename Traits::Vector>>& tangents) {
  Fair_points<Traits> p{{}, {}, closure == Closure::closed};
  for (; first != last; ++first) p.points.push_back(Geometric_continuity::coordinates<Traits>(*first));
  if (p.number() < (p.closed ? 3 : 2))
    throw Error(Error_code::wrong_number_of_points, "interpolate_fair: " + std::to_string(p.number()) + " points");
  if (!tangents.empty() && tangents.size() != p.points.size())
    throw Error(Error_code::wrong_number_of_points, "interpolate_fair: " + std::to_string(tangents.size()) +
                                                        " tangents for " + std::to_string(p.number()) + " points");
  for (const std::optional<typename Traits::Vector>& t : tangents) {
    p.tangents.emplace_back();
    if (t) p.tangents.back() = Geometric_continuity::coordinates<Traits>(*t);
  }
  const int dimension = p.points[0].dimension();
  for (int i = 0; i < p.number(); ++i)
    for (const double x : rounded_column<Traits>(p.points[i], dimension, i)) p.size = (std::max)(p.size, std::abs(x));
  for (int i = 0; i < p.pieces(); ++i)
    if (p.points[i] == p.points[p.next(i)])
      throw Error(Error_code::empty_domain, "interpolate_fair: the points " + std::to_string(i) + " and " +
                                                std::to_string(p.next(i)) + " coincide");
  p.order();
  for (int i = 0; i < p.number(); ++i)
    for (const double x : rounded_column<Traits>(p.from_first(i), dimension, p.given(i)))
      p.extent = (std::max)(p.extent, std::abs(x));
  return p;
}

// The multiple of 2^n nearest to x.
inline double multiple_of_power(double x, int n) { return std::ldexp(std::nearbyint(std::ldexp(x, -n)), n); }

// The exponent of a unit of all coordinates so that `digits` of those of the largest one are left
// for the points of the blends; below all exponents where no number is rounded.
template <class FT> int unit_with_room(double size, int digits) {
  if constexpr (std::is_floating_point_v<FT>)
    if (size > 0) return std::ilogb(size) + digits - std::numeric_limits<FT>::digits;
  return -1000;
}

// Leaves 7 digits for that, with floating-point numbers. Returns the largest change of a
// coordinate.
template <class Traits> typename Traits::FT round_points(Fair_points<Traits>& p) {
  typedef typename Traits::FT FT;
  FT moved(0);
  if constexpr (std::is_floating_point_v<FT>)
    for (Coordinates<Traits>& x : p.points)
      for (int k = 0; k < x.dimension(); ++k) {
        const FT given = x[k];
        // equivalent [7 -> 8, 1]: one digit more of room
        x[k] = FT(multiple_of_power(given, unit_with_room<FT>(p.size, 7)));
        moved = (std::max)(moved, FT(std::abs(x[k] - given)));
      }
  return moved;
}

// The points, in units of the power of two below the largest coordinate, with the tangents that are
// given.
template <class Traits> std::vector<Fair_joint<dimension_v<Traits>>> joints_of(const Fair_points<Traits>& p) {
  typedef Coordinate_vector<double, dimension_v<Traits>> Column;
  const int dimension = p.points[0].dimension();
  std::vector<Fair_joint<dimension_v<Traits>>> joints;
  for (int i = 0; i < p.number(); ++i) {
    Work_meter::pause();
    Column point = rounded_column<Traits>(p.from_first(i), dimension, p.given(i));
    for (int k = 0; k < dimension; ++k) point[k] = std::ldexp(point[k], -p.exponent());
    joints.push_back({point, Column(dimension), Column(dimension), false});
    if (p.tangents.empty() || !p.tangents[i]) continue;
    Column& tangent = joints.back().tangent;
    tangent = rounded_column<Traits>(*p.tangents[i], dimension, p.given(i));
    const double size = length(tangent);
    if (!(size > 0))
      throw Error(Error_code::zero_tangent, "interpolate_fair: at the point " + std::to_string(p.given(i)));
    tangent /= size;
    joints.back().given = true;
  }
  return joints;
}

// The lengths of the chords from each point to the next one, in the same units.
template <class Traits>
std::vector<double> chord_lengths(const Fair_points<Traits>& p,
                                  const std::vector<Fair_joint<dimension_v<Traits>>>& joints) {
  std::vector<double> lengths;
  for (int i = 0; i < p.pieces(); ++i) {
    lengths.push_back(length<dimension_v<Traits>>(joints[p.next(i)].point - joints[i].point));
    if (!(lengths.back() > 0))
      throw Error(Error_code::empty_domain, "interpolate_fair: the points " + std::to_string(p.given_piece(i)) +
                                                " and " + std::to_string((p.given_piece(i) + 1) % p.number()) +
                                                " coincide when they are rounded, to leave room for exact joins: "
                                                "subtract what all points have in common, or use exact numbers");
  }
  return lengths;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_POINTS_H
