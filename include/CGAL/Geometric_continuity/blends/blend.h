// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_H

#include <CGAL/Geometric_continuity/blends/automatic_shape.h>
#include <CGAL/Geometric_continuity/blends/internal/exact_blend.h>
#include <CGAL/Geometric_continuity/blends/quintic_strategies.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/local/end_jet.h>

#include <boost/config.hpp>

#include <array>
#include <string>
#include <type_traits>
#include <utility>

/// \file blend.h
/// The blend from one curve to the next: a Bézier curve on [0, 1] whose joins are \f$ G^2 \f$ (degree 5) or \f$ G^3 \f$,
/// \f$ F^3 \f$ (degree 7), whatever a strategy chooses for the scalars that are free. Portnov (5), (10), (15), corrected, with
/// \f$ \beta \f$ and \f$ \eta \f$; the formulas are in `blend_ends.h`.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// A quintic blend: a Bézier curve of degree 5 on [0, 1] together with the scalars that its strategy chose.
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits> struct Quintic_blend : Bezier_curve<Traits, 5> {
  typedef Quintic_parameters<typename Traits::FT> Parameters; ///< the type of what the strategy chose
  typedef Shape_parameters<typename Traits::FT> Shape;        ///< the type of the shape parameters

  Parameters parameters; ///< what the strategy chose
  Shape shape;           ///< the shape parameters, given or chosen

  /// From the coordinates of the control points.
  /// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
  Quintic_blend(const std::array<Geometric_continuity::Coordinates<Traits>, 6>& points, const Parameters& parameters,
                const Shape& shape)
      : Bezier_curve<Traits, 5>(points), parameters(parameters), shape(shape) {}
};

/// \ingroup PkgGeometricContinuityConstruction
/// A septic blend: a Bézier curve of degree 7 on [0, 1] together with the scalars that its strategy chose.
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits> struct Septic_blend : Bezier_curve<Traits, 7> {
  typedef Septic_parameters<typename Traits::FT> Parameters; ///< the type of what the strategy chose
  typedef Shape_parameters<typename Traits::FT> Shape;       ///< the type of the shape parameters

  Parameters parameters; ///< what the strategy chose
  Shape shape;           ///< the shape parameters, given or chosen

  /// From the coordinates of the control points.
  /// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
  Septic_blend(const std::array<Geometric_continuity::Coordinates<Traits>, 8>& points, const Parameters& parameters,
               const Shape& shape)
      : Bezier_curve<Traits, 7>(points), parameters(parameters), shape(shape) {}
};

/// \ingroup PkgGeometricContinuityConstruction
/// A blend by a strategy that chooses the shape parameters too, such as `Fair`, with what it reports.
/// \tparam Blend `Quintic_blend` or `Septic_blend` \tparam Report e.g. `Fair_report`
template <class Blend, class Report> struct Shaped_blend : Blend {
  Report report; ///< what the strategy reports
};

