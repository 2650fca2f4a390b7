// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/drawings/segment_curvature.h"

#include "commands/chains/plane_curvature.h"

#include <CGAL/Geometric_continuity/curves/Path_segment.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Sqrt_extension.h>

#include <utility>

bool decide_curvature(const GC::Svg_segment<Drawing_traits>& segment, const Curvature_bound& bound,
                      std::optional<GC::Curvature_excess>& excess) {
  if (segment.bezier()) {
    excess = curvature_excess(*segment.bezier(), bound);
    return true;
  }
  const GC::Elliptical_arc<Drawing_traits>& arc = *segment.arc();
  if (const auto curve = arc.curve()) {
    excess = GC::curvature_excess(*curve, bound.curvature);
    return true;
  }
  if (!arc.is_known()) return false;
  // a circle: the derivatives with respect to the angle are perpendicular, and of one length
  typedef CGAL::Sqrt_extension<Exact, Exact> Root;
  const auto jet = arc.start_jet_over<Root>(2, Root(Exact(0), Exact(1), arc.radicand()));
  const Root square = dot(jet[1], jet[1]);
  if (dot(jet[2], jet[2]) != square || dot(jet[1], jet[2]) != Root(0)) return false;
  if (Root(bound.curvature * bound.curvature) * square < Root(1)) {
    const std::pair<double, double> r = CGAL::to_interval(square);
    const auto over_root = [](double x) { return GC::sqrt_enclosure(Exact(Exact(1) / Exact(x))); };
    excess = GC::Curvature_excess{{{0, 1}, {over_root(r.second).lower, over_root(r.first).upper}}, 0, false};
  }
  return true;
}
