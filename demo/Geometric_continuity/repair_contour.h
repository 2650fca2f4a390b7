// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_DEMO_REPAIR_CONTOUR_H
#define GEOMETRIC_CONTINUITY_DEMO_REPAIR_CONTOUR_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/extensions/Grid_vector.h>
#include <CGAL/Geometric_continuity/joins/Join_grade.h>
#include <CGAL/Geometric_continuity/joins/Kink_bound.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

// The largest coordinate of a contour on its grid.
constexpr std::int64_t max_grid_coordinate = std::int64_t(1) << 50;

// One curve of a contour by its control points, in whole units of a grid: 2 for a line.
struct Grid_curve {
  std::vector<GC::Grid_vector> points; // none for what is no Bezier curve on the grid
  std::string reason;                  // why there are none
  bool fixed = false;                  // its handles do not move
};

// Curves of some length, each of which starts where the one before it ends. Glyphs, paths and chains are such contours.
struct Grid_contour {
  std::vector<Grid_curve> curves;
  bool closed = false; // the last one leads back to the first
  int decimals = 0;    // the unit is 10^-decimals

  // Returns a coordinate as a decimal, and a point, e.g. "(0.5, -2)".
  std::string text(std::int64_t coordinate) const;
  std::string text(const GC::Grid_vector& point) const { return '(' + text(point.x) + ", " + text(point.y) + ')'; }

  std::size_t number_of_joins() const { return curves.empty() || closed ? curves.size() : curves.size() - 1; }
};

// What to repair, and how.
struct Repair_options {
  GC::Kink_bound bound; // kinks are angles up to this one
  std::optional<CGAL::Exact_rational>
      max_move;           // in units; a tenth of the shorter handle, at least 1, unless it is given
  bool harmonise = false; // the curvatures, too
};

// A control point that has moved.
struct Handle_move {
  std::size_t curve, point;
  GC::Grid_vector from, to;

  // The distance.
  GC::Enclosure distance() const;
};

// The join behind a curve that was not repaired.
struct Unrepaired_join {
  std::size_t join;
  std::string reason;
};

// The curvatures at a join that were to agree.
struct Curvature_jump {
  std::size_t join;
  GC::Enclosure before, after; // relative; 0 is exact
  std::string reason;          // why it is not harmonised; empty when it is
};

// How many joins have each grade.
typedef std::map<GC::Join_grade, std::size_t> Grade_counts;

// What was done with a contour.
struct Contour_repair {
  std::vector<Handle_move> moves;
  std::vector<Unrepaired_join> unrepaired;
  std::map<std::string, std::size_t> undecided; // how many joins have no grade, for each reason
  std::vector<Curvature_jump> jumps;
};

// Returns the grade of a join, the one behind this curve; nothing where a curve is unknown.
std::optional<GC::Join_grade> grade(const Grid_contour& contour, std::size_t join, const GC::Kink_bound& bound);

// Counts the grades of all joins that are known.
Grade_counts grades(const Grid_contour& contour, const GC::Kink_bound& bound);

// Makes each kink exactly G1 by moving handles, not nodes, as little as possible, and harmonises the curvatures when that is asked for.
// A move that would make another join a kink or a corner is not made. What is said to be repaired is so by the exact predicates.
Contour_repair repair(Grid_contour& contour, const Repair_options& options);

#endif // GEOMETRIC_CONTINUITY_DEMO_REPAIR_CONTOUR_H
