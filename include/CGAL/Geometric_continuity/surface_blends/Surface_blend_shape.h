// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_SURFACE_BLEND_SHAPE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_SURFACE_BLEND_SHAPE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/blend_ends.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/surface_blends/Edge_function.h>
#include <CGAL/Geometric_continuity/surface_blends/internal/Blend_end.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Surface_blend_shape.h
/// The functions along its edges that \f$ G^2 \f$ leaves free of a blend surface, the types of such
/// surfaces, and the shape for which the caller gives none, by the strategies for blends of curves.
///
/// The curves `u` = const at some parameters \f$ u_1, \dots, u_m \f$ together are one curve
/// \f$ v \mapsto (S(u_1, v), \dots, S(u_m, v)) \f$ in a space of `3 m` dimensions. With constants
/// \f$ \beta, \delta \f$ it is a blend of the curves that both surfaces make in the same way, of
/// the family of blends of curves: \f$ \delta = (20 s - t)\,\beta \f$, with the part `t` of the
/// second derivative along the tangent. So each strategy for curves is one for surfaces. Lengths
/// and energies are the sums of squares over the curves. In degree 7 \f$ \delta = \beta_2 \f$ and
/// \f$ \delta_3 = \beta_3 \f$ of a septic blend with \f$ \mu = 3 \beta\beta_2 \f$.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// The way in which a blend leaves the parameters of a surface along an edge, or enters them:
/// \f$ \varphi(u, v) = (u + \alpha v + \frac12 \alpha_2 v^2,\ \beta v + \frac12 \delta v^2) \f$ to
/// second order, with functions of the parameter along the edge: numbers, polynomials or splines on
/// the domain of the edge, which is mapped to [0, 1].
/// \tparam FT_ a field number type
template <class FT_> struct Edge_reparametrisation {
  typedef FT_ FT;                     ///< the number type
  typedef Edge_function<FT> Function; ///< of the parameter along the edge

  Function alpha = Function{FT(0)};  ///< the first derivative along the edge
  Function beta = Function{FT(1)};   ///< the first derivative across the edge, positive
  Function alpha2 = Function{FT(0)}; ///< the second derivative along the edge
  Function delta = Function{FT(0)};  ///< the second derivative across the edge
};

/// \ingroup PkgGeometricContinuityConstruction
/// The way in which a blend leaves the parameters of a rational surface:
/// \f$ S = \lambda \cdot L \circ \varphi \f$ in homogeneous points, to second order, with the
/// factors \f$ \lambda_0 \f$ and \f$ 1 + \lambda_1 v + \frac12 \lambda_2 v^2 \f$.
/// \tparam FT a field number type
template <class FT> struct Rational_edge_reparametrisation : Edge_reparametrisation<FT> {
  /// of the parameter along the edge
  typedef typename Edge_reparametrisation<FT>::Function Function;

  FT lambda = FT(1);                  ///< the factor at the edge, positive
  Function lambda1 = Function{FT(0)}; ///< the first derivative of the other factor across the edge
  Function lambda2 = Function{FT(0)}; ///< its second derivative

  /// Sets \f$ \beta \f$ to 1 and all others to 0.
  Rational_edge_reparametrisation() = default;
  /// With the factor 1.
  Rational_edge_reparametrisation(const Edge_reparametrisation<FT>& r) : Edge_reparametrisation<FT>(r) {}
};

/// \ingroup PkgGeometricContinuityConstruction
/// The shape of a blend surface: all that \f$ G^2 \f$ leaves free at its two edges.
/// \tparam FT a field number type
template <class FT> struct Surface_blend_shape {
  Edge_reparametrisation<FT> start; ///< at the edge of the first surface
  Edge_reparametrisation<FT> end;   ///< at the edge of the second surface
};

