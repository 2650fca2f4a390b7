// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_CAD_JSON_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_CAD_JSON_H

#include "commands/cad/decide_cad.h"

#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

// `verify` writes this about the edges of CAD models.

inline GC::Enclosure in_length(const GC::Enclosure& x) { return x; }

// Writes an enclosure in a unit, and where its lower end is attained.
template <class Unit>
void write_maximum(std::ostream& os, const char* name, const std::optional<GC::Edge_maximum>& x, Unit unit) {
  GC::write_json(os << ",\"" << name << "\":",
                 x ? std::optional<GC::Enclosure>(unit(x->value)) : std::optional<GC::Enclosure>());
}
inline void write_place(std::ostream& os, const char* name, const std::optional<GC::Edge_maximum>& x) {
  if (!x) return;
  GC::write_number(os << ",\"" << name << "_at\":{\"parameter\":", x->parameter);
  os << ",\"point\":";
  for (std::size_t i = 0; i < 3; ++i) GC::write_number(os << (i == 0 ? '[' : ','), x->point[i]);
  os << "]}";
}

inline void write_ranges_json(std::ostream& os, const char* name,
                              const std::vector<std::pair<double, double>>& ranges) {
  if (ranges.empty()) return;
  os << ",\"" << name << "\":";
  char separator = '[';
  for (const auto& [begin, end] : ranges) {
    GC::write_number(os << separator << '[', begin);
    GC::write_number(os << ',', end);
    os << ']';
    separator = ',';
  }
  os << ']';
}

// Writes the members of an edge.
inline void write_members(std::ostream& os, std::size_t number, const Cad_edge& edge, const Cad_verdict& verdict) {
  os << "\"edge\":" << number << ",\"faces\":";
  for (std::size_t i = 0; i < edge.faces.size(); ++i) os << (i == 0 ? '[' : ',') << edge.faces[i];
  os << "],\"kind\":\"" << name(edge.kind) << "\",\"closed\":" << (edge.closed ? "true" : "false");
  GC::write_number(os << ",\"tolerance\":", edge.tolerance);
  if (!has_verdict(edge)) {
    os << ",\"order\":null";
    if (!edge.reason.empty()) GC::write_json(os << ",\"reason\":", edge.reason);
    if (edge.kind == Cad_edge_kind::degenerate) write_maximum(os, "deviation", verdict.deviation, in_length);
    return;
  }
  os << ",\"projected\":" << (edge.projected ? "true" : "false") << ",\"order\":\"" << verdict.order_name()
     << "\",\"shape\":\"" << name(verdict.shape) << "\",\"within\":[";
  for (std::size_t i = 0; i < 3; ++i) os << (i == 0 ? "\"" : ",\"") << verdict.within[i] << '"';
  os << ']';
  os << ",\"exact\":" << (verdict.exact ? '"' + *verdict.exact_name() + '"' : "null");
  if (!verdict.reason.empty()) GC::write_json(os << ",\"reason\":", verdict.reason);
  std::optional<GC::Edge_maximum> gap, angle, curvature;
  if (verdict.enclosure) {
    gap = verdict.enclosure->gap;
    angle = verdict.enclosure->angle;
    curvature = verdict.enclosure->curvature_jump;
  }
  if (edge.inside_out) os << ",\"inside_out\":true";
  write_maximum(os, "deviation", verdict.deviation, in_length);
  write_place(os, "deviation", verdict.deviation);
  if (verdict.computed) os << ",\"projected_anew\":true";
  write_maximum(os, "gap", gap, in_length);
  write_maximum(os, "angle_degrees", angle, GC::in_degrees);
  write_maximum(os, "curvature_percent", curvature, GC::in_percent);
  write_place(os, "gap", gap);
  write_place(os, "angle", angle);
  write_place(os, "curvature", curvature);
  if (!verdict.enclosure) return;
  write_ranges_json(os, "singular", verdict.enclosure->singular);
  write_ranges_json(os, "unresolved", verdict.enclosure->unresolved);
  write_ranges_json(os, "poles", verdict.poles);
}

