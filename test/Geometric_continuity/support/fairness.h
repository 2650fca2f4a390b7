// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>

#include "test.h"

// The fairness E = L^3 int (d kappa/ds)^2 + kappa^2 tau^2 ds by the textbook formulas of curvature
// and torsion and a dense quadrature, and pairs of curves to blend: what tests of fair blends
// share.

template <int N> using Vector = std::array<double, N>;
template <int N> double dot(const Vector<N>& x, const Vector<N>& y) {
  double sum = 0;
  for (int i = 0; i < N; ++i) sum += x[i] * y[i];
  return sum;
}
inline Vector<3> cross(const Vector<3>& x, const Vector<3>& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}
inline double cross(const Vector<2>& x, const Vector<2>& y) { return x[0] * y[1] - x[1] * y[0]; }

// (d kappa/ds)^2 + kappa^2 tau^2, from the derivatives.
inline double variation(const Vector<2>& d1, const Vector<2>& d2, const Vector<2>& d3) {
  const double g = dot<2>(d1, d1), v = std::sqrt(g);
  const double slope = (cross(d1, d3) / (v * g) - 3 * cross(d1, d2) * dot<2>(d1, d2) / (v * g * g)) / v;
  return slope * slope;
}
inline double variation(const Vector<3>& d1, const Vector<3>& d2, const Vector<3>& d3) {
  const double g = dot<3>(d1, d1), v = std::sqrt(g);
  const Vector<3> c = cross(d1, d2);
  const double length = std::sqrt(dot<3>(c, c)), curvature = length / (v * g), torsion = dot<3>(c, d3) / dot<3>(c, c);
  const double slope = (dot<3>(c, cross(d1, d3)) / (length * v * g) - 3 * length * dot<3>(d1, d2) / (v * g * g)) / v;
  return slope * slope + curvature * curvature * torsion * torsion;
}

// E of a curve of degree n with these control points, by Simpson's rule.
template <int N, std::size_t size> double fairness(const std::array<Vector<N>, size>& points, int intervals) {
  constexpr int n = static_cast<int>(size) - 1;
  std::array<Vector<N>, size> a; // coefficients of powers: binomials times differences
  double binomial = 1;
  for (int k = 0; k <= n; ++k) {
    for (int c = 0; c < N; ++c) {
      double factor = k % 2 == 0 ? 1 : -1, sum = 0;
      for (int i = 0; i <= k; ++i) {
        sum += factor * points[i][c];
        factor *= -static_cast<double>(k - i) / (i + 1);
      }
      a[k][c] = binomial * sum;
    }
    binomial *= static_cast<double>(n - k) / (k + 1);
  }
  double length = 0, integral = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double t = static_cast<double>(i) / intervals,
                 weight = (i == 0 || i == intervals ? 1 : 2 + 2 * (i % 2)) / (3. * intervals);
    Vector<N> d1{}, d2{}, d3{};
    for (int k = n; k >= 1; --k)
      for (int c = 0; c < N; ++c) {
        d1[c] = d1[c] * t + k * a[k][c];
        if (k >= 2) d2[c] = d2[c] * t + k * (k - 1) * a[k][c];
        if (k >= 3) d3[c] = d3[c] * t + k * (k - 1) * (k - 2) * a[k][c];
      }
    const double speed = std::sqrt(dot<N>(d1, d1));
    length += weight * speed;
    integral += weight * speed * variation(d1, d2, d3);
  }
  return length * length * length * integral;
}
template <class Traits, int degree> double fairness(const GC::Bezier_curve<Traits, degree>& curve) {
  constexpr int N = Traits::Dimension::value;
  std::array<Vector<N>, degree + 1> points;
  for (int j = 0; j <= degree; ++j)
    for (int c = 0; c < N; ++c) points[j][c] = curve.control_point(j)[c];
  return fairness<N>(points, 512);
}

// The end of one random cubic and the start of another.
template <class Traits> struct Pair {
  GC::Curve_jet<Traits> phi, psi;

  // With all coordinates in [-1, 1], or so that one curve leads to the other.
  Pair(std::mt19937_64& random, bool wild) : phi(cubic(random, wild, -3, true)), psi(cubic(random, wild, 2, false)) {}

private:
  static GC::Curve_jet<Traits> cubic(std::mt19937_64& random, bool wild, double from, bool at_end) {
    constexpr int N = Traits::Dimension::value;
    std::uniform_real_distribution<double> number(-1, 1);
    typename Traits::Point points[4];
    for (int i = 0; i < 4; ++i) {
      GC::Coordinate_vector<double, N> p;
      for (int c = 0; c < N; ++c) p[c] = number(random);
      if (!wild) p[0] = from + i + 0.3 * p[0];
      points[i] = GC::to_point<Traits>(p);
    }
    const GC::Bezier_curve<Traits, 3> curve(points, points + 4);
    return at_end ? curve.end_jet(3) : curve.start_jet(3);
  }
};
