// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "command_line.h"
#include "join_report.h"
#include "output.h"

#include <CGAL/Geometric_continuity/IO/figures/Svg_figure.h>
#include <CGAL/Geometric_continuity/blends/representable_blend.h>
#include <CGAL/Geometric_continuity/blends/septic_strategies.h>

#include <algorithm>
#include <array>
#include <iomanip>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

const char* const usage = R"(usage: geometric_continuity blend A.g2 B.g2 [OPTIONS]
       geometric_continuity blend CHAIN.g2 --replace I [OPTIONS]

Blends the end of the last curve of A into the start of the first curve of B,
or replaces the curve number I of a chain (counted from 0, cyclically) by a
blend of its neighbours. Both joins are decided exactly on the result. The
output is the blends, or the chain with its curve replaced when one strategy is
asked for.

strategies of order 2 (degree 5, G2):
  c2, normal, min_second, near_line, energy2, energy3 (default),
  free (--s1 --s2)
strategies of order 3 (degree 7, G3 or F3):
  c3, seq_g3, seq_f3, joint_g3, energy3_g3, energy4_g3 (default),
  free (--start --end)

--representable makes blends of order 2 with control points that are doubles
and joins that are exactly G2 nevertheless; with -o it writes both curves,
where needed rounded to few enough digits, and the blend between them. Numbers
R are decimals or fractions p/q.
Exit code: 0 when both joins of every blend have the order that is asked for, 1
when rounding has broken one (--kernel double; the files are written
nevertheless), 2 on bad input.
)";

const Arguments quintic_names = {"c2", "normal", "min_second", "near_line", "energy2", "energy3"};
const Arguments septic_names = {"c3", "seq_g3", "seq_f3", "joint_g3", "energy3_g3", "energy4_g3"};

// What one strategy gives.
template <class FT> struct Result {
  std::string strategy;
  Program_curve<FT> curve;
  std::string parameters, fallback;
  std::vector<Program_curve<FT>> neighbours = {}; // of a representable blend: both given curves as they now are
};

std::string rounded(double x) { return ::rounded(x, 6); }

std::string fallback_text(bool start, bool end) {
  return !start && !end ? ""
                        : std::string(" fallback at ") + (start && end ? "both ends"
                                                          : start      ? "the start"
                                                                       : "the end");
}

template <class FT> std::string text(const GC::Quintic_parameters<FT>& p) {
  return "s = (" + rounded(CGAL::to_double(p.s1)) + ", " + rounded(CGAL::to_double(p.s2)) + ')';
}

template <class FT> std::string text(const GC::Septic_end_parameters<FT>& p) {
  return '(' + rounded(CGAL::to_double(p.beta2)) + ", " + rounded(CGAL::to_double(p.mu)) + ", " +
         rounded(CGAL::to_double(p.beta3)) + ')';
}

template <class FT> std::string text(const GC::Septic_parameters<FT>& p) {
  return "(beta2, mu, beta3) = " + text(p.start) + ", " + text(p.end);
}

// Returns the three numbers of --start or --end.
template <class FT> GC::Septic_end_parameters<FT> end_parameters(const Command_line& line, const std::string& option) {
  const std::vector<FT> x = line.numbers<FT>(option);
  if (x.size() != 3) throw std::invalid_argument("--" + option + ": three numbers beta2,mu,beta3 are needed");
  return {x[0], x[1], x[2]};
}

