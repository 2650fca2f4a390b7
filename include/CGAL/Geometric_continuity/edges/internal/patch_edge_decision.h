// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_PATCH_EDGE_DECISION_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_PATCH_EDGE_DECISION_H

#include <CGAL/Geometric_continuity/edges/internal/edge_on_doubles.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>

#include <algorithm>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The layers next to an edge that count for an order. \pre `fits_edge_layers()`
template <class Traits> Edge_layers edge_layers(const Bezier_patch<Traits>& patch, Patch_edge edge, int order) {
  Edge_layers s;
  s.along = patch.degree_along(edge);
  s.across = patch.degree_across(edge);
  s.layers = std::min(order, s.across) + 1;
  for (int j = 0; j < s.layers; ++j)
    for (int i = 0; i <= s.along; ++i) {
      const Coordinates<Traits> x = Geometric_continuity::coordinates<Traits>(patch.control_point(edge, i, j));
      s.p[j][i] = {x[0], x[1], x[2]};
    }
  return s;
}

template <class Traits> bool fits_edge_layers(const Bezier_patch<Traits>& patch, Patch_edge edge) {
  return patch.degree_along(edge) <= Edge_layers::most_along && 1 <= patch.degree_across(edge) &&
         patch.degree_across(edge) <= Edge_layers::most_across;
}

// Whether two patches in space have an order along their whole edges; empty if numbers of fixed length do not decide it.
template <int order, class Traits, class Stages>
std::optional<bool> decide_on_patches(const Bezier_patch<Traits>& a, Patch_edge edge_a, const Bezier_patch<Traits>& b,
                                      Patch_edge edge_b, Stages& stages) {
  if constexpr (std::is_same_v<typename Traits::FT, double>)
    if (fits_edge_layers(a, edge_a) && fits_edge_layers(b, edge_b)) {
      const Edge_layers x = edge_layers(a, edge_a, order);
      Edge_layers y = edge_layers(b, edge_b, order);
      return decide_on_doubles<order>(x, y, stages);
    }
  return std::nullopt;
}

// The order 1 or 2 and whether the second edge runs backwards, if numbers of fixed length prove that.
struct Smooth_edge {
  int order;
  bool reversed;
};
template <class Traits>
std::optional<Smooth_edge> smooth_edge(const Bezier_patch<Traits>& a, Patch_edge edge_a, const Bezier_patch<Traits>& b,
                                       Patch_edge edge_b) {
  if constexpr (std::is_same_v<typename Traits::FT, double>) {
    const All_edge_stages stages;
    const std::optional<bool> second = decide_on_patches<2>(a, edge_a, b, edge_b, stages);
    if (!second || (!*second && !decide_on_patches<1>(a, edge_a, b, edge_b, stages).value_or(false)))
      return std::nullopt;
    return Smooth_edge{*second ? 2 : 1, !same_edge(edge_layers(a, edge_a, 0), edge_layers(b, edge_b, 0))};
  } else
    return std::nullopt;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_PATCH_EDGE_DECISION_H
