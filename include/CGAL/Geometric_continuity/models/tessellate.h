// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_TESSELLATE_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_TESSELLATE_H

#include <CGAL/Geometric_continuity/internal/Other_members.h>
#include <CGAL/Geometric_continuity/models/internal/Model_mesh.h>
#include <CGAL/Geometric_continuity/models/internal/Triangle_halfedges.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>
#include <CGAL/Geometric_continuity/surfaces/evaluate_grid.h>

#include <CGAL/boost/graph/properties.h>
#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file tessellate.h
/// Triangles that stand for surfaces, without cracks and within a proven distance, how they meet,
/// and their way into a mesh of \cgal.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// Triangles that stand for a surface: a range of points and a range of triangles that refer to
/// them by their numbers, as the functions for polygon soups of \cgal take them. Seen from the side
/// of \f$ S_u \times S_v \f$ the corners of each triangle run counterclockwise. See `tessellate()`.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> struct Tessellation {
  typedef Traits_ Traits;                      ///< the geometric traits
  typedef typename Traits::FT FT;              ///< the number type
  typedef typename Traits::Point Point;        ///< the points
  typedef std::array<std::size_t, 3> Triangle; ///< the numbers of three points

  /// Where a point lies.
  struct Place {
    std::size_t patch; ///< the number of the patch or surface, from 0 on
    FT u;              ///< in its domain
    FT v;              ///< in its domain
  };

  std::vector<Point> points;        ///< each once, also if several patches have it
  std::vector<Triangle> triangles;  ///< numbers of points
  std::vector<std::size_t> patches; ///< for each triangle, the number of its patch or surface
  std::vector<Place> places;        ///< for each point, one place where the surface has it
};

/// \ingroup PkgGeometricContinuitySurfaces
/// The counts of edges at which the triangles of a tessellation meet.
struct Mesh_edges {
  std::size_t inner = 0;    ///< edges of two triangles, which pass them in opposite directions
  std::size_t boundary = 0; ///< edges of one triangle only
  /// edges of more than two triangles, or of two which pass them in one direction
  std::size_t irregular = 0;

  /// Returns the number of all edges.
  std::size_t number_of_edges() const { return inner + boundary + irregular; }

  /// Tells whether each edge has a triangle on both sides.
  bool watertight() const { return boundary == 0 && irregular == 0; }

