// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EXACT_ANALYTIC_EDGE_H
#define CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EXACT_ANALYTIC_EDGE_H

#include <CGAL/Geometric_continuity/cad/internal/Edge_bounds.h>
#include <CGAL/Geometric_continuity/cad/internal/Exponential_sum.h>
#include <CGAL/Geometric_continuity/cad/internal/exact_cad_geometry.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_decision.h>
#include <CGAL/Geometric_continuity/joins/internal/join_forms.h>
#include <CGAL/Geometric_continuity/numbers/internal/subdivision.h>

#include <array>
#include <optional>
#include <utility>
#include <variant>

/// \file exact_analytic_edge.h
/// Continuity along edges on which both surfaces are sums of exponential functions: the gap, the
/// tangent planes and the curvatures agree when identities hold between such sums.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

inline Exponential_vector constant_vector(const Cad_point<3>& p) {
  return {Model_number(p[0]), Model_number(p[1]), Model_number(p[2])};
}

// A curve and its first two derivatives along a linear function of the parameter.
struct Exponential_curve {
  Exponential_vector c, d, e;

  // Returns whether the curve is of a kind for which it can be computed.
  bool take(const Cad_curve<3>& curve, const Linear_function& s) {
    if (const auto* line = std::get_if<Cad_line<3>>(&curve)) {
      d = constant_vector(line->direction);
      c = constant_vector(line->origin) + Exponential_sum(s) * d;
      return true;
    }
    const auto* conic = std::get_if<Cad_conic<3>>(&curve);
    if (!conic || conic->kind != Cad_conic<3>::Kind::ellipse) return false;
    const Exponential_vector x = Exponential_sum(Model_number(conic->a)) * constant_vector(conic->x_axis),
                             y = Exponential_sum(Model_number(conic->b)) * constant_vector(conic->y_axis);
    const Exponential_sum cosine = Exponential_sum::cosine(s), sine = Exponential_sum::sine(s);
    const Exponential_vector arm = cosine * x + sine * y;
    c = constant_vector(conic->centre) + arm;
    d = cosine * y - sine * x;
    e = Exponential_vector() - arm;
    return true;
  }
};

// The derivatives of a placed surface along a curve in its parameter plane.
struct Exponential_jet {
  Exponential_vector point, u, v, uu, uv, vv;
  // equivalent [1 -> 2, 1]: any number that is not zero of an elementary surface, whose normal
  // vanishes where it does
  Exponential_sum rho = Model_number(1);

  bool take(const Edge_side& side) {
    if (!take(*side.surface, *side.curve)) return false;
    const Cad_map map(side.placement);
    const auto placed = [&](Exponential_vector& x, bool is_point) {
      Exponential_vector y;
      for (int i = 0; i < 3; ++i) {
        if (is_point) y[i] = map.shift(i);
        for (int j = 0; j < 3; ++j) y[i] = y[i] + Exponential_sum(map(i, j)) * x[j];
      }
      x = std::move(y);
    };
    placed(point, true);
    for (Exponential_vector* x : {&u, &v, &uu, &uv, &vv}) placed(*x, false);
    return true;
  }

  Exponential_vector normal() const { return cross_form(u, v); }

  // Twice the mean curvature, times |N|^3, for the normal N.
  Exponential_sum mean_curvature(const Exponential_vector& n) const {
    return dot_form(u, u) * dot_form(vv, n) + dot_form(v, v) * dot_form(uu, n) -
           Exponential_sum(Model_number(2)) * dot_form(u, v) * dot_form(uv, n);
  }

private:
  bool take(const Cad_surface& surface, const Cad_curve<2>& curve) {
    const auto* elementary = std::get_if<Cad_elementary_surface>(&surface);
    if (elementary && elementary->kind == Cad_elementary_surface::Kind::plane)
      return take_plane(elementary->frame, curve);
    const std::optional<std::array<Linear_function, 2>> line = straight_line(curve);
    if (!line) return false;
    const Linear_function &s = (*line)[0], &t = (*line)[1];
    if (elementary) {
      take_elementary(*elementary, s, t);
      return true;
    }
    if (const auto* extrusion = std::get_if<Cad_extrusion>(&surface)) {
      Exponential_curve c;
      if (!c.take(extrusion->profile, s)) return false;
      v = constant_vector(extrusion->direction);
      point = c.c + Exponential_sum(t) * v;
      u = c.d;
      uu = c.e;
      return true;
    }
    const auto* revolution = std::get_if<Cad_revolution>(&surface);
    Exponential_curve c;
    if (!revolution || !c.take(revolution->profile, t)) return false;
    take_revolution(*revolution, s, c);
    return true;
  }

