// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/run_along_v.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace {

template <class T> std::vector<std::vector<T>> transposed(const std::vector<std::vector<T>>& rows) {
  std::vector<std::vector<T>> columns(rows.empty() ? 0 : rows.front().size());
  for (const std::vector<T>& row : rows)
    for (std::size_t j = 0; j < row.size(); ++j) columns[j].push_back(row[j]);
  return columns;
}

void exchange_parameters(Shell_model::Surface& s) {
  std::swap(s.degree_u, s.degree_v);
  std::swap(s.knots_u, s.knots_v);
  s.points = transposed(s.points);
  s.weights = transposed(s.weights);
}

} // namespace

void run_along_v(Shell_model& model) {
  for (Shell_model::Face& face : model.faces) {
    if (face.surface.plane || face.surface.points.size() <= face.surface.points.front().size()) continue;
    exchange_parameters(face.surface);
    face.reversed = !face.reversed; // what ran counterclockwise runs clockwise now
    for (auto& loop : face.loops) {
      std::reverse(loop.begin(), loop.end());
      for (Shell_model::Use& use : loop) {
        use.reversed = !use.reversed;
        for (std::array<double, 2>& uv : use.curve.points) std::swap(uv[0], uv[1]);
      }
    }
  }
}
