// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_FOOT_FINDER_H
#define CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_FOOT_FINDER_H

#include <CGAL/Geometric_continuity/cad/internal/Side_evaluator.h>
#include <CGAL/Geometric_continuity/joins/internal/join_forms.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

/// \file Foot_finder.h
/// The foot points of a curve C in space on a surface S: the zeros (u, v) of F = ((S - C) . S_u,
/// (S - C) . S_v).

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A lower bound of the distance of two points.
inline double length_below(const Interval_vector<3>& x, const Interval_vector<3>& y) {
  Interval sum = 0;
  for (int k = 0; k < 3; ++k) sum += square(x[k] - y[k]);
  return root_below((std::max)(0., sum.inf()));
}

class Foot_finder {
  typedef std::array<Interval, 2> Box;
  const Side_evaluator& side_;
  const Placed_curve& curve_;
  std::array<Cad_domain, 2> domain_;

  // F, its derivative, and the derivatives of the placed surface at all points of a box.
  struct Equations {
    Interval_vector<3> s, u, v, uu, uv, vv;
    Box f;
    Interval a, b, c; // the derivative (a, b; b, c)
  };

public:
  struct Foot {
    Cad_point<2> point, derivative; // by the parameter of the curve
  };
  struct Enclosed {
    Interval_vector<3> point, normal; // the normal of unit length
    // in the direction of the tangent plane that is orthogonal to the curve
    Interval curvature;
  };

  Foot_finder(const Side_evaluator& side, const Placed_curve& curve)
      : side_(side), curve_(curve), domain_(cad_domain(*side.given().surface)) {}

  // The foot point next to the curve of the side, rounded. Where the surface is singular a
  // parameter that does not matter stays.
  Foot near_curve(double t) const {
    const auto [point, tangent] = curve_.jet(t);
    Foot foot{start(t), {0, 0}};
    for (int step = 0; step < 50; ++step) {
      const Equations e = equations({Interval(foot.point[0]), Interval(foot.point[1])}, point);
      const std::array<double, 2> d = solved(e, middle(e.f[0]), middle(e.f[1]));
      double change = 0;
      for (std::size_t i = 0; i < 2; ++i) {
        const double x = in_domain(i, foot.point[i] - d[i]);
        if (!std::isfinite(x)) return foot;
        change = (std::max)(change, std::fabs(x - foot.point[i]) / (1 + std::fabs(x)));
        foot.point[i] = x;
      }
      if (change < 1e-15) break;
    }
    const Equations e = equations({Interval(foot.point[0]), Interval(foot.point[1])}, point);
    foot.derivative = solved(e, middle(dot_form(e.u, tangent)), middle(dot_form(e.v, tangent)));
    for (double& x : foot.derivative)
      if (!std::isfinite(x)) x = 0;
    return foot;
  }

  // The foot point at an end t of a range of the curve. Where a parameter of the surface does not
  // matter, as the longitude at a pole, it is the one to which those of the foot points at t + step
  // and t + 2 step lead, by the cubic through both, and the curve leaves along the line on which
  // the other one varies.
  Foot near_end(double t, double step) const {
    Foot foot = near_curve(t);
    const auto [point, tangent] = curve_.jet(t);
    const Equations e = equations({Interval(foot.point[0]), Interval(foot.point[1])}, point);
    const std::array<double, 2> size{extent(0) * std::sqrt(middle(dot_form(e.u, e.u))),
                                     extent(1) * std::sqrt(middle(dot_form(e.v, e.v)))};
    for (std::size_t i = 0; i < 2; ++i) {
      if (!(0 < size[1 - i] && size[i] <= 1e-6 * size[1 - i])) continue;
      const Foot x = near_curve(t + step), y = near_curve(t + 2 * step);
      if (!(std::fabs(x.point[i] - y.point[i]) <= 0.125 * extent(i))) continue;
      foot.point[i] =
          in_domain(i, 5 * y.point[i] - 4 * x.point[i] - step * (4 * x.derivative[i] + 2 * y.derivative[i]));
      foot.derivative[i] = 12 * (x.point[i] - y.point[i]) / step + 8 * x.derivative[i] + 5 * y.derivative[i];
      const Equations there = equations({Interval(foot.point[0]), Interval(foot.point[1])}, point);
      const Interval_vector<3>& other = i == 0 ? there.v : there.u;
      const double square = middle(dot_form(other, other));
      foot.derivative[1 - i] = middle(dot_form(other, tangent)) / square;
    }
    return foot;
  }

