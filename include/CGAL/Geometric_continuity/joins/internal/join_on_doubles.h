// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_ON_DOUBLES_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_ON_DOUBLES_H

#include <CGAL/Geometric_continuity/joins/internal/join_grid_legs.h>
#include <CGAL/Geometric_continuity/joins/internal/join_modulo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The lengths of two domains, if both have small whole numbers as ends.
inline bool whole_lengths(const std::pair<double, double>& left, const std::pair<double, double>& right, int& h,
                          int& l) {
  for (const double x : {left.first, left.second, right.first, right.second})
    if (!(std::abs(x) <= 0x1p20) || x != static_cast<int>(x)) return false;
  h = static_cast<int>(left.second - left.first);
  l = static_cast<int>(right.second - right.first);
  return h <= 1024 && l <= 1024;
}

// The end of a curve with double coordinates, or its start, as given. `Points` is something with degree(), domain() and
// coordinate(j, i).
template <int k, int N, class Points> BOOST_FORCEINLINE End_points<double, N> points_of(const Points& end) {
  const int m = end.degree();
  const auto point = [&](int j) -> std::array<double, N> {
    if constexpr (N == 2)
      return {end.coordinate(j, 0), end.coordinate(j, 1)};
    else
      return {end.coordinate(j, 0), end.coordinate(j, 1), end.coordinate(j, 2)};
  };
  if constexpr (k == 0)
    return {point(0)};
  else if constexpr (k == 1)
    return {point(0), point(std::min(m, 1))};
  else if constexpr (k == 2)
    return {point(0), point(std::min(m, 1)), point(std::min(m, 2))};
  else
    return {point(0), point(std::min(m, 1)), point(std::min(m, 2)), point(std::min(m, 3))};
}

// The decision on two ends with double coordinates, exact or `unknown`.
template <Join_question question, int N, class Left, class Right, class Stages>
Join_answer decide_on_doubles(const Left& left, const Right& right, Stages& stages) {
  constexpr int k = highest_difference(question);
  const auto decided = [&](Join_stage stage, Join_answer answer) {
    stages.decided(stage, answer);
    return answer;
  };
  const End_points<double, N> p = points_of<k, N>(left), q = points_of<k, N>(right);
  if constexpr (is_parametric(question) || is_geometric(question))
    if (p[0] != q[0]) return decided(Join_stage::comparison, Join_answer::no);
  if constexpr (k == 0)
    return decided(Join_stage::comparison, Join_answer::yes);
  else {
    const int m = left.degree(), n = right.degree();
    if (std::max(m, n) > 1000) return Join_answer::unknown;
    const Differences<double, N> legs_a = legs_of<k>(p), legs_b = legs_of<k>(q);
    const int pivot = is_parametric(question) ? 0 : largest_coordinate(legs_a[0]);
    if constexpr (!is_parametric(question)) {
      // the signs of rounded differences are exact
      const double x = coordinate_at(legs_a[0], pivot), y = coordinate_at(legs_b[0], pivot);
      if constexpr (is_geometric(question)) {
        if (!((x < 0 && 0 < y) || (0 < x && y < 0))) return decided(Join_stage::comparison, Join_answer::no);
      } else if (x == 0 || largest(legs_b[0]) == 0)
        return decided(Join_stage::comparison, Join_answer::undefined);
    }

    Join_weights_of<question, std::int64_t> w;
    if constexpr (is_parametric(question)) {
      int h, l;
      if (!whole_lengths(left.domain(), right.domain(), h, l)) return Join_answer::unknown;
      w = Parametric_join_weights<std::int64_t>::of(m, n, h, l);
      if (!weights_fit<k>(w)) return Join_answer::unknown;
    } else
      w = Join_weights<std::int64_t>::template geometric<question>(m, n);

    if (stages.uses(Join_stage::floating_point)) {
      typedef Join_weights_of<question, double> Weights;
      typedef Join_filter<Weights> Filter;
      const Difference_bounds A = bounds_of_differences<k>(legs_a), B = bounds_of_differences<k>(legs_b);
      const Weights weights = converted<double>(w);
      const Filter filter{A, B, weights};
      if (filter.in_range()) {
        const Differences<double, N> a = differences_of<k, true>(legs_a, m), b = differences_of<k, false>(legs_b, n);
        const Join_equations<double, N, Weights, const Filter> equations(a, b, weights, filter, pivot);
        if (!all_hold<question>(equations)) return decided(Join_stage::floating_point, Join_answer::no);
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
        if (stages.uses(Join_stage::bounded_residue)) {
          const Join_answer answer = decide_modulo<question, N>(p, q, a, b, pivot, w, filter, stages);
          if (answer != Join_answer::unknown) return answer;
        }
#endif
      }
    }
    if (!stages.uses(Join_stage::fixed_integer)) return Join_answer::unknown;
    return decide_on_grid_legs<question, N>(grid_legs_of<k>(points_of<k, N>(left)), m,
                                            grid_legs_of<k>(points_of<k, N>(right)), n, pivot, w, stages);
  }
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_ON_DOUBLES_H
