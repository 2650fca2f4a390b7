// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EDGE_BOUNDS_H
#define CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EDGE_BOUNDS_H

#include <CGAL/Geometric_continuity/cad/internal/Maximum_enclosure.h>
#include <CGAL/Geometric_continuity/cad/internal/Side_evaluator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

/// \file Edge_bounds.h
/// Bounds of gap, angle and curvature jump of two sides on a range of the parameter; where an edge
/// is divided first, and where the normal of a surface is proved to vanish on it.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// Where the normal of a surface is proved to vanish on an edge. It is not enough that it cannot be
// told from zero, because it may turn there.
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

  // Returns whether the normal, or if asked for the derivative of the edge in the parameter plane,
  // is proved to vanish at a point of the range, or beside it by no more than the rounding of
  // curves: at the apex of a cone, the pole of a sphere, a cusp of a torus, a line of a spline that
  // is a point; and at an end of the range where the derivatives of the surface are computed
  // without an error.
  bool is_on(const Edge_range& range, bool or_derivative) const {
    const Cad_curve<2>& curve = *side_.curve;
    const Interval_vector<2> c = cad_curve_jet(curve, range.t, 0).c[0];
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
    const Cad_curve_jet<2> c = cad_curve_jet(*side_.curve, at, 1);
    if (or_derivative && is_exact_zero(c.c[1][0]) && is_exact_zero(c.c[1][1])) return true;
    const std::array<std::vector<int>, 2> spans = intersected_pieces(*side_.surface, c.c[0][0], c.c[0][1], 0, 0);
    const Cad_surface_jet jet =
        // equivalent [1 -> 2, 3]: a derivative more, which is not used
        cad_surface_jet(*side_.surface, {c.c[0][0], c.c[0][1], spans[0].front(), spans[1].front()}, 1);
    const Interval_vector<3>&u = jet.s(1, 0), &v = jet.s(0, 1);
    for (int i = 0; i < 3; ++i)
      if (!is_exact_zero(u[i] * v[(i + 1) % 3] - u[(i + 1) % 3] * v[i])) return false;
    return true;
  }

  // Returns whether the distance from the axis does, with its sign: then it has a zero.
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

// The parameter among some of a range where a function, without care, is largest.
template <class Function> double likely_maximum(const Edge_range& range, const Function& f) {
  double best = range.t.inf(), largest = -1;
  for (int i = 0; i <= 8; ++i) {
    const double t = i == 0   ? range.t.inf()
                     : i == 8 ? range.t.sup()
                              : range.t.inf() + i * 0.125 * (range.t.sup() - range.t.inf());
    if (range.t.sup() < t) continue; // where the length overflows
    const double value = f(range.half == 0 ? 0. : (t - range.middle) / range.half);
    if (value > largest) largest = value, best = t;
  }
  return best;
}
inline double rounded_value(const Taylor_model& f, double s) {
  double y = 0;
  for (int k = Taylor_model::size - 1; k >= 0; --k) y = y * s + f.c[k];
  return y;
}

// Bounds of |d|^2, from below those at a parameter that may be given.
inline Bounds_on_range square_on(const Edge_range& range, const Taylor_vector& d, const std::optional<double>& at) {
  const Taylor_model square = dot(d, d);
  if (!square.known()) return {0, 0, range.middle, false};
  const double t = at ? *at : likely_maximum(range, [&](double s) { return rounded_value(square, s); });
  const Interval s = range.place(t);
  Interval at_point = 0; // by the coordinates: their remainders are squared
  for (const Taylor_model& x : d) at_point += CGAL::square(x(s));
  double by_coordinates = 0; // closer where rounding errors prevail
  for (const Taylor_model& x : d) {
    const double m = magnitude(x.range());
    by_coordinates += m * m;
  }
  const double upper = (std::min)(square.range().sup(), by_coordinates * Taylor_model::enlarged);
  Bounds_on_range bounds{(std::max)(0., at_point.inf()), (std::max)(upper, at_point.inf()), t, true,
                         upper - at_point.inf() <= 4 * (at_point.sup() - at_point.inf())};
  bounds.least = (std::max)(0., square.range().inf());
  return bounds;
}

