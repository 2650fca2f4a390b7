// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERPOLATE_FAIR_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERPOLATE_FAIR_H

#include <CGAL/FPU.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_joints.h>
#include <CGAL/Geometric_continuity/blends/representable_blend.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file interpolate_fair.h
/// Splines of fair quintic blends through points. At each point both blends have one jet (point, tangent, curvature), so that the joins
/// are exactly \f$ G^2 \f$, whatever tangents and curvatures are chosen.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// A \f$ G^2 \f$ spline of fair quintics through points: a segmented curve over the knots 0, 1, 2, ... that meets the points there.
template <class Traits> struct Fair_spline : Composite_bezier_curve<Traits, 5> {
  /// The largest change of a coordinate of a point, which leaves room for exact joins: 0 with an exact kernel.
  typename Traits::FT moved;
  /// The numbers of the points at which rounding may have broken the join: none with an exact kernel.
  std::vector<int> rounded;

  /// From the curve and what rounding has done.
  Fair_spline(const Composite_bezier_curve<Traits, 5>& curve, const typename Traits::FT& change,
              std::vector<int> rounded_joins)
      : Composite_bezier_curve<Traits, 5>(curve), moved(change), rounded(std::move(rounded_joins)) {}
};

namespace internal {

// Chooses tangents and curvatures, in the plane and in space the fair ones; in the order of the points.
template <int N> void choose_fair_joints(std::vector<Fair_joint<N>>& joints, bool closed) {
  const Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
  const auto in_dimension = [&](auto dimension) {
    constexpr int M = decltype(dimension)::value;
    const auto column = [](const auto& x) {
      Coordinate_vector<double, M> y(M);
      for (int i = 0; i < M; ++i) y[i] = x[i];
      return y;
    };
    std::vector<Fair_joint<M>> chosen;
    for (const Fair_joint<N>& j : joints)
      chosen.push_back({column(j.point), column(j.tangent), column(j.curvature), j.given});
    Fair_joints<M>(chosen, closed).minimise();
    for (std::size_t k = 0; k < joints.size(); ++k)
      for (int i = 0; i < M; ++i) {
        joints[k].tangent[i] = chosen[k].tangent[i];
        joints[k].curvature[i] = chosen[k].curvature[i];
      }
  };
  take_circles<N>(joints, closed);
  if (joints[0].point.dimension() == 2)
    in_dimension(std::integral_constant<int, 2>());
  else if (joints[0].point.dimension() == 3)
    in_dimension(std::integral_constant<int, 3>());
}

// The multiple of 2^n nearest to x.
inline double multiple_of_power(double x, int n) { return std::ldexp(std::nearbyint(std::ldexp(x, -n)), n); }

// The end and the start of curves with a jet at their join: parabolas with these control points.
template <class Traits>
Bezier_curve<Traits> parabola(const Coordinate_jet<typename Traits::FT, dimension_v<Traits>>& jet, bool ends) {
  typedef typename Traits::FT FT;
  const FT half = FT(FT(1) / FT(2));
  const Coordinates<Traits> leg = half * jet[1], middle = ends ? jet[0] - leg : jet[0] + leg,
                            far = (ends ? middle - leg : middle + leg) + half * jet[2];
  const typename Traits::Point p[] = {to_point<Traits>(ends ? far : jet[0]), to_point<Traits>(middle),
                                      to_point<Traits>(ends ? jet[0] : far)};
  return Bezier_curve<Traits>(p, p + 3);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns a spline of fair quintic blends through points, with joins that are exactly \f$ G^2 \f$. Each piece is the blend by `Fair` of the
/// tangents and curvatures at two points. These are found in floating-point numbers, in the plane and in space: from the circles through three
/// points on, such that the variation of curvature \f$ \int |(dK/ds)^\perp|^2 ds \f$ of blends of least energy is least, one point after the
/// other; in other dimensions they are those of the circles. Points of a circle, at equal distances, give nearly that circle.
///
/// With an exact kernel the points are met exactly, and the joins are \f$ G^2 \f$ whatever was found. With floating-point numbers,
/// `representable_blend()` makes the pieces: then the joins are exactly \f$ G^2 \f$, too, but at the points in `Fair_spline::rounded`, of
/// which there are few or none; and points with more binary digits than leave room for that are rounded, see `Fair_spline::moved`.
///
/// \f$ O(n) \f$, at most 20 steps for each point.
/// \param first, last the points
/// \param closure whether the curve returns to the first point, \f$ G^2 \f$ there, too
/// \param tangents the tangents at the points, of any length, where they are given; empty: all are free. With floating-point numbers
///   directions are rounded to about 17 binary digits, 8 with `float`
/// \tparam Traits a model of `GeometricContinuityTraits` \tparam InputIterator its value type is `Traits::Point`
/// \throws Error `wrong_number_of_points` for fewer than 2 points, or 3 if closed, and for another number of tangents; `empty_domain`
///   when two consecutive points coincide; `zero_tangent` for a tangent that is zero; `dimension_mismatch`; `not_finite` also when
///   floating-point numbers overflow
template <class Traits, class InputIterator>
Fair_spline<Traits> interpolate_fair(InputIterator first, InputIterator last, Closure closure = Closure::open,
                                     const std::vector<std::optional<typename Traits::Vector>>& tangents = {}) {
  typedef typename Traits::FT FT;
  constexpr int N = dimension_v<Traits>;
  typedef Coordinate_jet<FT, N> Jet;
  typedef Coordinate_vector<double, N> Column;
  constexpr bool rounds = std::is_floating_point_v<FT>;
  std::vector<Coordinates<Traits>> p;
  for (; first != last; ++first) p.push_back(coordinates<Traits>(*first));
  const int n = static_cast<int>(p.size());
  const bool closed = closure == Closure::closed;
  if (n < (closed ? 3 : 2))
    throw Error(Error_code::wrong_number_of_points, "interpolate_fair: " + std::to_string(n) + " points");
  if (!tangents.empty() && tangents.size() != p.size())
    throw Error(Error_code::wrong_number_of_points, "interpolate_fair: " + std::to_string(tangents.size()) +
                                                        " tangents for " + std::to_string(n) + " points");
  const auto number = [](const FT& x) {
    internal::check_finite(x, "interpolate_fair: a coordinate");
    const double y = internal::rounded_number(x);
    internal::check_finite(y, "interpolate_fair: a coordinate");
    return y;
  };
  const auto column = [&](const Coordinates<Traits>& x, int i) {
    if (x.dimension() != p[0].dimension())
      throw Error(Error_code::dimension_mismatch, "interpolate_fair: at the point " + std::to_string(i));
    Column y(x.dimension());
    for (int k = 0; k < x.dimension(); ++k) y[k] = number(x[k]);
    return y;
  };
  double size = 0;
  for (int i = 0; i < n; ++i)
    for (const double x : column(p[i], i)) size = (std::max)(size, std::abs(x));
  FT moved(0);
  if constexpr (rounds) // room for the digits of the blends
    if (size > 0)
      for (Coordinates<Traits>& x : p)
        for (int k = 0; k < x.dimension(); ++k) {
          FT& c = x[k];
          const FT given = c;
          c = FT(internal::multiple_of_power(c, std::ilogb(size) + 7 - std::numeric_limits<FT>::digits));
          moved = (std::max)(moved, FT(std::abs(c - given)));
        }
  std::vector<internal::Fair_joint<N>> joints;
  for (int i = 0; i < n; ++i) {
    internal::Fair_joint<N> joint{column(p[i], i), Column(p[i].dimension()), Column(p[i].dimension()), false};
    if (!tangents.empty() && tangents[i]) {
      joint.tangent = column(coordinates<Traits>(*tangents[i]), i);
      const double length = std::sqrt(dot(joint.tangent, joint.tangent));
      if (!(length > 0)) throw Error(Error_code::zero_tangent, "interpolate_fair: at the point " + std::to_string(i));
      joint.tangent /= length;
      joint.given = true;
    }
    joints.push_back(joint);
  }
  std::vector<double> lengths; // of the chords
  for (int i = 0; i < (closed ? n : n - 1); ++i) {
    const Column chord = joints[(i + 1) % n].point - joints[i].point;
    lengths.push_back(std::sqrt(dot(chord, chord)));
    if (!(lengths.back() > 0))
      throw Error(Error_code::empty_domain, "interpolate_fair: the points " + std::to_string(i) + " and " +
                                                std::to_string((i + 1) % n) + " coincide");
    internal::check_finite(lengths.back() * lengths.back(), "interpolate_fair: a distance");
  }
  internal::choose_fair_joints<N>(joints, closed);

  // short numbers, from which all is constructed in the field
  std::vector<Jet> jets;
  for (int i = 0; i < n; ++i) {
    const double before = i > 0 ? lengths[i - 1] : lengths.back(), after = i < n - 1 || closed ? lengths[i] : before,
                 h = (std::min)(closed || i > 0 ? before : after, after);
    const int unit = (std::max)(std::ilogb(h) - (rounds ? (std::min)(20, std::numeric_limits<FT>::digits / 3) : 20),
                                rounds ? std::ilogb(size) + 9 - std::numeric_limits<FT>::digits : -1000);
    Jet jet(p[i].dimension(), 2);
    jet[0] = p[i];
    const bool exactly = !rounds && joints[i].given;
    double speed = h;
    if (exactly) {
      jet[1] = coordinates<Traits>(*tangents[i]);
      const Column t = column(jet[1], i);
      speed = std::sqrt(dot(t, t));
    }
    const int unit_of_bend = exactly ? unit + 2 * (std::ilogb(speed) - std::ilogb(h)) : unit;
    for (int k = 0; k < p[i].dimension(); ++k) {
      if (!exactly)
        jet[1][k] = internal::short_number_in<FT>(internal::multiple_of_power(h * joints[i].tangent[k], unit));
      jet[2][k] = internal::short_number_in<FT>(
          internal::multiple_of_power(speed * speed * joints[i].curvature[k], unit_of_bend));
    }
    jets.push_back(std::move(jet));
  }

  std::vector<typename Traits::Point> points;
  std::vector<FT> knots(1, FT(0));
  std::vector<char> is_rounded(n, 0);
  for (int i = 0; i < static_cast<int>(lengths.size()); ++i) {
    const Jet &start = jets[i], &end = jets[(i + 1) % n];
    std::optional<Bezier_curve<Traits, 5>> piece;
    if constexpr (rounds) try {
        const Representable_blend<Traits> blend = representable_blend(internal::parabola<Traits>(start, true),
                                                                      internal::parabola<Traits>(end, false), Fair());
        if (!blend.start_join.is_moved() && !blend.end_join.is_moved()) piece = blend;
      } catch (const Error& e) {
        if (e.code() != Error_code::not_representable) throw;
      }
    if (!piece) {
      piece = blend(Curve_jet<Traits>(start), Curve_jet<Traits>(end), Fair());
      is_rounded[i] = is_rounded[(i + 1) % n] = rounds;
    }
    points.insert(points.end(), piece->begin() + (i == 0 ? 0 : 1), piece->end());
    knots.push_back(FT(i + 1));
  }
  std::vector<int> rounded;
  for (int i = closed ? 0 : 1; i < (closed ? n : n - 1); ++i)
    if (is_rounded[i]) rounded.push_back(i);
  return Fair_spline<Traits>(Composite_bezier_curve<Traits, 5>(points, std::move(knots)), moved, std::move(rounded));
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns a spline of fair quintic blends through points of a \cgal kernel, over whose traits class (`Traits_of`) it is.
/// \throws Error as for the points between two iterators
template <class Point>
Fair_spline<Traits_of<Point>>
interpolate_fair(const std::vector<Point>& points, Closure closure = Closure::open,
                 const std::vector<std::optional<typename Traits_of<Point>::Vector>>& tangents = {}) {
  return interpolate_fair<Traits_of<Point>>(points.begin(), points.end(), closure, tangents);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERPOLATE_FAIR_H
