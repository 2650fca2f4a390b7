// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "cad/Cad_words.h"
#include "cad/decide_cad.h"
#include "chains/join_report.h"
#include "reports/report_inputs.h"
#include "tolerances.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

Report_grade grade(const Cad_verdict& verdict) {
  switch (verdict.shape) {
  case Cad_shape::gap: return Report_grade::gap;
  case Cad_shape::kink: return Report_grade::kink;
  case Cad_shape::corner: return Report_grade::corner;
  case Cad_shape::smooth: return verdict.order() == 2 ? Report_grade::g2 : Report_grade::g1;
  case Cad_shape::undecided: break;
  }
  return Report_grade::undecided;
}

// The edge as a card of the page, without what is drawn.
Report_item item_of(std::size_t number, const Cad_edge& edge, const Cad_verdict& verdict, const Cad_model& model) {
  Report_item item;
  item.place = cad_place(number, edge, model) + ' ' + cad_kind(edge);
  item.verdict = verdict.enclosure ? cad_order(verdict) : verdict.reason;
  item.grade = grade(verdict);
  if (!verdict.enclosure) return item;
  const GC::Edge_enclosure& e = *verdict.enclosure;
  item.gap = e.gap.value;
  if (e.angle) item.angle = GC::in_degrees(e.angle->value);
  if (e.curvature_jump) item.curvature_jump = GC::in_percent(e.curvature_jump->value);
  const GC::Edge_maximum& worst = item.grade == Report_grade::gap || !e.angle ? e.gap : *e.angle;
  for (const double x : worst.point) item.point.push_back(rounded(x, 6));
  item.severity = &worst == &e.gap ? worst.value.lower : item.angle->lower;
  return item;
}

Report_model::Edge drawn(const Cad_edge& edge, const std::string& grade, std::size_t first_face) {
  Report_model::Edge result{grade, {}, {}};
  for (const std::size_t face : edge.faces) result.patches.push_back(first_face + face);
  for (const GC::Given_point<3>& p : edge.points) result.points.insert(result.points.end(), p.begin(), p.end());
  return result;
}

} // namespace

void report_cad(const Arguments& files, const Report_demand& demand, Report_page& page) {
  Cad_demand asked;
  asked.tolerance = default_cad_tolerance;
  asked.bounds = parse_tolerances(asked.tolerance, false).joins;
  asked.kink = GC::in_radians(demand.kink_bound.degrees());
  page.dimension = 3;
  Cad_summary summary;
  Report_model& model = page.model.emplace();
  std::vector<Report_model::Edge> edges; // of all items
  for (const std::string& file : files) {
    Decided_cad_file decided = decide_cad(file, asked);
    summary.add(decided, asked);
    const std::size_t first_face = model.patches.size();
    model.patches.resize(first_face + decided.model.faces.size(), {0, 0, {}}); // faces are not drawn
    for (const std::string& lost : decided.model.lost) page.notes.push_back(file + ": not read: " + lost);
    for (std::size_t i = 0; i < decided.verdicts.size(); ++i) {
      const Cad_edge& edge = decided.model.edges[i];
      if (edge.kind != Cad_edge_kind::inner && edge.kind != Cad_edge_kind::seam) {
        if (edge.kind != Cad_edge_kind::degenerate) model.edges.push_back(drawn(edge, "boundary", first_face));
        continue;
      }
      Report_item item = item_of(i, edge, decided.verdicts[i], decided.model);
      if (files.size() > 1) item.place = file + ": " + item.place;
      if (!page.count(item.grade, item.severity)) continue;
      item.number = page.total();
      item.edge = edges.size();
      edges.push_back(drawn(edge, report_grade_name(item.grade), first_face));
      page.add(std::move(item));
    }
  }
  page.finish();
  std::vector<Report_model::Edge> shown; // those of the items come first
  for (const Report_item& item : page.items()) shown.push_back(std::move(edges[item.edge]));
  model.edges.insert(model.edges.begin(), shown.begin(), shown.end());
  page.number_edges();
  page.summary = counted(summary.faces, "face") + ", " + counted(summary.decided(), "edge") + " of two sides within " +
                 asked.tolerance + ", lengths in mm; faces are not drawn";
}
