// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_ROUND_CORNER_H
#define CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_ROUND_CORNER_H

#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/extensions/internal/Measured_polygon.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

/// \file round_corner.h
/// A corner in which two curves meet is cut off at a given distance on both sides, and a blend is put in its place.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// A rounded corner: three curves, one after the other.
/// \tparam Left, Right `Bezier_curve` or `Rational_bezier_curve`, as given \tparam Blend what `blend()` returns for the strategy
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
typename Curve::FT cut_parameter(const Curve& curve, Curve_end end, double distance, const std::string& place) {
  typedef typename Curve::FT FT;
  const Measured_polygon<Curve::N> polygon(curve, end);
  const double length = polygon.length();
  if (!(distance < length)) {
    std::ostringstream reason;
    reason << place << ": the distance " << distance << " is not less than the length " << length << " of the "
           << (end == Curve_end::end ? "left" : "right") << " curve";
    throw Error(Error_code::parameter_outside_domain, reason.str());
  }
  const std::pair<FT, FT> domain = curve.domain();
  const FT step = FT(FT(polygon.parameter_at(distance)) * FT(domain.second - domain.first));
  return end == Curve_end::start ? FT(domain.first + step) : FT(domain.second - step);
}

inline void check_distance(double distance, const std::string& place) {
  if (!std::isfinite(distance)) throw Error(Error_code::not_finite, place + ": distance");
  if (distance < (std::numeric_limits<double>::min)())
    throw Error(Error_code::parameter_outside_domain, place + ": the distance is not positive");
}

// Whether two curves with opposite tangents end and start on one line, as far as a blend reads them.
template <class Field, class Left, class Right> bool turn_back(const Left& left, const Right& right, int order) {
  typedef Coordinate_vector<Field, Left::N> Vector;
  const Coordinate_jet<Field, Left::N> phi = end_jet<Field>(left, order), psi = start_jet<Field>(right, order);
  const Field square = dot(phi[1], phi[1]);
  const auto is_along = [&](const Vector& v) { return square * v == dot(v, phi[1]) * phi[1]; };
  bool on_line = dot(phi[1], psi[1]) < Field(0) && is_along(psi[0] - phi[0]);
  for (int k = 1; k <= order && on_line; ++k) on_line = is_along(phi[k]) && is_along(psi[k]);
  return on_line;
}

// The blend from the end of one part to the start of the next one.
template <class Left, class Right, class Strategy>
auto blend_of_parts(const Left& left, const Right& right, const Strategy& strategy, const std::string& place) {
  typedef typename Left::Traits Traits;
  typedef typename Left::FT FT;
  if (is_zero(end_jet<FT>(left, 1)[1])) throw Error(Error_code::zero_tangent, place + ": at the cut of the left curve");
  if (is_zero(start_jet<FT>(right, 1)[1]))
    throw Error(Error_code::zero_tangent, place + ": at the cut of the right curve");
  if (turn_back<typename Exact_field<FT>::type>(left, right, is_quintic_strategy_v<Strategy, Traits> ? 2 : 3))
    throw Error(Error_code::zero_tangent, place + ": the curves turn back on one line, where every blend has a cusp");
  if (left.coordinates(left.degree()) == right.coordinates(0))
    throw Error(Error_code::zero_direction, place + ": both cuts lie in one point");
  return blend(left, right, strategy);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Rounds the corner in which the curve `left` ends and the curve `right` starts: cuts off of both what is nearer to it
/// than `distance`, along the curve, and puts a blend into the gap. The corner may be a join of any kind, even a smooth one.
/// Segmented curves and B-splines are rounded by `round_corners()`.
///
/// The arc length between the corner and each cut is `distance` with a relative error of at most 1/1000; in exchange the cuts
/// have parameters with few binary digits. They are searched in floating-point numbers. The curves are cut, and blended, in
/// the field of the kernel: with an exact kernel both parts are exactly parts of the given curves, on parts of their
/// domains, and the joins are exactly as the strategy promises, \f$ G^2 \f$ with `Fair`.
///
/// Cutting takes \f$ O(m^2) \f$ operations for degree `m`, besides those in floating-point numbers, of which there are more
/// the more a curve bends.
///
/// \param distance positive, and less than the length of each curve
/// \tparam Left, Right `Bezier_curve` or `Rational_bezier_curve`, with one traits class
/// \tparam Strategy a model of `BlendStrategy` that is called without shape parameters
/// \returns a `Rounded_corner`
/// \throws Error `not_finite` when the distance, or a curve as numbers of type `double`, is infinite or undefined
/// \throws Error `curves_do_not_meet` unless `left` ends in the point where `right` starts
/// \throws Error `parameter_outside_domain` when the distance is not positive, or not less than the length of a curve
/// \throws Error `zero_tangent` when a first derivative is zero at a cut, and when the curves meet in a cusp and both
///   lie on one line; `zero_direction` when both cuts lie in one point, e.g. where one curve is the other one reversed
/// \throws Error `dimension_mismatch`, `not_representable` when a cut has no parameter of type `double`
template <class Left, class Right, class Strategy = Fair>
auto round_corner(const Left& left, const Right& right, double distance, const Strategy& strategy = Strategy()) {
  typedef typename Left::FT FT;
  const char* const place = "round_corner";
  internal::check_distance(distance, place);
  if (left.dimension() != right.dimension()) throw Error(Error_code::dimension_mismatch, place);
  if (left.coordinates(left.degree()) != right.coordinates(0)) throw Error(Error_code::curves_do_not_meet, place);
  const FT left_cut = internal::cut_parameter(left, Curve_end::end, distance, place),
           right_cut = internal::cut_parameter(right, Curve_end::start, distance, place);
  const Left left_part = left.split(left_cut).first;
  const Right right_part = right.split(right_cut).second;
  const auto gamma = internal::blend_of_parts(left_part, right_part, strategy, place);
  return Rounded_corner<Left, Right, std::decay_t<decltype(gamma)>>{left_part, gamma, right_part, left_cut, right_cut};
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_ROUND_CORNER_H
