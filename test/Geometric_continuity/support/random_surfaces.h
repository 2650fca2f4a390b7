// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "rational_surfaces.h"

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>

// Surfaces of all types with random numbers of 64 bits, and with one control point moved.

using GC::Edge_direction;
template <class Traits> using Bezier = GC::Bezier_patch<Traits>;
template <class Traits> using Bspline = GC::Bspline_surface<Traits>;
typedef GC::Knot_vector<Q> Knots;

typedef std::tuple<Bezier<Exact>, Bspline<Exact>, Patch<Exact>, Spline<Exact>> Surface_types;
template <class Surface> struct Type { typedef Surface type; };

// Calls f(Type<Surface>()) for each type of surfaces.
template <class Function> void for_each_surface_type(const Function& f) {
  f(Type<Bezier<Exact>>());
  f(Type<Bspline<Exact>>());
  f(Type<Patch<Exact>>());
  f(Type<Spline<Exact>>());
}

struct Random_surfaces : Random {
  // 64 bits over 2^31
  Q number() {
    return Q(Q(integer(-2147483647, 2147483647)) * Q(2147483648.0) + Q(integer(0, 2147483647))) / Q(1 << 30) / Q(2);
  }
  Patch_edge edge() { return GC::patch_edges[integer(0, 3)]; }
  Edge_direction direction() { return coin() ? Edge_direction::same : Edge_direction::opposite; }

  // Makes a net of degree 3 x 2, over inner knots or none, not near to another one.
  std::vector<std::vector<Exact::Point>> net(int m, int n) {
    const Q size(4294967296.0);
    return net_of(m, n, [&](int i, int j) {
      const Q x = number() + Q(4 * i) * size, y = number() + Q(4 * j) * size;
      return Exact::Point(x, y, number());
    });
  }
  std::vector<std::vector<Q>> weights(int m, int n) {
    return net_of(m, n, [&](int, int) { return fraction(integer(100, 110), 100); });
  }
  std::pair<Q, Q> domain() {
    const Q a = fraction_of<Q>(-9, 9, 1, 9);
    return {a, Q(a + fraction_of<Q>(1, 9, 1, 9))};
  }
  // Cubic, so that second derivatives do not jump.
  Knots knots() {
    const std::pair<Q, Q> d = domain();
    std::vector<Knots::Knot> inner;
    Q t(0);
    for (int i = integer(0, 2); i > 0; --i)
      inner.push_back({Q(d.first + (t += fraction(1, integer(3, 5))) * (d.second - d.first)), 1});
    return Knots(3, d.first, d.second, inner);
  }

  template <class Surface> Surface surface();
};
template <> inline Bezier<Exact> Random_surfaces::surface() {
  const int m = integer(2, 4), n = integer(2, 4);
  return Bezier<Exact>{net(m, n), domain(), domain()};
}
template <> inline Bspline<Exact> Random_surfaces::surface() {
  const Knots u = knots(), v = knots();
  return Bspline<Exact>(net(u.number_of_coefficients(), v.number_of_coefficients()), u, v);
}
template <> inline Patch<Exact> Random_surfaces::surface() {
  const int m = integer(2, 4), n = integer(2, 4);
  return Patch<Exact>(net(m, n), weights(m, n), domain(), domain());
}
template <> inline Spline<Exact> Random_surfaces::surface() {
  const Knots u = knots(), v = knots();
  const int m = u.number_of_coefficients(), n = v.number_of_coefficients();
  return Spline<Exact>(net(m, n), weights(m, n), u, v);
}

// With one control point of the layer j moved by the least number of 64 bits.
template <class Points> void move_point(Points& net, int i, int j) {
  const Exact::Point p = net[i][j];
  net[i][j] = Exact::Point(p.x(), p.y(), p.z() + Q(1) / Q(1 << 30) / Q(2));
}
inline Bezier<Exact> moved(const Bezier<Exact>& s, int i, int j) {
  auto net = net_points(Patch<Exact>(s));
  move_point(net, i, j);
  return Bezier<Exact>(net, s.domain_u(), s.domain_v());
}
inline Bspline<Exact> moved(const Bspline<Exact>& s, int i, int j) {
  auto net = net_points(s);
  move_point(net, i, j);
  return Bspline<Exact>(net, s.knots_u(), s.knots_v());
}
inline Patch<Exact> moved(const Patch<Exact>& s, int i, int j) {
  return Patch<Exact>(net_points(Patch<Exact>(moved(s.unweighted(), i, j))), net_weights(s), s.domain_u(),
                      s.domain_v());
}
inline Spline<Exact> moved(const Spline<Exact>& s, int i, int j) {
  return Spline<Exact>(net_points(moved(s.unweighted(), i, j)), net_weights(s), s.knots_u(), s.knots_v());
}

// The order along two whole edges, otherwise -2.
template <class A, class B> int whole_edge_order(const A& a, Patch_edge ea, const B& b, Patch_edge eb) {
  const auto edge = edge_continuity(a, ea, b, eb);
  return edge.whole_a && edge.whole_b ? edge.g_order : -2;
}
