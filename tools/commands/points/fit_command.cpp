// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/command_line.h"
#include "commands/curvature_options.h"
#include "commands/points/points_report.h"
#include "files/output.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/curves/fit.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <cstddef>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

const char* const fit_usage = R"(usage: geometric_continuity fit POINTS --tolerance R [OPTIONS] [-o OUT.g2]

Makes few Bezier curves near the polyline through the points: cubics with joins
that are G1, or with --order G2 quintics with joins that are G2. The joins are
decided exactly on the numbers that are written. It is proved that no point of
the curves is farther than R from the polyline, and no point of the polyline is
farther from the curves. The report has the bound.

POINTS has the coordinates of a vertex in each line, decimals or fractions p/q
with blanks or commas between them; what follows # is skipped. With --closed the
last vertex leads back to the first. Where the polyline turns by more than the
angle of --corner, the curve has a corner, too. --max-curvature K, or
--min-radius R for K = 1/R, asks whether the curvature is at most K between the
joins, which is decided exactly.

examples:
  geometric_continuity fit outline.txt --closed --tolerance 0.5 -o outline.g2
  geometric_continuity fit track.txt --order G2 --tolerance 1/100 -o track.g2 \
      --plot track.svg

Exit code: 0 when the joins have the order that is asked for, and the curves the
curvature, 1 when they do not (the files are written nevertheless), 2 on bad
input.
)";

typedef Program_traits<Exact> Traits;
typedef GC::Fitted_curve<Traits> Fitted;

void write_json(std::ostream& os, const Command_line& line, const Fitted& curve, std::size_t points,
                const Joins_of_pieces& joins, const std::string& curvature) {
  os << "{\"points\":" << points << ",\"closed\":" << (line.has("closed") ? "true" : "false") << ",\"order\":\""
     << line.text("order") << "\",\"pieces\":" << joins.pieces << ",\"tolerance\":";
  GC::write_json(os, line.text("tolerance"));
  GC::write_number(os << ",\"distance\":", curve.distance);
  for (const auto& [name, numbers] : {std::pair("vertices", &curve.vertices), std::pair("corners", &curve.corners)}) {
    os << ",\"" << name << "\":[";
    for (std::size_t k = 0; k < numbers->size(); ++k) os << (k == 0 ? "" : ",") << (*numbers)[k];
    os << ']';
  }
  os << ",\"joins\":" << joins.joins << ",\"g_order\":" << (joins.joins == 0 ? "null" : std::to_string(joins.g_order))
     << curvature << "}\n";
}

void write_text(std::ostream& os, const Command_line& line, const Fitted& curve, std::size_t points,
                const Joins_of_pieces& joins, bool proved) {
  const bool cubic = line.text("order") == "G1";
  std::ostringstream distance;
  distance << GC::Enclosure{0, curve.distance};
  os << counted(points, "point") << ", " << counted(joins.pieces, cubic ? "cubic curve" : "quintic curve") << ", "
     << counted(curve.corners.size(), "corner") << "\nthe distance is in " << distance.str() << ", proved; tolerance "
     << line.text("tolerance") << '\n'
     << counted(joins.joins, "join") << " without a corner"
     << (joins.joins == 0 ? ""
         : !proved        ? ", decided in exact arithmetic: the order is not reached"
         : cubic          ? ", G1 or more, proved in exact arithmetic"
                          : ", G2, proved in exact arithmetic")
     << '\n';
}

int run_fit(const Command_line& line) {
  check_points_arguments(line, "fit");
  if (!line.has("tolerance")) throw std::invalid_argument("fit: --tolerance is needed; see --help");
  const int order = line.choice("order", {"G1", "G2"}) == "G1" ? 1 : 2;
  const Exact tolerance = line.number("tolerance", Exact(0));
  const std::vector<Traits::Point> points = read_points<Exact>(line);
  const Fitted curve = with_name(line, [&] {
    return GC::fit<Traits>(points.begin(), points.end(), tolerance, closure_of(line), order,
                           line.number("corner", 45.));
  });
  std::ostringstream text;
  for (const auto& piece : curve.segments()) GC::write_g2(text, piece);
  const Joins_of_pieces joins = decide_joins<GC::Decimal>(text.str(), closure_of(line), curve.corners);
  const bool proved = joins.joins == 0 || joins.g_order >= order;
  const Bent_report bent = bent_report(line, text.str());
  if (line.has("json"))
    write_json(report_stream(line), line, curve, points.size(), joins, bent.text);
  else {
    write_text(report_stream(line), line, curve, points.size(), joins, proved);
    report_stream(line) << bent.text;
  }
  write_curves<Traits>(line, text.str(), points, "fit");
  return proved && bent.is_met ? requirement_met : requirement_not_met;
}

void describe_fit(po::options_description_easy_init add) {
  add("tolerance", po::value<std::string>(), "R > 0, the largest distance, in the unit of the coordinates");
  add("order", po::value<std::string>()->default_value("G1"), "G1 for cubics, G2 for quintics");
  add("closed", "the last point leads back to the first");
  add("corner", po::value<std::string>(), "A, from how many degrees on a corner is kept (default 45)");
  describe_curvature_bound(add);
  add("json", "print the report as JSON");
  add_shape_output(add, "the curves");
  add("plot", po::value<std::string>(), "draw the polyline and the curves, .svg");
}

} // namespace

const Command fit_command{"fit", fit_usage, describe_fit, run_fit};
