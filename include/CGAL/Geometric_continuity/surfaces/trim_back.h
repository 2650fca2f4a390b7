// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_TRIM_BACK_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_TRIM_BACK_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>

#include <string>

/// \file trim_back.h
/// A surface without a strip along one of its edges, as it is needed where something else is put in the place of the edge.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the surface without the strip of a constant width along an edge: for the edge `v = d` of a surface on [a, b] x [c, d] the part
/// on [a, b] x [c, d - distance], with the same parameters. A Bézier patch is split, knots of a B-spline surface are inserted. Exact with
/// an exact kernel.
/// \param surface a `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or `Rational_bspline_surface`
/// \param edge the edge that is cut off
/// \param distance in the parameter that is constant on the edge
/// \throws Error `parameter_outside_domain` unless the distance is positive and less than the length of the domain, with the edge;
///   `not_finite` when floating-point numbers overflow
template <class Surface>
Surface trim_back(const Surface& surface, Patch_edge edge, const typename Surface::FT& distance) {
  typedef typename Surface::FT FT;
  const typename Surface::Interval domain = runs_along_u(edge) ? surface.domain_v() : surface.domain_u();
  const FT cut = at_upper_end(edge) ? FT(domain.second - distance) : FT(domain.first + distance);
  if (!(domain.first < cut && cut < domain.second))
    throw Error(Error_code::parameter_outside_domain, "trim_back: the distance from the edge " + to_string(edge) +
                                                          " does not lie between 0 and the other edge");
  const auto parts = runs_along_u(edge) ? surface.split_v(cut) : surface.split_u(cut);
  return at_upper_end(edge) ? parts.first : parts.second;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_TRIM_BACK_H
