// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_SEPTIC_ENDS_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_SEPTIC_ENDS_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>

#include <array>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// The free scalars at one end of a septic blend: \f$ \gamma'' = \beta^2 d_2 + \beta_2 d_1 \f$,
/// \f$ \gamma''' = \beta^3 d_3 + \mu d_2 + \beta_3 d_1 \f$. The join is \f$ F^3 \f$ for all values and \f$ G^3 \f$ if and
/// only if \f$ \mu = 3\beta\beta_2 \f$ (or the curvature is zero).
template <class FT> struct Septic_end_parameters {
  FT beta2 = FT(0);
  FT mu = FT(0);
  FT beta3 = FT(0);

  friend bool operator==(const Septic_end_parameters& p, const Septic_end_parameters& q) {
    return p.beta2 == q.beta2 && p.mu == q.mu && p.beta3 == q.beta3;
  }
};

/// \ingroup PkgGeometricContinuityConstruction
/// What a strategy chooses for a septic blend.
template <class FT> struct Septic_parameters {
  Septic_end_parameters<FT> start, end;
  bool fallback_start = false; ///< the strategy is undefined at the start and used another value
  bool fallback_end = false;   ///< the same at the end
};

/// \ingroup PkgGeometricContinuityConstruction
/// One end of a septic blend: the point, the derivatives of the given curve, and the shape parameter.
template <class FT, int N> struct Septic_end {
  typedef Coordinate_vector<FT, N> Vector;

  Vector x, d1, d2, d3; ///< point and derivatives of the given curve
  FT beta;              ///< \f$ \beta_1 \f$ of the join
  int direction;        ///< 1 at the start of the blend, -1 at its end

  Vector first() const { return beta * d1; } ///< \f$ \gamma' \f$
  /// \f$ \gamma'' \f$
  Vector second(const Septic_end_parameters<FT>& p) const { return FT(beta * beta) * d2 + p.beta2 * d1; }
  /// \f$ \gamma''' \f$
  Vector third(const Septic_end_parameters<FT>& p) const {
    return FT(beta * beta * beta) * d3 + p.mu * d2 + p.beta3 * d1;
  }

  /// The four control points at this end, from the end inwards: \f$ b_0 \f$, \f$ b_1 = b_0 + \gamma'/7 \f$,
  /// \f$ b_2 = b_0 + 2\gamma'/7 + \gamma''/42 \f$, \f$ b_3 = b_0 + 3\gamma'/7 + \gamma''/14 + \gamma'''/210 \f$;
  /// at the end of the blend the odd derivatives change sign.
  std::array<Vector, 4> control_points(const Septic_end_parameters<FT>& p) const {
    const Vector g1 = FT(direction) * first(), g2 = second(p), g3 = FT(direction) * third(p);
    return {x, x + g1 / FT(7), x + FT(2) * g1 / FT(7) + g2 / FT(42),
            x + FT(3) * g1 / FT(7) + g2 / FT(14) + g3 / FT(210)};
  }
};

/// \ingroup PkgGeometricContinuityConstruction
/// What a strategy reads of a septic blend.
template <class FT, int N> struct Septic_ends {
  Septic_end<FT, N> start, end;

  /// The eight control points for given parameters.
  std::array<Coordinate_vector<FT, N>, 8> control_points(const Septic_parameters<FT>& p) const {
    const std::array<Coordinate_vector<FT, N>, 4> s = start.control_points(p.start), e = end.control_points(p.end);
    return {s[0], s[1], s[2], s[3], e[3], e[2], e[1], e[0]};
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_SEPTIC_ENDS_H
