// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/blends/two_surfaces.h"
#include "commands/command_line.h"
#include "commands/work_limit.h"
#include "files/output.h"
#include "formats/shapes/write_shapes.h"

#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/edges/edge_deviation.h>
#include <CGAL/Geometric_continuity/surface_blends/match.h>

#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

const char* const match_usage = R"(usage: geometric_continuity match A.g2 B.g2 | AB.g2 [OPTIONS] -o C.g2

Changes the surface of B.g2 near one of its edges so that it continues that of
A.g2 with G1, G2 or G3 along the whole edge, exactly. One file may have both.
Only the two, three or four rows of control points next to the edge change; the
degree across it is raised where needed, so that the opposite edge keeps its
derivatives. The lines across the edge change as little as numbers allow, or
have the given numbers: with C, T and W the edge and the derivatives of A across
it,
  S_v  = alpha C' + beta T
  S_vv = alpha^2 C'' + 2 alpha beta T' + beta^2 W + alpha2 C' + delta T
C.g2 has the changed surface alone. The report tells the order along the edge,
and what it was before.

examples:
  geometric_continuity match hood.g2 fender.g2 --edges v1,u0 -o fender.g2
  geometric_continuity match a.g2 b.g2 --order G1 --beta 1/2 -o c.step

Exit code: 0 when the result has the order, 1 when it has not, e.g. where a
normal vanishes, 2 on bad input.
)";

// The continuity of two surfaces along their edges.
template <class Surface>
std::string words(const Surface& a, GC::Patch_edge edge_a, const Surface& b, GC::Patch_edge edge_b) {
  std::ostringstream os;
  os << GC::edge_continuity(a, edge_a, b, edge_b);
  return os.str();
}

template <class Surface> int match(const Command_line& line, const Surface& a, const Surface& b) {
  const auto [edge_a, edge_b] = line.has("edges") ? given_edges(line) : nearest_edges(a, b);
  const int order = line.choice("order", {"G2", "G1", "G3"})[1] - '0';
  const GC::Edge_direction direction = nearer_direction(a, edge_a, b, edge_b);
  GC::Matching_shape<Exact> shape = nearest_matching_shape(a, edge_a, b, edge_b, order, direction);
  for (const auto& [name, number] : {std::pair("alpha", &shape.alpha), std::pair("beta", &shape.beta),
                                     std::pair("alpha2", &shape.alpha2), std::pair("delta", &shape.delta)})
    if (line.has(name)) *number = line.number(name, Exact(0));
  const Surface c = match(a, edge_a, b, edge_b, order, shape, direction);
  const bool has_order =
      order == 3 ? GC::is_g3_edge(a, edge_a, c, edge_b) : GC::edge_continuity(a, edge_a, c, edge_b).g_order >= order;
  std::ostream& report = report_stream(line);
  report << "edges: " << edge_a << ',' << edge_b << "\nbefore: " << words(a, edge_a, b, edge_b)
         << "\nafter: " << (order == 3 && has_order ? "G3" : words(a, edge_a, c, edge_b)) << "\nalpha = " << shape.alpha
         << ", beta = " << shape.beta;
  if (order > 1) report << ", alpha2 = " << shape.alpha2 << ", delta = " << shape.delta;
  report << '\n'
         << (has_order ? "" : "not ") << 'G' << order << " along the whole edge"
         << (has_order ? ", proved exactly\n" : "\n");
  write_shapes(line, [&](std::ostream& os) { GC::write_g2(os, c); });
  return has_order ? requirement_met : requirement_not_met;
}

void describe_match(po::options_description_easy_init add) {
  add("edges", po::value<std::string>(), "of A and of B, e.g. u1,v0 (default: those whose ends are nearest)");
  add("order", po::value<std::string>()->default_value("G2"), "G1, G2 or G3");
  add("alpha", po::value<std::string>(), "how far lines across the edge lean along it (default: the nearest)");
  add("beta", po::value<std::string>(), "R > 0, the speed across the edge (default: the nearest)");
  add("alpha2", po::value<std::string>(), "in the second derivative (default: the nearest)");
  add("delta", po::value<std::string>(), "in the second derivative (default: the nearest)");
  add("max-work", po::value<std::string>(), "the steps of work that are allowed");
  add_shape_output(add, "the changed surface");
}

int run_match(const Command_line& line) {
  const std::size_t files = line.files().size();
  if (files != 1 && files != 2) throw std::invalid_argument("match: one or two files are needed; see --help");
  if (!line.has("output")) throw std::invalid_argument("match: -o C.g2 is needed");
  check_shape_output(line);
  const GC::Work_scope each(line.work_limit());
  return within_work_limit([&] { return input_name(line.files()[0]) + ", ..."; },
                           [&] {
                             const Arguments files = line.files();
                             const auto both = files.size() == 2 ? read_both_surfaces(files) : read_exact_model(files);
                             return both.visit([&](const auto& surfaces) {
                               if (surfaces.size() != 2)
                                 throw GC::Error(GC::Error_code::malformed_input,
                                                 input_name(files[0]) + ": " + std::to_string(surfaces.size()) +
                                                     " surfaces where two are expected");
                               return match(line, surfaces[0], surfaces[1]);
                             });
                           });
}

} // namespace

const Command match_command{"match", match_usage, describe_match, run_match};
