// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "Kernels.h"
#include "Report.h"

#include <algorithm>

template <class FT>
void report_signed_square(Report& report, const std::string& path, const std::optional<GC::Signed_square<FT>>& x) {
  if (!x)
    report.predicate(path, [] { return std::string("null"); });
  else {
    report.predicate(path + ".sign", [&] { return x->sign; });
    report.construction(path + ".square", [&] { return x->square; });
  }
}

// curvature and torsion where the jet and the dimension have them
template <class FT, int N> std::optional<FT> curvature_if_defined(const GC::Coordinate_jet<FT, N>& jet) {
  return jet.order() < 2 ? std::nullopt : GC::curvature_squared(jet);
}
template <class FT, int N> std::optional<FT> torsion_if_defined(const GC::Coordinate_jet<FT, N>& jet) {
  if constexpr (N == 0 || N == 3)
    if (jet.dimension() == 3 && jet.order() >= 3) return GC::torsion(jet);
  return std::nullopt;
}

// Topic invariants.
template <class Traits> bool run_invariants(const Case& c, Report& report) {
  typedef typename Traits::FT FT;
  const Input<Traits> in{c};
  if (c.op == "polygon_invariants") {
    const GC::Bezier_curve<Traits> curve = in.curve("P");
    report.construction("kappa_sq_start", [&] { return start_invariants(curve).curvature_squared; });
    report.construction("kappa_sq_end", [&] { return end_invariants(curve).curvature_squared; });
    report.construction("tau_start", [&] { return start_invariants(curve).torsion; });
    report.construction("tau_end", [&] { return end_invariants(curve).torsion; });
    return true;
  }
  if (c.op != "invariants") return false;
  const GC::Curve_jet<Traits> jet = in.jet("jet");
  const int n = jet.dimension();
  report.construction("kappa_sq", [&] { return GC::curvature_squared(jet); });
  report.construction("curvature_vector", [&]() -> std::optional<std::vector<FT>> {
    const std::optional<typename Traits::Vector> k = GC::curvature_vector(jet);
    if (!k) return std::nullopt;
    return coordinates<Traits>(*k);
  });
  if constexpr (GC::dimension_v<Traits> == 2) report_signed_square(report, "signed", GC::signed_curvature(jet));
  if (n == 3) report.construction("tau", [&] { return torsion_if_defined(jet); });
  if (jet.order() >= n) {
    const std::vector<std::optional<GC::Signed_square<FT>>> kappa = GC::frenet_curvatures(jet);
    report.predicate("frenet#", [&] { return static_cast<int>(kappa.size()); });
    for (std::size_t i = 0; i < kappa.size(); ++i)
      report_signed_square(report, "frenet." + std::to_string(i), kappa[i]);
  }
  return true;
}

// Reports the results of join() as decisions on the input or on what was computed from it.
template <class Function>
void report_orders(Report& report, Source source, const std::string& prefix, const Function& join) {
  report.add(prefix + "c_order", source, [&] { return join().c_order; });
  report.add(prefix + "g_order", source, [&] { return join().g_order; });
  report.add(prefix + "f_order", source, [&] { return join().f_order; });
  report.add(prefix + "betas", source, [&] { return join().betas(); });
  report.add(prefix + "curvature_equal", source, [&] { return join().curvature_equal; });
  report.add(prefix + "curvature_vector_equal", source, [&] { return join().curvature_vector_equal; });
  report.add(prefix + "torsion_equal", source, [&] { return join().torsion_equal; });
}

template <class Jet, class Join> void report_join(Report& report, const Jet& left, const Jet& right, const Join& join) {
  // the invariants of both sides are listed for a regular join only
  report.construction("kappa2_left", [&] { return join.regular ? curvature_if_defined(left) : std::nullopt; });
  report.construction("kappa2_right", [&] { return join.regular ? curvature_if_defined(right) : std::nullopt; });
  report.construction("tau_left", [&] { return join.regular ? torsion_if_defined(left) : std::nullopt; });
  report.construction("tau_right", [&] { return join.regular ? torsion_if_defined(right) : std::nullopt; });
  report.predicate("regular", [&] { return join.regular; });
  report.predicate("tangent_continuous", [&] { return join.tangent_equal; });
  report_orders(report, Source::predicate, "", [&] { return join; });
}

// Topic joins.
template <class Traits> bool run_joins(const Case& c, Report& report) {
  if (c.op != "classify_join") return false;
  const Input<Traits> in{c};
  const GC::Curve_jet<Traits> left = in.jet("left"), right = in.jet("right");
  report_join(report, left, right, GC::continuity(left, right, c.integer("kmax")));
  return true;
}
