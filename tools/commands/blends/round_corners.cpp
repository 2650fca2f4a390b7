// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/blends/round_corners.h"

#include "commands/blends/arc_length.h"
#include "commands/chains/join_report.h"
#include "files/output.h"
#include "formats/g2_text/curves.h"
#include "formats/shapes/write_shapes.h"

#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
#include <CGAL/Geometric_continuity/repairs/round_corners.h>
#include <Geometric_continuity_figures/Svg_figure.h>

#include <algorithm>
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
Rounded<FT> with_corner(const Chain<FT>& chain, int i, const FT& distance, const Strategy& strategy) {
  const std::size_t left = static_cast<std::size_t>(i), right = (left + 1) % chain.size();
  const auto corner = GC::round_corner(chain[left], chain[right], distance, strategy);
  Rounded<FT> result{chain, {{left, distance, corner.left_cut, corner.right_cut, left + 1}}};
  result.curves[left] = corner.left;
  result.curves[right] = corner.right;
  result.curves.insert(result.curves.begin() + i + 1, corner.blend);
  return result;
}

template <class FT, class Strategy>
Rounded<FT> rounded_chain(const Command_line& line, const Chain<FT>& chain, const FT& distance, int order,
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

// The corners that were rounded in a chain, as it is written, decided exactly.
struct Corners_report {
  // A corner, how far from it the curves are cut, along them, and the joins of its blend.
  struct Corner {
    std::size_t join, blend;
    GC::Enclosure left, right;
    Join start, end;
  };

  std::size_t given; // the number of curves
  int order;         // that is asked for
  std::vector<Corner> corners = {};
  std::vector<Join> joins = {}; // of the whole chain

  template <class FT> Corners_report(const Chain<FT>& chain, const Rounded<FT>& result, bool closed, int order);

  // How many joins of the blends are not of the order.
  std::size_t broken() const {
    std::size_t n = 0;
    for (const Corner& c : corners) n += std::size_t(c.start.g_order < order) + std::size_t(c.end.g_order < order);
    return n;
  }
  bool is_proved() const { return broken() == 0; }
};

template <class FT>
Corners_report::Corners_report(const Chain<FT>& chain, const Rounded<FT>& result, bool closed, int order)
    : given(chain.size()), order(order) {
  std::vector<Exact_curve> curves;
  for (const Program_curve<FT>& c : result.curves) curves.push_back(as_written(c));
  closed = closed || (!result.corners.empty() && result.corners.back().join + 1 == given);
  joins = GC::chain_joins(curves, 3, closed ? GC::Closure::closed : GC::Closure::open);
  for (const GC::Rounded_join<FT>& corner : result.corners) {
    const Exact_curve left = exact(chain[corner.join]), right = exact(chain[(corner.join + 1) % given]);
    corners.push_back({corner.join, corner.blend, Arc_length::of(left.split(Exact(corner.left_cut)).second),
                       Arc_length::of(right.split(Exact(corner.right_cut)).first), joins[corner.blend - 1],
                       joins[corner.blend]});
  }
}

// A length to six digits, or its bounds where these are not the same to six digits.
std::string six_digits_of(const GC::Enclosure& x) {
  const std::string lower = rounded(x.lower, 6), upper = rounded(x.upper, 6);
  return lower == upper ? lower : '[' + lower + ", " + upper + ']';
}

void write_text(std::ostream& os, const Corners_report& report) {
  write_row(os, {"corner", "blend", "distance", "start join", "end join"});
  for (const Corners_report::Corner& c : report.corners) {
    const std::string left = six_digits_of(c.left), right = six_digits_of(c.right);
    write_row(os,
              {std::to_string(c.join) + " -> " + std::to_string((c.join + 1) % report.given), std::to_string(c.blend),
               left == right ? left : left + " and " + right, orders(c.start), orders(c.end)});
  }
  GC::Chain_summary summary;
  for (const Join& join : report.joins) summary.add(join);
  const std::size_t n = report.corners.size();
  os << n << (n == 1 ? " corner is rounded" : " corners are rounded")
     << (n == 0               ? ""
         : report.is_proved() ? ", both joins of every blend are proved in exact arithmetic"
                              : "; decided in exact arithmetic: " + broken_joins(report.broken(), 2 * n))
     << "\nthe chain: " << summary << '\n';
}

void write_json(std::ostream& os, const Corners_report& report) {
  os << "{\"corners\":[";
  const char* separator = "\n";
  for (const Corners_report::Corner& c : report.corners) {
    os << separator << "{\"join\":" << c.join << ",\"blend\":" << c.blend << ",\"left_distance\":";
    GC::write_json(os, c.left);
    GC::write_json(os << ",\"right_distance\":", c.right);
    GC::write_json(os << ",\"start_join\":", c.start, c.blend - 1, c.blend);
    GC::write_json(os << ",\"end_join\":", c.end, c.blend, c.blend + 1);
    os << '}';
    separator = ",\n";
  }
  int least = 3;
  for (const Join& join : report.joins) least = (std::min)(least, join.c_order < 0 ? -1 : join.g_order);
  os << "],\n\"order\":" << report.order << ",\"proved\":" << (report.is_proved() ? "true" : "false")
     << ",\n\"chain\":{\"joins\":" << report.joins.size()
     << ",\"g_order\":" << (report.joins.empty() ? "null" : std::to_string(least)) << "}}\n";
}

template <class FT> Exit_code round_corners(const Command_line& line) {
  const Arguments files = line.files();
  const int order = line.integer("order", 2, 3);
  if (line.has("strategy")) line.choice("strategy", {order == 2 ? "fair" : "fair_g3"});
  if (files.size() != 1) throw std::invalid_argument("blend --corner, --corners: one file is needed; see --help");
  const FT distance = line.number<FT>("distance", FT(0));
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
  const Corners_report report(chain, result, line.has("closed"), order);
  if (line.has("json"))
    write_json(report_stream(line), report);
  else
    write_text(report_stream(line), report);
  if (line.has("output"))
    write_shapes(line, [&](std::ostream& os) {
      for (const Program_curve<FT>& c : result.curves) GC::write_g2(os, c);
    });
  if (figure) write_output(line.text("plot"), [&](std::ostream& os) { figure->write(os); });
  return report.is_proved() ? requirement_met : requirement_not_met;
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
