// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_CAD_VERDICT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_CAD_VERDICT_H

#include "commands/chains/curvature_bound.h"
#include "formats/cad/Cad_model.h"
#include "reports/Claims.h"

#include <CGAL/Geometric_continuity/cad/cad_edge_continuity.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// The tolerance unless one is given: the edges of CAD models are computed, and never meet exactly.
constexpr const char *default_cad_tolerance = "vda-4955",
                     *default_cad_tolerance_of_curvature = "0.02,0.1deg,5%"; // where G2 or C2 is required

// The demands on the edges of CAD models and on the joins of wires.
struct Cad_demand {
  std::optional<int> order; // that is required
  int most = 0;             // up to this order there are bounds
  // of the gap in mm, the angle in radians and the relative jump of the curvature
  GC::Join_tolerance bounds;
  std::string tolerance; // as it is written
  GC::Bound kink;        // the angle that is reached all along a corner, in radians
  // C orders are those of wires
  GC::Continuity_kind kind = GC::Continuity_kind::G;
  std::optional<Curvature_bound> curvature = {}; // of curves without faces

  // Returns what is required, e.g. "G1"; empty if nothing is.
  std::string name() const {
    return order ? (kind == GC::Continuity_kind::C ? 'C' : 'G') + std::to_string(*order) : std::string();
  }
};

// How two faces meet along an edge. A corner is sharp everywhere, a fading one in places only,
// which may not be meant. At a fold a face comes back below the other. A bent edge is one of kink,
// corner and fading corner, and it is undecided which.
enum class Cad_shape { smooth, kink, corner, fading_corner, bent, fold, inside_out, gap, undecided };

inline const char* name(Cad_shape shape) {
  switch (shape) {
  case Cad_shape::smooth: return "smooth";
  case Cad_shape::kink: return "kink";
  case Cad_shape::corner: return "corner";
  case Cad_shape::fading_corner: return "fading corner";
  case Cad_shape::bent: return "kink or corner";
  case Cad_shape::fold: return "fold";
  case Cad_shape::inside_out: return "inside out";
  case Cad_shape::gap: return "gap";
  case Cad_shape::undecided: break;
  }
  return "undecided";
}

// Returns whether the two sides of an edge are compared.
inline bool has_verdict(const Cad_edge& edge) {
  return edge.kind == Cad_edge_kind::inner || edge.kind == Cad_edge_kind::seam || edge.kind == Cad_edge_kind::knot_line;
}

// The orders of an edge, or of a join of curves, within the tolerance.
struct Cad_orders {
  // For each order: edges or ends are the same; in addition tangent planes or tangents agree; the
  // curvatures across the edge or the curvature vectors.
  std::array<GC::Verdict, 3> within{GC::Verdict::undecided, GC::Verdict::undecided, GC::Verdict::undecided};

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
};

// The verdict on an edge within the tolerance.
struct Cad_verdict : Cad_orders {
  std::optional<GC::Edge_enclosure> enclosure; // if the edge has two sides that can be compared
  // why they cannot, or why the edge is not what it is said to be
  std::string reason;
  // the order with no tolerance, -1 for a gap, where it can be decided
  std::optional<int> exact;
  Cad_shape shape = Cad_shape::undecided;
  GC::Verdict is_corner = GC::Verdict::undecided; // of what is not smooth
  // of the curve in space from the side that is farther from it
  std::optional<GC::Edge_maximum> deviation;
  // the curves in the parameter planes are foot points of that in space, which the program has
  // computed
  bool computed = false;
  // Ranges of parameters that belong to a pole within the tolerance of gaps: angle and curvature
  // jump leave them out.
  std::vector<std::pair<double, double>> poles;
  bool is_exhausted = false; // the work did not suffice
  bool in_doubt = false;     // what is wrong may be wrong with projections only

  // Returns the order that holds with no tolerance: "G2", "G1", "G0" or "gap"; nothing where it
  // cannot be decided.
  std::optional<std::string> exact_name() const {
    if (!exact) return std::nullopt;
    return *exact < 0 ? "gap" : 'G' + std::to_string(*exact);
  }

  // Returns whether the edge has an order. A corner is meant: its faces need to meet only.
  GC::Verdict meets(int asked) const {
    GC::Verdict result = within[0];
    if (shape == Cad_shape::corner) return result;
    for (int i = 1; i <= asked; ++i) result = result && within[static_cast<std::size_t>(i)];
    return shape == Cad_shape::bent && is_corner == GC::Verdict::undecided && asked > 0 &&
                   within[0] != GC::Verdict::refuted
               ? GC::Verdict::undecided
               : result;
  }
};

// The verdict on a join of curves within the tolerance.
struct Cad_join_verdict : Cad_orders {
  std::optional<GC::Wire_enclosure> enclosure; // if it can be computed
  std::string reason;                          // why it cannot
  // In addition to the ends the first and the second derivatives agree.
  std::array<GC::Verdict, 3> c_within = within;
  Cad_shape shape = Cad_shape::undecided; // never one that only faces have

  // Returns whether the join has an order. A corner is meant, unless a C order is asked for.
  GC::Verdict meets(GC::Continuity_kind kind, int asked) const {
    if (kind == GC::Continuity_kind::C) return c_within[static_cast<std::size_t>(asked)];
    if (shape == Cad_shape::corner) return within[0];
    if (shape == Cad_shape::bent && asked > 0 && within[0] != GC::Verdict::refuted) return GC::Verdict::undecided;
    return within[static_cast<std::size_t>(asked)];
  }
};

// Why a place where more than two curves of a wire meet is not covered.
constexpr const char* branching_of_curves = "three curves or more meet there";

// Returns the class of a join and why it is not decided, as claim_of() an edge does.
Given claim_of(const Cad_join_verdict& verdict, const Cad_demand& demand);

// Returns the verdict on a join of curves.
Cad_join_verdict cad_verdict(const Cad_join& join, const Cad_demand& demand);

// Why boundary edges are not covered that lie beside others.
constexpr const char* beside_another = "it lies beside another boundary edge and was not compared with it, see --sew";

// Returns whether an edge is said to be a point, and is not proved to be one.
inline bool is_no_point(const Cad_edge& edge, const Cad_verdict& verdict) {
  return edge.kind == Cad_edge_kind::degenerate && verdict.within[0] != GC::Verdict::proved;
}

// Decides whether a curve without faces exceeds the bound on the curvature, and encloses its
// largest curvature, in 1/mm.
struct Cad_bend {
  Given given;
  GC::Edge_maximum curvature;
};
Cad_bend cad_bend(const Cad_curve_edge& curve, const Curvature_bound& bound);

// Returns the class of an edge and why it is not decided: with a requirement whether it is met,
// otherwise whether the orders 0 and 1 are decided. Empty for boundaries and proved points, which
// have nothing to decide.
std::optional<Given> claim_of(const Cad_edge& edge, const Cad_verdict& verdict, const Cad_demand& demand);

// Returns the verdict on an edge: on one that is said to be a point whether it is.
Cad_verdict cad_verdict(const Cad_edge& edge, const Cad_demand& demand);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CAD_CAD_VERDICT_H
