// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_MOVABLE_CONTOUR_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_MOVABLE_CONTOUR_H

#include "commands/repair/grid_contour.h"
#include "commands/repair/repair_contour.h"

#include <CGAL/Exact_rational.h>

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// The move of a control point to another place.
struct Move {
  std::size_t curve, point;
  GC::Grid_vector to;
  Grid_offset offset = Grid_offset(0, 0); // beside the grid
};
typedef std::vector<Move> Moves;

// The harm that moves leave behind; less is better.
struct Harm {
  std::size_t kinks = 0; // that are left next to them
  std::size_t lost = 0;  // joins that are G2 no more
  // the square of the largest distance between old and new points of the curves at equal parameters
  double change = 0;
  friend bool operator<(const Harm& x, const Harm& y) {
    return std::tie(x.kinks, x.lost, x.change) < std::tie(y.kinks, y.lost, y.change);
  }
};

// The state of a join next to a move, which must be kept.
struct Join_state {
  std::size_t join;
  std::optional<GC::Visual_class> grade;
  std::optional<GC::Kink_size> size = std::nullopt;  // of a kink
  std::optional<GC::Enclosure> angle = std::nullopt; // of a kink with an arc
};

// A contour whose control points move: which of them may, what a move harms, and which moves are
// allowed.
class Movable_contour {
  Grid_contour& contour_;
  const Repair_options& options_;
  const Grid_contour given_ = contour_;

  double change(const Moves& moves) const;
  Exact_segment drawn_segment(std::size_t curve) const;
  bool may_be_left_out(std::size_t join) const;

public:
  Movable_contour(Grid_contour& contour, const Repair_options& options) : contour_(contour), options_(options) {}

  const Grid_contour& now() const { return contour_; }
  const Repair_options& options() const { return options_; }
  const Grid_curve& curve(std::size_t i) const { return contour_.curves[i]; }
  const std::vector<GC::Grid_vector>& points(std::size_t curve) const { return contour_.curves[curve].points; }

  // The curve behind the join, or behind another curve, and the one before.
  std::size_t next(std::size_t curve) const { return contour_.next(curve); }
  std::size_t previous(std::size_t curve) const { return (curve == 0 ? contour_.curves.size() : curve) - 1; }

  // ---- joins

  std::size_t number_of_joins() const { return contour_.number_of_joins(); }
  std::optional<GC::Visual_class> grade(std::size_t join) const { return ::grade(contour_, join, options_.bound); }
  bool is_bezier_join(std::size_t join) const { return !points(join).empty() && !points(next(join)).empty(); }
  std::optional<GC::Kink_size> kink_size(std::size_t join) const; // between Bezier curves

  // The joins at both ends of curves.
  std::set<std::size_t> joins_of(std::size_t curve) const;
  std::set<std::size_t> joins_of(const Moves& moves) const;

  // The join at the other end of a curve than this one; nothing where that is free.
  std::optional<std::size_t> other_join(std::size_t curve, bool at_end) const;

  // ---- directions

  // The control point of a curve that tells its tangent at an end: the next one, or where that lies
  // at the node the one behind it.
  std::size_t tip(std::size_t curve, bool at_end) const;

  // The direction in which a curve ends or starts: that of the chord for a line. Zero where all
  // handles lie at the node, nothing where no vector of the grid has it.
  std::optional<GC::Grid_vector> first_difference(std::size_t curve, bool at_end) const;

  // The direction in which a curve ends or starts, which is known, with all of its digits.
  Grid_offset exact_direction(std::size_t curve, bool at_end) const;

  // ---- what may move

  // Returns whether the handle of a curve belongs to one node.
  bool is_free(std::size_t curve) const;
  bool is_free_quadratic(std::size_t curve) const;
  bool is_movable(std::size_t curve) const { return is_free(curve) || is_free_quadratic(curve); }

  // ---- moves

  // The move of the handle before, or behind, a join to where it has this difference to the node.
  Move to_left(std::size_t join, const GC::Grid_vector& difference) const;
  Move to_right(std::size_t join, const GC::Grid_vector& difference) const;

  // The move to a place beside the grid, which is given by the vector from a node of the curve.
  Move to_place(std::size_t curve, std::size_t point, std::size_t node, const Grid_offset& from_node) const;

  // Returns the moves back.
  Moves execute(const Moves& moves);

  // Puts another curve in the place of one, which is returned.
  Grid_curve replace(std::size_t curve, const Grid_curve& by) { return std::exchange(contour_.curves[curve], by); }

  // ---- harm

  Join_state state(std::size_t join) const;
  std::vector<Join_state> states(const std::set<std::size_t>& joins) const;

  // Returns whether a join is harmed by moves from the contour that was; it has changed to this
  // state.
  bool is_harmed(const Join_state& before, const Join_state& after, const Moves& back) const;

  // Decides what moves would do: nothing where they are allowed and make the join smooth, otherwise
  // why they are not made.
  std::string objection(std::size_t join, const Moves& moves, const CGAL::Exact_rational& bound, Harm& harm);
};

// Returns whether all control points have the same places.
bool same_points(const Grid_contour& x, const Grid_contour& y);

// Returns whether no control point has moved by more than the bound.
bool moves_within(const Grid_contour& from, const Grid_contour& to, const CGAL::Exact_rational& bound);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_MOVABLE_CONTOUR_H
