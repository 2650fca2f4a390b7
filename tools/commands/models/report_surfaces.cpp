// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/chains/join_report.h"
#include "commands/models/Model_surfaces.h"
#include "commands/report_inputs.h"
#include "commands/work_limit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

// So many spans of surfaces are drawn, and so many cells in all, as far as each span has one.
constexpr std::size_t most_drawn_spans = 20000, most_drawn_cells = 16000;

const char* reason(GC::Edge_defect defect) {
  switch (defect) {
  case GC::Edge_defect::none: return "";
  case GC::Edge_defect::gap: return ", the surface jumps";
  case GC::Edge_defect::collapsed: return ", the line is a point";
  case GC::Edge_defect::vanishing_normal: return ", a normal vanishes";
  case GC::Edge_defect::crease: return ", the tangent planes differ";
  case GC::Edge_defect::fold: return ", the surfaces fold back";
  case GC::Edge_defect::curvature: return ", the curvatures differ";
  }
  return "";
}

// Gathers the edges of a model and the knot lines in it, and draws the surfaces.
class Model_page {
  const Model_surfaces& surfaces_;
  const GC::Model_continuity<Exact>& model_;
  const GC::Enclosure corner_threshold_; // degrees
  Report_page& page_;

public:
  Model_page(const Model_surfaces& surfaces, const GC::Model_continuity<Exact>& model,
             const GC::Enclosure& corner_threshold, Report_page& page)
      : surfaces_(surfaces), model_(model), corner_threshold_(corner_threshold), page_(page) {}

  // The edges of the items are numbered as those of the model, and the knot lines behind them.
  void gather() {
    for (std::size_t i = 0; i < model_.edges.size(); ++i) {
      const Edge& e = model_.edges[i];
      if (e.kind == GC::Model_edge_kind::shared)
        gather(i, e.continuity, [&] {
          return "surface " + std::to_string(e.patch_a) + ", edge " + to_string(e.edge_a) + " - surface " +
                 std::to_string(*e.patch_b) + ", edge " + to_string(*e.edge_b) +
                 (e.non_manifold ? " (more than two surfaces meet here)" : "");
        });
    }
    for (std::size_t i = 0; i < model_.knot_lines.size(); ++i) {
      const Line& l = model_.knot_lines[i];
      gather(model_.edges.size() + i, l.line.continuity, [&] {
        return "surface " + std::to_string(l.patch) + ", inside, knot line " + (l.line.constant_u ? "u" : "v") +
               " number " + std::to_string(number_of_line(i));
      });
    }
  }

  // Returns what is drawn when the page shows these edges and knot lines: they come first, and the
  // others as far as there is space.
  Report_model drawing(const std::vector<Report_item>& items) const {
    Report_model result;
    std::vector<std::size_t> order;
    std::vector<bool> has(surfaces_.size(), false);
    const auto add = [&](std::size_t surface) {
      if (!has[surface]) order.push_back(surface);
      has[surface] = true;
    };
    for (const Report_item& item : items) {
      result.edges.push_back(edge(item.edge, report_grade_name(item.grade)));
      for (std::size_t surface : result.edges.back().patches) add(surface);
    }
    for (std::size_t s = 0; s < surfaces_.size(); ++s) add(s);
    std::size_t all = 0;
    for (std::size_t s = 0; s < surfaces_.size(); ++s) all += spans(s);
    const double per_span = std::sqrt(double(most_drawn_cells) / double((std::max)(all, std::size_t(1))));
    const int cells = (std::max)(1, (std::min)(10, static_cast<int>(per_span)));
    result.patches.resize(surfaces_.size(), {0, 0, {}});
    std::size_t drawn = 0, left_out = 0;
    for (std::size_t s : order)
      if ((drawn += spans(s)) <= most_drawn_spans)
        result.patches[s] = patch(s, cells);
      else
        ++left_out;
    if (left_out > 0) page_.notes.push_back(std::to_string(left_out) + " surfaces are not drawn.");
    for (std::size_t i = 0; i < model_.edges.size(); ++i)
      if (model_.edges[i].kind == GC::Model_edge_kind::boundary && result.patches[model_.edges[i].patch_a].m > 0)
        result.edges.push_back(edge(i, "boundary"));
    return result;
  }

private:
  // The number of a knot line among those in the same direction of its surface, from 1 on.
  std::size_t number_of_line(std::size_t i) const {
    const Line& l = model_.knot_lines[i];
    std::size_t number = 1;
    for (std::size_t j = i; j > 0 && model_.knot_lines[j - 1].patch == l.patch; --j)
      number += model_.knot_lines[j - 1].line.constant_u == l.line.constant_u;
    return number;
  }

