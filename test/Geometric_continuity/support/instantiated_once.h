// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Simple_cartesian.h>
#include <Geometric_continuity_figures/Svg_figure.h>

#include <iostream>
#include <vector>

// Most tests and examples instantiate this code. With the precompiled headers it is instantiated
// and compiled once for all of them; it is never called. Before you add to it, find out which
// functions many object files have (nm), and how much longer the headers then take.
namespace instantiated_once {

namespace GC = CGAL::Geometric_continuity;

template <class Left, class Right> void joins(const Left& left, const Right& right) {
  std::cout << GC::continuity(left, right) << GC::continuity(left, right, 4) << GC::deviation(left, right);
  static_cast<void>(GC::is_g1_join(left, right) && GC::is_g2_join(left, right) && GC::is_g3_join(left, right) &&
                    GC::is_f3_join(left, right));
}

template <class Traits, class FT = typename Traits::FT> void curves(const std::vector<typename Traits::Point>& points) {
  const GC::Bezier_curve<Traits> curve(points);
  const GC::Bezier_curve<Traits, 3> cubic(points);
  const GC::Bspline_curve<Traits> spline(points, GC::Knot_vector<FT>(3, std::vector<FT>()));
  joins(curve, curve);
  joins(cubic, cubic);
  std::cout << curve << GC::knot_continuity(spline, FT(1)) << curve.jet(FT(1), 3).point()
            << curve.split(FT(1)).first.elevate() << spline.jet(FT(1), 3).point() << spline.bezier_pieces().size()
            << spline.insert(FT(1)).number_of_points()
            << GC::chain_continuity(std::vector<GC::Bezier_curve<Traits>>{curve});
}

template <class Traits, class FT = typename Traits::FT>
void rational_curves(const std::vector<typename Traits::Point>& points) {
  const std::vector<FT> weights;
  const GC::Rational_bezier_curve<Traits> curve(points.begin(), points.end(), weights.begin(), weights.end());
  const GC::Rational_bspline_curve<Traits> spline(points, weights, GC::Knot_vector<FT>(3, std::vector<FT>()));
  joins(curve, curve);
  std::cout << curve.jet(FT(1), 3).point() << spline.jet(FT(1), 3).point() << spline.bezier_pieces().size();
}

template <class Traits> void blends(const std::vector<typename Traits::Point>& points) {
  const GC::Bezier_curve<Traits> curve(points);
  std::cout << GC::blend(curve, curve).control_point(0) << GC::blend(curve, curve, GC::Fair()).report;
}

template <class Surface> void edges(const Surface& s) {
  std::cout << GC::edge_continuity(s, GC::Patch_edge::u1, s, GC::Patch_edge::u0)
            << GC::blend(s, GC::Patch_edge::u1, s, GC::Patch_edge::u0).control_point(0, 0)
            << s.split_u(typename Surface::FT(1)).first.control_point(0, 0)
            << s.jet(typename Surface::FT(1), typename Surface::FT(1), 2).point();
}

template <class Traits, class FT = typename Traits::FT>
void surfaces(const std::vector<std::vector<typename Traits::Point>>& net) {
  const GC::Knot_vector<FT> knots(3, std::vector<FT>());
  const std::vector<std::vector<FT>> weights;
  edges(GC::Bezier_patch<Traits>(net));
  edges(GC::Bspline_surface<Traits>(net, knots, knots));
  edges(GC::Rational_bezier_patch<Traits>(net, weights));
  edges(GC::Rational_bspline_surface<Traits>(net, weights, knots, knots));
}

inline void all() {
  typedef CGAL::Simple_cartesian<CGAL::Exact_rational> Exact;
  typedef CGAL::Simple_cartesian<double> Double;
  curves<GC::Traits_2<Exact>>({});
  curves<GC::Traits_3<Exact>>({});
  curves<GC::Traits_2<CGAL::Epick>>({});
  curves<GC::Traits_3<CGAL::Epick>>({});
  curves<GC::Traits_2<Double>>({});
  curves<GC::Traits_3<Double>>({});
  curves<GC::Traits_2<CGAL::Epeck>>({});
  curves<GC::Traits_d<CGAL::Cartesian_d<CGAL::Exact_rational>>>({});
  rational_curves<GC::Traits_2<Exact>>({});
  rational_curves<GC::Traits_3<Exact>>({});
  blends<GC::Traits_2<Exact>>({});
  blends<GC::Traits_3<Exact>>({});
  blends<GC::Traits_2<CGAL::Epeck>>({});
  surfaces<GC::Traits_3<Exact>>({});
  std::cout << GC::read_g2_surfaces<GC::Traits_3<Exact>>(std::cin, "").size()
            << GC::read_g2_curves<GC::Traits_2<Exact>>(std::cin, "").size()
            << GC::model_continuity(std::vector<GC::Bezier_patch<GC::Traits_3<Exact>>>()).summary
            << GC::Svg_figure("").add(GC::Bezier_curve<GC::Traits_2<Exact>>());
}

} // namespace instantiated_once
