// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_EXTEND_H
#define CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_EXTEND_H

#include <CGAL/Geometric_continuity/algebra/internal/solve_positive_definite.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/extensions/alternatives.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_words.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file extend.h
/// The next segment behind a curve, with chosen members of Hagen's families of alternatives (see
/// `alternatives.h`), and the one that leads from the end of a chain of curves back to its start.
/// For a Bézier curve the segment is returned; a segmented curve and a B-spline curve are returned
/// with the segment.
///
/// `extend_toward()` leads to a wished point with the least energy among the members of Hagen's
/// families (see `alternatives.h`).

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityExtensions
/// The quantities that a join keeps continuous, each with all before it: \f$ F^1 \f$, \f$ F^2 \f$,
/// \f$ F^3 \f$.
enum class Frenet_order {
  tangent = 1,   ///< the direction of the tangent
  curvature = 2, ///< the curvature vector
  torsion = 3    ///< the Frenet frame, the curvature and the torsion
};

namespace internal {

// A number that a caller may leave out, see Convertible_number.
template <class FT> struct Given_optional_number {
  std::optional<FT> value;

  Given_optional_number() = default;
  Given_optional_number(std::nullopt_t) {}
  Given_optional_number(std::optional<FT> x) : value(std::move(x)) {}
  template <class T, class = std::enable_if_t<!std::is_same_v<std::decay_t<T>, std::optional<FT>> &&
                                              std::is_constructible_v<FT, T&&>>>
  Given_optional_number(T&& x) : value(Convertible_number<FT>(std::forward<T>(x)).value) {}
};

} // namespace internal

/// \ingroup PkgGeometricContinuityExtensions
/// The ratio and the members of the families of alternatives that a next segment takes. Scalars
/// that are not given are those of the smoothest join: \f$ C_0 \f$ of the \f$ C^2 \f$ member,
/// \f$ C_2 \f$ of the \f$ G^3 \f$ member and \f$ C_1 \f$ with \f$ \delta = 0 \f$.
template <class FT> struct Extension_parameters {
  /// the length of the domain of the next segment, that of the last one being 1
  FT beta = FT(1);
  std::optional<FT> c0; ///< \f$ C_0 \f$, which chooses \f$ b_2 \f$, see `Curvature_alternatives`
  /// \f$ C_1 \f$, which chooses \f$ b_3 \f$ together with `c2`, see `Torsion_alternatives`
  std::optional<FT> c1;
  /// \f$ C_2 \f$, which chooses \f$ b_3 \f$ together with `c1`, see `Torsion_alternatives`
  std::optional<FT> c2;

  /// Sets \f$ \beta = 1 \f$ and gives none of the others.
  Extension_parameters() = default;
  /// Takes numbers of any type from which `FT` can be made; `{}` or `std::nullopt` stands for a
  /// value that is not given.
  /// \throws Error `not_finite` when a floating-point number that is converted is infinite or not a
  ///   number
  Extension_parameters(internal::Convertible_number<FT> given_beta, internal::Given_optional_number<FT> given_c0 = {},
                       internal::Given_optional_number<FT> given_c1 = {},
                       internal::Given_optional_number<FT> given_c2 = {})
      : beta(std::move(given_beta.value)), c0(std::move(given_c0.value)), c1(std::move(given_c1.value)),
        c2(std::move(given_c2.value)) {}
};

