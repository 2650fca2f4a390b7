// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_INTERNAL_AUTOMATIC_SHAPE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_INTERNAL_AUTOMATIC_SHAPE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/blend_ends.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>
#include <CGAL/Geometric_continuity/surface_blends/internal/Blend_end.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

/// \file automatic_shape.h
/// The shape of a blend surface for which the caller gives none, by the strategies for blends of
/// curves.
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

// Returns the rows of both edges at the Greville abscissae of the edge that has more of them, or of
// both where they have as many.
template <class Kind, class Ends> Both_samples<Kind> sampled_ends(const Ends& ends, int order) {
  typedef typename Kind::FT FT;
  const Knot_vector<FT>&x = ends.first.knots, &y = ends.second.knots;
  std::vector<FT> parameters;
  const auto take = [&](const Knot_vector<FT>& knots) {
    for (int k = 0; k < knots.number_of_coefficients(); ++k) parameters.push_back(knots.greville_abscissa(k));
  };
  if (x.number_of_coefficients() >= y.number_of_coefficients()) take(x);
  if (x.number_of_coefficients() <= y.number_of_coefficients() && x != y) take(y);
  return samples_at<Kind>(ends, parameters, order);
}

// Returns x with few binary digits; 0 where it is small in comparison with the unit.
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
    const double ratio =
        std::sqrt(mean_square_of_weights(samples[0].weights) / mean_square_of_weights(samples[1].weights));
    (ratio < 1 ? shape.start : shape.end).lambda = typename Kind::FT(short_part(ratio < 1 ? 1 / ratio : ratio, 0));
  }
  return shape;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_INTERNAL_AUTOMATIC_SHAPE_H
