// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_DEVIATION_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_DEVIATION_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/internal/Other_members.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_decision.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_words.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <ostream>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// How far a join is from being continuous: guaranteed enclosures. With \f$ X \f$ for the curve
/// that ends and \f$ Y \f$ for the curve that starts there:
struct Join_deviation {
  Enclosure gap; ///< the distance \f$ |Y - X| \f$ of the ends, in units of the coordinates
  /// The angle between the tangents, in radians, in \f$ [0, \pi] \f$. Empty when a tangent is zero.
  std::optional<Enclosure> tangent_angle;
  /// The relative jump of the curvature vector, \f$ |K_Y - K_X| / \max(|K_X|, |K_Y|) \f$, in [0,
  /// 2]; 0 when both are zero. Empty when a tangent is zero.
  std::optional<Enclosure> curvature_jump;
  /// The jump of the torsion \f$ |\tau_Y - \tau_X| \f$, in units of 1/length. Empty unless in
  /// dimension 3 with nonzero curvature on both sides.
  std::optional<Enclosure> torsion_jump;

  /// \cond SKIP_IN_MANUAL
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(angle, "deviation(a, b).tangent_angle encloses the angle at the join, in radians")
  CGAL_GEOMETRIC_CONTINUITY_NO_MEMBER(distance, "deviation(a, b).gap is the distance of the ends at the join; that of "
                                                "whole curves is not measured")
  /// \endcond

