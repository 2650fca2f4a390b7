// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CHAIN_DIRECTION_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CHAIN_DIRECTION_H

#include "formats/svg/svg_drawing.h"

#include <CGAL/Exact_rational.h>

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

// Where the curves of a chain start and end.
typedef std::array<Drawing_traits::Point, 2> Curve_ends;

// The curves of a chain to be reversed.
struct Chain_reversal {
  std::vector<bool> curves;
  std::size_t gaps_before, gaps_after;
};

// Finds the fewest curves that must be reversed so that as few gaps as possible are left, which are
// wider than `gap`. Of equal choices the first curves stay as they are.
//
// The least costs of the curves from `i` on, where `i` is reversed or not, follow from those of
// `i + 1`, one after the other from the end on.
inline Chain_reversal find_reversal(const std::vector<Curve_ends>& curves, bool closed,
                                    const CGAL::Exact_rational& gap) {
  typedef std::tuple<std::size_t, std::size_t> Cost; // gaps, reversed curves
  const std::size_t n = curves.size();
  const auto is_gap = [&](std::size_t i, bool i_reversed, std::size_t j, bool j_reversed) {
    return CGAL::Exact_rational(gap * gap) <
           (curves[j][j_reversed ? 1 : 0] - curves[i][i_reversed ? 0 : 1]).squared_length();
  };
  Chain_reversal best{std::vector<bool>(n, false), 0, 0};
  for (std::size_t i = 0; i + 1 < n; ++i) best.gaps_before += is_gap(i, false, i + 1, false);
  if (closed && n > 0) best.gaps_before += is_gap(n - 1, false, 0, false);
  best.gaps_after = best.gaps_before;
  if (n < 2) return best;
  Cost least(best.gaps_before, 0);
  std::vector<std::array<Cost, 2>> costs(n);
  std::vector<std::array<bool, 2>> next_reversed(n);
  for (const bool first : {false, true}) {
    for (const bool last : {false, true}) costs[n - 1][last] = Cost(closed ? is_gap(n - 1, last, 0, first) : 0, last);
    for (std::size_t i = n - 1; i-- > 0;)
      for (const bool reversed : {false, true}) {
        const auto cost = [&](bool next) {
          const auto [gaps, count] = costs[i + 1][next];
          return Cost(gaps + is_gap(i, reversed, i + 1, next), count + reversed);
        };
        next_reversed[i][reversed] = cost(true) < cost(false);
        costs[i][reversed] = cost(next_reversed[i][reversed]);
      }
    if (!(costs[0][first] < least)) continue;
    least = costs[0][first];
    best.gaps_after = std::get<0>(least);
    best.curves[0] = first;
    for (std::size_t i = 0; i + 1 < n; ++i) best.curves[i + 1] = next_reversed[i][best.curves[i]];
  }
  return best;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CHAIN_DIRECTION_H
