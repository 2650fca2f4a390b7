// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/blends/blend_surfaces.h"
#include "commands/blends/blend_strategies.h"
#include "files/output.h"
#include "formats/g2_text/surfaces.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>
#include <CGAL/Geometric_continuity/surface_blends/representable_blend_surfaces.h>
#include <CGAL/Geometric_continuity/surfaces/possible_fold.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <istream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

typedef GC::Rational_bspline_surface<GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>>> Exact_surface;
typedef GC::Bspline_surface<GC::Traits_3<CGAL::Simple_cartesian<double>>> Double_surface;

std::vector<Exact_surface> read_surfaces(std::istream& is, const std::string& name, const Exact_surface*) {
  return GC::read_g2_rational_bspline_surfaces<Exact_surface::Traits>(is, name);
}
std::vector<Double_surface> read_surfaces(std::istream& is, const std::string& name, const Double_surface*) {
  return GC::read_g2_bspline_surfaces<Double_surface::Traits>(is, name);
}

// Reads the only surface of a file.
template <class Surface> Surface read_surface(const std::string& name) {
  Input input(name);
  const std::vector<Surface> surfaces = read_surfaces(input, input_name(name), static_cast<const Surface*>(nullptr));
  if (surfaces.size() != 1)
    throw GC::Error(GC::Error_code::malformed_input,
                    input_name(name) + ": " + std::to_string(surfaces.size()) + " surfaces where one is expected");
  return surfaces[0];
}

GC::Patch_edge edge_of(const std::string& name) {
  for (GC::Patch_edge edge : GC::patch_edges)
    if (to_string(edge) == name) return edge;
  throw std::invalid_argument("--edges: '" + name + "' is none of u0, u1, v0, v1");
}
std::pair<GC::Patch_edge, GC::Patch_edge> given_edges(const Command_line& line) {
  if (!line.has("edges")) return {GC::Patch_edge::v1, GC::Patch_edge::v0};
  const std::string text = line.text("edges");
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) throw std::invalid_argument("--edges: two names are needed, e.g. v1,v0");
  return {edge_of(text.substr(0, comma)), edge_of(text.substr(comma + 1))};
}

// Prints the continuity along the edge of a given surface, and returns whether the blend has the
// order there.
template <class Surface>
bool report_edge(std::ostream& report, int order, const std::string& file, const Surface& given, GC::Patch_edge edge,
                 const Surface& blend, GC::Patch_edge edge_of_blend) {
  report << input_name(file) << ", edge " << edge << ": ";
  if (order == 3 && is_g3_edge(given, edge, blend, edge_of_blend)) {
    report << "G3";
    return true;
  }
  const auto verdict = edge_continuity(given, edge, blend, edge_of_blend);
  report << verdict;
  return order == 2 && verdict.g_order >= 2;
}

// The derivatives of the parameter across an edge.
template <class Shape> void report_shape(std::ostream& report, const Shape& shape) {
  report << ", beta = " << shape.beta << ", delta = " << shape.delta;
  if constexpr (std::is_base_of_v<
                    GC::Septic_edge_reparametrisation<GC::Rational_edge_reparametrisation<CGAL::Exact_rational>>,
                    Shape>)
    report << ", delta3 = " << shape.delta3;
  report << '\n';
}

Exit_code report_order(std::ostream& report, int order, bool has_order) {
  report << (has_order ? "" : "not ") << 'G' << order << " along both edges"
         << (has_order ? ", proved exactly\n" : "\n");
  return has_order ? requirement_met : requirement_not_met;
}

// The search for folds may take long, and what it finds is no more than a warning: it never refuses
// the blend.
template <class Surface> void warn_of_fold(std::ostream& report, const Surface& s) {
  try {
    if (const auto fold = possible_fold(s))
      report << "warning: it may be folded near (" << CGAL::to_double(fold->u.first) << ", "
             << CGAL::to_double(fold->v.first) << "), where its normal may vanish\n";
  } catch (const GC::Error& e) {
    if (e.code() != GC::Error_code::work_limit) throw;
    report << "warning: it may be folded, which was not decided within --max-work\n";
  }
}

// As fractions, which are the same numbers in every arithmetic.
void write_exactly(std::ostream& os, const Double_surface& s) {
  typedef CGAL::Exact_rational FT;
  const auto exact = [](const GC::Knot_vector<double>& knots) {
    return GC::Knot_vector<FT>(knots.degree(), std::vector<FT>(knots.begin(), knots.end()));
  };
  std::vector<std::vector<Exact_surface::Point>> net(static_cast<std::size_t>(s.number_of_points_u()));
  for (int i = 0; i < s.number_of_points_u(); ++i)
    for (int j = 0; j < s.number_of_points_v(); ++j) {
      const Double_surface::Point& p = s.control_point(i, j);
      net[i].emplace_back(FT(p.x()), FT(p.y()), FT(p.z()));
    }
  GC::write_g2(os, GC::Bspline_surface<Exact_surface::Traits>(net, exact(s.knots_u()), exact(s.knots_v())));
}

