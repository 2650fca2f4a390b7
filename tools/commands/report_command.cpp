// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/command_line.h"
#include "commands/drawings/read_drawing.h"
#include "commands/kink_options.h"
#include "commands/report_inputs.h"
#include "commands/roads/road_options.h"
#include "commands/surfaces_hint.h"
#include "files/output.h"
#include "formats/cad/read_cad.h"
#include "formats/font/font_files.h"
#include "formats/opendrive/read_opendrive.h"

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

const char* const report_usage = R"(usage: geometric_continuity report FILE.g2... | DRAWING.svg... | FONT...
       | MODEL.step... | TOOLPATH.ngc... | ROAD.xodr... -o REPORT.html [OPTIONS]

Decides the joins of a chain, of drawings, toolpaths or fonts, the edges of CAD
models within --within, or with --surfaces those of a model, as verify does, and
writes a page that shows them: the worst first, each drawn large with its
curvature comb, its handles and the numbers, which are guaranteed bounds; or
with its two faces, and the whole model to be turned. The page filters and
sorts. It is one file, and needs no network. Several CAD models are drawn beside
each other.
  gap     the ends are apart
  kink    the tangents differ, by at most --kink-angle
  fading corner  of CAD models: by more in places only, which may not be meant
  corner  they differ by more
  G1      the tangents agree, the curvatures do not
  G2      the curvatures agree as well
In fonts, where the worst are those that are off by the most units, also
  bend    a kink of two straight lines, where no handle is off
  rounding  a kink or bend that is off by at most one unit, or --off-by units
Of road networks the page draws the roads in plan with their lanes, around each
join, and large with the curvature and the elevation along the road. All joins
of reference lines are listed, and of profiles and lanes those that are not as
verify demands.
examples:
  geometric_continuity report drawing.svg -o drawing.html
  geometric_continuity report model.step --within class-a -o model.html
Exit code: 0 when the page is written, 2 on bad input.
)";

// The names without folders.
std::string names(const Arguments& files) {
  std::string text;
  for (std::size_t i = 0; i < files.size() && i < 3; ++i) {
    const std::string name = input_name(files[i]);
    text += (i == 0 ? "" : ", ") + name.substr(name.find_last_of('/') + 1);
  }
  return files.size() > 3 ? text + " and " + std::to_string(files.size() - 3) + " more" : text;
}

// The address of the page of joins: what names a program (javascript:) is none.
std::string join_page(const std::string& address) {
  const std::size_t colon = address.find(':');
  const std::string scheme = colon < address.find_first_of("/?#") ? address.substr(0, colon) : "";
  if (address.empty() || address.find('#') != std::string::npos ||
      (!scheme.empty() && scheme != "http" && scheme != "https" && scheme != "file"))
    throw std::invalid_argument("--page: " + address +
                                ": a path from the report or an address (http, https, file) without #");
  return address;
}

// Writes the page.
int written(const Report_page& page, const std::string& output) {
  write_output(output, [&](std::ostream& os) { page.write(os); });
  if (page.left_out() > 0)
    std::cerr << "geometric_continuity: report: the page shows the worst " << page.items().size() << " of "
              << page.total() << "; --worst N shows more\n";
  return requirement_met;
}