/// \ingroup PkgGeometricContinuityConstruction
/// The shape of a rational blend surface: all that \f$ G^2 \f$ leaves free at its two edges.
/// \tparam FT a field number type
template <class FT> struct Rational_surface_blend_shape {
  Rational_edge_reparametrisation<FT> start; ///< at the edge of the first surface
  Rational_edge_reparametrisation<FT> end;   ///< at the edge of the second surface

  /// Sets all functions \f$ \beta \f$ to 1 and all others to 0.
  Rational_surface_blend_shape() = default;
  /// Takes the reparametrisations of both ends.
  Rational_surface_blend_shape(const Rational_edge_reparametrisation<FT>& given_start,
                               const Rational_edge_reparametrisation<FT>& given_end)
      : start(given_start), end(given_end) {}
  /// With the factor 1 at both ends.
  Rational_surface_blend_shape(const Surface_blend_shape<FT>& shape) : start(shape.start), end(shape.end) {}
};

/// \ingroup PkgGeometricContinuityConstruction
/// The functions that \f$ G^3 \f$ leaves free at an edge of a blend surface, in addition to a
/// reparametrisation of order 2: the third derivatives of \f$ \varphi \f$, which are
/// \f$ (\alpha_3, \delta_3) \f$, and that of the factor of homogeneous points.
/// \tparam Reparametrisation `Edge_reparametrisation` or `Rational_edge_reparametrisation`
template <class Reparametrisation> struct Septic_edge_reparametrisation : Reparametrisation {
  typedef typename Reparametrisation::FT FT;             ///< the number type
  typedef typename Reparametrisation::Function Function; ///< of the parameter along the edge

  Function alpha3 = Function{FT(0)}; ///< the third derivative along the edge
  Function delta3 = Function{FT(0)}; ///< the third derivative across the edge
  // the third derivative of the factor of a rational surface across the edge; not used for others
  Function lambda3 = Function{FT(0)};

  /// Sets \f$ \beta \f$ to 1 and all others to 0.
  Septic_edge_reparametrisation() = default;
  /// With third derivatives that are 0.
  Septic_edge_reparametrisation(const Reparametrisation& r) : Reparametrisation(r) {}
};

/// \ingroup PkgGeometricContinuityConstruction
/// The shape of a blend surface of degree 7 across: all that \f$ G^3 \f$ leaves free at its two
/// edges.
/// \tparam Shape `Surface_blend_shape` or `Rational_surface_blend_shape`
template <class Shape> struct Septic_surface_blend_shape {
  typedef Septic_edge_reparametrisation<decltype(Shape::start)> Reparametrisation; ///< at one edge

  Reparametrisation start; ///< at the edge of the first surface
  Reparametrisation end;   ///< at the edge of the second surface

  /// Sets all functions \f$ \beta \f$ to 1 and all others to 0.
  Septic_surface_blend_shape() = default;
  /// With third derivatives that are 0.
  Septic_surface_blend_shape(const Shape& shape) : start(shape.start), end(shape.end) {}
};

