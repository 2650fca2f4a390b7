// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_QUINTIC_STRATEGIES_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_QUINTIC_STRATEGIES_H

#include <CGAL/Geometric_continuity/blends/Quintic_ends.h>

#include <boost/config.hpp>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityStrategies
/// \f$ \gamma'' \f$ equals that of the given curves (scaled by \f$ \beta^2, \eta^2 \f$): a \f$ C^2 \f$ join when
/// \f$ \beta = \eta = 1 \f$. Portnov (6). \models BlendStrategy
struct Matching_second_derivative {
  template <class FT, int N> Quintic_parameters<FT> operator()(const Quintic_ends<FT, N>& e) const {
    const FT c = internal::fraction<FT, 1, 20>();
    return {FT(c * e.tangential1), FT(c * e.tangential2)};
  }
};

/// \ingroup PkgGeometricContinuityStrategies
/// The points \f$ C = B + d n \f$, straight above the second points. Portnov 4.1. \models BlendStrategy
struct Normal_offset {
  template <class FT, int N> Quintic_parameters<FT> operator()(const Quintic_ends<FT, N>&) const {
    return {internal::fraction<FT, -1, 5>(), internal::fraction<FT, 1, 5>()};
  }
};

/// \ingroup PkgGeometricContinuityStrategies
/// The least \f$ |\gamma''| \f$ at both ends. Portnov (16), with `d n` for the vector that is not a unit vector in print.
/// \models BlendStrategy
struct Minimal_second_derivative {
  template <class FT, int N> Quintic_parameters<FT> operator()(const Quintic_ends<FT, N>&) const {
    return {FT(0), FT(0)};
  }
};

/// \ingroup PkgGeometricContinuityStrategies
/// The points `C` nearest to the line \f$ B_1 B_2 \f$ on their lines. Portnov (23). Where that line is parallel to a
/// tangent, or \f$ B_1 = B_2 \f$, the point is not determined: there the strategy falls back to `Normal_offset` and says so.
/// Near that position the point is far away. \models BlendStrategy
struct Near_line {
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
/// The least energy \f$ \int_0^1 |\gamma^{(k)}|^2 dt \f$, `k` = 2 or 3. With `k` = 3 the result is optimal among all smooth
/// curves with the same ends. The linear system is never singular. \models BlendStrategy
template <int k> struct Minimal_energy {
  static_assert(k == 2 || k == 3, "a quintic blend minimises the energy of order 2 or 3");

  template <class FT, int N> BOOST_FORCEINLINE Quintic_parameters<FT> operator()(const Quintic_ends<FT, N>& e) const {
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
/// The caller's own scalars \f$ s_1, s_2 \f$. \models BlendStrategy
template <class FT_> struct Given_parameters {
  FT_ s1, s2;
  template <class FT, int N> Quintic_parameters<FT> operator()(const Quintic_ends<FT, N>&) const {
    return {FT(s1), FT(s2)};
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_QUINTIC_STRATEGIES_H
