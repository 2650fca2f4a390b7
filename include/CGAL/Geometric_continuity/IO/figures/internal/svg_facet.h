// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_FACET_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_FACET_H

#include <CGAL/Geometric_continuity/IO/figures/internal/svg_markup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

/// \file svg_facet.h
/// One of the small quadrangles of which a picture of surfaces consists, its parts and its outline.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A colour between two, x from 0 to 1, as #rrggbb.
inline std::string svg_mix(const std::array<int, 3>& from, const std::array<int, 3>& to, double x) {
  char text[8];
  std::array<int, 3> c;
  for (int i = 0; i < 3; ++i)
    c[i] = static_cast<int>(std::lround(from[i] + (std::min)(1.0, (std::max)(0.0, x)) * (to[i] - from[i])));
  std::snprintf(text, sizeof text, "#%02x%02x%02x", c[0], c[1], c[2]);
  return text;
}

// In tenths of a pixel: the first point, then steps.
inline std::string svg_outline(const std::vector<Svg_pixel>& polygon) {
  std::string path;
  long x = 0, y = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const long i = std::lround(10 * polygon[k][0]), j = std::lround(10 * polygon[k][1]);
    if (k > 0 && i == x && j == y) continue;
    const char* separator = path.empty() ? "M" : path.find('l') == std::string::npos ? "l" : i < x ? "" : " ";
    path += separator + std::to_string(i - x) + (j < y ? "" : " ") + std::to_string(j - y);
    x = i;
    y = j;
  }
  return path.empty() ? path : path + 'z';
}

// A quadrangle, its corners in turn.
struct Svg_facet {
  std::array<Svg_pixel, 4> corner;
  std::array<double, 4> depth; // in pixels, greater where it is nearer
  std::array<double, 4> angle; // of the normal and the light, from 0 to 1
  double shade = 0;            // from 0 for dark to 1 for bright
  double twist = 0;            // how far in depth it is from flat
  bool partly_hidden = false;

  double nearness() const { return 0.25 * (depth[0] + depth[1] + depth[2] + depth[3]); }

  // The part number i, j of n times n.
  Svg_facet part(int i, int j, int n) const {
    Svg_facet result = *this;
    for (int k = 0; k < 4; ++k) {
      const double x = (i + (k == 1 || k == 2)) / double(n), y = (j + (k >= 2)) / double(n);
      const double weight[] = {(1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y};
      result.corner[k] = Svg_pixel(2);
      result.depth[k] = result.angle[k] = 0;
      for (int l = 0; l < 4; ++l) {
        result.corner[k] += weight[l] * corner[l];
        result.depth[k] += weight[l] * depth[l];
        result.angle[k] += weight[l] * angle[l];
      }
    }
    return result;
  }

  // The part where the angle is between two.
  std::vector<Svg_pixel> between(double low, double high) const {
    std::vector<std::pair<Svg_pixel, double>> polygon;
    for (int i = 0; i < 4; ++i) polygon.emplace_back(corner[i], angle[i]);
    for (int sign : {1, -1}) {
      const double limit = sign > 0 ? low : high;
      std::vector<std::pair<Svg_pixel, double>> cut;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double x = sign * (a.second - limit), y = sign * (b.second - limit);
        if (x >= 0) cut.push_back(a);
        if ((x < 0 && y > 0) || (x > 0 && y < 0)) cut.emplace_back(a.first + x / (x - y) * (b.first - a.first), limit);
      }
      polygon = std::move(cut);
    }
    std::vector<Svg_pixel> result;
    for (const auto& p : polygon) result.push_back(p.first);
    return result;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_FACET_H
