// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/blends/blend_surfaces.h"
#include "commands/blends/blend_strategies.h"
#include "commands/blends/two_surfaces.h"
#include "commands/models/exact_models.h"
#include "files/output.h"
#include "formats/shapes/write_shapes.h"

#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>
#include <CGAL/Geometric_continuity/surface_blends/representable_blend_surfaces.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

typedef GC::Bspline_surface<GC::Traits_3<CGAL::Simple_cartesian<double>>> Double_surface;

Double_surface read_double_surface(const std::string& file) {
  Input input(file);
  return only_surface(file, GC::read_g2_bspline_surfaces<Double_surface::Traits>(input, input_name(file)));
}

// Prints the continuity along the edge of a given surface, and returns whether the blend has the
// order there.
template <class Surface>
bool report_edge(std::ostream& report, int order, const std::string& file, const Surface& given, GC::Patch_edge edge,
                 const Surface& blend, GC::Patch_edge edge_of_blend) {
  report << input_name(file) << ", edge " << edge << ": ";
  if (order == 3 && has_g3_edge(given, edge, blend, edge_of_blend)) {
    report << "G3";
    return true;
  }
  const GC::Spline_edge_continuity<Exact> verdict = decided_edge(given, edge, blend, edge_of_blend);
  report << verdict;
  return order == 2 && verdict.g_order >= 2;
}

