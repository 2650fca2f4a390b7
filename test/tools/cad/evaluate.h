// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <CGAL/Geometric_continuity/cad/Cad_geometry.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// Plain floating-point evaluation of curves and surfaces by the formulas of Cad_geometry.h.

namespace GC = CGAL::Geometric_continuity;

template <std::size_t D> std::array<double, D> plus(std::array<double, D> p, double s, const std::array<double, D>& d) {
  for (std::size_t i = 0; i < D; ++i) p[i] += s * d[i];
  return p;
}
inline GC::Cad_point<3> cross(const GC::Cad_point<3>& a, const GC::Cad_point<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <std::size_t D> double dot(const std::array<double, D>& a, const std::array<double, D>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < D; ++i) sum += a[i] * b[i];
  return sum;
}

// The values of the basis functions at t, by the recursion of Cox and de Boor; beyond the domain
// those of the next piece.
inline std::vector<double> basis(int degree, const std::vector<double>& knots, double t) {
  const std::size_t p = static_cast<std::size_t>(degree), n = knots.size() - p - 1;
  std::size_t span = p;
  while (span + 1 < n && knots[span + 1] <= t) ++span;
  while (knots[span] == knots[span + 1]) --span;
  std::vector<double> b(n + p, 0);
  b[span] = 1;
  for (std::size_t k = 1; k <= p; ++k)
    for (std::size_t i = span - k; i <= span; ++i) {
      const double left = i > span - k ? (t - knots[i]) / (knots[i + k] - knots[i]) * b[i] : 0,
                   right = i < span ? (knots[i + k + 1] - t) / (knots[i + k + 1] - knots[i + 1]) * b[i + 1] : 0;
      b[i] = left + right;
    }
  b.resize(n);
  return b;
}

template <int D> GC::Cad_point<D> value(const GC::Cad_curve<D>& curve, double t);

template <int D> GC::Cad_point<D> value_of(const GC::Cad_line<D>& c, double t) {
  return plus(c.origin, t, c.direction);
}
template <int D> GC::Cad_point<D> value_of(const GC::Cad_conic<D>& c, double t) {
  typedef typename GC::Cad_conic<D>::Kind Kind;
  const double x = c.kind == Kind::ellipse     ? c.a * std::cos(t)
                   : c.kind == Kind::hyperbola ? c.a * std::cosh(t)
                                               : t * t / (4 * c.a),
               y = c.kind == Kind::ellipse     ? c.b * std::sin(t)
                   : c.kind == Kind::hyperbola ? c.b * std::sinh(t)
                                               : t;
  return plus(plus(c.centre, x, c.x_axis), y, c.y_axis);
}
template <int D> GC::Cad_point<D> value_of(const GC::Cad_spline_curve<D>& c, double t) {
  const std::vector<double> b = basis(c.degree, c.knots, t);
  GC::Cad_point<D> sum{};
  double weight = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const double w = b[i] * (c.weights.empty() ? 1 : c.weights[i]);
    sum = plus(sum, w, c.points[i]);
    weight += w;
  }
  for (double& x : sum) x /= weight;
  return sum;
}
// The derivative by a difference, which is good enough for offsets here.
template <int D> GC::Cad_point<D> value_of(const GC::Cad_offset_curve<D>& c, double t) {
  const double h = 1e-5;
  const GC::Cad_point<D> d = plus(value<D>(*c.basis, t + h), -1, value<D>(*c.basis, t - h));
  GC::Cad_point<D> n{};
  if constexpr (D == 2)
    n = {d[1], -d[0]};
  else
    n = cross(d, c.reference);
  return plus(value<D>(*c.basis, t), c.distance / std::sqrt(dot(n, n)), n);
}
template <int D> GC::Cad_point<D> value(const GC::Cad_curve<D>& curve, double t) {
  return std::visit([t](const auto& c) { return value_of(c, t); }, curve);
}

inline GC::Cad_point<3> value(const GC::Cad_surface& surface, double u, double v);

inline GC::Cad_point<3> value_of(const GC::Cad_elementary_surface& s, double u, double v) {
  typedef GC::Cad_elementary_surface::Kind Kind;
  const GC::Cad_frame& f = s.frame;
  if (s.kind == Kind::plane) return plus(plus(f.origin, u, f.x_axis), v, f.y_axis);
  const double r = s.radius, q = s.other,
               distance = s.kind == Kind::cylinder ? r
                          : s.kind == Kind::cone   ? r + v * std::sin(q)
                          : s.kind == Kind::sphere ? r * std::cos(v)
                                                   : r + q * std::cos(v),
               height = s.kind == Kind::cylinder ? v
                        : s.kind == Kind::cone   ? v * std::cos(q)
                        : s.kind == Kind::sphere ? r * std::sin(v)
                                                 : q * std::sin(v);
  return plus(plus(plus(f.origin, distance * std::cos(u), f.x_axis), distance * std::sin(u), f.y_axis), height,
              f.z_axis);
}
inline GC::Cad_point<3> value_of(const GC::Cad_spline_surface& s, double u, double v) {
  const std::vector<double> a = basis(s.u_degree, s.u_knots, u), b = basis(s.v_degree, s.v_knots, v);
  GC::Cad_point<3> sum{};
  double weight = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) {
      const double w = a[i] * b[j] * (s.weights.empty() ? 1 : s.weights[i * b.size() + j]);
      sum = plus(sum, w, s.points[i * b.size() + j]);
      weight += w;
    }
  for (double& x : sum) x /= weight;
  return sum;
}
inline GC::Cad_point<3> value_of(const GC::Cad_extrusion& s, double u, double v) {
  return plus(value<3>(s.profile, u), v, s.direction);
}
inline GC::Cad_point<3> value_of(const GC::Cad_revolution& s, double u, double v) {
  const GC::Cad_point<3> w = plus(value<3>(s.profile, v), -1, s.origin);
  const double along = dot(w, s.direction);
  const GC::Cad_point<3> across = plus(w, -along, s.direction);
  return plus(plus(plus(s.origin, along, s.direction), std::cos(u), across), std::sin(u), cross(s.direction, w));
}
inline GC::Cad_point<3> value_of(const GC::Cad_offset_surface& s, double u, double v) {
  const double h = 1e-5;
  const GC::Cad_point<3> du = plus(value(*s.basis, u + h, v), -1, value(*s.basis, u - h, v)),
                         dv = plus(value(*s.basis, u, v + h), -1, value(*s.basis, u, v - h)), n = cross(du, dv);
  return plus(value(*s.basis, u, v), s.distance / std::sqrt(dot(n, n)), n);
}
inline GC::Cad_point<3> value(const GC::Cad_surface& surface, double u, double v) {
  return std::visit([u, v](const auto& s) { return value_of(s, u, v); }, surface);
}
