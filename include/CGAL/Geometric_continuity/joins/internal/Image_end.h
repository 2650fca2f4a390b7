// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_IMAGE_END_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_IMAGE_END_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The cross and the dot product of two vectors of the plane, and a bound of their terms.
template <class NT> struct Leg_products {
  NT cross, dot, size;

  Leg_products(const std::array<NT, 2>& a, const std::array<NT, 2>& b)
      : cross(NT(a[0] * b[1]) - NT(a[1] * b[0])), dot(NT(a[0] * b[0]) + NT(a[1] * b[1])), size(0) {
    using std::abs;
    if constexpr (std::is_floating_point_v<NT>) size = (abs(a[0]) + abs(a[1])) * (abs(b[0]) + abs(b[1]));
  }
};

// The end of a plane Bézier curve as it is drawn: the direction is that of the first leg that is not zero.
template <class Traits_, int Degree, Curve_end which> class Image_end {
  typedef Bezier_curve<Traits_, Degree> Curve;
  const Curve& curve_;
  int leg_ = 1; // the first control point from the node on that is not the node

public:
  typedef Traits_ Traits;
  typedef Bezier_curve<Traits, 1> Line;

  explicit Image_end(const Curve& curve) : curve_(curve) {
    while (leg_ <= curve.degree() && are_equal(leg_, 0)) ++leg_;
  }

  // \throws Error `not_finite`
  void check_node() const {
    for (int i = 0; i < 2; ++i) check_finite(coordinate(0, i), "join_grade");
  }

  bool has_length() const { return leg_ <= curve_.degree(); }

  // Whether the handle is at the node. \pre has_length()
  bool is_retracted() const { return leg_ > 1; }

  // Whether all control points lie on the chord in order: the legs that are not zero have one direction. \pre has_length()
  bool is_line() const {
    Line leg = line(leg_ - 1, leg_);
    for (int j = leg_; j < curve_.degree(); ++j)
      if (!are_equal(j + 1, j)) {
        const Line next = line(j, j + 1);
        if (!is_g1_join(leg, next)) return false;
        leg = next;
      }
    return true;
  }

  // The first leg that is not zero, as a curve that ends, or starts, at the node.
  Line curve() const { return which == Curve_end::end ? line(leg_, 0) : line(0, leg_); }

  // The same in the direction of the curve, the coordinates subtracted in NT.
  template <class NT> std::array<NT, 2> vector() const {
    const int from = which == Curve_end::end ? leg_ : 0, to = which == Curve_end::end ? 0 : leg_;
    const auto difference = [&](int i) -> NT {
      return NT(to_field<NT>(coordinate(to, i)) - to_field<NT>(coordinate(from, i)));
    };
    return {difference(0), difference(1)};
  }

private:
  const typename Traits::Point& point(int j) const {
    return curve_.control_point(which == Curve_end::end ? curve_.degree() - j : j);
  }
  typename Traits::FT coordinate(int j, int i) const { return Traits().compute_coordinate_object()(point(j), i); }
  bool are_equal(int j, int k) const {
    return coordinate(j, 0) == coordinate(k, 0) && coordinate(j, 1) == coordinate(k, 1);
  }
  Line line(int j, int k) const { return Line({point(j), point(k)}); }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_IMAGE_END_H
