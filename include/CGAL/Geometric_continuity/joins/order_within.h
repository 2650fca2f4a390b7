// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_ORDER_WITHIN_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_ORDER_WITHIN_H

#include <CGAL/Geometric_continuity/joins/Verdict.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// What is tolerated at a join; see `Join_deviation` for the quantities and their units.
struct Join_tolerance {
  double angle = 0;     ///< of the tangents, in radians
  double curvature = 0; ///< relative, of the curvature vectors
  double torsion = 0;   ///< in units of 1/length
  double gap = 0;       ///< in units of the coordinates
};

/// \ingroup PkgGeometricContinuityContinuity
/// Whether a join has the orders 0 to 3 within a tolerance.
struct Order_within {
  Join_deviation deviation; ///< on which the verdicts rest
  /// For each order: the ends meet; in addition the tangents agree; the curvature vectors; the torsions. Each of them within
  /// the tolerance, or exactly.
  std::array<Verdict, 4> verdicts;

  /// Whether the join has the order, 0 to 3, within the tolerance.
  Verdict operator()(int order) const { return verdicts[order]; }
  /// The largest order that is proved, -1 if none is.
  int proved_order() const {
    int order = 3;
    while (order >= 0 && verdicts[order] != Verdict::proved) --order;
    return order;
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// Decides which order the join between the end of `left` and the start of `right` has within a tolerance: *proved* when
/// the enclosures of `deviation()` and all lower orders are within it, *refuted* when one of them exceeds it, *undecided*
/// when the tolerance lies inside of an enclosure, or when the torsions cannot be compared because a curvature is zero. An
/// order that the join has exactly (in the sense of \f$ F^k \f$) is proved with each tolerance. A zero tangent refutes the
/// order 1.
/// \tparam Left, Right models of `ParametricCurve` with one traits class
/// \throws Error `unreachable_tolerance` for a negative tolerance or one that is not a number; `dimension_mismatch` when
///   the dimensions differ
template <class Left, class Right, class = std::void_t<typename Left::Traits, typename Right::Traits>>
Order_within order_within(const Left& left, const Right& right, const Join_tolerance& tolerance) {
  typedef typename Exact_field<Predicate_FT<typename Left::Traits>>::type Field;
  constexpr int N = dimension_v<typename Left::Traits>;
  for (double bound : {tolerance.angle, tolerance.curvature, tolerance.torsion, tolerance.gap})
    if (!(0 <= bound)) throw Error(Error_code::unreachable_tolerance, "order_within: " + std::to_string(bound));
  const Coordinate_jet<Field, N> x = end_jet<Field>(left, 3), y = start_jet<Field>(right, 3);
  const int exact_order = internal::Join_decision<Field, N>(x, y, 3)().f_order;
  Order_within result{internal::join_deviation(x, y), {}};
  const Join_deviation& d = result.deviation;
  const auto verdict = [](const std::optional<Enclosure>& e, double bound, Verdict undefined) {
    return e ? at_most(*e, bound) : undefined;
  };
  result.verdicts = {at_most(d.gap, tolerance.gap), verdict(d.tangent_angle, tolerance.angle, Verdict::refuted),
                     verdict(d.curvature_jump, tolerance.curvature, Verdict::refuted),
                     verdict(d.torsion_jump, tolerance.torsion, Verdict::undecided)};
  for (int order = 1; order <= 3; ++order) {
    Verdict& v = result.verdicts[order];
    v = order <= exact_order ? Verdict::proved : v && result.verdicts[order - 1];
  }
  return result;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_ORDER_WITHIN_H