  /// Writes the counts, e.g. `96 edges, watertight` or `96 edges, 12 on the boundary`.
  friend std::ostream& operator<<(std::ostream& os, const Mesh_edges& e) {
    os << e.number_of_edges() << " edges, ";
    if (e.watertight()) return os << "watertight";
    if (e.boundary > 0) os << e.boundary << " on the boundary";
    if (e.irregular > 0) os << (e.boundary > 0 ? ", " : "") << e.irregular << " irregular";
    return os;
  }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Counts the edges of triangles by how many triangles meet at them. \f$ O(n \log n) \f$ for `n`
/// triangles
/// \tparam TriangleRange a forward range of triples of numbers of points
template <class TriangleRange> Mesh_edges mesh_edges(const TriangleRange& triangles) {
  struct Use {
    std::size_t low, high;
    bool upwards;
    bool same_edge(const Use& other) const { return low == other.low && high == other.high; }
  };
  std::vector<Use> uses;
  uses.reserve(3 * static_cast<std::size_t>(std::distance(std::begin(triangles), std::end(triangles))));
  for (const auto& t : triangles)
    for (int i = 0; i < 3; ++i) {
      const std::size_t a = t[i], b = t[(i + 1) % 3];
      uses.push_back({(std::min)(a, b), (std::max)(a, b), a < b});
    }
  std::sort(uses.begin(), uses.end(),
            [](const Use& a, const Use& b) { return std::make_pair(a.low, a.high) < std::make_pair(b.low, b.high); });
  Mesh_edges result;
  for (auto first = uses.begin(), last = first; first != uses.end(); first = last) {
    while (last != uses.end() && first->same_edge(*last)) ++last;
    if (last - first == 1)
      ++result.boundary;
    else
      ++(last - first == 2 && first[0].upwards != first[1].upwards ? result.inner : result.irregular);
  }
  return result;
}

/// \ingroup PkgGeometricContinuitySurfaces
/// The largest number of triangles that `tessellate()` makes unless another number is given, so
/// that a wrong tolerance cannot fill the memory: each takes about 60 bytes.
constexpr std::size_t max_tessellation_triangles = 1 << 22;

/// \ingroup PkgGeometricContinuitySurfaces
/// The largest number of cells into which `tessellate()` cuts a Bézier patch in one direction.
constexpr int max_cells_in_one_direction = 1 << 12;

/// \ingroup PkgGeometricContinuitySurfaces
/// Each Bézier patch is cut into `n` times `n` cells, equal in its parameters.
struct Uniform_grid {
  int n; ///< from 1 to `max_cells_in_one_direction`
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Each Bézier patch is cut into as few equal cells as suffice that it is nowhere farther from its
/// triangles than the tolerance, by the proof in `Patch_flatness`. The numbers of cells in `u` and
/// in `v` are powers of two.
struct Chord_tolerance {
  double distance; ///< positive, in the unit of the coordinates
};

/// \ingroup PkgGeometricContinuitySurfaces
/// The phases that `tessellate()` counts when it reports its progress.
enum class Tessellation_stage {
  patches,  ///< the Bézier patches into which the surfaces have been cut
  triangles ///< the triangles that have been made
};

namespace internal {

inline std::string surface_in_tessellation(std::size_t number) {
  return "tessellate: surface " + std::to_string(number);
}

// Returns the bounds of a Bezier patch before its edges are compared with those of others.
template <class Patch> Patch_cells bounds_of_patch(const Uniform_grid& grid, const Patch&, std::size_t) {
  return {grid.n, grid.n};
}
template <class Patch> Patch_flatness bounds_of_patch(const Chord_tolerance&, const Patch& patch, std::size_t number) {
  const Patch_flatness flatness(patch);
  if (!std::isfinite(flatness.distance({max_cells_in_one_direction, max_cells_in_one_direction})))
    throw Error(Error_code::unreachable_tolerance,
                surface_in_tessellation(number) + ": the second derivatives of a patch overflow");
  return flatness;
}

inline Patch_cells cells_of_patch(const Uniform_grid&, const Patch_cells& cells, std::size_t, int) { return cells; }
inline Patch_cells cells_of_patch(const Chord_tolerance& tolerance, const Patch_flatness& flatness, std::size_t number,
                                  int least) {
  constexpr int most = max_cells_in_one_direction;
  const std::optional<Patch_cells> cells = flatness.cells(tolerance.distance, least, most);
  if (!cells)
    throw Error(Error_code::work_limit, surface_in_tessellation(number) + " needs more than " + std::to_string(most) +
                                            " cells of a patch in one direction");
  return *cells;
}

// No fewer cells suffice for a Bezier patch, and for a surface that may have several.
inline double least_cells(const Uniform_grid&, const Patch_cells& cells) { return double(cells.u) * cells.v; }
inline double least_cells(const Chord_tolerance& tolerance, const Patch_flatness& flatness) {
  return flatness.least_cells(tolerance.distance);
}
inline double least_cells_of_any_patch(const Uniform_grid& grid) { return double(grid.n) * grid.n; }
inline double least_cells_of_any_patch(const Chord_tolerance&) { return 1; }

inline void check_mode(const Uniform_grid& grid) {
  check_count(grid.n, "tessellate: a grid");
  if (grid.n == 0) throw Error(Error_code::wrong_number_of_points, "tessellate: a grid of no cells");
  if (grid.n > max_cells_in_one_direction)
    throw Error(Error_code::work_limit, "tessellate: a grid of " + std::to_string(grid.n) + " cells where at most " +
                                            std::to_string(max_cells_in_one_direction) + " are made");
}

inline void check_mode(const Chord_tolerance& tolerance) {
  check_finite(tolerance.distance, "tessellate: the tolerance");
  if (!(tolerance.distance > 0))
    throw Error(Error_code::unreachable_tolerance, "tessellate: the tolerance must be positive");
}

// The Bezier patches of one or more surfaces, each with the number of its surface. Before a surface
// is cut into them, before edges are compared and before the first point is computed, it is known
// that the triangles are not too many.
template <class Patch, class Mode> class Numbered_patches {
  typedef typename Patch::Traits Traits;
  typedef decltype(bounds_of_patch(std::declval<const Mode&>(), std::declval<const Patch&>(), 0)) Bounds;
  const Mode& mode_;
  std::size_t max_triangles_;
  Triangle_budget least_; // of the patches that are there
  std::vector<Patch> patches_;
  std::vector<std::size_t> numbers_;
  std::vector<Bounds> bounds_;

public:
  Numbered_patches(const Mode& mode, std::size_t max_triangles)
      : mode_(mode), max_triangles_(max_triangles), least_(max_triangles) {
    check_mode(mode);
  }

  template <class SurfaceRange, class Report> void add_all(const SurfaceRange& surfaces, Report& report) {
    Triangle_budget least(max_triangles_);
    std::size_t number = 0, all = 0;
    for (const auto& surface : surfaces) {
      require_space(surface, "tessellate");
      const std::size_t n = number_of_patches(surface);
      least.add(2 * static_cast<double>(n) * least_cells_of_any_patch(mode_), number++);
      all += n;
    }
    patches_.reserve(all);
    numbers_.reserve(all);
    bounds_.reserve(all);
    number = 0;
    for (const auto& surface : surfaces) add(surface, number++, report);
  }

  template <class Report> Tessellation<Traits> operator()(Report& report) const {
    std::vector<const Patch*> pointers;
    pointers.reserve(patches_.size());
    for (const Patch& patch : patches_) pointers.push_back(&patch);
    return Model_mesh<Patch, Tessellation<Traits>>(pointers, numbers_)(
        [&](std::size_t i, int least) { return cells_of_patch(mode_, bounds_[i], numbers_[i], least); }, max_triangles_,
        [&](std::size_t n) { report(Tessellation_stage::triangles, n); });
  }

private:
  static std::size_t number_of_patches(const Patch&) { return 1; }
  template <class Spline> static std::size_t number_of_patches(const Spline& surface) {
    return static_cast<std::size_t>(surface.knots_u().number_of_spans()) * surface.knots_v().number_of_spans();
  }

  template <class Report> void add(Patch patch, std::size_t number, Report& report) {
    bounds_.push_back(bounds_of_patch(mode_, patch, number));
    least_.add(2 * least_cells(mode_, bounds_.back()), number);
    patches_.push_back(std::move(patch));
    numbers_.push_back(number);
    report(Tessellation_stage::patches, patches_.size());
  }
  template <class Spline, class Report> void add(const Spline& surface, std::size_t number, Report& report) {
    surface.for_each_bezier_patch([&](Patch patch) { add(std::move(patch), number, report); });
  }
};

// The patches of which a surface consists.
template <class Surface>
using Patch_of = std::conditional_t<Is_rational<Surface>::value, Rational_bezier_patch<typename Surface::Traits>,
                                    Bezier_patch<typename Surface::Traits>>;

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Tessellates a model: makes triangles from the patches or surfaces of a range, welded along their
/// common edges.
///
/// Edges are the same when `model_continuity()` says so: by exact comparison of their curves, in
/// either direction and also if their degrees differ. A point on a common edge is computed once, so
/// that there are no cracks, with rounded numbers neither. It has as many points as the patch with
/// the most cells along it needs; the other patch takes them into the triangles of its outermost
/// cells. A collapsed edge gives one point. The numbers of the triangles are those in the range,
/// for the Bézier patches of a B-spline surface that of the surface.
///
/// The corners of a triangle are listed counterclockwise as seen from the side to which
/// \f$ S_u \times S_v \f$ points. Those of a closed part of the model, a solid, are listed
/// counterclockwise as seen from outside, whatever the direction of its parameters: each part of
/// which all edges are shared by two patches of one orientation, and whose volume is not zero.
///
/// The triangles are those of an oriented manifold if the patches are, with one exception: a patch
/// of which two adjacent edges are the same curve. With `Uniform_grid` this needs `n >= 3` where
/// patches close up or have two edges in common. With an exact kernel all points lie on the surface
/// exactly.
///
/// \f$ O(n \log n) \f$ comparisons of edges of `n` patches, and \f$ O(p^2) \f$ operations for each
/// point on a patch of degree `p`.
///
/// \param surfaces the patches or surfaces
/// \param mode how fine the triangles are
/// \param max_triangles more triangles are refused. Their number is predicted, up to those at
///   collapsed edges, from the numbers of cells, and from the knots even before a surface is cut
///   into patches
/// \param report is called as `report(stage, n)` with a `Tessellation_stage`: with the number of
///   Bézier patches so far after each that has been cut, and then with the number of triangles so
///   far after each whose triangles have been made
/// \tparam SurfaceRange a forward range of `Bezier_patch`, `Bspline_surface`,
///   `Rational_bezier_patch` or `Rational_bspline_surface`
/// \tparam Mode `Uniform_grid` or `Chord_tolerance`
/// \throws Error `unreachable_tolerance` for a tolerance that is not positive, or when the bounds
///   in `Patch_flatness` overflow; `not_finite` for a tolerance that is infinite or not a number;
///   `work_limit`, with the number of the surface, for more than `max_triangles` triangles, and for
///   a grid or a tolerance that would need more than `max_cells_in_one_direction` cells in a
///   direction of a patch; `negative_count` and `wrong_number_of_points` for a grid with a negative
///   number of cells and with none; `dimension_mismatch` unless in dimension 3. No point is
///   computed before
template <class SurfaceRange, class Mode, class Report>
auto tessellate(const SurfaceRange& surfaces, const Mode& mode, std::size_t max_triangles, Report report)
    -> Tessellation<typename std::decay_t<decltype(*std::begin(surfaces))>::Traits> {
  typedef std::decay_t<decltype(*std::begin(surfaces))> Surface;
  internal::Numbered_patches<internal::Patch_of<Surface>, Mode> patches(mode, max_triangles);
  patches.add_all(surfaces, report);
  return patches(report);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Tessellates a model, without reports.
/// \throws Error as the function that reports
template <class SurfaceRange, class Mode>
auto tessellate(const SurfaceRange& surfaces, const Mode& mode, std::size_t max_triangles = max_tessellation_triangles)
    -> Tessellation<typename std::decay_t<decltype(*std::begin(surfaces))>::Traits> {
  return tessellate(surfaces, mode, max_triangles, [](Tessellation_stage, std::size_t) {});
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Tessellates a patch or a surface, Bézier patch by Bézier patch, as a model of one: welded also
/// where it closes up.
/// \tparam Surface `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`
/// \throws Error as the function that tessellates a model
template <class Surface, class Mode>
Tessellation<typename Surface::Traits> tessellate(const Surface& surface, const Mode& mode,
                                                  std::size_t max_triangles = max_tessellation_triangles) {
  static_assert(internal::is_surface<Surface>, CGAL_GEOMETRIC_CONTINUITY_ASK_POLYLINE);
  static_assert(!internal::is_surface<Surface> || !std::is_arithmetic_v<Mode>,
                "tessellate(s, Chord_tolerance{0.01}) takes a tolerance, tessellate(s, Uniform_grid{10}) a number of "
                "cells in each direction of a patch");
  if constexpr (internal::is_surface<Surface> && !std::is_arithmetic_v<Mode>)
    return tessellate(std::array<Surface, 1>{surface}, mode, max_triangles);
  else // so that there is one error
    return {};
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Appends triangles to a mesh of \cgal: a vertex for each point, a face for each triangle, with
/// the orientation that `tessellate()` gives it, outwards for closed solids. When it throws, the
/// mesh has
/// not been changed. \f$ O(n \log n) \f$ for `n` triangles
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam Mesh a model of the concept `MutableFaceGraph` of \cgal
/// \tparam VertexPointMap a writable property map from the vertices of the mesh to points, to which
///   `Traits::Point` is assigned
/// \throws Error `not_a_manifold` when an edge has more than two triangles or two of opposite
///   orientations, or the triangles at a point are not one fan, or a triangle has one point twice
///   or a point that does not exist
template <class Traits, class Mesh, class VertexPointMap>
void to_face_graph(const Tessellation<Traits>& tessellation, Mesh& mesh, VertexPointMap points) {
  typedef boost::graph_traits<Mesh> Graph;
  typedef typename Graph::vertex_descriptor Vertex;
  typedef typename Graph::halfedge_descriptor Halfedge;
  typedef typename Graph::face_descriptor Face;
  const internal::Triangle_halfedges triangles(tessellation.triangles, tessellation.points.size());

  std::vector<Vertex> vertices;
  for (const typename Traits::Point& point : tessellation.points) {
    vertices.push_back(add_vertex(mesh));
    put(points, vertices.back(), point);
  }
  std::vector<Halfedge> halfedges(triangles.size(), Graph::null_halfedge());
  for (std::size_t h = 0; h < triangles.size(); ++h) {
    if (!triangles.on_boundary(h) && triangles.opposite(h) < h) {
      halfedges[h] = opposite(halfedges[triangles.opposite(h)], mesh);
      continue;
    }
    halfedges[h] = halfedge(add_edge(mesh), mesh);
    set_target(halfedges[h], vertices[triangles.target(h)], mesh);
    set_target(opposite(halfedges[h], mesh), vertices[triangles.source(h)], mesh);
  }
  // along the boundary
  std::vector<Halfedge> leaving(tessellation.points.size(), Graph::null_halfedge());
  for (std::size_t h = 0; h < triangles.size(); ++h) {
    set_halfedge(vertices[triangles.target(h)], halfedges[h], mesh);
    set_next(halfedges[h], halfedges[triangles.next(h)], mesh);
    if (triangles.on_boundary(h)) leaving[triangles.target(h)] = opposite(halfedges[h], mesh);
  }
  for (std::size_t t = 0; t < tessellation.triangles.size(); ++t) {
    const Face face = add_face(mesh);
    set_halfedge(face, halfedges[3 * t], mesh);
    for (int i = 0; i < 3; ++i) set_face(halfedges[3 * t + i], face, mesh);
  }
  for (std::size_t h = 0; h < triangles.size(); ++h)
    if (triangles.on_boundary(h)) {
      const Halfedge border = opposite(halfedges[h], mesh); // ends where h begins
      set_face(border, Graph::null_face(), mesh);
      set_next(border, leaving[triangles.source(h)], mesh);
      set_halfedge(vertices[triangles.source(h)], border, mesh);
    }
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Appends triangles to a mesh of \cgal, whose point map is `get(CGAL::vertex_point, mesh)`: a
/// vertex for each point, a face for each triangle. When it throws, the mesh has not been changed.
/// \f$ O(n \log n) \f$ for `n` triangles
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam Mesh a model of the concept `MutableFaceGraph` of \cgal with a property map of points
/// \throws Error `not_a_manifold` when an edge has more than two triangles or two of opposite
///   orientations, or the triangles at a point are not one fan, or a triangle has one point twice
///   or a point that does not exist
template <class Traits, class Mesh> void to_face_graph(const Tessellation<Traits>& tessellation, Mesh& mesh) {
  to_face_graph(tessellation, mesh, get(CGAL::vertex_point, mesh));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_TESSELLATE_H
