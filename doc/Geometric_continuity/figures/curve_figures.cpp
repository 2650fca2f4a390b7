// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "figures.h"

#include <CGAL/Geometric_continuity/algebra/Basis_matrix.h>
#include <CGAL/Geometric_continuity/curves/Cubic_blended_curve.h>
#include <CGAL/Geometric_continuity/extensions/alternatives.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/local/congruence.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef Plane::Point P;
typedef Space::Point Q;
typedef GC::Bezier_curve<Plane> Plane_curve;
typedef GC::Bezier_curve<Space> Space_curve;

// The frame of Frenet at five places of a space curve.
void frenet_frame(const std::string& file) {
  const Space_curve x{Q(4, 0, 0), Q(4, 4, 0.5), Q(0, 7, 1.5), Q(-4, 4, 2.5), Q(-4, -1, 3), Q(0, -3, 4)};
  GC::Svg_panel panel("e\u2081 tangent, e\u2082 principal normal, e\u2083 binormal");
  panel.add(x, named(given, "curve"));
  for (double t : {0., 0.25, 0.5, 0.75, 1.}) {
    const auto jet = x.jet(t, 2);
    const auto frame = GC::frenet_frame(jet)->normalized();
    for (int i : {1, 2, 3}) {
      const Space::Vector e = 1.5 * frame.vector(i);
      const GC::Svg_style style = i == 1 ? named(result, "e\u2081") : named(construction, "e\u2082, e\u2083");
      panel.add(Space_curve{x(t), x(t) + e}, style)
          .label("e" + std::string(i == 1   ? "\u2081"
                                   : i == 2 ? "\u2082"
                                            : "\u2083"));
    }
    panel.add(Space_curve{x(t)}, construction).join();
  }
  save(file, GC::Svg_figure("The frame of Frenet moves along a curve", 1).add(panel));
}

// The four blending functions of each basis, as curves (t, f(t)), scaled to be as wide as high.
template <class Basis>
GC::Svg_panel blending_functions(const std::string& caption, const Basis& basis,
                                 const std::array<const char*, 4>& names) {
  const GC::Svg_style axes = named(construction, "0, 1");
  GC::Svg_panel panel(caption);
  panel.add(Plane_curve{P(0, 0), P(1, 0)}, axes).label("1").add(Plane_curve{P(0, 0), P(0, 1)}, axes).label("1");
  panel.add(Plane_curve{P(0, 1), P(1, 1)}, axes);
  const auto to_bernstein = GC::basis_conversion<double>(basis, GC::Bezier_basis());
  for (int i = 0; i < 4; ++i) {
    std::vector<P> points;
    for (int j = 0; j < 4; ++j) points.push_back(P(j / 3., to_bernstein(i, j)));
    const Plane_curve f(points.begin(), points.end());
    panel.add(f, named(result, "blending functions"));
    double where = 0; // of the largest value
    for (int k = 0; k <= 100; ++k)
      if (std::abs(f(k / 100.).y()) > std::abs(f(where).y())) where = k / 100.;
    write(panel, f(where), names[static_cast<std::size_t>(i)]);
  }
  return panel;
}

void cubic_bases(const std::string& file) {
  const std::array<const char*, 4> points = {"P\u2081", "P\u2082", "P\u2083", "P\u2084"};
  save(file, GC::Svg_figure("The weights of points and derivatives for t from 0 to 1", 4)
                 .add(blending_functions("Hermite: P\u2081, P\u2084, R\u2081, R\u2084", GC::Hermite_basis(),
                                         {"P\u2081", "P\u2084", "R\u2081", "R\u2084"}))
                 .add(blending_functions("B\u00e9zier", GC::Bezier_basis(), points))
                 .add(blending_functions("Catmull-Rom", GC::Catmull_rom_basis(), points))
                 .add(blending_functions("uniform B-spline", GC::Uniform_bspline_basis(), points)));
}

// A corner, a kink and a join without one, at a node of the letter S of Latin Modern Sans 12. The
// handle behind the node and the line on which it lies where there is no kink.
void kinks_and_corners(const std::string& file) {
  const P node(171, 446);
  GC::Svg_figure figure("A corner is meant; a kink is not, and is mended: both handles move by one unit", 3);
  const auto add = [&](const std::string& caption, const P& before, const P& behind) {
    const Plane_curve left{P(286, 402), P(218, 419), before, node}, right{node, behind, P(131, 485), P(131, 530)};
    GC::Svg_style outline = named(given, "outline"), handles = named(result, "handles");
    outline.in_frame = false;
    const double length = std::sqrt(CGAL::squared_distance(node, behind) / CGAL::squared_distance(before, node));
    const GC::Enclosure angle = *GC::deviation(left, right).tangent_angle;
    std::string degrees = std::to_string(0.01 * std::round(100 * GC::in_degrees(angle).upper));
    degrees.resize(degrees.find('.') + 3);
    GC::Svg_panel panel(caption + ": " + degrees + "\u00b0");
    panel.add(left, outline).join().add(right, outline);
    panel.add(Plane_curve{before, node}, handles).add(Plane_curve{node, behind}, handles);
    panel.add(Plane_curve{node, node + 1.6 * length * (node - before)}, named(construction, "straight on"));
    figure.add(panel);
  };
  add("a corner that is meant", P(193, 425), P(150, 441));
  add("a kink, as drawn", P(193, 425), P(158, 460));
  add("mended, exactly", P(192, 425), P(158, 459));
  save(file, figure);
}

