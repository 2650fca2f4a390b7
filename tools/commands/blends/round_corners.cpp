// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/blends/round_corners.h"

#include "commands/blends/arc_length.h"
#include "commands/chains/join_report.h"
#include "commands/curvature_options.h"
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

// The curves of which a blend is made.
template <class Traits, int Degree>
std::vector<GC::Bezier_curve<Traits>> pieces_of(const GC::Bezier_curve<Traits, Degree>& blend) {
  return {blend};
}
template <class Traits>
std::vector<GC::Bezier_curve<Traits>> pieces_of(const GC::Composite_bezier_curve<Traits>& blend) {
  std::vector<GC::Bezier_curve<Traits>> pieces;
  for (const auto& segment : blend.segments()) pieces.emplace_back(segment);
  return pieces;
}

// Returns the chain with the corner after the curve number i rounded, cyclically.
template <class FT, class Strategy>
Rounded<FT> with_corner(const Chain<FT>& chain, int i, const FT& distance, const Strategy& strategy) {
  const std::size_t left = static_cast<std::size_t>(i), right = (left + 1) % chain.size();
  const auto corner = GC::round_corner(chain[left], chain[right], distance, strategy);
  const auto pieces = pieces_of(corner.blend);
  Rounded<FT> result{chain, {{left, distance, corner.left_cut, corner.right_cut, left + 1, pieces.size()}}};
  result.curves[left] = corner.left;
  result.curves[right] = corner.right;
  result.curves.insert(result.curves.begin() + i + 1, pieces.begin(), pieces.end());
  return result;
}

// At the distance that is asked for, or at that of a circle with the radius.
template <class FT, class Strategy>
Rounded<FT> rounded_chain(const Command_line& line, const Chain<FT>& chain, int order, const Strategy& strategy) {
  const int n = static_cast<int>(chain.size());
  const FT size = line.number<FT>(line.has("radius") ? "radius" : "distance", FT(0));
  if (!line.has("corner")) {
    const GC::Closure closure = line.has("closed") ? GC::Closure::closed : GC::Closure::open;
    const int least = line.choice("corners", {"all", "not-g1"}) == "all" ? order : 1;
    if (line.has("radius"))
      return GC::round_corners(chain.begin(), chain.end(), GC::Corner_radius{size}, closure, least, strategy);
    return GC::round_corners(chain.begin(), chain.end(), size, closure, least, strategy);
  }
  if (n < 2) throw std::invalid_argument("--corner: at least 2 curves are needed");
  const int i = line.integer("corner", 0, n - 1);
  if (!line.has("radius")) return with_corner(chain, i, size, strategy);
  const FT distance =
      GC::corner_distance(chain[static_cast<std::size_t>(i)], chain[static_cast<std::size_t>((i + 1) % n)], size);
  return with_corner(chain, i, distance, strategy);
}

// A chain as a strategy rounds it; all strategies cut the corners at the same places.
template <class FT> struct Variant {
  std::string strategy;
  Rounded<FT> result;
};

// By the strategy that is asked for, or by those that a bound on the curvature lets choose from.
template <class FT>
std::vector<Variant<FT>> variants(const Command_line& line, const Chain<FT>& chain, int order, bool is_bounded) {
  std::vector<Variant<FT>> result;
  const auto add = [&](const std::string& name, const auto& strategy) {
    result.push_back({name, rounded_chain(line, chain, order, strategy)});
  };
  if (line.has("cubic")) {
    add("cubic", GC::Cubics());
    if (is_bounded) add("two cubics", GC::Cubics{false});
  } else if (order == 3)
    add("fair_g3", GC::Fair_g3());
  else {
    add("fair", GC::Fair());
    if (is_bounded && !line.has("strategy")) {
      add("energy3", GC::Minimal_energy<3>());
      add("min_second", GC::Minimal_second_derivative());
    }
  }
  return result;
}

