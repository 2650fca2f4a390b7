// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_CAD_VERDICT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_CAD_VERDICT_H

#include "formats/cad/Cad_model.h"

#include <CGAL/Geometric_continuity/joins/order_within.h>
#include <CGAL/Geometric_continuity/numbers/Verdict.h>
#include <CGAL/Geometric_continuity/trimmed/Edge_enclosure.h>
#include <CGAL/Geometric_continuity/trimmed/exact_edge_continuity.h>
#include <CGAL/Geometric_continuity/trimmed/is_sharp_edge.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// The tolerance unless one is given: the edges of CAD models are computed, and never meet exactly.
constexpr const char* default_cad_tolerance = "vda-4955";

// What is asked of the edges of CAD models.
struct Cad_demand {
  std::optional<int> order;  // that is required
  int most = 0;              // up to this order there are bounds
  GC::Join_tolerance bounds; // of the gap in mm, the angle in radians and the relative jump of the curvature
  std::string tolerance;     // as it is written
  GC::Bound kink;            // the angle that is exceeded all along a corner, in radians
};

// How two faces meet along an edge. A corner is sharp everywhere, a fading one in places only, which may not be meant.
enum class Cad_shape { smooth, kink, corner, fading_corner, gap, undecided };

inline const char* name(Cad_shape shape) {
  switch (shape) {
  case Cad_shape::smooth: return "smooth";
  case Cad_shape::kink: return "kink";
  case Cad_shape::corner: return "corner";
  case Cad_shape::fading_corner: return "fading corner";
  case Cad_shape::gap: return "gap";
  case Cad_shape::undecided: break;
  }
  return "undecided";
}

// What is known of an edge within the tolerance.
struct Cad_verdict {
  std::optional<GC::Edge_enclosure> enclosure; // if the edge is an inner one or a seam, and its sides can be compared
  std::string reason;                          // why they cannot
  std::optional<int> exact;                    // the order with no tolerance, -1 for a gap, where it can be decided
  // For each order: the edges are the same; in addition the tangent planes agree; the curvatures across the edge.
  std::array<GC::Verdict, 3> within{GC::Verdict::undecided, GC::Verdict::undecided, GC::Verdict::undecided};
  Cad_shape shape = Cad_shape::undecided;

  // Returns the highest order that is proved, or -1.
  int order() const {
    int order = -1;
    while (order < 2 && within[static_cast<std::size_t>(order + 1)] == GC::Verdict::proved) ++order;
    return order;
  }

  // Returns "G2", "G1", "G0", "gap" or "undecided".
  std::string order_name() const {
    if (order() >= 0) return 'G' + std::to_string(order());
    return within[0] == GC::Verdict::refuted ? "gap" : "undecided";
  }

  // Returns the order that holds with no tolerance: "G2", "G1", "G0" or "gap"; nothing where it cannot be decided.
  std::optional<std::string> exact_name() const {
    if (!exact) return std::nullopt;
    return *exact < 0 ? "gap" : 'G' + std::to_string(*exact);
  }

  // A corner is meant: its faces need to meet only.
  bool fails(const Cad_demand& demand) const {
    return demand.order && order() < (shape == Cad_shape::corner ? 0 : *demand.order);
  }

  // Whether the order that is required, or the order 0 or 1 of what is not a corner, is undecided.
  bool is_undecided(const Cad_demand& demand) const {
    const int asked = shape == Cad_shape::corner ? 0 : demand.order.value_or(1);
    for (int i = 0; i <= asked; ++i)
      if (within[static_cast<std::size_t>(i)] != GC::Verdict::proved)
        return within[static_cast<std::size_t>(i)] == GC::Verdict::undecided;
    return false;
  }
};

// Whether the ranges that an enclosure leaves out are as short as singular points need: then it holds apart from these points.
inline bool are_points(const std::vector<std::pair<double, double>>& ranges, double length) {
  for (const auto& [begin, end] : ranges)
    if (!(end - begin <= length * 0x1p-18)) return false;
  return true;
}

// Returns the verdict on an edge that has two sides.
inline Cad_verdict cad_verdict(const Cad_edge& edge, const Cad_demand& demand) {
  Cad_verdict result;
  if (!edge.sides) {
    result.reason = edge.reason;
    return result;
  }
  const GC::Edge_side &a = (*edge.sides)[0], &b = (*edge.sides)[1];
  try {
    result.enclosure = GC::edge_enclosure(a, b, edge.begin, edge.end);
    if (const auto verdict = GC::exact_edge_continuity(a, b, edge.begin, edge.end)) result.exact = verdict->g_order;
  } catch (const GC::Error& e) {
    result.reason = e.what();
    return result;
  }
  const GC::Edge_enclosure& e = *result.enclosure;
  typedef std::vector<std::pair<double, double>> Ranges;
  const auto within = [&](const std::optional<GC::Edge_maximum>& x, const GC::Bound& bound, const Ranges& left_out) {
    const GC::Verdict all = are_points(left_out, edge.end - edge.begin) ? GC::Verdict::proved : GC::Verdict::undecided;
    return x ? GC::at_most(x->value, bound) && all : GC::Verdict::undecided;
  };
  result.within[0] = GC::at_most(e.gap.value, demand.bounds.gap);
  result.within[1] = result.within[0] && within(e.angle, demand.bounds.angle, e.singular);
  result.within[2] = result.within[1] && within(e.curvature_jump, demand.bounds.curvature, e.curvature_undefined);
  for (int i = 0; i <= result.exact.value_or(-1); ++i) result.within[static_cast<std::size_t>(i)] = GC::Verdict::proved;
  const GC::Verdict is_kink = within(e.angle, demand.kink, e.singular),
                    is_smooth = within(e.angle, demand.bounds.angle, e.singular);
  if (result.within[0] == GC::Verdict::refuted)
    result.shape = Cad_shape::gap;
  else if (is_smooth == GC::Verdict::proved)
    result.shape = Cad_shape::smooth;
  else if (is_kink == GC::Verdict::refuted)
    result.shape = GC::is_sharp_edge(a, b, edge.begin, edge.end, demand.kink) == GC::Verdict::proved
                       ? Cad_shape::corner
                       : Cad_shape::fading_corner;
  else if (is_smooth == GC::Verdict::refuted && is_kink == GC::Verdict::proved)
    result.shape = Cad_shape::kink;
  return result;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_CAD_VERDICT_H
