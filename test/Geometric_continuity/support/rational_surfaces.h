// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "net_of.h"
#include "random.h"

#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

// Rational patches with random numbers, in several kernels.

typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Exact;
typedef GC::Traits_3<CGAL::Epeck> Lazy;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Double;
typedef GC::Traits_3<CGAL::Epick> Filtered;
typedef std::tuple<Exact, Lazy, Filtered, Double> All_traits;
typedef std::tuple<Exact, Lazy> Exact_traits;

template <class Traits> using Patch = GC::Rational_bezier_patch<Traits>;
template <class Traits> using Spline = GC::Rational_bspline_surface<Traits>;
using GC::Patch_edge;
constexpr Patch_edge u0 = Patch_edge::u0, u1 = Patch_edge::u1, v0 = Patch_edge::v0, v1 = Patch_edge::v1;

class Random : public Random_integers<> {
public:
  // p/q with up to 40 bits over 20.
  Q rational() {
    return Q(Q(integer(-999999, 999999)) * Q(1000000) + Q(integer(0, 999999))) / Q(integer(1, 999999)) / Q(100000);
  }
  Q positive() { return Q(integer(1, 999999)) / Q(integer(1, 999999)); }
};

inline Q fraction(int p, int q) { return Q(p) / Q(q); }

// A patch with arbitrary rational numbers.
inline Patch<Exact> random_patch(Random& random, int p, int q) {
  const auto net = net_of(p + 1, q + 1, [&](int i, int j) {
    const Q x = random.rational() + Q(100 * i), y = random.rational() + Q(100 * j);
    return Exact::Point(x, y, random.rational());
  });
  const auto weights = net_of(p + 1, q + 1, [&](int, int) { return random.positive(); });
  return Patch<Exact>(net, weights, {Q(-1), Q(2)}, {Q(0), fraction(1, 3)});
}

// The nets of points and weights of a surface.
template <class Surface> auto net_points(const Surface& s) {
  return net_of(s.number_of_points_u(), s.number_of_points_v(), [&](int i, int j) { return s.control_point(i, j); });
}
template <class Surface> auto net_weights(const Surface& s) {
  return net_of(s.number_of_points_u(), s.number_of_points_v(), [&](int i, int j) { return s.weight(i, j); });
}

// The patch with all weights multiplied by a factor.
template <class Traits> Patch<Traits> with_factor(const Patch<Traits>& s, const typename Traits::FT& factor) {
  auto weights = net_weights(s);
  for (auto& row : weights)
    for (auto& w : row) w *= factor;
  return Patch<Traits>(net_points(s), weights, s.domain_u(), s.domain_v());
}
