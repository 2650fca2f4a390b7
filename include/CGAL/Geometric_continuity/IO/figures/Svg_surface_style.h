// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_SVG_SURFACE_STYLE_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_SVG_SURFACE_STYLE_H

#include <string>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// How the faces of surfaces are painted.
enum class Svg_shading {
  isophotes, ///< in strips of equal angles of the normal and the light: where the strips have a kink the surface is not
             ///< \f$ G^2 \f$, where they break it is not \f$ G^1 \f$
  smooth     ///< by the angle of the normal and the light
};

/// \ingroup PkgGeometricContinuityIO
/// How surfaces are drawn.
struct Svg_surface_style {
  Svg_shading shading = Svg_shading::isophotes; ///< the faces
  double azimuth = -60;                         ///< where the viewer is: degrees around the z-axis from the x-axis
  double elevation = 22;                        ///< where the viewer is: degrees above the ground
  std::string title;                            ///< plain text in UTF-8
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_SVG_SURFACE_STYLE_H
