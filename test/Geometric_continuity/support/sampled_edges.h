// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

// Gap, angle and curvature jump of two sides at one parameter, by numbers that carry their first
// and second derivatives by two variables: the formulas of the surfaces as they are documented, and
// the recursive definition of B-splines.

#include <CGAL/Geometric_continuity/cad/Cad_geometry.h>

#include "test.h"

#include <variant>

namespace sampled_edges {

// A value and its derivatives by x, y, xx, xy, yy.
template <class FT> struct Dual {
  FT f, x, y, xx, xy, yy;
  Dual(FT value = 0) : f(value), x(0), y(0), xx(0), xy(0), yy(0) {}
  Dual(FT f, FT x, FT y, FT xx, FT xy, FT yy) : f(f), x(x), y(y), xx(xx), xy(xy), yy(yy) {}
  // g(*this) with g, g', g''
  Dual of(FT g, FT d, FT e) const {
    return {g, FT(d * x), FT(d * y), FT(d * xx + e * x * x), FT(d * xy + e * x * y), FT(d * yy + e * y * y)};
  }
  friend Dual operator+(const Dual& a, const Dual& b) {
    return {FT(a.f + b.f), FT(a.x + b.x), FT(a.y + b.y), FT(a.xx + b.xx), FT(a.xy + b.xy), FT(a.yy + b.yy)};
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {FT(a.f * b.f),
            FT(a.x * b.f + a.f * b.x),
            FT(a.y * b.f + a.f * b.y),
            FT(a.xx * b.f + 2 * a.x * b.x + a.f * b.xx),
            FT(a.xy * b.f + a.x * b.y + a.y * b.x + a.f * b.xy),
            FT(a.yy * b.f + 2 * a.y * b.y + a.f * b.yy)};
  }
  friend Dual operator-(const Dual& a, const Dual& b) { return a + Dual(FT(-1)) * b; }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const FT i = FT(1) / b.f;
    return a * b.of(i, FT(-i * i), FT(2 * i * i * i));
  }
};
template <class FT> Dual<FT> cosine(const Dual<FT>& t) { return t.of(std::cos(t.f), -std::sin(t.f), -std::cos(t.f)); }
template <class FT> Dual<FT> sine(const Dual<FT>& t) { return t.of(std::sin(t.f), std::cos(t.f), -std::sin(t.f)); }

// The functions of the numbers span-degree to span by their recursive definition; `t` lies in the
// piece `span`, also where it is its end.
template <class FT> std::vector<Dual<FT>> basis(const std::vector<double>& k, int span, int degree, const Dual<FT>& t) {
  std::vector<Dual<FT>> b(degree + 2);
  b[degree] = Dual<FT>(FT(1));
  for (int d = 1; d <= degree; ++d)
    for (int i = degree - d; i <= degree; ++i) {
      const int j = span - degree + i;
      Dual<FT> sum;
      if (k[j] < k[j + d]) sum = (t - Dual<FT>(FT(k[j]))) / Dual<FT>(FT(k[j + d]) - FT(k[j])) * b[i];
      if (k[j + 1] < k[j + d + 1])
        sum = sum + (Dual<FT>(FT(k[j + d + 1])) - t) / Dual<FT>(FT(k[j + d + 1]) - FT(k[j + 1])) * b[i + 1];
      b[i] = sum;
    }
  return b;
}
template <class FT> int span_of(const std::vector<double>& k, int degree, const FT& t) {
  int span = degree;
  const int points = static_cast<int>(k.size()) - degree - 1;
  for (int s = degree; s < points; ++s)
    if (k[s] < k[s + 1] && FT(k[s]) <= t) span = s;
  return span;
}

template <class FT, int D> using Vector = std::array<Dual<FT>, D>;

