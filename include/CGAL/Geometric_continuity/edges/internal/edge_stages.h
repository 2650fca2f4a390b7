// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_STAGES_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_STAGES_H

#include <CGAL/Geometric_continuity/edges/internal/Edge_on_grid.h>
#include <CGAL/Geometric_continuity/edges/internal/edge_layers.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/local/coordinates.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>

/// \file edge_stages.h
/// The stages of a decision on an edge in numbers of fixed length, in their order: control points are compared,
/// floating-point numbers refute at the ends, and integers decide, with a short ratio of the tangent planes or without. What
/// they leave open, and why an edge is not smooth, is decided in multi-precision: see Edge_decision.h.

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

// Whether two patches have the order G^k along whole edges that are the same curve in one direction; or empty
// if numbers of fixed length do not decide it.
template <int order, class Stages>
std::optional<bool> decide_on_same_edge(const Edge_layers& a, const Edge_layers& b, Stages& stages) {
  const auto decided = [&](Edge_stage stage, bool answer) {
    stages.decided(stage, answer);
    return std::optional<bool>(answer);
  };
  if constexpr (order > 0) {
    if (is_collapsed(a)) {
      if (!stages.uses(Edge_stage::comparison)) return std::nullopt;
      return decided(Edge_stage::comparison, false);
    }
    if (stages.uses(Edge_stage::floating_point) && Edge_filter(a, b).template refutes<order>())
      return decided(Edge_stage::floating_point, false);
  }
  const double size = (std::max)(size_of(a), size_of(b));
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

// The decision on whole edges that may differ, or run in opposite directions; then the second is turned.
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

// The order 1 or 2 along two edges that are the same curve in one direction, if numbers of fixed length prove
// it. Otherwise the edge may be anything.
inline std::optional<int> smooth_order(const Edge_layers& a, const Edge_layers& b) {
  const All_edge_stages stages;
  const std::optional<bool> second = decide_on_same_edge<2>(a, b, stages);
  if (!second) return std::nullopt;
  if (*second) return 2;
  return decide_on_same_edge<1>(a, b, stages).value_or(false) ? std::optional<int>(1) : std::nullopt;
}

// ---------------------------------------------------------------- layers

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

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_STAGES_H
