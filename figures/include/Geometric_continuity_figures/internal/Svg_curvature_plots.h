// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_CURVATURE_PLOTS_H
#define GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_CURVATURE_PLOTS_H

#include <Geometric_continuity_figures/Svg_panel.h>
#include <Geometric_continuity_figures/internal/Svg_view.h>
#include <Geometric_continuity_figures/internal/svg_markup.h>
#include <Geometric_continuity_figures/internal/svg_text.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// \file Svg_curvature_plots.h
/// Plots of the curvature against the arc length, below the panels of a figure and with one scale
/// for all: signed in the plane.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

class Svg_curvature_plots {
  // The curves of one panel, one after the other.
  struct Line {
    Svg_role role;
    bool continues;                // the curve before it
    std::vector<Svg_pixel> points; // arc length from the start of the first curve, curvature
  };
  typedef std::vector<Line> Plot;

  // pixels; `above` lies between the panel and its plot, `left` and `below` leave room for numbers
  static constexpr double height_ = 104, above = 8, margin = 8, left = 40, below = 16;

  std::vector<Plot> plots_;      // one for each panel; empty where nothing is plotted
  double length_ = 0, most_ = 1; // of the curves; where none can be measured their curvature is 0
  double unit_;                  // of what was given
  bool is_signed_, any_ = false, cut_ = false;

public:
  // Takes curves that have been divided by `unit`.
  Svg_curvature_plots(const std::vector<const std::vector<Svg_curve>*>& panels, double unit, bool spatial)
      : unit_(unit), is_signed_(!spatial) {
    std::vector<std::pair<double, double>> weighted; // |curvature|, length of arc
    for (const std::vector<Svg_curve>* curves : panels) {
      plots_.emplace_back();
      double way = 0;
      for (const Svg_curve& c : *curves)
        if (c.style.curvature_plot && c.style.in_frame) plots_.back().push_back(line(c, way, weighted));
      any_ = any_ || !plots_.back().empty();
      length_ = (std::max)(length_, way);
    }
    choose_scale(weighted);
  }

  // Returns the height that a plot adds to a panel.
  double height() const { return any_ ? above + height_ : 0; }
  bool is_cut() const { return cut_; }
  bool empty() const { return !any_; }

  // The plot of the panel number i, below the panel whose lower left corner is (x, y).
  std::string picture(std::size_t i, double x, double y, double width) const {
    if (plots_[i].empty()) return std::string();
    const auto pixel = [&](const Svg_pixel& p) {
      const double inner = height_ - margin - below, k = (std::min)((std::max)(p[1] / most_, -1.), 1.);
      return svg_vector({left + (length_ > 0 ? p[0] / length_ : 0) * (width - left - margin),
                         is_signed_ ? margin + 0.5 * (1 - k) * inner : margin + (1 - k) * inner});
    };
    std::string s = "<svg x=\"" + svg_number(x) + "\" y=\"" + svg_number(y + above) + "\" width=\"" +
                    svg_number(width) + "\" height=\"" + svg_number(height_) + "\">\n";
    s += axes(pixel);
    std::string joins;
    for (std::size_t j = 1; j < plots_[i].size(); ++j) {
      if (plots_[i][j].continues) continue;
      const double way = plots_[i][j].points.front()[0];
      joins += svg_polyline({pixel(svg_vector({way, is_signed_ ? -most_ : 0.})), pixel(svg_vector({way, most_}))});
    }
    s += svg_stroke(plumb_stroke, joins);
    for (Svg_role role : {Svg_role::construction, Svg_role::given, Svg_role::result})
      for (const Line& l : plots_[i]) {
        std::vector<Svg_pixel> points;
        for (const Svg_pixel& p : l.points) points.push_back(pixel(p));
        if (l.role == role) s += svg_stroke(stroke_of(role), svg_polyline(points));
      }
    s += "<rect x=\".5\" y=\".5\" width=\"" + svg_number(width - 1) + "\" height=\"" + svg_number(height_ - 1) +
         "\" rx=\"3\" fill=\"none\" stroke=\"#e2e2e2\"/>\n";
    return s + "</svg>\n";
  }

private:
  // Lines and numbers, of what was given.
  template <class Pixel> std::string axes(Pixel pixel) const {
    constexpr double size = 9;
    const char* const colour = "#777777";
    std::string lines, numbers;
    const Round_step k = round_step(0.98 * most_ / unit_), s = round_step(length_ > 0 ? 0.3 * length_ * unit_ : 1);
    for (int n = is_signed_ ? -1 : 0; n <= 1; ++n) {
      const double curvature = n * k.value() * unit_;
      const Svg_pixel p = pixel(svg_vector({0., curvature}));
      lines += svg_polyline({p, pixel(svg_vector({length_, curvature}))});
      numbers += svg_text(left - 4, p[1] + 3, size, colour, "end", k.text(n));
    }
    const double lowest = is_signed_ ? -most_ : 0;
    for (int n = 0; n * s.value() <= 1.001 * length_ * unit_ && length_ > 0; ++n) {
      const Svg_pixel p = pixel(svg_vector({n * s.value() / unit_, lowest}));
      lines += svg_polyline({p, p + svg_vector({0., 3.})});
      numbers += svg_text(p[0], p[1] + 12, size, colour, "middle", s.text(n));
    }
    const Svg_pixel top = pixel(svg_vector({0., most_})), end = pixel(svg_vector({length_, lowest}));
    return svg_stroke(grid_stroke, lines) + numbers +
           svg_text(5, top[1] + 5, 10, colour, "start", "\xce\xba", " font-style=\"italic\"") +
           svg_text(end[0], end[1] - 3, 10, colour, "end", "s", " font-style=\"italic\"");
  }

  // Samples a curve that begins at the arc length `way`, and adds its length to this.
  Line line(const Svg_curve& curve, double& way, std::vector<std::pair<double, double>>& weighted) const {
    Line result{curve.style.role, curve.continues, {}};
    double speed = 0;
    for (int i = 0; i <= curve.samples; ++i) {
      const Coordinate_jet<double, 3> jet = polygon_jet(curve.points, i / double(curve.samples), 2);
      const double next = svg_length(jet[1]), step = i == 0 ? 0 : 0.5 * (speed + next) / curve.samples;
      speed = next;
      way += step;
      // equivalent [* -> +, 1]: how slow a curve is where its curvature is not plotted
      if (speed * speed < 1e-12) continue; // too slow to be measured
      double k = svg_length(*curvature_vector(jet));
      weighted.emplace_back(k, step);
      if (is_signed_ && jet[1][0] * jet[2][1] < jet[1][1] * jet[2][0]) k = -k;
      result.points.push_back(svg_vector({way, k}));
    }
    if (result.points.empty()) result.points.push_back(svg_vector({way, 0.}));
    return result;
  }

  // All is seen, unless a twentieth of the length has more than twice the curvature of the rest:
  // that is cut off.
  void choose_scale(std::vector<std::pair<double, double>>& weighted) {
    if (weighted.empty()) return;
    std::sort(weighted.begin(), weighted.end());
    double total = 0, sum = 0;
    for (const std::pair<double, double>& w : weighted) total += w.second;
    std::size_t i = 0;
    while ((sum += weighted[i].second) < 0.95 * total) ++i;
    const double flat = 1e-6; // straight for the eye, so that rounding errors are not magnified
    const double largest = (std::max)(weighted.back().first, flat), common = (std::max)(weighted[i].first, flat);
    cut_ = largest > 2 * common;
    most_ = 1.05 * (cut_ ? 2 * common : largest);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_CURVATURE_PLOTS_H
