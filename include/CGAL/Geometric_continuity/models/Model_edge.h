// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_MODEL_EDGE_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_MODEL_EDGE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/edges/knot_line_continuity.h>

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// What an edge of a model is.
enum class Model_edge_kind {
  shared,   ///< two patches have it
  boundary, ///< only one patch has it
  collapsed ///< it is a single point: all its control points are equal
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the name of a kind, as spelled in the enumeration.
inline std::string to_string(Model_edge_kind kind) {
  switch (kind) {
  case Model_edge_kind::shared: return "shared";
  case Model_edge_kind::boundary: return "boundary";
  case Model_edge_kind::collapsed: return "collapsed";
  }
  return "unknown";
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Writes the name of a kind.
inline std::ostream& operator<<(std::ostream& os, Model_edge_kind kind) { return os << to_string(kind); }

/// \ingroup PkgGeometricContinuitySurfaces
/// An edge of a model, with the decision if it is shared.
/// \tparam FT the field in which it was decided
template <class FT> struct Model_edge {
  Model_edge_kind kind;                  ///< whether there is a second patch
  std::size_t patch_a;                   ///< the number of the patch, from 0 on
  Patch_edge edge_a;                     ///< its edge
  std::optional<std::size_t> patch_b;    ///< the other patch of a shared edge; the same one where a patch closes up
  std::optional<Patch_edge> edge_b;      ///< its edge
  bool non_manifold = false;             ///< more than two patches have the edge
  Spline_edge_continuity<FT> continuity; ///< of a shared edge, with a verdict for each span of the knots

  /// Writes the row, e.g. `0 u1 - 1 u0: G2` or `5 v0: boundary`.
  friend std::ostream& operator<<(std::ostream& os, const Model_edge& e) {
    os << e.patch_a << ' ' << e.edge_a;
    if (e.kind != Model_edge_kind::shared) return os << ": " << e.kind;
    os << " - " << *e.patch_b << ' ' << *e.edge_b << ": " << e.continuity;
    return os << (e.non_manifold ? ", non-manifold" : "");
  }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// A knot line inside one of the surfaces of a model.
/// \tparam FT the field in which it was decided
template <class FT> struct Model_knot_line {
  std::size_t patch;  ///< the number of the surface, from 0 on
  Knot_line<FT> line; ///< the line and the decision

  /// Writes the row, e.g. `3 u = 1/2: G1 (curvature)`.
  friend std::ostream& operator<<(std::ostream& os, const Model_knot_line& l) { return os << l.patch << ' ' << l.line; }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// How many edges of a model have which continuity.
struct Model_summary {
  std::size_t g2 = 0;                ///< shared edges that are \f$ G^2 \f$
  std::size_t g1 = 0;                ///< shared edges that are \f$ G^1 \f$ but not \f$ G^2 \f$
  std::size_t g0 = 0;                ///< shared edges that are not \f$ G^1 \f$
  std::size_t vanishing_normals = 0; ///< those of `g0` whose only defect is that a normal vanishes somewhere
  std::size_t creases = 0;           ///< those of `g0` where the tangent planes differ somewhere
  std::size_t folds = 0;             ///< those of `g0` where both surfaces lie on one side somewhere, and no crease is
  std::size_t boundary = 0;          ///< edges of one patch only
  std::size_t collapsed = 0;         ///< edges that are single points
  std::size_t non_manifold = 0; ///< pairs of patches at an edge that more than two patches have; counted above, too
  /// Knot lines inside B-spline surfaces that are \f$ G^2 \f$ though the knot is multiple.
  std::size_t knot_lines_g2 = 0;
  std::size_t knot_lines_g1 = 0; ///< knot lines that are \f$ G^1 \f$ but not \f$ G^2 \f$
  std::size_t knot_lines_g0 = 0; ///< knot lines that are not \f$ G^1 \f$

  /// Writes the counts, e.g. `24 G2, 20 G1, 8 G0 (8 vanishing normals), 16 boundary, 8 collapsed`, and those of knot lines
  /// if there are any.
  friend std::ostream& operator<<(std::ostream& os, const Model_summary& s) {
    os << s.g2 << " G2, " << s.g1 << " G1, " << s.g0 << " G0";
    const char* separator = " (";
    const auto part = [&](std::size_t n, const char* what) {
      if (n == 0) return;
      os << separator << n << what;
      separator = ", ";
    };
    part(s.creases, " creases");
    part(s.folds, " folds");
    part(s.vanishing_normals, " vanishing normals");
    os << (s.g0 > 0 ? "), " : ", ") << s.boundary << " boundary, " << s.collapsed << " collapsed";
    if (s.non_manifold > 0) os << ", " << s.non_manifold << " non-manifold";
    if (s.knot_lines_g2 + s.knot_lines_g1 + s.knot_lines_g0 > 0)
      os << "; knot lines: " << s.knot_lines_g2 << " G2, " << s.knot_lines_g1 << " G1, " << s.knot_lines_g0 << " G0";
    return os;
  }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// What was decided about all edges of a model, and about the knot lines of B-spline surfaces.
template <class FT> struct Model_continuity {
  std::vector<Model_edge<FT>> edges;           ///< by the number of the first patch, then by its edge
  std::vector<Model_knot_line<FT>> knot_lines; ///< by the number of the surface, see `knot_line_continuity()`
  Model_summary summary;                       ///< of edges and knot lines

  /// Returns whether all shared edges and all knot lines have at least this order.
  bool has_order(int g_order) const { return failing(g_order).empty() && failing_knot_lines(g_order).empty(); }

  /// Returns the knot lines whose order is less than `g_order`.
  std::vector<Model_knot_line<FT>> failing_knot_lines(int g_order) const {
    std::vector<Model_knot_line<FT>> result;
    for (const Model_knot_line<FT>& l : knot_lines)
      if (l.line.continuity.g_order < g_order) result.push_back(l);
    return result;
  }

  /// Returns the shared edges whose order is less than `g_order`.
  std::vector<Model_edge<FT>> failing(int g_order) const {
    std::vector<Model_edge<FT>> result;
    for (const Model_edge<FT>& e : edges)
      if (e.kind == Model_edge_kind::shared && e.continuity.g_order < g_order) result.push_back(e);
    return result;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_MODEL_EDGE_H