void describe_report(po::options_description_easy_init add) {
  add("output,o", po::value<std::string>(), "write the page, .html");
  add("title", po::value<std::string>(), "title of the page");
  add("page", po::value<std::string>(),
      "link joins to the page geometric_continuity.html, as it is seen from REPORT.html or at http(s)");
  add("worst", po::value<int>()->default_value(10000), "show so many joins at most, from 1 to 50000");
  add("kink-angle", po::value<std::string>()->default_value("5"),
      "the largest angle, in degrees, that is a kink and not a corner");
  add("off-by", po::value<std::string>(),
      "for fonts: up to so many units a handle may be off because of rounding; 1 if not given");
  add("within", po::value<std::string>(),
      "for CAD models: the tolerance GAP,ANGLEdeg,CURVATURE% or a preset, vda-4955 if not given; see verify --help");
  add("sew", po::value<std::string>(), "for CAD models: join boundary edges that are within this distance, in mm");
  add("time-limit", po::value<std::string>(),
      "for CAD models: the seconds of processor time that reading one file may take, 60 if not given; a tenth of them "
      "for drawing one face");
  add("glyphs", po::value<std::string>(), "the glyphs of fonts, e.g. a-z,U+00E9,ampersand");
  describe_road_tolerances(add);
  add("closed", "the last curve leads back to the first");
  add("surfaces", "the files hold the patches of a model");
  add("max-work", po::value<std::string>(), "the steps of work that are allowed for one join, edge or curve");
}

int run_report(const Command_line& line) {
  const Arguments files = line.files();
  if (files.empty()) throw std::invalid_argument("report: no file is given; see --help");
  if (!line.has("output")) throw std::invalid_argument("report: -o REPORT.html is needed");
  const std::string output = line.text("output");
  if (!has_no_format(output) && extension(output) != ".html" && extension(output) != ".htm")
    throw std::invalid_argument("--output: " + output + ": the page is HTML, and the name must end with .html");
  Report_demand demand;
  demand.corner_threshold = corner_threshold(line);
  demand.rounding = rounding_bound(line);
  const GC::Work_scope each(line.work_limit());
  demand.closed = line.has("closed");
  Report_page page(static_cast<std::size_t>(line.integer("worst", 1, 50000)));
  if (line.has("page")) page.join_page = join_page(line.text("page"));
  page.title = line.has("title") ? line.text("title") : "Continuity of " + names(files);
  if (are_fonts(files)) {
    line.refuse({"surfaces", "closed", "within", "sew", "time-limit"}, "not for fonts");
    if (line.has("glyphs")) demand.glyphs = Glyph_selection(line.text("glyphs"));
    report_fonts(files, demand, page);
    return written(page, output);
  }
  line.refuse({"glyphs", "off-by"}, "only for fonts");
  if (are_cad_files(files)) {
    line.refuse({"surfaces", "closed", "page"}, "not for CAD models");
    if (line.has("within")) demand.tolerance = line.text("within");
    demand.reading = {Cad_drawing::faces_and_edges, line.length("sew"), line.seconds("time-limit", 60)};
    report_cad(files, demand, page);
    return written(page, output);
  }
  line.refuse({"within", "sew", "time-limit"}, "only for CAD models");
  if (const auto roads = std::count_if(files.begin(), files.end(), is_road_file); roads != 0) {
    if (roads != static_cast<std::ptrdiff_t>(files.size()))
      throw std::invalid_argument("road networks (.xodr) and other files are not shown on one page");
    line.refuse({"surfaces", "closed", "page"}, "not for road networks");
    read_road_tolerances(line, demand.roads);
    report_roads(files, demand, page);
    return written(page, output);
  }
  line.refuse({"gap", "kink", "curvature"}, "only for road networks");
  const auto drawings = std::count_if(files.begin(), files.end(), is_drawing_file);
  if (drawings != 0) {
    if (drawings != static_cast<std::ptrdiff_t>(files.size()))
      throw std::invalid_argument("drawings (.svg), toolpaths (.ngc) and curves (.g2) are not shown on one page");
    line.refuse({"surfaces", "closed"}, "not for drawings and toolpaths");
    report_drawings(files, demand, page);
  } else if (line.has("surfaces")) {
    line.refuse({"closed", "page"}, "not with --surfaces");
    report_surfaces(files, demand, page);
  } else
    return with_hint_of_surfaces(files, [&] {
      report_chain(files, demand, page);
      return written(page, output);
    });
  return written(page, output);
}

} // namespace

const Command report_command{"report", report_usage, describe_report, run_report};
