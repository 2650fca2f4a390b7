// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/chains/join_report.h"
#include "commands/drawings/segment_joins.h"
#include "reports/report_joins.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

typedef GC::Svg_segment<Drawing_traits> Segment;

// c + u cos(x) + v sin(x) for 0 <= x <= angle < 2 pi. With t = tan(x/4), cos(x) = (1 - 6 t^2 + t^4)
// / (1 + t^2)^2 and sin(x) = 4 t (1 - t^2) / (1 + t^2)^2: numerators and denominator are brought on
// t <= tan(angle/4) and into Bernstein form.
Report_curve drawn_arc(const std::array<double, 2>& c, const std::array<double, 2>& u, const std::array<double, 2>& v,
                       double angle, std::size_t group) {
  const double t = std::tan(angle / 4), cosine[] = {1, 0, -6, 0, 1}, sine[] = {0, 4, 0, -4, 0},
               unit[] = {1, 0, 2, 0, 1};
  const double binomials[5][5] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}};
  const auto bernstein = [&](const double* powers, int j) {
    double sum = 0;
    for (int i = 0; i <= j; ++i) sum += binomials[j][i] / binomials[4][i] * powers[i] * std::pow(t, i);
    return sum;
  };
  Report_curve curve{{}, {}, group};
  for (int j = 0; j <= 4; ++j) {
    const double w = bernstein(unit, j), x = bernstein(cosine, j) / w, y = bernstein(sine, j) / w;
    for (std::size_t i = 0; i < 2; ++i) curve.points.push_back(c[i] + x * u[i] + y * v[i]);
    curve.weights.push_back(w);
  }
  return curve;
}

double chord(const Segment& s) { return std::sqrt(CGAL::to_double((s.end() - s.start()).squared_length())); }

} // namespace

std::shared_ptr<const Report_curve> drawn_curve(const Segment& given, std::size_t group) {
  if (given.bezier()) return drawn_curve(*given.bezier(), group);
  const GC::Path_segment<Drawing_traits> segment = given.rounded();
  const Drawing_traits::Point q = segment.end();
  const Exact root(std::sqrt(CGAL::to_double(segment.radicand())));
  // with x'' = c - x
  const GC::Coordinate_jet<Exact, 2> jet = segment.start_jet_over<Exact>(2, root);
  const auto numbers = [](const Exact& x, const Exact& y) {
    return std::array<double, 2>{CGAL::to_double(x), CGAL::to_double(y)};
  };
  const std::array<double, 2> c = numbers(jet[0][0] + jet[2][0], jet[0][1] + jet[2][1]),
                              u = numbers(-jet[2][0], -jet[2][1]), v = numbers(jet[1][0], jet[1][1]);
  const double x = CGAL::to_double(q.x()) - c[0], y = CGAL::to_double(q.y()) - c[1];
  const double cosine = (x * v[1] - y * v[0]) / (u[0] * v[1] - u[1] * v[0]),
               sine = (u[0] * y - u[1] * x) / (u[0] * v[1] - u[1] * v[0]);
  double angle = std::atan2(sine, cosine);
  if (angle <= 0) angle += 2 * 3.141592653589793;
  return std::make_shared<const Report_curve>(drawn_arc(c, u, v, angle, group));
}

// A join with an arc has no bounds of the curvatures.
Report_item measured_join(const Segment& left, const Segment& right, const Report_demand& demand) {
  if (left.bezier() && right.bezier()) return measured_join(*left.bezier(), *right.bezier(), demand);
  Report_item item;
  item.grade = report_grade(segment_class(left, right, demand.corner_threshold));
  item.gap = GC::Enclosure{0, 0}; // segments of a path
  const std::optional<GC::Enclosure> angle = segment_angle(left, right);
  if (angle) item.angle = GC::in_degrees(*angle);
  if (item.grade == Report_grade::kink || item.grade == Report_grade::corner)
    item.severity = angle->upper * (std::min)(chord(left), chord(right)) / 3;
  const Plane_curve *const a = left.bezier(), *const b = right.bezier();
  const bool retracted =
      (a && a->control_point(a->degree() - 1) == left.end()) || (b && b->control_point(1) == right.start());
  item.verdict = report_words(item.grade, retracted);
  if (item.grade == Report_grade::undecided)
    item.verdict = left.is_known() && right.is_known()
                       ? "a segment has no length, hence no direction"
                       : "a rotated ellipse, whose tangent differs by too little to be told, or not at all";
  item.point = {rounded(CGAL::to_double(right.start().x()), 9), rounded(CGAL::to_double(right.start().y()), 9)};
  return item;
}
