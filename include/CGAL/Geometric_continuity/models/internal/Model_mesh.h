// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_MODEL_MESH_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_MODEL_MESH_H

#include <CGAL/Geometric_continuity/models/internal/Model_topology.h>
#include <CGAL/Geometric_continuity/models/internal/Patch_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

/// \file Model_mesh.h
/// The triangles of a model of Bézier patches without cracks: first the points of corners, then those of edges, each once
/// for all patches that have them, then the inside of the patches.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

enum class Edge_end { first, last };

template <class Traits> class Model_mesh {
  typedef typename Traits::FT FT;
  typedef Bezier_patch<Traits> Patch;
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::vector<const Patch*> patches_;
  std::vector<std::size_t> numbers_; // of the patches, in the tessellation
  Model_topology<Traits> topology_;
  std::vector<Patch_cells> cells_;
  std::vector<std::size_t> corners_;                               // their points, by the numbers of the topology
  std::vector<typename Patch_triangulation<Traits>::Edges> edges_; // by patch
  Tessellation<Traits> mesh_;

public:
  Model_mesh(const std::vector<const Patch*>& patches, const std::vector<std::size_t>& numbers)
      : patches_(patches), numbers_(numbers), topology_(patches), corners_(4 * patches.size(), none),
        edges_(patches.size()) {}

  // `cells_of(patch, least)` is the number of cells of a patch, if possible at least `least` in each direction: four cells
  // make the triangles of patches a manifold that close up, or meet more than once. Where two patches have an edge, one of
  // their numbers along it must divide the other.
  template <class Cells_of> Tessellation<Traits> operator()(Cells_of cells_of) {
    for (std::size_t i = 0; i < patches_.size(); ++i)
      cells_.push_back(cells_of(*patches_[i], topology_.simple(i) ? 1 : 4));
    for (const std::vector<Edge_use>& uses : topology_.edges()) add_edge(uses);
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      for (Patch_edge edge : patch_edges)
        if (points_of(i, edge).empty()) points_of(i, edge).push_back(end(i, edge, Edge_end::first)); // collapsed
      Patch_triangulation<Traits>(*patches_[i], numbers_[i], cells_[i], edges_[i], mesh_);
    }
    return std::move(mesh_);
  }

private:
  std::vector<std::size_t>& points_of(std::size_t patch, Patch_edge edge) {
    return edges_[patch][static_cast<std::size_t>(edge)];
  }

  std::size_t number_of_cells(const Edge_use& use) const {
    return static_cast<std::size_t>(runs_along_u(use.edge) ? cells_[use.patch].u : cells_[use.patch].v);
  }

  std::size_t add_point(std::size_t patch, const typename Traits::Point& point, const FT& u, const FT& v) {
    mesh_.points.push_back(point);
    mesh_.places.push_back({numbers_[patch], u, v});
    return mesh_.points.size() - 1;
  }

  // The point at one of the ends of an edge.
  std::size_t end(std::size_t patch, Patch_edge edge, Edge_end which) {
    const bool last = which == Edge_end::last, u = runs_along_u(edge) ? last : at_upper_end(edge),
               v = runs_along_u(edge) ? at_upper_end(edge) : last;
    std::size_t& point = corners_[topology_.corner(patch, u, v)];
    const Patch& s = *patches_[patch];
    if (point == none)
      point = add_point(patch, s.control_point(u ? s.degree_u() : 0, v ? s.degree_v() : 0),
                        u ? s.domain_u().second : s.domain_u().first, v ? s.domain_v().second : s.domain_v().first);
    return point;
  }

  // The points of an edge are computed once, from its first use, as many as the patch with the most cells needs.
  void add_edge(const std::vector<Edge_use>& uses) {
    std::size_t n = 1;
    for (const Edge_use& use : uses) n = (std::max)(n, number_of_cells(use));
    const std::size_t i = uses[0].patch;
    const Patch_edge edge = uses[0].edge;
    const Patch& s = *patches_[i];
    std::vector<Coordinates<Traits>> net;
    for (int k = 0; k <= s.degree_along(edge); ++k) net.push_back(coordinates<Traits>(s.control_point(edge, k, 0)));
    const std::vector<std::vector<FT>> weights = bernstein_weights<FT>(s.degree_along(edge), n);
    const FT u0 = at_upper_end(edge) ? s.domain_u().second : s.domain_u().first,
             v0 = at_upper_end(edge) ? s.domain_v().second : s.domain_v().first;
    std::vector<std::size_t> points(1, end(i, edge, Edge_end::first));
    for (std::size_t k = 1; k < n; ++k) {
      const FT t = fraction_of(s.domain(edge), k, n);
      const bool along_u = runs_along_u(edge);
      points.push_back(
          add_point(i, to_point<Traits>(weighted_sum(weights[k], net)), along_u ? t : u0, along_u ? v0 : t));
    }
    points.push_back(end(i, edge, Edge_end::last));
    for (const Edge_use& use : uses) {
      std::vector<std::size_t>& side = points_of(use.patch, use.edge);
      side = points;
      if (use.backwards) std::reverse(side.begin(), side.end());
    }
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_MODEL_MESH_H