// A corner whose blend exceeds a bound: the curve of it that is bent most.
struct Bent_corner {
  std::size_t curve; // of the pieces of the blend
  GC::Curvature_excess excess;
};
template <class FT>
std::optional<Bent_corner> bent_corner(const Rounded<FT>& chain, std::size_t corner, const Curvature_bound& bound) {
  std::optional<Bent_corner> worst;
  const GC::Rounded_join<FT>& join = chain.corners[corner];
  for (std::size_t k = 0; k < join.pieces; ++k) {
    const auto excess = curvature_excess(as_written(chain.curves[join.blend + k]), bound);
    if (excess && (!worst || size_of(worst->excess).upper < size_of(*excess).upper)) worst = Bent_corner{k, *excess};
  }
  return worst;
}

// The choice for a corner: the number of the variant, and where it exceeds the bound.
struct Choice {
  std::size_t variant = 0;
  std::optional<Bent_corner> bent = {};
};

// For each corner the first variant that meets the bound, or that which is bent least.
template <class FT>
std::vector<Choice> choices(const std::vector<Variant<FT>>& variants, const std::optional<Curvature_bound>& bound) {
  std::vector<Choice> result(variants[0].result.corners.size());
  if (!bound) return result;
  for (std::size_t c = 0; c < result.size(); ++c) {
    result[c].bent = bent_corner(variants[0].result, c, *bound);
    for (std::size_t v = 1; v < variants.size() && result[c].bent; ++v) {
      const std::optional<Bent_corner> bent = bent_corner(variants[v].result, c, *bound);
      if (!bent || size_of(bent->excess).upper < size_of(result[c].bent->excess).upper) result[c] = {v, bent};
    }
  }
  return result;
}

// The chain with the chosen blends.
template <class FT>
Rounded<FT> chosen_chain(const std::vector<Variant<FT>>& variants, const std::vector<Choice>& choices) {
  const Rounded<FT>& first = variants[0].result;
  Rounded<FT> result;
  std::size_t copied = 0; // of the first variant
  for (std::size_t c = 0; c < choices.size(); ++c) {
    const Rounded<FT>& chosen = variants[choices[c].variant].result;
    const GC::Rounded_join<FT>&from = chosen.corners[c], &instead_of = first.corners[c];
    result.curves.insert(result.curves.end(), first.curves.begin() + copied, first.curves.begin() + instead_of.blend);
    result.corners.push_back(from);
    result.corners.back().blend = result.curves.size();
    result.curves.insert(result.curves.end(), chosen.curves.begin() + from.blend,
                         chosen.curves.begin() + from.blend + from.pieces);
    copied = instead_of.blend + instead_of.pieces;
  }
  result.curves.insert(result.curves.end(), first.curves.begin() + copied, first.curves.end());
  return result;
}

