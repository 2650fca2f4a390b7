// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_SPLINE_EDGE_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_SPLINE_EDGE_CONTINUITY_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

/// \file Spline_edge_continuity.h
/// What `edge_continuity()` answers: the order of continuity, why it is not higher, and where.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// Why two surfaces are not smoother along an edge than they are.
enum class Edge_defect {
  none,             ///< they have the highest order that is decided, \f$ G^2 \f$
  gap,              ///< the edges are different curves
  collapsed,        ///< the edge is a single point
  vanishing_normal, ///< the tangent planes agree wherever there are any, but the normal of one side vanishes somewhere
  crease,           ///< the tangent planes differ somewhere
  fold,             ///< the tangent planes agree, but somewhere both surfaces lie on the same side of the edge
  curvature         ///< the tangent planes agree, the curvatures do not
};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns the name of a defect, as spelled in the enumeration.
inline std::string to_string(Edge_defect defect) {
  switch (defect) {
  case Edge_defect::none: return "none";
  case Edge_defect::gap: return "gap";
  case Edge_defect::collapsed: return "collapsed";
  case Edge_defect::vanishing_normal: return "vanishing_normal";
  case Edge_defect::crease: return "crease";
  case Edge_defect::fold: return "fold";
  case Edge_defect::curvature: return "curvature";
  }
  return "unknown";
}

/// \ingroup PkgGeometricContinuityContinuity
/// Writes the name of a defect.
inline std::ostream& operator<<(std::ostream& os, Edge_defect defect) { return os << to_string(defect); }

/// \ingroup PkgGeometricContinuityContinuity
/// Returns how severe a defect is, from 0 for none to 6 for a gap: it decides which of several spans is called the worst. In
/// increasing severity: none, curvature, collapsed, vanishing normal, fold, crease, gap.
inline int severity(Edge_defect defect) {
  switch (defect) {
  case Edge_defect::none: return 0;
  case Edge_defect::curvature: return 1;
  case Edge_defect::collapsed: return 2;
  case Edge_defect::vanishing_normal: return 3;
  case Edge_defect::fold: return 4;
  case Edge_defect::crease: return 5;
  case Edge_defect::gap: return 6;
  }
  return 7;
}

