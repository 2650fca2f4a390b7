// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "test.h"

#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>

// Nets of points or weights, and surfaces with numbers of other types.

// The m x n net of f(i, j).
template <class F> auto net_of(int m, int n, F f) {
  std::vector<std::vector<decltype(f(0, 0))>> net(m);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) net[i].push_back(f(i, j));
  return net;
}

// Returns the number in another type, which must have it.
template <class To, class From> To exactly(const From& x) {
  if constexpr (std::is_floating_point_v<To> && !std::is_floating_point_v<From>) {
    const To rounded = CGAL::to_double(x);
    BOOST_REQUIRE(From(rounded) == x);
    return rounded;
  } else
    return To(x);
}
template <class Traits, class Point> typename Traits::Point point_exactly(const Point& p) {
  typedef typename Traits::FT FT;
  return typename Traits::Point(exactly<FT>(p.x()), exactly<FT>(p.y()), exactly<FT>(p.z()));
}
template <class To, class From> std::pair<To, To> pair_exactly(const std::pair<From, From>& x) {
  return {exactly<To>(x.first), exactly<To>(x.second)};
}
template <class To, class From> GC::Knot_vector<To> knots_exactly(const GC::Knot_vector<From>& knots) {
  std::vector<To> u;
  for (const From& x : knots) u.push_back(exactly<To>(x));
  return GC::Knot_vector<To>(knots.degree(), u);
}
template <class Traits, class From> GC::Bezier_patch<Traits> surface_exactly(const GC::Bezier_patch<From>& s) {
  typedef typename Traits::FT FT;
  const auto point = [&](int i, int j) { return point_exactly<Traits>(s.control_point(i, j)); };
  return GC::Bezier_patch<Traits>(net_of(s.degree_u() + 1, s.degree_v() + 1, point), pair_exactly<FT>(s.domain_u()),
                                  pair_exactly<FT>(s.domain_v()));
}
template <class Traits, class From> GC::Bspline_surface<Traits> surface_exactly(const GC::Bspline_surface<From>& s) {
  typedef typename Traits::FT FT;
  const auto point = [&](int i, int j) { return point_exactly<Traits>(s.control_point(i, j)); };
  return GC::Bspline_surface<Traits>(net_of(s.number_of_points_u(), s.number_of_points_v(), point),
                                     knots_exactly<FT>(s.knots_u()), knots_exactly<FT>(s.knots_v()));
}
