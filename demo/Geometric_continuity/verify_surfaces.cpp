// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input.h"
#include "join_report.h"
#include "progress.h"
#include "work_limit.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/models/near_edges.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace {

typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
typedef Exact FT;
typedef GC::Model_edge<FT> Edge;
typedef GC::Model_knot_line<FT> Line;
typedef GC::Spline_edge_continuity<FT> Continuity;
typedef GC::Edge_order_within Within;

// What is asked of the edges of a model.
struct Edge_demand {
  std::optional<int> order;
  std::optional<GC::Edge_tolerance> tolerance;
  GC::Work_limit limit; // for each edge
};

const char* boolean(bool b) { return b ? "true" : "false"; }

std::string order(const GC::Edge_continuity<FT>& e) {
  return e.g_order < 0 ? to_string(e.defect) : "G" + std::to_string(e.g_order);
}

// Writes the members that edges, knot lines and spans have in common.
void write_verdict(std::ostream& os, const GC::Edge_continuity<FT>& e) {
  os << "\"order\":\"" << order(e) << "\",\"reason\":\"" << e.defect << "\",\"side\":\"" << e.side << '"';
  if (e.deviation) GC::write_number(os << ",\"angle_at_most\":", e.deviation->largest_angle());
}

void write_verdict(std::ostream& os, const Continuity& e) {
  write_verdict(os, static_cast<const GC::Edge_continuity<FT>&>(e));
  if (e.spans.size() == 1) return;
  const char* separator = ",\"spans\":[";
  for (const GC::Edge_span<FT>& span : e.spans) {
    os << separator << "{\"begin\":\"" << span.begin << "\",\"end\":\"" << span.end << "\",";
    write_verdict(os, span.continuity);
    os << '}';
    separator = ",";
  }
  os << ']';
}

void write_json(std::ostream& os, const Within& within) {
  os << ",\"within\":[\"" << within(0) << "\",\"" << within(1) << "\"]";
  os << ",\"gap\":";
  GC::write_json(os, within.deviation.gap);
  os << ",\"normal_angle\":";
  GC::write_json(os, within.deviation.normal_angle);
}

template <class A, class B>
void write_names(std::ostream& os, std::size_t patch_a, const A& edge_a, std::size_t patch_b, const B& edge_b) {
  os << "{\"patch_a\":" << patch_a << ",\"edge_a\":\"" << edge_a << "\",\"patch_b\":" << patch_b << ",\"edge_b\":\""
     << edge_b << '"';
}

void write_json(std::ostream& os, const Edge& e, const std::optional<Within>& within) {
  write_names(os, e.patch_a, e.edge_a, *e.patch_b, *e.edge_b);
  os << ',';
  write_verdict(os, e.continuity);
  os << ",\"reversed\":" << boolean(e.continuity.reversed) << ",\"non_manifold\":" << boolean(e.non_manifold);
  if (within) write_json(os, *within);
  os << '}';
}

void write_json(std::ostream& os, const Line& l, const std::optional<Within>& within) {
  os << "{\"patch\":" << l.patch << ",\"direction\":\"" << (l.line.constant_u ? 'u' : 'v') << "\",\"knot\":\""
     << l.line.knot << "\",\"multiplicity\":" << l.line.multiplicity << ',';
  write_verdict(os, l.line.continuity);
  if (within) write_json(os, *within);
  os << '}';
}

void write_json(std::ostream& os, const GC::Near_edges& e) {
  write_names(os, e.patch_a, e.edge_a, e.patch_b, e.edge_b);
  os << ",\"reversed\":" << boolean(e.within.deviation.reversed);
  write_json(os, e.within);
  os << '}';
}

// Writes the edges of one kind that are not shared.
void write_json(std::ostream& os, const std::vector<Edge>& edges, GC::Model_edge_kind kind) {
  const char* separator = "";
  for (const Edge& e : edges)
    if (e.kind == kind) {
      os << separator << "{\"patch\":" << e.patch_a << ",\"edge\":\"" << e.edge_a << "\"}";
      separator = ",";
    }
}