namespace internal {

[[noreturn]] BOOST_NOINLINE inline void refuse_blend(Error_code code, const char* place) {
  throw Error(code, std::string("blend: ") + place);
}

// Whether the square of a tangent, by which the formulas divide, is zero. Exact numbers need not be multiplied for this.
template <class FT, int N> CGAL_GC_FORCEINLINE bool is_zero_tangent(const Coordinate_vector<FT, N>& v) {
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
CGAL_GC_FORCEINLINE void check_blend_input(const Coordinate_jet<FT, N>& phi, const Coordinate_jet<FT, N>& psi,
                                           int order, const Shape_parameters<FT>& shape) {
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

// The one road of all blends: Ends is Quintic_ends or Septic_ends, Blend the type of the result.
template <class Blend, template <class, int> class Ends, class FT, int N, class Strategy>
CGAL_GC_FORCEINLINE Blend blend_of_jets(const Coordinate_jet<FT, N>& phi, const Coordinate_jet<FT, N>& psi,
                                        const Strategy& strategy, const Shape_parameters<FT>& shape) {
  check_blend_input(phi, psi, Ends<FT, N>::order, shape);
  if constexpr (is_blended_on_fractions<Ends, FT, N, Strategy>()) {
    const Exact_blend<Ends, FT, N> r = blend_on_fractions<Ends>(phi, psi, strategy, shape);
    return {r.points, r.parameters, shape};
  } else if constexpr (is_blended_lazily<Ends, FT, N, Strategy>()) {
    if (const auto r = blend_lazily<Ends>(phi, psi, strategy, shape)) return {r->points, r->parameters, shape};
  }
  // compilers keep e and p in registers only when they are not const
  Ends<FT, N> e(phi, psi, shape);
  typename Ends<FT, N>::Parameters p = strategy(e);
  return {e.control_points(p), p, shape};
}

template <class Strategy, class Jet, class = void> struct Chooses_shape : std::false_type {};
template <class Strategy, class Jet>
struct Chooses_shape<Strategy, Jet,
                     std::void_t<decltype(std::declval<const Strategy&>().choose(
                         std::declval<const Jet&>(), std::declval<const Jet&>()))>> : std::true_type {};

// The shape parameters are those of the strategy, if it chooses them, or those of automatic_shape().
template <class Blend, template <class, int> class Ends, class FT, int N, class Strategy>
CGAL_GC_FORCEINLINE auto blend_of_jets(const Coordinate_jet<FT, N>& phi, const Coordinate_jet<FT, N>& psi,
                                       const Strategy& strategy) {
  check_blend_input(phi, psi, Ends<FT, N>::order, Shape_parameters<FT>());
  if constexpr (Chooses_shape<Strategy, Coordinate_jet<FT, N>>::value) {
    const auto chosen = strategy.choose(phi, psi);
    return Shaped_blend<Blend, std::decay_t<decltype(chosen.report)>>{
        blend_of_jets<Blend, Ends>(phi, psi, chosen.strategy, chosen.shape), chosen.report};
  } else
    return blend_of_jets<Blend, Ends>(phi, psi, strategy, automatic_shape(phi, psi));
}

// `shape` is one argument, or none.
template <class Traits, class Strategy, class... Shape>
CGAL_GC_FORCEINLINE auto blend_of_jets(const Coordinate_jet<typename Traits::FT, dimension_v<Traits>>& phi,
                                       const Coordinate_jet<typename Traits::FT, dimension_v<Traits>>& psi,
                                       const Strategy& strategy, const Shape&... shape) {
  if constexpr (is_quintic_strategy_v<Strategy, Traits>)
    return blend_of_jets<Quintic_blend<Traits>, Quintic_ends>(phi, psi, strategy, shape...);
  else { // asked only now, so that a quintic strategy may be a generic lambda
    static_assert(is_septic_strategy_v<Strategy, Traits>, "the strategy models BlendStrategy");
    return blend_of_jets<Septic_blend<Traits>, Septic_ends>(phi, psi, strategy, shape...);
  }
}

// The ends of curves are read as continuity() reads them.
template <class Left, class Right, class Strategy, class... Shape>
auto blend_of_curves(const Left& phi, const Right& psi, const Strategy& strategy, const Shape&... shape) {
  typedef typename Left::Traits Traits;
  typedef typename Traits::FT FT;
  static_assert(std::is_same_v<Traits, typename Right::Traits>, "both curves must have the same traits class");
  constexpr int order = is_quintic_strategy_v<Strategy, Traits> ? 2 : 3;
  return blend_of_jets<Traits>(end_jet<FT>(phi, order), start_jet<FT>(psi, order), strategy, shape...);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the Bézier curve \f$ \gamma \f$ on [0, 1] that leads from the end of \f$ \varphi \f$ to the start of \f$ \psi \f$,
/// given by their jets there, with geometric continuity at both joins:
///
/// - with a quintic strategy (called with `Quintic_ends`) a `Quintic_blend` of degree 5 with \f$ G^2 \f$ joins, from jets of
///   order 2. Portnov (5), (10), (15), corrected and with \f$ \beta, \eta \f$;
/// - with a septic strategy (called with `Septic_ends`) a `Septic_blend` of degree 7 with \f$ G^3 \f$ or \f$ F^3 \f$ joins,
///   from jets of order 3.
///
/// With an exact kernel the joins are exact. A constant number of field operations in a given dimension.
///
/// \param shape the shape parameters, e.g. `{1, 1}` for Portnov's blends
/// \tparam Strategy a model of `BlendStrategy`
/// \throws Error `nonpositive_beta` unless \f$ \beta > 0 \f$ and \f$ \eta > 0 \f$ (checked first)
/// \throws Error `dimension_mismatch` for jets of different dimensions
/// \throws Error `jet_order_too_low` when a jet has fewer derivatives than the strategy's kind reads
/// \throws Error `zero_tangent` when a first derivative is zero
/// \throws Error `not_finite` when a shape parameter is infinite, or the result overflows the number type
template <class Traits, class Strategy>
CGAL_GC_FORCEINLINE auto blend(const Curve_jet<Traits>& phi, const Curve_jet<Traits>& psi, const Strategy& strategy,
                               const Shape_parameters<typename Traits::FT>& shape) {
  return internal::blend_of_jets<Traits>(phi, psi, strategy, shape);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the blend of two jets with the shape parameters that the strategy chooses, as `Fair` does, or else with those of
/// `automatic_shape()`: a `Quintic_blend` or a `Septic_blend`, or a `Shaped_blend` of one of these when the strategy chooses the
/// shape. A constant number of field operations in a given dimension, besides what the strategy needs.
/// \tparam Strategy a model of `BlendStrategy`
/// \throws Error `dimension_mismatch`, `jet_order_too_low`, `zero_tangent`, `not_finite` when the result overflows
template <class Traits, class Strategy>
CGAL_GC_FORCEINLINE auto blend(const Curve_jet<Traits>& phi, const Curve_jet<Traits>& psi, const Strategy& strategy) {
  return internal::blend_of_jets<Traits>(phi, psi, strategy);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the quintic blend of least energy \f$ \int |\gamma'''|^2 \f$ of two jets of order at least 2, with \f$ G^2 \f$ joins
/// and the shape parameters of `automatic_shape()`. A constant number of field operations in a given dimension.
/// \throws Error `dimension_mismatch`, `jet_order_too_low`, `zero_tangent`, `not_finite` when the result overflows
template <class Traits> Quintic_blend<Traits> blend(const Curve_jet<Traits>& phi, const Curve_jet<Traits>& psi) {
  return blend(phi, psi, Minimal_energy<3>());
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the blend from the end of the curve `phi` to the start of the curve `psi`: a `Quintic_blend` with \f$ G^2 \f$ joins
/// or a `Septic_blend` with \f$ G^3 \f$ or \f$ F^3 \f$ joins, by the kind of the strategy. The ends are read by `end_jet()` and
/// `start_jet()`, as `continuity()` reads them. A constant number of field operations in a given dimension, besides the jets.
/// \param shape the shape parameters, e.g. `{1, 1}` for Portnov's blends
/// \tparam Left, Right models of `ParametricCurve` with one traits class
/// \tparam Strategy a model of `BlendStrategy`
/// \throws Error `nonpositive_beta` unless \f$ \beta > 0 \f$ and \f$ \eta > 0 \f$ (checked first)
/// \throws Error `dimension_mismatch`, `zero_tangent`, `not_finite` when a shape parameter is infinite or the result overflows
template <class Left, class Right, class Strategy>
auto blend(const Left& phi, const Right& psi, const Strategy& strategy,
           const Shape_parameters<typename Left::Traits::FT>& shape) {
  return internal::blend_of_curves(phi, psi, strategy, shape);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the blend of two curves with the shape parameters that the strategy chooses, as `Fair` does, or else with those of
/// `automatic_shape()`: a `Quintic_blend` or a `Septic_blend`, or a `Shaped_blend` of one of these when the strategy chooses the
/// shape. A constant number of field operations in a given dimension, besides the jets and what the strategy needs.
/// \tparam Left, Right models of `ParametricCurve` with one traits class
/// \tparam Strategy a model of `BlendStrategy`
/// \throws Error `dimension_mismatch`, `zero_tangent`, `not_finite` when the result overflows
template <class Left, class Right, class Strategy>
auto blend(const Left& phi, const Right& psi, const Strategy& strategy) {
  return internal::blend_of_curves(phi, psi, strategy);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the quintic blend of least energy \f$ \int |\gamma'''|^2 \f$ from the end of the curve `phi` to the start of the
/// curve `psi`, with \f$ G^2 \f$ joins and the shape parameters of `automatic_shape()`.
/// \tparam Left, Right models of `ParametricCurve` with one traits class
/// \throws Error `dimension_mismatch`, `zero_tangent`, `not_finite` when the result overflows
template <class Left, class Right> Quintic_blend<typename Left::Traits> blend(const Left& phi, const Right& psi) {
  return blend(phi, psi, Minimal_energy<3>());
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_H
