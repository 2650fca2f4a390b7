// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_LABEL_PLACES_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_LABEL_PLACES_H

#include <CGAL/Geometric_continuity/IO/figures/internal/Svg_view.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// What is drawn in a panel, as points, and the places that it leaves for labels. The points are kept in square cells, so
// that a label looks only at those around it. What lies outside of the panel is farther from a label than the edge.
class Svg_label_places {
  static constexpr double cell = 2;               // pixels
  static constexpr std::size_t most_in_cell = 16; // more are not seen to make a difference
  static constexpr double far_away = 12;          // pixels; farther is not better

  double width_, height_;
  std::size_t columns_;
  std::vector<std::vector<Svg_pixel>> cells_;

public:
  Svg_label_places(double width, double height)
      : width_(width), height_(height), columns_(number(width) + 1), cells_(columns_ * (number(height) + 1)) {}

  void add_point(const Svg_pixel& p) {
    if (!(0 <= p[0] && p[0] <= width_ && 0 <= p[1] && p[1] <= height_)) return;
    std::vector<Svg_pixel>& points = cells_[number(p[1]) * columns_ + number(p[0])];
    if (points.size() < most_in_cell) points.push_back(p);
  }

  void add_segment(const Svg_pixel& p, const Svg_pixel& q, int pieces) {
    for (int i = 0; i <= pieces; ++i) add_point(p + i / double(pieces) * (q - p));
  }

  // Where a label beside p is farthest from all that is drawn and from the edge of the panel, among eight places.
  Svg_pixel place(const Svg_pixel& p, double text_width) const {
    const Svg_pixel half = svg_vector({0.5 * text_width, 4.5});
    Svg_pixel best = p;
    double best_distance = -1e6;
    for (const Svg_pixel& d :
         {svg_vector({0.0, -1.0}), svg_vector({0.0, 1.0}), svg_vector({1.0, 0.0}), svg_vector({-1.0, 0.0}),
          svg_vector({0.7, -0.8}), svg_vector({-0.7, -0.8}), svg_vector({0.7, 0.8}), svg_vector({-0.7, 0.8})}) {
      const Svg_pixel q = p + svg_vector({d[0] * (half[0] + 8), d[1] * (half[1] + 8)});
      const double distance = free_distance(q, half, best_distance);
      if (distance > best_distance) {
        best = q;
        best_distance = distance;
      }
    }
    return best;
  }

private:
  static std::size_t number(double x) { return static_cast<std::size_t>(x / cell); }

  // The distance of the box with this centre from what is drawn and from the edge, negative beyond the edge. Once it is not
  // greater than `enough`, it need not be exact.
  double free_distance(const Svg_pixel& centre, const Svg_pixel& half, double enough) const {
    const double low_x = centre[0] - half[0], high_x = centre[0] + half[0], low_y = centre[1] - half[1],
                 high_y = centre[1] + half[1];
    double distance = (std::min)({far_away, low_x - 2, width_ - high_x - 2, low_y - 2, height_ - high_y - 2});
    const double least = (std::max)(0.0, enough);
    const auto look_around = [&](double reach) {
      const std::size_t first = number((std::max)(0.0, low_x - reach)),
                        last = number((std::min)(width_, high_x + reach)),
                        end = number((std::min)(height_, high_y + reach));
      for (std::size_t y = number((std::max)(0.0, low_y - reach)); y <= end; ++y)
        for (std::size_t x = first; x <= last; ++x)
          for (const Svg_pixel& o : cells_[y * columns_ + x]) {
            const Svg_pixel away = svg_vector({(std::max)(0.0, std::abs(o[0] - centre[0]) - half[0]),
                                               (std::max)(0.0, std::abs(o[1] - centre[1]) - half[1])});
            distance = (std::min)(distance, svg_length(away));
            if (distance <= least) return;
          }
    };
    if (distance > least) look_around(0); // where most boxes are found to be taken
    if (distance > least) look_around(distance);
    return distance;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_LABEL_PLACES_H
