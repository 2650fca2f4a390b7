// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_CAD_SURFACE_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_CAD_SURFACE_JET_H

#include <CGAL/Geometric_continuity/edges/internal/cad_curve_jet.h>

#include <algorithm>
#include <array>
#include <type_traits>

/// \file Cad_surface_jet.h
/// The Taylor coefficients of surfaces at all parameters of a rectangle: what they are, and those of surfaces with a formula.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A rectangle of parameters, and a piece of a surface by the numbers of its spans in u and v.
struct Parameter_box {
  Interval u, v;
  int u_span, v_span;
};

// Numbers with two indices of a sum that is not too large.
template <class Number> class Triangle {
  std::array<Number, (highest_order + 1) * (highest_order + 2) / 2> x_;

public:
  Triangle() {
    if constexpr (std::is_same_v<Number, Interval>) x_.fill(Interval(0)); // vectors start as 0
  }
  Number& operator()(int i, int j) { return x_[(i + j) * (i + j + 1) / 2 + j]; }
  const Number& operator()(int i, int j) const { return x_[(i + j) * (i + j + 1) / 2 + j]; }
};

// Which derivatives are wanted: i times by u and j times by v, i + j at most `sum`.
struct Surface_orders {
  int u, v, sum;

  Surface_orders(int u, int v, int sum) : u(u), v(v), sum(sum) {}
  Surface_orders(int sum) : Surface_orders(sum, sum, sum) {}
  bool contains(int i, int j) const { return i <= u && j <= v && i + j <= sum; }
};

// Encloses the derivatives of S by u and v, i and j times, divided by i! j!, at all parameters of a box, of one piece
// of the surface, which is continued beyond its ends.
struct Cad_surface_jet {
  Triangle<Interval_vector<3>> s;
  int u_degree = highest_order, v_degree = highest_order; // those of higher numbers are zero

  // Adds a multiple of a vector.
  void add(int i, int j, const Interval& factor, const Cad_point<3>& v) {
    for (int k = 0; k < 3; ++k) s(i, j)[k] += factor * Interval(v[k]);
  }
};

inline Cad_surface_jet jet_of(const Cad_elementary_surface& surface, const Parameter_box& box,
                              const Surface_orders& order) {
  typedef Cad_elementary_surface::Kind Kind;
  const Cad_frame& f = surface.frame;
  const Interval r = surface.radius, q = surface.other;
  Cad_surface_jet jet;
  jet.add(0, 0, Interval(1), f.origin);
  if (surface.kind == Kind::plane) {
    jet.u_degree = jet.v_degree = 1;
    jet.add(0, 0, box.u, f.x_axis);
    jet.add(0, 0, box.v, f.y_axis);
    jet.add(1, 0, Interval(1), f.x_axis);
    jet.add(0, 1, Interval(1), f.y_axis);
    return jet;
  }
  // rho(v) R(u) + z(v) times the axis, by the coefficients of rho and z
  Interval_vector<highest_order + 1> rho, z;
  if (surface.kind == Kind::cylinder || surface.kind == Kind::cone) {
    jet.v_degree = 1;
    Cosine_and_sine angle{Interval(1), Interval(0)};
    if (surface.kind == Kind::cone) angle = cosine_and_sine(q);
    rho[0] = r + box.v * angle.sine;
    rho[1] = angle.sine;
    z[0] = box.v * angle.cosine;
    z[1] = angle.cosine;
  } else {
    const auto v = circle_jet(box.v);
    const Interval& radius = surface.kind == Kind::sphere ? r : q;
    for (int j = 0; j <= order.v; ++j) {
      rho[j] = radius * v[j].cosine;
      z[j] = radius * v[j].sine;
    }
    if (surface.kind == Kind::torus) rho[0] += r;
  }
  const auto u = circle_jet(box.u);
  for (int i = 0; i <= order.u; ++i)
    for (int j = 0; order.contains(i, j) && j <= jet.v_degree; ++j) {
      jet.add(i, j, rho[j] * u[i].cosine, f.x_axis);
      jet.add(i, j, rho[j] * u[i].sine, f.y_axis);
      if (i == 0) jet.add(0, j, z[j], f.z_axis);
    }
  return jet;
}

inline Cad_surface_jet jet_of(const Cad_extrusion& surface, const Parameter_box& box, const Surface_orders& order) {
  const Cad_curve_jet<3> c = cad_curve_jet(surface.profile, box.u, order.u, box.u_span);
  Cad_surface_jet jet;
  jet.v_degree = 1;
  for (int i = 0; i <= order.u; ++i) jet.s(i, 0) = c.c[i];
  jet.add(0, 0, box.v, surface.direction);
  jet.add(0, 1, Interval(1), surface.direction);
  return jet;
}

inline Cad_surface_jet jet_of(const Cad_revolution& surface, const Parameter_box& box, const Surface_orders& order) {
  const Cad_curve_jet<3> c = cad_curve_jet(surface.profile, box.v, order.v, box.v_span);
  const auto u = circle_jet(box.u);
  const Cad_point<3>& d = surface.direction;
  Cad_surface_jet jet;
  for (int j = 0; j <= order.v; ++j) {
    Interval_vector<3> w = c.c[j], along, across;
    if (j == 0)
      for (int k = 0; k < 3; ++k) w[k] -= Interval(surface.origin[k]);
    const Interval height = w[0] * Interval(d[0]) + w[1] * Interval(d[1]) + w[2] * Interval(d[2]);
    for (int k = 0; k < 3; ++k) {
      along[k] = height * Interval(d[k]);
      across[k] = Interval(d[(k + 1) % 3]) * w[(k + 2) % 3] - Interval(d[(k + 2) % 3]) * w[(k + 1) % 3];
    }
    for (int i = 0; order.contains(i, j); ++i)
      for (int k = 0; k < 3; ++k)
        jet.s(i, j)[k] = u[i].cosine * (w[k] - along[k]) + u[i].sine * across[k] + (i == 0 ? along[k] : Interval(0));
    if (j == 0)
      for (int k = 0; k < 3; ++k) jet.s(0, 0)[k] += Interval(surface.origin[k]);
  }
  return jet;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_CAD_SURFACE_JET_H
