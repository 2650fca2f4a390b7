// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_PARAMETER_LINE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_PARAMETER_LINE_H

/// \file Parameter_line.h
/// The lines on a surface on which one of its parameters is constant, and the parts of the surface beside them.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// The two kinds of parameter lines of a surface.
enum class Parameter_line {
  along_u, ///< `v` is constant
  along_v  ///< `u` is constant
};

/// \ingroup PkgGeometricContinuitySurfaces
/// The two parts of a surface beside a parameter line.
enum class Line_side {
  smaller_parameters, ///< where the parameter that is constant on the line is smaller
  larger_parameters   ///< where it is larger
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_PARAMETER_LINE_H
