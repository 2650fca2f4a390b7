// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_POINTS_POINTS_REPORT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_POINTS_POINTS_REPORT_H

#include "commands/chains/decided_join.h"
#include "commands/command_line.h"
#include "commands/curvature_options.h"
#include "commands/points/read_points.h"
#include "files/output.h"
#include "formats/shapes/write_shapes.h"

#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <Geometric_continuity_figures/Svg_figure.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// `interpolate` and `fit` have this in common: one file of points, a curve that may be closed, its
// joins, and where it is written.

// Refuses any other number of files, and outputs that cannot be written.
inline void check_points_arguments(const Command_line& line, const std::string& command) {
  if (line.files().size() != 1) throw std::invalid_argument(command + ": one file of points is needed; see --help");
  check_shape_output(line);
}

inline GC::Closure closure_of(const Command_line& line) {
  return line.has("closed") ? GC::Closure::closed : GC::Closure::open;
}

// Reads the points of the only file.
template <class FT> std::vector<typename Program_traits<FT>::Point> read_points(const Command_line& line) {
  const Arguments files = line.files();
  Input input(files[0]);
  return read_points<FT>(input, input_name(files[0]));
}

// Calls work(), and puts the name of the file before what it refuses.
template <class Work> auto with_name(const Command_line& line, Work work) {
  try {
    return work();
  } catch (const GC::Error& e) {
    if (e.code() == GC::Error_code::work_limit) throw;
    throw std::invalid_argument(input_name(line.files()[0]) + ": " + e.what());
  }
}

// A report on the curvature of curves, as they are written, if there is a bound: lines of text, or
// a member of a JSON object with a comma before it.
struct Bent_report {
  bool is_met = true;
  std::string text = {};
};
inline Bent_report bent_report(const Command_line& line, const std::string& curves) {
  const std::optional<Curvature_bound> bound = curvature_bound(line);
  if (!bound) return {};
  const Bent_curves bent = bent_curves(curves, *bound);
  std::ostringstream os;
  if (line.has("json"))
    write_json_member(os, bent, *bound);
  else
    write_text(os, bent, *bound);
  return {bent.is_met(), os.str()};
}

// Writes curves as they are, and draws them with the lines from point to point, where that is asked
// for.
template <class Traits>
void write_curves(const Command_line& line, const std::string& text, std::vector<typename Traits::Point> points,
                  const std::string& name) {
  if (line.has("output")) write_shapes(line, [&](std::ostream& os) { os << text; });
  if (!line.has("plot")) return;
  GC::Svg_panel panel;
  if (closure_of(line) == GC::Closure::closed) points.push_back(points.front());
  for (auto p = points.begin(); p + 1 != points.end(); ++p) panel.add(GC::Bezier_curve<Traits>(p, p + 2));
  std::istringstream is(text);
  GC::G2_piece_reader<Program_traits<Exact>> reader(is, "what is written");
  while (const std::optional<Exact_curve> piece = reader.next())
    panel.add(*piece, GC::Svg_style{GC::Svg_role::result, false, true, name}).join();
  write_output(line.text("plot"), [&](std::ostream& os) { os << GC::Svg_figure().add(panel); });
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_POINTS_POINTS_REPORT_H