template <class FT, int D> Vector<FT, D> curve_point(const GC::Cad_curve<D>& curve, const Dual<FT>& t) {
  Vector<FT, D> p;
  if (const auto* line = std::get_if<GC::Cad_line<D>>(&curve)) {
    for (int i = 0; i < D; ++i) p[i] = Dual<FT>(line->origin[i]) + t * Dual<FT>(line->direction[i]);
  } else if (const auto* s = std::get_if<GC::Cad_spline_curve<D>>(&curve)) {
    const int span = span_of(s->knots, s->degree, t.f);
    const std::vector<Dual<FT>> functions = basis(s->knots, span, s->degree, t);
    Dual<FT> w;
    for (int i = 0; i <= s->degree; ++i) {
      const int j = span - s->degree + i;
      const Dual<FT> b = functions[i] * Dual<FT>(s->weights.empty() ? FT(1) : FT(s->weights[j]));
      w = w + b;
      for (int k = 0; k < D; ++k) p[k] = p[k] + b * Dual<FT>(s->points[j][k]);
    }
    for (int i = 0; i < D; ++i) p[i] = p[i] / w;
  } else if constexpr (std::is_floating_point_v<FT>) {
    const auto& c = std::get<GC::Cad_conic<D>>(curve);
    typedef typename GC::Cad_conic<D>::Kind Kind;
    Dual<FT> x = Dual<FT>(c.a) * cosine(t), y = Dual<FT>(c.b) * sine(t);
    if (c.kind == Kind::hyperbola) {
      x = Dual<FT>(c.a) * t.of(std::cosh(t.f), std::sinh(t.f), std::cosh(t.f));
      y = Dual<FT>(c.b) * t.of(std::sinh(t.f), std::cosh(t.f), std::sinh(t.f));
    } else if (c.kind == Kind::parabola) {
      x = t * t / Dual<FT>(FT(4) * FT(c.a));
      y = t;
    }
    for (int i = 0; i < D; ++i) p[i] = Dual<FT>(c.centre[i]) + x * Dual<FT>(c.x_axis[i]) + y * Dual<FT>(c.y_axis[i]);
  } else {
    std::abort();
  }
  return p;
}

template <class FT> Vector<FT, 3> surface_point(const GC::Cad_surface& surface, const Dual<FT>& u, const Dual<FT>& v) {
  Vector<FT, 3> p;
  const auto add = [&](const Dual<FT>& factor, const GC::Cad_point<3>& x) {
    for (int i = 0; i < 3; ++i) p[i] = p[i] + factor * Dual<FT>(x[i]);
  };
  if (const auto* s = std::get_if<GC::Cad_spline_surface>(&surface)) {
    const int us = span_of(s->u_knots, s->u_degree, u.f), vs = span_of(s->v_knots, s->v_degree, v.f);
    const std::vector<Dual<FT>> in_u = basis(s->u_knots, us, s->u_degree, u),
                                in_v = basis(s->v_knots, vs, s->v_degree, v);
    Dual<FT> w;
    for (int i = 0; i <= s->u_degree; ++i)
      for (int j = 0; j <= s->v_degree; ++j) {
        const int index = (us - s->u_degree + i) * s->v_points() + vs - s->v_degree + j;
        const Dual<FT> b = in_u[i] * in_v[j] * Dual<FT>(s->weights.empty() ? FT(1) : FT(s->weights[index]));
        w = w + b;
        add(b, s->points[index]);
      }
    for (int i = 0; i < 3; ++i) p[i] = p[i] / w;
  } else if (const auto* x = std::get_if<GC::Cad_extrusion>(&surface)) {
    p = curve_point<FT, 3>(x->profile, u);
    add(v, x->direction);
  } else if constexpr (std::is_floating_point_v<FT>) {
    if (const auto* r = std::get_if<GC::Cad_revolution>(&surface)) {
      const GC::Cad_point<3>& d = r->direction;
      Vector<FT, 3> w = curve_point<FT, 3>(r->profile, v);
      for (int i = 0; i < 3; ++i) w[i] = w[i] - Dual<FT>(r->origin[i]);
      const Dual<FT> h = w[0] * Dual<FT>(d[0]) + w[1] * Dual<FT>(d[1]) + w[2] * Dual<FT>(d[2]);
      for (int i = 0; i < 3; ++i) {
        const Dual<FT> along = h * Dual<FT>(d[i]),
                       across = Dual<FT>(d[(i + 1) % 3]) * w[(i + 2) % 3] - Dual<FT>(d[(i + 2) % 3]) * w[(i + 1) % 3];
        p[i] = Dual<FT>(r->origin[i]) + along + cosine(u) * (w[i] - along) + sine(u) * across;
      }
      return p;
    }
    const auto& e = std::get<GC::Cad_elementary_surface>(surface);
    typedef GC::Cad_elementary_surface::Kind Kind;
    const Dual<FT> r(e.radius), q(e.other);
    Dual<FT> rho = r, z = v;
    add(Dual<FT>(1), e.frame.origin);
    if (e.kind == Kind::plane) {
      add(u, e.frame.x_axis);
      add(v, e.frame.y_axis);
      return p;
    }
    if (e.kind == Kind::cone) rho = r + v * sine(q), z = v * cosine(q);
    if (e.kind == Kind::sphere) rho = r * cosine(v), z = r * sine(v);
    if (e.kind == Kind::torus) rho = r + q * cosine(v), z = q * sine(v);
    add(rho * cosine(u), e.frame.x_axis);
    add(rho * sine(u), e.frame.y_axis);
    add(z, e.frame.z_axis);
  } else {
    std::abort();
  }
  return p;
}

