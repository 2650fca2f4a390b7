// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_PATH_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_PATH_CONTINUITY_H

#include <CGAL/Geometric_continuity/curves/Path_segment.h>
#include <CGAL/Geometric_continuity/joins/Visual_class.h>
#include <CGAL/Geometric_continuity/joins/internal/Enclosed_arc.h>
#include <CGAL/Geometric_continuity/joins/internal/Grid_join.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Sqrt_extension.h>

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The decision in a field extended by one or two square roots, without the betas that are not in
// FT.
template <class FT, class Field> Join_continuity<FT> drop_irrational_betas(const Join_continuity<Field>& join) {
  Join_continuity<FT> r;
  r.c_order = join.c_order;
  r.g_order = join.g_order;
  r.f_order = join.f_order;
  r.regular = join.regular;
  r.tangent_equal = join.tangent_equal;
  r.curvature_equal = join.curvature_equal;
  r.curvature_vector_equal = join.curvature_vector_equal;
  return r;
}

// Calls f(p, q) with the roots of the radicands of both segments, in the numbers of the traits
// class or in a field that is extended by one or two roots.
template <class Traits, class Function>
auto visit_roots(const Path_segment<Traits>& left, const Path_segment<Traits>& right, Function f) {
  typedef typename Traits::FT FT;
  const FT d = left.radicand(), e = right.radicand();
  const std::optional<FT> p = rational_square_root(d), q = rational_square_root(e);
  if constexpr (std::is_floating_point_v<FT>)
    return f(*p, *q);
  else {
    if (p && q) return f(*p, *q);
    typedef Sqrt_extension<FT, FT> Field; // a + b sqrt(d)
    // a + b sqrt(e), also when one root lies in the field of the other
    typedef Sqrt_extension<Field, FT> Tower;
    const Tower left_root(p ? Field(*p) : Field(FT(0), FT(1), d));
    const Tower right_root = q ? Tower(Field(*q)) : Tower(Field(FT(0)), Field(FT(1)), e);
    return f(left_root, right_root);
  }
}

// The direction at an end of a segment, of which the root of radicand() is given; zero for a curve
// of no length.
template <Curve_end which, class Traits, class Field>
std::array<Field, 2> path_direction(const Path_segment<Traits>& segment, const Field& root) {
  if (segment.bezier()) {
    typedef Curve_polygon<Traits, dynamic_degree, which> Polygon;
    const Image_end<Polygon> end{Polygon(*segment.bezier())};
    if (!end.has_length()) return {Field(0), Field(0)};
    const auto v = end.template vector<typename Traits::FT>();
    return {Field(v[0]), Field(v[1])};
  }
  const Coordinate_jet<Field, 2> jet = which == Curve_end::end ? segment.template end_jet_over<Field>(1, root)
                                                               : segment.template start_jet_over<Field>(1, root);
  return {jet[1][0], jet[1][1]};
}

