// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_FIGURES_SVG_FIGURE_H
#define GEOMETRIC_CONTINUITY_FIGURES_SVG_FIGURE_H

#include <Geometric_continuity_figures/Svg_panel.h>
#include <Geometric_continuity_figures/internal/Svg_curvature_plots.h>
#include <Geometric_continuity_figures/internal/Svg_view.h>
#include <Geometric_continuity_figures/internal/svg_markup.h>
#include <Geometric_continuity_figures/internal/svg_text.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// A figure of curves that join, in one or more panels side by side, as a picture in the format
/// SVG.
///
/// All panels have one scale and one view, so that they can be compared. The scale is that of the
/// curves; a control polygon that leads far away leaves its panel. When all curves are planar the
/// `y`-axis points upwards; otherwise the panels show an axonometric view from above, with a grid
/// on the ground plane and the shadow of the curves on it, and planar curves have `z = 0`. Curves
/// up to degree 3 are drawn exactly, others by cubic pieces within 1/50 of a pixel.
///
/// Curves with a curvature plot are drawn, one after the other as they were added, in a plot of the
/// curvature against the arc length below their panel. It is signed in the plane: positive where
/// the curve turns left. All plots of a figure have one scale, whose numbers are those of the
/// coordinates that were given: arc lengths in their unit, curvatures in one by this unit.
///
/// The teeth of a curvature comb point away from the centre of curvature and are proportional to
/// the curvature, by one factor for the figure. By this factor nine tenths of the combed length
/// have teeth of at most 9 % of the size of the curves, and longer teeth are cut off at 18 %: they
/// are drawn paler, the line through the tips is interrupted there, and the legend says so. When
/// all teeth are shorter they are enlarged until the longest has this length. Each curve has its
/// own comb up to its ends, so that a jump of the curvature at a join is a step of the line. Where
/// the tangent is zero, and the curvature undefined, there is no tooth. The legend shows the length
/// of the tooth of a round curvature.
///
/// Labels do not overlap: where there is no room beside a join a label stands farther away,
/// connected by a line, and the legend counts those for which there is none.
class Svg_figure {
public:
  /// Constructs a figure without panels, which will have at most `columns` panels in a row. The
  /// title is plain text in UTF-8.
  /// \throws Error `negative_count` for a negative number of columns, `wrong_number_of_points` for
  ///   no columns
  explicit Svg_figure(std::string title = std::string(), int columns = 3)
      : title_(std::move(title)), columns_(columns) {
    if (columns < 0) throw Error(Error_code::negative_count, "Svg_figure: columns");
    if (columns == 0) throw Error(Error_code::wrong_number_of_points, "Svg_figure: no columns");
  }

  /// Appends a panel; returns the figure.
  Svg_figure& add(Svg_panel panel) {
    panels_.push_back(std::move(panel));
    return *this;
  }

  /// Adds a curve or a range of curves to the panel that was appended last, or to a first one
  /// without a caption, as `Svg_panel::add()` does; returns the figure.
  /// \throws Error as `Svg_panel::add()` does
  template <class Curve> Svg_figure& add(const Curve& curve, const Svg_style& style = Svg_style()) {
    if (panels_.empty()) panels_.emplace_back();
    panels_.back().add(curve, style);
    return *this;
  }

  /// Returns the number of panels.
  int number_of_panels() const { return static_cast<int>(panels_.size()); }

  /// Writes the picture as an SVG document in UTF-8. Linear in the number of curves.
  void write(std::ostream& os) const {
    write(os, [](std::size_t) {});
  }