/// \ingroup PkgGeometricContinuityContinuity
/// A guaranteed enclosure of the largest angle \f$ \theta \in [0, \pi] \f$ between the normals of two surfaces along their
/// common edge, both turned so that \f$ \theta = 0 \f$ where the surfaces continue each other and \f$ \theta = \pi \f$ where
/// they fold back. Points where a normal vanishes are left out; limits at them count.
///
/// The angle is given without roots by its measure \f$ 1 - \cos\theta\,|\cos\theta| \f$, which grows with it from 0 over 1 for
/// a right angle to 2: it is \f$ \sin^2\theta \f$ up to the right angle and \f$ 2 - \sin^2\theta \f$ beyond. The measure is so
/// accurate that `angle()` is at most four units in the last place wide, unless the angle varies at scales near the limits
/// of floating-point numbers.
/// \tparam FT a field number type
template <class FT> struct Normal_deviation {
  FT lower; ///< the measure of an angle that occurs on the edge, or as a limit
  FT upper; ///< the measure of an angle that is not exceeded anywhere on the edge
  FT begin; ///< the sub-interval of the parameters of the edge
  FT end;   ///< where the angle is largest

  /// Returns an enclosure of the largest angle, in radians. It needs `CGAL::to_interval()` of `FT`.
  Enclosure angle() const { return {smallest_angle(), largest_angle()}; }
  /// Returns the lower bound of `angle()`.
  double smallest_angle() const { return angle(lower).lower; }
  /// Returns the upper bound of `angle()`.
  double largest_angle() const { return angle(upper).upper; }

  /// Returns an enclosure of the angle that has a measure between 0 and 2, in radians. It needs `CGAL::to_interval()`.
  /// \throws Error `parameter_outside_domain` for another measure
  static Enclosure angle(const FT& measure) {
    if (measure < FT(0) || FT(2) < measure)
      throw Error(Error_code::parameter_outside_domain, "Normal_deviation::angle: a measure is between 0 and 2");
    const bool obtuse = FT(1) < measure;
    const FT sine_squared = obtuse ? FT(FT(2) - measure) : measure;
    return internal::angle_of_squares(sine_squared, FT(FT(1) - sine_squared), obtuse);
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// What was decided about two surfaces along an edge.
/// \tparam FT the field in which it was decided
template <class FT> struct Edge_continuity {
  /// -1 when the edges differ, 0 when they are the same curve, 1 when the tangent planes agree along the whole closed edge
  /// and the surfaces lie on different sides of it, 2 when the curvatures agree as well.
  int g_order = -1;
  Edge_defect defect = Edge_defect::gap; ///< why the order is not higher
  bool reversed = false;                 ///< the second edge runs backwards
  bool coplanar = false;                 ///< \f$ \det(C', T_1, T_2) \equiv 0 \f$
  /// The signs of \f$ (C' \times T_1) \cdot (C' \times T_2) \f$: `negative` where the surfaces continue each other.
  Sign_pattern side = Sign_pattern::zero;
  bool collapsed = false;       ///< the edge is a single point
  bool normal_vanishes = false; ///< a normal vanishes somewhere on the closed edge
  /// The sub-interval of the parameters of the first edge, at most 1/32 of it, in which a normal vanishes: a point when it
  /// was found exactly. Empty where no normal vanishes or the edge is collapsed.
  std::optional<std::pair<FT, FT>> vanishing;
  /// The enclosure of the largest angle between the normals and the place of a crease or fold, in the parameters of the
  /// first edge. Empty without a common edge, and where one normal vanishes identically.
  std::optional<Normal_deviation<FT>> deviation;

  /// Writes the order, the defect and the upper bound of the angle in degrees, rounded upwards to the precision of the
  /// stream, e.g. `G1 (curvature)` or `G0 (crease), angle <= 17.2 degrees`.
  friend std::ostream& operator<<(std::ostream& os, const Edge_continuity& e) {
    if (e.g_order < 0) return os << "gap";
    os << 'G' << e.g_order;
    if (e.defect != Edge_defect::none) os << " (" << e.defect << ')';
    if (e.reversed) os << ", reversed";
    if (e.deviation && FT(0) < e.deviation->upper) {
      const double largest = e.deviation->largest_angle();
      os << ", angle <= "
         << internal::decimal_above(in_degrees({largest, largest}).upper, static_cast<int>(os.precision()))
         << " degrees";
    }
    return os;
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// What was decided about two surfaces along an interval of their common edge on which both are polynomials.
/// \tparam FT the field in which it was decided
template <class FT> struct Edge_span {
  FT begin;                       ///< the parameter of the first edge
  FT end;                         ///< where the span ends, in the same parameter
  Edge_continuity<FT> continuity; ///< on the closed span; all parameters in it are those of the first edge
};

/// \ingroup PkgGeometricContinuityContinuity
/// What was decided about two piecewise polynomial surfaces along the part that their edges have in common, on each span of
/// the knots of both. The members of the base class hold for the whole part:
///
/// - `g_order` is the least order of all spans, and `defect` belongs to `worst`;
/// - `coplanar` and `collapsed` hold when they do on all spans, `normal_vanishes` when it does on one, with the first
///   sub-interval in `vanishing`; `side` has the signs of all spans;
/// - `deviation` encloses the largest angle of all spans.
///
/// All parameters are those of the first edge, unless stated otherwise. Without a common part there are no spans, and the
/// order is -1.
/// \tparam FT the field in which it was decided
template <class FT> struct Spline_edge_continuity : Edge_continuity<FT> {
  std::vector<Edge_span<FT>> spans;       ///< in the order of the parameters of the first edge
  std::size_t worst = 0;                  ///< the number of the span that has the most severe defect, see `severity()`
  std::pair<FT, FT> part_a{FT(0), FT(0)}; ///< the part of the first edge that is common
  std::pair<FT, FT> part_b{FT(0), FT(0)}; ///< the same part of the second edge, in its parameters
  bool whole_a = false;                   ///< the common part is all of the first edge
  bool whole_b = false;                   ///< the common part is all of the second edge

  /// Writes the whole, then the place of the worst of several spans, and the part if it is not all of both edges; e.g.
  /// `G1 (curvature), worst of 3 spans on [0, 1/2]` or `G2, a part of the second edge`.
  friend std::ostream& operator<<(std::ostream& os, const Spline_edge_continuity& e) {
    os << static_cast<const Edge_continuity<FT>&>(e);
    if (e.spans.size() > 1 && e.defect != Edge_defect::none)
      os << ", worst of " << e.spans.size() << " spans on [" << e.spans[e.worst].begin << ", " << e.spans[e.worst].end
         << ']';
    if (!e.spans.empty() && !(e.whole_a && e.whole_b))
      os << ", a part of " << (e.whole_b ? "the first edge" : e.whole_a ? "the second edge" : "both edges");
    return os;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_SPLINE_EDGE_CONTINUITY_H