// Whose control points are doubles; the given surfaces are written, too, as they now are.
template <class Strategy> Exit_code representable_blend_by(const Command_line& line, const Strategy& strategy) {
  const Arguments files = line.files();
  const Double_surface a = read_surface<Double_surface>(files[0]), b = read_surface<Double_surface>(files[1]);
  const auto [edge_a, edge_b] = given_edges(line);
  const auto r = representable_blend(a, edge_a, b, edge_b, strategy, nearer_direction(a, edge_a, b, edge_b));
  std::ostream& report = report_stream(line);
  const bool at_a = report_edge(report, 2, files[0], r.first, edge_a, r.blend, GC::Patch_edge::v0);
  report << ", beta = " << r.start_join.beta << '\n';
  const bool at_b = report_edge(report, 2, files[1], r.second, edge_b, r.blend, GC::Patch_edge::v1);
  report << ", beta = " << r.end_join.beta << '\n';
  const double moved = (std::max)(r.start_join.moved, r.end_join.moved);
  if (moved == 0)
    report << "nothing was moved\n";
  else
    report << "coordinates were moved by at most " << moved << '\n';
  const Exit_code code = report_order(report, 2, at_a && at_b);
  warn_of_fold(report, r.blend);
  if (line.has("output"))
    write_output(line.text("output"), [&](std::ostream& os) {
      for (const Double_surface& s : {r.first, r.blend, r.second}) write_exactly(os, s);
    });
  return code;
}

template <class Strategy> Exit_code blend_by(const Command_line& line, const Strategy& strategy) {
  if constexpr (GC::is_quintic_strategy_v<Strategy, GC::Traits_d<CGAL::Cartesian_d<double>>>)
    if (line.has("representable")) return representable_blend_by(line, strategy);
  const Arguments files = line.files();
  const Exact_surface a = read_surface<Exact_surface>(files[0]), b = read_surface<Exact_surface>(files[1]);
  const auto [edge_a, edge_b] = given_edges(line);
  const GC::Edge_direction direction = nearer_direction(a, edge_a, b, edge_b);
  const auto shape = automatic_surface_shape(a, edge_a, b, edge_b, strategy, direction);
  const Exact_surface s = GC::blend(a, edge_a, b, edge_b, shape, direction);
  const int order = line.integer("order");
  std::ostream& report = report_stream(line);
  const bool at_a = report_edge(report, order, files[0], a, edge_a, s, GC::Patch_edge::v0);
  report_shape(report, shape.start);
  const bool at_b = report_edge(report, order, files[1], b, edge_b, s, GC::Patch_edge::v1);
  report_shape(report, shape.end);
  const Exit_code code = report_order(report, order, at_a && at_b);
  warn_of_fold(report, s);
  if (line.has("output")) write_output(line.text("output"), [&](std::ostream& os) { GC::write_g2(os, s); });
  return code;
}

// Blends by the strategy of --strategy, one of a table but for those for F3, which are none for
// surfaces.
template <class Table>
Exit_code blend_by_name(const Command_line& line, const Table& strategies, const std::string& by_default) {
  const auto of_surfaces = [](const auto& s) {
    typedef typename std::decay_t<decltype(s)>::Strategy Strategy;
    if constexpr (std::is_same_v<Strategy, GC::Sequential_f3> || std::is_same_v<Strategy, GC::Fair_f3>)
      return std::make_tuple();
    else
      return std::make_tuple(s);
  };
  const auto chosen = std::apply([&](const auto&... s) { return std::tuple_cat(of_surfaces(s)...); }, strategies);
  const std::string name = line.has("strategy") ? line.choice("strategy", names_of(chosen)) : by_default;
  if (line.files().size() != 2) throw std::invalid_argument("blend --surfaces: two files are needed; see --help");
  Exit_code code = bad_input;
  with_named_strategy(chosen, name, [&](const auto& strategy) { code = blend_by(line, strategy); });
  return code;
}

} // namespace

Exit_code blend_surfaces(const Command_line& line) {
  const GC::Work_scope each(line.work_limit());
  if (line.integer("order", 2, 3) == 2) return blend_by_name(line, quintic_strategies, "energy3");
  if (line.has("representable")) throw std::invalid_argument("--representable: blends of order 2 only");
  return blend_by_name(line, septic_strategies, "energy4_g3");
}
