// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_SURFACE_POLE_H
#define CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_SURFACE_POLE_H

#include <CGAL/Geometric_continuity/cad/internal/Side_evaluator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

/// \file Surface_pole.h
/// Poles of surfaces: whole parameter lines that lie within a small distance of one point of space.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The poles of a side next to its points. A surface that is rotated has one where a parameter line
// is a circle that is small enough. A spline has one only where a side, or a knot line, is a point
// up to rounding: next to a side that is nearly one, its normal turns. Numbers that are apart by
// far less than rounding are meant to be apart.
class Surface_pole {
  const Side_evaluator& side_;

public:
  explicit Surface_pole(const Side_evaluator& side) : side_(side) {}

  // The points of space, rounded, within the distance `radius` of which it is proved that a whole
  // parameter line lies next to the point of the side at t.
  std::vector<Cad_point<3>> next_to(double t, double radius) const {
    const Interval_vector<2> c = cad_curve_jet(*side_.given().curve, Interval(t), 0).c[0];
    std::vector<Cad_point<3>> poles;
    const auto add = [&](const std::optional<Interval_vector<3>>& line) {
      if (!line) return;
      const Interval_vector<3> placed = side_.placed()(*line, true);
      Cad_point<3> point;
      Interval square_of_radius = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        point[i] = middle(placed[i]);
        square_of_radius += CGAL::square(placed[i] - Interval(point[i]));
      }
      if (CGAL::sqrt(square_of_radius).sup() <= radius) poles.push_back(point);
    };
    const Cad_surface& surface = *side_.given().surface;
    if (const auto* elementary = std::get_if<Cad_elementary_surface>(&surface)) {
      for (double v : lines_next_to(*elementary, middle(c[1]))) add(circle(v));
    } else if (std::holds_alternative<Cad_revolution>(surface)) {
      add(circle(middle(c[1])));
      if (const std::optional<double> knot = next_knot(spline_parameters(surface)[1], middle(c[1]))) add(circle(*knot));
    } else if (const auto* spline = std::get_if<Cad_spline_surface>(&surface)) {
      for (const bool constant_u : {true, false})
        if (const std::optional<double> knot =
                next_knot(spline_parameters(surface)[constant_u ? 0 : 1], middle(c[constant_u ? 0 : 1])))
          add(point_of_line(*spline, constant_u, *knot));
    }
    return poles;
  }

private:
  // Returns about where in v the distance from the axis is zero.
  static std::vector<double> lines_next_to(const Cad_elementary_surface& s, double v) {
    typedef Cad_elementary_surface::Kind Kind;
    constexpr double pi = 3.141592653589793;
    const auto turned = [&](double zero) { return zero + 2 * pi * std::round((v - zero) / (2 * pi)); };
    switch (s.kind) {
    case Kind::sphere: return {turned(pi / 2), turned(-pi / 2)};
    case Kind::cone:
      if (const double sine = std::sin(s.other); sine != 0) return {-s.radius / sine};
      return {};
    case Kind::torus:
      if (std::fabs(s.radius) <= std::fabs(s.other)) {
        const double zero = std::acos(-s.radius / s.other);
        return {turned(zero), turned(-zero)};
      }
      return {};
    default: return {};
    }
  }

  static std::optional<double> next_knot(const Spline_parameter& parameter, double x) {
    if (!parameter) return std::nullopt;
    double best =
        std::fabs(parameter.first() - x) < std::fabs(parameter.last() - x) ? parameter.first() : parameter.last();
    parameter.for_each_inner_knot([&](double knot, int) {
      if (std::fabs(knot - x) < std::fabs(best - x)) best = knot;
    });
    return best;
  }

  // The line of a constant v of a surface that is rotated.
  std::optional<Interval_vector<3>> circle(double v) const {
    if (!std::isfinite(v)) return std::nullopt;
    const Cad_surface& surface = *side_.given().surface;
    const Interval all(-4, 4); // more than a turn
    const std::array<std::vector<int>, 2> spans = intersected_pieces(surface, all, Interval(v), 0, 0);
    return cad_surface_jet(surface, {all, Interval(v), 0, spans[1].front()}, 0).s(0, 0);
  }

  // A side, or a knot line that has a row of control points of its own: it lies in their convex
  // hull, since weights are positive. Nothing when these are neither one point nor as far apart as
  // rounding leaves them.
  static std::optional<Interval_vector<3>> point_of_line(const Cad_spline_surface& s, bool constant_u, double knot) {
    const std::vector<double>& knots = constant_u ? s.u_knots : s.v_knots;
    const std::ptrdiff_t degree = constant_u ? s.u_degree : s.v_degree;
    const auto [begin, end] = std::equal_range(knots.begin(), knots.end(), knot);
    if (end - begin < degree) return std::nullopt;
    const int line = static_cast<int>((std::max)(begin - knots.begin(), std::ptrdiff_t(1))) - 1;
    const int columns = s.v_points(), rows = static_cast<int>(s.points.size()) / columns;
    const auto point = [&](int i) -> const Cad_point<3>& {
      return s.points[static_cast<std::size_t>(constant_u ? line * columns + i : i * columns + line)];
    };
    Interval_vector<3> box;
    double apart = 0;
    for (std::size_t k = 0; k < 3; ++k) box[k] = point(0)[k];
    for (int i = 1; i < (constant_u ? columns : rows); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        box[k] = hull(box[k], Interval(point(i)[k]));
        apart = (std::max)(apart, box[k].sup() - box[k].inf());
      }
    double largest = 0;
    for (const Cad_point<3>& p : s.points)
      for (double x : p) largest = (std::max)(largest, std::fabs(x));
    if (apart > 0 && !(0x1p-70 * largest <= apart && apart <= 0x1p-46 * largest)) return std::nullopt;
    return box;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_SURFACE_POLE_H
