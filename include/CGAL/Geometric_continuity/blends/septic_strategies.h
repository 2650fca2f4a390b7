// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_SEPTIC_STRATEGIES_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_SEPTIC_STRATEGIES_H

#include <CGAL/Geometric_continuity/algebra/bernstein.h>
#include <CGAL/Geometric_continuity/algebra/internal/solve_positive_definite.h>
#include <CGAL/Geometric_continuity/blends/blend_ends.h>

#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <type_traits>

/// \file septic_strategies.h
/// The strategies of the package for blends of degree 7: how the scalars \f$ \beta_2, \mu, \beta_3 \f$ at each end are chosen.
/// Each takes a constant number of field operations in a given dimension.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// A strategy that treats both ends alike: End::choose(end, parameters) returns whether it fell back.
template <class End> struct End_by_end {
  typedef Tag_true Works_in_every_field;

  /// Chooses \f$ \beta_2, \mu, \beta_3 \f$ at both ends.
  template <class FT, int N> Septic_parameters<FT> operator()(const Septic_ends<FT, N>& e) const {
    Septic_parameters<FT> p;
    p.fallback_start = End::choose(e.start, p.start);
    p.fallback_end = End::choose(e.end, p.end);
    return p;
  }

protected:
  // beta_2 with gamma'' orthogonal to the tangent
  template <class FT, int N> static FT orthogonal_beta2(const Septic_end<FT, N>& e) {
    return FT(-e.beta * e.beta * dot(e.d1, e.d2) / dot(e.d1, e.d1));
  }
  // mu with gamma''' orthogonal to the principal normal; false where the curvature is zero
  template <class FT, int N> static bool orthogonal_mu(const Septic_end<FT, N>& e, FT& mu) {
    const Coordinate_vector<FT, N> n = orthogonal_component(e.d2, e.d1);
    const FT nn = dot(n, n);
    if (nn == FT(0)) return false;
    mu = -e.beta * e.beta * e.beta * dot(e.d3, n) / nn;
    return true;
  }
  // beta_3 with gamma''' orthogonal to the tangent
  template <class FT, int N> static FT orthogonal_beta3(const Septic_end<FT, N>& e, const FT& mu) {
    return FT(-dot(FT(e.beta * e.beta * e.beta) * e.d3 + mu * e.d2, e.d1) / dot(e.d1, e.d1));
  }
};

// The integral of p^(k) . q^(k) over [0,1] for two control polygons, up to the factor (m!/(m-k)!)^2.
template <class FT, int N, std::size_t points>
FT energy_product(std::array<Coordinate_vector<FT, N>, points> p, std::array<Coordinate_vector<FT, N>, points> q,
                  int k) {
  int m = static_cast<int>(points) - 1;
  for (; k > 0; --k, --m) {
    difference_step(p, m);
    difference_step(q, m);
  }
  const auto binomial = [](int n, int i) {
    int b = 1;
    for (int j = 0; j < i; ++j) b = b * (n - j) / (j + 1);
    return b;
  };
  FT sum(0);
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= m; ++j)
      sum += FT(binomial(m, i) * binomial(m, j)) / FT(binomial(2 * m, i + j)) * dot(p[i], q[j]);
  return FT(sum / FT(2 * m + 1));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses all derivatives up to the third equal to those of the given curves (scaled): a \f$ C^3 \f$ join when
/// \f$ \beta = \eta = 1 \f$. \models BlendStrategy
struct Matching_third_derivative {
  typedef Tag_true Works_in_every_field;

