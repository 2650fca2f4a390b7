// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_SURFACE_BLEND_SHAPE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_SURFACE_BLEND_SHAPE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/blend_ends.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/surface_blends/internal/Blend_end.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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
  typedef Edge_function<FT> Function; ///< a function of the parameter along the edge

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
  /// a function of the parameter along the edge
  typedef typename Edge_reparametrisation<FT>::Function Function;

  FT lambda = FT(1);                  ///< the factor at the edge, positive
  Function lambda1 = Function{FT(0)}; ///< the first derivative of the other factor across the edge
  Function lambda2 = Function{FT(0)}; ///< its second derivative

  /// Sets \f$ \beta \f$ to 1 and all others to 0.
  Rational_edge_reparametrisation() = default;
  /// Takes a polynomial reparametrisation, with the factor 1.
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
  /// Takes a polynomial shape, with the factor 1 at both ends.
  Rational_surface_blend_shape(const Surface_blend_shape<FT>& shape) : start(shape.start), end(shape.end) {}
};

/// \ingroup PkgGeometricContinuityConstruction
/// The functions that \f$ G^3 \f$ leaves free at an edge of a blend surface, in addition to a
/// reparametrisation of order 2: the third derivatives of \f$ \varphi \f$, which are
/// \f$ (\alpha_3, \delta_3) \f$, and that of the factor of homogeneous points.
/// \tparam Reparametrisation `Edge_reparametrisation` or `Rational_edge_reparametrisation`
template <class Reparametrisation> struct Septic_edge_reparametrisation : Reparametrisation {
  typedef typename Reparametrisation::FT FT;             ///< the number type
  typedef typename Reparametrisation::Function Function; ///< a function of the parameter along the edge

  Function alpha3 = Function{FT(0)}; ///< the third derivative along the edge
  Function delta3 = Function{FT(0)}; ///< the third derivative across the edge
  // the third derivative of the factor of a rational surface across the edge; not used for others
  Function lambda3 = Function{FT(0)};

  /// Sets \f$ \beta \f$ to 1 and all others to 0.
  Septic_edge_reparametrisation() = default;
  /// Takes numbers up to order 2; the third derivatives are 0.
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
  /// Takes numbers up to order 2; the third derivatives are 0.
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
/// Chooses the fairest blend of two surfaces among those with constants for functions that have no
/// fold: the least mean of the variations of curvature of the curves `u` = const, see
/// `mean_fairness()`. Of surfaces only.
///
/// It starts from those shapes of `Matching_second_derivative`, `Minimal_energy<2>`,
/// `Minimal_energy<3>` and `Fair` for which `possible_fold()` proves that there is no fold. From
/// each \f$ \beta \f$ and \f$ \delta \f$ at both ends are improved by the method of Levenberg
/// and Marquardt, where no step leads into a fold, and \f$ \beta \f$ stays within a factor of 4 of
/// the automatic shape; the least mean is taken. So it is never less fair than these, and has no
/// fold where one of the four has none. Where all have one, it is the fairest of what was found, as
/// it is in other dimensions than 3.
struct Fairest {};

/// \ingroup PkgGeometricContinuityStrategies
/// True for a strategy that chooses the shape of blend surfaces of degree 5: `Fairest`, or one that
/// can be called with `Quintic_ends<double, 0>`.
template <class Strategy>
constexpr bool is_quintic_surface_strategy_v =
    std::disjunction_v<std::is_same<Strategy, Fairest>,
                       std::is_invocable<const Strategy&, const Quintic_ends<double, 0>&>>;

/// \ingroup PkgGeometricContinuityStrategies
/// True for a strategy that chooses the shape of blend surfaces, of degree 5 or else of degree 7:
/// `Fairest`, or one that can be called with `Quintic_ends<double, 0>` or `Septic_ends<double, 0>`.
template <class Strategy>
constexpr bool is_surface_blend_strategy_v =
    std::disjunction_v<std::is_same<Strategy, Fairest>,
                       std::is_invocable<const Strategy&, const Quintic_ends<double, 0>&>,
                       std::is_invocable<const Strategy&, const Septic_ends<double, 0>&>>;

/// \ingroup PkgGeometricContinuityConstruction
/// The type of the shape that a strategy chooses for the blend of two surfaces:
/// `Blend_surface_shape`, or the `Septic_surface_blend_shape` of it.
template <class Surface_a, class Surface_b, class Strategy>
using Chosen_surface_shape =
    std::conditional_t<is_quintic_surface_strategy_v<Strategy>, Blend_surface_shape<Surface_a, Surface_b>,
                       Septic_surface_blend_shape<Blend_surface_shape<Surface_a, Surface_b>>>;

namespace internal {

// The values of the rows of an end at some parameters: as points and derivatives of the surface in
// `jet`, one after the other, and the last coordinates of homogeneous points in `weights`; those of
// the control points of the rows in `control_weights`.
template <bool is_rational> struct Edge_samples {
  Coordinate_jet<double, 0> jet;
  std::vector<std::array<double, 4>> weights, control_weights;

  template <class FT, int N> Edge_samples(const Blend_end<FT, N>& end, const std::vector<FT>& parameters, int order) {
    const int m = static_cast<int>(parameters.size()), n = end.edge[0].dimension() - (is_rational ? 1 : 0);
    jet = Coordinate_jet<double, 0>(m * n, order);
    const typename Blend_end<FT, N>::Row* const rows[] = {&end.edge, &end.cross, &end.second_cross, &end.third_cross};
    if constexpr (is_rational)
      for (std::size_t i = 0; i < end.edge.size(); ++i) {
        control_weights.emplace_back();
        for (int j = 0; j <= order; ++j) control_weights.back()[j] = CGAL::to_double((*rows[j])[i][n]);
      }
    for (int k = 0; k < m; ++k) {
      const FT& u = parameters[k];
      Coordinate_jet<FT, N> x(end.edge[0].dimension(), order);
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

template <class Kind> using Both_samples = std::array<Edge_samples<Kind::is_rational>, 2>;

// Returns the rows of both ends at some parameters.
template <class Kind, class Ends, class FT>
Both_samples<Kind> samples_at(const Ends& ends, const std::vector<FT>& parameters, int order) {
  Both_samples<Kind> samples = {Edge_samples<Kind::is_rational>(ends.first, parameters, order),
                                Edge_samples<Kind::is_rational>(ends.second, parameters, order)};
  if (is_zero(samples[0].jet[1])) throw Error(Error_code::zero_tangent, "automatic_surface_shape: the first surface");
  if (is_zero(samples[1].jet[1])) throw Error(Error_code::zero_tangent, "automatic_surface_shape: the second surface");
  return samples;
}

// Returns the rows of both edges at the Greville abscissae of the edge that has more of them.
template <class Kind, class Ends> Both_samples<Kind> sampled_ends(const Ends& ends, int order) {
  typedef typename Kind::FT FT;
  const Knot_vector<FT>&x = ends.first.knots, &y = ends.second.knots;
  const Knot_vector<FT>& knots = x.number_of_coefficients() < y.number_of_coefficients() ? y : x;
  std::vector<FT> parameters;
  for (int k = 0; k < knots.number_of_coefficients(); ++k) parameters.push_back(knots.greville_abscissa(k));
  return samples_at<Kind>(ends, parameters, order);
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

// Moves the factors of the homogeneous points no farther than is needed for the weights of all
// control points b_1, b_2, ... next to those of an edge to be at least a quarter of them. This is
// always possible: the weights
//
//   b_1 = w + d L_1 / n,  b_2 = w + 2 d L_1 / n + L_2 / (n (n-1)),
//   b_3 = w + 3 d L_1 / n + 3 L_2 / (n (n-1)) + d L_3 / (n (n-1) (n-2))
//
// of a blend of degree n, with L_k the derivatives of lambda w, grow with d^k lambda_k, as all w
// are positive. The direction d is 1 at the start of the blend, -1 at its end.
template <class Reparametrisation>
void keep_weights_positive(Reparametrisation& r, const Across_edge& x,
                           const std::vector<std::array<double, 4>>& control_weights, int direction, int order) {
  typedef typename Reparametrisation::FT FT;
  if constexpr (std::is_base_of_v<Rational_edge_reparametrisation<FT>, Reparametrisation>) {
    for (const std::array<double, 4>& w : control_weights)
      if (!(w[0] > 0)) return;
    typename Reparametrisation::Function* factors[3] = {&r.lambda1, &r.lambda2, nullptr};
    if constexpr (!std::is_same_v<Rational_edge_reparametrisation<FT>, Reparametrisation>) factors[2] = &r.lambda3;
    double lambda[3] = {0, 0, 0};
    const int n = 2 * order + 1, to_edge[3] = {n, n * (n - 1), n * (n - 1) * (n - 2)};
    for (int k = 0; k < order; ++k) {
      const double sign = k == 1 ? 1 : direction;
      lambda[k] = CGAL::to_double((*factors[k])[0]);
      double least = sign * lambda[k], margin = 0; // for rounding
      for (const std::array<double, 4>& w : control_weights) {
        const double d = x[0] * w[1] / w[0], e = (x[0] * x[0] * w[2] + x[1] * w[1]) / w[0],
                     f = (x[0] * x[0] * x[0] * w[3] + 3 * x[0] * x[1] * w[2] + x[2] * w[1]) / w[0];
        const double l1 = lambda[0] + d, l2 = lambda[1] + 2 * lambda[0] * d + e;
        const double without[3] = {direction * d, 2 * lambda[0] * d + e,
                                   direction * (3 * lambda[1] * d + 3 * lambda[0] * e + f)};
        const double before[3] = {1, 1 + direction * 2 * l1 / n, 1 + direction * 3 * l1 / n + 3 * l2 / to_edge[1]};
        const double needed = to_edge[k] * (0.25 - before[k]);
        least = (std::max)(least, needed - without[k]);
        margin = (std::max)(margin, (std::abs(needed) + std::abs(without[k])) / 128);
      }
      if (!(least > sign * lambda[k])) continue;
      lambda[k] = short_part(sign * (least + margin), 0);
      *factors[k] = short_constant<FT>(lambda[k]);
    }
  }
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

namespace internal {

// Returns the shape with these derivatives of the parameter across both edges, for surfaces of
// which there are samples.
template <class Kind, class Shape>
Shape shape_across(const std::array<Across_edge, 2>& across, const Both_samples<Kind>& samples, int order) {
  Shape shape;
  set_shape(shape.start, across[0], samples[0].weights);
  set_shape(shape.end, across[1], samples[1].weights);
  if constexpr (Kind::is_rational) {
    keep_weights_positive(shape.start, across[0], samples[0].control_weights, 1, order);
    keep_weights_positive(shape.end, across[1], samples[1].control_weights, -1, order);
    shape.end.lambda = typename Kind::FT(short_part(
        std::sqrt(mean_square_of_weights(samples[0].weights) / mean_square_of_weights(samples[1].weights)), 0));
  }
  return shape;
}

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_SURFACE_BLEND_SHAPE_H
