// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_REPORT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_REPORT_H

#include "commands/models/Model_surfaces.h"
#include "commands/models/model_findings.h"
#include "commands/models/model_json.h"
#include "files/progress.h"
#include "reports/Fingerprints.h"
#include "reports/Report.h"
#include "reports/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

// The demands on the edges of a model.
struct Edge_demand {
  std::optional<int> order;
  std::optional<GC::Edge_tolerance> tolerance;
};

// Multiplies the parameters that are printed.
inline void scale_parameters(Continuity& e, const Exact& factor) {
  for (GC::Edge_span<Exact>& span : e.spans) {
    span.begin *= factor;
    span.end *= factor;
  }
}

// The decisions on a model, exact and within the tolerance. Parameters are printed as those of the
// files.
class Model_report {
  const Model_surfaces& surfaces_;
  const Patch_places& places_;
  const Edge_demand demand_;
  GC::Model_continuity<Exact> model_;
  std::vector<std::optional<Within>> edges_, lines_; // as those of the model
  std::vector<GC::Nearly_coincident_edges> near_;
  Report report_;

public:
  Model_report(const Model_surfaces& surfaces, const Patch_places& places, const Report_mode& mode,
               const Edge_demand& demand)
      : surfaces_(surfaces), places_(places), demand_(demand), model_(surfaces.continuity(wanted_angles(mode, demand))),
        report_(mode, decide_within()) {
    const Exact& parameter_unit = surfaces.parameter_unit();
    if (parameter_unit == 1) return;
    for (Edge& e : model_.edges) scale_parameters(e.continuity, parameter_unit);
    for (Line& l : model_.knot_lines) {
      scale_parameters(l.line.continuity, parameter_unit);
      l.line.knot *= parameter_unit;
    }
  }

  // Prints the report and returns the exit code.
  int print() {
    for (const std::string& name : places_.names()) report_.begin_file(name);
    report_.row("edges");
    report_.row("knot_lines");
    if (demand_.tolerance) report_.row("near_edges");
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const Edge& e = model_.edges[i];
      if (e.kind == GC::Model_edge_kind::shared)
        add("edges", e, claim(e.continuity.g_order, edges_[i]), is_noted(e.continuity.g_order, edges_[i]), edges_[i]);
      else
        add_unshared(e);
    }
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const int order = model_.knot_lines[i].line.continuity.g_order;
      add("knot_lines", model_.knot_lines[i], claim(order, lines_[i]), is_noted(order, lines_[i]), lines_[i]);
    }
    for (const GC::Nearly_coincident_edges& e : near_)
      add("near_edges", e, claim(-1, e.within), is_noted(-1, e.within), std::optional<Within>(e.within));
    if (std::ostream* const os = report_.mode().certificate) surfaces_.write_certificate(*os, places_.names(), model_);
    return report_.print(std::cout, report_.mode().format == Report_format::text ? text_summary() : json_summary());
  }