// The decisions on a model, exact and within the tolerance.
template <class Surface> class Model_report {
  const std::vector<Surface>& surfaces_;
  const Report_mode mode_;
  const Edge_demand demand_;
  const GC::Model_continuity<FT> model_;
  std::vector<std::optional<Within>> edges_, lines_; // as those of the model
  std::vector<GC::Near_edges> near_;
  std::size_t failing_edges_ = 0, failing_lines_ = 0, undecided_ = 0;

public:
  Model_report(const std::vector<Surface>& surfaces, const Report_mode& mode, const Edge_demand& demand)
      : surfaces_(surfaces), mode_(mode), demand_(demand), model_(decided(surfaces, demand.limit)) {
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
    if (demand_.tolerance && demand_.tolerance->gap > 0) near_ = near(surfaces, model_, demand_);
    for (const GC::Near_edges& e : near_) {
      failing_edges_ += fails(-1, e.within);
      undecided_ += is_undecided(e.within);
    }
  }

  // Prints the report and returns the exit code.
  int print() const {
    if (mode_.format == Report_format::json)
      print_json();
    else
      print_text();
    return conclusion().exit_code(mode_, "shared edge");
  }

private:
  void print_json() const;
  void print_text() const;
  void print_verdict() const;

  static GC::Model_continuity<FT> decided(const std::vector<Surface>& surfaces, GC::Work_limit limit) {
    Progress progress("edges and knot lines");
    return GC::model_continuity(surfaces, limit, [&](std::size_t n) { progress.step(n); });
  }

  static std::vector<GC::Near_edges> near(const std::vector<Surface>& surfaces, const GC::Model_continuity<FT>& model,
                                          const Edge_demand& demand) {
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

  static void print(const std::optional<Within>& within) {
    if (within) print(*within);
  }
  static void print(const Within& within) {
    std::cout << "  within the tolerance: order 0 " << within(0) << ", 1 " << within(1) << "; " << within.deviation
              << '\n';
  }
};

template <class Surface> void Model_report<Surface>::print_json() const {
  std::cout << "{\"edges\":[";
  const char* separator = "\n ";
  for (std::size_t i = 0; i < model_.edges.size(); ++i)
    if (model_.edges[i].kind == GC::Model_edge_kind::shared) {
      std::cout << separator;
      write_json(std::cout, model_.edges[i], edges_[i]);
      separator = ",\n ";
    }
  std::cout << "],\n \"knot_lines\":[";
  separator = "\n ";
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    std::cout << separator;
    write_json(std::cout, model_.knot_lines[i], lines_[i]);
    separator = ",\n ";
  }
  if (demand_.tolerance) {
    std::cout << "],\n \"near_edges\":[";
    separator = "\n ";
    for (const GC::Near_edges& e : near_) {
      std::cout << separator;
      write_json(std::cout, e);
      separator = ",\n ";
    }
  }
  std::cout << "],\n \"boundary_edges\":[";
  write_json(std::cout, model_.edges, GC::Model_edge_kind::boundary);
  std::cout << "],\n \"collapsed_edges\":[";
  write_json(std::cout, model_.edges, GC::Model_edge_kind::collapsed);
  const GC::Model_summary& s = model_.summary;
  std::cout << "],\n \"summary\":{\"G2\":" << s.g2 << ",\"G1\":" << s.g1 << ",\"G0\":" << s.g0
            << ",\"boundary\":" << s.boundary << ",\"collapsed\":" << s.collapsed
            << ",\"vanishing_normals\":" << s.vanishing_normals << ",\"creases\":" << s.creases
            << ",\"folds\":" << s.folds << ",\"non_manifold\":" << s.non_manifold
            << ",\"knot_lines\":{\"G2\":" << s.knot_lines_g2 << ",\"G1\":" << s.knot_lines_g1
            << ",\"G0\":" << s.knot_lines_g0 << "}}";
  if (demand_.order)
    std::cout << ",\n \"required\":\"G" << *demand_.order << "\",\"met\":" << conclusion().json_met(mode_);
  std::cout << "}\n";
}

template <class Surface> void Model_report<Surface>::print_text() const {
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    std::cout << model_.edges[i] << '\n';
    print(edges_[i]);
  }
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    std::cout << model_.knot_lines[i] << '\n';
    print(lines_[i]);
  }
  for (const GC::Near_edges& e : near_) {
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
  const std::string order = "G" + std::to_string(*demand_.order) + (demand_.tolerance ? " within the tolerance" : ""),
                    near = near_.empty() ? "" : " and every pair of near edges",
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

} // namespace

int verify_surfaces(const Arguments& files, const Report_mode& mode, const std::optional<int>& required_g_order,
                    const std::optional<GC::Edge_tolerance>& tolerance, GC::Work_limit limit) {
  const Surface_model<Traits> model = read_surfaces<Traits>(files);
  return within_work_limit([&] { return files.size() == 1 ? input_name(files[0]) : input_name(files[0]) + ", ..."; },
                           [&] {
                             return model.visit([&](const auto& surfaces) {
                               return Model_report(surfaces, mode, {required_g_order, tolerance, limit}).print();
                             });
                           });
}
