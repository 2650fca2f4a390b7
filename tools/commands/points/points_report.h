// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_POINTS_POINTS_REPORT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_POINTS_POINTS_REPORT_H

#include "commands/command_line.h"
#include "commands/points/read_points.h"

#include <CGAL/Geometric_continuity/IO/figures/Svg_figure.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

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

// The lines from point to point, for a picture.
template <class Traits>
void add_polyline(GC::Svg_panel& panel, std::vector<typename Traits::Point> points, bool closed) {
  if (closed) points.push_back(points.front());
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    panel.add(GC::Bezier_curve<Traits>(points.begin() + static_cast<std::ptrdiff_t>(k),
                                       points.begin() + static_cast<std::ptrdiff_t>(k) + 2));
}

// The orders of the joins of pieces that are added one after the other, decided exactly.
class Joins_of_pieces {
  GC::Chain_analysis<Exact_curve> chain_{2};
  std::vector<bool> is_corner_; // at the start of the piece of this number
  std::size_t corners_ = 0;
  int c_order_ = 2, g_order_ = 2;

  void count(const GC::Chain_join<Exact_curve>& join) {
    if (join.right < is_corner_.size() && is_corner_[join.right]) {
      ++corners_;
      return;
    }
    c_order_ = (std::min)(c_order_, join.continuity.c_order);
    g_order_ = (std::min)(g_order_, join.continuity.g_order);
  }

public:
  explicit Joins_of_pieces(std::vector<bool> is_corner = {}) : is_corner_(std::move(is_corner)) {}

  void add(const Exact_curve& piece) {
    chain_.add(piece, [this](const auto& join) { count(join); });
  }
  void close() {
    chain_.close([this](const auto& join) { count(join); });
  }

  std::size_t pieces() const { return chain_.size(); }
  std::size_t joins() const { return chain_.summary().joins() - corners_; } // but for corners
  int c_order() const { return c_order_; }
  int g_order() const { return g_order_; }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_POINTS_POINTS_REPORT_H
