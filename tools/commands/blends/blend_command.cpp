// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/blends/blend_report.h"
#include "commands/blends/blend_strategies.h"
#include "commands/blends/blend_surfaces.h"
#include "commands/blends/round_corners.h"
#include "commands/blends/strategy_names.h"
#include "commands/command_line.h"
#include "commands/curvature_options.h"
#include "commands/drawings/round_drawing.h"
#include "commands/work_limit.h"
#include "files/output.h"
#include "formats/shapes/write_shapes.h"
#include "formats/svg/svg_drawing.h"

#include <Geometric_continuity_figures/Svg_figure.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

namespace {

const char* const blend_usage = R"(usage: geometric_continuity blend A.g2 B.g2 [OPTIONS]
       geometric_continuity blend CHAIN.g2 --replace I [OPTIONS]
       geometric_continuity blend CHAIN.g2 --corner I --distance R
       geometric_continuity blend CHAIN.g2 --corners all|not-g1 --distance R
       geometric_continuity blend A.svg --corners all --distance R -o OUT.svg
       geometric_continuity blend --surfaces A.g2 B.g2 [--edges v1,v0]

Blends the end of the last curve of A into the start of the first curve of B,
or replaces the curve number I of a chain (counted from 0, cyclically) by a
blend of its neighbours. Both joins are decided exactly on the numbers that are
written, as verify reads them. The output is the blends, or the chain with its
curve replaced when one strategy is asked for. The picture has a panel for each
strategy, with the variation of curvature E; its frame follows the blends.

strategies of order 2 (degree 5, joins G2): what they choose
  c2          the second derivatives of the given curves
  normal      third points straight above the second ones
  min_second  the least second derivatives at both ends
  near_line   third points near the line between the second ones; may lead far
              away
  energy2     the least int |x''|^2, that of a thin rod
  energy3     the least int |x'''|^2 (default)
  fair        the least variation of curvature: as if it were drawn
  free        your numbers, --s1 and --s2
strategies of order 3 (degree 7, joins G3, those with f3 in their name F3)
  c3          the derivatives of the given curves up to the third
  seq_g3      the least second derivatives, then the least third ones
  seq_f3      the same among joins with continuous curvature and torsion
  joint_g3    the least third derivatives
  energy3_g3  the least int |x'''|^2
  energy4_g3  the least int |x''''|^2 (default)
  fair_g3, fair_f3  the least variation of curvature
  free        your numbers, --start and --end
The tangents at both ends are as long as the chord, or as fair chooses them,
unless --beta or --eta is given; where one is given, the other is that of the
chord.

The table has two energies int |x^(k)|^2, and it and --json tell how fair each
blend is: the variation of curvature
L^3 int |dK/ds|^2, the bending energy L int |K|^2 (both for a curve of any
size), how often the curvature turns from rising to falling or back, how often
the curve inflects, and the largest curvature. The counts are exact.

--representable makes blends of order 2 with control points that are doubles
and joins that are exactly G2 nevertheless; with -o it writes both curves,
where needed rounded to few enough digits, and the blend between them. Numbers
R are decimals or fractions p/q.

--corner I rounds the join after the curve number I of a chain (counted from 0,
cyclically; a spline counts as its Bezier curves): both curves are cut at the
arc length R from it, lines exactly where their length is rational, curves
within 1/1000 of R, and a fair blend with G2 joins is put between them, with
--order 3 one with G3 joins. The report tells the true distances. --corners all
rounds all joins that do not have this order, --corners not-g1 corners and kinks
only; less than R is cut off a short curve, so that a quarter of it remains. The
output is the whole chain. With --cubic the corners of lines are rounded by one
cubic with both handles in the corner, others, in the plane, by two cubics; all
joins are G2, as drawings and fonts can hold them.

In a drawing (.svg) all corners that turn by more than --kink-angle degrees are
rounded in place by such cubics. R is in the units of the drawing. Path data
changes, and polygons, polylines and rectangles with corners become paths; all
else stays byte for byte. Corners of lines are exactly G2 on the decimals that
are written, others exactly G1, and G2 up to the decimals. With --radius R
corners of two lines become arcs of circles of this radius, which touch the
lines up to the decimals; with --cubic also these are cubics.

--radius R in place of --distance R: each corner is cut where a circle of this
radius touches both tangents, R tan(A/2) from a corner that turns by A.

--max-curvature K, or --min-radius R for K = 1/R, is a condition: a blend may
nowhere be bent more, which is decided exactly. Without --strategy all are
tried, and the fairest of those that meet it is written; if there is none, the
report has the least curvature, and nothing is written. Each corner takes the
first of fair, energy3 and min_second that meets it, with --cubic the first of
one and two cubics. If none meets it, the corner is named, and gets the least
curvature.

--surfaces makes a surface from the edge v1 of the surface in A to the edge v0
of that in B, or from and to those of --edges. Its degree across is 5, and it is
G2 with both along the whole edges, or with --order 3, by a strategy of order 3
with joins G3, it is 7, and the surface is G3. This is decided exactly. The
default of order 2 (energy3 with --representable) is a strategy that only
surfaces have:
  fairest     the least variation of curvature, in the mean of all curves
              across, found from c2, energy2, energy3 and fair; and no fold,
              where one of these has none
All other strategies take --beta R at A and --eta R at B, and free (your
numbers, by default 1 and 0) takes --delta R,R as well: S_v = beta L_v and
S_vv = beta^2 L_vv + delta L_v, with the surface L of A or B. A warning names
a place where it may be folded. --json tells the order along both edges, the
constants there, the fold and the variation of curvature. -o writes it; with
--representable, which takes polynomial surfaces whose edges have one degree and
the same knots, both surfaces around it, too.

Exact arithmetic on numbers of thousands of digits can take long: --max-work N
allows N steps, about N nanoseconds, instead of 4000000000.

examples:
  geometric_continuity blend a.g2 b.g2 --strategy fair -o blend.g2 \
      --plot blend.svg
  geometric_continuity blend outline.g2 --closed --corners all --distance 2 \
      -o rounded.g2

Exit code: 0 when both joins of every blend have the order that is asked for, 1
when rounding has broken one or more (--kernel double; the files are written
nevertheless), and when no blend, or not each corner, is within the bound on the
curvature, 2 on bad input, and with --corners when there is no join.
)";

// The given curves around the blend: all of A, or the curves after the replaced one; then those
// after the blend.
template <class FT> struct Scene { std::vector<Program_curve<FT>> before, after; };

// The curves that end and start where the blend does.
template <class FT> const Program_curve<FT>& left_of_blend(const Scene<FT>& scene) {
  return scene.before.empty() ? scene.after.back() : scene.before.back();
}
template <class FT> const Program_curve<FT>& right_of_blend(const Scene<FT>& scene) {
  return scene.after.empty() ? scene.before.front() : scene.after.front();
}

template <class FT> Scene<FT> read_scene(const Command_line& line) {
  const Arguments files = line.files();
  if (!line.has("replace")) {
    if (files.size() != 2) throw std::invalid_argument("blend: two files are needed; see --help");
    Scene<FT> scene{read_curves<FT>({files[0]}), read_curves<FT>({files[1]})};
    if (scene.before.front().dimension() != scene.after.front().dimension())
      throw GC::Error(GC::Error_code::dimension_mismatch,
                      "blend: " + input_name(files[0]) + " and " + input_name(files[1]));
    return scene;
  }
  if (files.size() != 1) throw std::invalid_argument("blend --replace: one file is needed; see --help");
  const std::vector<Program_curve<FT>> chain = read_curves<FT>(files);
  const int n = static_cast<int>(chain.size()), i = line.integer("replace");
  const std::string text = "--replace " + std::to_string(i) + ": " + input_name(files[0]) + " has " +
                           std::to_string(n) + (n == 1 ? " curve" : " curves");
  if (n < 3) throw std::invalid_argument(text + "; at least 3 are needed");
  if (i < 0 || i >= n) throw std::invalid_argument(text + ", number 0 to " + std::to_string(n - 1));
  return {{chain.begin(), chain.begin() + i}, {chain.begin() + i + 1, chain.end()}};
}

std::string plot_join(const Join& join) {
  return join.c_order < 0
             ? "gap"
             : (join.f_order > join.g_order ? 'F' + std::to_string(join.f_order) : 'G' + std::to_string(join.g_order));
}

// Draws one panel for each result. Throws GC::Error `not_finite` for coordinates that are too large
// to be drawn.
template <class FT>
GC::Svg_figure picture(const std::string& title, const Scene<FT>& scene, const std::vector<Blend_result<FT>>& results,
                       const std::vector<Blend_report>& reports, const Program_curve<FT>& phi,
                       const Program_curve<FT>& psi) {
  const bool chain = scene.before.size() + scene.after.size() > 2;
  GC::Svg_figure figure(title, 3);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Blend_result<FT>& r = results[i];
    const std::string& warning = reports[i].warning;
    const double e = reports[i].fairness;
    GC::Svg_panel panel(r.strategy + r.fallback + ", E = " + (std::isinf(e) ? "infinite" : rounded(e, 4)) +
                        (warning.empty() ? "" : "; warning: " + warning));
    // the frame follows the blend and its neighbours, but no result that leaves their neighbourhood
    const GC::Svg_style rest{GC::Svg_role::given, false, false, "", false, false},
        neighbour{GC::Svg_role::given, false, true, "", true},
        blend{GC::Svg_role::result, !chain, true, "blend", true, warning.empty()};
    for (const std::vector<Program_curve<FT>>* part : {&scene.before, &scene.after})
      for (const Program_curve<FT>& c : *part)
        if (&c != &phi && &c != &psi) panel.add(c, rest);
    panel.add(phi, neighbour).join(plot_join(reports[i].start));
    panel.add(r.curve, blend).join(plot_join(reports[i].end));
    panel.add(psi, neighbour);
    figure.add(panel);
  }
  return figure;
}

// Refuses the parameters of the free strategies where they have no meaning.
void check_parameters(const Command_line& line, int order, bool free) {
  const Arguments quintic = {"s1", "s2"}, septic = {"start", "end"};
  if (!free) {
    line.refuse(quintic, "only with --strategy free");
    line.refuse(septic, "only with --strategy free");
  }
  line.refuse(order == 2 ? septic : quintic, "not with --order " + std::to_string(order));
}

std::string with_commas(const Arguments& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// Refuses the strategies of the other order.
void check_order(const std::string& name, const Arguments& names) {
  const auto has = [&](const Arguments& of_order) {
    return std::find(of_order.begin(), of_order.end(), name) != of_order.end();
  };
  if (has(names) || !(has(quintic_names()) || has(septic_names()))) return;
  throw std::invalid_argument("--strategy: '" + name + "' is one of --order " + (has(quintic_names()) ? "2" : "3") +
                              "; here there are " + with_commas(names));
}

// The strategies that are asked for: one, several with commas between them, or all.
Arguments chosen_strategies(const Command_line& line, const Arguments& names, const std::string& automatic) {
  if (!line.has("strategy")) return {automatic};
  const std::string text = line.text("strategy");
  if (text.find(',') == std::string::npos) {
    Arguments choices = names;
    choices.insert(choices.end(), {"free", "all"});
    check_order(text, names);
    const std::string name = line.choice("strategy", choices);
    return name == "all" ? names : Arguments{name};
  }
  Arguments result;
  std::istringstream words(text + ',');
  for (std::string name; std::getline(words, name, ',');) {
    check_order(name, names);
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw std::invalid_argument("--strategy: '" + name + "' is none of those that can be compared, which are " +
                                  with_commas(names) + did_you_mean(name, names));
    result.push_back(name);
  }
  return result;
}

// Blends by the strategies that are asked for, prints a table and writes the files.
template <class FT> int blend(const Command_line& line) {
  const int order = line.integer("order", 2, 3);
  const Arguments names = order == 2 ? quintic_names() : septic_names();
  const std::optional<Curvature_bound> bound = curvature_bound(line);
  const bool takes_one = bound && !line.has("strategy"); // of those within the bound
  const Arguments chosen = takes_one ? names : chosen_strategies(line, names, order == 2 ? "energy3" : "energy4_g3");
  check_parameters(line, order, chosen.front() == "free");

  const Scene<FT> scene = read_scene<FT>(line);
  const Program_curve<FT>&phi = left_of_blend(scene), &psi = right_of_blend(scene);
  const Blender<FT> blender(line, phi, psi);
  const bool chain = line.has("replace") && (takes_one || chosen.size() == 1); // is written
  const bool limited = line.has("max-work");
  const GC::Work_scope each(line.work_limit());
  // the neighbours as they are given, if they can be read again, unless they are written with the
  // blend
  std::optional<Scene<Exact>> given;
  if constexpr (!std::is_same_v<FT, Exact>) {
    const auto can_be_read_again = [](const std::string& file) {
      std::error_code ignored;
      return std::filesystem::is_regular_file(file, ignored);
    };
    const Arguments files = line.files();
    if (!chain && std::all_of(files.begin(), files.end(), can_be_read_again)) given = read_scene<Exact>(line);
  }
  const Exact_curve left = given ? left_of_blend(*given) : as_written(phi),
                    right = given ? right_of_blend(*given) : as_written(psi);
  std::vector<Blend_result<FT>> results;
  std::vector<Blend_report> reports;
  for (const std::string& name : chosen) {
    const GC::Work_scope blend_and_joins(GC::Work_scope::limit_of_each(), "blend");
    results.push_back(order == 2 ? blender.quintic(name) : blender.septic(name));
    const Blend_result<FT>& r = results.back();
    const bool moved = !r.neighbours.empty();
    reports.push_back({r.strategy, moved ? exact(r.curve) : as_written(r.curve), moved ? exact(r.neighbours[0]) : left,
                       moved ? exact(r.neighbours[1]) : right, Exact(r.shape.beta), Exact(r.shape.eta),
                       r.parameters + r.fallback, r.report, limited});
    if (bound) reports.back().is_within = !curvature_excess(reports.back().curve, *bound);
  }
  const bool proved =
      std::all_of(reports.begin(), reports.end(), [order](const Blend_report& r) { return r.is_proved(order); });
  // which results are written and drawn
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < results.size(); ++i)
    if (!bound || *reports[i].is_within) kept.push_back(i);
  if (takes_one && kept.size() > 1)
    kept = {*std::min_element(kept.begin(), kept.end(),
                              [&](std::size_t i, std::size_t j) { return reports[i].fairness < reports[j].fairness; })};
  if (line.has("json"))
    write_json(report_stream(line), reports, order, bound);
  else {
    write_table(report_stream(line), reports, order, limited);
    if (bound) write_choice(report_stream(line), reports, *bound, takes_one && !kept.empty() ? chosen[kept[0]] : "");
  }
  if (kept.empty()) return requirement_not_met;
  const auto keep = [&](auto& all) {
    std::decay_t<decltype(all)> some;
    for (const std::size_t i : kept) some.push_back(all[i]);
    all = std::move(some);
  };
  keep(results);
  keep(reports);

  std::optional<GC::Svg_figure> figure;
  if (line.has("plot")) figure = picture(line.text("title"), scene, results, reports, phi, psi);
  if (line.has("output"))
    write_shapes(line, [&](std::ostream& os) {
      if (chain)
        for (const Program_curve<FT>& c : scene.before) GC::write_g2(os, c);
      for (const Blend_result<FT>& r : results)
        if (r.neighbours.empty())
          GC::write_g2(os, r.curve);
        else // as fractions, which are the same numbers in every arithmetic
          for (const Program_curve<FT>& c : {r.neighbours[0], r.curve, r.neighbours[1]}) GC::write_g2(os, exact(c));
      if (chain)
        for (const Program_curve<FT>& c : scene.after) GC::write_g2(os, c);
    });
  if (figure) write_output(line.text("plot"), [&](std::ostream& os) { figure->write(os); });
  return proved ? requirement_met : requirement_not_met;
}

void describe_blend(po::options_description_easy_init add) {
  add("strategy", po::value<std::string>(), "one of the strategies, some as A,B,C, or all: each of them except free");
  add("order", po::value<int>()->default_value(2), "2: quintic, 3: septic");
  add("beta", po::value<std::string>(), "R > 0, the blend starts with beta times the end tangent of A");
  add("eta", po::value<std::string>(), "R > 0, the blend ends with eta times the start tangent of B");
  add("s1", po::value<std::string>(), "R, free scalar at the start (free, order 2)");
  add("s2", po::value<std::string>(), "R, free scalar at the end (free, order 2)");
  add("start", po::value<std::string>(), "R,R,R = beta2,mu,beta3 at the start (free, order 3)");
  add("end", po::value<std::string>(), "R,R,R = beta2,mu,beta3 at the end (free, order 3)");
  add("replace", po::value<int>(), "I, replace this curve of a chain");
  add("corner", po::value<int>(), "I, round the join after this curve of a chain");
  add("corners", po::value<std::string>(), "all or not-g1, round these joins of a chain");
  add("distance", po::value<std::string>(), "R > 0, from a corner to where its curves are cut");
  add("radius", po::value<std::string>(),
      "R > 0, in place of --distance: corners are cut where a circle of this radius touches; in drawings they become "
      "arcs");
  add("cubic", "with --corner or --corners: round by cubics, one or two, with G2 joins; in drawings with --radius");
  add("kink-angle", po::value<std::string>(), "D, of drawings: corners are what turns by more degrees (default 5)");
  describe_curvature_bound(add);
  add("closed", "with --corners: the last curve leads back to the first");
  add("surfaces", "blend an edge of one surface into an edge of another one");
  add("edges", po::value<std::string>(), "EDGE,EDGE of A and B with --surfaces: u0, u1, v0 or v1 (default v1,v0)");
  add("direction", po::value<std::string>(), "same or opposite: how the edge of B runs, unless by its nearer ends");
  add("delta", po::value<std::string>(), "R,R = delta at A and at B (--surfaces, free)");
  add("kernel", po::value<std::string>()->default_value("exact"),
      "exact: construct in exact numbers; double: in floating-point numbers");
  add("representable", "control points that are doubles, joins that are exactly G2");
  add("json", "print the report as JSON");
  add("max-work", po::value<std::string>(), "the steps of work that are allowed for each blend");
  add_shape_output(add, "the result");
  add("plot", po::value<std::string>(), "draw the result, .svg");
  add("title", po::value<std::string>(), "title of the picture");
}

int run_blend(const Command_line& line) {
  const Arguments files = line.files();
  if (std::any_of(files.begin(), files.end(), is_svg_file)) {
    line.refuse({"strategy", "beta",   "eta",    "s1",       "s2",       "start",         "end",
                 "replace",  "corner", "closed", "surfaces", "edges",    "representable", "json",
                 "max-work", "plot",   "title",  "decimals", "flatness", "max-curvature", "min-radius"},
                "not for drawings");
    return round_drawing(line);
  }
  line.refuse({"kink-angle"}, "only for drawings");
  check_shape_output(line);
  if (!line.has("plot")) line.refuse({"title"}, "only with --plot");
  if (line.has("corner") || line.has("corners")) {
    line.refuse({"max-work"}, "not with --corner or --corners");
    line.refuse({"surfaces", "edges", "direction", "delta"}, "not with --corner or --corners");
    return round_corners(line);
  }
  const auto bounded = [&](auto work) {
    return within_work_limit([&] { return line.files().empty() ? "blend" : input_name(line.files().front()); }, work);
  };
  line.refuse({"distance", "radius", "closed", "cubic"}, "only with --corner or --corners");
  if (line.has("surfaces")) {
    line.refuse({"s1", "s2", "start", "end", "replace", "kernel", "plot", "max-curvature", "min-radius"},
                "not with --surfaces");
    return bounded([&] { return blend_surfaces(line); });
  }
  line.refuse({"edges", "direction", "delta"}, "only with --surfaces");
  if (line.has("representable")) {
    if (line.integer("order") != 2) throw std::invalid_argument("--representable: blends of order 2 only");
    line.refuse({"replace", "kernel"}, "not with --representable");
    return bounded([&] { return blend<double>(line); });
  }
  return bounded([&] {
    return line.choice("kernel", {"exact", "double"}) == "exact" ? blend<Exact>(line) : blend<double>(line);
  });
}

} // namespace

Arguments quintic_names() { return names_of(quintic_strategies); }
Arguments septic_names() { return names_of(septic_strategies); }

const Command blend_command{"blend", blend_usage, describe_blend, run_blend};
