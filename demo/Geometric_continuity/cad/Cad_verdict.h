// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_DEMO_CAD_CAD_VERDICT_H
#define GEOMETRIC_CONTINUITY_DEMO_CAD_CAD_VERDICT_H

#include "cad/Cad_model.h"

#include <CGAL/Geometric_continuity/joins/Verdict.h>
#include <CGAL/Geometric_continuity/joins/order_within.h>
#include <CGAL/Geometric_continuity/trimmed/Edge_enclosure.h>

#include <array>
#include <optional>
#include <string>

// The tolerance unless one is given: the edges of CAD models are computed, and never meet exactly.
constexpr const char* default_cad_tolerance = "vda-4955";

// What is asked of the edges of CAD models.
struct Cad_demand {
  std::optional<int> order;  // that is required
  int most = 0;              // up to this order there are bounds
  GC::Join_tolerance bounds; // of the gap in mm, the angle in radians and the relative jump of the curvature
  std::string tolerance;     // as it is written
  GC::Bound kink;            // the largest angle that is a kink and not a corner, in radians
};

// How two faces meet along an edge.
enum class Cad_shape { smooth, kink, corner, gap, undecided };

inline const char* name(Cad_shape shape) {
  switch (shape) {
  case Cad_shape::smooth: return "smooth";
  case Cad_shape::kink: return "kink";
  case Cad_shape::corner: return "corner";
  case Cad_shape::gap: return "gap";
  case Cad_shape::undecided: break;
  }
  return "undecided";
}

// What is known of an edge within the tolerance.
struct Cad_verdict {
  std::optional<GC::Edge_enclosure> enclosure; // if the edge is an inner one or a seam, and its sides can be compared
  std::string reason;                          // why they cannot
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

// Returns the verdict on an edge that has two sides.
inline Cad_verdict cad_verdict(const Cad_edge& edge, const Cad_demand& demand) {
  Cad_verdict result;
  if (!edge.sides) {
    result.reason = edge.reason;
    return result;
  }
  try {
    result.enclosure = GC::edge_enclosure((*edge.sides)[0], (*edge.sides)[1], edge.begin, edge.end);
  } catch (const GC::Error& e) {
    result.reason = e.what();
    return result;
  }
  const GC::Edge_enclosure& e = *result.enclosure;
  const auto within = [](const std::optional<GC::Edge_maximum>& x, const GC::Bound& bound) {
    return x ? GC::at_most(x->value, bound) : GC::Verdict::undecided;
  };
  result.within[0] = GC::at_most(e.gap.value, demand.bounds.gap);
  result.within[1] = result.within[0] && within(e.angle, demand.bounds.angle);
  result.within[2] = result.within[1] && within(e.curvature_jump, demand.bounds.curvature);
  const GC::Verdict is_kink = within(e.angle, demand.kink), is_smooth = within(e.angle, demand.bounds.angle);
  if (result.within[0] == GC::Verdict::refuted)
    result.shape = Cad_shape::gap;
  else if (is_smooth == GC::Verdict::proved)
    result.shape = Cad_shape::smooth;
  else if (is_kink == GC::Verdict::refuted)
    result.shape = Cad_shape::corner;
  else if (is_smooth == GC::Verdict::refuted && is_kink == GC::Verdict::proved)
    result.shape = Cad_shape::kink;
  return result;
}

#endif // GEOMETRIC_CONTINUITY_DEMO_CAD_CAD_VERDICT_H
