// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "Kernels.h"
#include "Report.h"

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>

// Patches of a case. Rounded kernels take all coordinates times a common denominator: whole
// numbers, which they represent without rounding. This changes the determinant by the third power
// of the scale, and no decision.
template <class Traits> struct Patch_input {
  typedef typename Traits::FT FT;

  const Case& c;
  Exact_rational scale = Exact_rational(1);

  explicit Patch_input(const Case& c) : c(c) {
    if constexpr (std::is_floating_point_v<FT> || std::is_same_v<FT, CGAL::Interval_nt<>>)
      for (const auto& [path, value] : c.in)
        if (path.back() != '#') scale *= denominator(Exact_rational(c.number(path) * scale));
  }

  GC::Bezier_patch<Traits> patch(const std::string& path) const {
    std::vector<std::vector<typename Traits::Point>> net;
    for (int i = 0; i < c.length(path); ++i) {
      net.emplace_back();
      for (std::vector<Exact_rational> row : c.rows(path + '.' + std::to_string(i))) {
        for (Exact_rational& x : row) x *= scale;
        net.back().push_back(Input<Traits>::point(Input<Traits>::convert(row)));
      }
    }
    return GC::Bezier_patch<Traits>(net);
  }
};

// Topic edges: two patches with the common edge v = 0.
template <class Traits> bool run_edges(const Case& c, Report& report) {
  if constexpr (GC::dimension_v<Traits> == 3) {
    if (c.op != "edge") return false;
    typedef typename Traits::FT FT;
    typedef GC::Edge_field<Traits> Field;
    const Patch_input<Traits> in(c);
    const GC::Bezier_patch<Traits> a = in.patch("net1"), b = in.patch("net2");
    constexpr GC::Patch_edge v0 = GC::Patch_edge::v0;
    report.construction("det", [&] {
      const GC::Edge_conditions<FT> rounded(GC::edge_rows_over<FT>(a, v0), GC::edge_rows_over<FT>(b, v0));
      const Exact_rational cube = in.scale * in.scale * in.scale;
      const GC::Bernstein_polynomial<Field> scaled = rounded.determinant();
      std::vector<Field> det;
      for (const Field& x : scaled.coefficients()) det.push_back(Field(x / from_rational<Field>(cube)));
      return det;
    });
    const GC::Edge_conditions<Field> conditions(GC::edge_rows(a, v0), GC::edge_rows(b, v0));
    report.predicate("coplanar", [&] { return conditions.coplanar(); });
    report.predicate("side", [&] { return to_string(conditions.side_pattern()); });
    report.predicate("g2_identity", [&] { return conditions.second_order(); });
    report.predicate("g1", [&] { return edge_continuity(a, v0, b, v0).g_order >= 1; });
    report.predicate("g2", [&] { return edge_continuity(a, v0, b, v0).g_order >= 2; });
    return true;
  } else
    return false;
}
