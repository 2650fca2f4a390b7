// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_CONTOURS_H
#define GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_CONTOURS_H

#include <Geometric_continuity_figures/internal/Svg_view.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

/// \file Svg_contours.h
/// Lines through grids that separate what is inside from what is outside, and lines with as few
/// points as a tolerance allows.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Between two nodes of a grid, by their numbers: the second is beside or below the first.
struct Grid_crossing {
  std::size_t first, second;
};

struct Grid_line {
  std::vector<Grid_crossing> crossings;
  bool closed;
};

// The lines through these cells of a grid between nodes that are inside and neighbours that are
// not, with the inside on one side. A cell has the number of its first node, j * columns + i. Lines
// that are not closed end at the border. Linear in the number of cells.
template <class Inside>
std::vector<Grid_line> grid_contours(int columns, const std::vector<std::size_t>& cells, Inside inside) {
  // of crossings, by their numbers: twice that of the first node
  std::unordered_map<std::size_t, std::size_t> next;
  std::unordered_set<std::size_t> has_before;
  std::vector<std::size_t> in_order;
  const std::size_t below = static_cast<std::size_t>(columns);
  for (const std::size_t cell : cells) {
    const std::array<bool, 4> in = {inside(cell), inside(cell + 1), inside(cell + below + 1),
                                    inside(cell + below)}; // in turn
    const std::array<std::size_t, 4> side = {2 * cell, 2 * (cell + 1) + 1, 2 * (cell + below), 2 * cell + 1};
    for (std::size_t k = 0; k < 4; ++k) {
      if (!in[k] || in[(k + 1) % 4]) continue;
      std::size_t m = (k + 1) % 4;
      while (!in[(m + 1) % 4]) m = (m + 1) % 4;
      next[side[k]] = side[m];
      has_before.insert(side[m]);
      in_order.push_back(side[k]);
    }
  }

  std::vector<Grid_line> lines;
  const auto follow = [&](std::size_t first, bool closed) {
    Grid_line line{{}, closed};
    for (std::size_t k = first;;) {
      line.crossings.push_back({k / 2, k / 2 + (k % 2 == 1 ? below : 1)});
      const auto found = next.find(k);
      if (found == next.end()) break;
      k = found->second;
      next.erase(found);
      if (k == first) break;
    }
    lines.push_back(std::move(line));
  };
  for (const std::size_t k : in_order)
    if (has_before.count(k) == 0) follow(k, false);
  for (const std::size_t k : in_order)
    if (next.count(k) > 0) follow(k, true);
  return lines;
}

// The line without points that are within their tolerance of the chord of those around them that
// stay (Douglas and Peucker).
inline std::vector<Svg_pixel> svg_simplified(const std::vector<Svg_pixel>& points,
                                             const std::vector<double>& tolerances, bool closed) {
  const std::size_t n = points.size();
  if (n < 3) return points;
  const auto at = [&](std::size_t i) -> const Svg_pixel& { return points[i == n ? 0 : i]; };
  std::vector<bool> stays(n + 1, false);
  stays[0] = stays[closed ? n : n - 1] = true;
  std::vector<std::pair<std::size_t, std::size_t>> chords;
  if (closed) {
    const auto farthest = std::max_element(points.begin(), points.end(), [&](const Svg_pixel& p, const Svg_pixel& q) {
      return svg_length(Svg_pixel(p - points[0])) < svg_length(Svg_pixel(q - points[0]));
    });
    const std::size_t middle = static_cast<std::size_t>(farthest - points.begin());
    stays[middle] = true;
    chords = {{0, middle}, {middle, n}};
  } else
    chords = {{0, n - 1}};
  while (!chords.empty()) {
    const auto [first, last] = chords.back();
    chords.pop_back();
    const Svg_pixel chord = at(last) - at(first);
    const double length = svg_length(chord);
    double most = 1; // of the distance by the tolerance
    std::size_t farthest = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const Svg_pixel d = at(i) - at(first);
      const double along = length > 0 ? (std::min)(length, (std::max)(0.0, dot(d, chord) / length)) : 0;
      const double distance = svg_length(length > 0 ? Svg_pixel(d - along / length * chord) : d) / tolerances[i];
      if (distance > most) {
        most = distance;
        farthest = i;
      }
    }
    if (farthest == first) continue;
    stays[farthest] = true;
    chords.emplace_back(first, farthest);
    chords.emplace_back(farthest, last);
  }
  std::vector<Svg_pixel> result;
  for (std::size_t i = 0; i < n; ++i)
    if (stays[i]) result.push_back(points[i]);
  return result;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_CONTOURS_H
