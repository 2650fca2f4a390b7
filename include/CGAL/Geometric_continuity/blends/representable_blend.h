// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_REPRESENTABLE_BLEND_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_REPRESENTABLE_BLEND_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/internal/Representable_end.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file representable_blend.h
/// Blends whose control points are floating-point numbers and whose joins are exactly \f$ G^2 \f$
/// nevertheless.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// The changes that a representable blend needed at one of its joins.
template <class FT, int N> struct Representable_join {
  /// The shape parameter \f$ \beta_1 > 0 \f$ of the join, seen from the given curve.
  FT beta;
  /// For each coordinate the power of two of which those of the three control points next to the
  /// join are multiples.
  Coordinate_vector<FT, N> grid;
  /// The largest change of a coordinate of these points, at most half of its grid unit; 0 when none
  /// was moved.
  FT moved;

  /// Returns whether a control point of the given curve was moved.
  bool is_moved() const { return moved != FT(0); }
};

/// \ingroup PkgGeometricContinuityConstruction
/// A quintic blend whose control points are floating-point numbers and whose joins are exactly
/// \f$ G^2 \f$, together with the curves that it joins. These are the given ones unless
/// `start_join.is_moved()` or `end_join.is_moved()`.
template <class Traits> struct Representable_blend : Bezier_curve<Traits, 5> {
  typedef typename Traits::FT FT;

  /// the first curve; `start_join` tells whether its last three control points were moved
  Bezier_curve<Traits> phi;
  /// the second curve; `end_join` tells whether its first three control points were moved
  Bezier_curve<Traits> psi;
  /// what was needed at the end of \f$ \varphi \f$
  Representable_join<FT, dimension_v<Traits>> start_join;
  /// what was needed at the start of \f$ \psi \f$
  Representable_join<FT, dimension_v<Traits>> end_join;

  /// Takes the blend, the two curves and what the joins needed.
  Representable_blend(const Bezier_curve<Traits, 5>& gamma, const Bezier_curve<Traits>& given_phi,
                      const Bezier_curve<Traits>& given_psi,
                      const Representable_join<FT, dimension_v<Traits>>& at_start,
                      const Representable_join<FT, dimension_v<Traits>>& at_end)
      : Bezier_curve<Traits, 5>(gamma), phi(given_phi), psi(given_psi), start_join(at_start), end_join(at_end) {}
};