// Blends two curves by strategies that are given by name.
template <class FT> class Blender {
  typedef Program_traits<FT> Traits;
  const Command_line& line_;
  const Program_curve<FT>&phi_, &psi_;
  const GC::Shape_parameters<FT> shape_;

  template <class Strategy> Result<FT> blend(const std::string& name, const Strategy& strategy) const {
    if constexpr (std::is_same_v<FT, double> && GC::is_quintic_strategy_v<Strategy, Traits>)
      if (line_.has("representable")) {
        const GC::Representable_blend<Traits> gamma = GC::representable_blend(phi_, psi_, strategy, shape_);
        const double moved = (std::max)(gamma.start_join.moved, gamma.end_join.moved);
        return {name,
                gamma,
                "beta = " + rounded(gamma.start_join.beta) + ", eta = " + rounded(gamma.end_join.beta) +
                    (moved == 0 ? ", nothing was moved" : ", coordinates were moved by at most " + rounded(moved)),
                "",
                {gamma.phi, gamma.psi}};
      }
    const auto gamma = GC::blend(phi_, psi_, strategy, shape_);
    return {name, gamma, text(gamma.parameters),
            fallback_text(gamma.parameters.fallback_start, gamma.parameters.fallback_end)};
  }

public:
  Blender(const Command_line& line, const Program_curve<FT>& phi, const Program_curve<FT>& psi)
      : line_(line), phi_(phi), psi_(psi), shape_{line.number("beta", FT(1)), line.number("eta", FT(1))} {}

  Result<FT> quintic(const std::string& name) const {
    if (name == "c2") return blend(name, GC::Matching_second_derivative());
    if (name == "normal") return blend(name, GC::Normal_offset());
    if (name == "min_second") return blend(name, GC::Minimal_second_derivative());
    if (name == "near_line") return blend(name, GC::Near_line());
    if (name == "energy2") return blend(name, GC::Minimal_energy<2>());
    if (name == "energy3") return blend(name, GC::Minimal_energy<3>());
    if (!line_.has("s1") || !line_.has("s2")) throw std::invalid_argument("--strategy free needs --s1 and --s2");
    return blend(name, GC::Given_parameters<FT>{line_.number("s1", FT(0)), line_.number("s2", FT(0))});
  }

  Result<FT> septic(const std::string& name) const {
    if (name == "c3") return blend(name, GC::Matching_third_derivative());
    if (name == "seq_g3") return blend(name, GC::Sequential_g3());
    if (name == "seq_f3") return blend(name, GC::Sequential_f3());
    if (name == "joint_g3") return blend(name, GC::Joint_g3());
    if (name == "energy3_g3") return blend(name, GC::Minimal_energy_g3<3>());
    if (name == "energy4_g3") return blend(name, GC::Minimal_energy_g3<4>());
    return blend(name,
                 GC::Given_end_parameters<FT>{end_parameters<FT>(line_, "start"), end_parameters<FT>(line_, "end")});
  }
};

// The given curves around the blend: all of A, or the curves after the replaced one; then those after the blend.
template <class FT> struct Scene { std::vector<Program_curve<FT>> before, after; };

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

template <class FT> std::string plot_join(const Program_curve<FT>& left, const Program_curve<FT>& right) {
  const Join join = GC::continuity(exact(left), exact(right));
  return join.c_order < 0
             ? "gap"
             : (join.f_order > join.g_order ? 'F' + std::to_string(join.f_order) : 'G' + std::to_string(join.g_order));
}