namespace internal {

// The polygon of the polynomial `left` itself on the interval behind its domain that is beta times
// as long.
template <class Traits, int Degree>
std::vector<Coordinates<Traits>> continued_polygon(const Bezier_curve<Traits, Degree>& left,
                                                   const typename Traits::FT& beta) {
  typedef typename Traits::FT FT;
  std::vector<Coordinates<Traits>> b, before;
  for (int j = 0; j <= left.degree(); ++j) b.push_back(left.coordinates(j));
  const Work_guard work("extend");
  const double p = left.degree();
  const std::size_t words = common_words<FT>(b);
  if (words > 0) // p^2/2 combinations of two
    work_meter().charge_fractions(p * p / 2 * left.dimension(), words + left.degree() * number_words(beta));
  before.resize(b.size());
  bernstein_split<FT>(b, left.degree(), FT(FT(1) + beta), before); // b: from 1 + beta back to 1
  std::reverse(b.begin(), b.end());
  return b;
}

// Moves b_j to its new place and the points behind it so that only the j-th derivative at the start
// changes.
template <class FT, int N>
void move_point(std::vector<Coordinate_vector<FT, N>>& b, int j, const Coordinate_vector<FT, N>& place) {
  const Coordinate_vector<FT, N> step = place - b[j];
  b[j] = place;
  for (int i = j + 1; i < static_cast<int>(b.size()); ++i) b[i] += binomial_coefficients<FT>(i)[j] * step;
}

template <class Traits, int Degree>
Bezier_curve<Traits, Degree> next_segment(const Bezier_curve<Traits, Degree>& left, const typename Traits::FT& beta,
                                          const std::vector<Coordinates<Traits>>& b) {
  typedef typename Traits::FT FT;
  for (const Coordinates<Traits>& point : b)
    for (const FT& x : point) check_finite(x, "extend: the result overflows");
  const std::vector<typename Traits::Point> points = to_points<Traits>(b);
  const std::pair<FT, FT> domain = left.domain();
  return {points.begin(), points.end(), domain.second, FT(domain.second + beta * (domain.second - domain.first))};
}

} // namespace internal

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the next segment of a chain behind `left`: of the same degree `m`, on the domain
/// \f$ [b, b + \beta (b - a)] \f$ behind \f$ [a, b] \f$, with the wanted continuity. Its first
/// points are the given members of the families of alternatives; its derivatives beyond the wanted
/// order are those of `left`. Without given parameters this is the polynomial `left` itself,
/// continued, for every order. \f$ O(m^2) \f$
/// \throws Error `wrong_number_of_points` when `m` is less than the order (the family does not
///   exist)
/// \throws Error `nonpositive_beta` unless \f$ \beta > 0 \f$
/// \throws Error `zero_tangent` when the last two control points are equal
/// \throws Error `not_finite` when a parameter is infinite or not a number, or the result overflows
///   the number type
/// \throws Error `work_limit` when exact numbers are so long that the limit does not suffice
template <class Traits, int Degree>
Bezier_curve<Traits, Degree> extend(const Bezier_curve<Traits, Degree>& left, Frenet_order order,
                                    const Extension_parameters<typename Traits::FT>& parameters = {}) {
  typedef typename Traits::FT FT;
  const FT& beta = parameters.beta;
  const Tangent_alternative<Traits> tangent = tangent_alternative(left, beta);
  std::vector<Geometric_continuity::Coordinates<Traits>> b = internal::continued_polygon(left, beta);
  const auto move = [&b](int j, const typename Traits::Point& place) {
    internal::move_point(b, j, Geometric_continuity::coordinates<Traits>(place));
  };
  move(1, tangent.point());
  if (order >= Frenet_order::curvature) {
    const Curvature_alternatives<Traits> line = curvature_alternatives(left, beta);
    const FT c0 = parameters.c0.value_or(line.ck_parameter());
    move(2, line.point_at(c0));
    if (order >= Frenet_order::torsion) {
      const Torsion_alternatives<Traits> plane = torsion_alternatives(left, c0, beta);
      const FT c2 = parameters.c2.value_or(plane.g3_parameters().c2),
               c1 = parameters.c1.value_or(connection_c1<FT>(left.degree(), beta, c0, c2, FT(0)));
      move(3, plane.point_at({c1, c2}));
    }
  }
  return internal::next_segment(left, beta, b);
}

