include <CGAL/Geometric_continuity/extensions/extend.h>// Copyright (c) 2026 The Geometric_continuity developers
include <CGAL/Geometric_continuity/extensions/extend.h>//
include <CGAL/Geometric_continuity/extensions/extend.h>// SPDX-License-Identifier: LGPL-3.0-or-later
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include "command_line.h"
include <CGAL/Geometric_continuity/extensions/extend.h>#include "join_report.h"
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/IO/atomic_file.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/IO/figures/Svg_figure.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <sstream>
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>namespace {
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>const char* const usage =
include <CGAL/Geometric_continuity/extensions/extend.h>    "usage: geometric_continuity extend A.g2 --order tangent|curvature|torsion [OPTIONS] -o OUT.g2\n"
include <CGAL/Geometric_continuity/extensions/extend.h>    "\n"
include <CGAL/Geometric_continuity/extensions/extend.h>    "Appends a segment of the same degree behind the last curve of A. Its first points are members of Hagen's "
include <CGAL/Geometric_continuity/extensions/extend.h>    "families:\n"
include <CGAL/Geometric_continuity/extensions/extend.h>    "  b1 = b0 + beta p, b2 = b0 + beta^2 (b-2 - b0) + C0 p, b3 = b0 + beta^3 (b-2 - b-3) + C1 p + C2 r\n"
include <CGAL/Geometric_continuity/extensions/extend.h>    "with p = b0 - b-1, r = b-2 - b-1. What is not given continues the curve as smoothly as possible; with --toward "
include <CGAL/Geometric_continuity/extensions/extend.h>    "the\n"
include <CGAL/Geometric_continuity/extensions/extend.h>    "segment ends at the point, or as near as it can, with the least energy. The join is decided exactly on the "
include <CGAL/Geometric_continuity/extensions/extend.h>    "result.\n"
include <CGAL/Geometric_continuity/extensions/extend.h>    "Of a curve with inner knots the last span decides; all curves are written as Bezier curves.\n";
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// The coordinates of --toward.
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> typename Program_curve<FT>::Point point(const std::string& text, int dimension) {
include <CGAL/Geometric_continuity/extensions/extend.h>  std::istringstream words(text);
include <CGAL/Geometric_continuity/extensions/extend.h>  std::vector<FT> x;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (std::string word; std::getline(words, word, ',');) x.push_back(GC::parse_number<FT>(word));
include <CGAL/Geometric_continuity/extensions/extend.h>  if (static_cast<int>(x.size()) != dimension)
include <CGAL/Geometric_continuity/extensions/extend.h>    throw std::invalid_argument("--toward: " + std::to_string(dimension) + " coordinates are needed, such as 1,2,3/2");
include <CGAL/Geometric_continuity/extensions/extend.h>  return {dimension, x.begin(), x.end()};
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> std::optional<FT> optional_number(const Command_line& line, const std::string& option) {
include <CGAL/Geometric_continuity/extensions/extend.h>  if (!line.has(option)) return std::nullopt;
include <CGAL/Geometric_continuity/extensions/extend.h>  return line.number(option, FT(0));
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT>
include <CGAL/Geometric_continuity/extensions/extend.h>Program_curve<FT> next_segment(const Command_line& line, const Program_curve<FT>& last, GC::Frenet_order order) {
include <CGAL/Geometric_continuity/extensions/extend.h>  const FT beta = line.number("beta", FT(1));
include <CGAL/Geometric_continuity/extensions/extend.h>  if (!line.has("toward"))
include <CGAL/Geometric_continuity/extensions/extend.h>    return GC::extend(
include <CGAL/Geometric_continuity/extensions/extend.h>        last, order,
include <CGAL/Geometric_continuity/extensions/extend.h>        {beta, optional_number<FT>(line, "c0"), optional_number<FT>(line, "c1"), optional_number<FT>(line, "c2")});
include <CGAL/Geometric_continuity/extensions/extend.h>  for (const char* option : {"c0", "c1", "c2"})
include <CGAL/Geometric_continuity/extensions/extend.h>    if (line.has(option)) throw std::invalid_argument(std::string("--toward chooses --") + option + " itself");
include <CGAL/Geometric_continuity/extensions/extend.h>  return GC::extend_toward(last, order, point<FT>(line.text("toward"), last.dimension()), beta);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> int extend(const Command_line& line) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Frenet_order Order;
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::string name = line.choice("order", {"tangent", "curvature", "torsion"});
include <CGAL/Geometric_continuity/extensions/extend.h>  const Order order = name == "tangent" ? Order::tangent : name == "curvature" ? Order::curvature : Order::torsion;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (const auto& [option, needed] :
include <CGAL/Geometric_continuity/extensions/extend.h>       {std::pair("c0", Order::curvature), {"c1", Order::torsion}, {"c2", Order::torsion}})
include <CGAL/Geometric_continuity/extensions/extend.h>    if (line.has(option) && order < needed)
include <CGAL/Geometric_continuity/extensions/extend.h>      throw std::invalid_argument(std::string("--") + option + " has no meaning for --order " + name);
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Program_curve<FT>> curves = read_curves<FT>(line.files());
include <CGAL/Geometric_continuity/extensions/extend.h>  const Program_curve<FT>& last = curves.back();
include <CGAL/Geometric_continuity/extensions/extend.h>  const Program_curve<FT> next = next_segment(line, last, order);
include <CGAL/Geometric_continuity/extensions/extend.h>  const Join join = GC::continuity(exact(last), exact(next));
include <CGAL/Geometric_continuity/extensions/extend.h>  std::cout << next << '\n' << join << '\n';
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>  GC::write_file_atomically(line.text("output"), [&](std::ostream& os) {
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const Program_curve<FT>& c : curves) GC::write_g2(os, c);
include <CGAL/Geometric_continuity/extensions/extend.h>    GC::write_g2(os, next);
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>  if (line.has("plot")) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const GC::Svg_style given{GC::Svg_role::given, false, true}, neighbour{GC::Svg_role::given, true, true},
include <CGAL/Geometric_continuity/extensions/extend.h>        added{GC::Svg_role::blend, true, true};
include <CGAL/Geometric_continuity/extensions/extend.h>    GC::Svg_panel panel;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const Program_curve<FT>& c : curves) panel.add(c, &c == &last ? neighbour : given);
include <CGAL/Geometric_continuity/extensions/extend.h>    panel.join(orders(join)).add(next, added);
include <CGAL/Geometric_continuity/extensions/extend.h>    GC::write_file_atomically(line.text("plot"), [&](std::ostream& os) { os << GC::Svg_figure().add(panel); });
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  return requirement_met;
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>} // namespace
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>int extend_command(const Arguments& arguments) {
include <CGAL/Geometric_continuity/extensions/extend.h>  const Command_line line(usage, arguments, [](po::options_description_easy_init add) {
include <CGAL/Geometric_continuity/extensions/extend.h>    add("order", po::value<std::string>(), "tangent, curvature or torsion: what is continuous");
include <CGAL/Geometric_continuity/extensions/extend.h>    add("beta", po::value<std::string>(), "R > 0, the length of the next parameter interval relative to the last; 1");
include <CGAL/Geometric_continuity/extensions/extend.h>    add("c0", po::value<std::string>(), "R, chooses b2 on its line");
include <CGAL/Geometric_continuity/extensions/extend.h>    add("c1", po::value<std::string>(), "R, chooses b3 in its plane");
include <CGAL/Geometric_continuity/extensions/extend.h>    add("c2", po::value<std::string>(), "R, chooses b3 in its plane");
include <CGAL/Geometric_continuity/extensions/extend.h>    add("toward", po::value<std::string>(), "x,y[,z], the wished end point");
include <CGAL/Geometric_continuity/extensions/extend.h>    add("kernel", po::value<std::string>()->default_value("exact"), "construct in exact numbers, or in double");
include <CGAL/Geometric_continuity/extensions/extend.h>    add("output,o", po::value<std::string>(), "write all curves of A and the new one, .g2");
include <CGAL/Geometric_continuity/extensions/extend.h>    add("plot", po::value<std::string>(), "draw the result, .svg");
include <CGAL/Geometric_continuity/extensions/extend.h>  });
include <CGAL/Geometric_continuity/extensions/extend.h>  if (line.help()) return requirement_met;
include <CGAL/Geometric_continuity/extensions/extend.h>  if (line.files().size() != 1) throw std::invalid_argument("extend: one file is needed; see --help");
include <CGAL/Geometric_continuity/extensions/extend.h>  if (!line.has("order")) throw std::invalid_argument("extend: --order is needed; see --help");
include <CGAL/Geometric_continuity/extensions/extend.h>  if (!line.has("output")) throw std::invalid_argument("extend: -o OUT.g2 is needed");
include <CGAL/Geometric_continuity/extensions/extend.h>  return line.choice("kernel", {"exact", "double"}) == "exact" ? extend<Exact>(line) : extend<double>(line);
include <CGAL/Geometric_continuity/extensions/extend.h>}
