// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "random.h"

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/swept_surfaces.h>

// Random curves, and profiles of swept surfaces.

typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Exact;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Double;
typedef GC::Traits_3<CGAL::Epick> Epick;
typedef GC::Traits_3<CGAL::Epeck> Epeck;
typedef std::tuple<Double, Epick, Epeck> Other_kernels;
typedef std::tuple<Exact, Double, Epeck> Deciding_kernels;
typedef std::tuple<Exact, Epick, Epeck, Double> All_kernels;
typedef std::tuple<Epick, Double> Double_kernels;
typedef GC::Coordinate_vector<Q, 3> Column;
typedef GC::Bezier_curve<Exact> Curve;
typedef GC::Revolution_surface_3<Curve> Revolution;
typedef GC::Extrusion_surface_3<Curve> Extrusion;
typedef Exact::Point Point;
typedef Exact::Vector Vector;
using GC::Edge_defect;
using GC::Sign_pattern;

class Random : public Random_integers<> {
public:
  Q rational() { return Q(Q(integer(-999999, 999999)) / Q(integer(1, 999999))); }
  Q positive() { return Q(Q(integer(1, 99999)) / Q(integer(1, 99999))); }
  Column column() {
    Column x(3);
    for (int i = 0; i < 3; ++i) x[i] = rational();
    return x;
  }
  Point point() { return GC::to_point<Exact>(column()); }
  Vector vector() { return GC::to_vector<Exact>(column()); }
  Curve curve(int degree) {
    std::vector<Point> points;
    for (int i = 0; i <= degree; ++i) points.push_back(point());
    const Q a = rational();
    return Curve(points.begin(), points.end(), a, Q(a + positive()));
  }
};

template <class Traits, class P> Column column(const P& p) { return GC::coordinates<Traits, Q>(p); }
inline Column column(const Point& p) { return column<Exact>(p); }
inline Column column(const Vector& v) { return column<Exact>(v); }
inline Column vec(int x, int y, int z) {
  Column c(3);
  c[0] = Q(x), c[1] = Q(y), c[2] = Q(z);
  return c;
}

// The curve on [0, 1] with a given 2-jet at its start, or at its end.
inline Curve curve_from(const Column& x, const Column& d1, const Column& d2, bool at_end = false) {
  const Q s = at_end ? Q(-1) : Q(1);
  const Column b1 = x + Q(s / Q(2)) * d1, b2 = Q(2) * b1 - x + Q(Q(1) / Q(2)) * d2;
  std::vector<Point> p;
  for (const Column& b : {x, b1, b2}) p.push_back(GC::to_point<Exact>(b));
  const Curve c(p.begin(), p.end());
  return at_end ? c.reverse() : c;
}

template <class Traits> GC::Bezier_curve<Traits> int_curve(std::initializer_list<std::array<int, 3>> rows) {
  std::vector<typename Traits::Point> p;
  for (const std::array<int, 3>& x : rows) p.emplace_back(x[0], x[1], x[2]);
  return GC::Bezier_curve<Traits>(p.begin(), p.end());
}

inline Q binomial(int n, int k) { return GC::binomial_coefficients<Q>(n)[k]; }

typedef GC::Bernstein_polynomial<Q> Polynomial;
inline Polynomial factor(const Q& root) { return Polynomial{Q(-root), Q(Q(1) - root)}; } // t - root

// A user's curve: the quarter of the unit circle in the plane y = 0 about (2, 0, 0), by a rational
// parameter in [0, 1].
struct Quarter_circle {
  typedef Exact Traits;
  std::pair<Q, Q> domain() const { return {Q(0), Q(1)}; }
  GC::Curve_jet<Exact> jet(const Q& u, int k) const {
    // cos + i sin = (1 + iu) / (1 - iu) = 2w - 1 with w = 1 / (1 - iu), of which each derivative is
    // a power
    const Q D = Q(Q(1) + u * u), x = Q(Q(1) / D), y = Q(u / D);
    Q re = Q(Q(2) * x), im = Q(Q(2) * y); // of 2 j! i^j w^(j+1)
    GC::Curve_jet<Exact> jet(3, k);
    for (int j = 0; j <= k; ++j) {
      jet[j][0] = Q(re + (j == 0 ? Q(1) : Q(0))); // 2 + cosine
      jet[j][2] = im;
      const Q before = re;
      re = Q(Q(-(j + 1)) * (re * y + im * x));
      im = Q(Q(j + 1) * (before * x - im * y));
    }
    return jet;
  }
};
