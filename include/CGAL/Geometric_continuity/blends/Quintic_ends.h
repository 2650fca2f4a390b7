// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_QUINTIC_ENDS_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_QUINTIC_ENDS_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/numbers/internal/fraction.h>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// The shape parameters of a blend: its first derivatives are \f$ \beta\varphi'(1) \f$ and \f$ \eta\psi'(0) \f$, both
/// positive. Portnov has \f$ \beta = \eta = 1 \f$.
template <class FT> struct Shape_parameters {
  FT beta = FT(1);
  FT eta = FT(1);
};

/// \ingroup PkgGeometricContinuityConstruction
/// What a strategy chooses for a quintic blend.
template <class FT> struct Quintic_parameters {
  FT s1 = FT(0);               ///< \f$ \gamma''(0) = 20 (d n_1 + s_1 u) \f$
  FT s2 = FT(0);               ///< \f$ \gamma''(1) = 20 (d n_2 + s_2 v) \f$
  bool fallback_start = false; ///< the strategy is undefined at the start and used another value
  bool fallback_end = false;   ///< the same at the end
};

/// \ingroup PkgGeometricContinuityConstruction
/// What a strategy reads of a quintic blend \f$ \gamma \f$: all but the two scalars that it chooses.
template <class FT, int N> struct Quintic_ends {
  typedef Coordinate_vector<FT, N> Vector;

  Vector a1, a2; ///< the end points \f$ A_1 = \gamma(0) \f$, \f$ A_2 = \gamma(1) \f$
  Vector u, v;   ///< the end tangents \f$ u = \gamma'(0) = \beta\varphi'(1) \f$, \f$ v = \gamma'(1) = \eta\psi'(0) \f$
  Vector w1, w2; ///< the scaled second derivatives \f$ \beta^2\varphi''(1) \f$, \f$ \eta^2\psi''(0) \f$

  FT tangential1; ///< the tangential part of `w1` in units of `u`, \f$ (w_1 \cdot u) / (u \cdot u) \f$
  FT tangential2; ///< the tangential part of `w2` in units of `v`

  Quintic_ends(const Vector& a1, const Vector& a2, const Vector& u, const Vector& v, const Vector& w1, const Vector& w2)
      : a1(a1), a2(a2), u(u), v(v), w1(w1), w2(w2), tangential1(dot(w1, u) / dot(u, u)),
        tangential2(dot(w2, v) / dot(v, v)) {}

  /// The vector `d n` of Portnov (15) at the start, without a root: \f$ w_1^\perp / 20 \f$
  Vector dn1() const { return internal::fraction<FT, 1, 20>() * (w1 - tangential1 * u); }
  /// The vector `d n` at the end
  Vector dn2() const { return internal::fraction<FT, 1, 20>() * (w2 - tangential2 * v); }

  Vector b1() const { return a1 + internal::fraction<FT, 1, 5>() * u; } ///< \f$ B_1 \f$, Portnov (10)
  Vector b2() const { return a2 - internal::fraction<FT, 1, 5>() * v; } ///< \f$ B_2 \f$

  /// \f$ C_1 = A_1 + (2/5 + s_1) u + d n_1 \f$
  Vector c1(const FT& s1) const {
    const FT c = internal::fraction<FT, 1, 20>();
    return a1 + FT(internal::fraction<FT, 2, 5>() + s1 - c * tangential1) * u + c * w1;
  }
  /// \f$ C_2 = A_2 - (2/5 - s_2) v + d n_2 \f$
  Vector c2(const FT& s2) const {
    const FT c = internal::fraction<FT, 1, 20>();
    return a2 - FT(internal::fraction<FT, 2, 5>() - s2 + c * tangential2) * v + c * w2;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_QUINTIC_ENDS_H
