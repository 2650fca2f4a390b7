// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "Kernels.h"
#include "Report.h"
#include "ops_local.h"

#include <CGAL/Geometric_continuity/extensions/alternatives.h>

#include <algorithm>

template <class Join> void report_errata_join(Report& report, const std::string& prefix, const Join& join) {
  report_orders(report, Source::predicate, prefix, [&] { return join; });
}

// Topic errata: the printed formulas and the corrected ones.
template <class Traits> bool run_errata(const Case& c, Report& report) {
  typedef typename Traits::FT FT;
  typedef GC::Coordinates<Traits> Coordinates;
  typedef GC::Bezier_curve<Traits> Curve;
  const Input<Traits> in{c};

  if (c.op == "hagen_3_2_3") {
    const Curve left = in.curve("left");
    const int m = left.degree();
    const std::vector<FT> C = in.numbers("C");
    const Coordinates b_1 = left.coordinates(m - 1), p = left.coordinates(m) - b_1, r = left.coordinates(m - 2) - b_1;
    const typename Traits::Point printed = GC::to_point<Traits>(C.at(1) * p + C.at(2) * r),
                                 correct = GC::torsion_alternatives(left, C.at(0)).point_at({C.at(1), C.at(2)});
    const auto right = [&](const typename Traits::Point& b3) {
      std::vector<typename Traits::Point> points{left.control_point(m), GC::tangent_alternative(left).point(),
                                                 GC::curvature_alternatives(left).point_at(C.at(0)), b3};
      points.resize(m + 1, points.back()); // a jet of order 3 reads four points only
      return Curve(points.begin(), points.end());
    };
    report.construction("printed_b3", [&] { return coordinates<Traits>(printed); });
    report.construction("correct_b3", [&] { return coordinates<Traits>(correct); });
    report_errata_join(report, "printed.", GC::continuity(left, right(printed)));
    report_errata_join(report, "correct.", GC::continuity(left, right(correct)));
  } else if (c.op == "convex_hull_outside_interval")
    report.construction("point", [&] { return coordinates<Traits>(in.curve("P")(in.number("t"))); });
  else if (c.op == "double_point_distance") {
    const Curve curve = in.curve("P");
    const int i = c.integer("index");
    const FT t = in.number("t");
    const auto squared_distance = [&](const Curve& moved) {
      const Coordinates d = moved.jet(t, 0)[0] - curve.coordinates(i);
      return dot(d, d);
    };
    report.construction("before", [&] { return squared_distance(curve); });
    report.construction("after", [&] { return squared_distance(GC::repeat_control_point(curve, i)); });
  } else if (c.has("left#") && c.has("right#")) {
    const Curve left = in.curve("left"), right = in.curve("right");
    // the jets of the document end there
    const int order = std::min({3, left.degree(), right.degree()});
    report_errata_join(report, "", GC::continuity(left.end_jet(order), right.start_jet(order)));
  } else if (c.has("phi_jet#") && c.has("points#"))
    report_errata_join(report, "", GC::continuity(in.jet("phi_jet"), in.curve("points").start_jet(2)));
  else if (c.has("psi_jet#") && c.has("points#"))
    report_errata_join(report, "", GC::continuity(in.curve("points").end_jet(2), in.jet("psi_jet")));
  else
    return false;
  return true;
}
