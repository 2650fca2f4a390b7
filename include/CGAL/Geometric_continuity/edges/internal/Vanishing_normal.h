// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_VANISHING_NORMAL_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_VANISHING_NORMAL_H

#include <CGAL/Geometric_continuity/edges/internal/Placed_side.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

/// \file Vanishing_normal.h
/// Where the normal of a surface is proved to vanish on an edge. That it cannot be told from zero is not enough: it may turn there.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

class Vanishing_normal {
  const Edge_side& side_;
  std::vector<std::pair<int, double>>
      collapsed_; // the ends of the domain in u (0) or v (1) where a spline surface is a point

public:
  explicit Vanishing_normal(const Edge_side& side) : side_(side) {
    const auto* s = std::get_if<Cad_spline_surface>(side.surface.get());
    if (!s) return;
    const int columns = s->v_points(), rows = static_cast<int>(s->points.size()) / columns;
    const auto add = [&](int axis, const std::vector<double>& knots, int degree, int lines, int points, auto point) {
      const int last = static_cast<int>(knots.size()) - 1;
      for (const bool at_end : {false, true}) {
        const double knot = at_end ? knots[last] : knots[0];
        if ((at_end ? knots[last - degree] : knots[degree]) != knot) continue; // not clamped
        bool is_point = true;
        for (int i = 1; i < points; ++i)
          is_point = is_point && point(at_end ? lines - 1 : 0, i) == point(at_end ? lines - 1 : 0, 0);
        if (is_point) collapsed_.emplace_back(axis, knot);
      }
    };
    add(0, s->u_knots, s->u_degree, rows, columns, [&](int i, int j) { return s->points[i * columns + j]; });
    add(1, s->v_knots, s->v_degree, columns, rows, [&](int j, int i) { return s->points[i * columns + j]; });
  }

  // Whether the normal, or if asked for the derivative of the edge in the parameter plane, is proved to vanish at a point of the range, or
  // beside it by no more than the rounding of curves: at the apex of a cone, the pole of a sphere, a cusp of a torus, a line of a spline
  // that is a point; and at an end of the range where the derivatives of the surface are computed without an error.
  bool is_on(const Edge_range& range, bool or_derivative) const {
    const Cad_curve<2>& curve = *side_.curve;
    const Interval_vector<2> c = cad_curve_jet(curve, range.t, 0, touched_pieces(curve, range.t, 1).front()).c[0];
    for (const auto& [axis, value] : collapsed_) {
      const Interval x = c[axis] + symmetric(rounding * (1 + std::fabs(value)));
      if (x.inf() <= value && value <= x.sup()) return true;
    }
    if (const auto* elementary = std::get_if<Cad_elementary_surface>(side_.surface.get()))
      if (changes_sign(*elementary, c[1] + symmetric(rounding * (1 + magnitude(c[1]))))) return true;
    return is_at(range.t.inf(), or_derivative) || is_at(range.t.sup(), or_derivative);
  }

private:
  static constexpr double rounding = 1e-12;

  bool is_at(double t, bool or_derivative) const {
    const Interval at(t);
    const Cad_curve_jet<2> c = cad_curve_jet(*side_.curve, at, 1, touched_pieces(*side_.curve, at, 1).front());
    if (or_derivative && is_exact_zero(c.c[1][0]) && is_exact_zero(c.c[1][1])) return true;
    const std::array<std::vector<int>, 2> spans = touched_pieces(*side_.surface, c.c[0][0], c.c[0][1], 0, 0);
    const Cad_surface_jet jet =
        cad_surface_jet(*side_.surface, {c.c[0][0], c.c[0][1], spans[0].front(), spans[1].front()}, 1);
    const Interval_vector<3>&u = jet.s(1, 0), &v = jet.s(0, 1);
    for (int i = 0; i < 3; ++i)
      if (!is_exact_zero(u[i] * v[(i + 1) % 3] - u[(i + 1) % 3] * v[i])) return false;
    return true;
  }

  // Whether the distance from the axis does, with its sign: then it has a zero.
  static bool changes_sign(const Cad_elementary_surface& s, const Interval& v) {
    typedef Cad_elementary_surface::Kind Kind;
    const auto sign = [&](double at) {
      const Interval rho =
          s.kind == Kind::cone     ? Interval(s.radius) + Interval(at) * cosine_and_sine(Interval(s.other)).sine
          : s.kind == Kind::sphere ? Interval(s.radius) * cosine_and_sine(Interval(at)).cosine
          : s.kind == Kind::torus  ? Interval(s.radius) + Interval(s.other) * cosine_and_sine(Interval(at)).cosine
                                   : Interval(1);
      return rho.inf() > 0 ? 1 : rho.sup() < 0 ? -1 : 0;
    };
    return sign(v.inf()) * sign(v.sup()) < 0;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_VANISHING_NORMAL_H
