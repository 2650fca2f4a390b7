// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_REPORT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_REPORT_H

#include "commands/chains/join_report.h"
#include "commands/models/model_findings.h"
#include "commands/models/model_json.h"
#include "files/progress.h"

#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/models/near_edges.h>

#include <cstddef>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

// What is asked of the edges of a model.
struct Edge_demand {
  std::optional<int> order;
  std::optional<GC::Edge_tolerance> tolerance;
  GC::Work_limit limit; // for each edge
};

// Multiplies the parameters that are printed.
inline void scale_parameters(Continuity& e, const Exact& factor) {
  for (GC::Edge_span<Exact>& span : e.spans) {
    span.begin *= factor;
    span.end *= factor;
  }
}

// The decisions on a model, exact and within the tolerance. Parameters are printed times `parameter_unit`.
template <class Surface> class Model_report {
  const std::vector<Surface>& surfaces_;
  const Patch_places& places_;
  const Report_mode mode_;
  const Edge_demand demand_;
  GC::Model_continuity<Exact> model_;
  std::vector<std::optional<Within>> edges_, lines_; // as those of the model
  std::vector<GC::Near_edges> near_;
  std::size_t failing_edges_ = 0, failing_lines_ = 0, undecided_ = 0;

public:
  Model_report(const std::vector<Surface>& surfaces, const Patch_places& places, const Report_mode& mode,
               const Edge_demand& demand, const Exact& parameter_unit)
      : surfaces_(surfaces), places_(places), mode_(mode), demand_(demand), model_(decided(surfaces, demand.limit)) {
    Progress progress("edges and knot lines within the tolerance");
    const auto step = [&] {
      const std::size_t done = edges_.size() + lines_.size();
      progress.step(done, [&] { return double(done) / double(model_.edges.size() + model_.knot_lines.size()); });
    };
    for (const Edge& e : model_.edges) {
      edges_.emplace_back();
      if (e.kind != GC::Model_edge_kind::shared) continue;
      if (demand_.tolerance) edges_.back() = GC::order_within(e.continuity, *demand_.tolerance);
      failing_edges_ += fails(e.continuity.g_order, edges_.back());
      undecided_ += is_undecided(edges_.back());
      step();
    }
    for (const Line& l : model_.knot_lines) {
      lines_.emplace_back();
      if (demand_.tolerance)
        lines_.back() = GC::order_within(surfaces[l.patch], l.line, *demand_.tolerance, demand_.limit);
      failing_lines_ += fails(l.line.continuity.g_order, lines_.back());
      undecided_ += is_undecided(lines_.back());
      step();
    }
    if (demand_.tolerance && demand_.tolerance->gap.upper() > 0) near_ = near(surfaces, model_, demand_);
    for (const GC::Near_edges& e : near_) {
      failing_edges_ += fails(-1, e.within);
      undecided_ += is_undecided(e.within);
    }
    if (parameter_unit != 1) {
      for (Edge& e : model_.edges) scale_parameters(e.continuity, parameter_unit);
      for (Line& l : model_.knot_lines) {
        scale_parameters(l.line.continuity, parameter_unit);
        l.line.knot *= parameter_unit;
      }
    }
  }

  // Prints the report and returns the exit code.
  int print() const {
    if (mode_.has_findings())
      print_findings();
    else if (mode_.format == Report_format::json)
      print_json();
    else
      print_text();
    return conclusion().exit_code(mode_, "shared edge");
  }

private:
  void print_findings() const;
  void print_json() const;
  void write_summary(std::ostream& os) const;
  void print_text() const;
  void print_verdict() const;

  static GC::Model_continuity<Exact> decided(const std::vector<Surface>& surfaces, GC::Work_limit limit) {
    Progress progress("edges and knot lines");
    return GC::model_continuity<CGAL::Parallel_if_available_tag>(surfaces, limit,
                                                                 [&](std::size_t n) { progress.step(n); });
  }

  static std::vector<GC::Near_edges> near(const std::vector<Surface>& surfaces,
                                          const GC::Model_continuity<Exact>& model, const Edge_demand& demand) {
    Progress progress("boundary edges");
    const auto part = [&](std::size_t n) { return double(n) / double(model.summary.boundary); };
    return GC::near_edges(surfaces, model, *demand.tolerance, demand.limit,
                          [&](std::size_t n) { progress.step(n, [&] { return part(n); }); });
  }

  // Edges that are single points have no tangent planes to compare.
  Conclusion conclusion() const {
    const GC::Model_summary& s = model_.summary;
    return {s.g2 + s.g1 + s.g0 + lines_.size() + near_.size(), failing_edges_ + failing_lines_,
            s.collapsed + undecided_};
  }

  bool fails(int exact_order, const std::optional<Within>& within) const {
    return demand_.order && exact_order < *demand_.order &&
           !(within && (*within)(*demand_.order) == GC::Verdict::proved);
  }

  // Whether an order is undecided within the tolerance. If one is required, it has been proved, or counts as failing.
  bool is_undecided(const std::optional<Within>& within) const {
    return !demand_.order && within &&
           ((*within)(0) == GC::Verdict::undecided || (*within)(1) == GC::Verdict::undecided);
  }

  Edge_state state(int exact_order, const std::optional<Within>& within) const {
    const bool fails = this->fails(exact_order, within),
               fails_undecided = fails && within && (*within)(*demand_.order) == GC::Verdict::undecided,
               is_smooth = 1 <= exact_order || (within && (*within)(1) == GC::Verdict::proved);
    return {fails, fails_undecided || is_undecided(within), !demand_.order && !is_smooth};
  }

  // "G1" or "G1 within the tolerance"; empty when nothing is required
  std::string required() const {
    return demand_.order ? "G" + std::to_string(*demand_.order) + (demand_.tolerance ? " within the tolerance" : "")
                         : "";
  }

  // What is printed: everything, or only what fails.
  bool is_printed(const Edge& e, const std::optional<Within>& within) const {
    return !mode_.summary || (e.kind == GC::Model_edge_kind::shared && fails(e.continuity.g_order, within));
  }
  bool is_printed(const Line& l, const std::optional<Within>& within) const {
    return !mode_.summary || fails(l.line.continuity.g_order, within);
  }
  bool is_printed(const GC::Near_edges& e) const { return !mode_.summary || fails(-1, e.within); }

  static void print(const std::optional<Within>& within) {
    if (within) print(*within);
  }
  static void print(const Within& within) {
    std::cout << "  within the tolerance: order 0 " << within(0) << ", 1 " << within(1) << "; " << within.deviation
              << '\n';
  }
};