// Prints the derivatives of the parameter across an edge.
template <class FT> void report_shape(std::ostream& report, const GC::Edge_reparametrisation<FT>& shape) {
  report << ", beta = " << shape.beta << ", delta = " << shape.delta;
}
template <class Reparametrisation>
void report_shape(std::ostream& report, const GC::Septic_edge_reparametrisation<Reparametrisation>& shape) {
  report_shape(report, static_cast<const Reparametrisation&>(shape));
  report << ", delta3 = " << shape.delta3;
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

// Returns the same surface over fractions.
Exact_surface exact_surface(const Double_surface& s) {
  typedef CGAL::Exact_rational FT;
  const auto exact_knots = [](const GC::Knot_vector<double>& knots) {
    return GC::Knot_vector<FT>(knots.degree(), std::vector<FT>(knots.begin(), knots.end()));
  };
  std::vector<std::vector<Exact_surface::Point>> net(static_cast<std::size_t>(s.number_of_points_u()));
  for (int i = 0; i < s.number_of_points_u(); ++i)
    for (int j = 0; j < s.number_of_points_v(); ++j) {
      const Double_surface::Point& p = s.control_point(i, j);
      net[i].emplace_back(FT(p.x()), FT(p.y()), FT(p.z()));
    }
  return {net, exact_knots(s.knots_u()), exact_knots(s.knots_v())};
}

// Returns the strategies of a table without those for F3, which are none for surfaces.
template <class Table> auto without_f3(const Table& strategies) {
  const auto chosen = [](const auto& s) {
    typedef typename std::decay_t<decltype(s)>::Strategy Strategy;
    if constexpr (std::is_same_v<Strategy, GC::Sequential_f3> || std::is_same_v<Strategy, GC::Fair_f3>)
      return std::make_tuple();
    else
      return std::make_tuple(s);
  };
  return std::apply([&](const auto&... s) { return std::tuple_cat(chosen(s)...); }, strategies);
}

// Returns the name of the strategy of --strategy, one of a table.
template <class Table>
std::string strategy_name(const Command_line& line, const Table& strategies, const std::string& by_default) {
  const std::string name = line.has("strategy") ? line.choice("strategy", names_of(strategies)) : by_default;
  if (line.files().size() != 2) throw std::invalid_argument("blend --surfaces: two files are needed; see --help");
  return name;
}

// Blends with control points that are doubles. The given surfaces are written, too, as they now
// are.
Exit_code blend_representably(const Command_line& line) {
  const std::string name = strategy_name(line, quintic_strategies, "energy3");
  const Arguments files = line.files();
  const Double_surface a = read_double_surface(files[0]), b = read_double_surface(files[1]);
  const auto [edge_a, edge_b] = given_edges(line);
  const GC::Edge_direction direction = nearer_direction(a, edge_a, b, edge_b);
  std::optional<GC::Representable_blend_surface<Double_surface>> r;
  with_named_strategy(quintic_strategies, name, [&, edge_a = edge_a, edge_b = edge_b](const auto& strategy) {
    r = GC::representable_blend(a, edge_a, b, edge_b, strategy, direction);
  });
  const Exact_surface first = exact_surface(r->first), s = exact_surface(r->blend), second = exact_surface(r->second);
  std::ostream& report = report_stream(line);
  const bool at_a = report_edge(report, 2, files[0], first, edge_a, s, GC::Patch_edge::v0);
  report << ", beta = " << r->start_join.beta << '\n';
  const bool at_b = report_edge(report, 2, files[1], second, edge_b, s, GC::Patch_edge::v1);
  report << ", beta = " << r->end_join.beta << '\n';
  const double moved = (std::max)(r->start_join.moved, r->end_join.moved);
  if (moved == 0)
    report << "nothing was moved\n";
  else
    report << "coordinates were moved by at most " << moved << '\n';
  const Exit_code code = report_order(report, 2, at_a && at_b);
  warn_of_fold(report, r->blend); // doubles are cut faster than fractions
  if (line.has("output"))
    write_shapes(line, [&](std::ostream& os) {
      for (const Exact_surface* x : {&first, &s, &second}) GC::write_g2(os, *x);
    });
  return code;
}

// Blends two surfaces with a shape that choose_shape(a, edge_a, b, edge_b, direction) returns.
template <class Surface, class Choose_shape>
Exit_code blend_with_shape(const Command_line& line, const Surface& a, const Surface& b,
                           const Choose_shape& choose_shape) {
  const Arguments files = line.files();
  const auto [edge_a, edge_b] = given_edges(line);
  const GC::Edge_direction direction = nearer_direction(a, edge_a, b, edge_b);
  const auto shape = choose_shape(a, edge_a, b, edge_b, direction);
  const Surface s = GC::blend(a, edge_a, b, edge_b, shape, direction);
  const int order = line.integer("order");
  std::ostream& report = report_stream(line);
  const bool at_a = report_edge(report, order, files[0], a, edge_a, s, GC::Patch_edge::v0);
  report_shape(report, shape.start);
  report << '\n';
  const bool at_b = report_edge(report, order, files[1], b, edge_b, s, GC::Patch_edge::v1);
  report_shape(report, shape.end);
  report << '\n';
  const Exit_code code = report_order(report, order, at_a && at_b);
  warn_of_fold(report, s);
  if (line.has("output")) write_shapes(line, [&](std::ostream& os) { GC::write_g2(os, s); });
  return code;
}

// Blends by the strategy of --strategy, one of a table.
template <class Table>
Exit_code blend_by_name(const Command_line& line, const Table& strategies, const std::string& by_default) {
  const std::string name = strategy_name(line, strategies, by_default);
  const auto choose_shape = [&](const auto& a, GC::Patch_edge edge_a, const auto& b, GC::Patch_edge edge_b,
                                GC::Edge_direction direction) {
    typedef std::decay_t<decltype(a)> Surface;
    // All strategies of a table choose shapes of one type.
    typedef typename std::tuple_element_t<0, Table>::Strategy First;
    GC::Chosen_surface_shape<Surface, Surface, First> shape;
    with_named_strategy(strategies, name, [&](const auto& strategy) {
      shape = automatic_surface_shape(a, edge_a, b, edge_b, strategy, direction);
    });
    return shape;
  };
  return read_both_surfaces(line.files()).visit([&](const auto& surfaces) {
    return blend_with_shape(line, surfaces[0], surfaces[1], choose_shape);
  });
}

} // namespace

Exit_code blend_surfaces(const Command_line& line) {
  const GC::Work_scope each(line.work_limit());
  if (line.integer("order", 2, 3) == 2)
    return line.has("representable") ? blend_representably(line) : blend_by_name(line, quintic_strategies, "energy3");
  if (line.has("representable")) throw std::invalid_argument("--representable: blends of order 2 only");
  return blend_by_name(line, without_f3(septic_strategies), "energy4_g3");
}
