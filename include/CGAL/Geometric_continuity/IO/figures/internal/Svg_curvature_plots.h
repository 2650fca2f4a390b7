// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_CURVATURE_PLOTS_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_CURVATURE_PLOTS_H

#include <CGAL/Geometric_continuity/IO/figures/Svg_panel.h>
#include <CGAL/Geometric_continuity/IO/figures/internal/Svg_view.h>
#include <CGAL/Geometric_continuity/IO/figures/internal/svg_markup.h>
#include <CGAL/Geometric_continuity/IO/figures/internal/svg_text.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// \file Svg_curvature_plots.h
/// Plots of the curvature against the arc length, below the panels of a figure and with one scale for all: signed in the plane.

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

  static constexpr double height_ = 84, above = 8, margin = 8; // pixels; `above` lies between the panel and its plot

  std::vector<Plot> plots_; // one for each panel; empty where nothing is plotted
  double length_ = 0, most_ = 0;
  bool is_signed_, any_ = false, cut_ = false;

public:
  // Of normalised curves.
  Svg_curvature_plots(const std::vector<const std::vector<Svg_curve>*>& panels, bool spatial) : is_signed_(!spatial) {
    std::vector<std::pair<double, double>> weighted; // |curvature|, length of arc
    for (const std::vector<Svg_curve>* curves : panels) {
      plots_.emplace_back();
      double way = 0;
      for (const Svg_curve& c : *curves)
        if (c.style.curvature_plot) plots_.back().push_back(line(c, way, weighted));
      any_ = any_ || !plots_.back().empty();
      length_ = (std::max)(length_, way);
    }
    choose_scale(weighted);
  }

  // What a plot adds to the height of a panel.
  double height() const { return any_ ? above + height_ : 0; }
  bool is_cut() const { return cut_; }
  bool empty() const { return !any_; }

  // The plot of the panel number i, below the panel whose lower left corner is (x, y).
  std::string picture(std::size_t i, double x, double y, double width) const {
    if (plots_[i].empty()) return std::string();
    const auto pixel = [&](const Svg_pixel& p) {
      const double inner = height_ - 2 * margin, k = (std::min)((std::max)(p[1] / most_, -1.), 1.);
      return svg_vector({margin + (length_ > 0 ? p[0] / length_ : 0) * (width - 2 * margin),
                         is_signed_ ? margin + 0.5 * (1 - k) * inner : margin + (1 - k) * inner});
    };
    std::string s = "<svg x=\"" + svg_number(x) + "\" y=\"" + svg_number(y + above) + "\" width=\"" +
                    svg_number(width) + "\" height=\"" + svg_number(height_) + "\">\n";
    s += svg_stroke(grid_stroke, svg_polyline({pixel(svg_vector({0., 0.})), pixel(svg_vector({length_, 0.}))}));
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
    s += svg_text(margin, margin + 5, 10, "#777777", "start", "\xce\xba(s)", " font-style=\"italic\"");
    s += "<rect x=\".5\" y=\".5\" width=\"" + svg_number(width - 1) + "\" height=\"" + svg_number(height_ - 1) +
         "\" rx=\"3\" fill=\"none\" stroke=\"#e2e2e2\"/>\n";
    return s + "</svg>\n";
  }

private:
  // Samples a curve that begins at the arc length `way`, and adds its length to this.
  Line line(const Svg_curve& curve, double& way, std::vector<std::pair<double, double>>& weighted) const {
    Line result{curve.style.role, curve.continues, {}};
    double speed = 0;
    for (int i = 0; i <= curve.samples; ++i) {
      const Coordinate_jet<double, 3> jet = polygon_jet(curve.points, i / double(curve.samples), 2);
      const double next = svg_length(jet[1]), step = i == 0 ? 0 : 0.5 * (speed + next) / curve.samples;
      speed = next;
      way += step;
      if (speed * speed < 1e-12) continue; // too slow to be measured
      double k = svg_length(*curvature_vector(jet));
      weighted.emplace_back(k, step);
      if (is_signed_ && jet[1][0] * jet[2][1] < jet[1][1] * jet[2][0]) k = -k;
      result.points.push_back(svg_vector({way, k}));
    }
    if (result.points.empty()) result.points.push_back(svg_vector({way, 0.}));
    return result;
  }

  // All is seen, unless a twentieth of the length has more than twice the curvature of the rest: that is cut off.
  void choose_scale(std::vector<std::pair<double, double>>& weighted) {
    if (weighted.empty()) return;
    std::sort(weighted.begin(), weighted.end());
    double total = 0, sum = 0;
    for (const std::pair<double, double>& w : weighted) total += w.second;
    std::size_t i = 0;
    while (i + 1 < weighted.size() && (sum += weighted[i].second) < 0.95 * total) ++i;
    const double flat = 1e-6; // straight for the eye, so that rounding errors are not magnified
    const double largest = (std::max)(weighted.back().first, flat), common = (std::max)(weighted[i].first, flat);
    cut_ = largest > 2 * common;
    most_ = 1.05 * (cut_ ? 2 * common : largest);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_CURVATURE_PLOTS_H