template <class Surface> void Model_report<Surface>::print_findings() const {
  Model_findings findings(places_, mode_, required());
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Edge& e = model_.edges[i];
    if (e.kind == GC::Model_edge_kind::shared) findings.add(e, edges_[i], state(e.continuity.g_order, edges_[i]));
    if (e.kind == GC::Model_edge_kind::collapsed) findings.add_collapsed(e);
  }
  for (std::size_t i = 0; i < lines_.size(); ++i)
    findings.add(model_.knot_lines[i], lines_[i], state(model_.knot_lines[i].line.continuity.g_order, lines_[i]));
  for (const GC::Near_edges& e : near_) findings.add(e, state(-1, e.within));
  std::ostringstream summary;
  write_summary(summary);
  findings.print(std::cout, summary.str());
}

template <class Surface> void Model_report<Surface>::print_json() const {
  std::cout << "{\"edges\":[";
  const char* separator = "\n ";
  for (std::size_t i = 0; i < model_.edges.size(); ++i)
    if (model_.edges[i].kind == GC::Model_edge_kind::shared && is_printed(model_.edges[i], edges_[i])) {
      std::cout << separator;
      write_json(std::cout, model_.edges[i], edges_[i]);
      separator = ",\n ";
    }
  std::cout << "],\n \"knot_lines\":[";
  separator = "\n ";
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (!is_printed(model_.knot_lines[i], lines_[i])) continue;
    std::cout << separator;
    write_json(std::cout, model_.knot_lines[i], lines_[i]);
    separator = ",\n ";
  }
  if (demand_.tolerance) {
    std::cout << "],\n \"near_edges\":[";
    separator = "\n ";
    for (const GC::Near_edges& e : near_) {
      if (!is_printed(e)) continue;
      std::cout << separator;
      write_json(std::cout, e);
      separator = ",\n ";
    }
  }
  if (!mode_.summary) {
    std::cout << "],\n \"boundary_edges\":[";
    write_json(std::cout, model_.edges, GC::Model_edge_kind::boundary);
    std::cout << "],\n \"collapsed_edges\":[";
    write_json(std::cout, model_.edges, GC::Model_edge_kind::collapsed);
  }
  std::cout << "],\n ";
  write_summary(std::cout);
  std::cout << "}\n";
}

