// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The six figures of Portnov's text, from the formulas: where the control points A, B, C of a blend
// lie, with the distance d, the line l and the right angles, and what three of his choices look
// like. Writes the picture portnov_figures.svg.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Simple_cartesian.h>
#include <Geometric_continuity_figures/Svg_figure.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational FT;
typedef GC::Traits_2<CGAL::Simple_cartesian<FT>> Traits;
typedef Traits::Point Point;
typedef Traits::Vector Vector;
typedef GC::Bezier_curve<Traits> Curve;
typedef GC::Quintic_blend<Traits> Blend;

const Curve phi{Point(0, 0), Point(1, 4), Point(4, 6), Point(7, 5)},
    psi{Point(10, 1), Point(12, -1), Point(15, 0), Point(16, 4)};
const GC::Svg_style given{GC::Svg_role::given, false, true}, construction{GC::Svg_role::construction},
    result{GC::Svg_role::result, true, true, "blend"};
const GC::Svg_style mark_of_angle{GC::Svg_role::given, false, false, "marks of angles"};
bool proved = true;

// The point of the line l that is nearest to B: d away from it.
Point foot_of(const Blend& gamma) {
  const Vector ab = gamma.control_point(1) - gamma.control_point(0),
               bc = gamma.control_point(2) - gamma.control_point(1);
  return gamma.control_point(2) - FT(FT(bc * ab) / ab.squared_length()) * ab;
}

// A panel with the end of phi and the points beside it, all enlarged about the end.
class Construction {
  GC::Svg_panel panel_;
  Point centre_;

public:
  Construction(const char* caption, const Blend& gamma) : panel_(caption), centre_(gamma.control_point(0)) {
    GC::Svg_style outside{GC::Svg_role::given};
    outside.in_frame = false;
    std::vector<Point> points;
    for (int j = 0; j <= 3; ++j) points.push_back(enlarged(phi.control_point(j)));
    panel_.add(Curve(points.begin(), points.end()), outside);
  }
  const GC::Svg_panel& panel() const { return panel_; }

  Construction& mark(const Point& p, const char* label) {
    panel_.add(Curve{enlarged(p)}, construction).join(label);
    return *this;
  }
  Construction& write(const Point& p, const char* label) {
    panel_.add(Curve{enlarged(p)}, construction).label(label);
    return *this;
  }
  Construction& line(const Point& p, const Point& q, const GC::Svg_style& style = construction) {
    panel_.add(Curve{enlarged(p), enlarged(q)}, style);
    return *this;
  }
  // A little square at p between directions that are orthogonal, which is checked.
  Construction& right_angle(const Point& p, const Vector& a, const Vector& b) {
    proved = proved && a * b == 0;
    const Vector x = short_vector(a), y = short_vector(b);
    return line(p + x, p + x + y, mark_of_angle).line(p + x + y, p + y, mark_of_angle);
  }
  // An arc at p from one direction to the other.
  Construction& angle(const Point& p, const Vector& a, const Vector& b, const char* label) {
    const Vector x = FT(4) * short_vector(a), y = FT(4) * short_vector(b);
    const Point middle = p + FT(FT(1) / FT(2)) * (x + y) + FT(FT(1) / FT(8)) * (x + y);
    panel_.add(Curve{enlarged(p + x), enlarged(middle), enlarged(p + y)}, mark_of_angle);
    return write(middle, label);
  }

private:
  Point enlarged(const Point& p) const { return centre_ + FT(FT(5) / FT(2)) * (p - centre_); }
  static Vector short_vector(const Vector& v) { return FT(0.2 / std::sqrt(CGAL::to_double(v.squared_length()))) * v; }
};

// The line l of all points C for which the curvature is continuous, and the points A, B.
Construction construction_of(const char* caption, const Blend& gamma) {
  const Point a = gamma.control_point(0), b = gamma.control_point(1), c = gamma.control_point(2), foot = foot_of(gamma);
  const Vector ab = b - a;
  Construction panel(caption, gamma);
  panel.line(a, a + FT(5) / FT(2) * ab).line(foot - ab, foot + FT(3) / FT(2) * ab).write(foot - ab, "l");
  return panel.mark(a, "A").mark(b, "B").mark(c, "C");
}

GC::Svg_panel blend_of(const char* caption, const std::string& order, const Blend& gamma) {
  for (const auto& join : {GC::continuity(phi, gamma), GC::continuity(gamma, psi)})
    proved = proved && (order == "C2" ? join.c_order : join.g_order) >= 2;
  return GC::Svg_panel(caption).add(phi, given).join(order).add(gamma, result).join(order).add(psi, given);
}

int main() {
  const GC::Shape_parameters<FT> shape(1, 1);
  const Blend c2 = GC::blend(phi, psi, GC::Matching_second_derivative(), shape),
              least = GC::blend(phi, psi, GC::Minimal_second_derivative(), shape),
              near = GC::blend(phi, psi, GC::Near_line(), shape);
  const auto a = [](const Blend& gamma) { return gamma.control_point(0); };
  const auto b = [](const Blend& gamma) { return gamma.control_point(1); };
  const auto c = [](const Blend& gamma) { return gamma.control_point(2); };
  Construction first = construction_of("1: |AC| sin CAB = d: C lies on the line l, parallel to AB", c2),
               second = construction_of("2: |\u03b3\u2033| is least where C projects to A + 2 AB", least),
               third = construction_of(
                   "3: C\u2080C and B\u2081C\u2080 are orthogonal; in the plane H is C, on the line B\u2081B\u2082",
                   near);
  const Point foot = foot_of(c2), twice = a(least) + FT(2) * (b(least) - a(least)), corner = foot_of(near),
              b2 = near.control_point(4);
  first.line(a(c2), c(c2)).line(b(c2), foot).write(b(c2) + FT(FT(1) / FT(2)) * (foot - b(c2)), "d");
  first.right_angle(b(c2), b(c2) - a(c2), foot - b(c2)).right_angle(foot, b(c2) - a(c2), b(c2) - foot);
  first.angle(a(c2), b(c2) - a(c2), c(c2) - a(c2), "CAB");
  second.line(c(least), twice).mark(twice, "A + 2 AB").right_angle(twice, b(least) - a(least), c(least) - twice);
  third.line(b(near), b2).line(b(near), corner).mark(b2, "B\u2082").mark(corner, "C\u2080");
  third.right_angle(corner, a(near) - b(near), b(near) - corner);

  GC::Svg_figure figure("Portnov's figures", 3);
  figure.add(first.panel()).add(second.panel()).add(third.panel());
  figure.add(blend_of("4: equal second derivatives, C2", "C2", c2))
      .add(blend_of("5: least second derivatives, G2", "G2", least));
  figure.add(blend_of("6: C\u2081, C\u2082 near the line B\u2081B\u2082, G2", "G2", near));
  std::ofstream("portnov_figures.svg") << figure;
  std::cout << figure.number_of_panels() << " figures, "
            << (proved ? "all joins and right angles are as drawn" : "a join or an angle is not as drawn") << '\n';
  return proved ? 0 : 1;
}
