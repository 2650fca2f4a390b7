// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_VISUAL_CLASS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_VISUAL_CLASS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>
#include <CGAL/Geometric_continuity/joins/internal/Image_end.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <array>
#include <cmath>
#include <optional>

/// \file Visual_class.h
/// The view of a designer on a join in the plane: a corner that is intended, a kink that nobody
/// wants and how large it is, or a smooth join.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The control points of a plane Bézier curve, counted from the node at one of its ends on.
template <class Traits_, int Degree, Curve_end which> class Curve_polygon {
  typedef Bezier_curve<Traits_, Degree> Curve;
  const Curve& curve_;

public:
  typedef Traits_ Traits;
  typedef Bezier_curve<Traits, 1> Line;
  static constexpr bool is_end = which == Curve_end::end;

  explicit Curve_polygon(const Curve& curve) : curve_(curve) {}

  const Curve& curve() const { return curve_; }
  int degree() const { return curve_.degree(); }

  // \throws Error `not_finite`
  void check_node() const {
    for (int i = 0; i < 2; ++i) check_finite(coordinate(0, i), "visual_class");
  }
  bool are_equal(int j, int k) const {
    return coordinate(j, 0) == coordinate(k, 0) && coordinate(j, 1) == coordinate(k, 1);
  }
  bool have_one_direction(int i, int j, int k) const { return is_g1_join(line(i, j), line(k, k + 1)); }
  Line line(int j, int k) const { return Line({point(j), point(k)}); }
  template <class NT> std::array<NT, 2> vector(int j, int k) const {
    const auto difference = [&](int i) -> NT {
      return NT(to_field<NT>(coordinate(k, i)) - to_field<NT>(coordinate(j, i)));
    };
    return {difference(0), difference(1)};
  }

private:
  const typename Traits::Point& point(int j) const { return curve_.control_point(is_end ? curve_.degree() - j : j); }
  typename Traits::FT coordinate(int j, int i) const { return Traits().compute_coordinate_object()(point(j), i); }
};

// The join between the end of a plane Bézier curve and the start of another one, as both are drawn.
template <class Traits, int Left, int Right> class Image_join {
  typedef typename Exact_field<Predicate_FT<Traits>>::type Field;
  const Image_end<Curve_polygon<Traits, Left, Curve_end::end>> left_;
  const Image_end<Curve_polygon<Traits, Right, Curve_end::start>> right_;

  // The first difference of an end that is not zero, as a curve.
  template <class End> static typename End::Polygon::Line line(const End& end) {
    const auto [j, k] = end.first_difference();
    return end.polygon().line(j, k);
  }
  template <class NT> Plane_products<NT> products() const {
    return {left_.template vector<NT>(), right_.template vector<NT>()};
  }

public:
  Image_join(const Bezier_curve<Traits, Left>& left, const Bezier_curve<Traits, Right>& right)
      : left_(Curve_polygon<Traits, Left, Curve_end::end>(left)),
        right_(Curve_polygon<Traits, Right, Curve_end::start>(right)) {}

  const auto& left() const { return left_; }
  const auto& right() const { return right_; }

  // Returns whether the angle is larger than the bound; empty when it is zero. \pre both ends have
  // a length
  std::optional<bool> exceeds(const Corner_threshold& bound) const {
    if constexpr (is_double<typename Traits::FT>) {
      // Differences, products and sums are rounded by 2^-52 in every rounding mode, once each.
      const Plane_products<double> r = products<double>();
      // equivalent [* -> +, 1]: a larger bound leaves more to the exact decision
      const double error = 0x1p-49 * r.size;
      if (0x1p-800 < r.size && r.size < 0x1p800) {
        if (error < std::abs(r.cross))
          if (const std::optional<bool> answer = bound.is_exceeded(r.cross, r.dot, 2 * error)) return answer;
        if (is_g1_join(line(left_), line(right_))) return std::nullopt;
      }
    }
    return internal::exceeds(products<Field>(), bound);
  }

  // Returns whether the curvatures agree. \pre there is one tangent, and retracted ends are lines
  bool has_one_curvature() const {
    const auto &left = left_.polygon().curve(), &right = right_.polygon().curve();
    return left_.is_retracted() ? right_.is_retracted() || is_g2_join(line(left_), right)
                                : (right_.is_retracted() ? is_g2_join(left, line(right_)) : is_g2_join(left, right));
  }

  // \pre both ends have a length
  Kink_size kink_size() const { return kink_size_of(left_.template vector<Field>(), right_.template vector<Field>()); }
};

inline const Corner_threshold& usual_corner_threshold() {
  static const Corner_threshold bound;
  return bound;
}

} // namespace internal

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
  const internal::Image_join<Traits, Left, Right> join(left, right);
  if (!join.left().has_length() || !join.right().has_length()) return std::nullopt;
  return join.kink_size();
}

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
  static_assert(dimension_v<Traits> == 2, "grades are those of curves in the plane");
  const internal::Image_join<Traits, Left, Right> join(left, right);
  if (is_c_join<0>(left, right)) return internal::visual_class_of(join, bound);
  join.left().polygon().check_node();
  join.right().polygon().check_node();
  return Visual_class::gap;
}

#ifndef CGAL_NO_DEPRECATED_CODE
// Old names, for one release.
template <class... A> CGAL_DEPRECATED auto join_grade(const A&... arguments) { return visual_class(arguments...); }
#endif

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_VISUAL_CLASS_H
