// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_MODEL_MESH_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_MODEL_MESH_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/models/internal/Edge_groups.h>
#include <CGAL/Geometric_continuity/models/internal/Patch_triangulation.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>
#include <CGAL/Geometric_continuity/surfaces/evaluate_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// \file Model_mesh.h
/// The triangles of a model of Bézier patches without cracks: first the points of corners, then
/// those of edges, each once for all patches that have them, then the inside of the patches. Which
/// edges and corners are the same is found first.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The edges and corners of the patches of a model, those that are the same under one number. Edges
// are the same as in `model_continuity()`. Corners are the same where they are ends of the same
// edge, or of a collapsed edge; corners that merely have the same coordinates are not.
template <class Patch> class Model_topology {
  typedef std::pair<std::size_t, std::size_t> Pair;

  Edge_groups<Patch> groups_;
  // of the corner 4 * patch + 2 * (at the end of u) + (at the end of v)
  std::vector<std::size_t> parent_;
  std::vector<bool> simple_; // by patch

public:
  // The patches are not copied.
  explicit Model_topology(const std::vector<const Patch*>& patches)
      : groups_(patches), parent_(4 * patches.size()), simple_(patches.size()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t(0));
    for (const Edge_use& use : groups_.collapsed()) unite(ends(use).first, ends(use).second);
    for (const Edge_uses& uses : groups_.edges()) {
      const Pair first = ends(uses[0]);
      for (const Edge_use& use : uses) {
        unite(first.first, ends(use).first);
        unite(first.second, ends(use).second);
      }
    }
    for (std::size_t& corner : parent_) corner = root(corner);
    std::vector<Pair> pairs; // of corners that have an edge or a diagonal of a patch in common
    // equivalent [2 -> 3, 1]: memory only
    pairs.reserve(groups_.edges().size() + 2 * patches.size());
    for (const Edge_uses& uses : groups_.edges()) pairs.push_back(vertices(ends(uses[0])));
    for (std::size_t i = 0; i < patches.size(); ++i)
      for (const Pair& diagonal : diagonals(i)) pairs.push_back(diagonal);
    std::sort(pairs.begin(), pairs.end());
    for (std::size_t i = 0; i < patches.size(); ++i) simple_[i] = is_simple(i, pairs);
  }

  // Returns the edges, ordered by the first use, which is that of the patch with the least number.
  const std::vector<Edge_uses>& edges() const { return groups_.edges(); }

  // The number, below four times the number of patches, of what may be the corner of several
  // patches.
  std::size_t corner(std::size_t patch, bool end_of_u, bool end_of_v) const {
    return parent_[4 * patch + 2 * end_of_u + end_of_v];
  }

  // Returns whether the four corners of the patch are different and no two of them are also two
  // corners of another patch, unless by the edge between them. Then lines from edge to edge through
  // the patch have no double elsewhere.
  bool simple(std::size_t patch) const { return simple_[patch]; }

  static constexpr std::size_t open = static_cast<std::size_t>(-1);

  // Returns for each patch the least number of a patch of the part to which it belongs, of those
  // that are connected by edges; `open` unless each edge of the part is that of two patches, whose
  // triangles pass it in opposite directions.
  std::vector<std::size_t> closed_parts() const {
    std::vector<std::size_t> part(simple_.size());
    std::iota(part.begin(), part.end(), std::size_t(0));
    const auto root = [&](std::size_t i) {
      while (part[i] != i) i = part[i] = part[part[i]];
      return i;
    };
    for (const Edge_uses& uses : groups_.edges())
      for (const Edge_use& use : uses) {
        const std::size_t a = root(uses[0].patch), b = root(use.patch);
        part[(std::max)(a, b)] = (std::min)(a, b);
      }
    for (std::size_t& p : part) p = root(p);
    std::vector<bool> closed(part.size(), true);
    for (const Edge_uses& uses : groups_.edges())
      if (uses.size() != 2 || is_passed_upwards(uses[0]) == is_passed_upwards(uses[1]))
        closed[part[uses[0].patch]] = false;
    for (std::size_t& p : part)
      if (!closed[p]) p = open;
    return part;
  }

