// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_CONNECTION_COEFFICIENTS_H
#define CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_CONNECTION_COEFFICIENTS_H

#include <CGAL/Geometric_continuity/Error.h>

#include <string>

/// \file connection_coefficients.h
/// The scalars of a torsion-continuous join of two Bézier polygons of one degree `m`, see `alternatives.h`: those that
/// choose the points, those that connect the derivatives, and how they determine each other. A constant number of field
/// operations each.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// The scalars that choose \f$ b_2 \f$ (`c0`) and \f$ b_3 \f$ (`c1`, `c2`) of a right polygon. Hagen (3.2.2), (3.2.3).
/// \tparam FT a field number type
template <class FT> struct Alternative_parameters {
  FT c0; ///< \f$ C_0 \f$
  FT c1; ///< \f$ C_1 \f$
  FT c2; ///< \f$ C_2 \f$
};

/// \ingroup PkgGeometricContinuityConstruction
/// The coefficients that connect the derivatives at a join of the curves `X` and `Y` over intervals of length 1:
/// \f$ Y' = \beta_1 X' \f$, \f$ Y'' = \beta_1^2 X'' + \beta_2 X' \f$, \f$ Y''' = \beta_1^3 X''' + \mu X'' + \delta X' \f$. The
/// join is \f$ F^3 \f$, and \f$ G^3 \f$ with \f$ \beta_3 = \delta \f$ when \f$ \mu = 3\beta_1\beta_2 \f$. Hagen (2.2).
/// \tparam FT a field number type
template <class FT> struct Connection_coefficients {
  FT beta1; ///< \f$ \beta_1 \f$
  FT beta2; ///< \f$ \beta_2 \f$
  FT mu;    ///< \f$ \mu \f$
  FT delta; ///< \f$ \delta \f$
};

namespace internal {

inline void check_degree(int m, int least, const char* place) {
  if (m < least)
    throw Error(Error_code::wrong_number_of_points,
                std::string(place) + ": there are no alternatives of degree " + std::to_string(m));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the scalars of the \f$ C^2 \f$ and \f$ C^3 \f$ members, when `beta` is the ratio of the parameter intervals:
/// \f$ C_0 = 2\beta^2 + 2\beta \f$, \f$ C_1 = \beta^3 + 3\beta^2 + 3\beta \f$, \f$ C_2 = 2\beta^3 + 3\beta^2 \f$; that is 4, 7, 5
/// for \f$ \beta = 1 \f$.
template <class FT> Alternative_parameters<FT> ck_parameters(const FT& beta) {
  const FT square = beta * beta, cube = square * beta;
  return {FT(FT(2) * square + FT(2) * beta), FT(cube + FT(3) * square + FT(3) * beta),
          FT(FT(2) * cube + FT(3) * square)};
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns \f$ \beta_2 = (m-1) (C_0 - 2\beta^2 - 2\beta) \f$.
/// \throws Error `wrong_number_of_points` when `m < 2`
template <class FT> FT connection_beta2(int m, const FT& beta, const FT& c0) {
  internal::check_degree(m, 2, "connection_beta2");
  return FT(FT(m - 1) * (c0 - ck_parameters<FT>(beta).c0));
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns all coefficients: \f$ \beta_1 = \beta \f$, \f$ \beta_2 \f$ as `connection_beta2()`, \f$ \mu = (m-2) (C_2 - 3\beta^2 - 2\beta^3) \f$,
/// \f$ \delta = (m-1)(m-2) (C_1 - C_2 - 3C_0 + \beta^3 + 6\beta^2 + 3\beta) \f$.
/// \throws Error `wrong_number_of_points` when `m < 3`
template <class FT>
Connection_coefficients<FT> connection_coefficients(int m, const FT& beta, const Alternative_parameters<FT>& c) {
  internal::check_degree(m, 3, "connection_coefficients");
  const Alternative_parameters<FT> ck = ck_parameters<FT>(beta);
  const FT mu = FT(m - 2) * (c.c2 - ck.c2);
  // beta^3 + 6 beta^2 + 3 beta = 3 (C^2 choice of C_0) - (C^3 choice of C_1) + (C^3 choice of C_2)
  const FT delta = FT(m - 1) * FT(m - 2) * ((c.c1 - ck.c1) - (c.c2 - ck.c2) - FT(3) * (c.c0 - ck.c0));
  return {beta, connection_beta2<FT>(m, beta, c.c0), mu, delta};
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the \f$ C_2 \f$ of the \f$ G^3 \f$ members of the plane:
/// \f$ C_2 = 3\beta^2 + 2\beta^3 + 3\beta \frac{m-1}{m-2} (C_0 - 2\beta^2 - 2\beta) \f$.
/// \throws Error `wrong_number_of_points` when `m < 3`
template <class FT> FT g3_c2(int m, const FT& beta, const FT& c0) {
  internal::check_degree(m, 3, "g3_c2");
  return FT(ck_parameters<FT>(beta).c2 + FT(3) * beta * connection_beta2<FT>(m, beta, c0) / FT(m - 2));
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the \f$ C_1 \f$ for which the connection has a wished \f$ \delta \f$:
/// \f$ C_1 = C_2 + 3C_0 - \beta^3 - 6\beta^2 - 3\beta + \frac{\delta}{(m-1)(m-2)} \f$.
/// \throws Error `wrong_number_of_points` when `m < 3`
template <class FT> FT connection_c1(int m, const FT& beta, const FT& c0, const FT& c2, const FT& delta) {
  internal::check_degree(m, 3, "connection_c1");
  const Alternative_parameters<FT> ck = ck_parameters<FT>(beta);
  return FT(ck.c1 + (c2 - ck.c2) + FT(3) * (c0 - ck.c0) + delta / (FT(m - 1) * FT(m - 2)));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_CONNECTION_COEFFICIENTS_H