// Hagen's families in space: the line of all b2 with the right curvature, the plane of all b3 with
// the right torsion behind one of them.
void hagen_families(const std::string& file) {
  const Space_curve left{Q(-6, -3, 0), Q(-6, 0, 1), Q(-4, 2, 2), Q(-1, 2, 2)};
  const auto line = GC::curvature_alternatives(left);
  const auto plane = GC::torsion_alternatives(left, 4.);
  const Q b0 = left.control_point(3), b1 = GC::reflection<Space>(b0, left.control_point(2));
  const auto start = [&](const std::string& caption) {
    GC::Svg_panel panel(caption);
    panel.add(left, {GC::Svg_role::given, true, false});
    return panel;
  };
  GC::Svg_panel curvature = start("curvature: b\u2082 on a line, one number C\u2080"),
                torsion = start("torsion: b\u2083 in a plane, two numbers C\u2081, C\u2082");
  const GC::Svg_style family = named(construction, "line and plane of alternatives"),
                      next = named(result, "next segment");
  curvature.add(Space_curve{line.point_at(1), line.point_at(6)}, family);
  for (double c0 : {2., 4., 6.}) {
    const Q b2 = line.point_at(c0);
    curvature.add(Space_curve{b0, b1, b2, b2 + (b2 - b1)}, next);
    curvature.add(Space_curve{b2}, family).join("C\u2080 = " + std::to_string(int(c0)));
  }
  const Q b2 = line.point_at(4.);
  for (int k = 0; k <= 4; ++k) {
    const double c1 = 5 + k, c2 = 4 + 0.5 * k;
    torsion.add(Space_curve{plane.point_at({c1, 4}), plane.point_at({c1, 6})}, family);
    torsion.add(Space_curve{plane.point_at({5, c2}), plane.point_at({9, c2})}, family);
  }
  for (const auto& c : {GC::Torsion_parameters<double>{7, 5}, {5, 4}, {9, 4}, {5, 6}, {9, 6}}) {
    torsion.add(Space_curve{b0, b1, b2, plane.point_at(c)}, next);
    if (c.c1 == 7) torsion.add(Space_curve{plane.point_at(c)}, family).join("C\u00b3");
  }
  for (GC::Svg_panel* panel : {&curvature, &torsion}) {
    panel->add(Space_curve{b0}, family).join("b\u2080");
    write(*panel, b1, "b\u2081");
  }
  write(torsion, b2, "b\u2082");
  save(file, GC::Svg_figure("All next segments with continuous curvature, and with continuous torsion", 2)
                 .add(curvature)
                 .add(torsion));
}

// Portnov's figure 3 in space, where the lines l and B1 B2 do not meet: C is the point of l that is
// nearest to B1 B2, and H is nearest to it, (23).
void portnov_figure_3(const std::string& file) {
  typedef Space::Vector Vector;
  const Q a(-4, 0, 0), b1(-1, 0, 0), b2(4, 3, -3);
  const Vector x(1, 0, 0), n(0, 0, -1), to_b2 = (b2 - b1) / std::sqrt((b2 - b1).squared_length());
  const double d = 2.5, t2 = d * (n * to_b2) / (1 - (x * to_b2) * (x * to_b2)), t1 = t2 * (x * to_b2);
  const Q c0 = b1 + d * n, c = c0 + t1 * x, h = b1 + t2 * to_b2;
  const GC::Svg_style squares = named(given, "right angles");
  GC::Svg_panel panel("C\u2080C is orthogonal to HC, and HC to B\u2081H");
  const auto right_angle = [&](const Q& p, const Q& q, const Q& r) {
    const Vector u = (q - p) / std::sqrt((q - p).squared_length()), v = (r - p) / std::sqrt((r - p).squared_length());
    if (std::abs(u * v) > 1e-12) throw std::runtime_error("portnov_figure_3: an angle is not right");
    panel.add(Space_curve{p + 0.35 * u, p + 0.35 * (u + v)}, squares)
        .add(Space_curve{p + 0.35 * (u + v), p + 0.35 * v}, squares);
  };
  const GC::Svg_style lines = named(construction, "AB, l, B\u2081B\u2082");
  panel.add(Space_curve{a, b1 + 3 * x}, lines).add(Space_curve{c0 - 3 * x, c0 + 4 * x}, lines).label("l");
  panel.add(Space_curve{b1, b2}, lines)
      .add(Space_curve{b1, c0}, named(result, "d, HC"))
      .add(Space_curve{h, c}, named(result, "d, HC"));
  write(panel, b1 + 0.5 * d * n, "d");
  right_angle(c0, b1, c);
  right_angle(h, c, b2);
  right_angle(c, h, c + (c - c0));
  for (const auto& [point, name] :
       {std::pair<Q, const char*>{a, "A"}, {b1, "B\u2081"}, {b2, "B\u2082"}, {c0, "C\u2080"}, {c, "C"}, {h, "H"}})
    panel.add(Space_curve{point}, lines).join(name);
  save(file, GC::Svg_figure("Portnov's figure 3: C near the line B\u2081B\u2082", 1).add(panel));
}

} // namespace

void draw_curve_figures(const std::string& folder) {
  frenet_frame(folder + "frenet_frame.svg");
  cubic_bases(folder + "cubic_bases.svg");
  kinks_and_corners(folder + "kinks_and_corners.svg");
  portnov_figure_3(folder + "portnov_figure_3.svg");
  hagen_families(folder + "hagen_families.svg");
}
