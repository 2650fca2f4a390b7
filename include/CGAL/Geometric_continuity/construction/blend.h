// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CONSTRUCTION_BLEND_H
#define CGAL_GEOMETRIC_CONTINUITY_CONSTRUCTION_BLEND_H

#include <CGAL/Geometric_continuity/construction/quintic_strategies.h>
#include <CGAL/Geometric_continuity/construction/septic_strategies.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>

#include <array>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// A quintic blend: a Bézier curve of degree 5 on [0, 1] together with the scalars that its strategy chose.
template <class Traits> struct Quintic_blend : Bezier_curve<Traits, 5> {
  Quintic_parameters<typename Traits::FT> parameters;

  Quintic_blend(const Bezier_curve<Traits, 5>& curve, const Quintic_parameters<typename Traits::FT>& parameters)
      : Bezier_curve<Traits, 5>(curve), parameters(parameters) {}
};

/// \ingroup PkgGeometricContinuityConstruction
/// A septic blend: a Bézier curve of degree 7 on [0, 1] together with the scalars that its strategy chose.
template <class Traits> struct Septic_blend : Bezier_curve<Traits, 7> {
  Septic_parameters<typename Traits::FT> parameters;

  Septic_blend(const Bezier_curve<Traits, 7>& curve, const Septic_parameters<typename Traits::FT>& parameters)
      : Bezier_curve<Traits, 7>(curve), parameters(parameters) {}
};

namespace internal {

template <class FT, int N>
void check_blend_input(const Coordinate_jet<FT, N>& phi, const Coordinate_jet<FT, N>& psi, int order,
                       const Shape_parameters<FT>& shape) {
  if (!(FT(0) < shape.beta)) throw Error(Error_code::nonpositive_beta, "blend: beta, at the end of the first curve");
  if (!(FT(0) < shape.eta)) throw Error(Error_code::nonpositive_beta, "blend: eta, at the start of the second curve");
  check_finite(shape.beta, "blend: beta");
  check_finite(shape.eta, "blend: eta");
  if (phi.dimension() != psi.dimension())
    throw Error(Error_code::dimension_mismatch, "blend: the first curve has dimension " +
                                                    std::to_string(phi.dimension()) + ", the second " +
                                                    std::to_string(psi.dimension()));
  if (phi.order() < order || psi.order() < order)
    throw Error(Error_code::jet_order_too_low, "blend: jets of order " + std::to_string(order) + " are needed");
  if (dot(phi[1], phi[1]) == FT(0)) throw Error(Error_code::zero_tangent, "blend: end of the first curve");
  if (dot(psi[1], psi[1]) == FT(0)) throw Error(Error_code::zero_tangent, "blend: start of the second curve");
}

template <class Traits, std::size_t points>
Bezier_curve<Traits, static_cast<int>(points) - 1> curve_from(const std::array<Coordinates<Traits>, points>& b) {
  std::array<typename Traits::Point, points> p;
  for (std::size_t i = 0; i < points; ++i) {
    for (const typename Traits::FT& x : b[i]) check_finite(x, "blend: the result overflows");
    p[i] = to_point<Traits>(b[i]);
  }
  return {p.begin(), p.end()};
}

template <class Traits, class Strategy>
Quintic_blend<Traits> quintic_blend(const Curve_jet<Traits>& phi, const Curve_jet<Traits>& psi,
                                    const Strategy& strategy, const Shape_parameters<typename Traits::FT>& shape) {
  typedef typename Traits::FT FT;
  check_blend_input<FT, dimension_v<Traits>>(phi, psi, 2, shape);
  const FT &beta = shape.beta, &eta = shape.eta;
  const Quintic_ends<FT, dimension_v<Traits>> e(phi[0], psi[0], beta * phi[1], eta * psi[1], FT(beta * beta) * phi[2],
                                                FT(eta * eta) * psi[2]);
  const Quintic_parameters<FT> p = strategy(e);
  return {curve_from<Traits>(std::array<Coordinates<Traits>, 6>{e.a1, e.b1(), e.c1(p.s1), e.c2(p.s2), e.b2(), e.a2}),
          p};
}

template <class Traits, class Strategy>
Septic_blend<Traits> septic_blend(const Curve_jet<Traits>& phi, const Curve_jet<Traits>& psi, const Strategy& strategy,
                                  const Shape_parameters<typename Traits::FT>& shape) {
  typedef typename Traits::FT FT;
  check_blend_input<FT, dimension_v<Traits>>(phi, psi, 3, shape);
  const Septic_ends<FT, dimension_v<Traits>> e{{phi[0], phi[1], phi[2], phi[3], shape.beta, 1},
                                               {psi[0], psi[1], psi[2], psi[3], shape.eta, -1}};
  const Septic_parameters<FT> p = strategy(e);
  return {curve_from<Traits>(e.control_points(p)), p};
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
auto blend(const Curve_jet<Traits>& phi, const Curve_jet<Traits>& psi, const Strategy& strategy,
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

#endif // CGAL_GEOMETRIC_CONTINUITY_CONSTRUCTION_BLEND_H
