// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_QUINTIC_STRATEGIES_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_QUINTIC_STRATEGIES_H

#include <CGAL/Geometric_continuity/blends/blend_ends.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>

#include <CGAL/tags.h>

#include <type_traits>
#include <utility>

/// \file quintic_strategies.h
/// The strategies of the package for blends of degree 5: how the scalars \f$ s_1, s_2 \f$ are chosen, by which the points
/// \f$ C_1, C_2 \f$ slide along the end tangents. Portnov (6), (16), (23), corrected; the least energies in closed form. Each
/// takes a constant number of field operations in a given dimension.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses \f$ \gamma'' \f$ equal to that of the given curves (scaled by \f$ \beta^2, \eta^2 \f$): a \f$ C^2 \f$ join when
/// \f$ \beta = \eta = 1 \f$. Portnov (6). \models BlendStrategy
struct Matching_second_derivative {
  typedef Tag_true Works_in_every_field;

  /// Chooses \f$ s_1 \f$ and \f$ s_2 \f$.
  template <class FT, int N> Quintic_parameters<FT> operator()(const Quintic_ends<FT, N>& e) const {
    const FT c = internal::fraction<FT, 1, 20>();
    return {FT(c * e.tangential1), FT(c * e.tangential2)};
  }
};

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses the points \f$ C = B + d n \f$, straight above the second points. Portnov 4.1. \models BlendStrategy
struct Normal_offset {
  typedef Tag_true Works_in_every_field;

  /// Chooses \f$ s_1 \f$ and \f$ s_2 \f$.
  template <class FT, int N> Quintic_parameters<FT> operator()(const Quintic_ends<FT, N>&) const {
    return {internal::fraction<FT, -1, 5>(), internal::fraction<FT, 1, 5>()};
  }
};

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses the least \f$ |\gamma''| \f$ at both ends. Portnov (16), with `d n` for the vector that is not a unit vector in print.
/// \models BlendStrategy
struct Minimal_second_derivative {
  typedef Tag_true Works_in_every_field;

  /// Chooses \f$ s_1 \f$ and \f$ s_2 \f$.
  template <class FT, int N> Quintic_parameters<FT> operator()(const Quintic_ends<FT, N>&) const {
    return {FT(0), FT(0)};
  }
};

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses the points `C` nearest to the line \f$ B_1 B_2 \f$. Portnov (23). Where that line is parallel to a tangent, or
/// \f$ B_1 = B_2 \f$, the point is not determined: there the strategy falls back to `Normal_offset` and says so. Near that
/// position the point is far away. \models BlendStrategy
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
/// Chooses the least energy \f$ \int_0^1 |\gamma^{(k)}|^2 dt \f$, `k` = 2 or 3. With `k` = 3 the result is optimal among all smooth
/// curves with the same ends. The linear system is never singular. \models BlendStrategy
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
/// Chooses the caller's own scalars \f$ s_1, s_2 \f$. \models BlendStrategy
/// \tparam FT_ a number type from which that of the blend can be made, e.g. `double` for an exact blend
template <class FT_> struct Given_parameters {
  typedef Tag_true Works_in_every_field;

  FT_ s1 = FT_(0); ///< \f$ s_1 \f$
  FT_ s2 = FT_(0); ///< \f$ s_2 \f$

  /// Sets both to 0.
  Given_parameters() = default;
  /// Takes numbers of any type from which `FT_` can be made.
  /// \throws Error `not_finite` when a floating-point number that is converted is infinite or not a number
  Given_parameters(internal::Given_number<FT_> s1, internal::Given_number<FT_> s2)
      : s1(std::move(s1.value)), s2(std::move(s2.value)) {}

  /// Returns the given scalars.
  /// \throws Error `not_finite` when a floating-point number that is converted is infinite or not a number
  template <class FT, int N, class = std::enable_if_t<std::is_constructible_v<FT, const FT_&>>>
  Quintic_parameters<FT> operator()(const Quintic_ends<FT, N>&) const {
    return {internal::to_field<FT>(s1), internal::to_field<FT>(s2)};
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_QUINTIC_STRATEGIES_H
