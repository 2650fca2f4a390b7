// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_MODEL_TOPOLOGY_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_MODEL_TOPOLOGY_H

#include <CGAL/Geometric_continuity/models/internal/Edge_groups.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

/// \file Model_topology.h
/// Which edges and corners of the patches of a model are the same.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The edges and corners of the patches of a model, those that are the same under one number. Edges are the same as in
// `model_continuity()`. Corners are the same where they are ends of the same edge, or of a collapsed edge; corners that
// merely have the same coordinates are not.
template <class Patch> class Model_topology {
  typedef std::pair<std::size_t, std::size_t> Pair;

  Edge_groups<Patch> groups_;
  std::vector<std::size_t> parent_; // of the corner 4 * patch + 2 * (at the end of u) + (at the end of v)
  std::vector<bool> simple_;        // by patch

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
    pairs.reserve(groups_.edges().size() + 2 * patches.size());
    for (const Edge_uses& uses : groups_.edges()) pairs.push_back(vertices(ends(uses[0])));
    for (std::size_t i = 0; i < patches.size(); ++i)
      for (const Pair& diagonal : diagonals(i)) pairs.push_back(diagonal);
    std::sort(pairs.begin(), pairs.end());
    for (std::size_t i = 0; i < patches.size(); ++i) simple_[i] = is_simple(i, pairs);
  }

  // By the first use, which is that of the patch with the least number.
  const std::vector<Edge_uses>& edges() const { return groups_.edges(); }

  // The number, below four times the number of patches, of what may be the corner of several patches.
  std::size_t corner(std::size_t patch, bool end_of_u, bool end_of_v) const {
    return parent_[4 * patch + 2 * end_of_u + end_of_v];
  }

  // Whether the four corners of the patch are different and no two of them are also two corners of another patch, unless
  // by the edge between them. Then lines from edge to edge through the patch have no double elsewhere.
  bool simple(std::size_t patch) const { return simple_[patch]; }

private:
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

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_MODEL_TOPOLOGY_H
