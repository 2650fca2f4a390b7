// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "figures.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>
#include <CGAL/Geometric_continuity/surface_blends/connect_g1.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>
#include <CGAL/Geometric_continuity/surfaces/elementary_surfaces.h>
#include <CGAL/Geometric_continuity/surfaces/swept_surfaces.h>
#include <Geometric_continuity_figures/svg_surfaces.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

typedef Space::Point Q;
typedef Space::Vector Vector;
typedef GC::Bezier_curve<Space> Curve;
typedef GC::Bspline_curve<Space> Spline;

template <class Function>
void add_polyline(GC::Svg_panel& panel, Function point, int pieces, const GC::Svg_style& style) {
  for (int i = 0; i < pieces; ++i) panel.add(Curve{point(i / double(pieces)), point((i + 1) / double(pieces))}, style);
}

// Two surfaces along a curve with given twists: their cross derivatives T, and at the ends how
// these turn. Of exact numbers.
void ribbon(const std::string& file) {
  typedef CGAL::Exact_rational FT;
  typedef GC::Traits_3<CGAL::Simple_cartesian<FT>> Traits;
  typedef Traits::Point Point;
  typedef GC::Bspline_curve<Traits> Exact_spline;
  typedef GC::Bezier_curve<Traits> Line;
  const auto spline = [](const std::vector<Point>& points) {
    return Exact_spline(points.begin(), points.end(), GC::Knot_vector<FT>(3, FT(0), FT(4), {{FT(2), 2}}));
  };
  const Exact_spline c =
      spline({Point(0, 0, 0), Point(2, 0, 0), Point(4, 0, 3), Point(6, 0, 3), Point(8, 0, 0), Point(10, 0, 0)});
  const Exact_spline left =
      spline({Point(1, 3, 0), Point(3, 4, 1), Point(4, 5, 4), Point(6, 5, 4), Point(9, 4, -1), Point(11, 3, 0)});
  const Exact_spline right =
      spline({Point(1, -3, 0), Point(3, -2, 1), Point(4, -4, 4), Point(6, -4, 4), Point(9, -2, -1), Point(11, -3, 0)});
  const auto ribbon = GC::connect_g1(c, left, right);
  if (!ribbon.g1() || !ribbon.twist_coplanar()) throw std::runtime_error("the ribbon is not as its caption says");
  GC::Svg_panel panel(
      "S = C + T v on both sides: G1 along all of C, proved, with the twists that were given at its ends");
  for (const auto* side : {&ribbon.side1, &ribbon.side2}) {
    const auto edge = GC::boundary_curve(*side, GC::Patch_edge::v1);
    for (const auto& piece : edge.bezier_pieces()) panel.add(piece, named(result, "edges of the ribbon, v = 1"));
    for (int i = 0; i <= 24; ++i) {
      const FT u(FT(i) / FT(6));
      panel.add(Line{c(u), edge(u)}, named(construction, "cross derivatives T, and at the ends T\u2032"));
    }
    for (int u : {0, 4}) {
      const Traits::Vector twist(edge.jet(FT(u), 1).derivative(1) - c.jet(FT(u), 1).derivative(1));
      const Point tip = edge(FT(u)) + FT(u == 0 ? 1 : -1) * twist;
      panel.add(Line{edge(FT(u)), tip}, named(construction, "cross derivatives T, and at the ends T\u2032"))
          .label("T\u2032");
    }
  }
  for (const auto& piece : c.bezier_pieces()) panel.add(piece, named(given, "C"));
  save(file, GC::Svg_figure("The ribbon with its twists", 1).add(panel));
}

