// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_PATCH_EDGE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_PATCH_EDGE_H

#include <array>
#include <ostream>
#include <string>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// The edges of a rectangular patch on [a, b] x [c, d]. Each runs in the direction of its growing parameter.
enum class Patch_edge {
  u0, ///< `u = a`, run through by `v`
  u1, ///< `u = b`, run through by `v`
  v0, ///< `v = c`, run through by `u`
  v1  ///< `v = d`, run through by `u`
};

/// \ingroup PkgGeometricContinuitySurfaces
/// All edges, in the order of the enumeration.
constexpr std::array<Patch_edge, 4> patch_edges = {Patch_edge::u0, Patch_edge::u1, Patch_edge::v0, Patch_edge::v1};

/// \ingroup PkgGeometricContinuitySurfaces
/// Whether the edge is run through by `u`.
inline bool runs_along_u(Patch_edge edge) { return edge == Patch_edge::v0 || edge == Patch_edge::v1; }

/// \ingroup PkgGeometricContinuitySurfaces
/// Whether the edge lies at the upper end of the parameter that is constant on it.
inline bool at_upper_end(Patch_edge edge) { return edge == Patch_edge::u1 || edge == Patch_edge::v1; }

/// \ingroup PkgGeometricContinuitySurfaces
inline std::string to_string(Patch_edge edge) {
  return std::string(runs_along_u(edge) ? "v" : "u") + (at_upper_end(edge) ? '1' : '0');
}

inline std::ostream& operator<<(std::ostream& os, Patch_edge edge) { return os << to_string(edge); }

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_PATCH_EDGE_H
