// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "Kernels.h"
#include "Report.h"
#include "ops_local.h"

#include <CGAL/Geometric_continuity/extensions/alternatives.h>
#include <CGAL/Geometric_continuity/extensions/extend.h>

// Topic hagen, the operations on scalars.
template <class FT> bool run_connection_scalars(const Case& c, Report& report) {
  const auto number = [&](const char* path) { return from_rational<FT>(c.number(path)); };
  if (c.op == "ck_choice") {
    const GC::Alternative_parameters<FT> ck = GC::ck_parameters<FT>(number("beta"));
    report.construction("C0", [&] { return ck.c0; });
    report.construction("C1", [&] { return ck.c1; });
    report.construction("C2", [&] { return ck.c2; });
  } else if (c.op == "g3_choice")
    report.construction("C2", [&] { return GC::g3_c2<FT>(c.integer("m"), number("beta"), number("C0")); });
  else
    return false;
  return true;
}

// The points behind the end of a polygon that the scalars C choose, and the join with the whole
// next segment.
template <class Traits> void run_next_points(const Input<Traits>& in, Report& report) {
  typedef typename Traits::FT FT;
  const GC::Bezier_curve<Traits> left = in.curve("left");
  const FT beta = in.number("beta");
  const std::vector<FT> C = in.numbers("C");
  const int k = C.empty() ? 1 : C.size() == 1 ? 2 : 3;

  std::vector<typename Traits::Point> next{GC::tangent_alternative(left, beta).point()};
  GC::Extension_parameters<FT> parameters;
  parameters.beta = beta;
  if (k >= 2) {
    parameters.c0 = C[0];
    next.push_back(GC::curvature_alternatives(left, beta).point_at(C[0]));
  }
  if (k == 3) {
    parameters.c1 = C.at(1);
    parameters.c2 = C.at(2);
    const GC::Torsion_alternatives<Traits> plane = GC::torsion_alternatives(left, C[0], beta);
    next.push_back(plane.point_at({C[1], C[2]}));
    const GC::Connection_coefficients<FT> connection = plane.connection({C[1], C[2]});
    report.construction("connection.beta1", [&] { return connection.beta1; });
    report.construction("connection.beta2", [&] { return connection.beta2; });
    report.construction("connection.mu", [&] { return connection.mu; });
    report.construction("connection.delta", [&] { return connection.delta; });
  }
  report.construction("next", [&] { return coordinate_rows<Traits>(next); });

  // on unit intervals, as far as the chosen points determine the derivatives
  const GC::Bezier_curve<Traits> right =
      GC::extend(left, static_cast<GC::Frenet_order>(k), parameters).with_domain(FT(0), FT(1));
  report.predicate("join_note", [] { return std::string("on unit parameter intervals"); });
  report_orders(report, Source::consequence, "join.",
                [&] { return GC::continuity(left.end_jet(k), right.start_jet(k)); });
}

// Topic hagen, the operations on points.
template <class Traits> bool run_hagen(const Case& c, Report& report) {
  typedef typename Traits::FT FT;
  const Input<Traits> in{c};
  if (c.op == "next_points")
    run_next_points(in, report);
  else if (c.op == "midpoint") {
    const auto point = [&](const char* path) { return in.point(in.numbers(path)); };
    const GC::Midpoint_construction<Traits> m =
        GC::midpoint_construction<Traits>(point("b_2"), point("b_1"), point("b0"));
    const FT c0 = in.number("C0");
    report.construction("b1", [&] { return coordinates<Traits>(m.b1); });
    report.construction("d0", [&] { return coordinates<Traits>(m.d0); });
    report.construction("b2_tilde", [&] { return coordinates<Traits>(m.b2_tilde); });
    report.construction("b2_bar", [&] { return coordinates<Traits>(m.b2_bar); });
    report.construction("b2", [&] { return coordinates<Traits>(m.b2(c0)); });
  } else
    return false;
  return true;
}
