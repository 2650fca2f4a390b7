// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_VISUAL_CLASS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_VISUAL_CLASS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/certified_bounds.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <ostream>
#include <type_traits>

/// \file Visual_class.h
/// The view of a designer on a join in the plane: a corner that is intended, a kink that nobody
/// wants and how large it is, or a smooth join.

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

// The end of a plane Bézier curve as it is drawn: the direction is that of the first side that is
// not zero.
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
    for (int i = 0; i < 2; ++i) check_finite(coordinate(0, i), "visual_class");
  }

  bool has_length() const { return leg_ <= curve_.degree(); }

  // Returns whether the handle is at the node. \pre has_length()
  bool is_retracted() const { return leg_ > 1; }

  // Returns whether all control points lie on the chord in order: the sides that are not zero have
  // one direction. \pre has_length()
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

  // The first side that is not zero, as a curve that ends, or starts, at the node.
  Line curve() const { return which == Curve_end::end ? line(leg_, 0) : line(0, leg_); }

  // Returns the vector in the direction of the curve. The coordinates are subtracted in NT.
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

/// \ingroup PkgGeometricContinuityContinuity
/// The size of a kink, as guaranteed enclosures. With `a` and `b` for the handles at the node, from
/// the control point before it and to the one behind it:
struct Kink_size {
  Enclosure angle; ///< the angle between `a` and `b`, in radians, in \f$ [0, \pi] \f$
  /// By how much a handle is off, in units of the coordinates: how far the tip of one of them must
  /// move at least to make their directions equal, \f$ |a \times b| / \max(|a|, |b|) \f$; from a
  /// right angle on \f$ \min(|a|, |b|) \f$. On a grid, about one unit is rounding.
  Enclosure handle_offset;
  /// The visible size: the angle times the length of the shorter handle, in units of the
  /// coordinates. Compare it to the size of the em or the drawing.
  Enclosure severity;

  /// Writes e.g. `angle [0.0499583, 0.0499584], handle off by 1, severity [0.999166, 0.999167]`.
  friend std::ostream& operator<<(std::ostream& os, const Kink_size& k) {
    return os << "angle " << k.angle << ", handle off by " << k.handle_offset << ", severity " << k.severity;
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns how large the angle at the join between the end of `left` and the start of `right` is,
/// whatever the curvatures; empty when one of the curves has no length. A handle that is retracted
/// is taken as `visual_class()` takes it: by the first side that is not zero. Everything is
/// computed in an exact field from the control points as given and rounded once, outwards. A gap is
/// not seen.
/// \throws Error `not_finite` for an infinite or undefined coordinate
template <class Traits, int Left, int Right>
std::optional<Kink_size> kink_size(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right) {
  static_assert(dimension_v<Traits> == 2, "kinks are those of curves in the plane");
  typedef typename Exact_field<Predicate_FT<Traits>>::type Field;
  const internal::Image_end<Traits, Left, Curve_end::end> x(left);
  const internal::Image_end<Traits, Right, Curve_end::start> y(right);
  if (!x.has_length() || !y.has_length()) return std::nullopt;
  const std::array<Field, 2> a = x.template vector<Field>(), b = y.template vector<Field>();
  const internal::Leg_products<Field> ab(a, b);
  const Field aa = internal::Leg_products<Field>(a, a).dot, bb = internal::Leg_products<Field>(b, b).dot,
              shorter = (std::min)(aa, bb), longer = (std::max)(aa, bb), sine_squared = Field(ab.cross * ab.cross);
  const Enclosure angle = angle_enclosure(sine_squared, ab.dot), handle = sqrt_enclosure(shorter);
  const Enclosure offset = Field(0) < ab.dot ? sqrt_enclosure(Field(sine_squared / longer)) : handle;
  return Kink_size{angle, offset, internal::nonnegative_product(angle, handle)};
}

namespace internal {

inline const Corner_threshold& usual_corner_threshold() {
  static const Corner_threshold bound;
  return bound;
}

// Returns whether the angle between two ends is larger than the bound; empty when it is zero. \pre
// both have a length
template <class Left_end, class Right_end>
std::optional<bool> exceeds(const Left_end& a, const Right_end& b, const Corner_threshold& bound) {
  typedef typename Left_end::Traits Traits;
  if constexpr (is_double<typename Traits::FT>) {
    // Differences, products and sums are rounded by 2^-52 in every rounding mode, once each.
    const Leg_products<double> r(a.template vector<double>(), b.template vector<double>());
    const double error = 0x1p-49 * r.size;
    if (0x1p-800 < r.size && r.size < 0x1p800) {
      if (error < std::abs(r.cross))
        if (const std::optional<bool> answer = bound.is_exceeded(r.cross, r.dot, 2 * error)) return answer;
      if (is_g1_join(a.curve(), b.curve())) return std::nullopt;
    }
  }
  typedef typename Exact_field<Predicate_FT<Traits>>::type Field;
  const Leg_products<Field> p(a.template vector<Field>(), b.template vector<Field>());
  if (p.cross == Field(0) && Field(0) < p.dot) return std::nullopt;
  return bound.is_exceeded(p.cross, p.dot);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns what the join between the end of `left` and the start of `right` looks like; empty when
/// the ends meet and one of the curves has no length, hence no direction. The bound is 5 degrees
/// unless another one is given.
///
/// It is decided exactly on the control points as given, with every kernel, and about the curves as
/// they are drawn:
/// - A curve whose control points lie on its chord, in order, is that line, also where handles are
///   retracted.
/// - Of other curves with a retracted handle, a first side that is zero, the first side that is not
///   zero is the direction in which the curve leaves the node. Such a join is `g1` at most, because
///   the curvature at the node is infinite or not given by the second differences.
///
/// Where no handle is retracted `g1` and `g2` are the answers of `is_g1_join()` and `is_g2_join()`.
/// \f$ O(1) \f$ then, otherwise \f$ O(m) \f$ for the degree `m`
/// \throws Error `not_finite` for an infinite or undefined coordinate that it reads
template <class Traits, int Left, int Right>
std::optional<Visual_class> visual_class(const Bezier_curve<Traits, Left>& left,
                                         const Bezier_curve<Traits, Right>& right,
                                         const Corner_threshold& bound = internal::usual_corner_threshold()) {
  typedef internal::Image_end<Traits, Left, Curve_end::end> Left_end;
  typedef internal::Image_end<Traits, Right, Curve_end::start> Right_end;
  static_assert(dimension_v<Traits> == 2, "grades are those of curves in the plane");
  const Left_end a(left);
  const Right_end b(right);
  if (!is_c_join<0>(left, right)) {
    a.check_node();
    b.check_node();
    return Visual_class::gap;
  }
  if (!a.has_length() || !b.has_length()) return std::nullopt;
  if (const std::optional<bool> corner = internal::exceeds(a, b, bound))
    return *corner ? Visual_class::corner : Visual_class::kink;
  const bool left_line = a.is_retracted() && a.is_line(), right_line = b.is_retracted() && b.is_line();
  // A zero first side is never that of a G2 join.
  const bool curvature_agrees = left_line && right_line ? true
                                : left_line             ? is_g2_join(a.curve(), right)
                                : right_line            ? is_g2_join(left, b.curve())
                                                        : is_g2_join(left, right);
  return curvature_agrees ? Visual_class::g2 : Visual_class::g1;
}

#ifndef CGAL_NO_DEPRECATED_CODE
// Old names, for one release.
template <class... A> CGAL_DEPRECATED auto join_grade(const A&... arguments) { return visual_class(arguments...); }
#endif

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_VISUAL_CLASS_H