// Draws one panel for each result. Throws GC::Error `not_finite` for coordinates that are too large to be drawn.
template <class FT>
GC::Svg_figure picture(const std::string& title, const Scene<FT>& scene, const std::vector<Result<FT>>& results,
                       const Program_curve<FT>& phi, const Program_curve<FT>& psi) {
  const bool chain = scene.before.size() + scene.after.size() > 2;
  GC::Svg_figure figure(title, 3);
  for (const Result<FT>& r : results) {
    GC::Svg_panel panel(r.strategy + r.fallback);
    const GC::Svg_style given{GC::Svg_role::given, false, !chain}, neighbour{GC::Svg_role::given, false, true},
        blend{GC::Svg_role::result, true, true, "blend"};
    // the neighbours of the blend are drawn with it, the rest of a chain without details
    for (const std::vector<Program_curve<FT>>* part : {&scene.before, &scene.after})
      for (const Program_curve<FT>& c : *part)
        if (&c != &phi && &c != &psi) panel.add(c, given);
    panel.add(phi, neighbour).join(plot_join(phi, r.curve));
    panel.add(r.curve, blend).join(plot_join(r.curve, psi));
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

// Writes a line of the table.
void write_row(std::ostream& os, const std::array<std::string, 5>& columns, const std::string& rest) {
  os << std::left << std::setw(11) << columns[0] << ' ' << std::setw(12) << columns[1] << ' ' << std::setw(12)
     << columns[2] << ' ' << std::right << std::setw(12) << columns[3] << ' ' << std::setw(12) << columns[4] << "  "
     << rest << '\n';
}

// Blends by the strategies that are asked for, prints a table and writes the files.
template <class FT> int blend(const Command_line& line) {
  const int order = line.integer("order", 2, 3);
  const Arguments& names = order == 2 ? quintic_names : septic_names;
  Arguments choices = names;
  choices.insert(choices.end(), {"free", "all"});
  const std::string chosen = line.has("strategy") ? line.choice("strategy", choices) : names.back();
  check_parameters(line, order, chosen == "free");

  const Scene<FT> scene = read_scene<FT>(line);
  const Program_curve<FT>& phi = scene.before.empty() ? scene.after.back() : scene.before.back();
  const Program_curve<FT>& psi = scene.after.empty() ? scene.before.front() : scene.after.front();
  const Blender<FT> blender(line, phi, psi);
  std::vector<Result<FT>> results;
  for (const std::string& name : chosen == "all" ? names : Arguments{chosen})
    results.push_back(order == 2 ? blender.quintic(name) : blender.septic(name));

  std::ostream& report = report_stream(line);
  write_row(report,
            {"strategy", "start join", "end join", order == 2 ? "int |x''|^2" : "int |x'''|^2",
             order == 2 ? "int |x'''|^2" : "int |x''''|^2"},
            "parameters");
  bool proved = true;
  for (const Result<FT>& r : results) {
    const Exact_curve gamma = exact(r.curve);
    const bool moved = !r.neighbours.empty();
    const Join start = GC::continuity(exact(moved ? r.neighbours[0] : phi), gamma),
               end = GC::continuity(gamma, exact(moved ? r.neighbours[1] : psi));
    for (const Join& join : {start, end})
      proved = proved && (order == 2 || phi.dimension() < 3 ? join.g_order >= 2 : join.f_order >= 3);
    write_row(report,
              {r.strategy, orders(start), orders(end), rounded(CGAL::to_double(gamma.energy(order))),
               rounded(CGAL::to_double(gamma.energy(order + 1)))},
              r.parameters + r.fallback);
  }
  report << (proved ? "both joins of every blend are proved in exact arithmetic\n"
                    : "decided in exact arithmetic: rounding has broken a join\n");

  std::optional<GC::Svg_figure> figure;
  if (line.has("plot")) figure = picture(line.text("title"), scene, results, phi, psi);
  if (line.has("output"))
    write_output(line.text("output"), [&](std::ostream& os) {
      const bool chain = line.has("replace") && results.size() == 1;
      if (chain)
        for (const Program_curve<FT>& c : scene.before) GC::write_g2(os, c);
      for (const Result<FT>& r : results)
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

} // namespace

int blend_command(const Arguments& arguments) {
  const Command_line line(usage, arguments, [](po::options_description_easy_init add) {
    add("strategy", po::value<std::string>(), "one of the strategies, or all: each of them except free");
    add("order", po::value<int>()->default_value(2), "2: quintic, 3: septic");
    add("beta", po::value<std::string>(), "R > 0, the blend starts with beta times the end tangent of A (default 1)");
    add("eta", po::value<std::string>(), "R > 0, the blend ends with eta times the start tangent of B (default 1)");
    add("s1", po::value<std::string>(), "R, free scalar at the start (free, order 2)");
    add("s2", po::value<std::string>(), "R, free scalar at the end (free, order 2)");
    add("start", po::value<std::string>(), "R,R,R = beta2,mu,beta3 at the start (free, order 3)");
    add("end", po::value<std::string>(), "R,R,R = beta2,mu,beta3 at the end (free, order 3)");
    add("replace", po::value<int>(), "I, replace this curve of a chain");
    add("kernel", po::value<std::string>()->default_value("exact"),
        "exact: construct in exact numbers; double: in floating-point numbers");
    add("representable", "control points that are doubles, joins that are exactly G2");
    add("output,o", po::value<std::string>(), "write the result, .g2");
    add("plot", po::value<std::string>(), "draw the result, .svg");
    add("title", po::value<std::string>(), "title of the picture");
  });
  if (line.help()) return requirement_met;
  check_outputs(line);
  if (!line.has("plot")) line.refuse({"title"}, "only with --plot");
  if (line.has("representable")) {
    if (line.integer("order") != 2) throw std::invalid_argument("--representable: blends of order 2 only");
    line.refuse({"replace", "kernel"}, "not with --representable");
    return blend<double>(line);
  }
  return line.choice("kernel", {"exact", "double"}) == "exact" ? blend<Exact>(line) : blend<double>(line);
}
