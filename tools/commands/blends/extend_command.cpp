// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/chains/decided_join.h"
#include "commands/chains/join_report.h"
#include "commands/command_line.h"
#include "commands/work_limit.h"
#include "files/output.h"
#include "formats/shapes/write_shapes.h"

#include <CGAL/Geometric_continuity/extensions/extend.h>
#include <Geometric_continuity_figures/Svg_figure.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

const char* const extend_usage = R"(usage: geometric_continuity extend A.g2 --order ORDER [OPTIONS] -o OUT.g2

Appends a segment of the same degree to the last curve of A. Its first points
are members of Hagen's families:
  b1 = b0 + beta p
  b2 = b0 + beta^2 (b-2 - b0) + c0 p
  b3 = b0 + beta^3 (b-2 - b-3) + c1 p + c2 r
with the numbers --c0, --c1 and --c2, p = b0 - b-1 and r = b-2 - b-1. Numbers
that are not given are chosen so that the curve goes on as smoothly as possible.
With --toward the segment ends at the point, or as near to it as possible, with
the least energy. The join is decided exactly on the numbers that are written,
as verify reads them. In a curve with inner knots the last span counts; all
curves are written as Bezier curves. Numbers R are decimals or fractions p/q.
Exact arithmetic on numbers of thousands of digits can take long: --max-work N
allows N steps, about N nanoseconds, instead of 4000000000.
examples:
  geometric_continuity extend a.g2 --order curvature -o longer.g2 \
      --plot longer.svg
  geometric_continuity extend a.g2 --order torsion --toward 1,2,3/2 \
      -o longer.g2
Exit code: 0 when the join has the order that is asked for, 1 when rounding has
broken it (--kernel double; the files are written nevertheless), 2 on bad input.
)";

// Returns the point of --toward.
template <class FT> typename Program_curve<FT>::Point end_point(const Command_line& line, int dimension) {
  const std::vector<FT> x = line.numbers<FT>("toward");
  if (static_cast<int>(x.size()) != dimension)
    throw std::invalid_argument("--toward: " + std::to_string(dimension) + " coordinates are needed, such as 1,2,3/2");
  return {dimension, x.begin(), x.end()};
}

template <class FT> std::optional<FT> optional_number(const Command_line& line, const std::string& option) {
  if (!line.has(option)) return std::nullopt;
  return line.number(option, FT(0));
}

template <class FT>
Program_curve<FT> next_segment(const Command_line& line, const Program_curve<FT>& last, GC::Frenet_order order) {
  const FT beta = line.number("beta", FT(1));
  if (!line.has("toward"))
    return GC::extend(
        last, order,
        {beta, optional_number<FT>(line, "c0"), optional_number<FT>(line, "c1"), optional_number<FT>(line, "c2")});
  for (const char* option : {"c0", "c1", "c2"})
    if (line.has(option)) throw std::invalid_argument(std::string("--toward chooses --") + option + " itself");
  return GC::extend_toward(last, order, end_point<FT>(line, last.dimension()), beta);
}

template <class FT> int extend(const Command_line& line) {
  typedef GC::Frenet_order Order;
  const std::string name = line.choice("order", {"tangent", "curvature", "torsion"});
  const Order order = name == "tangent" ? Order::tangent : name == "curvature" ? Order::curvature : Order::torsion;
  for (const auto& [option, needed] :
       {std::pair("c0", Order::curvature), {"c1", Order::torsion}, {"c2", Order::torsion}})
    if (line.has(option) && order < needed)
      throw std::invalid_argument(std::string("--") + option + " has no meaning for --order " + name);
  const std::vector<Program_curve<FT>> curves = read_curves<FT>(line.files());
  const Program_curve<FT>& last = curves.back();
  const Program_curve<FT> next = [&] {
    const GC::Work_scope scope(GC::Work_scope::limit_of_each(), "extend");
    return next_segment(line, last, order);
  }();
  const Join join = decided_join(as_written(last), as_written(next), 3);
  const bool proved = order == Order::tangent                             ? join.g_order >= 1
                      : order == Order::curvature || next.dimension() < 3 ? join.g_order >= 2
                                                                          : join.f_order >= 3;
  report_stream(line) << *next.polynomial() << '\n' // extensions are
                      << join << '\n'
                      << (proved ? "the join is proved in exact arithmetic\n"
                                 : "decided in exact arithmetic: rounding has broken the join\n");

  GC::Svg_panel panel;
  if (line.has("plot")) {
    const GC::Svg_style given{GC::Svg_role::given, false, true}, neighbour{GC::Svg_role::given, true, true},
        added{GC::Svg_role::result, true, true, "extension"};
    for (const Program_curve<FT>& c : curves) panel.add(c, &c == &last ? neighbour : given);
    panel.join(orders(join)).add(next, added);
  }
  write_shapes(line, [&](std::ostream& os) {
    for (const Program_curve<FT>& c : curves) GC::write_g2(os, c);
    GC::write_g2(os, next);
  });
  if (line.has("plot")) write_output(line.text("plot"), [&](std::ostream& os) { os << GC::Svg_figure().add(panel); });
  return proved ? requirement_met : requirement_not_met;
}

void describe_extend(po::options_description_easy_init add) {
  add("order", po::value<std::string>(), "tangent, curvature or torsion: what is continuous");
  add("beta", po::value<std::string>(),
      "R > 0, length of the new parameter interval in terms of the last one (default 1)");
  add("c0", po::value<std::string>(), "R, chooses b2 on its line");
  add("c1", po::value<std::string>(), "R, chooses b3 in its plane");
  add("c2", po::value<std::string>(), "R, chooses b3 in its plane");
  add("toward", po::value<std::string>(), "X,Y[,Z], where the segment shall end");
  add("kernel", po::value<std::string>()->default_value("exact"),
      "exact: construct in exact numbers; double: in floating-point numbers");
  add("max-work", po::value<std::string>(), "the steps of work that are allowed");
  add_shape_output(add, "all curves of A and the new one");
  add("plot", po::value<std::string>(), "draw the result, .svg");
}

int run_extend(const Command_line& line) {
  if (line.files().size() != 1) throw std::invalid_argument("extend: one file is needed; see --help");
  if (!line.has("order")) throw std::invalid_argument("extend: --order is needed; see --help");
  if (!line.has("output")) throw std::invalid_argument("extend: -o OUT.g2 is needed");
  check_shape_output(line);
  const GC::Work_scope each(line.work_limit());
  return within_work_limit(
      [&] { return input_name(line.files()[0]); },
      [&] {
        return line.choice("kernel", {"exact", "double"}) == "exact" ? extend<Exact>(line) : extend<double>(line);
      });
}

} // namespace

const Command extend_command{"extend", extend_usage, describe_extend, run_extend};
