// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_LAYERS_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_LAYERS_H

#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The layers of the control net of a Bezier patch next to an edge: p[j][i] is the control point number i along the edge in
// the layer number j, of which there are min(k, across) + 1 for the order k.
template <class T> struct Edge_points {
  static constexpr int most_along = 7, most_across = 8; // the degrees that are decided in numbers of fixed length

  int along, across, layers;
  std::array<T, 3> p[3][most_along + 1];

  // Whether numbers of fixed length decide edges of these degrees.
  static bool fits(int degree_along, int degree_across) {
    return degree_along <= most_along && 1 <= degree_across && degree_across <= most_across;
  }

  void reverse() {
    for (int j = 0; j < layers; ++j) std::reverse(p[j], p[j] + along + 1);
  }
};

typedef Edge_points<double> Edge_layers;
typedef Edge_points<std::int64_t> Grid_layers;

// Edges of equal degree are the same if and only if their control points are, see also Edge_sides::align().
inline bool same_edge(const Edge_layers& a, const Edge_layers& b) {
  return std::equal(a.p[0], a.p[0] + a.along + 1, b.p[0]);
}
inline bool same_edge_reversed(const Edge_layers& a, const Edge_layers& b) {
  return std::equal(a.p[0], a.p[0] + a.along + 1,
                    std::reverse_iterator<const std::array<double, 3>*>(b.p[0] + b.along + 1));
}
inline std::optional<Edge_direction> common_direction(const Edge_layers& a, const Edge_layers& b) {
  if (a.along != b.along) return std::nullopt;
  if (same_edge(a, b)) return Edge_direction::same;
  return same_edge_reversed(a, b) ? std::optional<Edge_direction>(Edge_direction::opposite) : std::nullopt;
}
inline bool is_collapsed(const Edge_layers& a) {
  return std::all_of(a.p[0], a.p[0] + a.along + 1, [&](const std::array<double, 3>& x) { return x == a.p[0][0]; });
}

// Infinity if a coordinate is infinite or not a number, or a bound of all coordinates.
inline double size_of(const Edge_layers& a) {
  double size[3] = {0, 0, 0}, test[3] = {0, 0, 0}; // 0, or not a number
  for (int j = 0; j < a.layers; ++j)
    for (int i = 0; i <= a.along; ++i)
      for (int x = 0; x < 3; ++x) {
        size[x] = (std::max)(size[x], std::abs(a.p[j][i][x]));
        test[x] += a.p[j][i][x] - a.p[j][i][x];
      }
  if (test[0] + test[1] + test[2] != 0) return std::numeric_limits<double>::infinity();
  return (std::max)({size[0], size[1], size[2]});
}

// In units of the grid; it is invalid afterwards unless all coordinates lie on it.
inline Grid_layers on_grid(const Edge_layers& a, Grid& grid) {
  Grid_layers g;
  g.along = a.along;
  g.across = a.across;
  g.layers = a.layers;
  for (int j = 0; j < a.layers; ++j)
    for (int i = 0; i <= a.along; ++i) g.p[j][i] = grid(a.p[j][i]);
  return g;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_LAYERS_H