// Writes the members of a join of curves.
inline void write_members(std::ostream& os, std::size_t number, const Cad_join& join, const Cad_join_verdict& verdict) {
  os << "\"join\":" << number << ",\"curves\":[" << join.curves[0] << ',' << join.curves[1] << ']';
  if (join.is_knot) GC::write_number(os << ",\"knot\":", join.ends[0].parameter);
  if (!verdict.enclosure) {
    GC::write_json(os << ",\"order\":null,\"reason\":", verdict.reason);
    return;
  }
  const GC::Wire_enclosure& e = *verdict.enclosure;
  os << ",\"order\":\"" << verdict.order_name() << "\",\"shape\":\"" << name(verdict.shape) << '"';
  for (const auto& [key, within] :
       {std::pair(",\"within\":[\"", &verdict.within), std::pair(",\"c_within\":[\"", &verdict.c_within)})
    os << key << (*within)[0] << "\",\"" << (*within)[1] << "\",\"" << (*within)[2] << "\"]";
  const auto write = [&](const char* key, const std::optional<GC::Enclosure>& x) {
    GC::write_json(os << ",\"" << key << "\":", x);
  };
  const auto converted = [](const std::optional<GC::Enclosure>& x, auto unit) {
    return x ? std::optional<GC::Enclosure>(unit(*x)) : std::nullopt;
  };
  write("gap", e.deviation.gap);
  write("angle_degrees", converted(e.deviation.tangent_angle, GC::in_degrees));
  write("curvature_percent", converted(e.deviation.curvature_jump, GC::in_percent));
  write("first_derivative_percent", GC::in_percent(e.derivative_jumps[0]));
  write("second_derivative_percent", GC::in_percent(e.derivative_jumps[1]));
  for (std::size_t i = 0; i < 3; ++i) GC::write_number(os << (i == 0 ? ",\"point\":[" : ","), e.point[i]);
  os << ']';
}

// Writes the members of a curve with a bound on its curvature.
inline void write_members(std::ostream& os, std::size_t number, const Cad_bend& bend) {
  os << "\"curve\":" << number;
  write_maximum(os, "curvature", std::optional(bend.curvature), in_length);
  write_place(os, "curvature", std::optional(bend.curvature));
}

inline void write_json(std::ostream& os, const Cad_summary& s) {
  os << "{\"faces\":" << s.faces << ",\"inner\":" << s.inner << ",\"seam\":" << s.seams
     << ",\"boundary\":" << s.boundary << ",\"non_manifold\":" << s.non_manifold << ",\"degenerate\":" << s.degenerate
     << ",\"knot_lines\":" << s.knot_lines << ",\"not_points\":" << s.no_points << ",\"G2\":" << s.g2
     << ",\"G1\":" << s.g1 << ",\"G0\":" << s.g0 << ",\"gap\":" << s.gaps << ",\"undecided\":" << s.undecided
     << ",\"kinks\":" << s.kinks << ",\"corners\":" << s.corners << ",\"fading_corners\":" << s.fading_corners
     << ",\"kinks_or_corners\":" << s.bent << ",\"folds\":" << s.folds << ",\"inside_out\":" << s.inside_out
     << ",\"exact\":" << s.exact << ",\"not_compared\":" << s.not_compared << ",\"projected\":" << s.projected
     << ",\"sewn\":" << s.sewn << ",\"placed_parts\":" << s.instances << ",\"different_parts\":" << s.shapes
     << ",\"compared\":" << s.compared << ",\"lost\":" << s.lost << ",\"beside\":" << s.beside
     << ",\"open_shells\":" << s.open_shells << ",\"curves\":" << s.curves << ",\"joins\":" << s.joins
     << ",\"free_ends\":" << s.free_ends << ",\"branchings\":" << s.branchings << ",\"length_unit\":\"mm\"}";
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_CAD_JSON_H
