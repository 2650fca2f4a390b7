// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_FINDINGS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_FINDINGS_H

#include "commands/models/model_json.h"
#include "files/input.h"
#include "reports/finding.h"

#include <cstddef>
#include <memory>
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
};

// How an edge, a knot line or a pair of near edges does.
struct Edge_state {
  bool fails;        // the requirement is not met
  bool is_undecided; // the order that is required, or any one, is undecided within the tolerance
  bool is_noted;     // it is not smooth, though that is not required
};

// The findings of a model.
class Model_findings {
  const Patch_places& places_;
  const bool strict_;
  const std::string required_; // what a finding that fails is not, e.g. "G1"
  std::unique_ptr<Finding_writer> writer_;

  static Finding_rule rule(GC::Edge_defect defect) {
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

  static std::string edge_name(std::size_t patch, GC::Patch_edge edge) {
    std::ostringstream os;
    os << "patch " << patch << ' ' << edge;
    return os.str();
  }

  template <class Row, class... More>
  void add(std::size_t patch, const char* kind, const std::string& place, GC::Edge_defect defect,
           const std::string& verdict, const std::optional<Within>& within, const Edge_state& state, const Row& row,
           const More&... more) {
    if (!state.fails && !state.is_undecided && !state.is_noted) {
      writer_->add_passed(places_.name(patch), 1, "edges and knot lines");
      return;
    }
    Finding f;
    f.file = places_.name(patch);
    f.line = places_.line(patch);
    f.kind = kind;
    f.place = place;
    f.rule = state.is_undecided ? Finding_rule::undecided : rule(defect);
    f.level = state.fails || (state.is_undecided && strict_) ? Finding_level::error
              : state.is_undecided                           ? Finding_level::warning
                                                             : Finding_level::note;
    std::ostringstream message, properties;
    if (state.fails)
      message << "not " << required_ << ", ";
    else if (state.is_undecided)
      message << "an order is undecided within the tolerance, ";
    message << verdict;
    if (within) message << "; " << within->deviation;
    f.message = message.str();
    write_json(properties, row, more...);
    f.properties = properties.str();
    f.properties = f.properties.substr(1, f.properties.size() - 2); // without braces
    writer_->add(f);
  }

  template <class T> static std::string text(const T& x) {
    std::ostringstream os;
    os << x;
    return os.str();
  }

public:
  Model_findings(const Patch_places& places, const Report_mode& mode, std::string required)
      : places_(places), strict_(mode.strict), required_(std::move(required)), writer_(finding_writer(mode.format)) {
    for (const std::string& name : places.names()) writer_->add_passed(name, 0, "edges and knot lines");
  }

  void add(const Edge& e, const std::optional<Within>& within, const Edge_state& state) {
    add(e.patch_a, "edge", edge_name(e.patch_a, e.edge_a) + " - " + edge_name(*e.patch_b, *e.edge_b),
        e.continuity.defect, text(e.continuity) + (e.non_manifold ? ", non-manifold" : ""), within, state, e, within);
  }

  void add(const Line& l, const std::optional<Within>& within, const Edge_state& state) {
    add(l.patch, "knot line",
        "patch " + std::to_string(l.patch) + (l.line.constant_u ? " u = " : " v = ") + text(l.line.knot),
        l.line.continuity.defect, text(static_cast<const Continuity&>(l.line.continuity)), within, state, l, within);
  }

  void add(const GC::Near_edges& e, const Edge_state& state) {
    add(e.patch_a, "near edges", edge_name(e.patch_a, e.edge_a) + " - " + edge_name(e.patch_b, e.edge_b),
        GC::Edge_defect::gap, "near", e.within, state, e);
  }

  void add_collapsed(const Edge& e) {
    Finding f;
    f.file = places_.name(e.patch_a);
    f.line = places_.line(e.patch_a);
    f.kind = "edge";
    f.place = edge_name(e.patch_a, e.edge_a);
    f.rule = Finding_rule::not_verified;
    f.level = strict_ ? Finding_level::error : Finding_level::note;
    f.message = "a single point, where there are no tangent planes to compare";
    writer_->add(f);
  }

  void print(std::ostream& os, const std::string& summary) { writer_->print(os, summary); }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_FINDINGS_H
