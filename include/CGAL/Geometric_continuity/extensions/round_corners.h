// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_ROUND_CORNERS_H
#define CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_ROUND_CORNERS_H

#include <CGAL/Geometric_continuity/curves/internal/curve_pieces.h>
#include <CGAL/Geometric_continuity/curves/piecewise_cubics.h>
#include <CGAL/Geometric_continuity/extensions/round_corner.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/joins/knot_continuity.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

/// \file round_corners.h
/// All corners of a chain of curves, or of a closed outline, are rounded as `round_corner()` rounds one.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// Where a corner of a chain was, and what has become of it.
template <class FT> struct Rounded_join {
  std::size_t join;  ///< the corner is the join after this Bézier curve of the given chain, counted from 0 on
  double distance;   ///< from the corner to both cuts, along the curves
  FT left_cut;       ///< the parameter where the curve before the corner is cut
  FT right_cut;      ///< the parameter where the curve after the corner is cut
  std::size_t blend; ///< the number of the blend in the rounded chain
};

/// \ingroup PkgGeometricContinuityConstruction
/// A chain of curves whose corners are rounded.
/// \tparam Curve `Bezier_curve<Traits>`, or `Rational_bezier_curve<Traits>` if the given curves are rational
template <class Curve> struct Rounded_chain {
  std::vector<Curve> curves;                             ///< the chain: curves, or parts of them, and blends
  std::vector<Rounded_join<typename Curve::FT>> corners; ///< the corners that were rounded, in their order
};

