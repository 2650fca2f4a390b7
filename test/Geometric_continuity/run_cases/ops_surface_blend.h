// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "Kernels.h"
#include "Report.h"

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>

#include <algorithm>
#include <type_traits>

template <class Traits> GC::Bezier_patch<Traits> patch_of(const Case& c, const std::string& path) {
  std::vector<std::vector<typename Traits::Point>> net;
  for (int i = 0; i < c.length(path); ++i) net.push_back(Input<Traits>{c}.points(path + '.' + std::to_string(i)));
  return GC::Bezier_patch<Traits>(net);
}

template <class FT> GC::Edge_reparametrisation<FT> reparametrisation_of(const Case& c, const std::string& path) {
  const auto function = [&](const char* name) {
    std::vector<FT> b;
    for (const Exact_rational& x : c.numbers(path + '.' + name)) b.push_back(from_rational<FT>(x));
    return GC::Bernstein_polynomial<FT>(b);
  };
  return {function("alpha"), function("beta"), function("alpha2"), function("delta")};
}

// Coefficients in another degree: raised, or lowered if they are those of a polynomial of that
// degree.
template <class FT> GC::Bernstein_polynomial<FT> in_degree(const GC::Bernstein_polynomial<FT>& p, int degree) {
  GC::Bernstein_polynomial<FT> q = p.elevated((std::max)(degree - p.degree(), 0));
  if constexpr (!std::is_floating_point_v<FT> && !std::is_same_v<FT, CGAL::Interval_nt<>>)
    while (degree < q.degree()) {
      const int n = q.degree(); // n q_i = i r_{i-1} + (n - i) r_i
      std::vector<FT> r(1, q[0]);
      for (int i = 1; i < n; ++i) r.push_back(FT((FT(n) * q[i] - FT(i) * r.back()) / FT(n - i)));
      const GC::Bernstein_polynomial<FT> lower(r);
      if (lower.elevated() != q) return p;
      q = lower;
    }
  return q;
}

// Topic surface_blend: from the edge v = 1 of one patch to the edge v = 0 of another. Nets are
// equal when they are after elevation along u to a common degree: the computed one is given in the
// degree of the expected one.
template <class Traits> bool run_surface_blend(const Case& c, Report& report) {
  typedef typename Traits::FT FT;
  if (c.op != "surface_blend") return false;
  constexpr GC::Patch_edge v0 = GC::Patch_edge::v0, v1 = GC::Patch_edge::v1;
  const GC::Bezier_patch<Traits> left = patch_of<Traits>(c, "left"), right = patch_of<Traits>(c, "right"),
                                 s = GC::blend(
                                     left, v1, right, v0,
                                     {reparametrisation_of<FT>(c, "start"), reparametrisation_of<FT>(c, "end")});
  report.construction("net", [&] {
    const auto expected = c.out.find("net#");
    const int degree = expected == c.out.end() ? s.degree_u() : std::stoi(expected->second) - 1;
    std::vector<std::vector<std::vector<FT>>> net;
    for (int j = 0; j <= s.degree_v(); ++j)
      for (int x = 0; x < s.dimension(); ++x) {
        std::vector<FT> b;
        for (int i = 0; i <= s.degree_u(); ++i) b.push_back(s.coordinates(i, j)[x]);
        const GC::Bernstein_polynomial<FT> row = in_degree(GC::Bernstein_polynomial<FT>(b), degree);
        net.resize(row.degree() + 1, std::vector<std::vector<FT>>(s.degree_v() + 1));
        for (int i = 0; i <= row.degree(); ++i) net[i][j].push_back(row[i]);
      }
    return net;
  });
  if constexpr (GC::dimension_v<Traits> == 3) {
    report.consequence("g2_start", [&] { return edge_continuity(left, v1, s, v0).g_order >= 2; });
    report.consequence("g2_end", [&] { return edge_continuity(s, v1, right, v0).g_order >= 2; });
  }
  return true;
}