private:
  // Returns whether the triangles of the patch, which turn from u to v, pass the edge in the
  // direction of the edge of the model.
  static bool is_passed_upwards(const Edge_use& use) {
    return (runs_along_u(use.edge) != at_upper_end(use.edge)) != use.backwards;
  }

  bool is_simple(std::size_t patch, const std::vector<Pair>& sorted_pairs) const {
    std::vector<Pair> pairs;
    for (Patch_edge edge : patch_edges) pairs.push_back(vertices(ends({patch, edge, false})));
    for (const Pair& diagonal : diagonals(patch)) pairs.push_back(diagonal);
    return std::all_of(pairs.begin(), pairs.end(), [&](const Pair& pair) {
      const auto range = std::equal_range(sorted_pairs.begin(), sorted_pairs.end(), pair);
      return pair.first != pair.second && range.second - range.first == 1;
    });
  }

  std::size_t root(std::size_t corner) {
    while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }
  void unite(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    parent_[(std::max)(a, b)] = (std::min)(a, b);
  }

  // The two corners where a use begins and ends.
  static Pair ends(const Edge_use& use) {
    const Pair ends = corners_of(use.patch, use.edge);
    return use.backwards ? Pair(ends.second, ends.first) : ends;
  }

  Pair vertices(const Pair& corners) const {
    const std::size_t a = parent_[corners.first], b = parent_[corners.second];
    return Pair((std::min)(a, b), (std::max)(a, b));
  }
  std::array<Pair, 2> diagonals(std::size_t patch) const {
    return {vertices(Pair(4 * patch, 4 * patch + 3)), vertices(Pair(4 * patch + 1, 4 * patch + 2))};
  }
};

// The triangles that are going to be made. More than the limit are refused before any of them is
// made.
class Triangle_budget {
  std::size_t limit_;
  double triangles_ = 0;

public:
  explicit Triangle_budget(std::size_t limit) : limit_(limit) {}

  // `surface` is the last for which triangles have been counted.
  void add(double triangles, std::size_t surface) {
    triangles_ = (std::min)(triangles_ + triangles, 1e300);
    if (triangles_ <= static_cast<double>(limit_)) return;
    char count[32]; // with an exponent when they are too many to be read
    std::snprintf(count, sizeof count, triangles_ < 1e15 ? "%.0f" : "%.3g", std::ceil(triangles_));
    throw Error(Error_code::work_limit, "tessellate: surface " + std::to_string(surface) + " leads to " + count +
                                            " triangles or more, where at most " + std::to_string(limit_) +
                                            " are made");
  }
  std::size_t triangles() const { return static_cast<std::size_t>(triangles_); }
};

// Makes `Mesh`, a Tessellation, of the patches.
template <class Patch, class Mesh> class Model_mesh {
  typedef typename Patch::Traits Traits;
  typedef typename Traits::FT FT;
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  // The points of an edge: those of two corners, and `cells - 1` between them, one after the other.
  struct Edge {
    std::size_t first, inner, last, cells;
  };
  // The edge of the model that is an edge of a patch; `none` when it is collapsed.
  struct Side {
    std::size_t edge = none;
    bool backwards = false;
  };

  const std::vector<const Patch*>& patches_;
  const std::vector<std::size_t>& numbers_; // of the patches, in the tessellation
  Model_topology<Patch> topology_;
  std::vector<Patch_cells> cells_;
  std::vector<std::size_t> corners_; // their points, by the numbers of the topology
  std::vector<Edge> edges_;          // of the model
  std::vector<std::array<Side, 4>> sides_;
  Mesh mesh_;
  std::vector<std::size_t> ends_; // of the triangles of each patch

public:
  // Neither patches nor numbers are copied.
  Model_mesh(const std::vector<const Patch*>& patches, const std::vector<std::size_t>& numbers)
      : patches_(patches), numbers_(numbers), topology_(patches), corners_(4 * patches.size(), none),
        sides_(patches.size()) {}

  // `cells_of(i, least)` is the number of cells of patch number i, if possible at least `least` in
  // each direction: four cells make the triangles of patches a manifold that close up, or meet more
  // than once. Where two patches have an edge, one of their numbers along it must divide the other.
  // After each patch `report(n)` is called with the number of triangles so far.
  template <class Cells_of, class Report> Mesh operator()(Cells_of cells_of, std::size_t max_triangles, Report report) {
    for (std::size_t i = 0; i < patches_.size(); ++i) cells_.push_back(cells_of(i, topology_.simple(i) ? 1 : 4));
    reserve(max_triangles);
    for (const Edge_uses& uses : topology_.edges()) add_edge(uses);
    typename Patch_triangulation<Patch, Mesh>::Edges points;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      for (Patch_edge edge : patch_edges) points_of(i, edge, points[static_cast<std::size_t>(edge)]);
      Patch_triangulation<Patch, Mesh>(*patches_[i], numbers_[i], cells_[i], points, mesh_);
      ends_.push_back(mesh_.triangles.size());
      report(mesh_.triangles.size());
    }
    turn_outwards();
    return std::move(mesh_);
  }

