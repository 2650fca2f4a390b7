// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_RASTER_H
#define GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_RASTER_H

#include <Geometric_continuity_figures/internal/Svg_contours.h>
#include <Geometric_continuity_figures/internal/Svg_view.h>
#include <Geometric_continuity_figures/internal/svg_markup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

/// \file Svg_raster.h
/// The parts of many triangles that are nearest to the viewer, on a grid of samples, and the
/// regions of the picture where a value that varies along it exceeds a level, bounded by contours.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A corner of a triangle: where it is in the picture, how near it is, and the value there, at
// least 0.
struct Svg_corner {
  Svg_pixel place;
  double depth; // greater where it is nearer
  double value;
};

class Svg_raster {
  static constexpr double per_pixel = 2; // samples
  static constexpr double empty = -1;    // the value where nothing is
  static constexpr double nothing = -(std::numeric_limits<double>::max)();

  int columns_, rows_; // with a border in which nothing is
  std::vector<double> depth_, value_;

public:
  Svg_raster(double width, double height)
      : columns_(3 + static_cast<int>(per_pixel * width)), rows_(3 + static_cast<int>(per_pixel * height)),
        depth_(static_cast<std::size_t>(columns_) * rows_, nothing), value_(depth_.size(), empty) {}

  void add(const Svg_corner& p, const Svg_corner& q, const Svg_corner& r) {
    const Svg_pixel a = q.place - p.place, b = r.place - p.place;
    const double area = a[0] * b[1] - a[1] * b[0];
    if (area == 0) return;
    const auto range = [&](int axis, int size) {
      const double low = (std::min)({p.place[axis], q.place[axis], r.place[axis]}),
                   high = (std::max)({p.place[axis], q.place[axis], r.place[axis]});
      return std::make_pair((std::max)(1, static_cast<int>(std::floor(per_pixel * low)) + 1),
                            (std::min)(size - 2, static_cast<int>(std::ceil(per_pixel * high)) + 1));
    };
    const auto x = range(0, columns_), y = range(1, rows_);
    // barycentric coordinates s, t, and their steps to the right
    const double step_s = b[1] / area / per_pixel, step_t = -a[1] / area / per_pixel;
    for (int j = y.first; j <= y.second; ++j) {
      const double dx = (x.first - 1) / per_pixel - p.place[0], dy = (j - 1) / per_pixel - p.place[1];
      double s = (dx * b[1] - dy * b[0]) / area, t = (a[0] * dy - a[1] * dx) / area;
      for (std::size_t k = at(x.first, j), end = at(x.second, j); k <= end; ++k, s += step_s, t += step_t) {
        if (!(s >= -rounding && t >= -rounding && s + t <= 1 + rounding)) continue;
        const double depth = p.depth + s * (q.depth - p.depth) + t * (r.depth - p.depth);
        if (!(depth > depth_[k])) continue;
        depth_[k] = depth;
        value_[k] = (std::max)(0.0, p.value + s * (q.value - p.value) + t * (r.value - p.value));
      }
    }
  }

  // Closes cracks between surfaces, which are thinner than a sample.
  void close_cracks() {
    for (int j = 1; j + 1 < rows_; ++j)
      for (int i = 1; i + 1 < columns_; ++i)
        for (std::size_t step : {std::size_t(1), static_cast<std::size_t>(columns_)}) {
          const std::size_t k = at(i, j), before = k - step, after = k + step;
          const double around = (std::min)(depth_[before], depth_[after]);
          if (around == nothing || depth_[k] != nothing) continue;
          depth_[k] = around;
          value_[k] = value_[before];
        }
  }

  // The farthest of what is nearest around a place.
  double depth_around(const Svg_pixel& p) const {
    const int x = static_cast<int>(std::lround(per_pixel * p[0])) + 1,
              y = static_cast<int>(std::lround(per_pixel * p[1])) + 1;
    // unreachable: protects memory; the margin is wider than what a line between the corners of
    //   facets can leave them
    if (x < 1 || y < 1 || x + 1 >= columns_ || y + 1 >= rows_) return nothing;
    double result = (std::numeric_limits<double>::max)();
    for (int j = y - 1; j <= y + 1; ++j)
      for (int i = x - 1; i <= x + 1; ++i) result = (std::min)(result, depth_[at(i, j)]);
    return result;
  }

  // For each k < levels: the outlines of where something is and its value is at least k / levels,
  // in tenths of a pixel, to be filled by the rule evenodd. Where the value varies by less than
  // `jump` from sample to sample they are contours, else the edges of what hides something.
  std::vector<std::string> regions(int levels, double jump) const {
    std::vector<int> level(value_.size()); // the highest one that is reached
    for (std::size_t k = 0; k < level.size(); ++k)
      level[k] = value_[k] == empty ? -1 : (std::min)(levels - 1, static_cast<int>(value_[k] * levels));
    // that are crossed
    std::vector<std::vector<std::size_t>> cells(static_cast<std::size_t>(levels));
    const std::size_t below = static_cast<std::size_t>(columns_);
    for (std::size_t k = 0; k + below + 1 < level.size(); ++k) {
      const int a = level[k], b = level[k + 1], c = level[k + below], d = level[k + below + 1];
      if (a == b && a == c && a == d) continue;
      for (int l = (std::min)({a, b, c, d}) + 1; l <= (std::max)({a, b, c, d}); ++l)
        cells[static_cast<std::size_t>(l)].push_back(k);
    }
    std::vector<std::string> result;
    for (int l = 0; l < levels; ++l)
      result.push_back(outlines(cells[static_cast<std::size_t>(l)], level, l, l / double(levels), jump));
    return result;
  }

private:
  static constexpr double rounding = 1e-9;

  std::size_t at(int i, int j) const { return static_cast<std::size_t>(j) * columns_ + i; }

  std::string outlines(const std::vector<std::size_t>& cells, const std::vector<int>& level, int l, double limit,
                       double jump) const {
    constexpr double least_area = 1; // square pixels; what is smaller is a speck
    std::string path;
    for (const Grid_line& line : grid_contours(columns_, cells, [&](std::size_t k) { return level[k] >= l; })) {
      std::vector<Svg_pixel> points;
      std::vector<double> tolerances;
      for (const Grid_crossing& c : line.crossings) {
        const double a = value_[c.first], b = value_[c.second];
        const bool is_contour = a != empty && b != empty && std::abs(b - a) < jump;
        points.push_back(place(c, is_contour ? (limit - a) / (b - a) : 0.5));
        tolerances.push_back(is_contour ? 0.08 : 0.35);
      }
      double area = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Svg_pixel p = points[i] - points[0], q = points[(i + 1) % points.size()] - points[0];
        area += 0.5 * (p[0] * q[1] - p[1] * q[0]);
      }
      if (std::abs(area) >= least_area) path += svg_outline(svg_simplified(points, tolerances, true));
    }
    return path;
  }

  Svg_pixel place(const Grid_crossing& c, double t) const {
    const std::size_t columns = static_cast<std::size_t>(columns_);
    const double x = static_cast<double>(c.first % columns), y = static_cast<double>(c.first / columns);
    const bool beside = c.second == c.first + 1;
    return svg_vector({(x + (beside ? t : 0) - 1) / per_pixel, (y + (beside ? 0 : t) - 1) / per_pixel});
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_RASTER_H
