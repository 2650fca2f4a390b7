// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/command_line.h"
#include "commands/curvature_options.h"
#include "commands/points/points_report.h"
#include "commands/work_limit.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/blends/interpolate_fair.h>
#include <CGAL/Geometric_continuity/curves/interpolate.h>

#include <cstddef>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace {

const char* const interpolate_usage = R"(usage: geometric_continuity interpolate POINTS [OPTIONS] [-o OUT.g2]

Leads a cubic B-spline through points: C2, with second derivatives that vanish
at its ends, or with --closed back to the first point and C2 there, too. The
knots are the parameters of the points: uniform, chordal (at the distances of
the points), or centripetal (at the roots of these). With --fair the curve is
made of quintics with G2 joins, whose curvature varies little; in the plane it
has no more inflections than the polygon of the points, or the report says where
it may have. The joins are decided exactly on the numbers that are written.

--max-curvature K, or --min-radius R for K = 1/R, asks whether the curvature is
at most K on the whole curve, which is decided exactly.

POINTS has the coordinates of a point in each line, decimals or fractions p/q
with blanks or commas between them; what follows # is skipped.

Exact numbers of a cubic spline become longer with the number of points;
--kernel double computes in floating-point numbers. Exact arithmetic on many
points, or on numbers of thousands of digits, can take long: --max-work N allows
N steps, about N nanoseconds, instead of 4000000000.

examples:
  geometric_continuity interpolate points.txt --fair -o fair.g2 --plot fair.svg
  geometric_continuity interpolate outline.txt --closed --kernel double \
      --parameters centripetal -o outline.g2

Exit code: 0 when the curve is proved to be C2, with --fair G2, and bent by no
more than is allowed, 1 when it is bent more, or when rounding has broken the
joins (--kernel double); the files are written nevertheless. 2 on bad input.
)";

GC::Parametrisation parametrisation_of(const Command_line& line) {
  const std::string name = line.choice("parameters", {"uniform", "chordal", "centripetal"});
  return name == "uniform"   ? GC::Parametrisation::uniform
         : name == "chordal" ? GC::Parametrisation::chordal
                             : GC::Parametrisation::centripetal;
}

// A curve as it is written, .g2, its joins, and what else is to be said.
struct Written_curve {
  std::string text;
  Joins_of_pieces joins;
  std::string remark;
  std::vector<int> waves = {}; // pieces
};

template <class FT>
Written_curve cubic_spline(const Command_line& line, const std::vector<typename Program_traits<FT>::Point>& points) {
  std::ostringstream os;
  GC::write_g2(os, GC::interpolate<Program_traits<FT>>(points.begin(), points.end(), parametrisation_of(line),
                                                       closure_of(line)));
  return {os.str(), decide_joins<GC::Decimal>(os.str(), closure_of(line)), ""};
}

template <class FT>
Written_curve fair_spline(const Command_line& line, const std::vector<typename Program_traits<FT>::Point>& points) {
  const auto curve = GC::interpolate_fair<Program_traits<FT>>(points.begin(), points.end(), closure_of(line));
  std::ostringstream os;
  for (const auto& piece : curve.segments())
    // not rounded
    GC::write_g2(os, exact(Program_curve<FT>(GC::Bezier_curve<Program_traits<FT>>(piece))));
  typedef std::conditional_t<std::is_same_v<FT, double>, double, GC::Decimal> Number;
  const double moved = CGAL::to_double(curve.moved);
  std::string remark = moved == 0 ? "" : "coordinates were moved by at most " + rounded(moved, 3) + '\n';
  if (curve.dimension() == 2) {
    remark += curve.waves.empty()
                  ? "no more inflections than the polygon, proved\n"
                  : "more inflections than the polygon, or not proved: " + counted(curve.waves.size(), "piece") +
                        ", the first one from the point " + std::to_string(curve.waves[0]) + " on\n";
  }
  return {os.str(), decide_joins<Number>(os.str(), closure_of(line)), remark, curve.waves};
}