  /// Writes the picture as an SVG document in UTF-8, and calls `report(n)` when `n` curves have
  /// been drawn, for each `n` from 1 on.
  template <class Report> void write(std::ostream& os, Report report) const {
    std::size_t drawn = 0;
    std::vector<Svg_panel> panels = panels_;
    std::vector<internal::Svg_curve*> curves;
    bool spatial = false;
    for (Svg_panel& panel : panels) {
      spatial = spatial || panel.spatial_;
      for (internal::Svg_curve& c : panel.curves_) curves.push_back(&c);
    }
    const double unit = internal::svg_normalise(curves);
    internal::svg_choose_samples(curves);

    const int columns = (std::max)(1, (std::min)(columns_, number_of_panels()));
    const double panel_width = (std::max)(260.0, (std::min)(560.0, (960.0 - gap * (columns - 1)) / columns));
    const internal::Svg_view view(curves, unit, spatial, panel_width);
    std::vector<const std::vector<internal::Svg_curve>*> curves_of_panels;
    for (const Svg_panel& panel : panels) curves_of_panels.push_back(&panel.curves_);
    const internal::Svg_curvature_plots plots(curves_of_panels, unit, spatial);
    const double width = columns * panel_width + (columns - 1) * gap + 2 * edge,
                 height = view.height() + plots.height(); // of a panel with its plot

    std::size_t without_room = 0; // labels
    double y = edge;              // of what comes next
    std::string body = internal::svg_title(title_, edge, width, y);
    if (!title_.empty()) y += 10;
    for (std::size_t first = 0; first < panels.size(); first += columns) {
      std::size_t lines = 0;
      for (std::size_t i = first; i < (std::min)(first + columns, panels.size()); ++i) {
        const double x = edge + static_cast<double>(i - first) * (panel_width + gap);
        body += picture(panels[i], view, x, y, without_room, [&] { report(++drawn); });
        body += plots.picture(i, x, y + view.height(), panel_width);
        const std::vector<std::string> caption = internal::wrapped_lines(panels[i].caption_, 12.5, panel_width);
        for (std::size_t j = 0; j < caption.size(); ++j)
          body += internal::svg_text(x + 0.5 * panel_width, y + height + 19 + 17.0 * static_cast<double>(j), 12.5,
                                     "#333333", "middle", caption[j]);
        lines = (std::max)(lines, caption.size());
      }
      y += height + 17.0 * static_cast<double>(lines) + 22;
    }
    body += legend(panels, view, plots, without_room, width, y);
    y += edge - 8;

    const std::string document = internal::svg_document(title_, width, y, body);
    os.write(document.data(), static_cast<std::streamsize>(document.size()));
  }

  /// Writes the picture as an SVG document in UTF-8.
  friend std::ostream& operator<<(std::ostream& os, const Svg_figure& figure) {
    figure.write(os);
    return os;
  }

private:
  static constexpr double edge = 24, gap = 20; // pixels around the figure and between panels
  static constexpr int per_tooth = 2;          // how many are computed for each that is drawn

  std::string title_;
  int columns_;
  std::vector<Svg_panel> panels_;

  // One panel with its upper left corner at (x, y), from the background to the foreground.
  template <class Report>
  static std::string picture(const Svg_panel& panel, const internal::Svg_view& view, double x, double y,
                             std::size_t& without_room, Report report) {
    using namespace internal;
    std::string s = "<svg x=\"" + svg_number(x) + "\" y=\"" + svg_number(y) + "\" width=\"" + svg_number(view.width()) +
                    "\" height=\"" + svg_number(view.height()) + "\">\n";
    if (view.spatial()) s += ground(panel, view);
    Svg_label_places places(view.width(), view.height());
    for (std::size_t k = 0; k < panel.curves_.size(); ++k) {
      const Svg_curve& c = panel.curves_[k];
      const std::vector<Svg_tooth> teeth = view.comb(c, per_tooth);
      const bool goes_on = k + 1 < panel.curves_.size() && panel.curves_[k + 1].continues;
      if (c.style.curvature_comb) s += comb(teeth, !c.continues, !goes_on, view);
      keep_free(places, c, teeth, view);
      report();
    }
    for (const Svg_curve& c : panel.curves_)
      if (c.polygon.size() > 1) s += svg_stroke(polygon_stroke, svg_polyline(view(c.polygon)));
    for (Svg_role role : {Svg_role::construction, Svg_role::given, Svg_role::result})
      for (const Svg_curve& c : panel.curves_)
        if (c.style.role == role) s += svg_stroke(stroke_of(role), svg_curve_path(view(c.points)));
    for (const Svg_curve& c : panel.curves_)
      for (const Svg_point& p : c.polygon) s += svg_disk(view(p), 2, polygon_stroke);
    for (const Svg_join& join : panel.joins_) {
      if (!join.is_marked) continue;
      const Svg_pixel p = view(panel.curves_[join.curve].points.back());
      s += svg_disk(p, 3.4, ring_stroke);
      places.take(p, svg_vector({4.0, 4.0}));
    }
    s += labels(panel, places, view, without_room);
    s += "<rect x=\".5\" y=\".5\" width=\"" + svg_number(view.width() - 1) + "\" height=\"" +
         svg_number(view.height() - 1) + "\" rx=\"3\" fill=\"none\" stroke=\"#e2e2e2\"/>\n";
    return s + "</svg>\n";
  }

