// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_PATCH_EDGE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_PATCH_EDGE_H

#include <array>
#include <ostream>
#include <string>

/// \file Patch_edge.h
/// The four edges of a patch, and the lines on a surface on which one of its parameters is constant, by name.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// The edges of a rectangular patch on [a, b] x [c, d]. Each runs in the direction of its growing parameter.
enum class Patch_edge {
  u0, ///< `u = a`, parametrised by `v`
  u1, ///< `u = b`, parametrised by `v`
  v0, ///< `v = c`, parametrised by `u`
  v1  ///< `v = d`, parametrised by `u`
};

/// \ingroup PkgGeometricContinuitySurfaces
/// All edges, in the order of the enumeration.
constexpr std::array<Patch_edge, 4> patch_edges = {Patch_edge::u0, Patch_edge::u1, Patch_edge::v0, Patch_edge::v1};

/// \ingroup PkgGeometricContinuitySurfaces
/// Tells whether an edge is parametrised by `u`.
inline bool runs_along_u(Patch_edge edge) { return edge == Patch_edge::v0 || edge == Patch_edge::v1; }

/// \ingroup PkgGeometricContinuitySurfaces
/// Tells whether an edge lies at the upper end of the parameter that is constant on it.
inline bool at_upper_end(Patch_edge edge) { return edge == Patch_edge::u1 || edge == Patch_edge::v1; }

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the name of an edge, as spelled in the enumeration.
inline std::string to_string(Patch_edge edge) {
  return std::string(runs_along_u(edge) ? "v" : "u") + (at_upper_end(edge) ? '1' : '0');
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Writes the name of an edge.
inline std::ostream& operator<<(std::ostream& os, Patch_edge edge) { return os << to_string(edge); }

/// \ingroup PkgGeometricContinuitySurfaces
/// How the second of two edges runs in comparison with the first one.
enum class Edge_direction {
  same,    ///< forwards
  opposite ///< backwards
};

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

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_PATCH_EDGE_H
