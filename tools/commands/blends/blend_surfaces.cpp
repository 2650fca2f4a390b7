// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/blends/blend_surfaces.h"
#include "commands/blends/blend_strategies.h"
#include "files/input.h"
#include "files/output.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/edges/blend_surfaces.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/possible_fold.h>
#include <CGAL/Simple_cartesian.h>

#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

typedef GC::Rational_bspline_surface<GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>>> Surface;

// Reads the only surface of a file.
Surface read_surface(const std::string& name) {
  Input input(name);
  const std::vector<Surface> surfaces = GC::read_g2_rational_bspline_surfaces<Surface::Traits>(input, input_name(name));
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

// An edge of one of the given surfaces, the derivatives of the parameter across it, and whether the blend has the order there.
template <class Shape>
bool report_edge(std::ostream& report, const std::string& file, GC::Patch_edge edge, const Shape& shape,
                 const Surface& given, const Surface& blend, GC::Patch_edge edge_of_blend) {
  constexpr int order =
      std::is_base_of_v<GC::Septic_edge_reparametrisation<GC::Rational_edge_reparametrisation<CGAL::Exact_rational>>,
                        Shape>
          ? 3
          : 2;
  report << input_name(file) << ", edge " << edge << ": ";
  bool has_order;
  if (order == 3 && is_g3_edge(given, edge, blend, edge_of_blend)) {
    report << "G3";
    has_order = true;
  } else {
    const auto verdict = edge_continuity(given, edge, blend, edge_of_blend);
    report << verdict;
    has_order = order == 2 && verdict.g_order >= 2;
  }
  report << ", beta = " << shape.beta << ", delta = " << shape.delta;
  if constexpr (order == 3) report << ", delta3 = " << shape.delta3;
  report << '\n';
  return has_order;
}

// The search for folds may take long, and what it finds is no more than a warning: it never refuses the blend.
void warn_of_fold(std::ostream& report, const Surface& s) {
  try {
    if (const auto fold = possible_fold(s))
      report << "warning: it may be folded near (" << CGAL::to_double(fold->u.first) << ", "
             << CGAL::to_double(fold->v.first) << "), where its normal may vanish\n";
  } catch (const GC::Error& e) {
    if (e.code() != GC::Error_code::work_limit) throw;
    report << "warning: it may be folded, which was not decided within --max-work\n";
  }
}

template <class Strategy> Exit_code blend_by(const Command_line& line, const Strategy& strategy) {
  const Arguments files = line.files();
  const Surface a = read_surface(files[0]), b = read_surface(files[1]);
  const auto [edge_a, edge_b] = given_edges(line);
  const GC::Edge_direction direction = nearer_direction(a, edge_a, b, edge_b);
  const auto shape = automatic_surface_shape(a, edge_a, b, edge_b, strategy, direction);
  const Surface s = GC::blend(a, edge_a, b, edge_b, shape, direction);
  std::ostream& report = report_stream(line);
  const bool at_a = report_edge(report, files[0], edge_a, shape.start, a, s, GC::Patch_edge::v0),
             at_b = report_edge(report, files[1], edge_b, shape.end, b, s, GC::Patch_edge::v1);
  const std::string order = line.integer("order") == 2 ? "G2" : "G3";
  report << (at_a && at_b ? order + " along both edges, proved exactly\n" : "not " + order + " along both edges\n");
  warn_of_fold(report, s);
  if (line.has("output")) write_output(line.text("output"), [&](std::ostream& os) { GC::write_g2(os, s); });
  return at_a && at_b ? requirement_met : requirement_not_met;
}

Exit_code quintic(const Command_line& line) {
  const std::string name = line.has("strategy") ? line.choice("strategy", quintic_names) : "energy3";
  if (name == "c2") return blend_by(line, GC::Matching_second_derivative());
  if (name == "normal") return blend_by(line, GC::Normal_offset());
  if (name == "min_second") return blend_by(line, GC::Minimal_second_derivative());
  if (name == "near_line") return blend_by(line, GC::Near_line());
  if (name == "energy2") return blend_by(line, GC::Minimal_energy<2>());
  if (name == "fair") return blend_by(line, GC::Fair());
  return blend_by(line, GC::Minimal_energy<3>());
}

// Strategies for F3 are none for surfaces.
Exit_code septic(const Command_line& line) {
  const Arguments names = {"c3", "seq_g3", "joint_g3", "energy3_g3", "energy4_g3", "fair_g3"};
  const std::string name = line.has("strategy") ? line.choice("strategy", names) : "energy4_g3";
  if (name == "c3") return blend_by(line, GC::Matching_third_derivative());
  if (name == "seq_g3") return blend_by(line, GC::Sequential_g3());
  if (name == "joint_g3") return blend_by(line, GC::Joint_g3());
  if (name == "energy3_g3") return blend_by(line, GC::Minimal_energy_g3<3>());
  if (name == "fair_g3") return blend_by(line, GC::Fair_g3());
  return blend_by(line, GC::Minimal_energy_g3<4>());
}

} // namespace

Exit_code blend_surfaces(const Command_line& line) {
  if (line.files().size() != 2) throw std::invalid_argument("blend --surfaces: two files are needed; see --help");
  const GC::Work_scope each(line.work_limit());
  return line.integer("order", 2, 3) == 2 ? quintic(line) : septic(line);
}
