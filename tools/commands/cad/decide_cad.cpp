// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/cad/decide_cad.h"

#include "commands/chains/ordered_batches.h"
#include "commands/tolerances.h"
#include "files/progress.h"
#include "formats/cad/read_cad.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

namespace {

// An edge on its way from the model to its verdict.
struct Edge_batch {
  std::size_t edge;
  Cad_verdict verdict;
};

} // namespace

Cad_demand demand_within(const std::string& tolerance, const GC::Kink_bound& kink) {
  const Tolerances tolerances = parse_tolerances(tolerance, false);
  if (tolerances.order > 2) throw std::invalid_argument("--within: of CAD models GAP,ANGLEdeg,CURVATURE% are compared");
  return {std::nullopt,    tolerances.order, tolerances.joins, tolerance, GC::in_radians(kink.degrees()),
          GC::Work_limit()};
}

Decided_cad_file decide_cad(const std::string& file, const Cad_demand& demand, const Cad_reading& reading) {
  Cad_reading with_order = reading;
  with_order.order = (std::max)(1, demand.most);
  Decided_cad_file result{file, read_cad(file, with_order), {}};
  const std::vector<Cad_edge>& edges = result.model.edges;
  Progress progress("edges");
  std::size_t next = 0;
  const auto read = [&](Edge_batch& batch) {
    batch.edge = next++;
    return batch.edge < edges.size();
  };
  const auto work = [&](Edge_batch& batch) { batch.verdict = cad_verdict(edges[batch.edge], demand); };
  const auto take = [&](Edge_batch& batch) {
    result.verdicts.push_back(std::move(batch.verdict));
    const std::size_t done = result.verdicts.size();
    progress.step(done, [&] { return double(done) / double(edges.size()); });
  };
  for_batches<Edge_batch>(read, work, take);
  return result;
}

void Cad_summary::add(const Decided_cad_file& file) {
  faces += file.model.faces.size();
  lost += file.model.lost.size();
  sewn += file.model.sewn;
  for (std::size_t i = 0; i < file.verdicts.size(); ++i) {
    const Cad_edge& edge = file.model.edges[i];
    const Cad_verdict& verdict = file.verdicts[i];
    switch (edge.kind) {
    case Cad_edge_kind::inner: ++inner; break;
    case Cad_edge_kind::seam: ++seams; break;
    case Cad_edge_kind::boundary: ++boundary; continue;
    case Cad_edge_kind::non_manifold: ++non_manifold; continue;
    case Cad_edge_kind::degenerate:
      ++degenerate;
      no_points += is_no_point(edge, verdict);
      continue;
    case Cad_edge_kind::knot_line: ++knot_lines; break;
    }
    const int order = verdict.order();
    ++(order == 2                                  ? g2
       : order == 1                                ? g1
       : order == 0                                ? g0
       : verdict.within[0] == GC::Verdict::refuted ? gaps
                                                   : undecided);
    kinks += verdict.shape == Cad_shape::kink;
    corners += verdict.shape == Cad_shape::corner;
    fading_corners += verdict.shape == Cad_shape::fading_corner;
    exact += verdict.exact.has_value();
    bent += verdict.shape == Cad_shape::bent;
    folds += verdict.shape == Cad_shape::fold;
    inside_out += verdict.shape == Cad_shape::inside_out;
    not_compared += !verdict.enclosure;
    projected += edge.projected;
  }
}
