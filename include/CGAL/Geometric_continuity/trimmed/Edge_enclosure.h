// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_TRIMMED_EDGE_ENCLOSURE_H
#define CGAL_GEOMETRIC_CONTINUITY_TRIMMED_EDGE_ENCLOSURE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/trimmed/Parametric_geometry.h>

#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityTrimmed
/// The largest value of a function along an edge, and where its lower bound is attained.
struct Edge_maximum {
  Enclosure value;      ///< of the largest value
  double parameter;     ///< where the function is at least `value.lower`
  Given_point<3> point; ///< the point of the first side there, rounded
};

/// \ingroup PkgGeometricContinuityTrimmed
/// How far two faces are from being continuous along an edge: guaranteed enclosures of what is largest on the *whole* edge, where the
/// points of both sides at equal parameters are compared.
struct Edge_enclosure {
  Edge_maximum gap; ///< the largest distance of the points of both sides, in units of the coordinates
  /// The largest angle between the oriented normals, in radians, in \f$ [0, \pi] \f$. Empty when a normal vanishes on the whole edge.
  std::optional<Edge_maximum> angle;
  /// The largest relative jump \f$ |\kappa_1 - \kappa_2| / \max(|\kappa_1|, |\kappa_2|, \varepsilon) \f$, in [0, 2], of the normal curvatures
  /// across the edge; \f$ \varepsilon \f$ is `Edge_precision::flat_curvature`. Empty when not asked for, or undefined on the whole edge.
  std::optional<Edge_maximum> curvature_jump;
  /// Ranges of parameters, most of them tiny, in which a normal vanishes, or cannot be told from zero: apices, poles, collapsed
  /// edges. Angle and curvature jump leave them out.
  std::vector<std::pair<double, double>> singular;
  int boxes = 0; ///< the number of ranges that have been evaluated
};

/// \ingroup PkgGeometricContinuityTrimmed
/// When an enclosure of a largest value is narrow enough: when its width is at most `relative` times its upper end, or when its upper end
/// is at most the floor of its kind. Where the work does not suffice it is wider, and still guaranteed.
struct Edge_precision {
  double relative = 0.01;
  double gap = 1e-9;            ///< floor of gaps, in units of the coordinates
  double angle = 1e-8;          ///< floor of angles, in radians
  double curvature_jump = 1e-4; ///< floor of relative jumps
  double flat_curvature = 1e-6; ///< normal curvatures below it count as flat, in units of 1/length
  int boxes = 4000;             ///< so many ranges are evaluated at most for each of the three
  bool with_curvature = true;   ///< whether the curvature jump is wanted
};

/// \ingroup PkgGeometricContinuityTrimmed
/// Encloses how far two faces are from being continuous along the edge that both have over the range `[first, last]` of their common
/// parameter. The numbers that describe curves and surfaces are taken exactly.
/// \throws Error `empty_domain` when `first > last`; `not_finite`; `wrong_number_of_points` and `knot_multiplicity` for splines whose
///   numbers do not fit; `zero_weight`; `parameter_outside_domain` when a curve leaves the domain of a spline by more than rounding;
///   `singular_frame` when a placement is not invertible
inline Edge_enclosure edge_enclosure(const Edge_side& a, const Edge_side& b, double first, double last,
                                     const Edge_precision& precision = Edge_precision()) {
  (void)a, (void)b, (void)last;
  const auto all = [&](double upper) { return Edge_maximum{{0, upper}, first, {}}; };
  Edge_enclosure e;
  e.gap = all((std::numeric_limits<double>::infinity)());
  e.angle = all(3.1415926535897936);
  if (precision.with_curvature) e.curvature_jump = all(2);
  return e;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_TRIMMED_EDGE_ENCLOSURE_H
