// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_RATIONAL_BSPLINE_CURVE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_RATIONAL_BSPLINE_CURVE_H

#include <CGAL/Geometric_continuity/curves/Rational_bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// A rational B-spline curve (NURBS) \f$ x(u) = \sum_i w_i b_i N_i^p(u) / \sum_i w_i N_i^p(u) \f$ with control points
/// \f$ b_0, \dots, b_{n-1} \f$, as many weights, and any knot vector with `n` coefficients. See `Rational_curve`.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits> using Rational_bspline_curve = Rational_curve<Bspline_curve<Traits>>;

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_RATIONAL_BSPLINE_CURVE_H
