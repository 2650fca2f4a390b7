// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_CAD_WORDS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_CAD_WORDS_H

#include "commands/cad/decide_cad.h"
#include "commands/chains/join_report.h"

#include <CGAL/Geometric_continuity/numbers/units.h>

#include <cstddef>
#include <optional>
#include <sstream>
#include <string>

// The words in which reports speak of an edge of a CAD model.

// Returns e.g. "edge 7 (plane 3 - cylinder 4)": the numbers of the faces behind what they are.
inline std::string cad_place(std::size_t number, const Cad_edge& edge, const Cad_model& model) {
  std::string text = "edge " + std::to_string(number);
  const char* separator = " (";
  for (const std::size_t face : edge.faces) {
    text += separator + model.faces[face] + ' ' + std::to_string(face);
    separator = " - ";
  }
  return text + ')';
}

// Returns "inner", "seam, closed" and the like.
inline std::string cad_kind(const Cad_edge& edge) {
  return std::string(name(edge.kind)) + (edge.closed ? ", closed" : "");
}

// Returns the order and the shape, e.g. "G0, corner", and the order that holds with no tolerance.
inline std::string cad_order(const Cad_verdict& verdict) {
  const std::string order = verdict.order_name();
  const bool has_shape = verdict.shape == Cad_shape::kink || verdict.shape == Cad_shape::corner ||
                         verdict.shape == Cad_shape::fading_corner;
  const std::string text = has_shape ? order + ", " + name(verdict.shape) : order;
  return verdict.exact.value_or(-1) < 0 ? text : text + ", exactly " + *verdict.exact_name();
}

// Returns what sewing has done.
inline std::string sewn_words(std::size_t edges) {
  return counted(edges, "edge") + " sewn by OpenCASCADE of two boundary edges: curves in parameter planes are adapted, "
                                  "surfaces stay as they are";
}

// Returns the enclosures, and the places of those that exceed the tolerance.
inline std::string cad_numbers(const Cad_verdict& verdict, const Cad_demand& demand) {
  if (!verdict.enclosure) return verdict.reason;
  const GC::Edge_enclosure& e = *verdict.enclosure;
  std::ostringstream os;
  const auto write_place = [&](const GC::Edge_maximum& x, const GC::Bound& bound) {
    if (GC::at_most(x.value, bound) != GC::Verdict::refuted) return;
    os << " at t = " << x.parameter << ", (" << x.point[0] << ", " << x.point[1] << ", " << x.point[2] << ')';
  };
  os << "gap " << e.gap.value << " mm";
  write_place(e.gap, demand.bounds.gap);
  if (e.angle) {
    os << ", angle " << GC::in_degrees(e.angle->value) << " degrees";
    write_place(*e.angle, demand.bounds.angle);
  } else
    os << ", no normal";
  if (e.curvature_jump) os << ", curvature jump " << GC::in_percent(e.curvature_jump->value) << " %";
  if (!e.singular.empty()) {
    os << "; a normal vanishes near t =";
    for (std::size_t i = 0; i < e.singular.size() && i < 4; ++i) os << ' ' << e.singular[i].first;
    if (e.singular.size() > 4) os << " ...";
  }
  return os.str();
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_CAD_WORDS_H
