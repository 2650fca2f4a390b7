// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "command_line.h"
#include "join_report.h"

#include <CGAL/Geometric_continuity/IO/atomic_file.h>
#include <CGAL/Geometric_continuity/IO/svg.h>

namespace {

const char* const usage =
    "usage: geometric_continuity plot FILE.g2... -o OUT.svg [OPTIONS]\n"
    "\n"
    "Draws the chain of curves of each file in a panel of its own, with the joins marked by their order.\n";

GC::Svg_panel picture(const std::string& file, const GC::Svg_style& style, bool closed) {
  const std::vector<Program_curve<Exact>> curves = read_curves<Exact>({file});
  GC::Svg_panel panel(file.substr(file.find_last_of('/') + 1));
  for (std::size_t i = 0; i < curves.size(); ++i) {
    panel.add(curves[i], style);
    if (i + 1 == curves.size() && !closed) continue;
    const Join join = GC::continuity(curves[i], curves[(i + 1) % curves.size()]);
    panel.join(join.c_order < 0 ? "gap" : 'G' + std::to_string(join.g_order));
  }
  return panel;
}

} // namespace

int plot_command(const Arguments& arguments) {
  const Command_line line(usage, arguments, [](po::options_description_easy_init add) {
    add("output,o", po::value<std::string>(), "the picture, .svg");
    add("closed", "the last curve of a file leads back to its first");
    add("no-polygon", "without control polygons");
    add("no-comb", "without curvature combs");
    add("columns", po::value<int>()->default_value(3), "panels in a row");
    add("title", po::value<std::string>(), "title of the picture");
  });
  if (line.help()) return requirement_met;
  if (line.files().empty()) throw std::invalid_argument("plot: no file is given; see --help");
  if (!line.has("output")) throw std::invalid_argument("plot: -o OUT.svg is needed");
  const GC::Svg_style style{GC::Svg_role::given, !line.has("no-polygon"), !line.has("no-comb")};
  GC::Svg_figure figure(line.has("title") ? line.text("title") : std::string(), line.integer("columns"));
  for (const std::string& file : line.files()) figure.add(picture(file, style, line.has("closed")));
  GC::write_file_atomically(line.text("output"), [&](std::ostream& os) { figure.write(os); });
  return requirement_met;
}
