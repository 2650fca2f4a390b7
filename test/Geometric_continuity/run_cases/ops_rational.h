// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "Kernels.h"
#include "Report.h"
#include "ops_bspline.h"
#include "ops_local.h"

template <class Traits>
GC::Rational_bezier_curve<Traits> rational_curve(const Case& c, const std::string& path,
                                                 const typename Traits::FT& h = typename Traits::FT(1)) {
  const Input<Traits> in{c};
  const auto points = in.points(path + "points");
  const auto weights = in.numbers(path + "weights");
  return {points.begin(), points.end(), weights.begin(), weights.end(), typename Traits::FT(0), h};
}

template <class Traits, class Curve> void report_rational(Report& report, const std::string& path, const Curve& curve) {
  report.construction(path + "points", [&] { return coordinate_rows<Traits>(curve); });
  report.construction(path + "weights",
                      [&] { return std::vector<typename Traits::FT>(curve.weights().begin(), curve.weights().end()); });
}

// Topic rational: Bezier and B-spline curves with weights.
template <class Traits> bool run_rational(const Case& c, Report& report) {
  typedef typename Traits::FT FT;
  const Input<Traits> in{c};
  if (c.op == "circular_arc") {
    if constexpr (GC::dimension_v<Traits> == 2) {
      const FT r = in.number("rot");
      report_rational<Traits>(
          report, "", GC::circular_arc<Traits>(in.point(in.numbers("center")), in.point(in.numbers("start")), r));
      return true;
    }
    return false;
  }
  if (c.op == "classify_join" && c.has("left.weights#")) {
    const GC::Rational_bezier_curve<Traits> left = rational_curve<Traits>(c, "left."),
                                            right = rational_curve<Traits>(c, "right.");
    const int order = c.integer("kmax");
    report_join(report, left.end_jet(3), right.start_jet(3), GC::continuity(left, right, order));
    return true;
  }
  if (!c.has("weights#")) return false;
  if (c.has("knots#")) {
    const Spline_input<Traits> spline(c);
    const GC::Bspline_curve<Traits> polygon = spline.curve();
    const std::vector<FT> weights = in.numbers("weights");
    const GC::Rational_bspline_curve<Traits> curve(polygon.begin(), polygon.end(), weights.begin(), weights.end(),
                                                   polygon.knots());
    const FT u = spline.parameter("u");
    if (c.op == "spline_jet") {
      report.construction("right", [&] { return spline.rows(curve.right_jet(u, c.integer("k"))); });
      report.construction("left", [&] { return spline.rows(curve.left_jet(u, c.integer("k"))); });
    } else if (c.op == "insert") {
      const GC::Rational_bspline_curve<Traits> finer = curve.insert(u);
      report.construction("degree", [&] { return finer.degree(); });
      report.construction("knots", [&] { return spline.unscaled(finer.knots()); });
      report_rational<Traits>(report, "", finer);
    } else
      return false;
    return true;
  }
  if (c.op == "eval_jet") {
    const FT h = in.number("interval_length");
    const GC::Rational_bezier_curve<Traits> curve = rational_curve<Traits>(c, "", h);
    report.construction("jet", [&] { return coordinate_rows(curve.jet(FT(in.number("t") * h), c.integer("k"))); });
  } else if (c.op == "split") {
    const GC::Rational_bezier_curve<Traits> curve = rational_curve<Traits>(c, "");
    const FT t = in.number("t");
    if (FT(0) < t && t < FT(1)) {
      const auto parts = curve.split(t);
      report_rational<Traits>(report, "left.", parts.first);
      report_rational<Traits>(report, "right.", parts.second);
    } else { // one part is the curve, the other one a point
      typedef GC::Rational_bezier_curve<Traits> Curve;
      std::vector<typename Curve::Homogeneous::Point> rows;
      for (const auto& p : curve.homogeneous()) rows.push_back(p);
      auto left = rows;
      GC::bernstein_split(rows, curve.degree(), t, left);
      report_rational<Traits>(report, "left.", Curve(typename Curve::Homogeneous(left)));
      report_rational<Traits>(report, "right.", Curve(typename Curve::Homogeneous(rows)));
    }
  } else if (c.op == "elevate")
    report_rational<Traits>(report, "", rational_curve<Traits>(c, "").elevate(c.integer("times")));
  else
    return false;
  return true;
}