// A placed point with derivatives by u and v, and the edge's direction in the parameter plane.
template <class FT> struct Sampled_side {
  Vector<FT, 3> p;
  FT du, dv;
};
template <class FT> Sampled_side<FT> sampled_side(const GC::Edge_side& side, double at) {
  const Vector<FT, 2> c = curve_point<FT, 2>(*side.curve, Dual<FT>(FT(at), FT(1), FT(0), FT(0), FT(0), FT(0)));
  const Dual<FT> u(c[0].f, FT(1), FT(0), FT(0), FT(0), FT(0)), v(c[1].f, FT(0), FT(1), FT(0), FT(0), FT(0));
  const Vector<FT, 3> p = surface_point<FT>(*side.surface, u, v);
  Vector<FT, 3> placed;
  for (int i = 0; i < 3; ++i) {
    placed[i] = Dual<FT>(side.placement[i][3]);
    for (int j = 0; j < 3; ++j) placed[i] = placed[i] + Dual<FT>(side.placement[i][j]) * p[j];
  }
  return {placed, c[0].x, c[1].x};
}

template <class FT> FT gap_square(const GC::Edge_side& a, const GC::Edge_side& b, double t) {
  const Sampled_side<FT> x = sampled_side<FT>(a, t), y = sampled_side<FT>(b, t);
  FT sum(0);
  for (int i = 0; i < 3; ++i) {
    const FT d = x.p[i].f - y.p[i].f;
    sum += d * d;
  }
  return sum;
}

// The unit normal, the length of the normal S_u x S_v that is divided by, and the normal curvature
// across the edge: of the difference of the edge's direction and its projection.
struct Normal_and_curvature {
  std::array<long double, 3> n;
  long double length, curvature;
};
inline Normal_and_curvature normal_and_curvature(const GC::Edge_side& side, double t) {
  typedef long double FT;
  typedef std::array<FT, 3> V;
  const Sampled_side<FT> s = sampled_side<FT>(side, t);
  const auto dot = [](const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const auto cross = [](const V& a, const V& b) {
    return V{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  V su, sv, suu, suv, svv, tangent;
  for (int i = 0; i < 3; ++i) {
    su[i] = s.p[i].x, sv[i] = s.p[i].y, suu[i] = s.p[i].xx, suv[i] = s.p[i].xy, svv[i] = s.p[i].yy;
    tangent[i] = su[i] * s.du + sv[i] * s.dv;
  }
  V n = cross(su, sv);
  const FT length = std::sqrt(dot(n, n));
  const auto& m = side.placement;
  const FT determinant =
      dot({m[0][0], m[0][1], m[0][2]}, cross({m[1][0], m[1][1], m[1][2]}, {m[2][0], m[2][1], m[2][2]}));
  // w = n x tangent = a su + b sv
  const V w = cross(n, tangent), aw = cross(w, sv), bw = cross(su, w);
  const FT a = dot(aw, n) / (length * length), b = dot(bw, n) / (length * length);
  const FT sign = ((determinant < 0) != side.reversed ? -1 : 1) / length;
  for (FT& x : n) x *= sign;
  return {n, length, (a * a * dot(suu, n) + 2 * a * b * dot(suv, n) + b * b * dot(svv, n)) / dot(w, w)};
}
inline long double angle(const GC::Edge_side& a, const GC::Edge_side& b, double t) {
  const auto x = normal_and_curvature(a, t).n, y = normal_and_curvature(b, t).n;
  long double minus = 0, plus = 0;
  for (int i = 0; i < 3; ++i) minus += (x[i] - y[i]) * (x[i] - y[i]), plus += (x[i] + y[i]) * (x[i] + y[i]);
  return 2 * std::atan2(std::sqrt(minus), std::sqrt(plus));
}
inline long double curvature_jump(const GC::Edge_side& a, const GC::Edge_side& b, double t, long double flat) {
  const long double x = normal_and_curvature(a, t).curvature, y = normal_and_curvature(b, t).curvature;
  return std::fabs(x - y) / std::fmax(std::fmax(std::fabs(x), std::fabs(y)), flat);
}

} // namespace sampled_edges
