// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_EXTEND_H
#define CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_EXTEND_H

#include <CGAL/Geometric_continuity/algebra/internal/solve_positive_definite.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/septic_strategies.h>
#include <CGAL/Geometric_continuity/curves/end_control_points.h>
#include <CGAL/Geometric_continuity/extensions/alternatives.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_conversion.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// What a join shall keep continuous, each with all before it: \f$ F^1 \f$, \f$ F^2 \f$, \f$ F^3 \f$.
enum class Frenet_order {
  tangent = 1,   ///< the direction of the tangent
  curvature = 2, ///< the curvature vector
  torsion = 3    ///< the Frenet frame, the curvature and the torsion
};

/// \ingroup PkgGeometricContinuityConstruction
/// The ratio and the members of the families of alternatives that a next segment takes. What is not given is that of the
/// smoothest join: \f$ C_0 \f$ of the \f$ C^2 \f$ member, \f$ C_2 \f$ of the \f$ G^3 \f$ member and \f$ C_1 \f$ with
/// \f$ \delta = 0 \f$.
template <class FT> struct Extension_parameters {
  FT beta = FT(1);          ///< the length of the domain of the next segment, that of the last one being 1
  std::optional<FT> c0;     ///< chooses \f$ b_2 \f$, see `Curvature_alternatives`
  std::optional<FT> c1, c2; ///< choose \f$ b_3 \f$, see `Torsion_alternatives`
};

namespace internal {

// The polygon of the polynomial `left` itself on the interval behind its domain that is beta times as long.
template <class Traits, int Degree>
std::vector<Coordinates<Traits>> continued_polygon(const Bezier_curve<Traits, Degree>& left,
                                                   const typename Traits::FT& beta) {
  typedef typename Traits::FT FT;
  std::vector<Coordinates<Traits>> b, before;
  for (int j = 0; j <= left.degree(); ++j) b.push_back(left.coordinates(j));
  before.resize(b.size());
  bernstein_split<FT>(b, left.degree(), FT(FT(1) + beta), before); // b: from 1 + beta back to 1
  std::reverse(b.begin(), b.end());
  return b;
}

// Moves b_j to its new place and the points behind it so that only the j-th derivative at the start changes.
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

// One degree of freedom of a polygon: the point b_index may move along a direction.
template <class Vector> struct Freedom {
  int index;
  Vector direction;
};

// Moves the points of the polygon b along the given directions so that the integral of |gamma''|^2 becomes least.
// \pre b_0 and b_1 do not move, and the directions of one point are independent
template <class FT, int N>
void minimize_energy(std::vector<Coordinate_vector<FT, N>>& b,
                     const std::vector<Freedom<Coordinate_vector<FT, N>>>& free) {
  const int m = static_cast<int>(b.size()) - 1;
  std::vector<std::vector<FT>> products(m + 1, std::vector<FT>(m + 1)), a(free.size());
  for (int i = 2; i <= m; ++i)
    for (int j = 0; j <= m; ++j) products[i][j] = second_derivative_product<FT>(m, i, j);
  std::vector<FT> rhs;
  for (std::size_t k = 0; k < free.size(); ++k) {
    const std::vector<FT>& row = products[free[k].index];
    for (const Freedom<Coordinate_vector<FT, N>>& other : free)
      a[k].push_back(FT(row[other.index] * dot(free[k].direction, other.direction)));
    FT sum(0);
    for (int j = 0; j <= m; ++j) sum -= row[j] * dot(free[k].direction, b[j]);
    rhs.push_back(sum);
  }
  const std::vector<FT> x = solve_positive_definite(std::move(a), std::move(rhs));
  for (std::size_t k = 0; k < free.size(); ++k) b[free[k].index] += x[k] * free[k].direction;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// The next segment of a chain behind `left`: of the same degree `m`, on the domain \f$ [b, b + \beta (b - a)] \f$ behind
/// \f$ [a, b] \f$, with the wanted continuity. Its first points are the given members of the families of alternatives; its
/// derivatives beyond the wanted order are those of `left`. Without given parameters this is the polynomial `left` itself,
/// continued, for every order. \f$ O(m^2) \f$
/// \throws Error `wrong_number_of_points` when `m` is less than the order (the family does not exist), `nonpositive_beta` unless
///   \f$ \beta > 0 \f$, `zero_tangent`, `not_finite` when the result overflows the number type
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

/// \ingroup PkgGeometricContinuityConstruction
/// The next segment of a chain behind `left` that leads to a wished point: of the same degree `m`, on the domain
/// \f$ [b, b + \beta (b - a)] \f$ behind \f$ [a, b] \f$, with the wanted continuity `k`. When `m > k` it ends at the point; when
/// `m == k` it ends at the nearest member of the family of alternatives. All that is free otherwise, the scalars of the
/// families and the points between, has the least energy \f$ \int |\gamma''|^2 \f$: an exact linear system in at most
/// `3 + n (m - k - 1)` unknowns in dimension `n`, never singular, solved by elimination.
/// \throws Error like `extend()`, `dimension_mismatch`
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

/// \ingroup PkgGeometricContinuityConstruction
/// The segment on [0, 1] that leads from the end of the curve `last` back to the start of the curve `first`, with the wanted
/// continuity at both joins: for the tangent the cubic with the end tangents \f$ \beta x' \f$ and \f$ \eta y' \f$, for the
/// curvature the quintic blend of least \f$ \int |\gamma'''|^2 \f$, for the torsion the \f$ G^3 \f$ septic blend of least
/// \f$ \int |\gamma^{(4)}|^2 \f$.
/// \tparam Left, Right models of `ParametricCurve` with one traits class
/// \throws Error like `blend()`
template <class Left, class Right>
Bezier_curve<typename Left::Traits> close(const Left& last, const Right& first, Frenet_order order,
                                          const Shape_parameters<typename Left::Traits::FT>& shape = {}) {
  typedef typename Left::Traits Traits;
  if (order == Frenet_order::torsion) return blend(last, first, Minimal_energy_g3<4>(), shape);
  if (order == Frenet_order::curvature) return blend(last, first, Minimal_energy<3>(), shape);
  Curve_jet<Traits> x = last.jet(last.domain().second, 1), y = first.jet(first.domain().first, 1);
  internal::check_blend_input(x, y, 1, shape);
  x[1] *= shape.beta;
  y[1] *= shape.eta;
  std::vector<typename Traits::Point> points = start_control_points(x, 3);
  const std::vector<typename Traits::Point> end = end_control_points(y, 3);
  points.insert(points.end(), end.begin(), end.end());
  return {points.begin(), points.end()};
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_EXTEND_H
