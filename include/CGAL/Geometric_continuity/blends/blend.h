// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_H

#include <CGAL/Geometric_continuity/blends/internal/blend_lazily.h>
#include <CGAL/Geometric_continuity/blends/internal/blend_on_fractions.h>
#include <CGAL/Geometric_continuity/blends/quintic_strategies.h>
#include <CGAL/Geometric_continuity/blends/septic_strategies.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_conversion.h>

#include <boost/config.hpp>

#include <array>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// A quintic blend: a Bézier curve of degree 5 on [0, 1] together with the scalars that its strategy chose.
template <class Traits> struct Quintic_blend : Bezier_curve<Traits, 5> {
  Quintic_parameters<typename Traits::FT> parameters;

  /// From the coordinates of the control points.
  Quintic_blend(const std::array<Geometric_continuity::Coordinates<Traits>, 6>& points,
                const Quintic_parameters<typename Traits::FT>& parameters)
      : Bezier_curve<Traits, 5>(points), parameters(parameters) {}
};

/// \ingroup PkgGeometricContinuityConstruction
/// A septic blend: a Bézier curve of degree 7 on [0, 1] together with the scalars that its strategy chose.
template <class Traits> struct Septic_blend : Bezier_curve<Traits, 7> {
  Septic_parameters<typename Traits::FT> parameters;

  /// From the coordinates of the control points.
  Septic_blend(const std::array<Geometric_continuity::Coordinates<Traits>, 8>& points,
               const Septic_parameters<typename Traits::FT>& parameters)
      : Bezier_curve<Traits, 7>(points), parameters(parameters) {}
};

