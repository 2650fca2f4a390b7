// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "net_of.h"
#include "random.h"

#include <CGAL/Fraction_traits.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>

// Control nets of patches that meet along an edge, in every kernel.

typedef std::tuple<CGAL::Simple_cartesian<Q>, CGAL::Epeck, CGAL::Epick, CGAL::Simple_cartesian<double>> All_kernels;

template <class K> using Patch = GC::Bezier_patch<GC::Traits_3<K>>;
using GC::Edge_defect;
using GC::Patch_edge;
using GC::Sign_pattern;
constexpr Patch_edge u0 = Patch_edge::u0, u1 = Patch_edge::u1, v0 = Patch_edge::v0, v1 = Patch_edge::v1;

template <class FT> constexpr bool is_exact = !std::is_floating_point_v<FT>;

// -------------------------------------------------------- space curves with polynomial coordinates

typedef GC::Bernstein_polynomial<Q> Polynomial;
typedef std::array<Polynomial, 3> Curve;
typedef std::array<Q, 3> Column;
typedef std::vector<std::vector<Column>> Net;

inline Curve operator+(const Curve& a, const Curve& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Curve operator*(const Polynomial& p, const Curve& c) { return {p * c[0], p * c[1], p * c[2]}; }
inline Curve derivative(const Curve& c) { return {c[0].derivative(), c[1].derivative(), c[2].derivative()}; }
inline Curve elevated_to(const Curve& c, int n) {
  Curve r = c;
  for (Polynomial& p : r) p = p.elevated(n - p.degree());
  return r;
}
inline int degree(const Curve& c) { return std::max({c[0].degree(), c[1].degree(), c[2].degree()}); }
inline Polynomial constant(int x) { return Polynomial{Q(x)}; }
inline Polynomial line(int x, int y) { return Polynomial{Q(x), Q(y)}; }

// The net of a patch of degree 2 (or 1, without w) across its edge v = 0, with the rows c, t, w.
// Its degree along the edge is the largest of theirs, or n.
inline Net net_from_rows(const Curve& c, const Curve& t, const Curve* w = nullptr, int n = 0) {
  for (const Curve* x : {&c, &t, w})
    if (x) n = std::max(n, degree(*x));
  const Curve c_n = elevated_to(c, n), t_n = elevated_to(t, n), w_n = elevated_to(w ? *w : c, n);
  Net net(n + 1, std::vector<Column>(w ? 3 : 2));
  for (int i = 0; i <= n; ++i)
    for (int x = 0; x < 3; ++x) {
      net[i][0][x] = c_n[x][i];
      net[i][1][x] = Q(c_n[x][i] + t_n[x][i] / Q(w ? 2 : 1));
      if (w) net[i][2][x] = Q(Q(2) * net[i][1][x] - net[i][0][x] + w_n[x][i] / Q(2));
    }
  return net;
}
inline Net net_from_rows(const Curve& c, const Curve& t, const Curve& w, int n = 0) {
  return net_from_rows(c, t, &w, n);
}

inline Q denominator_of(const Q& x) {
  CGAL::Fraction_traits<Q>::Numerator_type n;
  CGAL::Fraction_traits<Q>::Denominator_type d;
  CGAL::Fraction_traits<Q>::Decompose()(x, n, d);
  return Q(d);
}

// Nets in the coordinates of a kernel. Rounded kernels take all nets times a common denominator:
// whole numbers, which must be represented exactly.
template <class K, class FT = typename K::FT> std::vector<Patch<K>> patches(const std::vector<Net>& nets) {
  Q scale(1);
  if constexpr (!is_exact<FT>)
    for (const Net& net : nets)
      for (const auto& row : net)
        for (const Column& b : row)
          for (const Q& x : b) scale *= denominator_of(Q(x * scale));
  const auto number = [&](const Q& x) { return exactly<FT>(Q(x * scale)); };
  std::vector<Patch<K>> result;
  for (const Net& net : nets)
    result.emplace_back(net_of(static_cast<int>(net.size()), static_cast<int>(net[0].size()), [&](int i, int j) {
      const Column& b = net[i][j];
      return typename K::Point_3(number(b[0]), number(b[1]), number(b[2]));
    }));
  return result;
}

class Random : public Random_integers<> {
public:
  Polynomial polynomial(int degree, int low = -4, int high = 4) {
    std::vector<Q> c;
    for (int i = 0; i <= degree; ++i) c.push_back(Q(integer(low, high)));
    return Polynomial(c);
  }
  // a curve that goes roughly in a coordinate direction, so that two of them in different
  // directions are independent
  Curve curve(int degree, int direction, int step) {
    Curve c{polynomial(degree, -1, 1), polynomial(degree, -1, 1), polynomial(degree, -1, 1)};
    std::vector<Q> x;
    for (int i = 0; i <= degree; ++i) x.push_back(Q(direction == 0 ? step * i : step));
    c[direction] = Polynomial(x);
    return c;
  }
};

// Two surfaces with the edge C: S1 with T1, W1, and S2 with T2 = p C' + q T1 and W2 = p^2 C'' + 2 p
// q T1' + q^2 W1 + r C' + s T1, which is all that G2 leaves free.
struct Connection {
  Curve c, t1, w1, t2 = c, w2 = c;

  Connection(Random& random, int degree)
      : c(random.curve(degree, 0, 9)), t1(random.curve(degree - 1, 1, 9)), w1(random.curve(degree - 1, 2, 3)) {
    const Polynomial p = random.polynomial(1), q = constant(-random.integer(1, 2)), r = random.polynomial(1);
    connect(p, q, r, random.polynomial(1));
  }

  void connect(const Polynomial& p, const Polynomial& q, const Polynomial& r, const Polynomial& s) {
    const Curve d = derivative(c);
    t2 = p * d + q * t1;
    w2 = (p * p) * derivative(d) + (constant(2) * (p * q)) * derivative(t1) + (q * q) * w1 + r * d + s * t1;
  }
  Net first() const { return net_from_rows(c, t1, w1); }
  Net second() const { return net_from_rows(c, t2, w2); }
};

// The 8 ways to put a net on the unit square, and the edge that becomes of v0.
template <class K> std::vector<std::pair<Patch<K>, Patch_edge>> placements(const Patch<K>& s) {
  std::vector<std::pair<Patch<K>, Patch_edge>> result;
  for (bool swapped : {false, true})
    for (bool in_u : {false, true})
      for (bool in_v : {false, true}) {
        Patch<K> r = s;
        if (in_u) r = r.reverse_u();
        if (in_v) r = r.reverse_v();
        result.emplace_back(swapped ? r.swap_parameters() : r, swapped ? (in_v ? u1 : u0) : (in_v ? v1 : v0));
      }
  return result;
}