// Where one of several pieces is the function: what all of them allow, at one parameter the least.
inline void include(Bounds_on_range of_piece, Bounds_on_range& of_all, std::optional<double>& at) {
  if (at) {
    of_piece.lower = (std::min)(of_all.lower, of_piece.lower);
    of_piece.upper = (std::max)(of_all.upper, of_piece.upper);
    of_piece.least = (std::min)(of_all.least, of_piece.least);
  }
  of_all = of_piece;
  at = of_all.parameter;
}

// Bounds of |k1 - k2| / max(|k1|, |k2|, flat).
inline Bounds_on_range jump_on(const Edge_range& range, const Taylor_model& k1, const Taylor_model& k2, double flat,
                               const std::optional<double>& at) {
  const Taylor_model difference = k1 - k2;
  if (!difference.known()) return {0, 0, range.middle, false};
  const double t = at ? *at : likely_maximum(range, [&](double s) {
    const double x = rounded_value(k1, s), y = rounded_value(k2, s);
    return std::fabs(x - y) / (std::max)({std::fabs(x), std::fabs(y), flat, Taylor_model::tiny});
  });
  const auto smallest = [](const Interval& x) { return (std::max)({0., x.inf(), -x.sup()}); };
  const auto jump = [&](const Interval& d, const Interval& x, const Interval& y) {
    const Interval divisor((std::max)({smallest(x), smallest(y), flat}),
                           (std::max)({magnitude(x), magnitude(y), flat}));
    if (!(divisor.inf() > 0)) return Interval(0, 2);
    const Interval quotient = Interval(smallest(d), magnitude(d)) / divisor;
    return Interval((std::min)(quotient.inf(), 2.), (std::min)(quotient.sup(), 2.));
  };
  const Interval s = range.place(t), at_point = jump(difference(s), k1(s), k2(s));
  double upper = jump(difference.range(), k1.range(), k2.range()).sup();
  // where both change along the edge it is closer as |d| / max(1, |1 - d|), d = (k1 - k2) / k1, or
  // (k2 - k1) / k2 if k2 is larger
  const bool second = std::fabs(k1.c[0]) < std::fabs(k2.c[0]);
  const Taylor_model d = (second ? -difference : difference) * reciprocal(second ? k2 : k1);
  if (d.known()) {
    const Interval of_larger = d.range();
    const double divisor = (std::max)(1., smallest(1 - of_larger));
    // equivalent [0 -> 1, 1]: of the quotient only the upper end counts
    upper = (std::min)(upper, (Interval(0, magnitude(of_larger)) / Interval(divisor)).sup());
  }
  upper = (std::max)(upper, at_point.inf());
  return {at_point.inf(), upper, t, true, upper - at_point.inf() <= 4 * (at_point.sup() - at_point.inf())};
}

// Returns the ends of parts of a range in order, each once.
inline std::vector<double> in_order(std::vector<double> ends) {
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}
// Adds the knots of a curve that lie inside of a range.
template <int D> void add_knots(const Cad_curve<D>& curve, double first, double last, std::vector<double>& ends) {
  for (double k : inner_knots(curve))
    if (first < k && k < last) ends.push_back(k);
}

