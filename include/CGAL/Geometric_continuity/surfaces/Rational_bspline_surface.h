// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_RATIONAL_BSPLINE_SURFACE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_RATIONAL_BSPLINE_SURFACE_H

#include <CGAL/Geometric_continuity/surfaces/Rational_bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// A rational tensor-product B-spline surface (NURBS)
/// \f$ S(u, v) = \sum_{ij} w_{ij} b_{ij} N_i^p(u) N_j^q(v) / \sum_{ij} w_{ij} N_i^p(u) N_j^q(v) \f$ over two `Knot_vector`s, with
/// control points \f$ b_{ij} \f$ and as many weights. See `Rational_surface`.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits> using Rational_bspline_surface = Rational_surface<Bspline_surface<Traits>>;

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_RATIONAL_BSPLINE_SURFACE_H