  /// Chooses \f$ \beta_2, \mu, \beta_3 \f$ at both ends.
  template <class FT, int N> Septic_parameters<FT> operator()(const Septic_ends<FT, N>&) const { return {}; }
};

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses \f$ G^3 \f$ joins with the least \f$ |\gamma''| \f$, and then with the least \f$ |\gamma'''| \f$ that is left.
/// \models BlendStrategy
struct Sequential_g3 : internal::End_by_end<Sequential_g3> {
  /// Sets the scalars of one end; returns whether the rule is undefined there.
  template <class FT, int N> static bool choose(const Septic_end<FT, N>& e, Septic_end_parameters<FT>& p) {
    p.beta2 = orthogonal_beta2(e);
    p.mu = FT(3) * e.beta * p.beta2;
    p.beta3 = orthogonal_beta3(e, p.mu);
    return false;
  }
};

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses \f$ F^3 \f$ joins with the least \f$ |\gamma''| \f$ and the least \f$ |\gamma'''| \f$. Where the curvature is
/// zero, \f$ \mu = 0 \f$ (reported as a fallback). \models BlendStrategy
struct Sequential_f3 : internal::End_by_end<Sequential_f3> {
  /// Sets the scalars of one end; returns whether the rule is undefined there.
  template <class FT, int N> static bool choose(const Septic_end<FT, N>& e, Septic_end_parameters<FT>& p) {
    p.beta2 = orthogonal_beta2(e);
    const bool determined = orthogonal_mu(e, p.mu);
    p.beta3 = orthogonal_beta3(e, p.mu);
    return !determined;
  }
};

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses \f$ G^3 \f$ joins with the least \f$ |\gamma'''| \f$: the \f$ \mu \f$ of `Sequential_f3`, and
/// \f$ \beta_2 = \mu/(3\beta) \f$. Falls back to `Sequential_g3` where the curvature is zero. \models BlendStrategy
struct Joint_g3 : internal::End_by_end<Joint_g3> {
  /// Sets the scalars of one end; returns whether the rule is undefined there.
  template <class FT, int N> static bool choose(const Septic_end<FT, N>& e, Septic_end_parameters<FT>& p) {
    if (!orthogonal_mu(e, p.mu)) {
      Sequential_g3::choose(e, p);
      return true;
    }
    p.beta2 = p.mu / (FT(3) * e.beta);
    p.beta3 = orthogonal_beta3(e, p.mu);
    return false;
  }
};

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses \f$ G^3 \f$ joins with the least energy \f$ \int_0^1 |\gamma^{(k)}|^2 dt \f$, `k` = 3 or 4, over \f$ (\beta_2, \beta_3) \f$ at
/// both ends: a 4 x 4 linear system that is never singular. \models BlendStrategy
template <int k> struct Minimal_energy_g3 {
  static_assert(k == 3 || k == 4, "a septic blend minimises the energy of order 3 or 4");

  typedef Tag_true Works_in_every_field;

  /// Chooses \f$ \beta_2, \mu, \beta_3 \f$ at both ends.
  template <class FT, int N> Septic_parameters<FT> operator()(const Septic_ends<FT, N>& e) const {
    typedef std::array<Coordinate_vector<FT, N>, 8> Polygon;
    // the control polygon is affine in the four unknowns: base + sum x_i step[i]
    const Polygon base = e.control_points(parameters(e, {FT(0), FT(0), FT(0), FT(0)}));
    std::array<Polygon, 4> step;
    for (int i = 0; i < 4; ++i) {
      std::array<FT, 4> x = {FT(0), FT(0), FT(0), FT(0)};
      x[i] = FT(1);
      step[i] = e.control_points(parameters(e, x));
      for (int j = 0; j < 8; ++j) step[i][j] -= base[j];
    }
    std::array<std::array<FT, 4>, 4> a;
    std::array<FT, 4> b;
    for (int i = 0; i < 4; ++i) {
      b[i] = -internal::energy_product(step[i], base, k);
      for (int j = 0; j <= i; ++j) a[i][j] = a[j][i] = internal::energy_product(step[i], step[j], k);
    }
    return parameters(e, internal::solve_positive_definite(a, b));
  }

private:
  template <class FT, int N>
  static Septic_parameters<FT> parameters(const Septic_ends<FT, N>& e, const std::array<FT, 4>& x) {
    Septic_parameters<FT> p;
    p.start = {x[0], FT(FT(3) * e.start.beta * x[0]), x[1]};
    p.end = {x[2], FT(FT(3) * e.end.beta * x[2]), x[3]};
    return p;
  }
};

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses the caller's own parameters at both ends. \models BlendStrategy
/// \tparam FT_ a number type from which that of the blend can be made, e.g. `double` for an exact blend
template <class FT_> struct Given_end_parameters {
  typedef Tag_true Works_in_every_field;

  Septic_end_parameters<FT_> start; ///< the scalars at the start of the blend
  Septic_end_parameters<FT_> end;   ///< the scalars at the end of the blend

  /// Returns the given scalars.
  /// \throws Error `not_finite` when a floating-point number that is converted is infinite or not a number
  template <class FT, int N, class = std::enable_if_t<std::is_constructible_v<FT, const FT_&>>>
  Septic_parameters<FT> operator()(const Septic_ends<FT, N>&) const {
    return {Septic_end_parameters<FT>{start.beta2, start.mu, start.beta3},
            Septic_end_parameters<FT>{end.beta2, end.mu, end.beta3}};
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_SEPTIC_STRATEGIES_H