// Throws GC::Error `not_finite` for coordinates that are too large to be drawn.
template <class FT> GC::Svg_figure picture(const std::string& title, const Rounded<FT>& result) {
  GC::Svg_panel panel;
  auto corner = result.corners.begin();
  for (std::size_t k = 0; k < result.curves.size(); ++k) {
    const bool is_blend = corner != result.corners.end() && corner->blend <= k;
    panel.add(result.curves[k], is_blend ? GC::Svg_style{GC::Svg_role::result, false, true, "blend"}
                                         : GC::Svg_style{GC::Svg_role::given, false, true});
    if (is_blend && corner->blend + corner->pieces == k + 1) ++corner;
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
  // A corner, how far from it the curves are cut, along them, and the joins of its blend: at both
  // ends, and between its pieces.
  struct Corner {
    std::size_t join, blend, pieces;
    GC::Enclosure left, right;
    Join start, end;
    std::vector<Join> inner;
    std::string strategy;
    std::optional<Bent_corner> bent;
  };

  std::size_t given; // the number of curves
  int order;         // that is asked for
  std::vector<Corner> corners = {};
  std::vector<Join> joins = {}; // of the whole chain
  std::optional<Curvature_bound> bound = {};
  std::string strategies = {}; // from which is chosen

  template <class FT> Corners_report(const Chain<FT>& chain, const Rounded<FT>& result, bool closed, int order);

  // Takes what was chosen for each corner.
  template <class FT>
  void set_choices(const std::vector<Variant<FT>>& variants, const std::vector<Choice>& choices,
                   const std::optional<Curvature_bound>& given_bound) {
    bound = given_bound;
    for (const Variant<FT>& v : variants) strategies += (strategies.empty() ? "" : ", ") + v.strategy;
    for (std::size_t c = 0; c < corners.size(); ++c) {
      corners[c].strategy = variants[choices[c].variant].strategy;
      corners[c].bent = choices[c].bent;
    }
  }

  // How many joins of the blends are not of the order.
  std::size_t broken() const {
    std::size_t n = 0;
    for (const Corner& c : corners) {
      n += std::size_t(c.start.g_order < order) + std::size_t(c.end.g_order < order);
      for (const Join& join : c.inner) n += std::size_t(join.g_order < order);
    }
    return n;
  }
  std::size_t blend_joins() const {
    std::size_t n = 2 * corners.size();
    for (const Corner& c : corners) n += c.inner.size();
    return n;
  }
  std::size_t bent() const {
    return static_cast<std::size_t>(
        std::count_if(corners.begin(), corners.end(), [](const Corner& c) { return c.bent.has_value(); }));
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
    const auto first = joins.begin() + static_cast<std::ptrdiff_t>(corner.blend),
               last = first + static_cast<std::ptrdiff_t>(corner.pieces) - 1;
    corners.push_back({corner.join, corner.blend, corner.pieces,
                       Arc_length::of(left.split(Exact(corner.left_cut)).second),
                       Arc_length::of(right.split(Exact(corner.right_cut)).first), joins[corner.blend - 1], *last,
                       std::vector<Join>(first, last), "", std::nullopt});
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
    write_row(os, {std::to_string(c.join) + " -> " + std::to_string((c.join + 1) % report.given),
                   std::to_string(c.blend) + (c.pieces == 1 ? "" : ", " + std::to_string(c.blend + 1)),
                   left == right ? left : left + " and " + right, orders(c.start), orders(c.end)});
  }
  GC::Chain_summary summary;
  for (const Join& join : report.joins) summary.add(join);
  const std::size_t n = report.corners.size();
  os << n << (n == 1 ? " corner is rounded" : " corners are rounded")
     << (n == 0               ? ""
         : report.is_proved() ? (report.blend_joins() == 2 * n ? ", both joins" : ", all joins") +
                                    std::string(" of every blend are proved in exact arithmetic")
                              : "; decided in exact arithmetic: " + broken_joins(report.broken(), report.blend_joins()))
     << "\nthe chain: " << summary << '\n';
  if (!report.bound) return;
  for (const Corners_report::Corner& c : report.corners)
    if (c.bent)
      os << "corner " << c.join << " -> " << (c.join + 1) % report.given << ": " << to_string(c.bent->excess)
         << " of curve " << c.blend + c.bent->curve << '\n';
  if (report.bent() == 0)
    os << "every blend is " << report.bound->words << ", proved exactly\n";
  else
    os << counted(report.bent(), "blend") << " not " << report.bound->words << ", the least of " << report.strategies
       << "; a larger --distance bends less\n";
}

void write_json(std::ostream& os, const Corners_report& report) {
  os << "{\"corners\":[";
  const char* separator = "\n";
  for (const Corners_report::Corner& c : report.corners) {
    os << separator << "{\"join\":" << c.join << ",\"blend\":" << c.blend << ",\"left_distance\":";
    GC::write_json(os, c.left);
    GC::write_json(os << ",\"right_distance\":", c.right);
    GC::write_json(os << ",\"start_join\":", c.start, c.blend - 1, c.blend);
    GC::write_json(os << ",\"end_join\":", c.end, c.blend + c.pieces - 1, c.blend + c.pieces);
    os << ",\"pieces\":" << c.pieces;
    for (const Join& join : c.inner) GC::write_json(os << ",\"inner_join\":", join, c.blend, c.blend + 1);
    GC::write_json(os << ",\"strategy\":", c.strategy);
    if (report.bound) os << ",\"max_curvature_met\":" << (c.bent ? "false" : "true");
    if (c.bent) {
      write_json_members(os << ",\"bent\":{\"curve\":" << c.blend + c.bent->curve << ',', c.bent->excess);
      os << '}';
    }
    os << '}';
    separator = ",\n";
  }
  int least = 3;
  for (const Join& join : report.joins) least = (std::min)(least, join.c_order < 0 ? -1 : join.g_order);
  os << "],\n\"order\":" << report.order << ",\"proved\":" << (report.is_proved() ? "true" : "false")
     << (report.bound
             ? ",\n" + json_member(*report.bound) + ",\"max_curvature_met\":" + (report.bent() == 0 ? "true" : "false")
             : "")
     << ",\n\"chain\":{\"joins\":" << report.joins.size()
     << ",\"g_order\":" << (report.joins.empty() ? "null" : std::to_string(least)) << "}}\n";
}

template <class FT> Exit_code round_corners(const Command_line& line) {
  const Arguments files = line.files();
  const int order = line.integer("order", 2, 3);
  if (line.has("strategy")) line.choice("strategy", {order == 2 ? "fair" : "fair_g3"});
  const std::optional<Curvature_bound> bound = curvature_bound(line);
  if (files.size() != 1) throw std::invalid_argument("blend --corner, --corners: one file is needed; see --help");
  const Chain<FT> chain = read_curves<FT>(files);
  if (line.has("corners") && chain.size() == 1 && !line.has("closed")) throw std::invalid_argument(no_join);
  const std::vector<Variant<FT>> all = [&] {
    try {
      return variants<FT>(line, chain, order, bound.has_value());
    } catch (const GC::Error& e) {
      throw std::invalid_argument(input_name(files[0]) + ": " + e.what());
    }
  }();
  const std::vector<Choice> chosen = choices(all, bound);
  const Rounded<FT> result = chosen_chain(all, chosen);

  std::optional<GC::Svg_figure> figure;
  if (line.has("plot")) figure = picture(line.text("title"), result);
  Corners_report report(chain, result, line.has("closed"), order);
  report.set_choices(all, chosen, bound);
  if (line.has("json"))
    write_json(report_stream(line), report);
  else
    write_text(report_stream(line), report);
  if (line.has("output"))
    write_shapes(line, [&](std::ostream& os) {
      for (const Program_curve<FT>& c : result.curves) GC::write_g2(os, c);
    });
  if (figure) write_output(line.text("plot"), [&](std::ostream& os) { figure->write(os); });
  return report.is_proved() && report.bent() == 0 ? requirement_met : requirement_not_met;
}

} // namespace

Exit_code round_corners(const Command_line& line) {
  if (line.has("corner") && line.has("corners")) throw std::invalid_argument("--corner and --corners: one of them");
  if (line.has("cubic")) {
    line.refuse({"strategy"}, "not with --cubic");
    if (line.integer("order") != 2) throw std::invalid_argument("--cubic: joins of order 2 only");
  }
  if (line.has("distance") && line.has("radius")) throw std::invalid_argument("--distance and --radius: one of them");
  if (!line.has("distance") && !line.has("radius"))
    throw std::invalid_argument("--corner, --corners: --distance is needed, or --radius");
  if (line.has("corner")) line.refuse({"closed"}, "only with --corners");
  line.refuse({"replace", "representable", "beta", "eta", "s1", "s2", "start", "end"},
              "not with --corner or --corners");
  return line.choice("kernel", {"exact", "double"}) == "exact" ? round_corners<Exact>(line)
                                                               : round_corners<double>(line);
}
