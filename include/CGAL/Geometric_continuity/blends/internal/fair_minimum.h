// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_MINIMUM_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_MINIMUM_H

#include <CGAL/Geometric_continuity/algebra/internal/solve_positive_definite.h>
#include <CGAL/Geometric_continuity/blends/internal/Fairness_quadrature.h>
#include <CGAL/Geometric_continuity/blends/quintic_strategies.h>
#include <CGAL/Geometric_continuity/blends/septic_strategies.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

// The fairest blend of a family, by the method of Levenberg and Marquardt. Deterministic; nothing is allocated.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The blend of least energy with the shape parameters e^a and e^b: where the search starts.
template <Blend_kind kind, int M>
typename Fair_family<kind, M>::Unknowns least_energy(const Fair_family<kind, M>& f, double a, double b) {
  typedef Coordinate_vector<double, M> Vector;
  const double beta = std::exp(a), eta = std::exp(b);
  const Vector origin(M);
  if constexpr (kind == Blend_kind::g2) {
    const Quintic_parameters<double> p =
        Minimal_energy<3>()(Quintic_ends<double, M>(origin, f.chord, beta * f.start.d[0], eta * f.end.d[0],
                                                    (beta * beta) * f.start.d[1], (eta * eta) * f.end.d[1]));
    return {a, 20 * p.s1, b, 20 * p.s2};
  } else {
    const std::array<Vector, 4> phi = {origin, f.start.d[0], f.start.d[1], f.start.d[2]},
                                psi = {f.chord, f.end.d[0], f.end.d[1], f.end.d[2]};
    const Septic_parameters<double> p =
        Minimal_energy_g3<4>()(Septic_ends<double, M>(phi, psi, Shape_parameters<double>(beta, eta)));
    if constexpr (kind == Blend_kind::g3)
      return {a, p.start.beta2 / beta, p.start.beta3 / beta, b, p.end.beta2 / eta, p.end.beta3 / eta};
    else
      return {a, p.start.beta2 / beta, p.start.beta3 / beta, p.start.mu / (beta * beta),
              b, p.end.beta2 / eta,    p.end.beta3 / eta,    p.end.mu / (eta * eta)};
  }
}

enum class Shape_choice { free, given };

template <Blend_kind kind, int M> class Fair_minimum {
  typedef Fair_family<kind, M> Family;
  typedef typename Family::Unknowns Unknowns;
  static constexpr int unknowns = Family::unknowns, shape_unknowns[2] = {0, Family::End::unknowns};
  static constexpr double most_change = 1.3862943611198906; // of the logarithm of a shape parameter: a factor of 4
  static constexpr double longest_step = 0.75;              // of the same
  static constexpr double precision = 1e-4;                 // of E, as far as the expansion tells
  static constexpr int most_iterations = 100;

  const Family& family_;
  const Shape_choice shape_;

public:
  Unknowns x;           ///< the blend that was found
  Unknowns automatic;   ///< the blend of least energy with the automatic shape
  double before, after; ///< E of both
  int iterations = 0;
  bool converged = false;

  Fair_minimum(const Family& family, Shape_choice shape) : family_(family), shape_(shape) {
    automatic = x = least_energy(family, 0, 0);
    before = after = Fairness_quadrature<kind, M, 24>(family).value(x);
    look_around();
    // a curve that is almost a cusp needs more nodes
    descend<24>() || descend<48>() || descend<96>();
  }

  // Takes a blend near the minimum, e.g. with rounded numbers, unless it is worse than the automatic one.
  void take(const Unknowns& rounded) {
    Fairness_quadrature<kind, M, 96> quadrature(family_);
    before = quadrature.value(automatic);
    x = rounded;
    after = quadrature.value(x);
    if (after <= before) return;
    x = automatic;
    after = before;
    converged = false;
  }

private:
  // The automatic shape may be in the reach of a bad minimum: then another one with longer or shorter tangents is much better.
  void look_around() {
    if (shape_ == Shape_choice::given) return;
    Fairness_quadrature<kind, M, 24> quadrature(family_);
    constexpr double much_better = 0.25, factor = 0.6931471805599453; // 2
    double best = before * much_better;
    for (double a : {-factor, 0., factor})
      for (double b : {-factor, 0., factor}) {
        const Unknowns y = least_energy(family_, a, b);
        const double e = quadrature.value(y);
        if (!(e < best)) continue;
        best = e;
        x = y;
      }
  }

  bool is_fixed(int k, const Unknowns& gradient) const {
    for (int shape : shape_unknowns)
      if (k == shape)
        return shape_ == Shape_choice::given || (x[k] >= most_change && gradient[k] < 0) ||
               (x[k] <= -most_change && gradient[k] > 0);
    return false;
  }

  // Minimises the quadrature with so many nodes. Returns whether twice as many nodes say the same of the result.
  template <int nodes> bool descend() {
    Fairness_quadrature<kind, M, nodes> quadrature(family_);
    double here = quadrature.value(x);
    Fairness_expansion<unknowns> expansion = quadrature.expand(x);
    converged = false;
    for (double damping = 1e-2; damping < 1e10 && iterations < most_iterations; ++iterations) {
      if (!(here <= (std::numeric_limits<double>::max)())) break;
      const Unknowns next = step(expansion, damping);
      double gain = 0; // as the expansion predicts it
      for (int k = 0; k < unknowns; ++k) {
        const double h = next[k] - x[k];
        gain -= 2 * expansion.gradient[k] * h;
        for (int l = 0; l < unknowns; ++l) gain -= h * expansion.matrix[k][l] * (next[l] - x[l]);
      }
      if (!(gain > precision * here)) {
        converged = damping <= 1 || here == 0;
        break;
      }
      const double value = quadrature.value(next);
      if (value < here) {
        const double ratio = (here - value) / gain;
        damping = (std::max)(damping * (ratio > 0.75 ? 0.1 : ratio < 0.25 ? 2 : 0.5), 1e-9);
        x = next;
        here = value;
        expansion = quadrature.expand(x);
      } else
        damping *= 8;
    }
    after = Fairness_quadrature<kind, M, 2 * nodes>(family_).value(x);
    constexpr double agreement = 0.01;
    const bool agreed = std::abs(after - here) <= agreement * after;
    converged = converged && agreed;
    return agreed;
  }

  // The minimum of the expansion with damping, not too far away.
  Unknowns step(const Fairness_expansion<unknowns>& e, double damping) const {
    std::array<std::array<double, unknowns>, unknowns> matrix = e.matrix;
    Unknowns h;
    for (int k = 0; k < unknowns; ++k) {
      h[k] = -e.gradient[k];
      matrix[k][k] += damping * matrix[k][k] + std::numeric_limits<double>::min();
    }
    for (int k = 0; k < unknowns; ++k)
      if (is_fixed(k, e.gradient)) {
        for (int l = 0; l < unknowns; ++l) matrix[k][l] = matrix[l][k] = 0;
        matrix[k][k] = 1;
        h[k] = 0;
      }
    h = solve_positive_definite(matrix, h);
    double longest = 0;
    for (int k : shape_unknowns) longest = (std::max)(longest, std::abs(h[k]));
    const double part = longest > longest_step ? longest_step / longest : 1;
    Unknowns next;
    for (int k = 0; k < unknowns; ++k) next[k] = x[k] + part * h[k];
    for (int k : shape_unknowns) next[k] = (std::min)((std::max)(next[k], -most_change), most_change);
    return next;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_MINIMUM_H