  bool take_plane(const Cad_frame& f, const Cad_curve<2>& curve) {
    std::array<Exponential_sum, 2> p;
    if (const std::optional<std::array<Linear_function, 2>> line = straight_line(curve)) {
      for (int i = 0; i < 2; ++i) p[i] = (*line)[i];
    } else {
      const auto* conic = std::get_if<Cad_conic<2>>(&curve);
      if (!conic || conic->kind != Cad_conic<2>::Kind::ellipse) return false;
      const Linear_function t{Model_number(0), Model_number(1)};
      const Exponential_sum x = Exponential_sum(Model_number(conic->a)) * Exponential_sum::cosine(t),
                            y = Exponential_sum(Model_number(conic->b)) * Exponential_sum::sine(t);
      for (int i = 0; i < 2; ++i)
        p[i] = Exponential_sum(Model_number(conic->centre[i])) + x * Model_number(conic->x_axis[i]) +
               y * Model_number(conic->y_axis[i]);
    }
    u = constant_vector(f.x_axis);
    v = constant_vector(f.y_axis);
    point = constant_vector(f.origin) + p[0] * u + p[1] * v;
    return true;
  }

  // rho(v) R(u) + z(v) times the axis
  void take_elementary(const Cad_elementary_surface& surface, const Linear_function& s, const Linear_function& t) {
    typedef Cad_elementary_surface::Kind Kind;
    const Model_number r(surface.radius), q(surface.other);
    Exponential_sum z, rho_1, z_1, rho_2, z_2;
    rho = r;
    if (surface.kind == Kind::cylinder || surface.kind == Kind::cone) {
      const Linear_function angle{surface.kind == Kind::cone ? q : Model_number(0), Model_number(0)};
      rho_1 = Exponential_sum::sine(angle);
      z_1 = Exponential_sum::cosine(angle);
      rho = rho + rho_1 * Exponential_sum(t);
      z = z_1 * Exponential_sum(t);
    } else {
      const Exponential_sum radius = surface.kind == Kind::sphere ? r : q;
      const Exponential_sum x = radius * Exponential_sum::cosine(t), y = radius * Exponential_sum::sine(t);
      rho = surface.kind == Kind::sphere ? x : rho + x;
      z = y;
      rho_1 = Exponential_sum() - y;
      z_1 = x;
      rho_2 = Exponential_sum() - x;
      z_2 = rho_1;
    }
    const Exponential_sum cosine = Exponential_sum::cosine(s), sine = Exponential_sum::sine(s);
    const Exponential_vector x = constant_vector(surface.frame.x_axis), y = constant_vector(surface.frame.y_axis),
                             axis = constant_vector(surface.frame.z_axis), arm = cosine * x + sine * y,
                             turned = cosine * y - sine * x;
    point = constant_vector(surface.frame.origin) + rho * arm + z * axis;
    u = rho * turned;
    v = rho_1 * arm + z_1 * axis;
    uu = Exponential_vector() - rho * arm;
    uv = rho_1 * turned;
    vv = rho_2 * arm + z_2 * axis;
  }

