// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/contour/Movable_contour.h"

#include "commands/drawings/segment_joins.h"
#include "commands/repair/grid_vectors.h"

#include <algorithm>
#include <cmath>

// ---- joins

std::optional<GC::Kink_size> Movable_contour::kink_size(std::size_t join) const {
  const Grid_curve &left = curve(join), &right = curve(next(join));
  return contour_.is_beside_grid ? segment_kink(exact_bezier(left), exact_bezier(right))
                                 : segment_kink(grid_bezier(left.points), grid_bezier(right.points));
}

std::set<std::size_t> Movable_contour::joins_of(std::size_t curve) const {
  std::set<std::size_t> joins;
  for (const bool at_end : {true, false})
    if (const std::optional<std::size_t> join = other_join(curve, at_end)) joins.insert(*join);
  return joins;
}

std::set<std::size_t> Movable_contour::joins_of(const Moves& moves) const {
  std::set<std::size_t> joins;
  for (const Move& m : moves) joins.merge(joins_of(m.curve));
  return joins;
}

std::optional<std::size_t> Movable_contour::other_join(std::size_t curve, bool at_end) const {
  const bool is_free = !contour_.closed && curve == (at_end ? 0 : contour_.curves.size() - 1);
  if (is_free) return std::nullopt;
  return at_end ? previous(curve) : curve;
}

// ---- directions

std::size_t Movable_contour::tip(std::size_t curve, bool at_end) const {
  const Grid_curve& c = contour_.curves[curve];
  const std::size_t n = c.points.size() - 1, node = at_end ? n : 0;
  const auto at = [&](std::size_t k) { return at_end ? n - k : k; };
  std::size_t k = 1;
  while (k + 1 < n && c.points[at(k)] == c.points[node] && offset(c, at(k)) == offset(c, node)) ++k;
  return at(k);
}

std::optional<GC::Grid_vector> Movable_contour::first_difference(std::size_t curve, bool at_end) const {
  const Grid_curve& c = contour_.curves[curve];
  if (c.arc) return arc_direction(*c.arc, at_end);
  const std::vector<GC::Grid_vector>& p = c.points;
  if (is_line(c)) return p.back() - p.front();
  const GC::Grid_vector& handle = p[tip(curve, at_end)];
  return at_end ? p.back() - handle : handle - p[0];
}

Grid_offset Movable_contour::exact_direction(std::size_t curve, bool at_end) const {
  const Grid_curve& c = contour_.curves[curve];
  if (c.arc) return exact_vector(*arc_direction(*c.arc, at_end));
  const std::size_t n = c.points.size() - 1;
  if (is_line(c)) return exact_vector(c, 0, n);
  return at_end ? exact_vector(c, tip(curve, true), n) : exact_vector(c, 0, tip(curve, false));
}

// ---- what may move

// Returns whether the node between two quadratics may be left out, so that it would move with
// their handles. A repair may make it so.
bool Movable_contour::may_be_left_out(std::size_t join) const {
  const std::vector<GC::Grid_vector>&left = points(join), &right = points(next(join));
  return contour_.may_leave_nodes_out && left.size() == 3 && right.size() == 3 &&
         left[2] - left[1] == right[1] - right[0];
}

bool Movable_contour::is_free(std::size_t curve) const {
  const Grid_curve& c = contour_.curves[curve];
  return !c.fixed && c.points.size() >= 4 && !is_line(c);
}

bool Movable_contour::is_free_quadratic(std::size_t curve) const {
  const Grid_curve& c = contour_.curves[curve];
  return !c.fixed && c.points.size() == 3 && !is_line(c) && !may_be_left_out(previous(curve)) &&
         !may_be_left_out(curve);
}

// ---- moves

Move Movable_contour::to_left(std::size_t join, const GC::Grid_vector& difference) const {
  const std::size_t n = points(join).size() - 1;
  return {join, tip(join, true), points(join)[n] - difference, offset(curve(join), n)};
}

Move Movable_contour::to_right(std::size_t join, const GC::Grid_vector& difference) const {
  const std::size_t right = next(join);
  return {right, tip(right, false), points(right)[0] + difference, offset(curve(right), 0)};
}

Move Movable_contour::to_place(std::size_t curve, std::size_t point, std::size_t node,
                               const Grid_offset& from_node) const {
  const Grid_curve& c = contour_.curves[curve];
  const auto whole = [](const Grid_fraction& x) { return on_grid(x).value_or(0); };
  const GC::Grid_vector near = c.points[node] + GC::Grid_vector{whole(from_node.x()), whole(from_node.y())};
  return {curve, point, near, exact_point(c, node) + from_node - (CGAL::ORIGIN + exact_vector(near))};
}

Moves Movable_contour::execute(const Moves& moves) {
  Moves back;
  for (const Move& m : moves) {
    Grid_curve& c = contour_.curves[m.curve];
    back.push_back({m.curve, m.point, std::exchange(c.points[m.point], m.to), offset(c, m.point)});
    if (!c.offsets.empty()) c.offsets[m.point] = m.offset;
  }
  return back;
}

