// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_LADDER_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_LADDER_H

#include <CGAL/Geometric_continuity/edges/internal/Edge_equations.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_input.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_on_grid.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_grid.h>

#include <algorithm>
#include <cmath>
#include <optional>

/// \file Edge_ladder.h
/// The rungs by which the order along an edge is found on the control points next to it (Edge_input.h), from the cheapest to the one that
/// is left: control points are compared, rounded numbers refute at the ends, integers of fixed length decide, with a short ratio of the
/// tangent planes or without. What they leave open, and why an edge is not smooth, is decided in numbers of any length (Edge_decision.h).

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

// Which stages are taken, and who is told of the decision. By default all are, and nobody is.
struct All_edge_stages {
  static constexpr bool uses(Edge_stage) { return true; }
  void decided(Edge_stage, bool) const {}
};

// Whether the lower orders are told apart when an edge has not the highest one that is asked for.
enum class Lower_orders { as_one, told_apart };

// The ladder for two patches along whole edges that are the same curve in one direction.
class Edge_ladder {
  const Edge_layers &a_, &b_;
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  Grid_layers x_, y_;
  std::optional<Edge_on_grid> on_grid_;
  bool tried_ = false;
#endif

public:
  // \pre the edges are the same, in one direction
  Edge_ladder(const Edge_layers& a, const Edge_layers& b) : a_(a), b_(b) {}
  Edge_ladder(const Edge_ladder&) = delete;

  int degree() const { return a_.along; }
  bool is_collapsed() const { return internal::is_collapsed(a_); }

  // The order, up to the highest one that is asked for; as_one: or a higher one that is less than that. Empty if numbers of fixed length
  // do not find it.
  template <int highest, class Stages> std::optional<int> order(Lower_orders lower, Stages& stages) {
    static_assert(1 <= highest && highest <= 2);
    const auto decided = [&](Edge_stage stage, int found) {
      stages.decided(stage, found == highest);
      return std::optional<int>(found);
    };
    if (is_collapsed()) return stages.uses(Edge_stage::comparison) ? decided(Edge_stage::comparison, 0) : std::nullopt;
    int most = highest;
    if (stages.uses(Edge_stage::floating_point)) {
      most = not_refuted<highest>(lower);
      if (most == 0 || (most < highest && lower == Lower_orders::as_one))
        return decided(Edge_stage::floating_point, most);
    }
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
    const Edge_on_grid* const edge = on_grid();
    if (!edge) return std::nullopt;
    if (stages.uses(Edge_stage::simple_ratio))
      if (const std::optional<int> found = edge->order_by_ratio(most)) return decided(Edge_stage::simple_ratio, *found);
    if (stages.uses(Edge_stage::fixed_integer))
      if (const std::optional<int> found = edge->order(most)) return decided(Edge_stage::fixed_integer, *found);
#endif
    return std::nullopt;
  }

  // The order 1 or 2, if numbers of fixed length prove it. Otherwise the edge may be anything.
  std::optional<int> smooth_order() {
    const All_edge_stages stages;
    const std::optional<int> found = order<2>(Lower_orders::told_apart, stages);
    return found.value_or(0) > 0 ? found : std::nullopt;
  }

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  // In integers of fixed length; nothing unless all coordinates lie on one grid.
  const Edge_on_grid* on_grid() {
    if (!tried_) {
      tried_ = true;
      const double size = (std::max)(size_of(a_), size_of(b_));
      if (!std::isfinite(size)) return nullptr;
      Grid grid(size);
      if (!grid.valid()) return nullptr;
      convert(a_, grid, x_);
      convert(b_, grid, y_);
      if (grid.valid()) on_grid_.emplace(x_, y_);
    }
    return on_grid_ ? &*on_grid_ : nullptr;
  }
#endif

private:
  // The highest order that rounded numbers do not refute at the ends.
  template <int highest> int not_refuted(Lower_orders lower) const {
    int most = highest;
    for (const bool at_end : {false, true}) {
      const Rounded_edge_end end(a_, b_, at_end);
      if (!end.in_range()) continue;
      if (end.tangent_planes_differ()) return 0;
      if (highest > 1 && most > 1 && end.curvatures_differ()) most = 1;
      if (most < highest && lower == Lower_orders::as_one) break;
    }
    return most;
  }
};

// Whether two patches have the order G^k along whole edges that are the same curve in one direction; or empty
// if numbers of fixed length do not decide it.
template <int order, class Stages>
std::optional<bool> decide_on_same_edge(const Edge_layers& a, const Edge_layers& b, Stages& stages) {
  if constexpr (order == 0) { // infinite coordinates are refused elsewhere
    if (!std::isfinite((std::max)(size_of(a), size_of(b))) || !stages.uses(Edge_stage::comparison)) return std::nullopt;
    stages.decided(Edge_stage::comparison, true);
    return true;
  } else {
    const std::optional<int> found = Edge_ladder(a, b).template order<order>(Lower_orders::as_one, stages);
    return found ? std::optional<bool>(*found == order) : std::nullopt;
  }
}

// The same on whole edges that may differ, or run in opposite directions; then the second is turned.
template <int order, class Stages>
CGAL_GC_FORCEINLINE std::optional<bool> decide_on_layers(const Edge_layers& a, Edge_layers& b, Stages& stages) {
  if (a.along != b.along) return std::nullopt;
  const std::optional<Edge_direction> direction = common_direction(a, b);
  if (!direction) {
    if (!stages.uses(Edge_stage::comparison)) return std::nullopt;
    stages.decided(Edge_stage::comparison, false);
    return false;
  }
  if (*direction == Edge_direction::opposite) b.reverse();
  return decide_on_same_edge<order>(a, b, stages);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_LADDER_H
