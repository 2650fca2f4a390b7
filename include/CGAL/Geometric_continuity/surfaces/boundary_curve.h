// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_BOUNDARY_CURVE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_BOUNDARY_CURVE_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

#include <vector>

/// \file boundary_curve.h
/// The edges of surfaces as curves.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns an edge of a patch as a Bézier curve on the domain of the edge; its control points are
/// those of the patch along the edge. \f$ O(p) \f$ for an edge of degree `p`
template <class Traits> Bezier_curve<Traits> boundary_curve(const Bezier_patch<Traits>& patch, Patch_edge edge) {
  const typename Bezier_patch<Traits>::Interval domain = patch.domain(edge);
  std::vector<typename Traits::Point> points;
  for (int i = 0; i <= patch.degree_along(edge); ++i) points.push_back(patch.control_point(edge, i, 0));
  return Bezier_curve<Traits>(points.begin(), points.end(), domain.first, domain.second);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns an edge of a B-spline surface as a curve over the knots of the surface along the edge.
/// The knots across the edge need not be clamped. \f$ O(m q + q^2) \f$ for an edge with `m` control
/// points, of degree `q` across the edge
template <class Traits> Bspline_curve<Traits> boundary_curve(const Bspline_surface<Traits>& surface, Patch_edge edge) {
  std::vector<typename Traits::Point> points;
  const auto rows = surface.rows(edge, 0);
  for (const Coordinates<Traits>& x : rows[0]) points.push_back(to_point<Traits>(x));
  return Bspline_curve<Traits>(points.begin(), points.end(), surface.knots_along(edge));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns an edge of a rational patch as a rational curve, with the domain and the direction of
/// the edge.
template <class Traits>
Rational_bezier_curve<Traits> boundary_curve(const Rational_bezier_patch<Traits>& patch, Patch_edge edge) {
  const typename Rational_bezier_patch<Traits>::Interval domain = patch.domain(edge);
  typedef typename Rational_bezier_curve<Traits>::Homogeneous Homogeneous;
  return Rational_bezier_curve<Traits>(Homogeneous(patch.rows(edge, 0)[0], domain.first, domain.second));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns an edge of a rational B-spline surface as a rational curve over the knots of the edge.
template <class Traits>
Rational_bspline_curve<Traits> boundary_curve(const Rational_bspline_surface<Traits>& surface, Patch_edge edge) {
  typedef typename Rational_bspline_curve<Traits>::Homogeneous Homogeneous;
  const auto rows = surface.rows(edge, 0);
  return Rational_bspline_curve<Traits>(Homogeneous(rows[0].begin(), rows[0].end(), surface.knots_along(edge)));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_BOUNDARY_CURVE_H