// ---- harm

// The square of the largest value of n t (1-t)^(n-1), by which a handle of a curve of degree n
// moves its points, times that of the move.
double Movable_contour::change(const Moves& moves) const {
  double most = 0;
  for (const Move& m : moves) {
    const GC::Grid_vector v = m.to - points(m.curve)[m.point];
    const double n = static_cast<double>(points(m.curve).size() - 1), weight = std::pow((n - 1) / n, n - 1);
    double x = static_cast<double>(v.x), y = static_cast<double>(v.y);
    if (contour_.is_beside_grid) {
      const Grid_offset d = m.offset - offset(curve(m.curve), m.point);
      x += CGAL::to_double(d.x());
      y += CGAL::to_double(d.y());
    }
    most = (std::max)(most, weight * weight * (x * x + y * y));
  }
  return most;
}

Exact_segment Movable_contour::drawn_segment(std::size_t curve) const {
  const Exact_segment segment = grid_segment(contour_.curves[curve]);
  return contour_.map ? segment.transform(*contour_.map) : segment;
}

Join_state Movable_contour::state(std::size_t join) const {
  Join_state s{join, grade(join)};
  if (s.grade == GC::Visual_class::kink && is_bezier_join(join))
    s.size = kink_size(join);
  else if (s.grade == GC::Visual_class::kink)
    s.angle = segment_angle(drawn_segment(join), drawn_segment(next(join)));
  return s;
}

std::vector<Join_state> Movable_contour::states(const std::set<std::size_t>& joins) const {
  std::vector<Join_state> result;
  for (const std::size_t j : joins) result.push_back(state(j));
  return result;
}

bool Movable_contour::is_harmed(const Join_state& before, const Join_state& after, const Moves& back) const {
  if (!before.grade) { // an arc that is not known: directions next to it stay as they are
    for (const Move& m : back) {
      const std::size_t n = points(m.curve).size() - 1;
      const bool at_end = m.curve == before.join;
      const Grid_curve& c = curve(m.curve);
      const std::size_t node = at_end ? n : 0;
      const bool next_to_node = m.point == tip(m.curve, at_end);
      const Grid_offset u = difference(c.points[node], offset(c, node), m.to, m.offset),
                        v = exact_vector(c, node, m.point);
      if (next_to_node && (cross_product(u, v) != 0 || u * v <= 0)) return true;
    }
    return false;
  }
  switch (*before.grade) {
  case GC::Visual_class::gap: return false;
  case GC::Visual_class::corner: return after.grade != GC::Visual_class::corner;
  case GC::Visual_class::kink:
    return after.grade < GC::Visual_class::kink ||
           (before.size && after.size &&
            (after.size->angle.upper > before.size->angle.upper ||
             after.size->handle_offset.upper > before.size->handle_offset.upper));
  default: return after.grade < GC::Visual_class::g1;
  }
}

std::string Movable_contour::objection(std::size_t join, const Moves& moves, const CGAL::Exact_rational& bound,
                                       Harm& harm) {
  for (const Move& m : moves) {
    const Grid_curve& from = given_.curves[m.curve];
    const Grid_offset move = difference(from.points[m.point], offset(from, m.point), m.to, m.offset);
    if (const CGAL::Exact_rational squared = move.squared_length(); squared > CGAL::Exact_rational(bound * bound))
      return "not on this grid: the nearest position, " + contour_.text(m.to, m.offset) + ", is " +
             units(GC::sqrt_enclosure(squared)) + " away, and the handle may move by " +
             rounded_up(CGAL::to_double(bound));
  }
  harm = {0, 0, change(moves)};
  const std::vector<Join_state> before = states(joins_of(moves));
  const Moves back = execute(moves);
  bool smooth = grade(join) >= GC::Visual_class::g1;
  for (const Join_state& x : before) {
    const Join_state after = state(x.join);
    smooth = smooth && (x.join == join || !is_harmed(x, after, back));
    harm.kinks += after.grade == GC::Visual_class::kink;
    harm.lost += x.grade == GC::Visual_class::g2 && after.grade == GC::Visual_class::g1;
  }
  execute(back);
  return smooth ? "" : "another join would be harmed";
}

// ---- contours before and after

bool same_points(const Grid_contour& x, const Grid_contour& y) {
  return std::equal(
      x.curves.begin(), x.curves.end(), y.curves.begin(), y.curves.end(),
      [](const Grid_curve& c, const Grid_curve& d) { return c.points == d.points && c.offsets == d.offsets; });
}

bool moves_within(const Grid_contour& from, const Grid_contour& to, const CGAL::Exact_rational& bound) {
  const CGAL::Exact_rational squared = CGAL::Exact_rational(bound * bound);
  for (std::size_t i = 0; i < from.curves.size(); ++i)
    for (std::size_t k = 0; k < from.curves[i].points.size(); ++k) {
      const Grid_curve &x = from.curves[i], &y = to.curves[i];
      if (squared < difference(x.points[k], offset(x, k), y.points[k], offset(y, k)).squared_length()) return false;
    }
  return true;
}
