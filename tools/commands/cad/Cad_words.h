// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_CAD_WORDS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_CAD_WORDS_H

#include "commands/cad/decide_cad.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// The words in which reports speak of an edge of a CAD model.

// Returns what the file says of a face, e.g. `#123 "top"`; empty if it says nothing.
inline std::string cad_label(std::size_t face, const Cad_model& model) {
  if (face >= model.labels.size()) return "";
  const Cad_label& label = model.labels[face];
  return label.name.empty() ? label.id : label.id + (label.id.empty() ? "\"" : " \"") + label.name + '"';
}

// Returns e.g. `edge 7 (plane 3 - cylinder 4; #123, #140 "bore") of bolt:1`: the numbers of the
// faces behind what they are, what the file says of them, and the placed part, if there are
// several.
inline std::string cad_place(std::size_t number, const Cad_edge& edge, const Cad_model& model) {
  std::string text = "edge " + std::to_string(number);
  const char* separator = " (";
  for (const std::size_t face : edge.faces) {
    text += separator + model.faces[face] + ' ' + std::to_string(face);
    separator = " - ";
  }
  separator = "; ";
  for (const std::size_t face : edge.faces)
    if (const std::string label = cad_label(face, model); !label.empty()) {
      text += separator + label;
      separator = ", ";
    }
  text += ')';
  if (model.instances.empty() || edge.faces.empty()) return text;
  return text + " of " + model.instances[model.labels[edge.faces[0]].instance];
}

// Returns e.g. `curve 0 (circle; #16)`.
inline std::string cad_place(std::size_t number, const Cad_wires& wires) {
  const Cad_curve_edge& c = wires.curves[number];
  return "curve " + std::to_string(number) + " (" + c.kind + (c.id.empty() ? ")" : "; " + c.id + ')');
}

// Returns e.g. `join of curve 0 (circle; #16) and curve 1 (line; #24)`.
inline std::string cad_place(const Cad_join& join, const Cad_wires& wires) {
  const auto curve = [&](std::size_t number) { return cad_place(number, wires); };
  if (join.is_knot) {
    std::ostringstream os;
    os << "knot " << join.ends[0].parameter << " of " << curve(join.curves[0]);
    return os.str();
  }
  if (join.curves[0] == join.curves[1]) return "ends of " + curve(join.curves[0]);
  return "join of " + curve(join.curves[0]) + " and " + curve(join.curves[1]);
}

// Returns "inner", "seam, closed" and the like.
inline std::string cad_kind(const Cad_edge& edge) {
  return std::string(name(edge.kind)) + (edge.closed ? ", closed" : "");
}

// Returns the order and the shape, e.g. "G0, corner", and the order that holds with no tolerance.
inline std::string cad_order(const Cad_verdict& verdict) {
  const std::string order = verdict.order_name();
  const bool has_shape =
      verdict.shape != Cad_shape::smooth && verdict.shape != Cad_shape::gap && verdict.shape != Cad_shape::undecided;
  const std::string text = has_shape ? order + ", " + name(verdict.shape) : order;
  return verdict.exact.value_or(-1) < 0 ? text : text + ", exactly " + *verdict.exact_name();
}

// Returns why an edge that is said to be a point may be none.
inline std::string cad_no_point(const Cad_verdict& verdict) {
  if (!verdict.deviation) return "said to be a point, which is not verified: " + verdict.reason;
  std::ostringstream os;
  os << "said to be a point, but " << verdict.deviation->value << " mm long at least";
  return os.str();
}

// Returns e.g. "100 placed parts, 2 different ones".
inline std::string parts_words(std::size_t instances, std::size_t shapes) {
  return std::to_string(instances) + " placed parts, " + std::to_string(shapes) +
         " different: what is equal is decided once";
}

// Returns how many boundary edges lie beside others, and what is to be done.
inline std::string beside_words(std::size_t edges) {
  return counted(edges, "boundary edge") + (edges == 1 ? " lies beside another one" : " lie beside others") +
         " and are not compared: --sew DISTANCE joins them";
}

// Returns what sewing has done.
inline std::string sewn_words(std::size_t edges) {
  return counted(edges, "edge") + " sewn by OpenCASCADE of two boundary edges: curves in parameter planes are adapted, "
                                  "surfaces stay as they are";
}