// A join with an arc of a rotated ellipse, whose directions are enclosed.
template <class Traits> class Rotated_join {
  typedef typename Traits::FT FT;
  typedef Coordinate_jet<FT, 2> Jet;
  typedef std::array<Exact_range<FT>, 2> Direction;
  static constexpr int first_bits = 128, last_bits = 1024;
  const Path_segment<Traits>&left_, &right_;

  template <Curve_end which> static std::optional<Direction> direction(const Path_segment<Traits>& segment, int bits) {
    if (segment.arc()) return Enclosed_arc<Traits>(*segment.arc()).tangent(which, bits);
    const std::array<FT, 2> v = path_direction<which>(segment, FT(0));
    return Direction{Exact_range<FT>(v[0]), Exact_range<FT>(v[1])};
  }

public:
  Rotated_join(const Path_segment<Traits>& left, const Path_segment<Traits>& right) : left_(left), right_(right) {}

  bool has_directions() const { return left_.has_length() && right_.has_length(); }

  // The jets in coordinates in which they are rational, where there are such.
  std::optional<std::pair<Jet, Jet>> common_jets(int order) const {
    if (!left_.arc() || !right_.arc()) return std::nullopt;
    return Enclosed_arc<Traits>(*left_.arc()).common_jets(Enclosed_arc<Traits>(*right_.arc()), order);
  }

  // Calls f(products) with narrower and narrower enclosures, until it returns true. Returns false
  // when it never does. \pre has_directions()
  template <class Function> bool until(Function f) const {
    for (int bits = first_bits; bits <= last_bits; bits *= 2) {
      const std::optional<Direction> a = direction<Curve_end::end>(left_, bits),
                                     b = direction<Curve_end::start>(right_, bits);
      if (!a || !b) continue;
      const Direction &x = *a, &y = *b;
      if (f(Enclosed_products<FT>{x[0] * y[1] - x[1] * y[0], x[0] * y[0] + x[1] * y[1]})) return true;
    }
    return false;
  }

  // The decision, if it can be made.
  std::optional<Join_continuity<FT>> continuity(int max_order) const {
    if (const auto jets = common_jets((std::max)(max_order, 3)))
      return Join_decision<FT, 2>(jets->first, jets->second, max_order)();
    Join_continuity<FT> join;
    join.c_order = join.g_order = join.f_order = left_.end() == right_.start() ? 0 : -1;
    join.regular = !starts_with_zero(left_, true) && !starts_with_zero(right_, false);
    if (!join.regular) return join;
    join.tangent_equal = false;
    if (!until([](const Enclosed_products<FT>& p) { return p.differ(); })) return std::nullopt;
    return join;
  }

private:
  // Returns whether the first derivative at an end is zero.
  static bool starts_with_zero(const Path_segment<Traits>& segment, bool at_end) {
    if (segment.arc()) return false;
    const Bezier_curve<Traits>& b = *segment.bezier();
    return b.control_point(at_end ? b.degree() : 0) == b.control_point(at_end ? b.degree() - 1 : 1);
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// The join between the end of a segment of a path and the start of another one, for
/// `continuity()`, `visual_class()` and `visit_enclosures()`: what these have in common is prepared
/// once. The segments must outlive it.
/// \tparam Traits a model of `GeometricContinuityTraits` of dimension 2
template <class Traits> class Path_join {
  const Path_segment<Traits>&left_, &right_;
  internal::Grid_join<2> grid_; // of Bezier curves whose coordinates are short rational numbers
  bool has_grid_ = false;
  mutable std::optional<std::pair<internal::Grid_join<2>::Jet, internal::Grid_join<2>::Jet>>
      jets_; // enclosures, once asked for

  template <class T> friend std::optional<Join_continuity<typename T::FT>> continuity(const Path_join<T>&, int);
  template <class T, class Function> friend bool visit_enclosures(const Path_join<T>&, Function);
  template <class T> friend std::optional<Visual_class> visual_class(const Path_join<T>&, const Corner_threshold&);

public:
  /// Prepares the join.
  Path_join(const Path_segment<Traits>& left, const Path_segment<Traits>& right) : left_(left), right_(right) {
    if constexpr (internal::Rational_parts<typename Traits::FT>::value)
      has_grid_ = left.bezier() && right.bezier() && grid_.set_rationals(*left.bezier(), *right.bezier());
  }

  /// Returns the segment that ends at the join.
  const Path_segment<Traits>& left() const { return left_; }
  /// Returns the segment that starts at the join.
  const Path_segment<Traits>& right() const { return right_; }
};

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of a join of segments of paths, up to order `max_order`; empty when it
/// cannot be decided.
///
/// Arcs are taken with respect to the eccentric angle; only the C order and the shape parameters
/// depend on that. Where the centre of an arc is not rational, the decision is made in the field
/// extended by its square root, exactly, and no shape parameters are given. In `double` it is plain
/// floating point.
///
/// The directions of an arc of a rotated ellipse, which are not known as numbers of such a field,
/// are enclosed, with 128 bits and more, until they differ from those of the other segment. They
/// are equal where both segments are halves of such an ellipse, or of a larger one, or are parts of
/// equal angle on different sides of their chords, and the chords are parallel: that is decided
/// exactly, for all orders. Where 1024 bits do not tell, nothing is decided: `tangent_angle()`
/// tells by how little the directions differ, if they do.
/// \throws Error `negative_count` for a negative `max_order`, `work_limit`
template <class Traits>
std::optional<Join_continuity<typename Traits::FT>> continuity(const Path_join<Traits>& path_join, int max_order) {
  typedef typename Traits::FT FT;
  const Path_segment<Traits>&left = path_join.left(), &right = path_join.right();
  if constexpr (!std::is_floating_point_v<FT>)
    if (!left.is_known() || !right.is_known()) {
      if (max_order < 0) throw Error(Error_code::negative_count, "continuity: order");
      return internal::Rotated_join<Traits>(left, right).continuity(max_order);
    }
  if (path_join.has_grid_ && 0 <= max_order && max_order <= 3) {
    Join_continuity<FT> join;
    if (path_join.grid_.decide(max_order, join, internal::Join_asked::all)) return join;
  }
  const int order = (std::max)(max_order, 3); // curvature is reported for every max_order
  const auto decide = [&](const auto& left_root, const auto& right_root) {
    typedef std::decay_t<decltype(left_root)> Field;
    const Coordinate_jet<Field, 2> x = left.template end_jet_over<Field>(order, left_root),
                                   y = right.template start_jet_over<Field>(order, right_root);
    const Join_continuity<Field> join = internal::Join_decision<Field, 2>(x, y, max_order)();
    if constexpr (std::is_same_v<Field, FT>)
      return join;
    else
      return internal::drop_irrational_betas<FT>(join);
  };
  return internal::visit_roots(left, right, decide);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of the join between the end of `left` and the start of `right`.
template <class Traits>
std::optional<Join_continuity<typename Traits::FT>> continuity(const Path_segment<Traits>& left,
                                                               const Path_segment<Traits>& right, int max_order = 3) {
  return continuity(Path_join<Traits>(left, right), max_order);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Calls `f(x, y)` with enclosures of the jets of order 3 at the end of the left segment and at the
/// start of the right one, with respect to parameters of the domain [0, 1] each: `Coordinate_jet`s
/// of `Interval_nt<false>`, with which `f` can compute. Returns false, without a call, unless both
/// are Bézier curves whose coordinates are short rational numbers, over domains whose ends are
/// short integers.
template <class Traits, class Function> bool visit_enclosures(const Path_join<Traits>& join, Function f) {
  if (!join.has_grid_) return false;
  const Protect_FPU_rounding<true> rounding_upwards;
  if (!join.jets_) join.jets_ = join.grid_.enclosed_jets();
  f(join.jets_->first, join.jets_->second);
  return true;
}

namespace internal {

// Calls f(p) with the products of the directions at a join, in a field of exact numbers; returns
// whether both have a direction.
// \pre both are known
template <class Traits, class Function>
bool visit_direction_products(const Path_segment<Traits>& left, const Path_segment<Traits>& right, Function f) {
  return visit_roots(left, right, [&](const auto& left_root, const auto& right_root) -> bool {
    typedef std::decay_t<decltype(left_root)> Field;
    const std::array<Field, 2> a = path_direction<Curve_end::end>(left, left_root),
                               b = path_direction<Curve_end::start>(right, right_root);
    for (const std::array<Field, 2>& v : {a, b})
      if (v[0] == Field(0) && v[1] == Field(0)) return false;
    f(Plane_products<Field>(a, b));
    return true;
  });
}

// The angle with these products. With square roots, the tangent or cotangent that is at most 1 is
// enclosed before it is squared: the roots in its square would cancel, and leave the more of an
// error the smaller it is.
template <class FT, class Field> Enclosure angle_of_products(const Plane_products<Field>& p) {
  if constexpr (std::is_same_v<FT, Field>)
    return angle_enclosure(FT(p.cross * p.cross), p.dot);
  else {
    const Field zero(0), c = p.cross < zero ? Field(-p.cross) : p.cross, d = p.dot < zero ? Field(-p.dot) : p.dot;
    const bool steep = d < c;
    const Enclosure q = enclosure(steep ? Field(d / c) : Field(c / d));
    const auto angle = [&](double x) -> Enclosure {
      const FT one(1), t((std::max)(x, 0.)), cosine = steep ? t : one;
      return angle_enclosure(steep ? one : FT(t * t), p.dot < zero ? FT(-cosine) : cosine);
    };
    const Enclosure first = angle(q.lower), second = angle(q.upper);
    return {(std::min)(first.lower, second.lower), (std::max)(first.upper, second.upper)};
  }
}

// The grade of a join with an arc of a rotated ellipse, if it can be decided.
template <class Traits>
std::optional<Visual_class> rotated_visual_class(const Path_segment<Traits>& left, const Path_segment<Traits>& right,
                                                 const Corner_threshold& bound) {
  const Rotated_join<Traits> join(left, right);
  if (!join.has_directions()) return std::nullopt;
  if (left.end() != right.start()) return Visual_class::gap;
  if (join.common_jets(2)) {
    const auto decision = join.continuity(2);
    return decision->g_order >= 2 ? Visual_class::g2 : decision->g_order == 1 ? Visual_class::g1 : Visual_class::corner;
  }
  std::optional<bool> corner;
  join.until([&](const auto& p) {
    if (p.differ()) corner = p.exceed(bound);
    return corner.has_value();
  });
  return corner ? std::optional<Visual_class>(*corner ? Visual_class::corner : Visual_class::kink) : std::nullopt;
}

// The angle at a join with an arc of a rotated ellipse, with at least 48 bits unless it is too
// small. \pre both have a length
template <class Traits>
Enclosure rotated_join_angle(const Path_segment<Traits>& left, const Path_segment<Traits>& right) {
  typedef typename Traits::FT FT;
  const Rotated_join<Traits> join(left, right);
  if (const auto jets = join.common_jets(1)) return angle_enclosure(FT(0), FT(jets->first[1][1] * jets->second[1][1]));
  Enclosure angle{0, 4};
  join.until([&](const auto& p) {
    angle = p.angle();
    return angle.upper - angle.lower <= 0x1p-48 * angle.upper;
  });
  return angle;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns what a join of segments of paths looks like, see `visual_class()` of Bézier curves;
/// empty when one of them has no length, and where `continuity()` does not decide. Directions of
/// arcs are compared in the field of their square roots, or enclosed. Exact, except in `double`
/// \throws Error `not_finite`, `work_limit`
template <class Traits>
std::optional<Visual_class> visual_class(const Path_join<Traits>& join,
                                         const Corner_threshold& bound = internal::usual_corner_threshold()) {
  const Path_segment<Traits>&left = join.left(), &right = join.right();
  std::optional<bool> corner;
  if (left.bezier() && right.bezier()) {
    // The first derivatives are multiples of the handles, or zero.
    visit_enclosures(join, [&](const auto& x, const auto& y) {
      const auto c = x[1][0] * y[1][1] - x[1][1] * y[1][0], d = x[1][0] * y[1][0] + x[1][1] * y[1][1];
      if (0 < c.inf() || c.sup() < 0)
        corner = bound.is_exceeded(c.inf(), d.inf(), (c.sup() - c.inf()) + (d.sup() - d.inf()));
    });
    if (corner && join.grid_.ends_meet()) return *corner ? Visual_class::corner : Visual_class::kink;
    return visual_class(*left.bezier(), *right.bezier(), bound);
  }
  if constexpr (!std::is_floating_point_v<typename Traits::FT>)
    if (!left.is_known() || !right.is_known()) return internal::rotated_visual_class(left, right, bound);
  const bool directed = internal::visit_direction_products(left, right, [&](const auto& p) {
    typedef std::decay_t<decltype(p.dot)> Field;
    if (p.cross != Field(0) || p.dot < Field(0)) corner = bound.is_exceeded(p.cross, p.dot);
  });
  if (!directed) return std::nullopt;
  if (left.end() != right.start()) return Visual_class::gap;
  if (corner) return *corner ? Visual_class::corner : Visual_class::kink;
  // Readers of paths make lines of cubics that are drawn as lines, so that a handle that is
  // retracted here is one that bends. equivalent [2 -> 3, 1]: deciding the order 3 as well changes
  // nothing below it
  return continuity(join, 2)->g_order >= 2 ? Visual_class::g2 : Visual_class::g1;
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns what the join between the end of `left` and the start of `right` looks like.
template <class Traits>
std::optional<Visual_class> visual_class(const Path_segment<Traits>& left, const Path_segment<Traits>& right,
                                         const Corner_threshold& bound = internal::usual_corner_threshold()) {
  return visual_class(Path_join<Traits>(left, right), bound);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns the angle in \f$ [0, \pi] \f$ between the directions in which the segments are drawn, in
/// radians; empty when one of them has no length. A retracted handle is taken as `visual_class()`
/// takes it.
/// \throws Error `not_finite`
template <class Traits>
std::optional<Enclosure> tangent_angle(const Path_segment<Traits>& left, const Path_segment<Traits>& right) {
  std::optional<Enclosure> angle;
  if constexpr (!std::is_floating_point_v<typename Traits::FT>)
    if (!left.is_known() || !right.is_known()) {
      if (left.has_length() && right.has_length()) angle = internal::rotated_join_angle(left, right);
      return angle;
    }
  internal::visit_direction_products(
      left, right, [&](const auto& p) { angle = internal::angle_of_products<typename Traits::FT>(p); });
  return angle;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_PATH_CONTINUITY_H