  // Encloses the foot point next to the curve of the side, or the point of that curve.
  std::optional<Enclosed> enclosed(double t, bool is_projected) const {
    const auto [point, tangent] = curve_.jet(t);
    const std::optional<Box> box = is_projected ? foot_box(near_curve(t).point, point) : own_box(t);
    if (!box || !is_in_one_piece(*box)) return std::nullopt;
    const Equations e = equations(*box, point);
    Enclosed result;
    const std::array<Interval, 3> n = cross_form(e.u, e.v);
    const Interval square = dot_form(n, n);
    if (!(square.inf() > 0)) return std::nullopt;
    const Interval length = CGAL::sqrt(square) * Interval(side_.is_flipped() ? -1 : 1);
    result.point = e.s;
    for (int k = 0; k < 3; ++k) result.normal[k] = n[k] / length;
    // a S_u + b S_v is orthogonal to the tangent
    const Interval b = dot_form(e.u, tangent), a = -dot_form(e.v, tangent);
    const Interval across = a * a * dot_form(e.u, e.u) + 2 * (a * b * dot_form(e.u, e.v)) + b * b * dot_form(e.v, e.v);
    const Interval form = a * a * dot_form(e.uu, result.normal) + 2 * (a * b * dot_form(e.uv, result.normal)) +
                          b * b * dot_form(e.vv, result.normal);
    result.curvature = across.inf() > 0 ? form / across : Interval::largest();
    return result;
  }

private:
  Interval_vector<2> on_curve(double t) const {
    const Cad_curve<2>& curve = *side_.given().curve;
    return cad_curve_jet(curve, Interval(t), 0).c[0];
  }
  Cad_point<2> start(double t) const {
    const Interval_vector<2> c = on_curve(t);
    return {middle(c[0]), middle(c[1])};
  }
  std::optional<Box> own_box(double t) const {
    const Interval_vector<2> c = on_curve(t);
    return Box{c[0], c[1]};
  }

  double in_domain(std::size_t i, double x) const {
    return (std::min)((std::max)(x, domain_[i].first), domain_[i].last);
  }
  // How far a parameter reaches, 1 where there is no end.
  double extent(std::size_t i) const {
    const double length = domain_[i].last - domain_[i].first;
    return std::isfinite(length) ? length : 1;
  }

  std::array<std::vector<int>, 2> spans(const Box& x) const {
    return intersected_pieces(*side_.given().surface, x[0], x[1], 0, 0);
  }
  bool is_in_one_piece(const Box& x) const {
    const std::array<std::vector<int>, 2> s = spans(x);
    return s[0].size() == 1 && s[1].size() == 1;
  }

  // Returns whether the box lies in the domain, up to rounding.
  bool is_in_domain(const Box& x) const {
    for (std::size_t i = 0; i < 2; ++i) {
      const double margin = 1e-9 * (domain_[i].last - domain_[i].first);
      if (x[i].inf() < domain_[i].first - margin || domain_[i].last + margin < x[i].sup()) return false;
    }
    return true;
  }

  Equations equations(const Box& x, const Interval_vector<3>& point) const {
    const std::array<std::vector<int>, 2> s = spans(x);
    const Cad_surface_jet jet = cad_surface_jet(*side_.given().surface, {x[0], x[1], s[0].front(), s[1].front()}, 2);
    const auto twice = [](Interval_vector<3> d) {
      for (Interval& y : d) y = 2 * y;
      return d;
    };
    const Validated_transform& placed = side_.placed();
    Equations e{placed(jet.s(0, 0), true),
                placed(jet.s(1, 0), false),
                placed(jet.s(0, 1), false),
                placed(twice(jet.s(2, 0)), false),
                placed(jet.s(1, 1), false),
                placed(twice(jet.s(0, 2)), false),
                {Interval(0), Interval(0)},
                Interval(0),
                Interval(0),
                Interval(0)};
    const std::array<Interval, 3> r = minus(e.s, point);
    e.f = {dot_form(r, e.u), dot_form(r, e.v)};
    e.a = dot_form(e.u, e.u) + dot_form(r, e.uu);
    e.b = dot_form(e.u, e.v) + dot_form(r, e.uv);
    e.c = dot_form(e.v, e.v) + dot_form(r, e.vv);
    return e;
  }

