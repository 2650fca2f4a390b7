// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_STRATEGIES_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_STRATEGIES_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/internal/solve_positive_definite.h>
#include <CGAL/Geometric_continuity/blends/blend_ends.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

/// \file blend_strategies.h
/// The strategies of the package: how the free scalars of a blend are chosen. For degree 5 these
/// are \f$ s_1, s_2 \f$, by which the points \f$ C_1, C_2 \f$ slide along the end tangents: Portnov
/// (6), (16), (23), corrected, and the least energies in closed form; of degree 7
/// \f$ \beta_2, \mu, \beta_3 \f$ at each end. Each takes a constant number of field operations in a
/// given dimension.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses \f$ \gamma'' \f$ equal to that of the given curves (scaled by \f$ \beta^2, \eta^2 \f$):
/// a \f$ C^2 \f$ join when \f$ \beta = \eta = 1 \f$. Portnov (6). \cgalModels{BlendStrategy}
struct Matching_second_derivative {
  typedef Tag_true Works_in_every_field;

  /// Chooses \f$ s_1 \f$ and \f$ s_2 \f$.
  template <class FT, int N> Quintic_parameters<FT> operator()(const Quintic_ends<FT, N>& e) const {
    const FT c = internal::fraction<FT, 1, 20>();
    return {FT(c * e.tangential1), FT(c * e.tangential2)};
  }
};

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses the points \f$ C = B + d n \f$, straight above the second points. Portnov 4.1.
/// \cgalModels{BlendStrategy}
struct Normal_offset {
  typedef Tag_true Works_in_every_field;

  /// Chooses \f$ s_1 \f$ and \f$ s_2 \f$.
  template <class FT, int N> Quintic_parameters<FT> operator()(const Quintic_ends<FT, N>&) const {
    return {internal::fraction<FT, -1, 5>(), internal::fraction<FT, 1, 5>()};
  }
};

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses the least \f$ |\gamma''| \f$ at both ends. Portnov (16), with `d n` for the vector that
/// is not a unit vector in print.
/// \cgalModels{BlendStrategy}
struct Minimal_second_derivative {
  typedef Tag_true Works_in_every_field;

  /// Chooses \f$ s_1 \f$ and \f$ s_2 \f$.
  template <class FT, int N> Quintic_parameters<FT> operator()(const Quintic_ends<FT, N>&) const {
    return {FT(0), FT(0)};
  }
};

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses the points `C` nearest to the line \f$ B_1 B_2 \f$. Portnov (23). Where that line is
/// parallel to a tangent, or \f$ B_1 = B_2 \f$, the point is not determined: there the strategy
/// falls back to `Normal_offset` and says so. Near that position the point is far away.
/// \cgalModels{BlendStrategy}
struct Near_line {
  typedef Tag_true Works_in_every_field;

  /// Chooses \f$ s_1 \f$ and \f$ s_2 \f$.
  template <class FT, int N> Quintic_parameters<FT> operator()(const Quintic_ends<FT, N>& e) const {
    const Coordinate_vector<FT, N> w = e.b2() - e.b1();
    Quintic_parameters<FT> p = Normal_offset()(e);
    p.fallback_start = !add_shift(e.u, e.dn1(), w, p.s1);
    p.fallback_end = !add_shift(e.v, e.dn2(), w, p.s2);
    return p;
  }

private:
  // s += t(x, dn) = (x.w)(dn.w) / (x.x w.w - (x.w)^2)
  template <class FT, int N>
  static bool add_shift(const Coordinate_vector<FT, N>& x, const Coordinate_vector<FT, N>& dn,
                        const Coordinate_vector<FT, N>& w, FT& s) {
    const FT xw = dot(x, w), sine = dot(x, x) * dot(w, w) - xw * xw;
    if (sine == FT(0)) return false;
    s += xw * dot(dn, w) / sine;
    return true;
  }
};

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses the least energy \f$ \int_0^1 |\gamma^{(k)}|^2 dt \f$, `k` = 2 or 3. With `k` = 3 the
/// result is optimal among all smooth curves with the same ends. The linear system is never
/// singular. \cgalModels{BlendStrategy}
template <int k> struct Minimal_energy {
  static_assert(k == 2 || k == 3, "a quintic blend minimises the energy of order 2 or 3");

  typedef Tag_true Works_in_every_field;

  /// Chooses \f$ s_1 \f$ and \f$ s_2 \f$.
  template <class FT, int N> CGAL_GC_FORCEINLINE Quintic_parameters<FT> operator()(const Quintic_ends<FT, N>& e) const {
    const Coordinate_vector<FT, N>&a1 = e.a1, &a2 = e.a2, &u = e.u, &v = e.v;
    const Coordinate_vector<FT, N> b1 = e.b1(), b2 = e.b2(), c1 = e.c1(FT(0)), c2 = e.c2(FT(0));
    if constexpr (k == 2) // [12u.u, 2u.v; 2u.v, 12v.v] s = r
      return solve<FT>(FT(12) * dot(u, u), FT(2) * dot(u, v), FT(12) * dot(v, v),
                       -dot(FT(4) * a1 - FT(13) * b1 + FT(12) * c1 + FT(2) * c2 - FT(8) * b2 + FT(3) * a2, u),
                       -dot(FT(3) * a1 - FT(8) * b1 + FT(2) * c1 + FT(12) * c2 - FT(13) * b2 + FT(4) * a2, v));
    else // [3u.u, -u.v; -u.v, 3v.v] s = r
      return solve<FT>(FT(3) * dot(u, u), -dot(u, v), FT(3) * dot(v, v), dot(FT(3) * b1 - a1 - FT(3) * c1 + c2, u),
                       -dot(FT(3) * c2 - c1 - FT(3) * b2 + a2, v));
  }

private:
  template <class FT>
  static Quintic_parameters<FT> solve(const FT& m11, const FT& m12, const FT& m22, const FT& r1, const FT& r2) {
    const FT det = m11 * m22 - m12 * m12;
    return {FT((r1 * m22 - r2 * m12) / det), FT((m11 * r2 - m12 * r1) / det)};
  }
};

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses the caller's own scalars \f$ s_1, s_2 \f$. \cgalModels{BlendStrategy}
/// \tparam FT_ a number type from which that of the blend can be made, e.g. `double` for an exact
///   blend
template <class FT_> struct Given_parameters {
  typedef Tag_true Works_in_every_field;

  FT_ s1 = FT_(0); ///< \f$ s_1 \f$
  FT_ s2 = FT_(0); ///< \f$ s_2 \f$

  /// Sets both to 0.
  Given_parameters() = default;
  /// Takes numbers of any type from which `FT_` can be made.
  /// \throws Error `not_finite` when a floating-point number that is converted is infinite or not a
  ///   number
  Given_parameters(internal::Convertible_number<FT_> given_s1, internal::Convertible_number<FT_> given_s2)
      : s1(std::move(given_s1.value)), s2(std::move(given_s2.value)) {}

  /// Returns the given scalars.
  /// \throws Error `not_finite` when a floating-point number that is converted is infinite or not a
  ///   number
  template <class FT, int N, class = std::enable_if_t<std::is_constructible_v<FT, const FT_&>>>
  Quintic_parameters<FT> operator()(const Quintic_ends<FT, N>&) const {
    return {internal::to_field<FT>(s1), internal::to_field<FT>(s2)};
  }
};

