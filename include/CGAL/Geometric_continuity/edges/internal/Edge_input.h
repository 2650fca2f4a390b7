// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_INPUT_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_INPUT_H

#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/local/coordinates.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

/// \file Edge_input.h
/// What the rungs of Edge_ladder.h are asked about: the control points next to an edge of each of two patches, or of rows, in numbers of
/// fixed length; and those of B-spline surfaces over inner knots, for all spans at once.

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
inline void convert(const Edge_layers& a, Grid& grid, Grid_layers& g) {
  g.along = a.along;
  g.across = a.across;
  g.layers = a.layers;
  for (int j = 0; j < a.layers; ++j)
    for (int i = 0; i <= a.along; ++i) g.p[j][i] = grid(a.p[j][i]);
}

// Whether the control points of a surface are those of one Bezier patch.
template <class Traits> bool is_one_patch(const Bezier_patch<Traits>&) { return true; }
template <class Traits> bool is_one_patch(const Bspline_surface<Traits>& s) {
  const auto one_span = [](const auto& knots) {
    return knots.number_of_coefficients() == knots.degree() + 1 && knots.is_clamped();
  };
  return one_span(s.knots_u()) && one_span(s.knots_v());
}

// Calls f(x, p) for all coordinates x of the control points that count for an order, and their places p: the point number i
// along the edge in each layer j. Returns whether the degrees are among those that are decided in numbers of fixed length.
// Most edges that are not smooth are refused soon after this: it is written out where it is called.
template <class Field, class Surface, class Function>
CGAL_GC_FORCEINLINE bool for_each_layer(const Surface& s, Patch_edge edge, int order, Edge_layers& layers, Function f) {
  const bool along_u = runs_along_u(edge);
  const int along = along_u ? s.degree_u() : s.degree_v(), across = along_u ? s.degree_v() : s.degree_u();
  layers.along = along;
  layers.across = across;
  layers.layers = (std::min)(order, across) + 1;
  if (!is_one_patch(s) || !Edge_layers::fits(along, across)) return false;
  const int first = at_upper_end(edge) ? across : 0, step = at_upper_end(edge) ? -1 : 1;
  for (int j = 0; j <= (std::min)(order, across); ++j)
    for (int i = 0; i <= along; ++i) {
      const int inward = first + step * j;
      const Coordinate_vector<Field, Surface::N> x = coordinates<typename Surface::Traits, Field>(
          along_u ? s.control_point(i, inward) : s.control_point(inward, i));
      for (int k = 0; k < 3; ++k) f(x[k], layers.p[j][i][k]);
    }
  return true;
}

// The layers x and y of both edges that count for an order: the control points as given if they are doubles; if they are
// rational numbers, multiplied by their common denominator. Returns whether numbers of fixed length may decide: for low
// degrees, and short numerators.
template <class Surface_a, class Surface_b>
bool edge_layers(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b, int order,
                 Edge_layers& x, Edge_layers& y) {
  typedef Edge_field<typename Surface_a::Traits> Field;
  typedef typename Surface_a::Traits::FT FT;
  if constexpr (std::is_same_v<FT, double>) {
    const auto copy = [](double number, double& place) { place = number; };
    return for_each_layer<FT>(a, edge_a, order, x, copy) && for_each_layer<FT>(b, edge_b, order, y, copy);
  } else if constexpr (Common_denominator<Field>::clears) {
    Common_denominator<Field> denominator;
    const auto include = [&](const Field& number, double&) { denominator.include(number); };
    if (!for_each_layer<Field>(a, edge_a, order, x, include) || !for_each_layer<Field>(b, edge_b, order, y, include))
      return false;
    bool all_short = true;
    const auto scale = [&](const Field& number, double& place) {
      place = CGAL::to_double(denominator.numerator(number));
      all_short = all_short && std::abs(place) < 0x1p53; // then it is exact
    };
    for_each_layer<Field>(a, edge_a, order, x, scale);
    for_each_layer<Field>(b, edge_b, order, y, scale);
    return all_short;
  } else
    return false;
}

