// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "net_of.h"

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>

// B-spline surfaces that are parts of one polynomial surface, or of two with a known join.

typedef CGAL::Simple_cartesian<Q> Exact;
typedef std::tuple<Exact, CGAL::Epick, CGAL::Simple_cartesian<double>> Kernels;

template <class K> using Surface = GC::Bspline_surface<GC::Traits_3<K>>;
template <class K> using Patch = GC::Bezier_patch<GC::Traits_3<K>>;
typedef Surface<Exact> S;
typedef GC::Knot_vector<Q> Knots;
using GC::Edge_defect;
using GC::Patch_edge;
constexpr Patch_edge u0 = Patch_edge::u0, u1 = Patch_edge::u1, v0 = Patch_edge::v0, v1 = Patch_edge::v1;

// ---------------------------------------------------------------- surfaces

// A polynomial surface: the coefficients of u^i v^j, i, j <= 3.
typedef std::array<std::array<std::array<int, 4>, 4>, 3> Map;

inline Map graph(const std::array<std::array<int, 4>, 4>& z) {
  Map f{};
  f[0][1][0] = 1;
  f[1][0][1] = 1;
  f[2] = z;
  return f;
}

// x = u, y = v, z = 2 u^3 v - u v^2 + 3 u^2 - u^2 v^3
inline const Map wave = graph({{{0, 0, 0, 0}, {0, 0, -1, 0}, {3, 0, 0, -1}, {0, 2, 0, 0}}});

// The blossom of u^k in degree 3 at the knots j+1, j+2, j+3.
inline Q blossom(const Knots& t, int j, int k) {
  const Q &a = t[j + 1], &b = t[j + 2], &c = t[j + 3];
  if (k == 0) return Q(1);
  if (k == 1) return Q((a + b + c) / 3);
  return k == 2 ? Q((a * b + b * c + c * a) / 3) : Q(a * b * c);
}

// Over cubic knots, with the coordinates times 9, so that whole knots give whole coordinates.
inline S spline(const Map& f, const Knots& u, const Knots& v) {
  const auto point = [&](int i, int j) {
    Q x[3];
    for (int c = 0; c < 3; ++c)
      for (int k = 0; k < 4; ++k)
        for (int l = 0; l < 4; ++l) x[c] += 9 * f[c][k][l] * blossom(u, i, k) * blossom(v, j, l);
    return Exact::Point_3(x[0], x[1], x[2]);
  };
  return S(net_of(u.number_of_coefficients(), v.number_of_coefficients(), point), u, v);
}

// With control points and knots moved.
template <class Point_map, class Knot_map> S changed(const S& s, Point_map point, Knot_map knot) {
  const auto net = net_of(s.number_of_points_u(), s.number_of_points_v(),
                          [&](int i, int j) { return Exact::Point_3(point(i, j, s.control_point(i, j))); });
  std::vector<Q> u;
  for (const Q& t : s.knots_u()) u.push_back(knot(t));
  return S(net, Knots(s.degree_u(), u), s.knots_v());
}
template <class Point_map> S with_points(const S& s, Point_map point) {
  return changed(s, point, [](const Q& t) { return t; });
}
inline S lifted(const S& s, int i, int j) {
  return with_points(s, [&](int k, int l, const Exact::Point_3& p) {
    return k == i && l == j ? Exact::Point_3(p.x(), p.y(), p.z() + 1) : p;
  });
}
inline S with_knots(const S& s, const Q& scale, const Q& shift) {
  return changed(
      s, [](int, int, const Exact::Point_3& p) { return p; }, [&](const Q& t) { return Q(scale * t + shift); });
}

// The part on [a, b] of the domain of u.
inline S part(const S& s, const Q& a, const Q& b) {
  const int order = s.degree_u() + 1;
  S r = s.clamp();
  for (const Q& t : {a, b}) r = r.insert_u(t, order - r.knots_u().multiplicity(t));
  std::vector<Q> u;
  std::vector<std::vector<Exact::Point_3>> net;
  for (int i = 0; i < r.knots_u().size(); ++i) {
    if (r.knots_u()[i] < a || b < r.knots_u()[i]) continue;
    u.push_back(r.knots_u()[i]);
    if (!(r.knots_u()[i] < b)) continue;
    net.emplace_back();
    for (int j = 0; j < r.number_of_points_v(); ++j) net.back().push_back(r.control_point(i, j));
  }
  return S(net, Knots(order - 1, u), r.knots_v());
}

// Returns the same surface in another kernel; it must be represented exactly.
template <class K> Surface<K> in(const S& s) { return surface_exactly<GC::Traits_3<K>>(s); }

inline Knots knots(const Q& a, const Q& b, const std::vector<Q>& inner = {}) {
  std::vector<Q> u(4, a);
  u.insert(u.end(), inner.begin(), inner.end());
  u.insert(u.end(), 4, b);
  return Knots(3, u);
}

// ---------------------------------------------------------------- results

inline std::mt19937_64 seeded() {
  constexpr unsigned seed = 20260721;
  BOOST_TEST_MESSAGE("seed " << seed);
  return std::mt19937_64(seed);
}