// Writes the parameters where ranges begin.
inline void write_ranges(std::ostream& os, const char* text, const std::vector<std::pair<double, double>>& ranges) {
  if (ranges.empty()) return;
  os << text;
  for (std::size_t i = 0; i < ranges.size() && i < 4; ++i) os << ' ' << ranges[i].first;
  if (ranges.size() > 4) os << " ...";
}

// Returns where the curves in parameter planes come from if they are not in the file, and how far
// the curve in space is from its faces if that matters; empty otherwise.
inline std::string cad_projection(const Cad_edge& edge, const Cad_verdict& verdict, const Cad_demand& demand) {
  if (!verdict.deviation) return edge.projected ? "; projected" : "";
  const bool is_far = GC::at_most(verdict.deviation->value, demand.bounds.gap) != GC::Verdict::proved;
  std::ostringstream os;
  if (edge.projected)
    os << "; projected, deviation " << verdict.deviation->value << " mm";
  else if (verdict.computed)
    os << "; the curves in the parameter planes are not close to that in space: projected anew, deviation "
       << verdict.deviation->value << " mm";
  else if (is_far)
    os << "; the curve in space is " << verdict.deviation->value << " mm off the faces";
  if (verdict.in_doubt) os << ", which leaves open what is wrong";
  return os.str();
}

// Returns the enclosures, and the places of those that exceed the tolerance.
inline std::string cad_numbers(const Cad_edge& edge, const Cad_verdict& verdict, const Cad_demand& demand) {
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
    write_place(*e.angle, demand.bounds.tangent_angle);
  } else
    os << ", no normal";
  if (e.curvature_jump) os << ", curvature jump " << GC::in_percent(e.curvature_jump->value) << " %";
  os << cad_projection(edge, verdict, demand);
  write_ranges(os, "; a normal vanishes near t =", e.singular);
  write_ranges(os,
               e.exhausted ? "; not resolved, for which the work did not suffice, from t =" : "; not resolved near t =",
               e.unresolved);
  write_ranges(os, "; what belongs to a pole within the tolerance is left out near t =", verdict.poles);
  return os.str();
}

// Returns all that is said of an edge behind its place.
inline std::string cad_sentence(const Cad_edge& edge, const Cad_verdict& verdict, const Cad_demand& demand) {
  if (has_verdict(edge)) return cad_kind(edge) + ": " + cad_order(verdict) + "; " + cad_numbers(edge, verdict, demand);
  if (edge.kind == Cad_edge_kind::boundary && !edge.reason.empty()) return cad_kind(edge) + ": " + edge.reason;
  return cad_kind(edge) + (is_no_point(edge, verdict) ? ": " + cad_no_point(verdict) : "");
}

// Returns all that is said of a join behind its place.
inline std::string cad_sentence(const Cad_join_verdict& verdict, const Cad_demand& demand) {
  if (!verdict.enclosure) return verdict.reason;
  const GC::Wire_enclosure& e = *verdict.enclosure;
  std::ostringstream os;
  os << verdict.order_name();
  if (verdict.shape == Cad_shape::kink || verdict.shape == Cad_shape::corner || verdict.shape == Cad_shape::bent)
    os << ", " << name(verdict.shape);
  os << "; gap " << e.deviation.gap << " mm";
  if (e.deviation.tangent_angle)
    os << ", angle " << GC::in_degrees(*e.deviation.tangent_angle) << " degrees, curvature jump "
       << GC::in_percent(*e.deviation.curvature_jump) << " %";
  else
    os << ", no tangent";
  if (demand.kind == GC::Continuity_kind::C)
    os << ", jumps of derivatives " << GC::in_percent(e.derivative_jumps[0]) << " % and "
       << GC::in_percent(e.derivative_jumps[1]) << " %";
  os << " at (" << e.point[0] << ", " << e.point[1] << ", " << e.point[2] << ')';
  return os.str();
}

// Returns what is said of the curvature of a curve behind its place.
inline std::string cad_sentence(const Cad_bend& bend) {
  if (bend.given.claim == Claim::not_covered) return bend.given.reason;
  const GC::Edge_maximum& k = bend.curvature;
  std::ostringstream os;
  if (std::isfinite(k.value.upper))
    os << "curvature " << k.value << " /mm, radius " << GC::Enclosure{1 / k.value.upper, 1 / k.value.lower} << " mm";
  else
    os << "curvature of at least " << k.value.lower << " /mm";
  os << " at t = " << k.parameter << ", (" << k.point[0] << ", " << k.point[1] << ", " << k.point[2] << ')';
  return os.str();
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_CAD_WORDS_H
