// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_REPAIR_CONTOUR_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_REPAIR_CONTOUR_H

#include "commands/repair/grid_contour.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

// Options that tell what to repair, and how.
struct Repair_options {
  GC::Corner_threshold bound; // kinks are angles up to this one
  // in units; unless it is given, twice what the kink is off and one more, for curvatures a
  // tenth of the shorter handle
  std::optional<CGAL::Exact_rational> max_move = std::nullopt;
  bool harmonise = false;                          // the curvatures, too
  std::optional<int> grid_decimals = std::nullopt; // of another grid than that of the file
  bool change_arcs = false;                        // where no handle can move
  // up to which width gaps are closed, in coordinates
  std::optional<CGAL::Exact_rational> close = std::nullopt;
};

// A control point that has moved.
struct Handle_move {
  std::size_t curve, point;
  GC::Grid_vector from, to;
  Grid_offset offset_from = Grid_offset(0, 0), offset_to = Grid_offset(0, 0);

  // The distance.
  GC::Enclosure distance() const;
};

// Returns a number of four digits that is not less than x.
std::string rounded_up(double x);

// Returns a distance, rounded up, e.g. "1 unit".
std::string units(const GC::Enclosure& distance);

// An arc with other radii, or with another end, where it is smooth with its neighbour.
struct Arc_offer {
  std::size_t curve = 0;
  Grid_curve changed = {};
  bool moves_start = false, moves_end = false; // otherwise the radii change
  std::vector<std::string> numbers = {};       // both radii, or the coordinates of the end
  bool is_decimal = false;                     // so that it can be written
  bool is_on_grid = false;                     // without more decimals than there are
  double size = 0;                             // of the change

  std::string text() const;
};

// The join behind a curve that was not repaired.
struct Unrepaired_join {
  std::size_t join;
  std::string reason;
  std::vector<Arc_offer> offers = {}; // each of which would repair it
};

// An arc that was changed: what of it, e.g. "radius", and the numbers.
struct Arc_change {
  std::size_t curve;
  std::string what;
  std::vector<std::string> from, to;
};

// The curvatures at a join that were to agree.
struct Curvature_jump {
  std::size_t join;
  GC::Enclosure before, after; // relative; 0 is exact
  std::string reason;          // why it is not harmonised; empty when it is
};

// A gap that was closed.
struct Closed_gap {
  std::size_t join;
  GC::Enclosure width; // in coordinates
};

// The result of the repair of a contour.
struct Contour_repair {
  std::vector<Closed_gap> closed;
  std::vector<Handle_move> moves; // of nodes, too, where gaps are closed
  std::vector<Arc_change> arcs;
  std::vector<Unrepaired_join> unrepaired;
  std::map<std::string, std::size_t> undecided; // how many joins have no grade, for each reason
  std::vector<Curvature_jump> jumps;
  std::vector<std::size_t> lost; // the joins that were G2 and now are G1

  // Returns whether there is something to tell.
  bool is_of_use() const { return !moves.empty() || !arcs.empty() || !unrepaired.empty() || !jumps.empty(); }
};

// Makes each kink exactly G1 by moving handles, not nodes, so that the curves change as little as
// possible, and harmonises the curvatures when that is asked for. A move that would harm another
// join is not made: a smooth one stays smooth, a corner stays a corner, a kink does not grow,
// neither its angle nor by how much a handle is off, and a direction next to an arc that is not
// known stays as it is; a join that is G2 falls to G1 only where no other move does. Mirror images
// are repaired to mirror images. The exact predicates confirm all repairs that are reported.
// Repairing again changes nothing.
//
// Gaps are closed first where that is asked for. Both nodes come to one point, with the handles
// that belong to them alone: to the middle, or to one of the nodes where this harms fewer joins.
//
// Beside the grid, both handles of a node move to whole units from it; where no position is near
// enough, and the contour may get more decimals, one handle moves to a short decimal multiple of
// the other one, or of a line.
Contour_repair repair(Grid_contour& contour, const Repair_options& options);

// Returns why a contour needs a coarser grid for its repair: a vector that decides about it is
// longer than a handle may be. Empty where it does not.
std::string needs_coarser_grid(const Grid_contour& contour, const Repair_options& options);

// The largest coordinate of the whole of a contour beside the grid.
std::int64_t longest_beside_grid(const Repair_options& options);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_REPAIR_CONTOUR_H
