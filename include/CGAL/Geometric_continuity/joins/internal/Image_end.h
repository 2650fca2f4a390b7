// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_IMAGE_END_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_IMAGE_END_H

#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

/// The decisions about what is seen of a join, for curves with any numbers and for control points
/// that are integers.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The cross and the dot product of two vectors of the plane, and a bound of their terms.
template <class NT> struct Plane_products {
  NT cross, dot, size;

  Plane_products(const std::array<NT, 2>& a, const std::array<NT, 2>& b)
      : cross(NT(a[0] * b[1]) - NT(a[1] * b[0])), dot(NT(a[0] * b[0]) + NT(a[1] * b[1])), size(0) {
    using std::abs;
    if constexpr (std::is_floating_point_v<NT>) size = (abs(a[0]) + abs(a[1])) * (abs(b[0]) + abs(b[1]));
  }
};

// The end of a plane Bézier curve as it is drawn: the direction is that of the first difference
// that is not zero. A `Polygon` counts the control points from the node on. It has
// - `is_end`: whether the curve ends at the node, `degree()`, and `are_equal(j, k)` for points j
//   and k;
// - `vector<NT>(j, k)` from point j to point k;
// - `have_one_direction(i, j, k)`, which decides that for the vectors from i to j and from k to k +
//   1, which are not zero.
template <class Polygon_> class Image_end {
  Polygon_ polygon_;
  int first_ = 1; // the first control point from the node on that is not the node

public:
  typedef Polygon_ Polygon;

  explicit Image_end(Polygon polygon) : polygon_(std::move(polygon)) {
    while (first_ <= polygon_.degree() && polygon_.are_equal(first_, 0)) ++first_;
  }

  const Polygon& polygon() const { return polygon_; }
  bool has_length() const { return first_ <= polygon_.degree(); }

  // Returns whether the handle is at the node. \pre has_length()
  bool is_retracted() const { return first_ > 1; }

  // Returns whether all control points lie on the chord in order: the differences that are not zero
  // have one direction.
  // \pre has_length()
  bool is_line() const {
    int i = 0, j = first_; // the last difference that is not zero
    for (int k = first_; k < polygon_.degree(); ++k)
      if (!polygon_.are_equal(k + 1, k)) {
        if (!polygon_.have_one_direction(i, j, k)) return false;
        i = k;
        j = k + 1;
      }
    return true;
  }

  // Returns whether the curvature at the node is given by the second differences, or that of a
  // line. \pre has_length()
  bool has_curvature() const { return !is_retracted() || is_line(); }

  // The points between which the first difference that is not zero lies, in the direction of the
  // curve.
  std::pair<int, int> first_difference() const { return Polygon::is_end ? std::pair(first_, 0) : std::pair(0, first_); }

  // The first difference that is not zero, in the direction of the curve, subtracted in NT. \pre
  // has_length()
  template <class NT> std::array<NT, 2> vector() const {
    const auto [j, k] = first_difference();
    return polygon_.template vector<NT>(j, k);
  }
};

// Decides whether the angle between two directions is larger than the bound, given their products;
// empty when it is zero.
template <class NT> std::optional<bool> exceeds(const Plane_products<NT>& p, const Corner_threshold& bound) {
  if (p.cross == NT(0) && NT(0) < p.dot) return std::nullopt;
  return bound.is_exceeded(p.cross, p.dot);
}

// Returns what a join looks like whose curves meet; empty when one of them has no length. A `Join`
// has the ends `left()` and `right()`, `exceeds(bound)`, which is empty when the angle is zero, and
// `has_one_curvature()`, which is asked where it is and both ends have a curvature.
template <class Join> std::optional<Visual_class> visual_class_of(const Join& join, const Corner_threshold& bound) {
  if (!join.left().has_length() || !join.right().has_length()) return std::nullopt;
  if (const std::optional<bool> corner = join.exceeds(bound))
    return *corner ? Visual_class::corner : Visual_class::kink;
  if (!join.left().has_curvature() || !join.right().has_curvature()) return Visual_class::g1;
  return join.has_one_curvature() ? Visual_class::g2 : Visual_class::g1;
}

// Returns how large a kink is, from both vectors in the direction of the curves, which are not
// zero.
template <class Field> Kink_size kink_size_of(const std::array<Field, 2>& a, const std::array<Field, 2>& b) {
  const Plane_products<Field> ab(a, b);
  const Field aa = Plane_products<Field>(a, a).dot, bb = Plane_products<Field>(b, b).dot, shorter = (std::min)(aa, bb),
              longer = (std::max)(aa, bb), sine_squared = Field(ab.cross * ab.cross);
  const Enclosure angle = angle_enclosure(sine_squared, ab.dot), handle = sqrt_enclosure(shorter);
  const Enclosure offset = Field(0) < ab.dot ? sqrt_enclosure(Field(sine_squared / longer)) : handle;
  return Kink_size{angle, offset, nonnegative_product(angle, handle)};
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_IMAGE_END_H