// From rows of one degree. The surfaces C + T v + W v^2/2 have the same order along the edge; their control points are C,
// C + T/2 and C + T + W/2, here times two and the common denominator. Returns whether numbers of fixed length may decide.
template <class Field>
bool edge_layers(const Edge_rows<Field>& a, const Edge_rows<Field>& b, Edge_layers& x, Edge_layers& y) {
  if constexpr (Common_denominator<Field>::clears) {
    const std::size_t n = a.edge.size();
    for (const auto* row : {&a.edge, &a.cross, &a.second_cross, &b.edge, &b.cross, &b.second_cross})
      if (row->size() != n) return false;
    if (!Edge_layers::fits(static_cast<int>(n) - 1, 2)) return false;
    Common_denominator<Field> denominator;
    for (const auto* row : {&a.edge, &a.cross, &a.second_cross, &b.cross, &b.second_cross})
      for (const Coordinate_vector<Field, 3>& v : *row)
        for (const Field& number : v) denominator.include(number);
    bool all_short = true;
    const auto scaled = [&](const Field& number) {
      const double result = CGAL::to_double(denominator.numerator(number));
      all_short = all_short && std::abs(result) <= 0x1p50; // then it is exact, and so are the sums
      return result;
    };
    const auto take = [&](const Edge_rows<Field>& rows, Edge_layers& s) {
      s.along = static_cast<int>(n) - 1;
      s.across = 2;
      s.layers = 3;
      for (std::size_t i = 0; i < n && all_short; ++i)
        for (int k = 0; k < 3; ++k) {
          const double c = 2 * scaled(a.edge[i][k]), t = scaled(rows.cross[i][k]), w = scaled(rows.second_cross[i][k]);
          s.p[0][i][k] = c;
          s.p[1][i][k] = c + t;
          s.p[2][i][k] = c + 2 * t + w;
        }
    };
    take(a, x);
    take(b, y);
    return all_short;
  } else
    return false;
}

// The control points next to an edge over clamped knots, and the knots across it. With the distances h1 and h2 of the first two
// that follow the edge, from there on, and the legs a = P1 - P0 and c = P2 - P1, the rows of the derivatives across are
//   T = q a/h1,  W = q (q-1)/h1 (c/h2 - a/h1),
// coefficient by coefficient, over the knots along the edge.
template <class Field> struct Spline_side {
  typedef std::array<std::int64_t, 3> Point;

  int q;
  Field h1, h2;
  std::vector<Field> knots; // along the edge
  std::vector<std::array<double, 3>> given[3];
  std::vector<Point> p[3];

  // Whether the surface has such an edge, of a degree of at least 2 across it.
  template <class Traits> bool take(const Bspline_surface<Traits>& s, Patch_edge edge) {
    const Knot_vector<double>&along = s.knots_along(edge), &across = s.knots_across(edge);
    q = across.degree();
    if (q < 2 || along.degree() < 1 || !along.is_clamped() || !across.is_clamped()) return false;
    const int last = across.size() - 1, m = across.number_of_coefficients();
    const bool upper = at_upper_end(edge);
    const auto knot = [&](int i) { return Field(upper ? -across[last - i] : across[i]); };
    h1 = Field(knot(q + 1) - knot(q));
    h2 = Field(knot(q + 2) - knot(q));
    for (double u : along) knots.emplace_back(u);
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < along.number_of_coefficients(); ++i) {
        const int side = upper ? m - 1 - j : j;
        const Coordinates<Traits> x =
            coordinates<Traits>(runs_along_u(edge) ? s.control_point(i, side) : s.control_point(side, i));
        given[j].push_back({x[0], x[1], x[2]});
      }
    return true;
  }

  void reverse() {
    std::reverse(knots.begin(), knots.end());
    for (Field& u : knots) u = Field(-u);
    for (auto& row : given) std::reverse(row.begin(), row.end());
  }

  static Point difference(const Point& x, const Point& y) { return {x[0] - y[0], x[1] - y[1], x[2] - y[2]}; }
  std::size_t size() const { return p[0].size(); }
  Point a(std::size_t i) const { return difference(p[1][i], p[0][i]); }
  Point c(std::size_t i) const { return difference(p[2][i], p[1][i]); }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_INPUT_H
