// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_GRID_CONTOUR_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_GRID_CONTOUR_H

#include "commands/drawings/segment_joins.h"
#include "formats/svg/svg_drawing.h"

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Path_segment.h>
#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>
#include <CGAL/Geometric_continuity/repairs/align_handles.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

// The largest coordinate of a contour on its grid.
constexpr std::int64_t max_grid_coordinate = std::int64_t(1) << 50;

typedef GC::Path_segment<Drawing_traits> Exact_segment;
typedef GC::Svg_transform<Drawing_traits> Drawing_transform;

// A point beside the grid: that on the grid, and from there on to it, in units.
typedef Drawing_traits::FT Grid_fraction;
typedef Drawing_traits::Vector Grid_offset;

// One curve of a contour by its control points, in whole units of a grid: 2 for a line.
struct Grid_curve {
  // none for what is no Bezier curve on the grid
  std::vector<GC::Grid_vector> points;
  std::string reason;                                 // why there are none
  bool fixed = false;                                 // its handles do not move
  std::shared_ptr<const Exact_segment> arc = nullptr; // an arc of an ellipse, in units of the grid
  // how far each control point lies beside its point on the grid; of contours beside the grid only
  std::vector<Grid_offset> offsets = {};
  // of the arc as it is written, with the radii in units
  std::optional<GC::Elliptical_arc_parameters<Grid_fraction>> written = std::nullopt;
};

// Curves of some length, each of which starts where the one before it ends. Glyphs, paths and
// chains are such contours.
//
// Numbers can be too long for a grid of their last decimal. Then nodes lie *beside the grid*, which
// is a coarser one, and stay there, and handles move such that they are whole units away from their
// nodes.
struct Grid_contour {
  std::vector<Grid_curve> curves;
  bool closed = false; // the last one leads back to the first
  // in the middle of two handles of quadratics, as TrueType does
  bool may_leave_nodes_out = false;
  int decimals = 0; // the unit is 10^-decimals, also a negative number of them
  // by which it is drawn, where that changes angles
  std::optional<Drawing_transform> map = std::nullopt;
  bool is_beside_grid = false;
  // handles may get more decimals than there are: where no other position is exact, beside the grid
  bool may_add_decimals = false;
  bool takes_fractions = false; // coordinates need not be decimals
  // whether the point where it starts, or ends, belongs to one curve and may be written anew, with
  // at most so many decimals
  bool has_free_start = false, has_free_end = false;
  int most_decimals = 0;

  // Returns a coordinate as a decimal, or as a fraction where it is none.
  std::string text(std::int64_t coordinate) const;
  std::string text(const Grid_fraction& coordinate) const;

  // Returns a point, e.g. "(0.5, -2)".
  std::string text(const GC::Grid_vector& point) const { return '(' + text(point.x) + ", " + text(point.y) + ')'; }
  std::string text(const GC::Grid_vector& point, const Grid_offset& offset) const;

  // Returns the unit as a decimal.
  std::string unit() const;

  std::size_t number_of_joins() const { return curves.empty() || closed ? curves.size() : curves.size() - 1; }
  std::size_t next(std::size_t curve) const { return curve + 1 == curves.size() ? 0 : curve + 1; }
};

// A power of ten.
Grid_fraction power_of_ten(int exponent);

// Returns the offset of a control point from its point on the grid.
Grid_offset offset(const Grid_curve& curve, std::size_t point);

// Returns a control point, and the vector from one to another, in units.
Drawing_traits::Point exact_point(const Grid_curve& curve, std::size_t point);
inline Grid_offset exact_vector(const Grid_curve& curve, std::size_t from, std::size_t to) {
  return exact_point(curve, to) - exact_point(curve, from);
}

// Returns a number rounded to an integer; nothing where it is too large for a contour.
std::optional<std::int64_t> on_grid(const Grid_fraction& x);

// Returns a curve beside a grid. Its handles have the points of the grid that are nearest as seen
// from their nodes.
Grid_curve curve_beside_grid(const std::vector<Drawing_traits::Point>& points, int decimals);

// Returns the decimals of the finest grid for curves with these nodes, in coordinates: that on
// which the whole contour is no longer than a handle may be.
int coarser_decimals(const std::vector<Drawing_traits::Point>& nodes, std::int64_t longest);

// A curve on the grid in floating-point numbers, which hold its coordinates exactly.
typedef GC::Bezier_curve<Grid_traits> Grid_bezier;
Grid_bezier grid_bezier(const std::vector<GC::Grid_vector>& points);

// A curve with all of its digits, in units.
typedef GC::Bezier_curve<Drawing_traits> Exact_bezier;
Exact_bezier exact_bezier(const Grid_curve& curve);

// A curve as a segment of a path.
Exact_segment grid_segment(const Grid_curve& curve);

// Returns whether the control points lie on the chord, in order.
bool is_line(const Grid_curve& curve);

// Returns the shortest whole vector of a direction; nothing where that is longer than a handle may
// be.
std::optional<GC::Grid_vector> primitive_direction(const Grid_offset& direction);

// The direction of an arc at an end, as the shortest whole vector; nothing where that is too long
// or irrational.
std::optional<GC::Grid_vector> arc_direction(const Exact_segment& arc, bool at_end);

// How many joins have each grade.
typedef std::map<GC::Visual_class, std::size_t> Grade_counts;

// Returns the grade of a join, the one behind this curve, as it is drawn; nothing where it is not
// known.
std::optional<GC::Visual_class> grade(const Grid_contour& contour, std::size_t join, const GC::Corner_threshold& bound);

// Counts the grades of all joins that are known.
Grade_counts grades(const Grid_contour& contour, const GC::Corner_threshold& bound);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_GRID_CONTOUR_H
