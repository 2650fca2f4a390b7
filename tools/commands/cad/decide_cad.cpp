// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/cad/decide_cad.h"

#include "commands/chains/ordered_batches.h"
#include "commands/tolerances.h"
#include "files/progress.h"
#include "formats/cad/read_cad.h"

#include <algorithm>
#include <future>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

namespace {

// An edge on its way from the model to its verdict.
struct Edge_batch {
  std::size_t edge;
  Cad_verdict verdict;
};

// Returns the data that decide an edge, apart from the place of its part: curves and surfaces that
// are shared are the same.
std::string key_of(const Cad_edge& edge) {
  std::string key;
  const auto add = [&](const auto& x) { key.append(reinterpret_cast<const char*>(&x), sizeof x); };
  add(edge.kind);
  add(edge.inside_out);
  add(edge.projections);
  add(edge.begin);
  add(edge.end);
  for (const GC::Edge_side& side : *edge.sides) {
    add(side.surface.get());
    add(side.curve.get());
    add(side.placement);
    add(side.reversed);
    add(side.face_side);
  }
  if (edge.space) {
    add(edge.space->curve.get());
    add(edge.space->placement);
  }
  return key;
}

// For each edge the first one that has the same verdict.
std::vector<std::size_t> equal_edges(const std::vector<Cad_edge>& edges) {
  std::vector<std::size_t> result;
  std::map<std::string, std::size_t> known;
  for (std::size_t i = 0; i < edges.size(); ++i)
    result.push_back(edges[i].sides ? known.emplace(key_of(edges[i]), i).first->second : i);
  return result;
}

// Moves the points of a verdict from the part to where it is placed.
void move(Cad_verdict& verdict, const GC::Cad_placement& place) {
  const auto move_point = [&](GC::Edge_maximum& x) {
    const GC::Cad_point<3> p = x.point;
    for (std::size_t i = 0; i < 3; ++i)
      x.point[i] = place[i][0] * p[0] + place[i][1] * p[1] + place[i][2] * p[2] + place[i][3];
  };
  if (verdict.deviation) move_point(*verdict.deviation);
  if (!verdict.enclosure) return;
  move_point(verdict.enclosure->gap);
  if (verdict.enclosure->angle) move_point(*verdict.enclosure->angle);
  if (verdict.enclosure->curvature_jump) move_point(*verdict.enclosure->curvature_jump);
}

Decided_cad_file decided(const std::string& file, Cad_model model, const Cad_demand& demand) {
  Decided_cad_file result{file, std::move(model), {}, {}, {}, 0};
  const std::vector<Cad_edge>& edges = result.model.edges;
  Progress progress("edges");
  const std::vector<std::size_t> first = equal_edges(edges);
  std::size_t next = 0;
  const auto read = [&](Edge_batch& batch) {
    batch.edge = next++;
    return batch.edge < edges.size();
  };
  const auto work = [&](Edge_batch& batch) {
    if (first[batch.edge] == batch.edge) batch.verdict = cad_verdict(edges[batch.edge], demand);
  };
  const auto take = [&](Edge_batch& batch) {
    const std::size_t same = first[batch.edge];
    result.verdicts.push_back(same == batch.edge ? std::move(batch.verdict) : result.verdicts[same]);
    const std::size_t done = result.verdicts.size();
    progress.step(done, [&] { return double(done) / double(edges.size()); });
  };
  for_batches<Edge_batch>(read, work, take);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    move(result.verdicts[i], edges[i].place);
    result.compared += edges[i].sides && first[i] == i;
  }
  for (const Cad_join& join : result.model.wires.joins) result.joins.push_back(cad_verdict(join, demand));
  const std::vector<Cad_curve_edge>& curves = result.model.wires.curves;
  for (std::size_t i = 0; demand.curvature && i < curves.size(); ++i)
    if (curves[i].space) result.bends.emplace_back(i, cad_bend(curves[i], *demand.curvature));
  return result;
}

} // namespace

void decide_cad_files(const Arguments& files, const Cad_demand& demand, const Cad_reading& reading,
                      const std::function<void(const Decided_cad_file&)>& take) {
  Cad_reading with_order = reading;
  with_order.order = (std::max)(1, demand.most);
  with_order.gap = demand.bounds.gap.lower();
  std::future<Cad_model> next;
  const auto read = [&](std::size_t i) {
    if (i < files.size()) next = std::async(std::launch::async, read_cad, files[i], with_order);
  };
  read(0);
  for (std::size_t i = 0; i < files.size(); ++i) {
    Cad_model model = next.get();
    read(i + 1);
    take(decided(files[i], std::move(model), demand));
  }
}

std::string Cad_summary::hint() const {
  if (boundary > 0) return "--sew DISTANCE joins boundary edges that coincide";
  return curves > 0 ? "the ends of its curves are free: no two of them meet" : "";
}

void Cad_summary::add(Claim claim, int order, Cad_shape shape) {
  ++(claim == Claim::not_covered ? not_compared
     : claim == Claim::undecided ? undecided
     : order == 2                ? g2
     : order == 1                ? g1
     : order == 0                ? g0
                                 : gaps);
  kinks += shape == Cad_shape::kink;
  corners += shape == Cad_shape::corner;
  fading_corners += shape == Cad_shape::fading_corner;
  bent += shape == Cad_shape::bent;
  folds += shape == Cad_shape::fold;
  inside_out += shape == Cad_shape::inside_out;
}

void Cad_summary::add(const Decided_cad_file& file, const Cad_demand& demand) {
  faces += file.model.faces.size();
  lost += file.model.lost.size();
  open_shells += file.model.open_shells.size();
  const Cad_wires& wires = file.model.wires;
  curves += wires.curves.size();
  joins += wires.joins.size();
  free_ends += wires.free_ends.size();
  branchings += wires.branchings.size();
  sewn += file.model.sewn;
  instances += file.model.instances.size();
  shapes += file.model.shapes;
  compared += file.compared;
  for (std::size_t i = 0; i < file.verdicts.size(); ++i) {
    const Cad_edge& edge = file.model.edges[i];
    const Cad_verdict& verdict = file.verdicts[i];
    switch (edge.kind) {
    case Cad_edge_kind::inner: ++inner; break;
    case Cad_edge_kind::seam: ++seams; break;
    case Cad_edge_kind::boundary:
      ++boundary;
      beside += !edge.reason.empty();
      continue;
    case Cad_edge_kind::non_manifold: ++non_manifold; continue;
    case Cad_edge_kind::degenerate:
      ++degenerate;
      no_points += is_no_point(edge, verdict);
      continue;
    case Cad_edge_kind::knot_line: ++knot_lines; break;
    }
    add(claim_of(edge, verdict, demand)->claim, verdict.order(), verdict.shape);
    exact += verdict.exact.has_value();
    projected += edge.projected;
  }
  for (const Cad_join_verdict& verdict : file.joins)
    add(claim_of(verdict, demand).claim, verdict.order(), verdict.shape);
}
