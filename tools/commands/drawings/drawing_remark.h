// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_DRAWING_REMARK_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_DRAWING_REMARK_H

#include "commands/chains/join_report.h"
#include "commands/drawings/drawing_kink.h"
#include "formats/svg/svg_drawing.h"

#include <CGAL/Geometric_continuity/joins/path_continuity.h>

#include <cmath>
#include <optional>
#include <string>

// A reader wants to know this about a join of a drawing, in words.

typedef GC::Svg_segment<Drawing_traits> Drawing_segment;
typedef GC::Curve_jet<Program_traits<Exact>> Drawing_jet;

// A jet for the numbers of a report, for which square roots and rotations are rounded.
inline Exact rounded_root(const GC::Path_segment<Drawing_traits>& segment) {
  return Exact(std::sqrt(CGAL::to_double(segment.radicand())));
}

inline Drawing_jet report_jet(const GC::Coordinate_jet<Exact, 2>& jet) {
  GC::Coordinate_jet<Exact, 0> result(2, 3);
  for (int j = 0; j <= 3; ++j)
    for (int i = 0; i < 2; ++i) result[j][i] = jet[j][i];
  return Drawing_jet(result);
}

inline Drawing_jet rounded_end_jet(const GC::Path_segment<Drawing_traits>& given) {
  const GC::Path_segment<Drawing_traits> segment = given.rounded();
  return report_jet(segment.end_jet_over<Exact>(3, rounded_root(segment)));
}

inline Drawing_jet rounded_start_jet(const GC::Path_segment<Drawing_traits>& given) {
  const GC::Path_segment<Drawing_traits> segment = given.rounded();
  return report_jet(segment.start_jet_over<Exact>(3, rounded_root(segment)));
}

inline double length(const Drawing_segment& line) {
  return std::sqrt(CGAL::to_double((line.end() - line.start()).squared_length()));
}

// Says what the segments of a join are, as far as that explains a remark.
inline std::string explanation(const GC::Join_continuity<Exact>& join, const Drawing_segment& left,
                               const Drawing_segment& right) {
  std::string s;
  if (!join.regular) s += ", a handle is at the node";
  for (const Drawing_segment* segment : {&left, &right})
    if (segment->letter == 'Z' || segment->letter == 'z')
      s += ", the closing line is " + rounded(length(*segment), 4) + " long";
  return s;
}

// Returns remark() of the join.
inline std::string drawing_remark(const Join& decision, const Drawing_join& join) {
  std::optional<std::string> words;
  GC::visit_enclosures(join, [&](const auto& x, const auto& y) { words = remark(decision, x, y); });
  return words ? *words : remark(decision, rounded_end_jet(join.left()), rounded_start_jet(join.right()));
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_DRAWINGS_DRAWING_REMARK_H
