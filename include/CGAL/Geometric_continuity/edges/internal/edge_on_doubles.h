// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_ON_DOUBLES_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_ON_DOUBLES_H

#include <CGAL/Geometric_continuity/edges/internal/edge_filter.h>
#include <CGAL/Geometric_continuity/edges/internal/edge_on_grid.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Where a decision on an edge was made.
enum class Edge_stage {
  comparison,     // equality of the control points as given
  floating_point, // a condition is farther from zero than its rounding error
  simple_ratio,   // integers of fixed length, where the tangent planes agree by short numbers
  fixed_integer,  // integers of fixed length
  multiprecision
};

// Which stages are taken, and what hears of the decision: the default uses all and does not listen.
struct All_edge_stages {
  static constexpr bool uses(Edge_stage) { return true; }
  void decided(Edge_stage, bool) const {}
};

// Whether two patches have the order G^k along the whole edges whose layers are given, or empty if numbers of fixed length
// do not decide it. Edges of one degree are the same if and only if their control points are, in one of both directions.
template <int order, class Stages>
std::optional<bool> decide_on_doubles(const Edge_layers& a, Edge_layers& b, Stages& stages) {
  const auto decided = [&](Edge_stage stage, bool answer) {
    stages.decided(stage, answer);
    return std::optional<bool>(answer);
  };
  if (a.along != b.along) return std::nullopt;
  const bool forwards = same_edge(a, b);
  if ((!forwards && !same_edge_reversed(a, b)) || (order > 0 && is_collapsed(a))) {
    if (!stages.uses(Edge_stage::comparison)) return std::nullopt;
    return decided(Edge_stage::comparison, false);
  }
  if (!forwards) b.reverse();
  if constexpr (order > 0)
    if (stages.uses(Edge_stage::floating_point) && Edge_filter(a, b).refutes<order>())
      return decided(Edge_stage::floating_point, false);
  const double size = std::max(size_of(a), size_of(b));
  if (!std::isfinite(size)) return std::nullopt;
  if constexpr (order == 0) {
    if (!stages.uses(Edge_stage::comparison)) return std::nullopt;
    return decided(Edge_stage::comparison, true);
  } else {
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
    Grid grid(size);
    if (!grid.valid()) return std::nullopt;
    const Grid_layers x = on_grid(a, grid), y = on_grid(b, grid);
    if (!grid.valid()) return std::nullopt;
    const Edge_on_grid edge(x, y);
    if (stages.uses(Edge_stage::simple_ratio))
      if (const std::optional<bool> answer = edge.template decide_by_ratio<order>())
        return decided(Edge_stage::simple_ratio, *answer);
    if (stages.uses(Edge_stage::fixed_integer))
      if (const std::optional<bool> answer = edge.template decide<order>())
        return decided(Edge_stage::fixed_integer, *answer);
#endif
  }
  return std::nullopt;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_ON_DOUBLES_H