  /// Writes what there is, angles in degrees and ratios in percent, e.g. `gap 0, tangent angle
  /// [0.5, 0.50001] degrees, curvature jump 2%`.
  friend std::ostream& operator<<(std::ostream& os, const Join_deviation& d) {
    os << "gap " << d.gap;
    if (d.tangent_angle) os << ", tangent angle " << in_degrees(*d.tangent_angle) << " degrees";
    if (d.curvature_jump) os << ", curvature jump " << in_percent(*d.curvature_jump) << '%';
    if (d.torsion_jump) os << ", torsion jump " << *d.torsion_jump;
    return os;
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// The tolerance at a join: the quantities of `Join_deviation`, in their units.
struct Join_tolerance {
  Bound tangent_angle = 0;        ///< in radians
  Bound curvature_jump = 0;       ///< relative
  Bound torsion_jump = 0;         ///< in space, in units of 1/length
  Bound gap = 0;                  ///< in units of the coordinates
  Bound curvature_derivative = 0; ///< in the plane, of \f$ d\kappa/ds \f$, in units of 1/length^2
};

/// \ingroup PkgGeometricContinuityContinuity
/// The orders 0 to 3 of a join, within a tolerance.
struct Order_within {
  Join_deviation deviation; ///< the deviation on which the verdicts rest
  /// For each order: the ends meet; in addition the tangents agree; the curvature vectors; the
  /// torsions, or in the plane the derivatives of the curvature with respect to arc length. Each of
  /// them within the tolerance, or exactly.
  std::array<Verdict, 4> verdicts;

  /// Returns whether the join has the order, 0 to 3, within the tolerance.
  /// \throws Error `negative_count` for a negative order, `jet_order_too_low` for one above 3
  Verdict operator()(int order) const {
    if (order < 0) throw Error(Error_code::negative_count, "Order_within: order");
    if (order > 3) throw Error(Error_code::jet_order_too_low, "Order_within: orders 0 to 3 are decided");
    return verdicts[order];
  }
  /// Returns the largest order that is proved, -1 if none is.
  int proved_order() const {
    int order = 3;
    while (order >= 0 && verdicts[order] != Verdict::proved) --order;
    return order;
  }

  /// \cond SKIP_IN_MANUAL
  CGAL_GEOMETRIC_CONTINUITY_NO_ORDERS(
      "order_within(a, b, tolerance).proved_order() is the largest order that is proved, "
      "order_within(a, b, tolerance)(2) the verdict about one")
  /// \endcond

  /// Writes the verdicts and the deviation, e.g. `order 0 proved, 1 proved, 2 refuted, 3 refuted;
  /// gap 0, ...`.
  friend std::ostream& operator<<(std::ostream& os, const Order_within& within) {
    os << "order";
    for (int order = 0; order <= 3; ++order) os << (order == 0 ? " " : ", ") << order << ' ' << within(order);
    return os << "; " << within.deviation;
  }
};

namespace internal {

// Takes note of the work on curvatures and torsions, which are forms of degree 6 at most.
template <class Field, int N>
void charge_invariants(const Coordinate_jet<Field, N>& x, const Coordinate_jet<Field, N>& y) {
  const Work_guard work("deviation");
  std::vector<Coordinate_vector<Field, N>> vectors;
  for (const Coordinate_jet<Field, N>* jet : {&x, &y})
    for (int j = 0; j <= jet->order(); ++j) vectors.push_back((*jet)[j]);
  const std::size_t words = common_words<Field>(vectors);
  work_meter().charge_fractions(20. * x.dimension(), 6 * words);
}

// The deviation of two jets of order 3 in an exact field.
template <class Field, int N>
Join_deviation join_deviation(const Coordinate_jet<Field, N>& x, const Coordinate_jet<Field, N>& y) {
  typedef Coordinate_vector<Field, N> Vector;
  if (x.dimension() != y.dimension()) throw Error(Error_code::dimension_mismatch, "deviation of two jets");
  charge_invariants(x, y);
  const auto square = [](const Vector& v) -> Field { return dot(v, v); };
  Join_deviation d{sqrt_enclosure(square(y[0] - x[0])), {}, {}, {}};
  if (is_zero(x[1]) || is_zero(y[1])) return d;
  const Field xy = dot(x[1], y[1]);
  d.tangent_angle = angle_enclosure(Field(square(x[1]) * square(y[1]) - xy * xy), xy);
  const Vector kx = *curvature_vector(x), ky = *curvature_vector(y);
  const Field largest = (std::max)(square(kx), square(ky));
  d.curvature_jump = largest == Field(0) ? Enclosure{0, 0} : sqrt_enclosure(Field(square(ky - kx) / largest));
  if constexpr (N == 0 || N == 3)
    if (x.dimension() == 3 && !is_zero(kx) && !is_zero(ky)) {
      const Field jump = *torsion(y) - *torsion(x);
      d.torsion_jump = enclosure(jump < Field(0) ? Field(-jump) : jump);
    }
  return d;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns how far the join between the end of `left` and the start of `right` is from being
/// continuous. Everything is computed in an exact field from the control points as given, also with
/// `Simple_cartesian<double>`; only the last step, a root or an arc tangent, is rounded, outwards.
/// \tparam Left, Right models of `ParametricCurve` with one traits class
/// \throws Error `dimension_mismatch` when the dimensions differ, `not_finite` for an infinite or
///   undefined coordinate, `work_limit` when exact numbers are so long that the limit does not
///   suffice
template <class Left, class Right, class = std::void_t<typename Left::Traits, typename Right::Traits>>
Join_deviation deviation(const Left& left, const Right& right) {
  typedef typename Exact_field<Predicate_FT<typename Left::Traits>>::type Field;
  static_assert(std::is_same_v<typename Left::Traits, typename Right::Traits>,
                "both curves must have the same traits class");
  static_assert(!internal::is_surface<Left>, "deviation(a, b) is of two curves; edge_deviation(a, Patch_edge::v1, b, "
                                             "Patch_edge::v0) measures the edge of two surfaces");
  const Work_scope jets_and_invariants(Work_scope::limit_of_each(), "deviation");
  if constexpr (internal::is_surface<Left>) // so that there is one error
    return {};
  else
    return internal::join_deviation(end_jet<Field>(left, 3), start_jet<Field>(right, 3));
}

namespace internal {

// The derivative of the signed curvature of a planar curve with respect to arc length, with g =
// x'.x': (det(x', x''') g - 3 det(x', x'') x'.x'') / g^3. \pre the tangent is not zero
template <class Field, int N> Field curvature_derivative(const Coordinate_jet<Field, N>& x) {
  const auto det = [&](int j) -> Field { return Field(x[1][0] * x[j][1] - x[1][1] * x[j][0]); };
  const Field g = dot(x[1], x[1]);
  return Field((det(3) * g - Field(3) * det(2) * dot(x[1], x[2])) / (g * g * g));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Decides which order the join between the end of `left` and the start of `right` has within a
/// tolerance: *proved* when the enclosures of `deviation()` and all lower orders are within it,
/// *refuted* when one of them exceeds it, *undecided* when the tolerance lies inside of an
/// enclosure, or when the torsions cannot be compared because a curvature is zero. An order that
/// the join has exactly is proved with each tolerance. A zero tangent refutes the order 1.
///
/// Exact orders are those of \f$ F^k \f$, in the plane \f$ G^k \f$: there the order 3 means that
/// the derivative
/// \f$ d\kappa/ds = \frac{(x' \cdot x') \det(x', x''') - 3 (x' \cdot x'') \det(x', x'')}{(x' \cdot x')^3} \f$
/// of the signed curvature agrees as well, by which \f$ G^3 \f$ and \f$ G^2 \f$ differ.
/// \tparam Left, Right models of `ParametricCurve` with one traits class
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number;
///   `dimension_mismatch` when the dimensions differ; `work_limit` when exact numbers are so long
///   that the limit does not suffice
template <class Left, class Right, class = std::void_t<typename Left::Traits, typename Right::Traits>>
Order_within order_within(const Left& left, const Right& right, const Join_tolerance& tolerance) {
  typedef typename Exact_field<Predicate_FT<typename Left::Traits>>::type Field;
  constexpr int N = dimension_v<typename Left::Traits>;
  for (const Bound& bound : {tolerance.tangent_angle, tolerance.curvature_jump, tolerance.torsion_jump, tolerance.gap,
                             tolerance.curvature_derivative})
    internal::check_bound(bound);
  const Work_scope jets_and_decision(Work_scope::limit_of_each(), "order_within");
  const Coordinate_jet<Field, N> x = end_jet<Field>(left, 3), y = start_jet<Field>(right, 3);
  const bool planar = x.dimension() == 2;
  const Join_continuity<Field> exact = internal::Join_decision<Field, N>(x, y, 3)();
  const int exact_order = planar ? exact.g_order : exact.f_order;
  Order_within result{internal::join_deviation(x, y), {}};
  const Join_deviation& d = result.deviation;
  const auto verdict = [](const std::optional<Enclosure>& e, const Bound& bound, Verdict undefined) {
    return e ? at_most(*e, bound) : undefined;
  };
  result.verdicts = {at_most(d.gap, tolerance.gap), verdict(d.tangent_angle, tolerance.tangent_angle, Verdict::refuted),
                     verdict(d.curvature_jump, tolerance.curvature_jump, Verdict::refuted),
                     verdict(d.torsion_jump, tolerance.torsion_jump, Verdict::undecided)};
  if constexpr (N == 0 || N == 2)
    if (planar && exact.regular) {
      const Field jump = internal::curvature_derivative(y) - internal::curvature_derivative(x);
      result.verdicts[3] = at_most(enclosure(jump < Field(0) ? Field(-jump) : jump), tolerance.curvature_derivative);
    }
  for (int order = 1; order <= 3; ++order) {
    Verdict& v = result.verdicts[order];
    v = order <= exact_order ? Verdict::proved : v && result.verdicts[order - 1];
  }
  return result;
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns the relative jump \f$ |y^{(k)} - x^{(k)}| / \max(|x^{(k)}|, |y^{(k)}|) \f$ of the
/// derivative of order `k` with respect to the parameters of the curves at a join, in [0, 2]; 0
/// when both are zero.
/// \tparam Left, Right models of `ParametricCurve` with one traits class
/// \throws Error `dimension_mismatch`, `not_finite`, `negative_count` unless `k` is positive
template <class Left, class Right, class = std::void_t<typename Left::Traits, typename Right::Traits>>
Enclosure derivative_jump(const Left& left, const Right& right, int k) {
  typedef typename Exact_field<Predicate_FT<typename Left::Traits>>::type Field;
  constexpr int N = dimension_v<typename Left::Traits>;
  if (k < 1) throw Error(Error_code::negative_count, "derivative_jump: the order is not positive");
  const auto x = end_jet<Field>(left, k)[k], y = start_jet<Field>(right, k)[k];
  if (x.dimension() != y.dimension()) throw Error(Error_code::dimension_mismatch, "derivative_jump");
  const Coordinate_vector<Field, N> difference = y - x;
  const Field a = dot(x, x), b = dot(y, y), largest = (std::max)(a, b);
  return largest == Field(0) ? Enclosure{0, 0} : sqrt_enclosure(Field(dot(difference, difference) / largest));
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides if a join is \f$ C^k \f$ within a tolerance, `k` from 0 to 2: the gap is within it, the
/// `derivative_jump()` of the first derivatives is at most the angle in radians, by which they may
/// turn at most then, and that of the second ones at most the bound of the curvature. A join that
/// is exactly \f$ C^k \f$ is so with each tolerance.
/// \throws Error as `order_within()`; `jet_order_too_low` for a higher order
template <class Left, class Right, class = std::void_t<typename Left::Traits, typename Right::Traits>>
Verdict is_c_within(const Left& left, const Right& right, int k, const Join_tolerance& tolerance) {
  for (const Bound& bound : {tolerance.tangent_angle, tolerance.curvature_jump, tolerance.gap})
    internal::check_bound(bound);
  if (k < 0) throw Error(Error_code::negative_count, "is_c_within: order");
  if (k > 2) throw Error(Error_code::jet_order_too_low, "is_c_within: orders 0 to 2 are decided");
  typedef typename Exact_field<Predicate_FT<typename Left::Traits>>::type Field;
  const auto gap = start_jet<Field>(right, 0)[0] - end_jet<Field>(left, 0)[0];
  Verdict verdict = at_most(sqrt_enclosure(Field(dot(gap, gap))), tolerance.gap);
  if (k > 0) verdict = verdict && at_most(derivative_jump(left, right, 1), tolerance.tangent_angle);
  if (k > 1) verdict = verdict && at_most(derivative_jump(left, right, 2), tolerance.curvature_jump);
  return verdict;
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides which order a join has within one number: it is the tolerance for each of the quantities
/// of `Join_deviation`, in their units. The angle in radians and the relative jump of the curvature
/// do not depend on the unit of length, as the others do.
/// \throws Error as the function that takes a `Join_tolerance`
template <class Left, class Right, class Number, class = std::void_t<typename Left::Traits, typename Right::Traits>,
          class = std::enable_if_t<std::is_arithmetic_v<Number>>>
Order_within order_within(const Left& left, const Right& right, Number tolerance) {
  const Bound bound(tolerance);
  return order_within(left, right, Join_tolerance{bound, bound, bound, bound, bound});
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_DEVIATION_H
