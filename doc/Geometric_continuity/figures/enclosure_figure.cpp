// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "figures.h"

#include <CGAL/Geometric_continuity/cad/cad_edge_continuity.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <memory>
#include <string>
#include <vector>

// A plane and a spline face that meet along a line, at an angle that differs from 0 between two of
// 21 samples only: the defect of defect_between_samples.step. The enclosure of the angle on 40
// parts of the edge, beside the samples.
void draw_enclosure(const std::string& folder) {
  typedef Plane::Point P;
  typedef GC::Bezier_curve<Plane> Curve;
  const double length = 100;
  const std::vector<double> knots{0, 0, 0, 51, 52, 53, 54, length, length, length}, slopes{0, 0, 0, 0.05, 0, 0, 0};
  GC::Cad_spline_surface face{2, 1, knots, {0, 0, 10, 10}, {}, {}};
  for (std::size_t i = 0; i < slopes.size(); ++i)
    for (double y : {0., 10.}) face.points.push_back({0.5 * (knots[i + 1] + knots[i + 2]), y, y * slopes[i]});
  const GC::Cad_elementary_surface plane{GC::Cad_elementary_surface::Kind::plane,
                                         {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto side = [](const GC::Cad_surface& surface) {
    const GC::Cad_placement unmoved{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    return GC::Edge_side{std::make_shared<GC::Cad_surface>(surface),
                         std::make_shared<GC::Cad_curve<2>>(GC::Cad_line<2>{{0, 0}, {1, 0}}), unmoved, false};
  };
  const GC::Edge_side a = side(plane), b = side(face);
  const auto angle = [&](double first, double last) {
    return GC::in_degrees(GC::edge_enclosure(a, b, first, last).angle->value).upper;
  };

  const double scale = 8; // of degrees, so that they are seen
  const auto point = [&](double t, double degrees) { return P(t, scale * degrees); };
  const GC::Svg_style axes = named(construction, "0 to 2 degrees");
  GC::Svg_panel panel("21 samples find 0 everywhere; the angle is proved to reach " +
                      std::to_string(angle(0, length)).substr(0, 4) + "\u00b0");
  panel.add(Curve{point(0, 0), point(length, 0)}, axes).label("edge");
  panel.add(Curve{point(0, 0), point(0, 2)}, axes).label("2\u00b0").add(Curve{point(0, 2), point(length, 2)}, axes);
  const int parts = 40, steps = 800;
  for (int i = 0; i < parts; ++i) {
    const double first = length * i / parts, last = length * (i + 1) / parts, most = angle(first, last);
    const GC::Svg_style bound = named(result, "upper bound on each part, proved");
    panel.add(Curve{point(first, most), point(last, most)}, bound);
    if (most > 1e-3)
      panel.add(Curve{point(first, 0), point(first, most)}, bound).add(Curve{point(last, 0), point(last, most)}, bound);
  }
  for (int i = 0; i < steps; ++i) {
    const double first = length * i / steps, last = length * (i + 1) / steps, x = angle(first, first),
                 y = angle(last, last);
    if (x > 1e-6 || y > 1e-6) panel.add(Curve{point(first, x), point(last, y)}, named(given, "angle of the normals"));
  }
  // at a hundredth of the length from both ends, as OpenCASCADE takes them
  for (int i = 0; i <= 20; ++i) {
    const double t = length * (0.01 + 0.98 * i / 20);
    panel.add(Curve{point(t, angle(t, t))}, named(given, "sample")).join();
  }
  save(folder + "enclosure.svg",
       GC::Svg_figure("The angle along an edge of a CAD model: samples and an enclosure", 1).add(panel));
}
