// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_RATIONAL_BEZIER_CURVE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_RATIONAL_BEZIER_CURVE_H

#include <CGAL/Geometric_continuity/curves/Rational_curve.h>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// A rational Bézier curve \f$ x(u) = \sum_i w_i b_i B_i^m(t) / \sum_i w_i B_i^m(t) \f$, \f$ t = (u-a)/(b-a) \f$, with control
/// points \f$ b_0, \dots, b_m \f$ and weights \f$ w_0, \dots, w_m \f$ on the domain [a, b], by default [0, 1]: arcs of circles
/// and all other conics, the pieces of NURBS curves. See `Rational_curve`.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam Degree the degree `m >= 0`, or `dynamic_degree`
template <class Traits, int Degree = dynamic_degree>
using Rational_bezier_curve = Rational_curve<Bezier_curve<Traits, Degree>>;

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_RATIONAL_BEZIER_CURVE_H
