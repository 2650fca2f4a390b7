// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_CLOSE_H
#define CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_CLOSE_H

#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/septic_strategies.h>
#include <CGAL/Geometric_continuity/curves/end_control_points.h>
#include <CGAL/Geometric_continuity/extensions/extend.h>

#include <vector>

/// \file close.h
/// The segment that leads from the end of a chain of curves back to its start.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the segment on [0, 1] that leads from the end of the curve `last` back to the start of the curve `first`, with the wanted
/// continuity at both joins: for the tangent the cubic with the end tangents \f$ \beta x' \f$ and \f$ \eta y' \f$, for the
/// curvature the quintic blend of least \f$ \int |\gamma'''|^2 \f$, for the torsion the \f$ G^3 \f$ septic blend of least
/// \f$ \int |\gamma^{(4)}|^2 \f$.
/// \tparam Left, Right models of `ParametricCurve` with one traits class
/// \throws Error `nonpositive_beta` unless \f$ \beta > 0 \f$ and \f$ \eta > 0 \f$, `dimension_mismatch`, `zero_tangent` when an end
///   tangent is zero, `not_finite` when a shape parameter is infinite or the result overflows
template <class Left, class Right>
Bezier_curve<typename Left::Traits> close(const Left& last, const Right& first, Frenet_order order,
                                          const Shape_parameters<typename Left::Traits::FT>& shape = {}) {
  typedef typename Left::Traits Traits;
  if (order == Frenet_order::torsion) return blend(last, first, Minimal_energy_g3<4>(), shape);
  if (order == Frenet_order::curvature) return blend(last, first, Minimal_energy<3>(), shape);
  typedef typename Traits::FT FT;
  Curve_jet<Traits> x(end_jet<FT>(last, 1)), y(start_jet<FT>(first, 1));
  internal::check_blend_input(x, y, 1, shape);
  x[1] *= shape.beta;
  y[1] *= shape.eta;
  std::vector<typename Traits::Point> points = start_control_points(x, 3);
  const std::vector<typename Traits::Point> end = end_control_points(y, 3);
  points.insert(points.end(), end.begin(), end.end());
  return {points.begin(), points.end()};
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the closed curve with one more segment, which `close()` makes from the last one to the first. It takes a parameter
/// interval of length 1; all segments get the highest degree.
/// \throws Error `nonpositive_beta`, `zero_tangent`, `not_finite` as `close()` of two curves
template <class Traits, int Degree>
Composite_bezier_curve<Traits> close(const Composite_bezier_curve<Traits, Degree>& curve, Frenet_order order,
                                     const Shape_parameters<typename Traits::FT>& shape = {}) {
  std::vector<Bezier_curve<Traits>> segments = internal::segments_of(curve);
  segments.push_back(close(segments.back(), segments.front(), order, shape));
  return Composite_bezier_curve<Traits>(segments.begin(), segments.end());
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_CLOSE_H