  // The solution of (a, b; b, c) x = (f, g), rounded; by the first fundamental form where that is
  // not positive.
  static std::array<double, 2> solved(const Equations& e, double f, double g) {
    double a = middle(e.a), b = middle(e.b), c = middle(e.c);
    // equivalent [> -> >=, 3]: a limit without meaning to the last digit
    if (!(a > 0 && c > 0 && a * c - b * b > 1e-12 * a * c)) {
      const double tiny = 1e-300;
      a = middle(dot_form(e.u, e.u)) + tiny;
      b = middle(dot_form(e.u, e.v));
      c = middle(dot_form(e.v, e.v)) + tiny;
      if (a < 1e-20 * c) return {0, g / c};
      if (c < 1e-20 * a) return {f / a, 0};
    }
    const double d = a * c - b * b;
    return {(c * f - b * g) / d, (a * g - b * f) / d};
  }

  // Which parameters of a foot point are at an end of the domain: -1 at the first, 1 at the last.
  std::array<int, 2> at_ends(const Cad_point<2>& x) const {
    std::array<int, 2> at{};
    for (std::size_t i = 0; i < 2; ++i) at[i] = x[i] == domain_[i].first ? -1 : x[i] == domain_[i].last ? 1 : 0;
    return at;
  }

  // A box in which there is one foot point, by Krawczyk's test. At an end of the domain the
  // distance must fall beyond the end, or the foot point may lie beyond it by rounding. \pre x is
  // close to it
  std::optional<Box> foot_box(const Cad_point<2>& x, const Interval_vector<3>& point) const {
    const std::array<int, 2> at = at_ends(x);
    if (const std::optional<Box> box = foot_box(x, point, {true, true}); box && is_in_domain(*box)) return box;
    for (const std::array<bool, 2>& is_free :
         {std::array<bool, 2>{at[0] == 0, at[1] == 0}, std::array<bool, 2>{at[0] == 0, true},
          std::array<bool, 2>{true, at[1] == 0}}) {
      if (is_free[0] && is_free[1]) continue;
      const std::optional<Box> box = foot_box(x, point, is_free);
      if (!box || !is_in_domain(*box)) continue;
      const Equations e = equations(*box, point);
      bool falls = true; // the gradient of half the square of the distance is f
      for (std::size_t i = 0; i < 2; ++i)
        falls = falls && (is_free[i] || (at[i] > 0 ? e.f[i].sup() < 0 : e.f[i].inf() > 0));
      if (falls) return box;
    }
    return std::nullopt;
  }

  // Encloses the foot point among the points with the given values of the parameters that are not
  // free.
  std::optional<Box> foot_box(const Cad_point<2>& x, const Interval_vector<3>& point,
                              const std::array<bool, 2>& is_free) const {
    const Equations at = equations({Interval(x[0]), Interval(x[1])}, point);
    const double a = middle(at.a), b = middle(at.b), c = middle(at.c), d = a * c - b * b;
    std::array<double, 3> y{c / d, -b / d, a / d}; // about the inverse
    if (!is_free[0] || !is_free[1]) y = {is_free[0] ? 1 / a : 0, 0, is_free[1] ? 1 / c : 0};
    for (double n : y)
      if (!std::isfinite(n)) return std::nullopt;
    if (!(a > 0 && c > 0) || (is_free[0] && is_free[1] && !(d > 0))) return std::nullopt;
    const Box step{Interval(y[0]) * at.f[0] + Interval(y[1]) * at.f[1],
                   Interval(y[1]) * at.f[0] + Interval(y[2]) * at.f[1]};
    std::array<double, 2> radius{};
    for (std::size_t i = 0; i < 2; ++i)
      if (is_free[i]) radius[i] = 2 * magnitude(step[i]) + 1e-15 * (1 + std::fabs(x[i]));
    for (int attempt = 0; attempt < 12; ++attempt) {
      const Box delta{symmetric(radius[0]), symmetric(radius[1])},
          box{Interval(x[0]) + delta[0], Interval(x[1]) + delta[1]};
      if (!is_in_one_piece(box)) return std::nullopt;
      const Equations e = equations(box, point);
      const Box moved{(1 - (Interval(y[0]) * e.a + Interval(y[1]) * e.b)) * delta[0] -
                          (Interval(y[0]) * e.b + Interval(y[1]) * e.c) * delta[1] - step[0],
                      (1 - (Interval(y[1]) * e.b + Interval(y[2]) * e.c)) * delta[1] -
                          (Interval(y[1]) * e.a + Interval(y[2]) * e.b) * delta[0] - step[1]};
      if ((!is_free[0] || magnitude(moved[0]) < radius[0]) && (!is_free[1] || magnitude(moved[1]) < radius[1]))
        return Box{Interval(x[0]) + (is_free[0] ? moved[0] : Interval(0)),
                   Interval(x[1]) + (is_free[1] ? moved[1] : Interval(0))};
      for (double& r : radius) r *= 4;
    }
    return std::nullopt;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_FOOT_FINDER_H
