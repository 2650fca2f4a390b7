// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/g2_surfaces.h>
#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Geometric_continuity/surfaces/model_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <stdexcept>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

namespace {

typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef GC::Bezier_patch<Traits> Patch;
typedef GC::Model_edge<CGAL::Exact_rational> Edge;

std::vector<Patch> read_model(const Arguments& files) {
  std::vector<Patch> model;
  for (const std::string& name : files) {
    std::ifstream stream(name);
    if (!stream) throw GC::Error(GC::Error_code::cannot_read_file, name);
    GC::G2_surface_reader<Traits> reader(stream, name);
    while (const std::optional<Patch> patch = reader.next()) model.push_back(*patch);
  }
  return model;
}

void write_json(std::ostream& os, const Edge& e) {
  os << "{\"patch_a\":" << e.patch_a << ",\"edge_a\":\"" << e.edge_a << "\",\"patch_b\":" << *e.patch_b
     << ",\"edge_b\":\"" << *e.edge_b << "\",\"order\":\"G" << e.continuity.g_order << "\",\"reason\":\""
     << e.continuity.defect << "\",\"reversed\":" << (e.continuity.reversed ? "true" : "false") << ",\"side\":\""
     << e.continuity.side << "\",\"non_manifold\":" << (e.non_manifold ? "true" : "false");
  if (e.continuity.deviation) os << ",\"angle_at_most\":" << e.continuity.deviation->largest_angle();
  os << '}';
}

// The edges that are not shared, in a list of their own.
void write_json(std::ostream& os, const std::vector<Edge>& edges, GC::Model_edge_kind kind) {
  const char* separator = "";
  for (const Edge& e : edges)
    if (e.kind == kind) {
      os << separator << "{\"patch\":" << e.patch_a << ",\"edge\":\"" << e.edge_a << "\"}";
      separator = ",";
    }
}

void print_json(const GC::Model_continuity<CGAL::Exact_rational>& model) {
  std::cout << "{\"edges\":[";
  const char* separator = "\n ";
  for (const Edge& e : model.edges)
    if (e.kind == GC::Model_edge_kind::shared) {
      std::cout << separator;
      write_json(std::cout, e);
      separator = ",\n ";
    }
  std::cout << "],\n \"boundary_edges\":[";
  write_json(std::cout, model.edges, GC::Model_edge_kind::boundary);
  std::cout << "],\n \"collapsed_edges\":[";
  write_json(std::cout, model.edges, GC::Model_edge_kind::collapsed);
  const GC::Model_summary& s = model.summary;
  std::cout << "],\n \"summary\":{\"G2\":" << s.g2 << ",\"G1\":" << s.g1 << ",\"G0\":" << s.g0
            << ",\"boundary\":" << s.boundary << ",\"collapsed\":" << s.collapsed
            << ",\"vanishing_normals\":" << s.vanishing_normals << ",\"creases\":" << s.creases
            << ",\"folds\":" << s.folds << ",\"non_manifold\":" << s.non_manifold << '}';
}

} // namespace

int verify_surfaces(const Arguments& files, bool json, const std::optional<int>& required) {
  const std::vector<Patch> patches = read_model(files);
  const GC::Model_continuity<CGAL::Exact_rational> model = GC::continuity_of_model(patches);
  const std::size_t failing = required ? model.failing(*required).size() : 0;
  if (json) {
    print_json(model);
    if (required)
      std::cout << ",\n \"required\":\"G" << *required << "\",\"met\":" << (failing == 0 ? "true" : "false");
    std::cout << "}\n";
  } else {
    for (const Edge& e : model.edges) std::cout << e << '\n';
    std::cout << patches.size() << " patches: " << model.summary << '\n';
    if (required && failing == 0) std::cout << "every shared edge is G" << *required << ", proved exactly\n";
    if (required && failing > 0) std::cout << failing << " of them not G" << *required << '\n';
  }
  return failing == 0 ? requirement_met : requirement_not_met;
}
