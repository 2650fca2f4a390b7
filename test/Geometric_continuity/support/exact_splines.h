// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "random.h"

#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>

// Random splines in space with exact numbers.

typedef CGAL::Simple_cartesian<Q> Exact;
typedef std::tuple<CGAL::Simple_cartesian<double>, CGAL::Epick> Rounded_kernels;

template <class K> using Curve = GC::Bspline_curve<GC::Traits_3<K>>;
template <class K> using Surface = GC::Bspline_surface<GC::Traits_3<K>>;
typedef GC::Coordinate_vector<Q, 3> Vector;
typedef GC::Knot_vector<Q> Knots;
using GC::Patch_edge;

// ---------------------------------------------------------------- random input

inline Q ratio(int p, int q) { return Q(Q(p) / Q(q)); }

class Random : public Random_integers<> {
public:
  // Between -10 and 10, of 12 digits over one of three denominators: what is derived from many has
  // common denominators that do not grow with their number.
  Q number() {
    const Q numerator = Q(Q(integer(-999999, 999999)) * Q(1000000) + Q(integer(0, 999999)));
    const int denominators[] = {1, 999983, 100003};
    return Q(numerator / (Q(100003) * Q(denominators[integer(0, 2)])));
  }
  Q between(const Q& a, const Q& b) { return Q(a + (b - a) * ratio(integer(1, 999), 1000)); }
  Vector vector() {
    Vector x(3);
    for (int i = 0; i < 3; ++i) x[i] = number();
    return x;
  }
  std::vector<Vector> vectors(int n) {
    std::vector<Vector> x;
    while (n-- > 0) x.push_back(vector());
    return x;
  }

  // Clamped, on a domain anywhere, with inner knots of multiplicity 1 to `highest`.
  Knots knots(int degree, int highest) {
    const Q a = ratio(integer(-99, 99), 7);
    Q b = a;
    std::vector<Knots::Knot> inner;
    for (int i = integer(0, 3); i >= 0; --i) {
      b += coin() ? ratio(integer(1, 99), 7) : ratio(integer(1, 99), 7000000);
      if (i > 0) inner.push_back({b, integer(1, highest)});
    }
    return Knots(degree, a, b, inner);
  }
};

template <class Test> void repeat(int times, Test test) {
  Random random;
  for (int i = 0; i < times; ++i) BOOST_TEST_CONTEXT("seed " << random.seed << ", round " << i) test(random);
}

inline Exact::Point_3 point(const Vector& x) { return Exact::Point_3(x[0], x[1], x[2]); }
inline Vector column(const Exact::Point_3& p) { return GC::coordinates<GC::Traits_3<Exact>>(p); }
inline Vector column(const Exact::Vector_3& v) { return GC::coordinates<GC::Traits_3<Exact>>(v); }

inline Curve<Exact> curve(const Knots& knots, const std::vector<Vector>& x) {
  std::vector<Exact::Point_3> points;
  for (const Vector& xi : x) points.push_back(point(xi));
  return Curve<Exact>(points.begin(), points.end(), knots);
}
inline Curve<Exact> random_curve(Random& random, const Knots& knots) {
  return curve(knots, random.vectors(knots.number_of_coefficients()));
}

inline Vector cross(const Vector& x, const Vector& y) {
  Vector z(3);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    z[i] = x[j] * y[k] - x[k] * y[j];
  }
  return z;
}
inline Q det(const Vector& x, const Vector& y, const Vector& z) { return dot(cross(x, y), z); }

// Parameters in all spans, the knots and the ends.
inline std::vector<Q> parameters(const Knots& knots, Random& random) {
  std::vector<Q> u;
  for (int k : knots.spans()) {
    u.push_back(knots[k]);
    u.push_back(random.between(knots[k], knots[k + 1]));
  }
  u.push_back(knots.domain().second);
  return u;
}