  Report_grade grade(const Continuity& e, const std::optional<GC::Enclosure>& angle) const {
    if (e.g_order < 0) return Report_grade::gap;
    if (e.g_order > 0) return e.g_order > 1 ? Report_grade::g2 : Report_grade::g1;
    if (e.defect == GC::Edge_defect::fold) return Report_grade::corner;
    if (e.defect != GC::Edge_defect::crease || !angle) return Report_grade::g0;
    if (angle->upper <= corner_threshold_.lower) return Report_grade::kink;
    return corner_threshold_.upper < angle->lower ? Report_grade::corner : Report_grade::undecided;
  }

  template <class Place> void gather(std::size_t number, const Continuity& e, Place place) {
    std::optional<GC::Enclosure> angle;
    if (e.g_order > 0)
      angle = GC::Enclosure{0, 0};
    else if (e.deviation)
      angle = GC::in_degrees(e.deviation->angle());
    const Report_grade grade = this->grade(e, angle);
    const double severity = angle ? angle->upper : 0;
    const std::string open = "the largest angle of a kink lies between the bounds";
    if (!page_.count(grade, severity, open)) return;
    Report_item item;
    item.number = page_.total();
    item.place = place();
    item.verdict = (e.g_order < 0 ? std::string("gap") : 'G' + std::to_string(e.g_order)) + reason(e.defect);
    if (e.spans.size() > 1 && e.defect != GC::Edge_defect::none)
      item.verdict += ", worst in span " + std::to_string(e.worst + 1) + " of " + std::to_string(e.spans.size());
    if (grade == Report_grade::undecided) item.verdict += ": " + open;
    item.grade = grade;
    item.angle = angle;
    item.severity = severity;
    item.edge = number;
    page_.add(std::move(item));
  }

  std::size_t spans(std::size_t surface) const {
    const auto [u, v] = surfaces_.spans(surface);
    return u * v;
  }

  Report_model::Patch patch(std::size_t surface, int cells) const {
    const auto number = [cells](std::size_t spans) { return (std::min)(cells * static_cast<int>(spans), 256); };
    const auto [u, v] = surfaces_.spans(surface);
    const int m = number(u), n = number(v);
    return {m, n, surfaces_.grid(surface, m, n)};
  }

  Report_model::Edge edge(std::size_t number, const std::string& grade) const {
    if (number >= model_.edges.size()) {
      const Line& l = model_.knot_lines[number - model_.edges.size()];
      return {grade, {l.patch}, surfaces_.knot_line(l)};
    }
    const Edge& e = model_.edges[number];
    Report_model::Edge result{grade, {e.patch_a}, surfaces_.edge(e.patch_a, e.edge_a)};
    if (e.patch_b && *e.patch_b != e.patch_a) result.patches.push_back(*e.patch_b);
    return result;
  }
};

} // namespace

void report_surfaces(const Arguments& files, const Report_demand& demand, Report_page& page) {
  const std::string name = files.size() == 1 ? input_name(files[0]) : input_name(files[0]) + ", ...";
  page.dimension = 3;
  const Model_surfaces surfaces(files, Model_surfaces::Units::any);
  const GC::Model_continuity<Exact> model =
      within_work_limit([&] { return name; }, [&] { return surfaces.continuity(GC::Crease_angles::enclosed); });
  Model_page gatherer(surfaces, model, GC::enclosure(demand.corner_threshold.degrees()), page);
  gatherer.gather();
  page.finish();
  page.model = gatherer.drawing(page.items());
  page.number_edges();
  std::ostringstream summary;
  summary << counted(surfaces.size(), "surface") << ": " << model.summary;
  page.summary = summary.str();
}