private:
  // A summary tells angles only of what is not met.
  static GC::Crease_angles wanted_angles(const Report_mode& mode, const Edge_demand& demand) {
    const bool only_counts =
        mode.summary && !mode.has_findings() && mode.certificate == nullptr && !demand.order && !demand.tolerance;
    return only_counts ? GC::Crease_angles::omitted : GC::Crease_angles::enclosed;
  }

  // Decides what is asked within the tolerance, and returns what the report is about.
  Report_subject decide_within() {
    Progress progress("edges and knot lines within the tolerance");
    const auto step = [&] {
      const std::size_t done = edges_.size() + lines_.size();
      progress.step(done, [&] { return double(done) / double(model_.edges.size() + model_.knot_lines.size()); });
    };
    for (const Edge& e : model_.edges) {
      edges_.emplace_back();
      if (e.kind != GC::Model_edge_kind::shared) continue;
      if (demand_.tolerance) edges_.back() = GC::order_within(e.continuity, *demand_.tolerance);
      step();
    }
    for (const Line& l : model_.knot_lines) {
      lines_.emplace_back();
      if (demand_.tolerance) lines_.back() = surfaces_.order_within(l, *demand_.tolerance);
      step();
    }
    if (demand_.tolerance && demand_.tolerance->gap.upper() > 0)
      near_ = surfaces_.nearly_coincident_edges(model_, *demand_.tolerance);
    Report_subject s{"shared edge", std::string("every shared edge") +
                                        (near_.empty() ? "" : " and every pair of near edges") +
                                        (lines_.empty() ? "" : " and every knot line")};
    if (!demand_.order) return s;
    const std::string order = "G" + std::to_string(*demand_.order);
    s.required = order + (demand_.tolerance ? " within the tolerance" : "");
    s.required_in_json = "\"required\":\"" + order + '"';
    return s;
  }

  // Returns the claim of the requirement, exactly or within the tolerance; where nothing is
  // required, of all orders within the tolerance.
  Claim claim(int exact_order, const std::optional<Within>& within) const {
    if (!demand_.order) {
      const bool is_open = within && ((*within)(0) == GC::Verdict::undecided || (*within)(1) == GC::Verdict::undecided);
      return is_open ? Claim::undecided : Claim::met;
    }
    if (*demand_.order <= exact_order) return Claim::met;
    if (!within) return Claim::not_met;
    const GC::Verdict verdict = (*within)(*demand_.order);
    return verdict == GC::Verdict::proved      ? Claim::met
           : verdict == GC::Verdict::undecided ? Claim::undecided
                                               : Claim::not_met;
  }

  // Returns whether it is not smooth, though that is not required.
  bool is_noted(int exact_order, const std::optional<Within>& within) const {
    return !demand_.order && exact_order < 1 && !(within && (*within)(1) == GC::Verdict::proved);
  }

  // Adds an edge, a knot line or a pair of near edges, with its row or finding.
  template <class Row>
  void add(const std::string& array, const Row& row, Claim claim, bool is_noted, const std::optional<Within>& within) {
    const std::size_t patch = patch_of(row);
    report_.add(places_.name(patch), {claim, "edge", "the tolerance lies between the bounds"}, is_noted, [&] {
      const Edge_words words = words_of(row);
      Finding f;
      f.file = places_.name(patch);
      f.line = places_.line(patch);
      f.kind = words.kind;
      f.place = words.place;
      f.rule = claim == Claim::undecided ? Finding_rule::undecided : edge_rule(words.defect);
      f.message = (claim == Claim::not_met     ? "not " + report_.subject().required + ", "
                   : claim == Claim::undecided ? "an order is undecided within the tolerance, "
                                               : "") +
                  words.verdict + (within ? "; " + text_of(within->deviation) : "");
      const std::string object = json_of(row, within);
      f.properties = object.substr(1, object.size() - 2); // without braces
      set_place(f, row);
      f.measure = measure_of(f.rule, row, within);
      if (f.rule == Finding_rule::gap && within && within->deviation.normal_angle)
        f.behind = Measure{"angle_degrees", GC::in_degrees(*within->deviation.normal_angle)};
      return f;
    });
    if (!report_.shows(claim)) return;
    if (report_.mode().format == Report_format::json) report_.row(array, ",\n " + json_of(row, within), claim);
    if (report_.mode().format != Report_format::text) return;
    std::string line = text_of(row) + '\n';
    if (within)
      line += "  within the tolerance: order 0 " + text_of((*within)(0)) + ", 1 " + text_of((*within)(1)) + "; " +
              text_of(within->deviation) + '\n';
    report_.row(array, line, claim);
  }

  // Edges that no other surface has are listed; those that are single points have no tangent planes
  // to compare.
  void add_unshared(const Edge& e) {
    const bool collapsed = e.kind == GC::Model_edge_kind::collapsed;
    if (collapsed)
      report_.add(places_.name(e.patch_a),
                  {Claim::not_covered, "collapsed edge", "single points, where there are no tangent planes to compare"},
                  false, [&] {
                    Finding f;
                    f.file = places_.name(e.patch_a);
                    f.line = places_.line(e.patch_a);
                    f.kind = "edge";
                    f.place = edge_name(e.patch_a, e.edge_a);
                    f.rule = Finding_rule::not_verified;
                    f.message = "a single point, where there are no tangent planes to compare";
                    set_place(f, e);
                    return f;
                  });
    if (!report_.shows(Claim::met)) return;
    if (report_.mode().format == Report_format::text) report_.row("", text_of(e) + '\n', Claim::met);
    if (report_.mode().format == Report_format::json)
      report_.row(collapsed ? "collapsed_edges" : "boundary_edges",
                  ",{\"patch\":" + std::to_string(e.patch_a) + ",\"edge\":\"" + text_of(e.edge_a) + "\"}", Claim::met);
  }

  template <class Row> void set_place(Finding& f, const Row& row) const {
    const std::size_t patch = patch_of(row);
    const std::optional<std::size_t> other = other_patch_of(row);
    f.object = "patch " + std::to_string(places_.number_in_file(patch));
    f.spot = spot_of(row);
    f.shape = f.spot + net(patch);
    if (!other) return;
    f.object += " - " + (places_.name(*other) == f.file ? "" : path_in_folder(places_.name(*other)) + ' ') + "patch " +
                std::to_string(places_.number_in_file(*other));
    f.shape += net(*other);
  }

  // The control points of a patch as parts of the largest difference, wherever they are and in
  // whatever unit.
  std::string net(std::size_t patch) const {
    const std::vector<std::array<double, 3>> points = surfaces_.net(patch);
    double largest = 0;
    for (const std::array<double, 3>& point : points)
      for (const double x : point) largest = (std::max)(largest, std::abs(x));
    std::string text = ";";
    for (const std::array<double, 3>& point : points)
      for (const double x : point) text += ' ' + rounded(largest == 0 ? 0 : x / largest, 6);
    return text;
  }

  static std::string json_of(const GC::Nearly_coincident_edges& e, const std::optional<Within>&) {
    std::ostringstream os;
    write_json(os, e);
    return os.str();
  }
  template <class Row> static std::string json_of(const Row& row, const std::optional<Within>& within) {
    std::ostringstream os;
    write_json(os, row, within);
    return os.str();
  }

  std::string json_summary() const {
    const GC::Model_summary& s = model_.summary;
    std::ostringstream os;
    os << "\"summary\":{\"G2\":" << s.g2 << ",\"G1\":" << s.g1 << ",\"G0\":" << s.g0 << ",\"boundary\":" << s.boundary
       << ",\"collapsed\":" << s.collapsed << ",\"vanishing_normals\":" << s.vanishing_normals
       << ",\"creases\":" << s.creases << ",\"folds\":" << s.folds << ",\"non_manifold\":" << s.non_manifold
       << ",\"knot_lines\":{\"G2\":" << s.knot_lines_g2 << ",\"G1\":" << s.knot_lines_g1
       << ",\"G0\":" << s.knot_lines_g0 << "}}";
    return os.str();
  }

  std::string text_summary() const {
    std::ostringstream os;
    os << surfaces_.size() << " patches" << (demand_.tolerance ? ", with no tolerance: " : ": ") << model_.summary;
    if (!near_.empty()) os << "; near edges: " << near_.size();
    os << '\n';
    return os.str();
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_REPORT_H