  void take_revolution(const Cad_revolution& surface, const Linear_function& s, const Exponential_curve& c) {
    const Exponential_vector o = constant_vector(surface.origin), d = constant_vector(surface.direction);
    const Exponential_sum cosine = Exponential_sum::cosine(s), sine = Exponential_sum::sine(s);
    const auto along = [&](const Exponential_vector& w) { return dot_form(w, d) * d; };
    const auto arm = [&](const Exponential_vector& w) { return cosine * (w - along(w)) + sine * cross_form(d, w); };
    const auto turned = [&](const Exponential_vector& w) { return cosine * cross_form(d, w) - sine * (w - along(w)); };
    const Exponential_vector w = c.c - o;
    point = o + along(w) + arm(w);
    u = turned(w);
    uu = Exponential_vector() - arm(w);
    v = along(c.d) + arm(c.d);
    uv = turned(c.d);
    vv = along(c.e) + arm(c.e);
  }
};

// The sign of the product of two oriented normals that are parallel on the whole range; empty when
// one vanishes there, or so nearly that it is not found out. It is the same everywhere: the square
// of the difference of the unit normals is 0 or 4.
inline std::optional<int> sign_of_parallel_normals(const Edge_side& a, const Edge_side& b, double first, double last) {
  const Protect_FPU_rounding<true> rounding_upwards;
  const Edge_bounds bounds(a, b);
  std::optional<int> sign;
  Newest_first<Range> ranges;
  ranges.add({first, last});
  int evaluated = 0;
  const bool found = subdivide(ranges, [&](const Range& range) {
    const Bounds_on_range square = bounds(range.lower, range.upper, Edge_quantity::angle, 0);
    if (square.defined && square.lower > 0) sign = -1;
    if (square.defined && square.upper < 4) sign = 1;
    const bool last_one = evaluated++ == 1000;
    if (square.defined && sign) return After_part::drop;
    return last_one || !range.is_divisible() ? After_part::stop : After_part::divide;
  });
  return found ? sign : std::nullopt;
}

// The verdict where points at equal parameters are compared and angles are those of the oriented
// normals.
//
// G2 where the tangent planes agree: both shape operators map the direction of the edge to the
// derivative of the same unit normal. Their difference, a symmetric map that vanishes on this
// direction, vanishes when its trace does, the difference of the mean curvatures. With M = 2
// H |N|^3 and N_2 = r N_1 that is M_1 r^3 = M_2, where r is the quotient of two coordinates that do
// not vanish identically.
inline std::optional<Edge_continuity<Model_number>> exact_analytic_edge(const Edge_side& a, const Edge_side& b,
                                                                        double first, double last) {
  Exponential_jet x, y;
  if (!(first < last) || !x.take(a) || !y.take(b)) return std::nullopt;
  Edge_continuity<Model_number> e;
  if (!is_zero(x.point - y.point)) return e;
  e.g_order = 0;
  const Exponential_vector n = x.normal(), m = y.normal();
  if (x.point[0].derivative().is_zero() && x.point[1].derivative().is_zero() && x.point[2].derivative().is_zero()) {
    e.defect = Edge_defect::collapsed;
    e.collapsed = true;
    return e;
  }
  if (is_zero(n) || is_zero(m)) return std::nullopt;
  if (!is_zero(cross_form(n, m))) {
    e.defect = Edge_defect::crease;
    return e;
  }
  e.coplanar = true;
  if (!x.rho.sign_on(first, last) || !y.rho.sign_on(first, last)) return std::nullopt;
  const std::optional<int> sign = sign_of_parallel_normals(a, b, first, last);
  if (!sign) return std::nullopt;
  const std::pair<Model_number, Model_number> range{Model_number(first), Model_number(last)};
  if (*sign < 0) {
    e.defect = Edge_defect::fold;
    e.side = Sign_pattern::positive;
    e.deviation = Normal_deviation<Model_number>{Model_number(2), Model_number(2), range.first, range.second};
    return e;
  }
  int i = 0;
  while (n[i].is_zero()) ++i;
  const Exponential_sum left = x.mean_curvature(n) * m[i] * m[i] * m[i],
                        right = y.mean_curvature(m) * n[i] * n[i] * n[i];
  return smooth_continuity<Model_number>(left == right ? 2 : 1, range);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EXACT_ANALYTIC_EDGE_H