namespace internal {

// Returns the part of a rational curve that an extension of this order reads: its Taylor
// polynomial, of its degree or of that order.
template <class Traits, int Degree>
Bezier_curve<Traits> polynomial_at_end(const Rational_bezier_curve<Traits, Degree>& left, Frenet_order order) {
  if (left.is_polynomial()) return *left.polynomial();
  return taylor_polynomial_at_end(left, (std::max)(left.degree(), static_cast<int>(order)));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the next segment of a chain behind a rational curve: a polynomial one, which `extend()`
/// makes from the Taylor polynomial of `left` at its end, see `taylor_polynomial_at_end()`. Its
/// degree is that of `left`, or the order if that is higher. With equal weights it is that of the
/// polynomial curve.
/// \throws Error `nonpositive_beta`, `zero_tangent`, `not_finite`, `work_limit` as `extend()` of a
///   Bézier curve
template <class Traits, int Degree>
Bezier_curve<Traits> extend(const Rational_bezier_curve<Traits, Degree>& left, Frenet_order order,
                            const Extension_parameters<typename Traits::FT>& parameters = {}) {
  return extend(internal::polynomial_at_end(left, order), order, parameters);
}

namespace internal {

template <class Traits, int Degree>
std::vector<Bezier_curve<Traits>> segments_of(const Composite_bezier_curve<Traits, Degree>& curve) {
  std::vector<Bezier_curve<Traits>> segments;
  for (int l = 0; l < curve.number_of_segments(); ++l) segments.push_back(curve.segment(l));
  return segments;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the segmented curve with one more segment, which `extend()` makes from the last one. In
/// the global parameter \f$ \beta \f$ is the ratio of the lengths of the two parameter intervals.
/// \throws Error `wrong_number_of_points`, `nonpositive_beta`, `zero_tangent`, `not_finite`,
///   `work_limit` as `extend()` of a Bézier curve
template <class Traits, int Degree>
Composite_bezier_curve<Traits, Degree> extend(const Composite_bezier_curve<Traits, Degree>& curve, Frenet_order order,
                                              const Extension_parameters<typename Traits::FT>& parameters = {}) {
  std::vector<Bezier_curve<Traits>> segments = internal::segments_of(curve);
  segments.push_back(extend(segments.back(), order, parameters));
  return Composite_bezier_curve<Traits, Degree>(segments.begin(), segments.end());
}

namespace internal {

// The curve over the knots of both, with the end of the curve repeated p times. The segment starts
// where the clamped curve ends.
template <class Traits>
Bspline_curve<Traits> with_segment(const Bspline_curve<Traits>& clamped, const Bezier_curve<Traits>& segment) {
  typedef typename Traits::FT FT;
  std::vector<typename Traits::Point> points(clamped.begin(), clamped.end());
  points.insert(points.end(), segment.begin() + 1, segment.end());
  std::vector<FT> knots(clamped.knots().begin(), clamped.knots().end() - 1);
  knots.insert(knots.end(), clamped.degree() + 1, segment.domain().second);
  return {points.begin(), points.end(), Knot_vector<FT>(clamped.degree(), std::move(knots))};
}

// A rational curve with a polynomial segment behind its clamped form, raised to the degree of the
// curve.
template <class Traits>
Rational_bspline_curve<Traits> with_segment(const Rational_bspline_curve<Traits>& clamped,
                                            const Bezier_curve<Traits>& segment, const char* place) {
  typedef typename Rational_bspline_curve<Traits>::Homogeneous::Point Row;
  if (segment.degree() > clamped.degree())
    throw Error(Error_code::wrong_number_of_points,
                std::string(place) + ": the order exceeds the degree " + std::to_string(clamped.degree()));
  const typename Traits::FT weight = clamped.weights().back();
  const auto homogeneous =
      Rational_bezier_curve<Traits>(segment).homogeneous().transform([&](const Row& p) { return Row(weight * p); });
  return Rational_bspline_curve<Traits>(with_segment(clamped.homogeneous(), homogeneous));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the rational B-spline curve with one more segment, a polynomial one, which `extend()`
/// makes from the rational Bézier curve on the last span; knots as for a B-spline curve.
/// \throws Error `wrong_number_of_points` when the order exceeds the degree, `nonpositive_beta`,
///   `zero_tangent`, `not_finite` as `extend()` of a Bézier curve
template <class Traits>
Rational_bspline_curve<Traits> extend(const Rational_bspline_curve<Traits>& curve, Frenet_order order,
                                      const Extension_parameters<typename Traits::FT>& parameters = {}) {
  const Rational_bspline_curve<Traits> clamped = curve.clamp();
  return internal::with_segment(clamped, extend(clamped.bezier_pieces().back(), order, parameters), "extend");
}

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the B-spline curve with one more segment, which `extend()` makes from the Bézier curve
/// on the last span. It is clamped; its domain \f$ [a, b] \f$ grows by \f$ \beta \f$ times the
/// length of that span. The inner knots stay, and the join at `b` becomes a knot of multiplicity
/// `p`, because a join with geometric continuity is in general no smoother in the parameter;
/// `Bspline_curve::remove_superfluous_knots()` leaves those that are needed. A clamped curve keeps
/// its control points. For the Bézier curve on the last span \f$ O(n p^3) \f$.
/// \throws Error `wrong_number_of_points`, `nonpositive_beta`, `zero_tangent`, `not_finite`,
///   `work_limit` as `extend()` of a Bézier curve
template <class Traits>
Bspline_curve<Traits> extend(const Bspline_curve<Traits>& curve, Frenet_order order,
                             const Extension_parameters<typename Traits::FT>& parameters = {}) {
  const Bspline_curve<Traits> clamped = curve.clamp();
  return internal::with_segment(clamped, extend(clamped.bezier_pieces().back(), order, parameters));
}

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the segment on [0, 1] that leads from the end of the curve `last` back to the start of
/// the curve `first`, with the wanted continuity at both joins: for the tangent the cubic with the
/// end tangents \f$ \beta x' \f$ and \f$ \eta y' \f$, for the curvature the quintic blend of least
/// \f$ \int |\gamma'''|^2 \f$, for the torsion the \f$ G^3 \f$ septic blend of least
/// \f$ \int |\gamma^{(4)}|^2 \f$.
/// \tparam Left, Right models of `ParametricCurve` with one traits class
/// \throws Error `nonpositive_beta` unless \f$ \beta > 0 \f$ and \f$ \eta > 0 \f$,
///   `dimension_mismatch`, `zero_tangent` when an end tangent is zero, `not_finite` when a shape
///   parameter is infinite or the result overflows
template <class Left, class Right>
Bezier_curve<typename Left::Traits> close(const Left& last, const Right& first, Frenet_order order,
                                          const Shape_parameters<typename Left::Traits::FT>& shape = {}) {
  typedef typename Left::Traits Traits;
  if (order == Frenet_order::torsion) return blend(last, first, Minimal_energy_g3<4>(), shape);
  if (order == Frenet_order::curvature) return blend(last, first, Minimal_energy<3>(), shape);
  typedef typename Traits::FT FT;
  Curve_jet<Traits> x(end_jet<FT>(last, 1)), y(start_jet<FT>(first, 1));
  internal::check_blend_input(x, y, 1, shape);
  x[1] *= shape.beta;
  y[1] *= shape.eta;
  std::vector<typename Traits::Point> points = start_control_points(x, 3);
  const std::vector<typename Traits::Point> end = end_control_points(y, 3);
  points.insert(points.end(), end.begin(), end.end());
  return {points.begin(), points.end()};
}

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the closed curve with one more segment, which `close()` makes from the last one to the
/// first. It takes a parameter interval of length 1; all segments get the highest degree.
/// \throws Error `nonpositive_beta`, `zero_tangent`, `not_finite` as `close()` of two curves
template <class Traits, int Degree>
Composite_bezier_curve<Traits> close(const Composite_bezier_curve<Traits, Degree>& curve, Frenet_order order,
                                     const Shape_parameters<typename Traits::FT>& shape = {}) {
  std::vector<Bezier_curve<Traits>> segments = internal::segments_of(curve);
  segments.push_back(close(segments.back(), segments.front(), order, shape));
  return Composite_bezier_curve<Traits>(segments.begin(), segments.end());
}

namespace internal {

// One degree of freedom of a polygon: the point b_index may move along a direction.
template <class Vector> struct Freedom {
  int index;
  Vector direction;
};

// Moves the points of the polygon b along the given directions so that the integral of |gamma''|^2
// becomes least. b_0 and b_1 do not move, and the directions of one point are independent.
template <class FT, int N>
void minimize_energy(std::vector<Coordinate_vector<FT, N>>& b,
                     const std::vector<Freedom<Coordinate_vector<FT, N>>>& free) {
  const int m = static_cast<int>(b.size()) - 1;
  const Second_derivative_products<FT> products(m);
  Work_meter* const work = scope_of<FT>();
  std::vector<std::vector<FT>> a(free.size());
  std::vector<FT> rhs;
  for (std::size_t k = 0; k < free.size(); ++k) {
    const std::vector<FT> row = products.row(free[k].index);
    const std::size_t words = work ? most_words(free[k].direction) : 0;
    if (work) work->charge_fractions(static_cast<double>(free.size()) * free[k].direction.dimension(), 2 * words);
    for (const Freedom<Coordinate_vector<FT, N>>& other : free)
      a[k].push_back(FT(row[other.index] * dot(free[k].direction, other.direction)));
    FT sum(0);
    for (int j = 0; j <= m; ++j) {
      sum -= row[j] * dot(free[k].direction, b[j]);
      if (work) work->charge_fractions(b[j].dimension() + 1., number_words(sum), most_words(b[j]) + words);
    }
    rhs.push_back(sum);
  }
  const std::vector<FT> x = solve_positive_definite(std::move(a), std::move(rhs));
  for (std::size_t k = 0; k < free.size(); ++k) b[free[k].index] += x[k] * free[k].direction;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the next segment of a chain behind `left` that leads to a wished point: of the same
/// degree `m`, on the domain \f$ [b, b + \beta (b - a)] \f$ behind \f$ [a, b] \f$, with the wanted
/// continuity `k`. When `m > k` it ends at the point; when `m == k` it ends at the nearest member
/// of the family of alternatives. All that is free otherwise, the scalars of the families and the
/// points between, has the least energy \f$ \int |\gamma''|^2 \f$: an exact linear system in at
/// most `3 + n (m - k - 1)` unknowns in dimension `n`, never singular, solved by elimination.
/// \throws Error `wrong_number_of_points` when `m < k`, `nonpositive_beta` unless
///   \f$ \beta > 0 \f$, `zero_tangent` when the last two control points are equal,
///   `dimension_mismatch`, `not_finite` when the result overflows the number type; `work_limit` in
///   a `Work_scope`
template <class Traits, int Degree>
Bezier_curve<Traits, Degree> extend_toward(const Bezier_curve<Traits, Degree>& left, Frenet_order order,
                                           const typename Traits::Point& wished,
                                           const typename Traits::FT& beta = typename Traits::FT(1)) {
  typedef typename Traits::FT FT;
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;
  const int m = left.degree(), k = static_cast<int>(order), n = left.dimension();
  const Tangent_alternative<Traits> tangent = tangent_alternative(left, beta);
  const Coordinates end = Geometric_continuity::coordinates<Traits>(wished);
  if (end.dimension() != n) throw Error(Error_code::dimension_mismatch, "extend_toward: the wished point");

  std::vector<Coordinates> b{left.coordinates(m), Geometric_continuity::coordinates<Traits>(tangent.point())};
  std::vector<internal::Freedom<Coordinates>> free;
  if (order >= Frenet_order::curvature) {
    const Curvature_alternatives<Traits> line = curvature_alternatives(left, beta);
    const FT c0 = m == 2 ? line.nearest_parameter(wished) : FT(0);
    b.push_back(Geometric_continuity::coordinates<Traits>(line.point_at(c0)));
    if (m > 2) free.push_back({2, Geometric_continuity::coordinates<Traits>(line.direction())});
  }
  if (order >= Frenet_order::torsion) {
    const Torsion_alternatives<Traits> plane = torsion_alternatives(left, FT(0), beta);
    const Torsion_parameters<FT> c = m == 3 ? plane.nearest_parameters(wished) : Torsion_parameters<FT>{FT(0), FT(0)};
    b.push_back(Geometric_continuity::coordinates<Traits>(plane.point_at(c)));
    if (m > 3) free.push_back({3, Geometric_continuity::coordinates<Traits>(plane.directions().first)});
    if (m > 3 && !plane.is_line())
      free.push_back({3, Geometric_continuity::coordinates<Traits>(plane.directions().second)});
  }
  for (int j = k + 1; j < m; ++j) {
    b.push_back(Coordinates(n));
    for (int i = 0; i < n; ++i) {
      Coordinates axis(n);
      axis[i] = FT(1);
      free.push_back({j, axis});
    }
  }
  if (m > k) b.push_back(end);
  internal::minimize_energy(b, free);
  return internal::next_segment(left, beta, b);
}

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the next segment of a chain behind a rational curve that leads to a wished point: a
/// polynomial one, which `extend_toward()` makes from the Taylor polynomial of `left` at its end,
/// as `extend()` of a rational curve.
/// \throws Error `nonpositive_beta`, `zero_tangent`, `dimension_mismatch`, `not_finite` as
///   `extend_toward()` of a Bézier curve
template <class Traits, int Degree>
Bezier_curve<Traits> extend_toward(const Rational_bezier_curve<Traits, Degree>& left, Frenet_order order,
                                   const typename Traits::Point& wished,
                                   const typename Traits::FT& beta = typename Traits::FT(1)) {
  return extend_toward(internal::polynomial_at_end(left, order), order, wished, beta);
}

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the rational B-spline curve with one more segment, a polynomial one, which
/// `extend_toward()` makes from the rational Bézier curve on the last span.
/// \throws Error `wrong_number_of_points` when the order exceeds the degree, otherwise as
///   `extend_toward()` of a Bézier curve
template <class Traits>
Rational_bspline_curve<Traits> extend_toward(const Rational_bspline_curve<Traits>& curve, Frenet_order order,
                                             const typename Traits::Point& wished,
                                             const typename Traits::FT& beta = typename Traits::FT(1)) {
  const Rational_bspline_curve<Traits> clamped = curve.clamp();
  return internal::with_segment(clamped, extend_toward(clamped.bezier_pieces().back(), order, wished, beta),
                                "extend_toward");
}

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the segmented curve with one more segment, which `extend_toward()` makes from the last
/// one. In the global parameter \f$ \beta \f$ is the ratio of the lengths of the two parameter
/// intervals.
/// \throws Error `wrong_number_of_points`, `nonpositive_beta`, `zero_tangent`,
///   `dimension_mismatch`, `not_finite` as `extend_toward()` of a Bézier curve
template <class Traits, int Degree>
Composite_bezier_curve<Traits, Degree> extend_toward(const Composite_bezier_curve<Traits, Degree>& curve,
                                                     Frenet_order order, const typename Traits::Point& wished,
                                                     const typename Traits::FT& beta = typename Traits::FT(1)) {
  std::vector<Bezier_curve<Traits>> segments = internal::segments_of(curve);
  segments.push_back(extend_toward(segments.back(), order, wished, beta));
  return Composite_bezier_curve<Traits, Degree>(segments.begin(), segments.end());
}

/// \ingroup PkgGeometricContinuityExtensions
/// Returns the B-spline curve with one more segment, which `extend_toward()` makes from the Bézier
/// curve on the last span. It is clamped, and the join becomes a knot of multiplicity `p`, as by
/// `extend()` of a B-spline curve.
/// \throws Error `wrong_number_of_points`, `nonpositive_beta`, `zero_tangent`,
///   `dimension_mismatch`, `not_finite` as `extend_toward()` of a Bézier curve
template <class Traits>
Bspline_curve<Traits> extend_toward(const Bspline_curve<Traits>& curve, Frenet_order order,
                                    const typename Traits::Point& wished,
                                    const typename Traits::FT& beta = typename Traits::FT(1)) {
  const Bspline_curve<Traits> clamped = curve.clamp();
  return internal::with_segment(clamped, extend_toward(clamped.bezier_pieces().back(), order, wished, beta));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_EXTEND_H