template <class Surface> void Model_report<Surface>::write_summary(std::ostream& os) const {
  const GC::Model_summary& s = model_.summary;
  os << "\"summary\":{\"G2\":" << s.g2 << ",\"G1\":" << s.g1 << ",\"G0\":" << s.g0 << ",\"boundary\":" << s.boundary
     << ",\"collapsed\":" << s.collapsed << ",\"vanishing_normals\":" << s.vanishing_normals
     << ",\"creases\":" << s.creases << ",\"folds\":" << s.folds << ",\"non_manifold\":" << s.non_manifold
     << ",\"knot_lines\":{\"G2\":" << s.knot_lines_g2 << ",\"G1\":" << s.knot_lines_g1 << ",\"G0\":" << s.knot_lines_g0
     << "}}";
  if (demand_.order) os << ",\n \"required\":\"G" << *demand_.order << "\",\"met\":" << conclusion().json_met(mode_);
}

template <class Surface> void Model_report<Surface>::print_text() const {
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (!is_printed(model_.edges[i], edges_[i])) continue;
    std::cout << model_.edges[i] << '\n';
    print(edges_[i]);
  }
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (!is_printed(model_.knot_lines[i], lines_[i])) continue;
    std::cout << model_.knot_lines[i] << '\n';
    print(lines_[i]);
  }
  for (const GC::Near_edges& e : near_) {
    if (!is_printed(e)) continue;
    std::cout << e << '\n';
    print(e.within);
  }
  std::cout << surfaces_.size() << " patches: " << model_.summary;
  if (!near_.empty()) std::cout << "; near edges: " << near_.size();
  std::cout << '\n';
  const Conclusion all = conclusion();
  if (all.decided == 0) std::cout << "no shared edge, nothing was decided\n";
  if (demand_.order && all.decided > 0) print_verdict();
  if (undecided_ > 0) std::cout << "orders that are undecided within the tolerance: " << undecided_ << '\n';
  if (mode_.strict && all.unverified > 0) std::cout << "not met, because not all was verified\n";
}

template <class Surface> void Model_report<Surface>::print_verdict() const {
  const Conclusion all = conclusion();
  const std::string order = required(), near = near_.empty() ? "" : " and every pair of near edges",
                    inside = lines_.empty() ? "" : " and every knot line";
  if (all.failing == 0) {
    std::cout << "every shared edge" << near << inside << " is " << order << ", proved exactly";
    if (model_.summary.collapsed > 0)
      std::cout << "; " << counted(model_.summary.collapsed, "collapsed edge") << " not verified";
    std::cout << '\n';
  }
  if (failing_edges_ > 0) std::cout << failing_edges_ << " of them not " << order << '\n';
  if (failing_lines_ > 0)
    std::cout << failing_lines_ << (failing_lines_ == 1 ? " knot line not " : " knot lines not ") << order << '\n';
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_REPORT_H
