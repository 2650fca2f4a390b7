// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_KINK_PROPOSALS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_KINK_PROPOSALS_H

#include "commands/repair/contour/Movable_contour.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/repairs/align_handles.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// A proposal that would mend a kink.
struct Proposal {
  std::size_t join;
  Moves moves = {}; // none where there is a reason
  std::string reason = {};
  CGAL::Exact_rational bound = 0; // of the moves
  Harm harm = {};
};

// Returns the moves that mend a kink with the least harm, or why there are none.
Proposal propose(Movable_contour& contour, std::size_t join);

// A kink whose handles stay on the grid. `in` and `out` are the directions at the node.
Proposal propose_on_grid(Movable_contour& contour, std::size_t join, const GC::Grid_vector& in,
                         const GC::Grid_vector& out);

// A kink of nodes beside the grid. Both handles come to whole units from the node, or where none
// of these are near enough, one to a multiple of the other one.
Proposal propose_beside_grid(Movable_contour& contour, std::size_t join, const GC::Grid_vector& in,
                             const GC::Grid_vector& out);

// ---- what both have in common

// Takes those of the moves that harm least, of equal ones the first.
void choose(Movable_contour& contour, const std::vector<Moves>& choices, Proposal& proposal);

// How far a handle may move for a kink between these handles: twice what it is off and one unit.
CGAL::Exact_rational max_move(const Movable_contour& contour, std::size_t join, const Grid_offset& in,
                              const Grid_offset& out);

// Handles that are mirror images of each other stay so: on a line of the grid at a right angle to
// the axis. Nothing for other handles.
std::optional<Moves> symmetric(const Movable_contour& contour, std::size_t join, const GC::Grid_vector& in,
                               const GC::Grid_vector& out);

// align_handles() in coordinates in which mirror images are one: in the first octant with the
// longer difference first, seen from there to the left. So their handles move to mirror images,
// also where several positions are equally near.
std::optional<GC::Aligned_handles> aligned(const GC::Grid_vector& in, const GC::Grid_vector& out,
                                           const CGAL::Exact_rational& most);

// The handle of a quadratic belongs to both of its nodes: it moves to where the tangents at both
// intersect, or, where the other join is not to be smooth, along that at this node.
struct Quadratic_handle {
  bool is_bound = false; // by the other join
  // node + k direction is on the tangent at the other node; nothing where it is on none
  std::optional<CGAL::Exact_rational> k = std::nullopt;
  std::string reason = {}; // why it can go to no place at all
};

// Returns where the handle of a quadratic may be on the line from the node of a join in a
// direction.
Quadratic_handle quadratic_handle(const Movable_contour& contour, std::size_t join, std::size_t curve,
                                  const Grid_offset& direction);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_CONTOUR_KINK_PROPOSALS_H
