// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_H

#include <CGAL/Geometric_continuity/blends/blend_ends.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>
#include <CGAL/Geometric_continuity/blends/internal/exact_blend.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/internal/independent_iterations.h>
#include <CGAL/Geometric_continuity/internal/parallel.h>
#include <CGAL/Geometric_continuity/joins/Curve_ends.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>

#include <boost/config.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

/// \file blend.h
/// The blend from one curve to the next: a Bézier curve on [0, 1] whose joins are \f$ G^2 \f$
/// (degree 5) or \f$ G^3 \f$, \f$ F^3 \f$ (degree 7), whatever a strategy chooses for the scalars
/// that are free. Portnov (5), (10), (15), corrected, with \f$ \beta \f$ and \f$ \eta \f$; the
/// formulas are in `blend_ends.h`.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// A blend: a Bézier curve on [0, 1] together with the scalars that its strategy chose.
/// `Quintic_blend` and `Septic_blend` are blends.
/// \tparam Traits a model of `GeometricContinuityTraits` \tparam Degree 5 or 7
/// \tparam Parameters_ `Quintic_parameters` or `Septic_parameters` of the numbers of the traits
///   class
template <class Traits, int Degree, class Parameters_> struct Blend_curve : Bezier_curve<Traits, Degree> {
  typedef Parameters_ Parameters;                      ///< the type of what the strategy chose
  typedef Shape_parameters<typename Traits::FT> Shape; ///< the type of the shape parameters

  Parameters parameters; ///< what the strategy chose
  Shape shape;           ///< the shape parameters, given or chosen

  /// Constructs the blend from the coordinates of its control points.
  /// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
  CGAL_GC_FORCEINLINE Blend_curve(const std::array<Geometric_continuity::Coordinates<Traits>, Degree + 1>& points,
                                  const Parameters& given_parameters, const Shape& given_shape)
      : Bezier_curve<Traits, Degree>(points), parameters(given_parameters), shape(given_shape) {}
};

/// \ingroup PkgGeometricContinuityConstruction
/// A quintic blend: a Bézier curve of degree 5 on [0, 1] together with the scalars that its
/// strategy chose.
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits> using Quintic_blend = Blend_curve<Traits, 5, Quintic_parameters<typename Traits::FT>>;

/// \ingroup PkgGeometricContinuityConstruction
/// A septic blend: a Bézier curve of degree 7 on [0, 1] together with the scalars that its strategy
/// chose.
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits> using Septic_blend = Blend_curve<Traits, 7, Septic_parameters<typename Traits::FT>>;

/// \ingroup PkgGeometricContinuityConstruction
/// A blend by a strategy that also chooses the shape parameters, such as `Fair`, with the report of
/// the strategy.
/// \tparam Blend `Quintic_blend` or `Septic_blend` \tparam Report e.g. `Fair_report`
template <class Blend, class Report> struct Shaped_blend : Blend {
  Report report; ///< what the strategy reports
};

/// \ingroup PkgGeometricContinuityContinuity
/// The ends of a blend, which is a Bézier curve.
template <class Traits, int Degree, class Parameters>
struct Curve_ends<Blend_curve<Traits, Degree, Parameters>> : Bezier_ends<Blend_curve<Traits, Degree, Parameters>> {};
/// \ingroup PkgGeometricContinuityContinuity
/// The ends of a blend with a report.
template <class Blend, class Report>
struct Curve_ends<Shaped_blend<Blend, Report>> : Bezier_ends<Shaped_blend<Blend, Report>> {};

namespace internal {

[[noreturn]] BOOST_NOINLINE inline void refuse_blend(Error_code code, const char* place) {
  throw Error(code, std::string("blend: ") + place);
}

// Returns whether the square of a tangent, by which the formulas divide, is zero. Exact numbers
// need not be multiplied for this.
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

// Called for each blend, and small when the shape parameters are constants: written out at the
// place of the call.
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

// All blends go through this function: Ends is Quintic_ends or Septic_ends, Blend the type of the
// result.
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

// The shape parameters are those of the strategy, if it chooses them, or those of
// automatic_shape().
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
    constexpr bool is_strategy = is_septic_strategy_v<Strategy, Traits>;
    static_assert(is_strategy, "the third argument of blend() is a strategy, a model of BlendStrategy such as Fair() "
                               "(G2, as blend(phi, psi) is without a third argument) or Fair_g3()");
    if constexpr (is_strategy)
      return blend_of_jets<Septic_blend<Traits>, Septic_ends>(phi, psi, strategy, shape...);
    else // so that there is one error
      return blend_of_jets<Quintic_blend<Traits>, Quintic_ends>(phi, psi, Minimal_energy<3>(), shape...);
  }
}

