// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/contour/close_gaps.h"

#include "commands/repair/contour/Movable_contour.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace {

// The points to which both ends of a gap may move: those nearest to its middle, and the ends.
std::vector<Drawing_traits::Point> meeting_points(const Movable_contour& contour, const Drawing_traits::Point& p,
                                                  const Drawing_traits::Point& q) {
  const Drawing_traits::Point middle = CGAL::midpoint(p, q);
  if (contour.now().is_beside_grid) return {middle, p, q};
  std::vector<Drawing_traits::Point> result;
  const auto below = [](const Grid_fraction& x) { return std::floor(CGAL::to_double(x)); }; // of a half
  const double x = below(middle.x()), y = below(middle.y());
  for (const double i : {0., 1.})
    for (const double j : {0., 1.})
      if ((i == 0 || x != middle.x()) && (j == 0 || y != middle.y())) result.emplace_back(x + i, y + j);
  result.push_back(p);
  result.push_back(q);
  return result;
}

// The moves of an end of a curve to a point, with the handle that belongs to it.
Moves moves_of_end(const Movable_contour& contour, std::size_t curve, bool at_end, const Drawing_traits::Point& to) {
  const Grid_curve& c = contour.curve(curve);
  const std::size_t n = c.points.size() - 1, node = at_end ? n : 0, handle = at_end ? n - 1 : 1;
  const Grid_offset v = to - exact_point(c, node);
  if (v == CGAL::NULL_VECTOR) return {};
  Moves moves{contour.to_place(curve, node, node, v)};
  if (contour.is_free(curve)) moves.push_back(contour.to_place(curve, handle, handle, v));
  return moves;
}

// The ends of the curves at a join.
std::pair<Drawing_traits::Point, Drawing_traits::Point> ends(const Movable_contour& contour, std::size_t join) {
  const Grid_curve &left = contour.curve(join), &right = contour.curve(contour.next(join));
  return {exact_point(left, left.points.size() - 1), exact_point(right, 0)};
}

void close_gap(Movable_contour& contour, std::size_t join) {
  const std::size_t left = join, right = contour.next(join);
  const auto [p, q] = ends(contour, join);
  std::set<std::size_t> joins;
  for (const std::size_t curve : {left, right}) joins.merge(contour.joins_of(curve));
  joins.erase(join);
  const std::vector<Join_state> before = contour.states(joins);
  typedef std::tuple<std::size_t, CGAL::Exact_rational, CGAL::Exact_rational> Cost; // harm, the moves
  std::optional<Cost> least;
  Moves best;
  for (const Drawing_traits::Point& to : meeting_points(contour, p, q)) {
    Moves moves = moves_of_end(contour, left, true, to);
    for (Move& m : moves_of_end(contour, right, false, to)) moves.push_back(std::move(m));
    const Moves back = contour.execute(moves);
    std::size_t harm = contour.grade(join) >= GC::Visual_class::g1 ? 0 : 1;
    for (const Join_state& s : before) harm += contour.is_harmed(s, contour.state(s.join), back);
    contour.execute({back.rbegin(), back.rend()});
    const CGAL::Exact_rational a = (to - p).squared_length(), b = (to - q).squared_length();
    const Cost cost(harm, (std::max)(a, b), (std::min)(a, b));
    if (least && !(cost < *least)) continue;
    least = cost;
    best = std::move(moves);
  }
  contour.execute(best);
}

} // namespace

std::vector<Closed_gap> close_gaps(Grid_contour& given, const Repair_options& options,
                                   const CGAL::Exact_rational& widest) {
  Movable_contour contour(given, options);
  std::vector<Closed_gap> closed;
  const CGAL::Exact_rational bound = widest * power_of_ten(given.decimals), unit = power_of_ten(-given.decimals);
  for (std::size_t j = 0; j < contour.number_of_joins(); ++j) {
    if (!contour.is_bezier_join(j) || contour.grade(j) != GC::Visual_class::gap) continue;
    const auto [p, q] = ends(contour, j);
    const CGAL::Exact_rational squared = (q - p).squared_length();
    if (squared > CGAL::Exact_rational(bound * bound)) continue;
    close_gap(contour, j);
    closed.push_back({j, GC::sqrt_enclosure(CGAL::Exact_rational(squared * unit * unit))});
  }
  return closed;
}