private:
  // A point that is added to an edge of a cell adds a triangle. Points in the middle of a cell are
  // not foreseen.
  void reserve(std::size_t max_triangles) {
    Triangle_budget budget(max_triangles);
    for (std::size_t i = 0; i < patches_.size(); ++i) budget.add(2.0 * cells_[i].u * cells_[i].v, numbers_[i]);
    std::size_t points = corners_.size();
    for (const Patch_cells& cells : cells_) points += static_cast<std::size_t>(cells.u - 1) * (cells.v - 1);
    for (const Edge_uses& uses : topology_.edges()) {
      const std::size_t n = cells_along(uses);
      points += n - 1;
      for (const Edge_use& use : uses) budget.add(static_cast<double>(n - number_of_cells(use)), numbers_[use.patch]);
    }
    mesh_.points.reserve(points);
    mesh_.places.reserve(points);
    mesh_.triangles.reserve(budget.triangles());
    mesh_.patches.reserve(budget.triangles());
    edges_.reserve(topology_.edges().size());
  }

  std::size_t number_of_cells(const Edge_use& use) const {
    return static_cast<std::size_t>(runs_along_u(use.edge) ? cells_[use.patch].u : cells_[use.patch].v);
  }

  // Turns the triangles of each closed part of the model so that its volume is positive: the sum of
  // (ax + bx + cx - 3 ox) / 6 times the area of the projection to x = 0, over the triangles abc.
  void turn_outwards() {
    constexpr std::size_t open = Model_topology<Patch>::open;
    const std::vector<std::size_t> parts = topology_.closed_parts();
    if (std::all_of(parts.begin(), parts.end(), [](std::size_t part) { return part == open; })) return;
    std::vector<std::array<double, 3>> x;
    x.reserve(mesh_.points.size());
    for (const typename Traits::Point& p : mesh_.points) {
      const Coordinates<Traits> c = Geometric_continuity::coordinates<Traits>(p);
      x.push_back({rounded_number(c[0]), rounded_number(c[1]), rounded_number(c[2])});
    }
    std::vector<double> volume(parts.size(), 0), size(parts.size(), 0);
    const auto first = [&](std::size_t patch) { return patch == 0 ? 0 : ends_[patch - 1]; };
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i] == open) continue;
      // equivalent [3 -> 4, 1]: the volume of what is closed does not depend on the origin
      const double origin = first(i) < ends_[i] ? 3 * x[mesh_.triangles[first(parts[i])][0]][0] : 0;
      double sum = 0, sum_of_sizes = 0;
      for (std::size_t t = first(i); t < ends_[i]; ++t) {
        const auto& triangle = mesh_.triangles[t];
        const std::array<double, 3>&a = x[triangle[0]], &b = x[triangle[1]], &c = x[triangle[2]];
        const double area = (b[1] - a[1]) * (c[2] - a[2]) - (c[1] - a[1]) * (b[2] - a[2]),
                     part = (a[0] + b[0] + c[0] - origin) * area;
        sum += part;
        sum_of_sizes += std::abs(part);
      }
      volume[parts[i]] += sum;
      size[parts[i]] += sum_of_sizes;
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i] != open && volume[parts[i]] < -1e-9 * size[parts[i]]) // not by rounding
        for (std::size_t t = first(i); t < ends_[i]; ++t) std::swap(mesh_.triangles[t][1], mesh_.triangles[t][2]);
  }

  // Returns as many cells as the patch with the most cells needs.
  std::size_t cells_along(const Edge_uses& uses) const {
    std::size_t n = 1;
    for (const Edge_use& use : uses) n = (std::max)(n, number_of_cells(use));
    return n;
  }

  std::size_t add_point(std::size_t patch, typename Traits::Point point, const FT& u, const FT& v) {
    mesh_.points.push_back(std::move(point));
    mesh_.places.push_back({numbers_[patch], u, v});
    return mesh_.points.size() - 1;
  }

  // The point at a corner.
  std::size_t corner(std::size_t number) {
    const std::size_t patch = number / 4;
    const bool u = number % 4 >= 2, v = number % 2 == 1;
    std::size_t& point = corners_[topology_.corner(patch, u, v)];
    const Patch& s = *patches_[patch];
    if (point == none)
      point = add_point(patch, corner_point(s, u, v), u ? s.domain_u().second : s.domain_u().first,
                        v ? s.domain_v().second : s.domain_v().first);
    return point;
  }

  // The points of an edge are computed once, from its first use.
  void add_edge(const Edge_uses& uses) {
    const std::size_t n = cells_along(uses), i = uses[0].patch;
    const Patch_edge edge = uses[0].edge;
    const std::pair<std::size_t, std::size_t> ends = corners_of(i, edge);
    const std::size_t first = corner(ends.first), inner = mesh_.points.size();
    if (n > 1) add_inner_points(i, edge, n);
    const std::size_t last = corner(ends.second);
    for (const Edge_use& use : uses)
      sides_[use.patch][static_cast<std::size_t>(use.edge)] = {edges_.size(), use.backwards};
    edges_.push_back({first, inner, last, n});
  }

  void add_inner_points(std::size_t i, Patch_edge edge, std::size_t n) {
    const Patch& s = *patches_[i];
    std::vector<decltype(summand(s, edge, 0))> net;
    for (int k = 0; k <= s.degree_along(edge); ++k) net.push_back(summand(s, edge, k));
    Point_sums<Patch> sums(s, net);
    const auto weights = sums.weights(s.degree_along(edge), n);
    const FT u0 = at_upper_end(edge) ? s.domain_u().second : s.domain_u().first,
             v0 = at_upper_end(edge) ? s.domain_v().second : s.domain_v().first;
    for (std::size_t k = 1; k < n; ++k) {
      const FT t = fraction_of(s.domain(edge), k, n);
      const bool along_u = runs_along_u(edge);
      sums.charge(static_cast<double>(weights[k].size()));
      add_point(i, sums.point(weighted_sum(weights[k], sums.net())), along_u ? t : u0, along_u ? v0 : t);
    }
  }

  // The points along an edge of a patch, in the direction of the parameter.
  void points_of(std::size_t patch, Patch_edge patch_edge, std::vector<std::size_t>& points) {
    const Side& side = sides_[patch][static_cast<std::size_t>(patch_edge)];
    points.clear();
    if (side.edge == none) {
      points.push_back(corner(corners_of(patch, patch_edge).first));
      return;
    }
    const Edge& edge = edges_[side.edge];
    points.push_back(edge.first);
    for (std::size_t k = 0; k + 1 < edge.cells; ++k) points.push_back(edge.inner + k);
    points.push_back(edge.last);
    if (side.backwards) std::reverse(points.begin(), points.end());
  }
};

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_MODEL_MESH_H
