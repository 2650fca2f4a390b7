// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "Kernels.h"
#include "Report.h"

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Simple_cartesian.h>

// Rational patches of a case. Rounded kernels take all coordinates times a common denominator, and
// all weights times another one, which changes no decision; cases that are no whole numbers of 53
// bits then are left out.
template <class Traits> class Rational_patch_input {
  typedef typename Traits::FT FT;

  const Case& c;
  Exact_rational point_scale_ = Exact_rational(1), weight_scale_ = Exact_rational(1);

public:
  bool representable = true;

  explicit Rational_patch_input(const Case& c) : c(c) {
    if constexpr (std::is_floating_point_v<FT>) {
      for_each_number(
          [&](const Exact_rational& x, Exact_rational& scale) { scale *= denominator(Exact_rational(x * scale)); });
      for_each_number([&](const Exact_rational& x, const Exact_rational& scale) {
        const Exact_rational scaled = x * scale;
        representable = representable && Exact_rational(CGAL::to_double(scaled)) == scaled;
      });
    }
  }

  GC::Rational_bezier_patch<Traits> patch(const std::string& path) const {
    std::vector<std::vector<typename Traits::Point>> net;
    std::vector<std::vector<FT>> weights;
    for (int i = 0; i < c.length(path + ".points"); ++i) {
      const std::string row = '.' + std::to_string(i);
      net.emplace_back();
      for (const std::vector<Exact_rational>& x : c.rows(path + ".points" + row))
        net.back().push_back(Input<Traits>::point(Input<Traits>::convert(times(point_scale_, x))));
      weights.push_back(Input<Traits>::convert(times(weight_scale_, c.numbers(path + ".weights" + row))));
    }
    try {
      return GC::Rational_bezier_patch<Traits>(net, weights);
    } catch (const GC::Error& e) {
      if (e.code() != GC::Error_code::zero_weight) throw;
      return part_next_to_edge(net, weights);
    }
  }

private:
  // Takes a net whose denominator is positive near the edge only.
  template <class Points, class Weights>
  static GC::Rational_bezier_patch<Traits> part_next_to_edge(const Points& net, const Weights& weights) {
    typedef GC::Rational_bezier_patch<Traits> Patch;
    std::vector<std::vector<typename GC::Homogeneous_traits<Traits>::Point>> points(net.size());
    for (std::size_t i = 0; i < net.size(); ++i)
      for (std::size_t j = 0; j < net[i].size(); ++j)
        points[i].push_back(GC::homogeneous_point(GC::coordinates<Traits>(net[i][j]), weights[i][j]));
    const FT part = FT(FT(1) / FT(1024));
    return Patch(typename Patch::Homogeneous(points).split_v(part).first);
  }

  static std::vector<Exact_rational> times(const Exact_rational& scale, std::vector<Exact_rational> x) {
    for (Exact_rational& y : x) y *= scale;
    return x;
  }
  template <class Function> void for_each_number(Function f) {
    for (const auto& [path, value] : c.in)
      if (path.back() != '#')
        f(c.number(path), path.find("weights") == std::string::npos ? point_scale_ : weight_scale_);
  }
};

// Topic rational_edges: two rational patches with the common edge v = 0. Decisions are exact on
// doubles, too; therefore an interval kernel, which would enclose whole numbers, decides as doubles
// do.
template <class Traits> bool run_rational_edges(const Case& c, Report& report) {
  if constexpr (std::is_same_v<typename Traits::FT, CGAL::Interval_nt<>>)
    return run_rational_edges<GC::Traits_3<CGAL::Simple_cartesian<double>>>(c, report);
  else if constexpr (GC::dimension_v<Traits> == 3) {
    if (c.op != "edge" || !c.has("net1.weights#")) return false;
    const Rational_patch_input<Traits> in(c);
    if (!in.representable) return true;
    const GC::Rational_bezier_patch<Traits> a = in.patch("net1"), b = in.patch("net2");
    constexpr GC::Patch_edge v0 = GC::Patch_edge::v0;
    const auto edge = edge_continuity(a, v0, b, v0);
    report.predicate("coplanar", [&] { return edge.coplanar; });
    report.predicate("side", [&] { return to_string(edge.side); });
    report.predicate("g1", [&] { return is_g1_edge(a, v0, b, v0); });
    report.predicate("g2", [&] { return edge.g_order >= 2; });
    return true;
  } else
    return false;
}