// The range of an edge, divided at the knots of the curves of its sides, and on both sides of the
// parameters near which a curve crosses a knot line of its surface. (What is not found here will be
// found by halving.) \pre the numbers of the sides have been checked. \throws Error
// `parameter_outside_domain`
inline std::vector<double> divided_range(std::initializer_list<const Edge_side*> sides, double first, double last) {
  std::vector<double> ends{first, last};
  for (const Edge_side* side : sides) add_knots(*side->curve, first, last, ends);
  ends = in_order(std::move(ends));
  const std::size_t pieces = ends.size();
  const double margin = (last - first) * 0x1p-40;
  for (const Edge_side* side : sides) {
    const std::array<std::vector<double>, 2> knots = inner_knots(*side->surface);
    const std::array<Cad_domain, 2> domain = cad_domain(*side->surface);
    for (double t : {first, last}) cad_domain(*side->curve).check(t, "the range of an edge");
    for (int axis = 0; axis < 2; ++axis) {
      const auto enclosed = [&](double t) { return cad_curve_jet(*side->curve, Interval(t), 0).c[0][axis]; };
      const auto coordinate = [&](double t) { return middle(enclosed(t)); };
      for (std::size_t i = 0; i < pieces; ++i) domain[axis].check(coordinate(ends[i]), "an edge on a surface");
      for (std::size_t i = 0; i + 1 < pieces && !knots[axis].empty(); ++i) {
        const double from = coordinate(ends[i]), to = coordinate(ends[i + 1]);
        for (double knot : knots[axis]) {
          if (!((std::min)(from, to) < knot && knot < (std::max)(from, to))) continue;
          double below = ends[i], above = ends[i + 1];
          for (int k = 0; k < 60; ++k) {
            const double t = below / 2 + above / 2;
            (coordinate(t) != knot && (coordinate(t) < knot) == (from < to) ? below : above) = t;
          }
          const bool exact = enclosed(above).is_same(Interval(knot));
          for (double t : {exact ? above : below - margin, exact ? above : above + margin})
            if (first < t && t < last) ends.push_back(t);
        }
      }
    }
  }
  return in_order(std::move(ends));
}

// Both sides of an edge over ranges of the parameter.
class Edge_bounds {
  typedef std::array<std::vector<Side_models>, 2> Models;
  std::array<Side_evaluator, 2> sides_;
  std::array<Vanishing_normal, 2> vanishing_;
  std::vector<double> ends_;
  Edge_quantity most_ = Edge_quantity::gap;
  mutable std::vector<std::optional<Models>> first_models_; // from each end to the next

  Models models(const Edge_range& range, Edge_quantity quantity) const {
    return {sides_[0].models(range, quantity), sides_[1].models(range, quantity)};
  }

  // On the ranges with which each question begins there is one answer to all of them.
  const Models& models(double lower, double upper, const Edge_range& range, Edge_quantity quantity,
                       std::optional<Models>& other) const {
    const std::size_t i = static_cast<std::size_t>(std::lower_bound(ends_.begin(), ends_.end(), lower) - ends_.begin());
    const bool is_first = i < ends_.size() && ends_[i] == lower && ends_[(std::min)(i + 1, ends_.size() - 1)] == upper;
    std::optional<Models>& known = is_first ? first_models_[i] : other;
    if (!known) known = models(range, is_first ? most_ : quantity);
    return *known;
  }

public:
  // \throws Error for numbers that do not fit or are not finite
  Edge_bounds(const Edge_side& a, const Edge_side& b)
      : sides_{Side_evaluator(a), Side_evaluator(b)}, vanishing_{Vanishing_normal(a), Vanishing_normal(b)} {}

  // Takes the sides for questions about quantities up to `most` that begin with the parts of a
  // range. \throws Error as divided_range()
  Edge_bounds(const Edge_side& a, const Edge_side& b, double first, double last, Edge_quantity most)
      : Edge_bounds(a, b) {
    most_ = most;
    ends_ = divided_range({&a, &b}, first, last);
    first_models_.resize(ends_.size());
  }

  // Returns the ends of the parts of the range.
  const std::vector<double>& ends() const { return ends_; }

  // Returns whether it is proved that a normal vanishes at a point of the range, or for curvatures
  // the direction of the edge.
  bool is_undefined(double lower, double upper, Edge_quantity quantity) const {
    const Edge_range range(lower, upper);
    return quantity != Edge_quantity::gap &&
           std::any_of(vanishing_.begin(), vanishing_.end(), [&](const Vanishing_normal& normal) {
             return normal.is_on(range, quantity == Edge_quantity::curvature);
           });
  }