namespace internal {

[[noreturn]] BOOST_NOINLINE inline void refuse_blend(Error_code code, const char* place) {
  throw Error(code, std::string("blend: ") + place);
}

// Whether the square of a tangent, by which the formulas divide, is zero. Exact numbers need not be multiplied for this.
template <class FT, int N> BOOST_FORCEINLINE bool is_zero_tangent(const Coordinate_vector<FT, N>& v) {
  if constexpr (Rational_parts<FT>::value)
    return is_zero(v);
  else
    return dot(v, v) == FT(0);
}
template <class ET, int N> bool is_zero_tangent(const Coordinate_vector<Lazy_exact_nt<ET>, N>& v) {
  for (const Lazy_exact_nt<ET>& x : v) // most often an interval tells
    if (!x.approx().do_overlap(Interval_nt<false>(0))) return false;
  return is_zero(v);
}

// Called for each blend, and small when the shape parameters are constants: written out at the place of the call.
template <class FT, int N>
BOOST_FORCEINLINE void check_blend_input(const Coordinate_jet<FT, N>& phi, const Coordinate_jet<FT, N>& psi, int order,
                                         const Shape_parameters<FT>& shape) {
  if (!(FT(0) < shape.beta)) refuse_blend(Error_code::nonpositive_beta, "beta, at the end of the first curve");
  if (!(FT(0) < shape.eta)) refuse_blend(Error_code::nonpositive_beta, "eta, at the start of the second curve");
  check_finite(shape.beta, "blend: beta");
  check_finite(shape.eta, "blend: eta");
  if (N == 0 && phi.dimension() != psi.dimension())
    refuse_blend(Error_code::dimension_mismatch, "the dimensions of the two curves differ");
  if (phi.order() < order || psi.order() < order)
    refuse_blend(Error_code::jet_order_too_low,
                 order == 2 ? "jets of order 2 are needed" : "jets of order 3 are needed");
  if (is_zero_tangent(phi[1])) refuse_blend(Error_code::zero_tangent, "end of the first curve");
  if (is_zero_tangent(psi[1])) refuse_blend(Error_code::zero_tangent, "start of the second curve");
}

template <class Traits, class Strategy>
BOOST_FORCEINLINE Quintic_blend<Traits> quintic_blend(const Curve_jet<Traits>& phi, const Curve_jet<Traits>& psi,
                                                      const Strategy& strategy,
                                                      const Shape_parameters<typename Traits::FT>& shape) {
  typedef typename Traits::FT FT;
  check_blend_input<FT, dimension_v<Traits>>(phi, psi, 2, shape);
  if constexpr (is_blended_on_fractions<FT, Strategy>) {
    const auto [points, parameters] =
        blend_on_fractions<Quintic_form, FT, dimension_v<Traits>>(phi, psi, strategy, shape);
    return {points, parameters};
  } else if constexpr (is_blended_lazily<FT, Strategy>) {
    if (const auto r = blend_lazily<Quintic_form>(phi, psi, strategy, shape)) return {r->points, r->parameters};
  }
  const FT &beta = shape.beta, &eta = shape.eta;
  // compilers keep e and p in registers only when they are not const
  Quintic_ends<FT, dimension_v<Traits>> e(phi[0], psi[0], beta * phi[1], eta * psi[1], FT(beta * beta) * phi[2],
                                          FT(eta * eta) * psi[2]);
  Quintic_parameters<FT> p = strategy(e);
  return {{e.a1, e.b1(), e.c1(p.s1), e.c2(p.s2), e.b2(), e.a2}, p};
}

template <class Traits, class Strategy>
Septic_blend<Traits> septic_blend(const Curve_jet<Traits>& phi, const Curve_jet<Traits>& psi, const Strategy& strategy,
                                  const Shape_parameters<typename Traits::FT>& shape) {
  typedef typename Traits::FT FT;
  check_blend_input<FT, dimension_v<Traits>>(phi, psi, 3, shape);
  if constexpr (is_blended_on_fractions<FT, Strategy>) {
    const auto [points, parameters] =
        blend_on_fractions<Septic_form, FT, dimension_v<Traits>>(phi, psi, strategy, shape);
    return {points, parameters};
  } else if constexpr (is_blended_lazily<FT, Strategy>) {
    if (const auto r = blend_lazily<Septic_form>(phi, psi, strategy, shape)) return {r->points, r->parameters};
  }
  const Septic_ends<FT, dimension_v<Traits>> e{{phi[0], phi[1], phi[2], phi[3], shape.beta, 1},
                                               {psi[0], psi[1], psi[2], psi[3], shape.eta, -1}};
  const Septic_parameters<FT> p = strategy(e);
  return {e.control_points(p), p};
}

// A strategy is quintic when it can be called with Quintic_ends, septic when with Septic_ends.
template <class Traits, class Strategy>
constexpr bool is_quintic_strategy =
    std::is_invocable_v<const Strategy&, const Quintic_ends<typename Traits::FT, dimension_v<Traits>>&>;
template <class Traits, class Strategy>
constexpr bool is_septic_strategy =
    std::is_invocable_v<const Strategy&, const Septic_ends<typename Traits::FT, dimension_v<Traits>>&>;

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// The Bézier curve \f$ \gamma \f$ on [0, 1] that leads from the end of \f$ \varphi \f$ to the start of \f$ \psi \f$,
/// given by their jets there, with geometric continuity at both joins:
///
/// - with a quintic strategy (called with `Quintic_ends`) a `Quintic_blend` of degree 5 with \f$ G^2 \f$ joins, from jets of
///   order 2. Portnov (5), (10), (15), corrected and with \f$ \beta, \eta \f$;
/// - with a septic strategy (called with `Septic_ends`) a `Septic_blend` of degree 7 with \f$ G^3 \f$ or \f$ F^3 \f$ joins,
///   from jets of order 3.
///
/// With an exact kernel the joins are exact; a constant number of field operations.
///
/// \tparam Strategy a model of `BlendStrategy`
/// \throws Error `nonpositive_beta` unless \f$ \beta > 0 \f$ and \f$ \eta > 0 \f$ (checked first),
///   `dimension_mismatch` for jets of different dimensions, `jet_order_too_low`, `zero_tangent` when a first derivative is
///   zero, `not_finite` when the result overflows the number type
template <class Traits, class Strategy>
BOOST_FORCEINLINE auto blend(const Curve_jet<Traits>& phi, const Curve_jet<Traits>& psi, const Strategy& strategy,
                             const Shape_parameters<typename Traits::FT>& shape = {}) {
  if constexpr (internal::is_quintic_strategy<Traits, Strategy>)
    return internal::quintic_blend(phi, psi, strategy, shape);
  else { // asked only now, so that a quintic strategy may be a generic lambda
    static_assert(internal::is_septic_strategy<Traits, Strategy>, "the strategy models BlendStrategy");
    return internal::septic_blend(phi, psi, strategy, shape);
  }
}

/// \ingroup PkgGeometricContinuityConstruction
/// The quintic blend of least energy \f$ \int |\gamma'''|^2 \f$ of two jets of order at least 2.
template <class Traits> Quintic_blend<Traits> blend(const Curve_jet<Traits>& phi, const Curve_jet<Traits>& psi) {
  return blend(phi, psi, Minimal_energy<3>());
}

/// \ingroup PkgGeometricContinuityConstruction
/// The blend from the end of the curve `phi` to the start of the curve `psi`.
/// \tparam Left, Right models of `ParametricCurve` with one traits class
template <class Left, class Right, class Strategy>
auto blend(const Left& phi, const Right& psi, const Strategy& strategy,
           const Shape_parameters<typename Left::Traits::FT>& shape = {}) {
  typedef typename Left::Traits Traits;
  static_assert(std::is_same_v<Traits, typename Right::Traits>, "both curves must have the same traits class");
  constexpr int order = internal::is_quintic_strategy<Traits, Strategy> ? 2 : 3;
  return blend(Curve_jet<Traits>(phi.jet(phi.domain().second, order)),
               Curve_jet<Traits>(psi.jet(psi.domain().first, order)), strategy, shape);
}

/// \ingroup PkgGeometricContinuityConstruction
/// The quintic blend of least energy \f$ \int |\gamma'''|^2 \f$ of two curves.
template <class Left, class Right> Quintic_blend<typename Left::Traits> blend(const Left& phi, const Right& psi) {
  return blend(phi, psi, Minimal_energy<3>());
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_H
