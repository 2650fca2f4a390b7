// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_JSON_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_JSON_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

// `verify --surfaces --json` writes this about edges and knot lines.

namespace GC = CGAL::Geometric_continuity;

// Whatever the numbers of the surfaces are, everything is decided in exact ones.
typedef CGAL::Exact_rational Exact;
typedef GC::Model_edge<Exact> Edge;
typedef GC::Model_knot_line<Exact> Line;
typedef GC::Spline_edge_continuity<Exact> Continuity;
typedef GC::Edge_order_within Within;

inline const char* boolean(bool b) { return b ? "true" : "false"; }

inline std::string order(const GC::Edge_continuity<Exact>& e) {
  return e.g_order < 0 ? to_string(e.defect) : "G" + std::to_string(e.g_order);
}

// Writes the members that edges, knot lines and spans have in common.
inline void write_verdict(std::ostream& os, const GC::Edge_continuity<Exact>& e) {
  os << "\"order\":\"" << order(e) << "\",\"reason\":\"" << e.defect << "\",\"side\":\"" << e.side << '"';
  if (!e.deviation) return;
  const double angle = e.deviation->largest_angle();
  GC::write_number(os << ",\"angle_at_most\":", angle);
  GC::write_number(os << ",\"angle_at_most_degrees\":", GC::in_degrees({angle, angle}).upper);
}

inline void write_verdict(std::ostream& os, const Continuity& e) {
  write_verdict(os, static_cast<const GC::Edge_continuity<Exact>&>(e));
  if (e.spans.size() == 1) return;
  const char* separator = ",\"spans\":[";
  for (const GC::Edge_span<Exact>& span : e.spans) {
    os << separator << "{\"begin\":\"" << span.begin << "\",\"end\":\"" << span.end << "\",";
    write_verdict(os, span.continuity);
    os << '}';
    separator = ",";
  }
  os << ']';
}

inline void write_json(std::ostream& os, const Within& within) {
  os << ",\"within\":[\"" << within(0) << "\",\"" << within(1) << "\"]";
  os << ",\"gap\":";
  GC::write_json(os, within.deviation.gap);
  os << ",\"normal_angle\":";
  GC::write_json(os, within.deviation.normal_angle);
  std::optional<GC::Enclosure> degrees;
  if (within.deviation.normal_angle) degrees = GC::in_degrees(*within.deviation.normal_angle);
  os << ",\"angle_degrees\":";
  GC::write_json(os, degrees);
}

template <class A, class B>
void write_names(std::ostream& os, std::size_t patch_a, const A& edge_a, std::size_t patch_b, const B& edge_b) {
  os << "{\"patch_a\":" << patch_a << ",\"edge_a\":\"" << edge_a << "\",\"patch_b\":" << patch_b << ",\"edge_b\":\""
     << edge_b << '"';
}

inline void write_json(std::ostream& os, const Edge& e, const std::optional<Within>& within) {
  write_names(os, e.patch_a, e.edge_a, *e.patch_b, *e.edge_b);
  os << ',';
  write_verdict(os, e.continuity);
  os << ",\"reversed\":" << boolean(e.continuity.reversed) << ",\"non_manifold\":" << boolean(e.non_manifold);
  if (within) write_json(os, *within);
  os << '}';
}

inline void write_json(std::ostream& os, const Line& l, const std::optional<Within>& within) {
  os << "{\"patch\":" << l.patch << ",\"direction\":\"" << (l.line.constant_u ? 'u' : 'v') << "\",\"knot\":\""
     << l.line.knot << "\",\"multiplicity\":" << l.line.multiplicity << ',';
  write_verdict(os, l.line.continuity);
  if (within) write_json(os, *within);
  os << '}';
}

inline void write_json(std::ostream& os, const GC::Nearly_coincident_edges& e) {
  write_names(os, e.patch_a, e.edge_a, e.patch_b, e.edge_b);
  os << ",\"reversed\":" << boolean(e.within.deviation.reversed);
  write_json(os, e.within);
  os << '}';
}

// Writes the edges of one kind that are not shared.
inline void write_json(std::ostream& os, const std::vector<Edge>& edges, GC::Model_edge_kind kind) {
  const char* separator = "";
  for (const Edge& e : edges)
    if (e.kind == kind) {
      os << separator << "{\"patch\":" << e.patch_a << ",\"edge\":\"" << e.edge_a << "\"}";
      separator = ",";
    }
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_JSON_H
