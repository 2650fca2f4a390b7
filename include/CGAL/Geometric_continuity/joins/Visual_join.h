// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_VISUAL_JOIN_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_VISUAL_JOIN_H

#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>
#include <CGAL/Geometric_continuity/joins/internal/Image_end.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>

/// \file Visual_join.h
/// The look of a join of two curves whose control points lie on a grid, as those of a font do.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// Control points with integer coordinates, counted from the node at one of the ends on.
template <class Point, class Integer, bool is_end_> class Integer_polygon {
  typedef std::decay_t<decltype(Point::x)> Coordinate;
  const Point* points_;
  int degree_;

  const Point& point(int j) const { return points_[static_cast<std::ptrdiff_t>(is_end_ ? degree_ - j : j)]; }

public:
  static constexpr bool is_end = is_end_;

  Integer_polygon(const Point* points, int degree) : points_(points), degree_(degree) {}

  int degree() const { return degree_; }
  bool are_equal(int j, int k) const { return point(j).x == point(k).x && point(j).y == point(k).y; }

  // The vector has the type of the coordinates, and is then converted.
  template <class NT> std::array<NT, 2> vector(int j, int k) const {
    const Coordinate x = point(k).x - point(j).x, y = point(k).y - point(j).y;
    if constexpr (std::is_integral_v<NT>)
      return {static_cast<NT>(x), static_cast<NT>(y)};
    else
      return {from_integer<NT>(x), from_integer<NT>(y)};
  }
  bool have_one_direction(int i, int j, int k) const {
    const Plane_products<Integer> p(vector<Integer>(i, j), vector<Integer>(k, k + 1));
    return p.cross == 0 && 0 < p.dot;
  }

  // With the first differences a and b in the direction of the curve the curvature is (1 -
  // 1/degree) a x b / |.|^3; here without that length and times the degree.
  Integer bend() const {
    if (degree_ == 1) return 0;
    const std::array<Integer, 2> a = vector<Integer>(is_end ? 2 : 0, 1), b = vector<Integer>(1, is_end ? 0 : 2);
    return (degree_ - 1) * Plane_products<Integer>(a, b).cross;
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// The join of two plane Bézier curves whose control points are integers: it is seen as by
/// `visual_class()`, without long numbers where the integers are short. The curves meet in the
/// node, the last control point of the left and the first one of the right one.
/// \tparam Point_ a point with integer members `x` and `y`, whose differences have no overflow
/// \tparam Integer_ a signed integer type that has all cross and dot products of differences, times
///   the product of both degrees
template <class Point_, class Integer_> class Visual_join {
public:
  typedef Point_ Point;                                ///< a control point
  typedef Integer_ Integer;                            ///< a product of differences
  typedef std::decay_t<decltype(Point::x)> Coordinate; ///< a coordinate
  typedef std::array<Coordinate, 2> Vector;            ///< a difference of points
  typedef Corner_threshold::Field Field;               ///< exact numbers

private:
  typedef internal::Image_end<internal::Integer_polygon<Point, Integer, true>> Left;
  typedef internal::Image_end<internal::Integer_polygon<Point, Integer, false>> Right;

  const Left left_;
  const Right right_;
  const Vector incoming_, outgoing_;

  template <class End> static Vector vector_of(const End& end) {
    return end.has_length() ? end.template vector<Coordinate>() : Vector{0, 0};
  }
  internal::Plane_products<Integer> products() const {
    return {{Integer(incoming_[0]), Integer(incoming_[1])}, {Integer(outgoing_[0]), Integer(outgoing_[1])}};
  }

  // The ends as internal::visual_class_of() asks for them.
  struct Image {
    const Visual_join& join;

    const Left& left() const { return join.left_; }
    const Right& right() const { return join.right_; }
    std::optional<bool> exceeds(const Corner_threshold& bound) const {
      return internal::exceeds(join.products(), bound);
    }

    // Parallel directions with |b| / |a| = b_i / a_i make the curvatures comparable without roots.
    bool has_one_curvature() const {
      const std::size_t i = join.incoming_[0] != 0 ? 0 : 1;
      const Coordinate a = std::abs(join.incoming_[i]), b = std::abs(join.outgoing_[i]);
      const typename Left::Polygon& x = left().polygon();
      const typename Right::Polygon& y = right().polygon();
      const Integer left_bend = left().is_retracted() ? Integer(0) : Integer(x.bend() * y.degree()),
                    right_bend = right().is_retracted() ? Integer(0) : Integer(y.bend() * x.degree());
      constexpr int digits = 8 * static_cast<int>(sizeof(Integer)) - 1, short_digits = digits * 23 / 127;
      constexpr Integer short_length = Integer(1) << short_digits, short_bend = Integer(1)
                                                                                << (digits - 2 - 3 * short_digits);
      const auto is_short = [](const Integer& bend) { return -short_bend < bend && bend < short_bend; };
      if (a < short_length && b < short_length && is_short(left_bend) && is_short(right_bend))
        return Integer(b) * b * b * left_bend == Integer(a) * a * a * right_bend;
      const double c = static_cast<double>(b), d = static_cast<double>(a), p = c * c * c * rounded(left_bend),
                   q = d * d * d * rounded(right_bend);
      if (0x1p-46 * (std::abs(p) + std::abs(q)) < std::abs(p - q)) return false;
      const auto product = [](Coordinate length, Integer bend) -> Field {
        const Field l = exact(Integer(length));
        return Field(l * l) * Field(l * exact(bend));
      };
      return product(b, left_bend) == product(a, right_bend);
    }
  };

public:
  /// Constructs the join of two curves from their control points, which must stay as long as this
  /// object.
  Visual_join(const Point* left, int left_degree, const Point* right, int right_degree)
      : left_({left, left_degree}), right_({right, right_degree}), incoming_(vector_of(left_)),
        outgoing_(vector_of(right_)) {}

  /// Returns the first difference of the left curve that is not zero, in the direction of the
  /// curve; zero if it has no length.
  const Vector& incoming() const { return incoming_; }
  /// Returns that of the right curve.
  const Vector& outgoing() const { return outgoing_; }
  /// Returns the cross product of both.
  Integer cross() const { return products().cross; }
  /// Returns their dot product.
  Integer dot() const { return products().dot; }

  /// Returns whether both curves are drawn as lines. \pre both have a length
  bool is_of_lines() const { return left_.is_line() && right_.is_line(); }

  /// Decides whether the angle is larger than the bound. \pre both have a length
  bool exceeds(const Corner_threshold& bound) const { return internal::exceeds(products(), bound).value_or(false); }

  /// Returns what the join looks like, as the function `visual_class()` does; empty when a curve
  /// has no length.
  std::optional<Visual_class> visual_class(const Corner_threshold& bound) const {
    return internal::visual_class_of(Image{*this}, bound);
  }

  /// Returns how large the angle is, as the function `kink_size()` does. \pre both have a length
  Kink_size kink_size() const {
    return internal::kink_size_of(left_.template vector<Field>(), right_.template vector<Field>());
  }

  /// Returns an integer, rounded.
  static double rounded(const Integer& x) { return internal::rounded_integer(x); }
  /// Returns an integer as an exact number.
  static Field exact(const Integer& x) { return internal::from_integer<Field>(x); }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_VISUAL_JOIN_H
