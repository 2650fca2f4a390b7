// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/blends/round_corners.h"

#include "commands/chains/join_report.h"
#include "files/output.h"
#include "formats/g2_text/curves.h"

#include <CGAL/Geometric_continuity/IO/figures/Svg_figure.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
#include <CGAL/Geometric_continuity/repairs/round_corners.h>

#include <array>
#include <cstddef>
#include <iomanip>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

template <class FT> using Chain = std::vector<Program_curve<FT>>;
template <class FT> using Rounded = GC::Rounded_chain<Program_curve<FT>>;

// Returns the chain with the corner after the curve number i rounded, cyclically.
template <class FT, class Strategy>
Rounded<FT> with_corner(const Chain<FT>& chain, int i, double distance, const Strategy& strategy) {
  const std::size_t left = static_cast<std::size_t>(i), right = (left + 1) % chain.size();
  const auto corner = GC::round_corner(chain[left], chain[right], distance, strategy);
  Rounded<FT> result{chain, {{left, distance, corner.left_cut, corner.right_cut, left + 1}}};
  result.curves[left] = corner.left;
  result.curves[right] = corner.right;
  result.curves.insert(result.curves.begin() + i + 1, corner.blend);
  return result;
}

template <class FT, class Strategy>
Rounded<FT> rounded_chain(const Command_line& line, const Chain<FT>& chain, double distance, int order,
                          const Strategy& strategy) {
  const int n = static_cast<int>(chain.size());
  if (!line.has("corner"))
    return GC::round_corners(chain.begin(), chain.end(), distance,
                             line.has("closed") ? GC::Closure::closed : GC::Closure::open,
                             line.choice("corners", {"all", "not-g1"}) == "all" ? order : 1, strategy);
  if (n < 2) throw std::invalid_argument("--corner: at least 2 curves are needed");
  return with_corner(chain, line.integer("corner", 0, n - 1), distance, strategy);
}

// Throws GC::Error `not_finite` for coordinates that are too large to be drawn.
template <class FT> GC::Svg_figure picture(const std::string& title, const Rounded<FT>& result) {
  GC::Svg_panel panel;
  auto corner = result.corners.begin();
  for (std::size_t k = 0; k < result.curves.size(); ++k) {
    const bool is_blend = corner != result.corners.end() && corner->blend == k;
    panel.add(result.curves[k], is_blend ? GC::Svg_style{GC::Svg_role::result, false, true, "blend"}
                                         : GC::Svg_style{GC::Svg_role::given, false, true});
    if (is_blend) ++corner;
  }
  GC::Svg_figure figure(title, 1);
  figure.add(panel);
  return figure;
}

void write_row(std::ostream& os, const std::array<std::string, 5>& columns) {
  os << std::left << std::setw(12) << columns[0] << ' ' << std::right << std::setw(6) << columns[1] << ' '
     << std::setw(10) << columns[2] << "  " << std::left << std::setw(12) << columns[3] << ' ' << columns[4] << '\n';
}

// Prints the corners and their blends. Returns whether both joins of every blend have the order. `given` is the number of given
// curves.
template <class FT>
bool write_report(std::ostream& os, const Rounded<FT>& result, std::size_t given, bool closed, int order) {
  std::vector<Exact_curve> curves;
  for (const Program_curve<FT>& c : result.curves) curves.push_back(as_written(c));
  closed = closed || (!result.corners.empty() && result.corners.back().join + 1 == given);
  const std::vector<Join> joins = GC::chain_joins(curves, 3, closed ? GC::Closure::closed : GC::Closure::open);
  GC::Chain_summary summary;
  for (const Join& join : joins) summary.add(join);
  write_row(os, {"corner", "blend", "distance", "start join", "end join"});
  std::size_t broken = 0;
  for (const GC::Rounded_join<FT>& corner : result.corners) {
    const Join &start = joins[corner.blend - 1], &end = joins[corner.blend];
    broken += std::size_t(start.g_order < order) + std::size_t(end.g_order < order);
    write_row(os, {std::to_string(corner.join) + " -> " + std::to_string((corner.join + 1) % given),
                   std::to_string(corner.blend), rounded(corner.distance, 6), orders(start), orders(end)});
  }
  const std::size_t n = result.corners.size();
  os << n << (n == 1 ? " corner is rounded" : " corners are rounded")
     << (n == 0        ? ""
         : broken == 0 ? ", both joins of every blend are proved in exact arithmetic"
                       : "; decided in exact arithmetic: " + broken_joins(broken, 2 * n))
     << "\nthe chain: " << summary << '\n';
  return broken == 0;
}

template <class FT> Exit_code round_corners(const Command_line& line) {
  const Arguments files = line.files();
  const int order = line.integer("order", 2, 3);
  if (line.has("strategy")) line.choice("strategy", {order == 2 ? "fair" : "fair_g3"});
  if (files.size() != 1) throw std::invalid_argument("blend --corner, --corners: one file is needed; see --help");
  const double distance = line.number<double>("distance", 0);
  const Chain<FT> chain = read_curves<FT>(files);
  if (line.has("corners") && chain.size() == 1 && !line.has("closed")) throw std::invalid_argument(no_join);
  const Rounded<FT> result = [&] {
    try {
      return order == 2 ? rounded_chain(line, chain, distance, order, GC::Fair())
                        : rounded_chain(line, chain, distance, order, GC::Fair_g3());
    } catch (const GC::Error& e) {
      throw std::invalid_argument(input_name(files[0]) + ": " + e.what());
    }
  }();

  std::optional<GC::Svg_figure> figure;
  if (line.has("plot")) figure = picture(line.text("title"), result);
  const bool proved = write_report(report_stream(line), result, chain.size(), line.has("closed"), order);
  if (line.has("output"))
    write_output(line.text("output"), [&](std::ostream& os) {
      for (const Program_curve<FT>& c : result.curves) GC::write_g2(os, c);
    });
  if (figure) write_output(line.text("plot"), [&](std::ostream& os) { figure->write(os); });
  return proved ? requirement_met : requirement_not_met;
}

} // namespace

Exit_code round_corners(const Command_line& line) {
  if (line.has("corner") && line.has("corners")) throw std::invalid_argument("--corner and --corners: one of them");
  if (!line.has("distance")) throw std::invalid_argument("--corner, --corners: --distance is needed");
  if (line.has("corner")) line.refuse({"closed"}, "only with --corners");
  line.refuse({"replace", "representable", "beta", "eta", "s1", "s2", "start", "end"},
              "not with --corner or --corners");
  return line.choice("kernel", {"exact", "double"}) == "exact" ? round_corners<Exact>(line)
                                                               : round_corners<double>(line);
}
