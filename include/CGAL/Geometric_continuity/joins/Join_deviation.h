// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_DEVIATION_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_DEVIATION_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <array>
#include <optional>
#include <ostream>

/// \file Join_deviation.h
/// How far a join is from being continuous, the tolerance for it, and the verdict.

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

  /// Writes the verdicts and the deviation, e.g. `order 0 proved, 1 proved, 2 refuted, 3 refuted;
  /// gap 0, ...`.
  friend std::ostream& operator<<(std::ostream& os, const Order_within& within) {
    os << "order";
    for (int order = 0; order <= 3; ++order) os << (order == 0 ? " " : ", ") << order << ' ' << within(order);
    return os << "; " << within.deviation;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_DEVIATION_H
