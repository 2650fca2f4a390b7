// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_FINDINGS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_FINDINGS_H

#include "commands/commands.h"
#include "commands/models/model_json.h"
#include "formats/g2_text/surfaces.h"
#include "reports/finding.h"

#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Where the patches of a model stand.
class Patch_places {
  std::vector<std::string> names_; // of the files
  std::vector<Surface_place> places_;

public:
  Patch_places(const Arguments& files, std::vector<Surface_place> places) : places_(std::move(places)) {
    for (const std::string& file : files) names_.push_back(input_name(file));
  }

  const std::vector<std::string>& names() const { return names_; }
  const std::string& name(std::size_t patch) const { return names_[places_[patch].file]; }
  long long line(std::size_t patch) const { return places_[patch].line; }

  // The file and the number of a patch in it, from 0 on.
  std::size_t number_in_file(std::size_t patch) const {
    std::size_t first = patch;
    while (first > 0 && places_[first - 1].file == places_[patch].file) --first;
    return patch - first;
  }
};

// Returns the rule for a defect of an edge.
inline Finding_rule edge_rule(GC::Edge_defect defect) {
  switch (defect) {
  case GC::Edge_defect::gap: return Finding_rule::gap;
  case GC::Edge_defect::vanishing_normal: return Finding_rule::tangent;
  case GC::Edge_defect::crease:
  case GC::Edge_defect::fold: return Finding_rule::kink;
  case GC::Edge_defect::curvature: return Finding_rule::curvature;
  case GC::Edge_defect::none:
  case GC::Edge_defect::collapsed: break;
  }
  return Finding_rule::not_verified;
}

template <class T> std::string text_of(const T& x) {
  std::ostringstream os;
  os << x;
  return os.str();
}

inline std::string edge_name(std::size_t patch, GC::Patch_edge edge) {
  return "patch " + std::to_string(patch) + ' ' + text_of(edge);
}

// The patch on which an edge, a knot line or a pair of near edges is found.
inline std::size_t patch_of(const Edge& e) { return e.patch_a; }
inline std::size_t patch_of(const Line& l) { return l.patch; }
inline std::size_t patch_of(const GC::Nearly_coincident_edges& e) { return e.patch_a; }

// The other patch, if there is one.
inline std::optional<std::size_t> other_patch_of(const Edge& e) { return e.patch_b; }
inline std::optional<std::size_t> other_patch_of(const Line&) { return std::nullopt; }
inline std::optional<std::size_t> other_patch_of(const GC::Nearly_coincident_edges& e) { return e.patch_b; }

// Where it is on its patches.
inline std::string spot_of(const Edge& e) { return text_of(e.edge_a) + (e.edge_b ? ' ' + text_of(*e.edge_b) : ""); }
inline std::string spot_of(const Line& l) { return (l.line.constant_u ? "u = " : "v = ") + text_of(l.line.knot); }
inline std::string spot_of(const GC::Nearly_coincident_edges& e) { return text_of(e.edge_a) + ' ' + text_of(e.edge_b); }

// How large the defect of this rule is, if that is known.
inline std::optional<Measure> measure_of(Finding_rule rule, const std::optional<GC::Normal_deviation<Exact>>& angle,
                                         const std::optional<Within>& within) {
  if (rule == Finding_rule::gap && within) return Measure{"gap", within->deviation.gap};
  if (rule != Finding_rule::kink) return std::nullopt;
  if (within && within->deviation.normal_angle)
    return Measure{"angle_degrees", GC::in_degrees(*within->deviation.normal_angle)};
  return angle ? std::optional<Measure>(Measure{"angle_degrees", GC::in_degrees(angle->angle())}) : std::nullopt;
}
inline std::optional<Measure> measure_of(Finding_rule rule, const Edge& e, const std::optional<Within>& within) {
  return measure_of(rule, e.continuity.deviation, within);
}
inline std::optional<Measure> measure_of(Finding_rule rule, const Line& l, const std::optional<Within>& within) {
  return measure_of(rule, l.line.continuity.deviation, within);
}
inline std::optional<Measure> measure_of(Finding_rule rule, const GC::Nearly_coincident_edges&,
                                         const std::optional<Within>& within) {
  return measure_of(rule, std::optional<GC::Normal_deviation<Exact>>(), within);
}

// The words about an edge.
struct Edge_words {
  std::string kind, place;
  GC::Edge_defect defect;
  std::string verdict;
};

inline Edge_words words_of(const Edge& e) {
  if (e.kind == GC::Model_edge_kind::collapsed)
    return {"edge", edge_name(e.patch_a, e.edge_a), GC::Edge_defect::collapsed, "a single point"};
  return {"edge", edge_name(e.patch_a, e.edge_a) + " - " + edge_name(*e.patch_b, *e.edge_b), e.continuity.defect,
          text_of(e.continuity) + (e.non_manifold ? ", non-manifold" : "")};
}

inline Edge_words words_of(const Line& l) {
  return {"knot line",
          "patch " + std::to_string(l.patch) + (l.line.constant_u ? " u = " : " v = ") + text_of(l.line.knot),
          l.line.continuity.defect, text_of(static_cast<const Continuity&>(l.line.continuity))};
}

inline Edge_words words_of(const GC::Nearly_coincident_edges& e) {
  return {"near edges", edge_name(e.patch_a, e.edge_a) + " - " + edge_name(e.patch_b, e.edge_b), GC::Edge_defect::gap,
          "near"};
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_FINDINGS_H