namespace internal {

template <class A, class B> struct Blended_shape {
  typedef typename A::FT FT;
  typedef std::conditional_t<Blended_surfaces<A, B>::is_rational, Rational_surface_blend_shape<FT>,
                             Surface_blend_shape<FT>>
      type;
};

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// The type of the blend of two surfaces: `Bezier_patch` or `Rational_bezier_patch` of two patches,
/// otherwise `Bspline_surface` or `Rational_bspline_surface`; rational if one of them is.
template <class Surface_a, class Surface_b>
using Blend_surface = typename internal::Blended_surfaces<Surface_a, Surface_b>::Surface;

/// \ingroup PkgGeometricContinuityConstruction
/// The type of the shape of the blend of two surfaces: `Rational_surface_blend_shape` if one of
/// them is rational, otherwise `Surface_blend_shape`.
template <class Surface_a, class Surface_b>
using Blend_surface_shape = typename internal::Blended_shape<Surface_a, Surface_b>::type;

/// \ingroup PkgGeometricContinuityStrategies
/// True for a strategy that chooses the shape of blend surfaces of degree 5: it can be called with
/// `Quintic_ends<double, 0>`.
template <class Strategy>
constexpr bool is_quintic_surface_strategy_v = std::is_invocable_v<const Strategy&, const Quintic_ends<double, 0>&>;

/// \ingroup PkgGeometricContinuityStrategies
/// True for a strategy that chooses the shape of blend surfaces, of degree 5 or else of degree 7:
/// it can be called with `Quintic_ends<double, 0>` or `Septic_ends<double, 0>`.
template <class Strategy>
constexpr bool is_surface_blend_strategy_v =
    std::disjunction_v<std::is_invocable<const Strategy&, const Quintic_ends<double, 0>&>,
                       std::is_invocable<const Strategy&, const Septic_ends<double, 0>&>>;

/// \ingroup PkgGeometricContinuityConstruction
/// The type of the shape that a strategy chooses for the blend of two surfaces:
/// `Blend_surface_shape`, or the `Septic_surface_blend_shape` of it.
template <class Surface_a, class Surface_b, class Strategy>
using Chosen_surface_shape =
    std::conditional_t<is_quintic_surface_strategy_v<Strategy>, Blend_surface_shape<Surface_a, Surface_b>,
                       Septic_surface_blend_shape<Blend_surface_shape<Surface_a, Surface_b>>>;

namespace internal {

// The values of the rows of an end at the Greville abscissae of some knots: as points and
// derivatives of the surface in `jet`, one after the other, and the last coordinates of homogeneous
// points in `weights`.
template <bool is_rational> struct Edge_samples {
  Coordinate_jet<double, 0> jet;
  std::vector<std::array<double, 4>> weights;

  template <class FT, int N> Edge_samples(const Blend_end<FT, N>& end, const Knot_vector<FT>& knots, int order) {
    const int m = knots.number_of_coefficients(), n = end.edge[0].dimension() - (is_rational ? 1 : 0);
    jet = Coordinate_jet<double, 0>(m * n, order);
    for (int k = 0; k < m; ++k) {
      const FT u = knots.greville_abscissa(k);
      Coordinate_jet<FT, N> x(end.edge[0].dimension(), order);
      const typename Blend_end<FT, N>::Row* const rows[] = {&end.edge, &end.cross, &end.second_cross, &end.third_cross};
      for (int j = 0; j <= order; ++j) x[j] = bspline_value(end.knots, *rows[j], u);
      if constexpr (is_rational) {
        weights.emplace_back();
        for (int j = 0; j <= order; ++j) weights.back()[j] = CGAL::to_double(x[j][n]);
        take(project(x), k * n);
      } else
        take(x, k * n);
    }
  }

private:
  template <class Jet> void take(const Jet& x, int first) {
    for (int j = 0; j <= jet.order(); ++j)
      for (int i = 0; i < x[j].dimension(); ++i) {
        jet[j][first + i] = CGAL::to_double(x[j][i]);
        check_finite(jet[j][first + i], "automatic_surface_shape: a number beyond those in floating-point arithmetic");
      }
  }
};

// Returns the rows of both edges at the Greville abscissae of the edge that has more of them.
template <class Kind, class A, class B>
std::pair<Edge_samples<Kind::is_rational>, Edge_samples<Kind::is_rational>>
sampled_ends(const A& a, Patch_edge edge_a, const B& b, Patch_edge edge_b, Edge_direction direction, int order) {
  const auto ends = Kind::ends(a, edge_a, b, edge_b, direction, order);
  const auto &x = ends.first.knots, &y = ends.second.knots;
  const auto& knots = x.number_of_coefficients() < y.number_of_coefficients() ? y : x;
  std::pair<Edge_samples<Kind::is_rational>, Edge_samples<Kind::is_rational>> samples({ends.first, knots, order},
                                                                                      {ends.second, knots, order});
  if (is_zero(samples.first.jet[1]))
    throw Error(Error_code::zero_tangent, "automatic_surface_shape: the first surface");
  if (is_zero(samples.second.jet[1]))
    throw Error(Error_code::zero_tangent, "automatic_surface_shape: the second surface");
  return samples;
}

// With few binary digits; nothing where it is small in comparison with the unit.
inline double short_part(double x, double unit) {
  check_finite(x, "automatic_surface_shape");
  return std::abs(x) < 0x1p-20 * unit ? 0 : short_double<ratio_digits>(x);
}

// The derivatives beta, delta and delta_3 of the parameter across an edge.
typedef std::array<double, 3> Across_edge;

inline std::array<Across_edge, 2> across_edges(const Quintic_ends<double, 0>& e, const Quintic_parameters<double>& p,
                                               const Shape_parameters<double>& s) {
  return {{{s.beta, short_part(s.beta * (20 * p.s1 - e.tangential1), s.beta), 0},
           {s.eta, short_part(s.eta * (20 * p.s2 - e.tangential2), s.eta), 0}}};
}
inline std::array<Across_edge, 2> across_edges(const Septic_ends<double, 0>&, const Septic_parameters<double>& p,
                                               const Shape_parameters<double>& s) {
  return {{{s.beta, short_part(p.start.beta2, s.beta), short_part(p.start.beta3, s.beta)},
           {s.eta, short_part(p.end.beta2, s.eta), short_part(p.end.beta3, s.eta)}}};
}

// Returns the derivatives that a strategy chooses for all curves together, whose ends are `start`
// and `end`.
template <class Strategy>
std::array<Across_edge, 2> chosen_across_edges(const Strategy& strategy, const Coordinate_jet<double, 0>& start,
                                               const Coordinate_jet<double, 0>& end) {
  typedef std::conditional_t<is_quintic_surface_strategy_v<Strategy>, Quintic_ends<double, 0>, Septic_ends<double, 0>>
      Ends;
  const auto across = [&](const auto& chosen, const Shape_parameters<double>& s) {
    const Ends e(start, end, s);
    return across_edges(e, chosen(e), s);
  };
  if constexpr (Chooses_shape<Strategy, Coordinate_jet<double, 0>>::value) {
    const auto chosen = strategy.choose(start, end);
    return across(chosen.strategy, chosen.shape);
  } else
    return across(strategy, automatic_shape(start, end));
}

template <class FT> Edge_function<FT> short_constant(double x) { return {short_number_in<FT>(x)}; }

template <class FT> void set_third(Edge_reparametrisation<FT>&, double, double) {}
template <class Reparametrisation>
void set_third(Septic_edge_reparametrisation<Reparametrisation>& r, double delta3, double lambda3) {
  typedef typename Reparametrisation::FT FT;
  r.delta3 = short_constant<FT>(delta3);
  r.lambda3 = short_constant<FT>(lambda3);
}

// Sets the constants of one end. For rational surfaces the factor of the homogeneous points keeps
// the denominator as constant as constants can: from the derivatives m of w_0 w(phi), divided by
// those of order 0, as sums over all samples.
template <class Reparametrisation>
void set_shape(Reparametrisation& r, const Across_edge& x, const std::vector<std::array<double, 4>>& weights) {
  typedef typename Reparametrisation::FT FT;
  r.beta = short_constant<FT>(x[0]);
  r.delta = short_constant<FT>(x[1]);
  double lambda[3] = {0, 0, 0};
  if constexpr (std::is_base_of_v<Rational_edge_reparametrisation<FT>, Reparametrisation>) {
    double squares = 0, m[3] = {0, 0, 0};
    for (const std::array<double, 4>& w : weights) {
      squares += w[0] * w[0];
      m[0] += w[0] * x[0] * w[1];
      m[1] += w[0] * (x[0] * x[0] * w[2] + x[1] * w[1]);
      m[2] += w[0] * (x[0] * x[0] * x[0] * w[3] + 3 * x[0] * x[1] * w[2] + x[2] * w[1]);
    }
    lambda[0] = short_part(-m[0] / squares, 1);
    lambda[1] = short_part(-(m[1] + 2 * lambda[0] * m[0]) / squares, 1);
    lambda[2] = short_part(-(m[2] + 3 * lambda[0] * m[1] + 3 * lambda[1] * m[0]) / squares, 1);
    r.lambda1 = short_constant<FT>(lambda[0]);
    r.lambda2 = short_constant<FT>(lambda[1]);
  }
  set_third(r, x[2], lambda[2]);
}

inline double mean_square_of_weights(const std::vector<std::array<double, 4>>& weights) {
  double squares = 0;
  for (const std::array<double, 4>& w : weights) squares += w[0] * w[0];
  return squares;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns how the second of two edges runs when its ends are nearer to those of the first one: in
/// the same direction unless the lines between the ends of the edges point in opposite directions.
/// \throws Error `dimension_mismatch`
template <class Surface_a, class Surface_b>
Edge_direction nearer_direction(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  typedef internal::Blended_surfaces<Surface_a, Surface_b> Kind;
  typedef typename Kind::FT FT;
  const auto ends = Kind::ends(a, edge_a, b, edge_b, Edge_direction::same);
  const auto chord = [](const auto& row) {
    if constexpr (Kind::is_rational)
      return affine_point(row.back()) - affine_point(row.front());
    else
      return row.back() - row.front();
  };
  return dot(chord(ends.first.edge), chord(ends.second.edge)) < FT(0) ? Edge_direction::opposite : Edge_direction::same;
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the shape of a blend from an edge of one surface to an edge of another one that a
/// strategy for blends of curves chooses: of degree 5, or of degree 7 by a septic strategy. All
/// functions are constants, and those of the parameter along the edge, \f$ \alpha \f$,
/// \f$ \alpha_2 \f$ and \f$ \alpha_3 \f$, are 0.
///
/// The curves `u` = const at the Greville abscissae of the edge with more of them are taken as one
/// curve in a space of many dimensions. A strategy that chooses its own shape parameters, as `Fair`
/// does, chooses \f$ \beta \f$ at both ends; otherwise they make the tangents as long as the chords
/// in the mean square, see `automatic_shape()`. The scalars \f$ s_1, s_2 \f$ of the strategy give
/// \f$ \delta \f$: with `Matching_second_derivative` it is 0, `Minimal_energy<3>` has the least sum
/// of \f$ \int |S_{vvv}|^2 dv \f$, `Fair` the least variation of the curvature of the curve in many
/// dimensions. A septic strategy gives \f$ \delta = \beta_2 \f$ and \f$ \delta_3 = \beta_3 \f$; for
/// \f$ G^3 \f$, \f$ \mu \f$ is \f$ 3\beta\beta_2 \f$, whatever it chooses. For rational surfaces,
/// the factors of the homogeneous points keep the denominator of the blend as constant as constants
/// can.
///
/// All this is computed in floating-point numbers and rounded to 8 binary digits, so that exact
/// numbers stay short. The blend is exact, whatever the shape is. Linear in the number of knots.
/// \tparam Strategy a model of `BlendStrategy`, called with `Quintic_ends<double, 0>` or, if it
///   cannot be, `Septic_ends<double, 0>`
/// \throws Error `zero_tangent` where a derivative across an edge vanishes at all these parameters,
///   `dimension_mismatch`, `not_finite` for numbers so large or small that their squares are not in
///   the range of floating-point numbers
template <class Surface_a, class Surface_b, class Strategy>
Chosen_surface_shape<Surface_a, Surface_b, Strategy>
automatic_surface_shape(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                        const Strategy& strategy, Edge_direction direction) {
  static_assert(is_surface_blend_strategy_v<Strategy>, "the strategy is one for blends in every field");
  typedef internal::Blended_surfaces<Surface_a, Surface_b> Kind;
  constexpr int order = is_quintic_surface_strategy_v<Strategy> ? 2 : 3;
  const auto [start, end] = internal::sampled_ends<Kind>(a, edge_a, b, edge_b, direction, order);
  const std::array<internal::Across_edge, 2> across = internal::chosen_across_edges(strategy, start.jet, end.jet);
  Chosen_surface_shape<Surface_a, Surface_b, Strategy> shape;
  internal::set_shape(shape.start, across[0], start.weights);
  internal::set_shape(shape.end, across[1], end.weights);
  if constexpr (Kind::is_rational)
    shape.end.lambda = typename Kind::FT(internal::short_part(
        std::sqrt(internal::mean_square_of_weights(start.weights) / internal::mean_square_of_weights(end.weights)), 0));
  return shape;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_SURFACE_BLEND_SHAPE_H