  // The grid, the axes in its corner, the shadows, and plumb lines from the joins.
  static std::string ground(const Svg_panel& panel, const internal::Svg_view& view) {
    using namespace internal;
    const int nx = view.cells(0), ny = view.cells(1);
    std::string grid, shadow, plumb, axes, names;
    for (int i = 0; i <= nx; ++i) grid += svg_polyline({view(view.grid_point(i, 0)), view(view.grid_point(i, ny))});
    for (int j = 0; j <= ny; ++j) grid += svg_polyline({view(view.grid_point(0, j)), view(view.grid_point(nx, j))});
    for (const Svg_curve& c : panel.curves_) {
      std::vector<Svg_point> points;
      for (const Svg_point& p : c.points) points.push_back(view.ground(p));
      shadow += svg_curve_path(view(points));
    }
    for (const Svg_join& join : panel.joins_) {
      if (!join.is_marked) continue;
      const Svg_point p = panel.curves_[join.curve].points.back();
      plumb += svg_polyline({view(p), view(view.ground(p))});
    }
    const Svg_point origin = view.grid_point(0, 0);
    for (int i = 0; i < 3; ++i) {
      Svg_point tip = origin, beyond = origin;
      tip[i] += 0.8 * view.cell();
      beyond[i] += 1.1 * view.cell();
      axes += svg_polyline({view(origin), view(tip)});
      const Svg_pixel p = view(beyond);
      names += svg_text(p[0], p[1] + 3.5, 10, "#777777", "middle", std::string(1, "xyz"[i]), " font-style=\"italic\"");
    }
    const std::string plane = svg_polyline(
        {view(origin), view(view.grid_point(nx, 0)), view(view.grid_point(nx, ny)), view(view.grid_point(0, ny))});
    return "<path fill=\"#f7f7f7\" d=\"" + plane + "Z\"/>\n" + svg_stroke(grid_stroke, grid) +
           svg_stroke(shadow_stroke, shadow) + svg_stroke(plumb_stroke, plumb) + svg_stroke(axes_stroke, axes) + names;
  }

  // Returns whether the curve begins with the first tooth and ends with the last one.
  static std::string comb(const std::vector<internal::Svg_tooth>& teeth, bool begins, bool ends,
                          const internal::Svg_view& view) {
    using namespace internal;
    std::string lines, cut, envelope;
    std::vector<Svg_pixel> run; // tips of whole teeth in a row
    Svg_pixel drawn(2);         // the foot of the last tooth
    for (std::size_t i = 0; i < teeth.size(); ++i) {
      const Svg_pixel foot = view(teeth[i].foot), tip = view(teeth[i].tip);
      const bool end = (i == 0 && begins) || (i + 1 == teeth.size() && ends),
                 visible = svg_length(Svg_pixel(tip - foot)) > 0.5;
      const bool crowded = teeth[i].whole && !end && svg_length(Svg_pixel(foot - drawn)) < 2;
      if (i % per_tooth == 0 && visible && !crowded) {
        (!teeth[i].whole ? cut : end ? envelope : lines) += svg_polyline({foot, tip});
        drawn = foot;
      }
      if (teeth[i].whole) run.push_back(tip);
      if (!teeth[i].whole || i + 1 == teeth.size()) {
        envelope += svg_smooth_path(run);
        run.clear();
      }
    }
    return svg_stroke(cut_teeth_stroke, cut) + svg_stroke(teeth_stroke, lines) + svg_stroke(envelope_stroke, envelope);
  }

  // No label is to be where the curve, its comb and its polygon are.
  static void keep_free(internal::Svg_label_places& places, const internal::Svg_curve& c,
                        const std::vector<internal::Svg_tooth>& teeth, const internal::Svg_view& view) {
    for (const internal::Svg_tooth& t : teeth)
      places.add_segment(view(t.foot), view(c.style.curvature_comb ? t.tip : t.foot), 4);
    for (std::size_t j = 1; j < c.polygon.size(); ++j)
      places.add_segment(view(c.polygon[j - 1]), view(c.polygon[j]), 20);
  }