// Normals along a profile that is extruded and one that turns about an axis.
void swept_normals(const std::string& file) {
  const Curve profile{Q(1.6, 0, 4), Q(0.8, 0, 2.4), Q(3.2, 0, 0.6), Q(2, 0, 0)};
  const GC::Svg_style curve = named(given, "profile"), line = named(construction, "lines of the surface"),
                      normal = named(result, "normals");
  const Vector direction(0, 4, 0);
  GC::Svg_panel extrusion("extrusion: tangent \u00d7 direction"),
      revolution("revolution: the normal of the profile turns about the axis");
  const GC::Extrusion_surface_3<Curve> wall(profile, direction);
  const GC::Revolution_surface_3<Curve> vase(profile, Q(0, 0, 0), Vector(0, 0, 1));
  const auto add_normal = [&](GC::Svg_panel& panel, const Q& p, const Vector& n) {
    panel.add(Curve{p, p + 0.9 / std::sqrt(n.squared_length()) * n}, normal);
  };
  for (int i = 0; i <= 6; ++i) extrusion.add(Curve{wall(i / 6., 0), wall(i / 6., 1)}, line);
  for (int j = 0; j <= 4; ++j) {
    const Vector step = j / 4. * direction;
    extrusion.add(profile.transform(CGAL::Aff_transformation_3<Kernel>(CGAL::TRANSLATION, step)),
                  j == 0 ? curve : line);
  }
  for (int i = 0; i <= 6; ++i)
    for (int j : {0, 2, 4}) add_normal(extrusion, wall(i / 6., j / 4.), wall.normal(i / 6., j / 4.));
  for (int i = 0; i <= 6; ++i) {
    const auto parallel = [&](double t) { return vase(i / 6., std::tan(3.14159265358979 / 4 * (2 * t - 1.8))); };
    add_polyline(revolution, parallel, 24, line);
  }
  for (int j = 0; j <= 6; ++j) {
    const double v = std::tan(3.14159265358979 / 4 * (j / 3. - 1.8));
    add_polyline(
        revolution, [&](double t) { return vase(t, v); }, 16, j == 6 ? curve : line);
    for (int i = 0; i <= 6 && j % 2 == 0; ++i) add_normal(revolution, vase(i / 6., v), vase.normal(i / 6., v));
  }
  revolution.add(Curve{Q(0, 0, 0), Q(0, 0, 4.6)}, line).label("axis");
  save(file, GC::Svg_figure("Normals of swept surfaces", 2).add(extrusion).add(revolution));
}

// A fillet of a plane and a cylinder, by a circle and by a blend: surfaces of revolution of exact
// numbers.
void edge_pair(const std::string& folder) {
  typedef CGAL::Exact_rational FT;
  typedef GC::Traits_3<CGAL::Simple_cartesian<FT>> Traits;
  typedef Traits::Point Point;
  typedef GC::Rational_bezier_curve<Traits> Profile;
  const Profile ring = GC::Bezier_curve<Traits>{Point(FT(5) / FT(2), 0, 0), Point(2, 0, 0)},
                circle({Point(2, 0, 0), Point(1, 0, 0), Point(1, 0, 1)}, {FT(1), FT(1), FT(2)}),
                wall = GC::Bezier_curve<Traits>{Point(1, 0, 1), Point(1, 0, 2)},
                blend = GC::blend(ring, wall, GC::Fair());
  for (const bool smooth : {false, true}) {
    std::vector<GC::Rational_bspline_surface<Traits>> surfaces;
    for (const Profile& profile : {ring, smooth ? blend : circle, wall})
      surfaces.push_back(
          GC::full_revolution(GC::Rational_bspline_curve<Traits>(profile), Point(0, 0, 0), Traits::Vector(0, 0, 1)));
    GC::Svg_surface_style style;
    style.elevation = 32;
    style.width = 552; // two of them in a row
    style.title = smooth ? "G2 edges: isophotes run through" : "G1 edges: isophotes are kinked";
    std::ofstream os(folder + (smooth ? "edge_g2.svg" : "edge_g1.svg"));
    GC::write_svg_surfaces(os, surfaces, style);
    if (!os.flush()) throw std::runtime_error("cannot write edge_g2.svg");
  }
}

} // namespace

void draw_surface_figures(const std::string& folder) {
  ribbon(folder + "ribbon.svg");
  swept_normals(folder + "swept_normals.svg");
  edge_pair(folder);
}
