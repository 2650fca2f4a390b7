// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_RATIONAL_BEZIER_PATCH_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_RATIONAL_BEZIER_PATCH_H

#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// A rational tensor-product Bézier patch
/// \f$ S(u, v) = \sum_{ij} w_{ij} b_{ij} B_i^p(s) B_j^q(t) / \sum_{ij} w_{ij} B_i^p(s) B_j^q(t) \f$, \f$ s = (u-a)/(b-a) \f$,
/// \f$ t = (v-c)/(d-c) \f$, with control points \f$ b_{ij} \f$ and weights \f$ w_{ij} \f$ on [a, b] x [c, d], by default the
/// unit square: pieces of cylinders, spheres and tori, and of all NURBS surfaces. See `Rational_surface`.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits> using Rational_bezier_patch = Rational_surface<Bezier_patch<Traits>>;

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_RATIONAL_BEZIER_PATCH_H