  // None where another is; those that are not beside their point are connected with it.
  static std::string labels(const Svg_panel& panel, internal::Svg_label_places& places, const internal::Svg_view& view,
                            std::size_t& without_room) {
    using namespace internal;
    std::string s, connections;
    for (const Svg_join& join : panel.joins_) {
      const Svg_pixel p = view(panel.curves_[join.curve].points.back());
      if (join.label.empty() || !places.is_in_panel(p)) continue;
      const double text_width = svg_text_width(join.label, 11);
      const std::optional<Svg_pixel> q = places.place(p, text_width);
      if (!q) {
        ++without_room;
        continue;
      }
      const Svg_pixel half = places.half_size(text_width), d = *q - p;
      places.take(*q, half + svg_vector({3.0, 2.0}));
      const double reach =
          // from the label to p
          (std::max)(std::abs(d[0]) / (half[0] + 2), std::abs(d[1]) / (half[1] + 2));
      if (svg_length(d) * (1 - 1 / reach) > 14)
        connections += svg_polyline({p + 4 / svg_length(d) * d, p + (1 - 1 / reach) * d});
      s += svg_text((*q)[0], (*q)[1] + 4, 11, "#222222", "middle", join.label,
                    " stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\"");
    }
    return svg_stroke(axes_stroke, connections) + s;
  }

  // Returns the legend of the styles in the panels, with samples, and moves y below it.
  static std::string legend(const std::vector<Svg_panel>& panels, const internal::Svg_view& view,
                            const internal::Svg_curvature_plots& plots, std::size_t without_room, double width,
                            double& y) {
    using namespace internal;
    std::vector<std::pair<Svg_role, std::string>> lines; // each once
    bool polygon = false, comb = false, join = false;
    for (const Svg_panel& panel : panels) {
      for (const Svg_join& j : panel.joins_)
        join = join || (j.is_marked && panel.curves_[j.curve].points.size() > 1); // no single point
      for (const Svg_curve& c : panel.curves_) {
        const std::pair<Svg_role, std::string> line(c.style.role, name_of(c.style));
        if (c.points.size() > 1 && std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
        polygon = polygon || c.style.control_polygon;
        comb = comb || c.style.curvature_comb;
      }
    }
    Svg_legend items;
    const std::string line = "M0 0L26 0";
    for (Svg_role role : {Svg_role::given, Svg_role::result, Svg_role::construction})
      for (const std::pair<Svg_role, std::string>& l : lines)
        if (l.first == role) items.add(l.second, svg_stroke(stroke_of(role), line));
    if (polygon)
      items.add("control polygon", svg_stroke(polygon_stroke, line) +
                                       svg_disk(svg_vector({0.0, 0.0}), 2, polygon_stroke) +
                                       svg_disk(svg_vector({26.0, 0.0}), 2, polygon_stroke));
    if (comb)
      items.add(view.comb_is_cut() ? "curvature comb (long teeth cut off)" : "curvature comb",
                svg_stroke(teeth_stroke, "M2 5L0 -3M7.5 4L6.5 -5M13 3.7L13 -6M18.5 4L19.5 -5M24 5L26 -3") +
                    svg_stroke(envelope_stroke, "M0 -3Q13 -9 26 -3"));
    if (const double longest = view.curvature_of_tooth(26); comb && longest > 0) {
      const Round_step step = round_step(longest);
      const std::string end = svg_number(26 * step.value() / longest);
      items.add("tooth of curvature " + step.text(1) + " (1/unit)",
                svg_stroke(envelope_stroke, "M0 0H" + end + "M0 -3V3M" + end + " -3V3"));
    }
    if (!plots.empty())
      items.add(plots.is_cut() ? "below: curvature \xce\xba (1/unit, cut off) against arc length s (units)"
                               : "below: curvature \xce\xba (1/unit) against arc length s (units)",
                svg_stroke(given_stroke, "M2 4C9 -10 16 8 24 -6"));
    if (join) items.add("join", svg_disk(svg_vector({19.0, 0.0}), 3.4, ring_stroke));
    if (without_room > 0)
      items.add(std::to_string(without_room) + (without_room == 1 ? " label has" : " labels have") + " no room",
                svg_disk(svg_vector({19.0, 0.0}), 3.4, ring_stroke));
    if (view.spatial()) items.add("shadow on the ground", svg_stroke(shadow_stroke, line));
    return items.lines(width, edge, y);
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_FIGURES_SVG_FIGURE_H
