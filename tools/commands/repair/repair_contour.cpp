// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/repair_contour.h"

#include "commands/repair/contour/Movable_contour.h"
#include "commands/repair/contour/close_gaps.h"
#include "commands/repair/contour/harmonise_curvatures.h"
#include "commands/repair/contour/mend_kinks.h"
#include "commands/repair/contour/offer_arcs.h"
#include "commands/repair/grid_vectors.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

namespace {

// Makes the kinks smooth. A repair that was impossible before may be possible after the others; a
// given limit holds for all rounds together.
Contour_repair mend_in_rounds(Grid_contour& contour, const Repair_options& options) {
  const Grid_contour met = contour;
  Contour_repair result = mend_kinks(contour, options);
  if (same_points(contour, met)) return result;
  while (!result.unrepaired.empty()) {
    Grid_contour again = contour;
    Contour_repair next = mend_kinks(again, options);
    const bool more = next.unrepaired.size() < result.unrepaired.size() &&
                      (!options.max_move || moves_within(met, again, *options.max_move));
    if (!more) break;
    contour = std::move(again);
    result = std::move(next);
  }
  return result;
}

// Leaves out the joins that are smooth, as other handles have moved.
void remove_mended(const Grid_contour& contour, const Repair_options& options, std::vector<Unrepaired_join>& joins) {
  const auto is_mended = [&](const Unrepaired_join& x) {
    return grade(contour, x.join, options.bound) >= GC::Visual_class::g1;
  };
  joins.erase(std::remove_if(joins.begin(), joins.end(), is_mended), joins.end());
}

// Returns the control points that have moved.
std::vector<Handle_move> moves_between(const Grid_contour& given, const Grid_contour& contour) {
  std::vector<Handle_move> moves;
  for (std::size_t i = 0; i < contour.curves.size(); ++i)
    for (std::size_t k = 0; k < contour.curves[i].points.size(); ++k) {
      const GC::Grid_vector &from = given.curves[i].points[k], &to = contour.curves[i].points[k];
      const Grid_offset offset_from = offset(given.curves[i], k), offset_to = offset(contour.curves[i], k);
      if (from == to && offset_from == offset_to) continue;
      moves.push_back({i, k, from, to, offset_from, offset_to});
    }
  return moves;
}

// Returns the joins next to moves that were G2 and now are G1.
std::vector<std::size_t> lost_joins(const Grid_contour& given, const Grid_contour& contour,
                                    const Repair_options& options, const std::vector<Handle_move>& moves) {
  std::set<std::size_t> touched;
  for (const Handle_move& m : moves) {
    touched.insert(m.curve);
    touched.insert(m.curve == 0 ? contour.curves.size() - 1 : m.curve - 1);
  }
  std::vector<std::size_t> lost;
  for (const std::size_t j : touched)
    if (j < contour.number_of_joins() && grade(given, j, options.bound) == GC::Visual_class::g2 &&
        grade(contour, j, options.bound) == GC::Visual_class::g1)
      lost.push_back(j);
  return lost;
}

} // namespace

Contour_repair repair(Grid_contour& contour, const Repair_options& options) {
  const Grid_contour given = contour;
  std::vector<Closed_gap> closed;
  if (options.close) closed = close_gaps(contour, options, *options.close);
  Contour_repair result = mend_in_rounds(contour, options);
  if (!result.unrepaired.empty()) offer_arcs(contour, options, result);
  if (options.harmonise) {
    result.jumps = harmonise_curvatures(contour, options);
    remove_mended(contour, options, result.unrepaired);
  }
  result.closed = std::move(closed);
  result.arcs = arc_changes(given, contour);
  result.moves = moves_between(given, contour);
  result.lost = lost_joins(given, contour, options, result.moves);
  return result;
}

std::string Arc_offer::text() const {
  if (moves_start || moves_end)
    return std::string(moves_start ? "the start (" : "the end (") + numbers[0] + ", " + numbers[1] + ')';
  return numbers[0] == numbers[1] ? "the radius " + numbers[0] : "the radii " + numbers[0] + ", " + numbers[1];
}

GC::Enclosure Handle_move::distance() const {
  return GC::sqrt_enclosure(difference(from, offset_from, to, offset_to).squared_length());
}

std::string rounded_up(double x) {
  std::ostringstream os;
  os.precision(4);
  os << GC::Enclosure{x, x}; // is rounded outwards
  const std::string text = os.str();
  const std::size_t comma = text.find(", ");
  return comma == std::string::npos ? text : text.substr(comma + 2, text.size() - comma - 3);
}

std::string units(const GC::Enclosure& distance) {
  const std::string number = rounded_up(distance.upper);
  return number + (number == "1" ? " unit" : " units");
}

std::int64_t longest_beside_grid(const Repair_options& options) {
  return options.harmonise ? GC::max_harmonised_coordinate / 2 : GC::max_handle_coordinate / 2;
}

std::string needs_coarser_grid(const Grid_contour& contour, const Repair_options& options) {
  const auto is_longer = [](const GC::Grid_vector& v, std::int64_t bound) { return largest_coordinate(v) > bound; };
  for (std::size_t j = 0; j < contour.number_of_joins(); ++j) {
    const std::optional<GC::Visual_class> grade = ::grade(contour, j, options.bound);
    const bool harmonises = options.harmonise && grade == GC::Visual_class::g1;
    if (grade != GC::Visual_class::kink && !harmonises) continue;
    for (const bool at_end : {true, false}) {
      const Grid_curve& c = contour.curves[at_end ? j : contour.next(j)];
      if (c.points.empty()) continue;
      const std::size_t n = c.points.size() - 1;
      if (is_line(c)) {
        if (!harmonises && is_longer(GC::primitive(c.points[n] - c.points[0]), GC::max_handle_coordinate))
          return "the direction of a line is longer than 2^28 units";
        continue;
      }
      const auto vector = [&](std::size_t k) {
        return at_end ? c.points[n] - c.points[n - k] : c.points[k] - c.points[0];
      };
      if (is_longer(vector(1), GC::max_handle_coordinate)) return "a handle is longer than 2^28 units";
      if (harmonises &&
          (is_longer(vector(1), GC::max_harmonised_coordinate) || is_longer(vector(2), GC::max_harmonised_coordinate)))
        return "a handle is longer than 2^25 units, too long for curvatures";
    }
  }
  return "";
}