  Bounds_on_range operator()(double lower, double upper, Edge_quantity quantity, double flat) const {
    const Edge_range range(lower, upper);
    std::optional<Models> other;
    const auto& [a, b] = models(lower, upper, range, quantity, other);
    Bounds_on_range bounds{0, 0, range.middle, false};
    const bool several = a.size() * b.size() > 1, may_jump = several && quantity != Edge_quantity::gap;
    std::optional<double> at;
    // the largest of what all combinations of pieces allow, at one parameter the least
    for (const Side_models& x : a)
      for (const Side_models& y : b) {
        const Bounds_on_range of_pieces = quantity == Edge_quantity::gap ? square_on(range, x.point - y.point, at)
                                          : quantity == Edge_quantity::angle
                                              ? square_on(range, x.normal - y.normal, at)
                                              : jump_on(range, x.curvature, y.curvature, flat, at);
        // equivalent [false -> true, 2]: whether bounds are noisy is not asked where there are
        //   none
        if (!of_pieces.defined) return {0, 0, range.middle, false, false, may_jump};
        include(of_pieces, bounds, at);
      }
    if (several) bounds.noisy = a[0].along_knots || b[0].along_knots;
    bounds.knots = may_jump && !bounds.noisy;
    return bounds;
  }

  // The point of the first side, rounded.
  Cad_point<3> point(double t) const {
    const std::vector<Side_models> models = sides_[0].models(Edge_range(t, t), Edge_quantity::gap);
    if (models.empty()) return {};
    const Taylor_vector& p = models[0].point;
    return {p[0].c[0], p[1].c[0], p[2].c[0]};
  }
};

// Bounds the distance of a side of an edge from the edge as a curve in space, on ranges of the
// parameter.
class Distance_bounds {
  Side_evaluator side_;
  Placed_curve curve_;
  std::vector<double> ends_;

public:
  // \throws Error as divided_range()
  Distance_bounds(const Edge_side& side, const Edge_curve& curve, double first, double last)
      : side_(side), curve_(curve) {
    for (double t : {first, last}) cad_domain(*curve.curve).check(t, "the range of an edge");
    ends_ = divided_range({&side}, first, last);
    add_knots(*curve.curve, first, last, ends_);
    ends_ = in_order(std::move(ends_));
  }

  // Returns the ends of the parts into which the range is divided first.
  const std::vector<double>& ends() const { return ends_; }

  // Returns bounds of the square of the distance at equal parameters.
  Bounds_on_range operator()(double lower, double upper) const {
    const Edge_range range(lower, upper);
    const Taylor_vector points = curve_.models(range);
    Bounds_on_range bounds{0, 0, range.middle, false};
    std::optional<double> at;
    for (const Side_models& x : side_.models(range, Edge_quantity::gap)) {
      const Bounds_on_range of_piece = square_on(range, x.point - points, at);
      if (!of_piece.defined) return of_piece;
      include(of_piece, bounds, at);
    }
    return bounds;
  }

  // Returns the point of the curve, rounded.
  Cad_point<3> point(double t) const { return curve_.point(t); }
};

// Bounds the curvature of an edge as a curve in space, on ranges of the parameter.
class Curvature_bounds {
  Placed_curve curve_;
  std::vector<double> ends_;

public:
  // \throws Error `parameter_outside_domain`
  Curvature_bounds(const Edge_curve& curve, double first, double last) : curve_(curve), ends_{first, last} {
    for (double t : {first, last}) cad_domain(*curve.curve).check(t, "the range of an edge");
    add_knots(*curve.curve, first, last, ends_);
    ends_ = in_order(std::move(ends_));
  }

  // Returns the ends of the parts into which the range is divided first.
  const std::vector<double>& ends() const { return ends_; }

  // Returns bounds of the square of the curvature |c' x c''| / |c'|^3.
  Bounds_on_range operator()(double lower, double upper) const {
    const Edge_range range(lower, upper);
    const Taylor_vector tangent = curve_.models(range, 1);
    const Taylor_model f = reciprocal_root(dot(tangent, tangent));
    return square_on(range, cross(tangent, curve_.models(range, 2)) * (f * f * f), std::nullopt);
  }

  // Returns the point of the curve, rounded.
  Cad_point<3> point(double t) const { return curve_.point(t); }
};

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EDGE_BOUNDS_H
