// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "Kernels.h"
#include "Report.h"

// Topic bezier: operations on curves and on Bernstein polynomials.
template <class Traits> bool run_bezier(const Case& c, Report& report) {
  typedef typename Traits::FT FT;
  typedef GC::Bezier_curve<Traits> Curve;
  const Input<Traits> in{c};

  if (c.op == "eval_jet") {
    const FT h = in.number("interval_length");
    const GC::Curve_jet<Traits> jet = in.curve("P", FT(0), h).jet(FT(in.number("t") * h), c.integer("k"));
    report.construction("jet", [&] { return coordinate_rows(jet); });
  } else if (c.op == "split") {
    // at the ends of the domain only the polynomials of the coordinates can be split
    const Curve curve = in.curve("P");
    const FT t = in.number("t");
    std::vector<std::vector<FT>> left(curve.degree() + 1), right = left;
    for (int i = 0; i < curve.dimension(); ++i) {
      const auto parts = curve.coordinate_polynomial(i).split(t);
      for (int j = 0; j <= curve.degree(); ++j) {
        left[j].push_back(parts.first[j]);
        right[j].push_back(parts.second[j]);
      }
    }
    const bool inside = FT(0) < t && t < FT(1);
    report.construction("left", [&] { return inside ? coordinate_rows<Traits>(curve.split(t).first) : left; });
    report.construction("right", [&] { return inside ? coordinate_rows<Traits>(curve.split(t).second) : right; });
  } else if (c.op == "elevate")
    report.construction("P", [&] { return coordinate_rows<Traits>(in.curve("P").elevate(c.integer("times"))); });
  else if (c.op == "energy")
    report.construction("energy", [&] { return in.curve("P").energy(c.integer("k")); });
  else if (c.op == "points_from_jet") {
    const GC::Curve_jet<Traits> jet = in.jet("jet");
    const int m = c.integer("degree");
    const FT h = in.number("interval_length");
    report.construction("start", [&] { return coordinate_rows<Traits>(GC::start_control_points(jet, m, h)); });
    report.construction("end", [&] { return coordinate_rows<Traits>(GC::end_control_points(jet, m, h)); });
  } else if (c.op == "double_point") {
    const int i = c.integer("index");
    const FT t = in.number("t");
    const Curve before = in.curve("P"), after = GC::repeat_control_point(before, i);
    report.construction("P", [&] { return coordinate_rows<Traits>(after); });
    report.construction("point", [&] { return coordinates<Traits>(after(t)); });
    report.construction("weight_before", [&] { return GC::bernstein_basis(before.degree(), t)[i]; });
    report.construction("weight_after", [&] {
      const std::vector<FT> b = GC::bernstein_basis(after.degree(), t);
      return FT(b[i] + b[i + 1]);
    });
  } else if (c.op == "closed_tangent")
    report.predicate("class", [&] { return to_string(GC::closing(in.curve("P"))); });
  else
    return false;
  return true;
}

// The operations of the topic that have no dimension.
template <class FT> bool run_bernstein(const Case& c, Report& report) {
  const auto polynomial = [&](const std::string& path) {
    std::vector<FT> coefficients;
    for (const Exact_rational& x : c.numbers(path)) coefficients.push_back(from_rational<FT>(x));
    return GC::Bernstein_polynomial<FT>(coefficients);
  };
  if (c.op == "bernstein_product")
    report.construction("c", [&] { return (polynomial("a") * polynomial("b")).coefficients(); });
  else if (c.op == "sign_pattern")
    report.predicate("pattern", [&] { return to_string(GC::sign_pattern(polynomial("bernstein"))); });
  else
    return false;
  return true;
}
