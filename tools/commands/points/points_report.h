// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_POINTS_POINTS_REPORT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_POINTS_POINTS_REPORT_H

#include "commands/command_line.h"
#include "commands/points/read_points.h"
#include "files/output.h"

#include <CGAL/Geometric_continuity/IO/figures/Svg_figure.h>

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
  check_outputs(line);
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

// The pieces of a curve, and the joins between them that are no corners.
struct Joins_of_pieces {
  std::size_t pieces = 0, joins = 0;
  int c_order = 2, g_order = 2;       // of all joins, 2 at most
  std::size_t not_c2 = 0, not_g2 = 0; // joins
};

// Decides the joins of the pieces of curves that are written, .g2, exactly on numbers that a
// `Number` holds as they stand there. At the starts of the pieces with the numbers `corners`, in
// increasing order, are corners.
template <class Number>
Joins_of_pieces decide_joins(const std::string& text, GC::Closure closure, const std::vector<int>& corners = {}) {
  typedef Program_span<Number> Span;
  std::istringstream is(text);
  GC::G2_span_reader<Program_traits<Exact>, Number> reader(is, "what is written", 3);
  Joins_of_pieces result;
  const auto decide = [&](const Span& left, const Span& right, std::size_t number) {
    if (std::binary_search(corners.begin(), corners.end(), static_cast<int>(number))) return;
    const GC::Join_continuity<Exact> join = continuity_orders(left, right, 2);
    ++result.joins;
    result.c_order = (std::min)(result.c_order, join.c_order);
    result.g_order = (std::min)(result.g_order, join.g_order);
    result.not_c2 += join.c_order < 2;
    result.not_g2 += join.g_order < 2;
  };
  Span first, last;
  for (Span next; reader.next(next); ++result.pieces) {
    if (result.pieces == 0)
      first = next;
    else
      decide(last, next, result.pieces);
    std::swap(last, next);
  }
  if (closure == GC::Closure::closed) decide(last, first, 0);
  return result;
}

// Writes curves as they are, and draws them with the lines from point to point, where that is asked
// for.
template <class Traits>
void write_curves(const Command_line& line, const std::string& text, std::vector<typename Traits::Point> points,
                  const std::string& name) {
  if (line.has("output")) write_output(line.text("output"), [&](std::ostream& os) { os << text; });
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