// The ends of curves are read as continuity() reads them.
template <class Left, class Right, class Strategy, class... Shape>
auto blend_of_curves(const Left& phi, const Right& psi, const Strategy& strategy, const Shape&... shape) {
  typedef typename Left::Traits Traits;
  typedef typename Traits::FT FT;
  static_assert(std::is_same_v<Traits, typename Right::Traits>, "both curves must have the same traits class");
  static_assert(!is_surface<Left>, "blend(phi, psi) is of two curves; of two surfaces, name the edges, as in "
                                   "blend(a, Patch_edge::v1, b, Patch_edge::v0)");
  constexpr int order = is_quintic_strategy_v<Strategy, Traits> ? 2 : 3;
  if constexpr (is_surface<Left>) // so that there is one error
    return blend_of_jets<Traits>(Coordinate_jet<FT, dimension_v<Traits>>(), Coordinate_jet<FT, dimension_v<Traits>>(),
                                 strategy, shape...);
  else
    return blend_of_jets<Traits>(end_jet<FT>(phi, order), start_jet<FT>(psi, order), strategy, shape...);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the Bézier curve \f$ \gamma \f$ on [0, 1] that leads from the end of \f$ \varphi \f$ to
/// the start of \f$ \psi \f$, given by their jets there, with geometric continuity at both joins:
///
/// - with a quintic strategy (called with `Quintic_ends`) a `Quintic_blend` of degree 5 with
///   \f$ G^2 \f$ joins, from jets of order 2. Portnov (5), (10), (15), corrected and with
///   \f$ \beta, \eta \f$;
/// - with a septic strategy (called with `Septic_ends`) a `Septic_blend` of degree 7 with
///   \f$ G^3 \f$ or \f$ F^3 \f$ joins, from jets of order 3.
///
/// With an exact kernel the joins are exact. A constant number of field operations in a given
/// dimension.
///
/// \param shape the shape parameters, e.g. `{1, 1}` for Portnov's blends
/// \tparam Strategy a model of `BlendStrategy`
/// \throws Error `nonpositive_beta` unless \f$ \beta > 0 \f$ and \f$ \eta > 0 \f$ (checked first)
/// \throws Error `dimension_mismatch` for jets of different dimensions
/// \throws Error `jet_order_too_low` when a jet has fewer derivatives than the strategy's kind
///   reads
/// \throws Error `zero_tangent` when a first derivative is zero
/// \throws Error `not_finite` when a shape parameter is infinite, or the result overflows the
///   number type
template <class Traits, class Strategy>
CGAL_GC_FORCEINLINE auto blend(const Curve_jet<Traits>& phi, const Curve_jet<Traits>& psi, const Strategy& strategy,
                               const Shape_parameters<typename Traits::FT>& shape) {
  return internal::blend_of_jets<Traits>(phi, psi, strategy, shape);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the blend of two jets with the shape parameters that the strategy chooses, as `Fair`
/// does, or else with those of `automatic_shape()`: a `Quintic_blend` or a `Septic_blend`, or a
/// `Shaped_blend` of one of these when the strategy chooses the shape. A constant number of field
/// operations in a given dimension, besides what the strategy needs.
/// \tparam Strategy a model of `BlendStrategy`
/// \throws Error `dimension_mismatch`, `jet_order_too_low`, `zero_tangent`, `not_finite` when the
///   result overflows
template <class Traits, class Strategy>
CGAL_GC_FORCEINLINE auto blend(const Curve_jet<Traits>& phi, const Curve_jet<Traits>& psi, const Strategy& strategy) {
  return internal::blend_of_jets<Traits>(phi, psi, strategy);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the quintic blend of least energy \f$ \int |\gamma'''|^2 \f$ of two jets of order at
/// least 2, with \f$ G^2 \f$ joins and the shape parameters of `automatic_shape()`. A constant
/// number of field operations in a given dimension.
/// \throws Error `dimension_mismatch`, `jet_order_too_low`, `zero_tangent`, `not_finite` when the
///   result overflows
template <class Traits> Quintic_blend<Traits> blend(const Curve_jet<Traits>& phi, const Curve_jet<Traits>& psi) {
  return blend(phi, psi, Minimal_energy<3>());
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the blend from the end of the curve `phi` to the start of the curve `psi`: a
/// `Quintic_blend` with \f$ G^2 \f$ joins or a `Septic_blend` with \f$ G^3 \f$ or \f$ F^3 \f$
/// joins, by the kind of the strategy. The ends are read by `end_jet()` and `start_jet()`, as
/// `continuity()` reads them. A constant number of field operations in a given dimension, besides
/// the jets.
/// \param shape the shape parameters, e.g. `{1, 1}` for Portnov's blends
/// \tparam Left, Right models of `ParametricCurve` with one traits class
/// \tparam Strategy a model of `BlendStrategy`
/// \throws Error `nonpositive_beta` unless \f$ \beta > 0 \f$ and \f$ \eta > 0 \f$ (checked first)
/// \throws Error `dimension_mismatch`, `zero_tangent`, `not_finite` when a shape parameter is
///   infinite or the result overflows
template <class Left, class Right, class Strategy>
auto blend(const Left& phi, const Right& psi, const Strategy& strategy,
           const Shape_parameters<typename Left::Traits::FT>& shape) {
  return internal::blend_of_curves(phi, psi, strategy, shape);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the blend of two curves with the shape parameters that the strategy chooses, as `Fair`
/// does, or else with those of `automatic_shape()`: a `Quintic_blend` or a `Septic_blend`, or a
/// `Shaped_blend` of one of these when the strategy chooses the shape. A constant number of field
/// operations in a given dimension, besides the jets and what the strategy needs.
/// \tparam Left, Right models of `ParametricCurve` with one traits class
/// \tparam Strategy a model of `BlendStrategy`
/// \throws Error `dimension_mismatch`, `zero_tangent`, `not_finite` when the result overflows
template <class Left, class Right, class Strategy>
auto blend(const Left& phi, const Right& psi, const Strategy& strategy) {
  return internal::blend_of_curves(phi, psi, strategy);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the quintic blend of least energy \f$ \int |\gamma'''|^2 \f$ of two curves or jets with
/// the given shape parameters, e.g. `blend(phi, psi, {1, 1})`, with \f$ G^2 \f$ joins.
/// \tparam Left, Right models of `ParametricCurve` with one traits class, or `Curve_jet`
/// \throws Error as with a strategy and shape parameters
template <class Left, class Right, class FT = typename Left::Traits::FT>
Quintic_blend<typename Left::Traits> blend(const Left& phi, const Right& psi, const Shape_parameters<FT>& shape) {
  return blend(phi, psi, Minimal_energy<3>(), shape);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the quintic blend of least energy \f$ \int |\gamma'''|^2 \f$ from the end of the curve
/// `phi` to the start of the curve `psi`, with \f$ G^2 \f$ joins and the shape parameters of
/// `automatic_shape()`.
/// \tparam Left, Right models of `ParametricCurve` with one traits class
/// \throws Error `dimension_mismatch`, `zero_tangent`, `not_finite` when the result overflows
template <class Left, class Right> Quintic_blend<typename Left::Traits> blend(const Left& phi, const Right& psi) {
  return blend(phi, psi, Minimal_energy<3>());
}

/// \ingroup PkgGeometricContinuityConstruction
/// Many quintic blends as a structure of arrays: for each control point and each coordinate one
/// array.
/// \tparam FT a field number type, usually `double` \tparam N the dimension
template <class FT, int N> class Blend_arrays {
  Jet_arrays<FT, N, 5> points_;

public:
  /// Changes the number of blends. The numbers are unspecified afterwards.
  void resize(std::size_t n) { points_.resize(n); }
  /// Returns the number of blends.
  std::size_t size() const { return points_.size(); }
  /// Returns the coordinates number `i` of the control points number `j`, 0 to 5, of all blends, an
  /// array of `size()` numbers.
  FT* array(int j, int i) { return points_.array(j, i); }
  /// Returns the coordinates number `i` of the control points number `j`, 0 to 5, of all blends, an
  /// array of `size()` numbers.
  const FT* array(int j, int i) const { return points_.array(j, i); }
};

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_OFF

namespace internal {

template <class FT, int N, int k> FT squared_tangent(const Jet_arrays<FT, N, k>& jets, std::size_t at) {
  FT square(0);
  for_each_index<N>([&](int i) CGAL_GC_FORCEINLINE_LAMBDA { square += jets.array(1, i)[at] * jets.array(1, i)[at]; });
  return square;
}

template <class FT, int N, int k> void check_tangents(const Jet_arrays<FT, N, k>& jets, const char* place) {
  std::size_t zeros = 0; // counted first, which is done for several jets at a time
  for (std::size_t at = 0; at < jets.size(); ++at) zeros += squared_tangent(jets, at) == FT(0) ? 1 : 0;
  if (zeros == 0) return;
  std::size_t at = 0;
  while (!(squared_tangent(jets, at) == FT(0))) ++at;
  throw Error(Error_code::zero_tangent, place + std::to_string(at));
}

// `shape(at)` returns the shape parameters of the blend number `at`.
template <class Concurrency_tag, class FT, int N, int k, class Strategy, class Shape>
void blend_arrays(const Jet_arrays<FT, N, k>& phi, const Jet_arrays<FT, N, k>& psi, const Strategy& strategy,
                  const Shape& shape, Blend_arrays<FT, N>& gamma) {
  static_assert(k >= 2, "a quintic blend reads 2 derivatives");
  if (phi.size() != psi.size()) throw Error(Error_code::wrong_number_of_points, "blend: the numbers of jets differ");
  check_tangents(phi, "blend: end of the first curve number ");
  check_tangents(psi, "blend: start of the second curve number ");
  gamma.resize(phi.size());
  for_each_block<Concurrency_tag>(phi.size(), [&](std::size_t begin, std::size_t end) {
    typedef Coordinate_vector<FT, N> Vector;
    std::array<std::array<const FT*, N>, 3> x, y;
    std::array<std::array<FT*, N>, 6> out;
    for (int i = 0; i < N; ++i) {
      for (int j = 0; j < 3; ++j) {
        x[j][i] = phi.array(j, i);
        y[j][i] = psi.array(j, i);
      }
      for (int j = 0; j < 6; ++j) out[j][i] = gamma.array(j, i);
    }
    CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (std::size_t at = begin; at < end; ++at) {
      const auto read = [&](const std::array<const FT*, N>& arrays) {
        Vector v;
        for_each_index<N>([&](int i) CGAL_GC_FORCEINLINE_LAMBDA { v[i] = arrays[i][at]; });
        return v;
      };
      const auto write = [&](const std::array<FT*, N>& arrays, const Vector& v) {
        for_each_index<N>([&](int i) CGAL_GC_FORCEINLINE_LAMBDA { arrays[i][at] = v[i]; });
      };
      // compilers keep e and p in registers only when they are not const
      const std::array<Vector, 3> left = {read(x[0]), read(x[1]), read(x[2])},
                                  right = {read(y[0]), read(y[1]), read(y[2])};
      Quintic_ends<FT, N> e(left, right, shape(at));
      Quintic_parameters<FT> p = strategy(e);
      write(out[0], e.a1);
      write(out[1], e.b1());
      write(out[2], e.c1(p.s1));
      write(out[3], e.c2(p.s2));
      write(out[4], e.b2());
      write(out[5], e.a2);
    }
  });
}

} // namespace internal

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_ON

/// \ingroup PkgGeometricContinuityConstruction
/// Computes the quintic blends of many pairs of jets with the same shape parameters, as `blend()`
/// does one by one. The formulas are those of the strategy, and the compiler computes several
/// blends at a time. \f$ O(n) \f$. The caller must ensure that the numbers are finite: a blend of
/// others is not finite either.
///
/// \param phi,psi `n` jets of order at least 2 at the ends of the first and at the starts of the
///   second curves
/// \param shape the shape parameters of all blends, both positive
/// \param gamma the blends, resized to `n`
/// \tparam Strategy a quintic strategy without branches, which excludes `Near_line` and `Fair`
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
/// \throws Error `nonpositive_beta` unless both shape parameters are positive;
///   `wrong_number_of_points` when the numbers of jets differ; `zero_tangent`, before anything is
///   computed, when a first derivative is zero
template <class Concurrency_tag = Sequential_tag, class FT, int N, int k, class Strategy>
void blend(const Jet_arrays<FT, N, k>& phi, const Jet_arrays<FT, N, k>& psi, const Strategy& strategy,
           const Shape_parameters<FT>& shape, Blend_arrays<FT, N>& gamma) {
  if (!(FT(0) < shape.beta && FT(0) < shape.eta)) throw Error(Error_code::nonpositive_beta, "blend: of many jets");
  internal::blend_arrays<Concurrency_tag>(
      phi, psi, strategy, [&](std::size_t) { return shape; }, gamma);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Computes the quintic blends of many pairs of jets with the shape parameters of
/// `automatic_shape()`, as `blend()` does one by one. \f$ O(n) \f$. The caller must ensure that the
/// numbers are finite.
///
/// \param phi,psi `n` jets of order at least 2 at the ends of the first and at the starts of the
///   second curves
/// \param gamma the blends, resized to `n`
/// \tparam Strategy a quintic strategy for given shape parameters
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
/// \throws Error `wrong_number_of_points` when the numbers of jets differ; `zero_tangent`, before
///   anything is computed, when a first derivative is zero
template <class Concurrency_tag = Sequential_tag, class FT, int N, int k, class Strategy>
void blend(const Jet_arrays<FT, N, k>& phi, const Jet_arrays<FT, N, k>& psi, const Strategy& strategy,
           Blend_arrays<FT, N>& gamma) {
  internal::blend_arrays<Concurrency_tag>(
      phi, psi, strategy, [&](std::size_t at) { return internal::automatic_shape<FT, N>(phi.jet(at), psi.jet(at)); },
      gamma);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_BLEND_H
