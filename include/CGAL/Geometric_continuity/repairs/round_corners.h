// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_REPAIRS_ROUND_CORNERS_H
#define CGAL_GEOMETRIC_CONTINUITY_REPAIRS_ROUND_CORNERS_H

#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Cubic_blended_curve.h>
#include <CGAL/Geometric_continuity/curves/internal/curve_pieces.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/repairs/internal/Corner_side.h>
#include <CGAL/Geometric_continuity/repairs/internal/Cubic_blend.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file round_corners.h
/// A corner in which two curves meet is cut off at a given distance on both sides, and a blend is
/// put in its place: one corner, or all corners of a chain of curves or of a closed outline. The
/// blend is a quintic, or made of the cubics that drawings and fonts can hold.

namespace CGAL {

template <class Kernel, class Container> class Polygon_2;

namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityExtensions
/// Blends two ends by cubics, with \f$ G^2 \f$ joins; given to `round_corner()` and
/// `round_corners()` in place of a `BlendStrategy`.
///
/// Two straight ends whose tangents meet, as in the corner of two lines, are joined by one cubic,
/// both of whose handles lie in that point, in any dimension. All others, which must be in the
/// plane, are joined by two cubics that are \f$ G^2 \f$ where they meet, too; their curvature
/// varies little. Only field operations construct them, so that the joins are exact with an exact
/// kernel. Floating-point numbers are rounded once, in the end.
struct Cubics {
  /// whether one cubic is taken where there is one; two of them are fuller
  bool single = true;
};

namespace internal {

template <class Left, class Right>
Composite_bezier_curve<typename Left::Traits> blend_by_cubics(const Left& phi, const Right& psi, const Cubics& cubics,
                                                              const std::string& place) {
  typedef typename Left::Traits Traits;
  typedef typename Traits::FT FT;
  typedef typename Exact_field<FT>::type Field;
  if (phi.dimension() != psi.dimension()) throw Error(Error_code::dimension_mismatch, place);
  const auto x = end_jet<Field>(phi, 2), y = start_jet<Field>(psi, 2);
  if (is_zero(x[1])) throw Error(Error_code::zero_tangent, place + ": end of the left curve");
  if (is_zero(y[1])) throw Error(Error_code::zero_tangent, place + ": start of the right curve");
  const Cubic_blend<Field, dimension_v<Traits>> result(x, y, cubics.single, place);
  const auto number = [](const Field& z) -> FT {
    if constexpr (std::is_floating_point_v<FT>)
      return CGAL::to_double(z);
    else
      return FT(z);
  };
  std::vector<typename Traits::Point> points;
  for (const auto& p : result.points) {
    Coordinates<Traits> c(p.dimension());
    for (int i = 0; i < p.dimension(); ++i) c[i] = number(p[i]);
    points.push_back(to_point<Traits>(c));
  }
  std::vector<FT> knots = {FT(0), FT(1)};
  if (points.size() > 4) knots.push_back(number(Field(Field(1) + result.ratio)));
  return {points.begin(), points.end(), knots};
}

} // namespace internal

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the blend by cubics from the end of the curve `phi` to the start of the curve `psi`: a
/// curve of one or two segments, the first over [0, 1]. Some thousand evaluations of floating-point
/// formulas search for two cubics; besides them the number of field operations is constant.
/// \tparam Left, Right models of `ParametricCurve` with one traits class
/// \throws Error `dimension_mismatch` when the dimensions differ, and in space unless one cubic is
///   enough; `zero_tangent` when a first derivative is zero; `zero_direction` when both ends lie in
///   one point
/// \throws Error `not_representable` when no two cubics are found that do not turn back, as where
///   `psi` starts behind the end of `phi`
template <class Left, class Right>
Composite_bezier_curve<typename Left::Traits> blend(const Left& phi, const Right& psi, const Cubics& cubics) {
  return internal::blend_by_cubics(phi, psi, cubics, "blend by cubics");
}

/// \ingroup PkgGeometricContinuityExtensions
/// A rounded corner: three curves, one after the other.
/// \tparam Left, Right `Bezier_curve` or `Rational_bezier_curve`, as given \tparam Blend what
///   `blend()` returns for the strategy
template <class Left, class Right, class Blend> struct Rounded_corner {
  typedef typename Left::FT FT; ///< the field

  Left left;    ///< the left curve from its start to `left_cut`
  Blend blend;  ///< the blend between the cuts
  Right right;  ///< the right curve from `right_cut` to its end
  FT left_cut;  ///< the parameter of the left curve where it is cut
  FT right_cut; ///< the parameter of the right curve where it is cut
};

namespace internal {

// The parameter at the given distance from an end of a curve, which is longer than this.
template <class Curve>
typename Curve::FT cut_parameter(const Curve& curve, Curve_end end, const typename Curve::FT& distance,
                                 const std::string& place) {
  const Corner_side<Curve> side(curve, end);
  if (!(distance < side.length())) {
    std::ostringstream reason;
    reason << place << ": the distance " << CGAL::to_double(distance) << " is not less than the length "
           << CGAL::to_double(side.length()) << " of the " << (end == Curve_end::end ? "left" : "right") << " curve";
    throw Error(Error_code::parameter_outside_domain, reason.str());
  }
  return side.parameter_at(distance);
}

template <class FT> void check_distance(const FT& distance, const std::string& place) {
  const double rounded = CGAL::to_double(distance);
  if (!std::isfinite(rounded)) throw Error(Error_code::not_finite, place + ": distance");
  if (rounded < (std::numeric_limits<double>::min)())
    throw Error(Error_code::parameter_outside_domain, place + ": the distance is not positive");
}

// Returns whether two curves with opposite tangents end and start on one line, as far as a blend
// reads them.
template <class Field, class Left, class Right> bool turn_back(const Left& left, const Right& right, int order) {
  typedef Coordinate_vector<Field, Left::N> Vector;
  const Coordinate_jet<Field, Left::N> phi = end_jet<Field>(left, order), psi = start_jet<Field>(right, order);
  const Field square = dot(phi[1], phi[1]);
  const auto is_along = [&](const Vector& v) { return square * v == dot(v, phi[1]) * phi[1]; };
  bool on_line = dot(phi[1], psi[1]) < Field(0) && is_along(psi[0] - phi[0]);
  for (int k = 1; k <= order && on_line; ++k) on_line = is_along(phi[k]) && is_along(psi[k]);
  return on_line;
}

// Returns the curve at the speed 1 where it has this first derivative, if its speed there is
// rational. A strategy may round, and then the blend of two lines would depend on how fast they are
// run through.
template <class Curve, class Vector> Curve at_unit_speed(const Curve& curve, const Vector& derivative) {
  typedef typename Curve::FT FT;
  if constexpr (has_rational_roots<FT>())
    if (const std::optional<FT> speed = rational_square_root(FT(dot(derivative, derivative)))) {
      const std::pair<FT, FT> domain = curve.domain();
      return curve.with_domain(FT(domain.first * *speed), FT(domain.second * *speed));
    }
  return curve;
}

// The blend from the end of one part to the start of the next one.
template <class Left, class Right, class Strategy>
auto blend_of_parts(const Left& left, const Right& right, const Strategy& strategy, const std::string& place) {
  typedef typename Left::Traits Traits;
  typedef typename Left::FT FT;
  const auto incoming = end_jet<FT>(left, 1)[1], outgoing = start_jet<FT>(right, 1)[1];
  if (is_zero(incoming)) throw Error(Error_code::zero_tangent, place + ": at the cut of the left curve");
  if (is_zero(outgoing)) throw Error(Error_code::zero_tangent, place + ": at the cut of the right curve");
  constexpr bool has_order_2 = std::is_same_v<Strategy, Cubics> || is_quintic_strategy_v<Strategy, Traits>;
  if (turn_back<typename Exact_field<FT>::type>(left, right, has_order_2 ? 2 : 3))
    throw Error(Error_code::zero_tangent, place + ": the curves turn back on one line, where every blend has a cusp");
  if (left.coordinates(left.degree()) == right.coordinates(0))
    throw Error(Error_code::zero_direction, place + ": both cuts lie in one point");
  if constexpr (std::is_same_v<Strategy, Cubics>)
    return blend_by_cubics(at_unit_speed(left, incoming), at_unit_speed(right, outgoing), strategy, place);
  else
    return blend(at_unit_speed(left, incoming), at_unit_speed(right, outgoing), strategy);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityExtensions
/// Returns how far from the corner of two curves, of which the tangents turn by \f$ \theta \f$, a
/// circle of the given radius touches both tangents: \f$ r \tan(\theta/2) \f$. It is exact where
/// the kernel is and the tangent of half the angle is rational, and rounded otherwise.
/// \throws Error `zero_tangent` when a first derivative is zero at the corner, and when the curves
///   turn back; `dimension_mismatch`
template <class Left, class Right>
typename Left::FT corner_distance(const Left& left, const Right& right,
                                  const internal::Convertible_number<typename Left::FT>& radius) {
  typedef typename Left::FT FT;
  if (left.dimension() != right.dimension()) throw Error(Error_code::dimension_mismatch, "corner_distance");
  const auto u = end_jet<FT>(left, 1)[1], v = start_jet<FT>(right, 1)[1];
  if (is_zero(u)) throw Error(Error_code::zero_tangent, "corner_distance: end of the left curve");
  if (is_zero(v)) throw Error(Error_code::zero_tangent, "corner_distance: start of the right curve");
  // with s = |u| |v| and c = u . v: tan^2(theta/2) = (s - c) / (s + c)
  const FT c = dot(u, v), square = FT(dot(u, u) * dot(v, v)), sine_squared = FT(square - c * c);
  if (c < FT(0) && sine_squared == FT(0))
    throw Error(Error_code::zero_tangent, "corner_distance: the curves turn back at the corner");
  if constexpr (internal::has_rational_roots<FT>()) {
    const std::optional<FT> s = rational_square_root(square), sine = rational_square_root(sine_squared);
    if (s && sine) return FT(radius.value * *sine / (*s + c));
  }
  const double x = CGAL::to_double(sine_squared / square), y = CGAL::to_double(c) / std::sqrt(CGAL::to_double(square));
  return FT(CGAL::to_double(radius.value) * std::sqrt(x) / (1 + y));
}

/// \ingroup PkgGeometricContinuityExtensions
/// Rounds the corner in which the curve `left` ends and the curve `right` starts: cuts the parts of
/// both off that are nearer to it than `distance`, along the curve, and puts a blend into the gap.
/// The corner may be a join of any kind, even a smooth one. Segmented curves and B-splines are
/// rounded by `round_corners()`.
///
/// A line is cut at `distance` exactly where an exact kernel is given and its length is rational;
/// of other lines the parameter is as near to that as a floating-point number can be, and lines of
/// equal length are cut alike. Along other curves the arc length between the corner and the cut is
/// `distance` with a relative error of at most 1/1000; in exchange their cuts have parameters with
/// few binary digits. They are searched in floating-point numbers. The curves are cut, and blended,
/// in the field of the kernel: with an exact kernel both parts are exactly parts of the given
/// curves, on parts of their domains, and the joins are exactly as the strategy promises,
/// \f$ G^2 \f$ with `Fair`.
///
/// Cutting takes \f$ O(m^2) \f$ operations for degree `m`, besides those in floating-point numbers,
/// of which there are more the more a curve bends.
///
/// \param distance positive, and less than the length of each curve
/// \tparam Left, Right `Bezier_curve` or `Rational_bezier_curve`, with one traits class
/// \tparam Strategy `Cubics`, or a model of `BlendStrategy` that is called without shape parameters
/// \returns a `Rounded_corner`
/// \throws Error `not_finite` when the distance, or a curve as numbers of type `double`, is
///   infinite or undefined
/// \throws Error `curves_do_not_meet` unless `left` ends in the point where `right` starts
/// \throws Error `parameter_outside_domain` when the distance is not positive, or not less than the
///   length of a curve
/// \throws Error `zero_tangent` when a first derivative is zero at a cut, and when the curves meet
///   in a cusp and both lie on one line; `zero_direction` when both cuts lie in one point, e.g.
///   where one curve is the other one reversed
/// \throws Error `dimension_mismatch`, `not_representable` when a cut has no parameter of type
///   `double`, and as `blend()` with `Cubics` does
template <class Left, class Right, class Strategy = Fair>
auto round_corner(const Left& left, const Right& right, const internal::Convertible_number<typename Left::FT>& distance,
                  const Strategy& strategy = Strategy()) {
  typedef typename Left::FT FT;
  constexpr bool have_no_split = std::is_same_v<decltype(left.split(FT())), internal::No_result> ||
                                 std::is_same_v<decltype(right.split(FT())), internal::No_result>;
  static_assert(!have_no_split, "round_corner(a, b, distance) takes Bezier curves, as a.bezier_pieces().back() and "
                                "b.bezier_pieces().front() of splines are");
  if constexpr (have_no_split) // so that there is one error
    return internal::No_result();
  else {
    const char* const place = "round_corner";
    internal::check_distance(distance.value, place);
    if (left.dimension() != right.dimension()) throw Error(Error_code::dimension_mismatch, place);
    if (left.coordinates(left.degree()) != right.coordinates(0)) throw Error(Error_code::curves_do_not_meet, place);
    const FT left_cut = internal::cut_parameter(left, Curve_end::end, distance.value, place),
             right_cut = internal::cut_parameter(right, Curve_end::start, distance.value, place);
    const Left left_part = left.split(left_cut).first;
    const Right right_part = right.split(right_cut).second;
    const auto gamma = internal::blend_of_parts(left_part, right_part, strategy, place);
    return Rounded_corner<Left, Right, std::decay_t<decltype(gamma)>>{left_part, gamma, right_part, left_cut,
                                                                      right_cut};
  }
}

/// \ingroup PkgGeometricContinuityExtensions
/// Is given to `round_corners()` in place of a distance: each corner is cut at the distance in
/// which a circle of this radius touches both tangents, see `corner_distance()`.
template <class FT> struct Corner_radius { FT radius; };
template <class FT> Corner_radius(FT) -> Corner_radius<FT>;

/// \ingroup PkgGeometricContinuityExtensions
/// Where a corner of a chain was, and what has become of it.
template <class FT> struct Rounded_join {
  /// the corner is the join after this Bézier curve of the given chain, counted from 0 on
  std::size_t join;
  /// from the corner to both cuts, along the curves, as `round_corner()` is asked for it
  FT distance;
  FT left_cut;       ///< the parameter where the curve before the corner is cut
  FT right_cut;      ///< the parameter where the curve after the corner is cut
  std::size_t blend; ///< the number of the blend in the rounded chain
  /// of how many curves the blend is made: 1, or with `Cubics` up to 2
  std::size_t pieces = 1;
};

/// \ingroup PkgGeometricContinuityExtensions
/// A chain of curves whose corners are rounded.
/// \tparam Curve `Bezier_curve<Traits>`, or `Rational_bezier_curve<Traits>` if the given curves are
///   rational
template <class Curve> struct Rounded_chain {
  /// the chain: curves, or parts of them, and blends
  std::vector<Curve> curves;
  /// the corners that were rounded, in their order
  std::vector<Rounded_join<typename Curve::FT>> corners;

  auto begin() const { return curves.begin(); }                      ///< iterates over the curves
  auto end() const { return curves.end(); }                          ///< the end of the curves
  std::size_t size() const { return curves.size(); }                 ///< the number of curves
  const Curve& operator[](std::size_t i) const { return curves[i]; } ///< the `i`-th curve
};

namespace internal {

// The curve between two parameters, each of which may be an end of it.
template <class Curve>
Curve part_between(const Curve& curve, const typename Curve::FT& a, const typename Curve::FT& b) {
  const Curve before = b < curve.domain().second ? curve.split(b).first : curve;
  return curve.domain().first < a ? before.split(a).second : before;
}

// The continuity at the joins of the Bezier curves that a curve is made of, decided on the curve as
// it is given.
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

// As round_corners() rounds: distance(left, right) is that of a corner, zero where none is rounded.
template <class ForwardIterator, class Distance, class Strategy>
Rounded_chain<Bezier_piece<typename std::iterator_traits<ForwardIterator>::value_type>>
rounded_chain(ForwardIterator first, ForwardIterator last, const Distance& distance, Closure closure, int order,
              const Strategy& strategy) {
  typedef Bezier_piece<typename std::iterator_traits<ForwardIterator>::value_type> Curve;
  typedef typename Curve::FT FT;
  const bool closed = closure == Closure::closed;
  const auto place = [](std::size_t i) { return "round_corners: join after curve " + std::to_string(i); };

  std::vector<Curve> given;
  std::vector<bool> is_corner; // the join after the curve
  const auto add_join = [&](const auto& join) {
    if (join.c_order < 0) throw Error(Error_code::curves_do_not_meet, place(is_corner.size()));
    is_corner.push_back(join.g_order < order);
  };
  for (ForwardIterator c = first; c != last; ++c) {
    add_bezier_pieces(*c, given);
    for (const auto& join : inner_joins(*c, order)) add_join(join);
    const ForwardIterator next = std::next(c);
    if (next != last)
      add_join(continuity(*c, *next, order));
    else if (closed)
      add_join(continuity(*c, *first, order));
    else
      is_corner.push_back(false);
  }
  const std::size_t n = given.size();
  std::vector<FT> distances(n, FT(0));
  for (std::size_t i = 0; i < n; ++i) {
    if (is_corner[i]) distances[i] = distance(given[i], given[(i + 1) % n]);
    is_corner[i] = FT(0) < distances[i];
  }
  const auto longest = [&](std::size_t i) -> FT { // distance of a corner from its cut on this curve
    const FT part(is_corner[i] && is_corner[(i + n - 1) % n] ? 0.375 : 0.75);
    return FT(part * Corner_side<Curve>(given[i], Curve_end::start).length());
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
    const FT d = (std::min)({distances[i], longest(i), longest(next)});
    ends[i] = cut_parameter(given[i], Curve_end::end, d, place(i));
    starts[next] = cut_parameter(given[next], Curve_end::start, d, place(i));
    result.corners.push_back({i, d, ends[i], starts[next], 0});
  }

  std::vector<Curve> parts;
  for (std::size_t i = 0; i < n; ++i) parts.push_back(part_between(given[i], starts[i], ends[i]));
  auto corner = result.corners.begin();
  for (std::size_t i = 0; i < n; ++i) {
    result.curves.push_back(parts[i]);
    if (!is_corner[i]) continue;
    corner->blend = result.curves.size();
    ++corner;
    for_each_piece(blend_of_parts(parts[i], parts[(i + 1) % n], strategy, place(i)),
                   [&](const auto& piece) { result.curves.emplace_back(piece); });
    std::prev(corner)->pieces = result.curves.size() - std::prev(corner)->blend;
  }
  return result;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityExtensions
/// Rounds the corners of a chain of curves, each of which starts where the one before it ends.
/// Segmented curves and B-splines are chains of Bézier curves themselves, and their inner joins and
/// knots are joins like all others. Corners are the joins whose \f$ G \f$ order is less than
/// `order`: with 1 kinks and cusps, with 2 jumps of the curvature too. All other joins, and the
/// control points of Bézier curves without corners, stay as they are.
///
/// A corner is cut off at `distance` on both sides, as `round_corner()` does, or nearer, so that a
/// quarter of each curve remains: at most at 3/4 of the length of a Bézier curve with one corner,
/// and at 3/8 of the length of one with two. Both cuts of a corner have the same distance.
///
/// One call of `continuity()` or `knot_continuity()` for each join, and what `round_corner()` takes
/// for each corner.
///
/// \param first,last the curves, of type `Bezier_curve`, `Composite_bezier_curve`, `Bspline_curve`,
///   `Rational_bezier_curve` or `Rational_bspline_curve`
/// \param distance positive
/// \param closure whether the end of the last curve and the start of the first are a join too,
///   which may be a corner
/// \param order the \f$ G \f$ order that joins need in order to stay
/// \param strategy `Cubics`, or a model of `BlendStrategy` that is called without shape parameters
/// \throws Error `negative_count` for a negative order, `not_finite` when the distance, or a curve
///   as numbers of type `double`, is infinite or undefined
/// \throws Error `curves_do_not_meet` when there is a gap, with the number of the Bézier curve
///   before it
/// \throws Error `parameter_outside_domain` when the distance is not positive, or a curve at a
///   corner has length zero
/// \throws Error `zero_tangent`, `zero_direction`, `dimension_mismatch`, `not_representable` as
///   `round_corner()` does
template <class ForwardIterator, class Strategy = Fair>
Rounded_chain<internal::Bezier_piece<typename std::iterator_traits<ForwardIterator>::value_type>> round_corners(
    ForwardIterator first, ForwardIterator last,
    const internal::Convertible_number<typename std::iterator_traits<ForwardIterator>::value_type::FT>& distance,
    Closure closure, int order = 2, const Strategy& strategy = Strategy()) {
  typedef typename std::iterator_traits<ForwardIterator>::value_type::FT FT;
  internal::check_distance(distance.value, "round_corners");
  internal::check_count(order, "round_corners: order");
  const auto same = [&](const auto&, const auto&) -> FT { return distance.value; };
  return internal::rounded_chain(first, last, same, closure, order, strategy);
}

/// \ingroup PkgGeometricContinuityExtensions
/// Rounds the corners of a chain of curves as by circles of a radius: those whose tangents turn, by
/// more than \f$ 10^{-9} \f$, at the distance of each where such a circle touches both tangents, or
/// nearer on short curves.
/// \throws Error as with a distance, and as `corner_distance()`
template <class ForwardIterator, class Number, class Strategy = Fair>
auto round_corners(ForwardIterator first, ForwardIterator last, const Corner_radius<Number>& radius, Closure closure,
                   int order = 2, const Strategy& strategy = Strategy()) {
  typedef typename std::iterator_traits<ForwardIterator>::value_type::FT FT;
  const internal::Convertible_number<FT> r(radius.radius);
  internal::check_distance(r.value, "round_corners");
  internal::check_count(order, "round_corners: order");
  const FT least = FT(r.value * FT(0.5e-9));
  const auto touching = [&](const auto& left, const auto& right) -> FT {
    const FT d = corner_distance(left, right, r.value);
    return d < least ? FT(0) : d;
  };
  return internal::rounded_chain(first, last, touching, closure, order, strategy);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Rounds all corners of the curves of a range, such as a `std::vector`.
template <class Range, class Strategy = Fair>
auto round_corners(
    const Range& chain,
    const internal::Convertible_number<typename std::decay_t<decltype(*std::begin(chain))>::FT>& distance,
    Closure closure, int order = 2, const Strategy& strategy = Strategy()) {
  return round_corners(std::begin(chain), std::end(chain), distance, closure, order, strategy);
}

namespace internal {

// The sides of a polygon or a polyline.
template <class Point>
std::vector<Bezier_curve<Traits_of<Point>>> sides_of(const std::vector<Point>& points, Closure closure) {
  if (points.size() < 2) throw Error(Error_code::wrong_number_of_points, "round_corners: fewer than two points");
  std::vector<Bezier_curve<Traits_of<Point>>> sides;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) sides.emplace_back(points[i], points[i + 1]);
  if (closure == Closure::closed && points.front() != points.back()) sides.emplace_back(points.back(), points.front());
  return sides;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Rounds all corners of the polygon or the polyline with these vertices, points of a \cgal kernel,
/// over whose traits class (`Traits_of`) the result is.
/// \throws Error `wrong_number_of_points` for fewer than two points, and as for a chain of curves
template <class Point, class Strategy = Fair>
Rounded_chain<Bezier_curve<Traits_of<Point>>>
round_corners(const std::vector<Point>& points,
              const internal::Convertible_number<typename Traits_of<Point>::FT>& distance, Closure closure,
              int order = 2, const Strategy& strategy = Strategy()) {
  return round_corners(internal::sides_of(points, closure), distance, closure, order, strategy);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Rounds all corners of the curves of a range, or of the polygon or the polyline with a vector of
/// points, as by circles of a radius.
/// \throws Error as for a distance, and as `corner_distance()`
template <class Range, class Number, class Strategy = Fair>
auto round_corners(const Range& chain, const Corner_radius<Number>& radius, Closure closure, int order = 2,
                   const Strategy& strategy = Strategy()) {
  if constexpr (internal::Has_traits<std::decay_t<decltype(*std::begin(chain))>>::value)
    return round_corners(std::begin(chain), std::end(chain), radius, closure, order, strategy);
  else
    return round_corners(internal::sides_of(chain, closure), radius, closure, order, strategy);
}

namespace internal {

// Tells whether points, or curves, end where they start.
template <class Curve_or_point> Closure closure_of(const std::vector<Curve_or_point>& chain) {
  if (chain.empty()) return Closure::open;
  if constexpr (Has_traits<Curve_or_point>::value) {
    typedef typename Curve_or_point::FT FT;
    const bool meet = end_jet<FT>(chain.back(), 0)[0] == start_jet<FT>(chain.front(), 0)[0];
    return meet ? Closure::closed : Closure::open;
  } else
    return chain.front() == chain.back() ? Closure::closed : Closure::open;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Rounds all corners of a vector of curves, or of the polygon or the polyline with a vector of
/// points, at a distance or as by circles of a `Corner_radius`: it is closed where it ends in the
/// point where it starts, and open otherwise.
/// \throws Error as the functions that take a `Closure`
template <class Curve_or_point, class Number>
auto round_corners(const std::vector<Curve_or_point>& chain, const Number& distance)
    -> decltype(round_corners(chain, distance, Closure::open)) {
  return round_corners(chain, distance, internal::closure_of(chain));
}

/// \ingroup PkgGeometricContinuityConstruction
/// Rounds all corners of a `CGAL::Polygon_2`, which is closed, at a distance or as by circles of a
/// `Corner_radius`.
/// \throws Error as for a vector of points
template <class Kernel, class Container, class Number>
Rounded_chain<Bezier_curve<Traits_2<Kernel>>> round_corners(const CGAL::Polygon_2<Kernel, Container>& polygon,
                                                            const Number& distance) {
  const std::vector<typename Kernel::Point_2> vertices(polygon.vertices_begin(), polygon.vertices_end());
  return round_corners(vertices, distance, Closure::closed);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_REPAIRS_ROUND_CORNERS_H
