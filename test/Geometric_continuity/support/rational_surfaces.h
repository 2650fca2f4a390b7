// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

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
  std::vector<std::vector<Exact::Point>> net(p + 1);
  std::vector<std::vector<Q>> weights(p + 1);
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j <= q; ++j) {
      net[i].push_back({random.rational() + Q(100 * i), random.rational() + Q(100 * j), random.rational()});
      weights[i].push_back(random.positive());
    }
  return Patch<Exact>(net, weights, {Q(-1), Q(2)}, {Q(0), fraction(1, 3)});
}

// The patch with all weights multiplied by a factor.
template <class Traits> Patch<Traits> with_factor(const Patch<Traits>& s, const typename Traits::FT& factor) {
  std::vector<std::vector<typename Traits::Point>> net(s.degree_u() + 1);
  std::vector<std::vector<typename Traits::FT>> weights(s.degree_u() + 1);
  for (int i = 0; i <= s.degree_u(); ++i)
    for (int j = 0; j <= s.degree_v(); ++j) {
      net[i].push_back(s.control_point(i, j));
      weights[i].push_back(typename Traits::FT(factor * s.weight(i, j)));
    }
  return Patch<Traits>(net, weights, s.domain_u(), s.domain_v());
}