template <class FT> int interpolate(const Command_line& line) {
  const std::vector<typename Program_traits<FT>::Point> points = read_points<FT>(line);
  const bool fair = line.has("fair");
  const Written_curve written =
      with_name(line, [&] { return fair ? fair_spline<FT>(line, points) : cubic_spline<FT>(line, points); });
  const Joins_of_pieces& joins = written.joins;
  const bool none = joins.joins == 0, proved = none || (fair ? joins.g_order : joins.c_order) >= 2;
  const Bent_report bent = bent_report(line, written.text);
  std::ostream& report = report_stream(line);
  const std::string parameters = fair ? "" : to_string(parametrisation_of(line));
  if (line.has("json")) {
    report << "{\"points\":" << points.size() << ",\"closed\":" << (line.has("closed") ? "true" : "false")
           << ",\"curve\":\"" << (fair ? "fair\",\"parameters\":null" : "cubic\",\"parameters\":\"" + parameters + '"')
           << ",\"pieces\":" << joins.pieces << ",\"joins\":" << joins.joins
           << ",\"c_order\":" << (none ? "null" : std::to_string(joins.c_order))
           << ",\"g_order\":" << (none ? "null" : std::to_string(joins.g_order));
    if (fair && points[0].dimension() == 2) {
      report << ",\"waves\":[";
      for (std::size_t k = 0; k < written.waves.size(); ++k) report << (k == 0 ? "" : ",") << written.waves[k];
      report << ']';
    }
    report << bent.text << "}\n";
  } else
    report << counted(points.size(), "point") << ", " << (fair ? "" : parameters + " parameters, ")
           << counted(joins.pieces, fair ? "fair quintic" : "cubic piece") << '\n'
           << written.remark << counted(joins.joins, "join")
           << (none ? ""
               : !proved
                   ? ", decided in exact arithmetic: " + broken_joins(fair ? joins.not_g2 : joins.not_c2, joins.joins)
               : fair ? ", G2, proved in exact arithmetic"
                      : ", C2, proved in exact arithmetic")
           << '\n'
           << bent.text;
  write_curves<Program_traits<FT>>(line, written.text, points, "spline");
  return proved && bent.is_met ? requirement_met : requirement_not_met;
}

void describe_interpolate(po::options_description_easy_init add) {
  add("closed", "lead back to the first point");
  add("parameters", po::value<std::string>()->default_value("chordal"),
      "of the points: uniform, chordal or centripetal");
  add("fair", "make fair quintics with G2 joins in place of a cubic spline");
  add("kernel", po::value<std::string>()->default_value("exact"),
      "exact: construct in exact numbers; double: in floating-point numbers");
  describe_curvature_bound(add);
  add("max-work", po::value<std::string>(), "the steps of work that are allowed");
  add("json", "print the report as JSON");
  add_shape_output(add, "the curve");
  add("plot", po::value<std::string>(), "draw the points and the curve, .svg");
}

int run_interpolate(const Command_line& line) {
  check_points_arguments(line, "interpolate");
  if (line.has("fair")) line.refuse({"parameters"}, "not with --fair, which chooses none");
  const bool exact = line.choice("kernel", {"exact", "double"}) == "exact";
  if (!exact) line.refuse({"max-work"}, "only with --kernel exact");
  const GC::Work_scope each(line.work_limit());
  std::optional<GC::Work_scope> all; // of a search that is no object of its own
  if (line.has("fair") && exact) all.emplace(line.work_limit(), "interpolate");
  return within_work_limit([&] { return input_name(line.files()[0]); },
                           [&] { return exact ? interpolate<Exact>(line) : interpolate<double>(line); });
}

} // namespace

const Command interpolate_command{"interpolate", interpolate_usage, describe_interpolate, run_interpolate};