namespace internal {

// A strategy that treats both ends alike: End::choose(end, parameters) returns whether it fell
// back.
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

// The integral of p^(k) . q^(k) over [0,1] for two control polygons, up to the factor
// (m!/(m-k)!)^2.
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
/// Chooses all derivatives up to the third equal to those of the given curves (scaled): a
/// \f$ C^3 \f$ join when \f$ \beta = \eta = 1 \f$. \cgalModels{BlendStrategy}
struct Matching_third_derivative {
  typedef Tag_true Works_in_every_field;

  /// Chooses \f$ \beta_2, \mu, \beta_3 \f$ at both ends.
  template <class FT, int N> Septic_parameters<FT> operator()(const Septic_ends<FT, N>&) const { return {}; }
};

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses \f$ G^3 \f$ joins with the least \f$ |\gamma''| \f$, and then with the least
/// \f$ |\gamma'''| \f$ that is left.
/// \cgalModels{BlendStrategy}
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
/// Chooses \f$ F^3 \f$ joins with the least \f$ |\gamma''| \f$ and the least \f$ |\gamma'''| \f$.
/// Where the curvature is zero, \f$ \mu = 0 \f$ (reported as a fallback).
/// \cgalModels{BlendStrategy}
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
/// Chooses \f$ G^3 \f$ joins with the least \f$ |\gamma'''| \f$: the \f$ \mu \f$ of
/// `Sequential_f3`, and \f$ \beta_2 = \mu/(3\beta) \f$. Falls back to `Sequential_g3` where the
/// curvature is zero. \cgalModels{BlendStrategy}
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
/// Chooses \f$ G^3 \f$ joins with the least energy \f$ \int_0^1 |\gamma^{(k)}|^2 dt \f$, `k` = 3 or
/// 4, over \f$ (\beta_2, \beta_3) \f$ at both ends: a 4 x 4 linear system that is never singular.
/// \cgalModels{BlendStrategy}
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
/// Chooses the caller's own parameters at both ends. \cgalModels{BlendStrategy}
/// \tparam FT_ a number type from which that of the blend can be made, e.g. `double` for an exact
///   blend
template <class FT_> struct Given_end_parameters {
  typedef Tag_true Works_in_every_field;

  Septic_end_parameters<FT_> start; ///< the scalars at the start of the blend
  Septic_end_parameters<FT_> end;   ///< the scalars at the end of the blend

  /// Returns the given scalars.
  /// \throws Error `not_finite` when a floating-point number that is converted is infinite or not a
  ///   number
  template <class FT, int N, class = std::enable_if_t<std::is_constructible_v<FT, const FT_&>>>
  Septic_parameters<FT> operator()(const Septic_ends<FT, N>&) const {
    return {Septic_end_parameters<FT>{start.beta2, start.mu, start.beta3},
            Septic_end_parameters<FT>{end.beta2, end.mu, end.beta3}};
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_STRATEGIES_H
