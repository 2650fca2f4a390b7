// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// A box without a lid: all its edges are rounded, and what is left open is named.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/models/round_edges.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational FT;
typedef GC::Traits_3<CGAL::Simple_cartesian<FT>> Traits;
typedef Traits::Point Point;
typedef GC::Bezier_patch<Traits> Patch;

int main() {
  const Point a(0, 0, 0), b(12, 0, 0), c(12, 8, 0), d(0, 8, 0); // the bottom
  const auto wall = [](const Point& p, const Point& q) {
    return Patch({{p, Point(p.x(), p.y(), 6)}, {q, Point(q.x(), q.y(), 6)}});
  };
  const std::vector<Patch> box = {Patch({{a, d}, {b, c}}), wall(a, b), wall(b, c), wall(c, d), wall(d, a)};
  std::cout << "before: " << GC::model_continuity(box) << '\n';

  const GC::Rounded_model<Patch> rounded = GC::round_edges(box, {1});
  for (const auto& corner : rounded.corners)
    std::cout << "a hole at (" << corner.point << "), where " << corner.blends.size() << " blends end\n";

  std::vector<Patch> all = rounded.surfaces;
  for (const auto& blend : rounded.blends) all.push_back(blend.surface);
  const auto model = GC::model_continuity(all);
  std::cout << "after: " << model << '\n';
  return rounded.is_g2() && model.summary.g2 == 16 && rounded.corners.size() == 4 ? 0 : 1;
}