namespace internal {

// The curve between two parameters, each of which may be an end of it.
template <class Curve>
Curve part_between(const Curve& curve, const typename Curve::FT& a, const typename Curve::FT& b) {
  const Curve before = b < curve.domain().second ? curve.split(b).first : curve;
  return curve.domain().first < a ? before.split(a).second : before;
}

// The continuity at the joins of the Bezier curves that a curve is made of, decided on the curve as it is given.
template <class Traits, int Degree>
std::vector<Join_continuity<Predicate_FT<Traits>>> inner_joins(const Bezier_curve<Traits, Degree>&, int) {
  return {};
}
template <class Traits, int Degree>
std::vector<Join_continuity<Predicate_FT<Traits>>> inner_joins(const Composite_bezier_curve<Traits, Degree>& curve,
                                                               int order) {
  std::vector<Join_continuity<Predicate_FT<Traits>>> joins;
  for (int l = 0; l + 1 < curve.number_of_segments(); ++l)
    joins.push_back(continuity(curve.segment(l), curve.segment(l + 1), order));
  return joins;
}
template <class Spline>
std::vector<Join_continuity<Predicate_FT<typename Spline::Traits>>> joins_at_knots(const Spline& curve, int order) {
  std::vector<Join_continuity<Predicate_FT<typename Spline::Traits>>> joins;
  for (const auto& k : knot_continuities(curve, order)) joins.push_back(k.join);
  return joins;
}
template <class Traits> auto inner_joins(const Bspline_curve<Traits>& curve, int order) {
  return joins_at_knots(curve, order);
}
template <class Traits> auto inner_joins(const Rational_bspline_curve<Traits>& curve, int order) {
  return joins_at_knots(curve, order);
}
template <class Traits, int Degree>
std::vector<Join_continuity<Predicate_FT<Traits>>> inner_joins(const Rational_bezier_curve<Traits, Degree>&, int) {
  return {};
}

// The Bezier curves that a curve is made of; of a rational curve whatever its weights are.
template <class Curve>
using Bezier_piece = std::conditional_t<Is_rational<Curve>::value, Rational_bezier_curve<typename Curve::Traits>,
                                        Bezier_curve<typename Curve::Traits>>;
template <class Curve> void add_bezier_pieces(const Curve& curve, std::vector<Bezier_piece<Curve>>& pieces) {
  for_each_piece(curve, [&](const auto& piece) { pieces.emplace_back(piece); });
}
template <class Traits, int Degree>
void add_bezier_pieces(const Rational_bezier_curve<Traits, Degree>& curve,
                       std::vector<Rational_bezier_curve<Traits>>& pieces) {
  pieces.emplace_back(curve);
}
template <class Traits>
void add_bezier_pieces(const Rational_bspline_curve<Traits>& curve,
                       std::vector<Rational_bezier_curve<Traits>>& pieces) {
  for (const Rational_bezier_curve<Traits>& piece : curve.bezier_pieces()) pieces.push_back(piece);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Rounds the corners of a chain of curves, each of which starts where the one before it ends. Segmented curves and B-splines
/// are chains of Bézier curves themselves, and their inner joins and knots are joins like all others. Corners are the joins
/// whose \f$ G \f$ order is less than `order`: with 1 kinks and cusps, with 2 jumps of the curvature too. All other joins,
/// and the control points of Bézier curves without corners, stay as they are.
///
/// A corner is cut off at `distance` on both sides, as `round_corner()` does, or nearer, so that a quarter of each curve
/// remains: at most at 3/4 of the length of a Bézier curve with one corner, and at 3/8 of the length of one with two. Both cuts of
/// a corner have the same distance.
///
/// One call of `continuity()` or `knot_continuity()` for each join, and what `round_corner()` takes for each corner.
///
/// \param first,last the curves, of type `Bezier_curve`, `Composite_bezier_curve`, `Bspline_curve`, `Rational_bezier_curve` or
///   `Rational_bspline_curve`
/// \param distance positive
/// \param closure whether the end of the last curve and the start of the first are a join too, which may be a corner
/// \param order the \f$ G \f$ order that joins need in order to stay
/// \param strategy a model of `BlendStrategy` that is called without shape parameters
/// \throws Error `negative_count` for a negative order, `not_finite` when the distance, or a curve as numbers of type
///   `double`, is infinite or undefined
/// \throws Error `curves_do_not_meet` when there is a gap, with the number of the Bézier curve before it
/// \throws Error `parameter_outside_domain` when the distance is not positive, or a curve at a corner has length zero
/// \throws Error `zero_tangent`, `zero_direction`, `dimension_mismatch`, `not_representable` as `round_corner()` does
template <class ForwardIterator, class Strategy = Fair>
Rounded_chain<internal::Bezier_piece<typename std::iterator_traits<ForwardIterator>::value_type>>
round_corners(ForwardIterator first, ForwardIterator last, double distance, Closure closure, int order = 2,
              const Strategy& strategy = Strategy()) {
  typedef internal::Bezier_piece<typename std::iterator_traits<ForwardIterator>::value_type> Curve;
  typedef typename Curve::FT FT;
  const bool closed = closure == Closure::closed;
  internal::check_distance(distance, "round_corners");
  internal::check_count(order, "round_corners: order");
  const auto place = [](std::size_t i) { return "round_corners: join after curve " + std::to_string(i); };

  std::vector<Curve> given;
  std::vector<bool> is_corner; // the join after the curve
  const auto add_join = [&](const auto& join) {
    if (join.c_order < 0) throw Error(Error_code::curves_do_not_meet, place(is_corner.size()));
    is_corner.push_back(join.g_order < order);
  };
  for (ForwardIterator c = first; c != last; ++c) {
    internal::add_bezier_pieces(*c, given);
    for (const auto& join : internal::inner_joins(*c, order)) add_join(join);
    const ForwardIterator next = std::next(c);
    if (next != last)
      add_join(continuity(*c, *next, order));
    else if (closed)
      add_join(continuity(*c, *first, order));
    else
      is_corner.push_back(false);
  }
  const std::size_t n = given.size();
  const auto longest = [&](std::size_t i) { // distance of a corner from its cut on this curve
    const double length = internal::Measured_polygon<Curve::N>(given[i], Curve_end::start).length();
    return (is_corner[i] && is_corner[(i + n - 1) % n] ? 0.375 : 0.75) * length;
  };

  Rounded_chain<Curve> result;
  std::vector<FT> starts, ends; // of what remains of the curves
  for (const Curve& c : given) {
    starts.push_back(c.domain().first);
    ends.push_back(c.domain().second);
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_corner[i]) continue;
    const std::size_t next = (i + 1) % n;
    const double d = (std::min)({distance, longest(i), longest(next)});
    ends[i] = internal::cut_parameter(given[i], Curve_end::end, d, place(i));
    starts[next] = internal::cut_parameter(given[next], Curve_end::start, d, place(i));
    result.corners.push_back({i, d, ends[i], starts[next], 0});
  }

  std::vector<Curve> parts;
  for (std::size_t i = 0; i < n; ++i) parts.push_back(internal::part_between(given[i], starts[i], ends[i]));
  auto corner = result.corners.begin();
  for (std::size_t i = 0; i < n; ++i) {
    result.curves.push_back(parts[i]);
    if (!is_corner[i]) continue;
    corner->blend = result.curves.size();
    ++corner;
    result.curves.push_back(internal::blend_of_parts(parts[i], parts[(i + 1) % n], strategy, place(i)));
  }
  return result;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_ROUND_CORNERS_H
