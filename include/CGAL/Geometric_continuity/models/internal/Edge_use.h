// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_USE_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_USE_H

#include <CGAL/Geometric_continuity/surfaces/Patch_edge.h>

#include <cstddef>
#include <utility>

/// \file Edge_use.h
/// The edges of a model as edges of its patches.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// An edge of a patch as one use of an edge of the model.
struct Edge_use {
  std::size_t patch;
  Patch_edge edge;
  bool backwards; // against the direction of the first use

  friend bool operator<(const Edge_use& a, const Edge_use& b) {
    return std::make_pair(a.patch, a.edge) < std::make_pair(b.patch, b.edge);
  }
};

// The uses of one edge.
class Edge_uses {
  const Edge_use *first_, *last_;

public:
  Edge_uses(const Edge_use* first, const Edge_use* last) : first_(first), last_(last) {}

  const Edge_use* begin() const { return first_; }
  const Edge_use* end() const { return last_; }
  std::size_t size() const { return static_cast<std::size_t>(last_ - first_); }
  const Edge_use& operator[](std::size_t i) const { return first_[i]; }
};

// The numbers of the two corners where an edge begins and ends; a corner has the number 4 * patch + 2 * (at the end of u) +
// (at the end of v).
inline std::pair<std::size_t, std::size_t> corners_of(std::size_t patch, Patch_edge edge) {
  const std::size_t side = at_upper_end(edge), first = 4 * patch;
  return runs_along_u(edge) ? std::make_pair(first + side, first + 2 + side)
                            : std::make_pair(first + 2 * side, first + 2 * side + 1);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_USE_H