namespace internal {

enum class Curve_side { start, end };

// The control points next to a join of a curve, read inward; a straight line has no third one, and
// none is needed.
template <class Traits, int Degree>
std::array<Coordinates<Traits>, 3> inward_points(const Bezier_curve<Traits, Degree>& curve, Curve_side side) {
  const int m = curve.degree();
  const auto point = [&](int i) { return curve.coordinates(side == Curve_side::end ? m - i : i); };
  return {point(0), point(1), point((std::min)(m, 2))};
}

// The curve with these points next to the join.
template <class Traits, int Degree>
Bezier_curve<Traits> with_inward_points(const Bezier_curve<Traits, Degree>& curve, Curve_side side,
                                        const std::array<Coordinates<Traits>, 3>& b) {
  const int m = curve.degree();
  std::vector<typename Traits::Point> points(curve.begin(), curve.end());
  for (int i = 0; i <= (std::min)(m, 2); ++i) points[side == Curve_side::end ? m - i : i] = to_point<Traits>(b[i]);
  return Bezier_curve<Traits>(points.begin(), points.end(), curve.domain().first, curve.domain().second);
}

inline void check_degrees(int phi, int psi) {
  if (phi < 1 || psi < 1)
    throw Error(Error_code::wrong_number_of_points, "representable_blend: a curve of degree 0 has no tangent");
}

template <class FT, int N>
Representable_join<FT, N> representable_join(const Representable_end<FT, N>& end,
                                             const std::array<Coordinate_vector<FT, N>, 3>& given) {
  Representable_join<FT, N> join{end.beta(), given[0], FT(0)};
  for (int x = 0; x < given[0].dimension(); ++x) join.grid[x] = std::ldexp(FT(1), end.grid()[x]);
  for (int i = 0; i < 3; ++i)
    for (int x = 0; x < given[i].dimension(); ++x)
      join.moved = (std::max)(join.moved, FT(std::abs(end.points()[i][x] - given[i][x])));
  return join;
}

// Chooses the points of a blend at both ends: as long as there are none, one end after the other is
// made simpler.
template <class FT, int N, class Strategy>
void choose_points(Representable_end<FT, N>& start, Representable_end<FT, N>& end, const Strategy& strategy) {
  for (bool found = false; !found;) {
    const Quintic_ends<Exact_rational, N> ends(start.a(), end.a(), start.tangent(), end.tangent(),
                                               start.second_derivative(), end.second_derivative());
    const Quintic_parameters<Exact_rational> s = strategy(ends);
    const bool start_found = start.choose(ends.c1(s.s1)), end_found = end.choose(ends.c2(s.s2));
    if (!start_found) start.simplify();
    if (!end_found) end.simplify();
    found = start_found && end_found;
  }
}

// The control points of the blend, which are numbers of type FT.
template <class FT, int N>
std::array<Coordinate_vector<FT, N>, 6> chosen_points(const Representable_end<FT, N>& start,
                                                      const Representable_end<FT, N>& end) {
  const auto rounded = [](const Coordinate_vector<Exact_rational, N>& x) {
    Coordinate_vector<FT, N> y(x.dimension());
    for (int i = 0; i < x.dimension(); ++i) y[i] = FT(CGAL::to_double(x[i]));
    return y;
  };
  return {rounded(start.a()),         rounded(start.second_point()), rounded(start.third_point()),
          rounded(end.third_point()), rounded(end.second_point()),   rounded(end.a())};
}

template <class FT> FT length_of(const std::pair<FT, FT>& domain) { return domain.second - domain.first; }

// Calls f(strategy, shape) with the shape parameters that the strategy chooses, or else with
// automatic ones, and the strategy for them.
template <class FT, int N, class Strategy, class Function>
auto with_wished_shape(const Coordinate_jet<Exact_rational, N>& left, const Coordinate_jet<Exact_rational, N>& right,
                       const Strategy& strategy, const Function& f) {
  const auto call = [&](const auto& s, const Shape_parameters<Exact_rational>& shape) {
    // short: exact
    return f(s, Shape_parameters<FT>(FT(CGAL::to_double(shape.beta)), FT(CGAL::to_double(shape.eta))));
  };
  if constexpr (Chooses_shape<Strategy, Coordinate_jet<Exact_rational, N>>::value) {
    const auto chosen = strategy.choose(left, right);
    return call(chosen.strategy, chosen.shape);
  } else
    return call(strategy, automatic_shape(left, right));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns a quintic blend with control points that are floating-point numbers and with joins that
/// are *exactly* \f$ G^2 \f$, as the exact predicates on the control points confirm: joins with the
/// curves in its members `phi` and `psi`, which are the given ones, or these moved to a grid; with
/// a given curve that was moved it has a gap. Rounding breaks every exact join of `blend()`; here
/// the freedom of geometric continuity is spent on numbers with few digits.
///
/// With \f$ p = b_0 - b_{-1} \f$ and \f$ q = b_0 - 2b_{-1} + b_{-2} \f$ at the end of a curve of
/// degree \f$ m \f$,
/// \f[ B = A + c\,p, \qquad C = 2B - A + c^2\,\frac{5(m-1)}{4m}\,q + e\,p \f]
/// with \f$ \beta = 5ch/m \f$ for a domain of the length `h`, and mirrored at the start of
/// \f$ \psi \f$. Here `c` is close to \f$ \beta m/(5h) \f$ for the \f$ \beta \f$ of `shape` (within
/// 1/8 of it, by 3 to 8 binary digits) and a multiple of the odd part of \f$ m/\gcd(m,5) \f$, so
/// that no division by it remains; and `e` is close to what the strategy chooses, as near as the
/// remaining digits allow (at least to 1/32, as a part of the side `p`).
///
/// The three control points next to a join should be multiples of one power of two, with about a
/// dozen binary digits to spare. Points that are not, e.g. those with 53 random digits, are rounded
/// to the finest such grid that leaves room, each coordinate by at most half a grid unit; the
/// result has the curves as they then are, and says by how much they moved. The shape of the whole
/// blend follows the moved curves.
///
/// \param phi,psi Bézier curves of any degree \f$ \ge 1 \f$
/// \param strategy a quintic strategy, see `BlendStrategy`; it is called with exact numbers
/// \param shape the wished shape parameters
/// \tparam Traits a traits class whose `FT` is `float` or `double`
/// \throws Error `nonpositive_beta`, `dimension_mismatch`, `zero_tangent` as `blend()`
/// \throws Error `wrong_number_of_points` for a curve of degree 0
/// \throws Error `not_finite` for an infinite shape parameter, or when the strategy gives one
/// \throws Error `not_representable` when no grid serves: when the tangent at a join is lost on
///   each grid that leaves room (as for a shape parameter that is far too small or too large), or
///   when a coordinate, a grid unit or a shape parameter would overflow
///
/// All of this holds in every rounding mode of floating-point arithmetic.
///
/// A constant number of operations on rational numbers for each grid that is tried, at most
/// about 50.
template <class Traits, int M, int N, class Strategy>
Representable_blend<Traits> representable_blend(const Bezier_curve<Traits, M>& phi, const Bezier_curve<Traits, N>& psi,
                                                const Strategy& strategy,
                                                const Shape_parameters<typename Traits::FT>& shape) {
  typedef typename Traits::FT FT;
  typedef internal::Representable_end<FT, dimension_v<Traits>> End;
  typedef std::array<Geometric_continuity::Coordinates<Traits>, 3> Points;
  static_assert(std::is_floating_point_v<FT>, "with exact numbers, blend() is exact");
  internal::check_degrees(phi.degree(), psi.degree());
  internal::check_blend_input(end_jet<Exact_rational>(phi, 2), start_jet<Exact_rational>(psi, 2), 2,
                              Shape_parameters<Exact_rational>{shape.beta, shape.eta});
  const Points given_start = internal::inward_points(phi, internal::Curve_side::end),
               given_end = internal::inward_points(psi, internal::Curve_side::start);
  const auto lengths = [](const auto& curve) {
    const FT length = internal::length_of(curve.domain());
    return internal::Inward_lengths<FT>{curve.degree(), length, length};
  };
  End start(given_start, lengths(phi), 1, shape.beta, "representable_blend: end of the first curve"),
      end(given_end, lengths(psi), -1, shape.eta, "representable_blend: start of the second curve");
  internal::choose_points(start, end, strategy);
  const Bezier_curve<Traits, 5> gamma(internal::chosen_points(start, end));
  return {gamma, internal::with_inward_points(phi, internal::Curve_side::end, start.points()),
          internal::with_inward_points(psi, internal::Curve_side::start, end.points()),
          internal::representable_join(start, given_start), internal::representable_join(end, given_end)};
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the representable blend whose shape parameters are near those that the strategy chooses,
/// as `Fair` does, or else near those of `automatic_shape()`. Errors and
/// cost are those of `representable_blend()` with a shape, besides what the choice of the shape
/// needs.
/// \throws Error `dimension_mismatch`, `zero_tangent`, `wrong_number_of_points`,
///   `not_representable`
template <class Traits, int M, int N, class Strategy>
Representable_blend<Traits> representable_blend(const Bezier_curve<Traits, M>& phi, const Bezier_curve<Traits, N>& psi,
                                                const Strategy& strategy) {
  typedef Coordinate_jet<Exact_rational, dimension_v<Traits>> Jet;
  internal::check_degrees(phi.degree(), psi.degree());
  const Jet left = end_jet<Exact_rational>(phi, 2), right = start_jet<Exact_rational>(psi, 2);
  internal::check_blend_input(left, right, 2, Shape_parameters<Exact_rational>());
  typedef typename Traits::FT FT;
  return internal::with_wished_shape<FT>(left, right, strategy, [&](const auto& s, const Shape_parameters<FT>& shape) {
    return representable_blend(phi, psi, s, shape);
  });
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the representable blend next to the blend of least energy \f$ \int |\gamma'''|^2 \f$
/// with the shape parameters of `automatic_shape()`. Errors and cost are those of
/// `representable_blend()` with a strategy.
/// \throws Error `dimension_mismatch`, `zero_tangent`, `wrong_number_of_points`,
///   `not_representable`
template <class Traits, int M, int N>
Representable_blend<Traits> representable_blend(const Bezier_curve<Traits, M>& phi,
                                                const Bezier_curve<Traits, N>& psi) {
  return representable_blend(phi, psi, Minimal_energy<3>());
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_REPRESENTABLE_BLEND_H
