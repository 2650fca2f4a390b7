// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/chains/decided_join.h"
#include "commands/command_line.h"
#include "commands/surfaces_hint.h"
#include "files/output.h"
#include "files/progress.h"

#include <CGAL/Geometric_continuity/extensions/alternatives.h>
#include <Geometric_continuity_figures/Svg_figure.h>

namespace {

const char* const plot_usage = R"(usage: geometric_continuity plot FILE.g2... -o OUT.svg [OPTIONS]

Draws the chain of curves of each file in a panel of its own, with the joins
marked by their order. With --surfaces it draws all surfaces of the files as
one model, with its edges coloured by their order.
examples:
  geometric_continuity plot outline.g2 --closed -o outline.svg
  geometric_continuity plot --surfaces model.g2 --view -30,20 -o model.svg
Exit code: 0 when the picture is written, 2 on bad input.
)";

std::string name_without_folder(const std::string& file) { return file.substr(file.find_last_of('/') + 1); }

// Draws the chain of curves of a file.
GC::Svg_panel picture(const std::string& file, const GC::Svg_style& style, bool closed) {
  GC::Svg_panel panel(name_without_folder(file));
  Curve_stream<GC::G2_piece_reader<Program_traits<Exact>>> stream({file});
  Progress progress("curves read");
  const auto mark = [&](const Exact_curve& left, const Exact_curve& right) {
    const GC::Join_continuity<Exact> join = decided_join(left, right, 3);
    panel.join(join.c_order < 0 ? "gap" : 'G' + std::to_string(join.g_order));
  };
  std::optional<Exact_curve> first, last;
  std::size_t curves = 0;
  for (std::optional<Exact_curve> curve; stream.next(curve); last = curve) {
    if (!first) first = curve;
    if (last) mark(*last, *curve); // at the end of the curve before
    panel.add(*curve, style);
    progress.step(++curves);
  }
  if (closed && last) mark(*last, *first);
  return panel;
}

// Draws Hagen's figure 2 for the end of the last curve of a file.
GC::Svg_panel alternatives(const std::string& file, const GC::Svg_style& style) {
  const std::vector<Exact_curve> curves = read_curves<Exact>({file});
  typedef GC::Bezier_curve<Program_traits<Exact>> Polynomial;
  const Exact_curve& curve = curves.back();
  const Polynomial last =
      curve.is_polynomial() ? *curve.polynomial() : GC::taylor_polynomial_at_end(curve, (std::max)(curve.degree(), 2));
  const int m = last.degree();
  const GC::Midpoint_construction<Program_traits<Exact>> points = GC::midpoint_construction(last);
  const GC::Curvature_alternatives<Program_traits<Exact>> line = GC::curvature_alternatives(last);
  GC::Svg_panel panel(name_without_folder(file) + ": the line of alternatives for b\u2082, C\u2080 from 0 to 6");
  const GC::Svg_style construction{GC::Svg_role::construction, false, false},
      found{GC::Svg_role::result, false, false, "line of alternatives"};
  for (const Exact_curve& c : curves) panel.add(c, style);
  const auto side = [&](const Exact_curve::Point& a, const Exact_curve::Point& b) {
    panel.add(Polynomial{a, b}, construction);
  };
  side(last.control_point(m - 1), points.b1);
  side(last.control_point(m - 2), points.d0);
  side(points.d0, points.b2_tilde);
  side(points.d0, points.b2_bar);
  panel.add(Polynomial{line.point_at(0), line.point_at(6)}, found);
  const auto mark = [&](const Exact_curve::Point& p, const char* label) { panel.add(Polynomial{p}).join(label); };
  mark(last.control_point(m), "b\u2080");
  mark(last.control_point(m - 1), "b\u208b\u2081");
  mark(last.control_point(m - 2), "b\u208b\u2082");
  mark(points.b1, "b\u2081");
  mark(points.d0, "d\u2080");
  mark(points.b2_tilde, "b\u0303\u2082");
  mark(points.b2_bar, "b\u0304\u2082");
  return panel;
}

int plot_curves(const Command_line& line, const std::string& title) {
  if (line.has("alternatives")) line.refuse({"closed"}, "not with --alternatives");
  const GC::Svg_style style{GC::Svg_role::given, !line.has("no-polygon"), !line.has("no-comb")};
  GC::Svg_figure figure(title, line.integer("columns", 1, 1000));
  for (const std::string& file : line.files()) try {
      figure.add(line.has("alternatives") ? alternatives(file, style) : picture(file, style, line.has("closed")));
    } catch (const GC::Error& error) { // of the panel, which knows the number of the curve
      if (error.code() != GC::Error_code::not_finite) throw;
      throw std::runtime_error(input_name(file) + ": " + error.what());
    }
  Progress progress("curves drawn");
  write_output(line.text("output"),
               [&](std::ostream& os) { figure.write(os, [&](std::size_t n) { progress.step(n); }); });
  return requirement_met;
}

void describe_plot(po::options_description_easy_init add) {
  add("output,o", po::value<std::string>(), "write the picture, .svg");
  add("alternatives", "add Hagen's midpoint construction and his line of alternatives");
  add("closed", "the last curve of a file leads back to its first");
  add("no-polygon", "without control polygons");
  add("no-comb", "without curvature combs");
  add("columns", po::value<int>()->default_value(3), "panels in a row, from 1 to 1000");
  add("title", po::value<std::string>(), "title of the picture");
  add("surfaces", "the files are surfaces, class 200");
  add("isophotes", "draw surfaces in strips that show kinks, the default");
  add("shaded", "draw surfaces smoothly shaded");
  add("view", po::value<std::string>(), "AZIMUTH,ELEVATION of the viewer of surfaces in degrees (default -60,22)");
}

int run_plot(const Command_line& line) {
  if (line.files().empty()) throw std::invalid_argument("plot: no file is given; see --help");
  if (!line.has("output")) throw std::invalid_argument("plot: -o OUT.svg is needed");
  check_picture_name(line, "output");
  const std::string title = line.text("title");
  if (line.has("surfaces")) {
    line.refuse({"alternatives", "closed", "no-polygon", "no-comb", "columns"}, "not with --surfaces");
    if (line.has("isophotes") && line.has("shaded"))
      throw std::invalid_argument("plot: --isophotes and --shaded exclude each other");
    return plot_surfaces(line.files(), {line.text("output"), title, line.text("view"), line.has("shaded")});
  }
  line.refuse({"isophotes", "shaded", "view"}, "only with --surfaces");
  return with_hint_of_surfaces(line.files(), [&] { return plot_curves(line, title); });
}

} // namespace

const Command plot_command{"plot", plot_usage, describe_plot, run_plot};
