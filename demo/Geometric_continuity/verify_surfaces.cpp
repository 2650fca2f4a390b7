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
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

namespace {

typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef CGAL::Exact_rational FT;
typedef GC::Bspline_surface<Traits> Surface;
typedef GC::Model_edge<FT> Edge;
typedef GC::Spline_edge_continuity<FT> Continuity;

std::vector<Surface> read_model(const Arguments& files) {
  std::vector<Surface> model;
  for (const std::string& name : files) {
    std::ifstream stream(name);
    if (!stream) throw GC::Error(GC::Error_code::cannot_read_file, name);
    GC::G2_bspline_surface_reader<Traits> reader(stream, name);
    while (std::optional<Surface> surface = reader.next()) model.push_back(*std::move(surface));
  }
  return model;
}

const char* boolean(bool b) { return b ? "true" : "false"; }

std::string order(const GC::Edge_continuity<FT>& e) {
  return e.g_order < 0 ? to_string(e.defect) : "G" + std::to_string(e.g_order);
}

// The keys that edges, knot lines and spans have in common.
void write_verdict(std::ostream& os, const GC::Edge_continuity<FT>& e) {
  os << "\"order\":\"" << order(e) << "\",\"reason\":\"" << e.defect << "\",\"side\":\"" << e.side << '"';
  if (e.deviation) os << ",\"angle_at_most\":" << e.deviation->largest_angle();
}

void write_verdict(std::ostream& os, const Continuity& e) {
  write_verdict(os, static_cast<const GC::Edge_continuity<FT>&>(e));
  if (e.spans.size() == 1) return;
  const char* separator = ",\"spans\":[";
  for (const GC::Edge_span<FT>& span : e.spans) {
    os << separator << "{\"begin\":\"" << span.begin << "\",\"end\":\"" << span.end << "\",";
    write_verdict(os, span.continuity);
    os << '}';
    separator = ",";
  }
  os << ']';
}

void write_json(std::ostream& os, const Edge& e) {
  os << "{\"patch_a\":" << e.patch_a << ",\"edge_a\":\"" << e.edge_a << "\",\"patch_b\":" << *e.patch_b
     << ",\"edge_b\":\"" << *e.edge_b << "\",";
  write_verdict(os, e.continuity);
  os << ",\"reversed\":" << boolean(e.continuity.reversed) << ",\"non_manifold\":" << boolean(e.non_manifold) << '}';
}

void write_json(std::ostream& os, const GC::Model_knot_line<FT>& l) {
  os << "{\"patch\":" << l.patch << ",\"direction\":\"" << (l.line.constant_u ? 'u' : 'v') << "\",\"knot\":\""
     << l.line.knot << "\",\"multiplicity\":" << l.line.multiplicity << ',';
  write_verdict(os, l.line.continuity);
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

void print_json(const GC::Model_continuity<FT>& model) {
  std::cout << "{\"edges\":[";
  const char* separator = "\n ";
  for (const Edge& e : model.edges)
    if (e.kind == GC::Model_edge_kind::shared) {
      std::cout << separator;
      write_json(std::cout, e);
      separator = ",\n ";
    }
  std::cout << "],\n \"knot_lines\":[";
  separator = "\n ";
  for (const GC::Model_knot_line<FT>& l : model.knot_lines) {
    std::cout << separator;
    write_json(std::cout, l);
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
            << ",\"folds\":" << s.folds << ",\"non_manifold\":" << s.non_manifold
            << ",\"knot_lines\":{\"G2\":" << s.knot_lines_g2 << ",\"G1\":" << s.knot_lines_g1
            << ",\"G0\":" << s.knot_lines_g0 << "}}";
}

} // namespace

int verify_surfaces(const Arguments& files, bool json, const std::optional<int>& required) {
  const std::vector<Surface> surfaces = read_model(files);
  const GC::Model_continuity<FT> model = GC::continuity_of_model(surfaces);
  const std::size_t edges = required ? model.failing(*required).size() : 0,
                    lines = required ? model.failing_knot_lines(*required).size() : 0;
  const bool met = edges + lines == 0;
  if (json) {
    print_json(model);
    if (required) std::cout << ",\n \"required\":\"G" << *required << "\",\"met\":" << boolean(met);
    std::cout << "}\n";
  } else {
    for (const Edge& e : model.edges) std::cout << e << '\n';
    for (const GC::Model_knot_line<FT>& l : model.knot_lines) std::cout << l << '\n';
    std::cout << surfaces.size() << " patches: " << model.summary << '\n';
    const std::string inside = model.knot_lines.empty() ? "" : " and every knot line";
    if (required && met) std::cout << "every shared edge" << inside << " is G" << *required << ", proved exactly\n";
    if (edges > 0) std::cout << edges << " of them not G" << *required << '\n';
    if (lines > 0) std::cout << lines << " knot lines not G" << *required << '\n';
  }
  return met ? requirement_met : requirement_not_met;
}
