// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_FILTER_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_FILTER_H

#include <CGAL/Geometric_continuity/edges/internal/edge_layers.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// What floating-point numbers can refute: the conditions of Edge_on_grid, and of Edge_normals, at both ends of the edge, where they need only few
// control points. With u = 2^-52, which bounds the relative error of an operation in every rounding mode, with or without
// fused multiplication and addition:
//
// - det(d, a, b) has 6 terms; in each of them three differences, two products, and at most four sums are rounded. With
//   bounds D, A, B of the coordinates the error is at most 6 ((1+u)^9 - 1) (1+u)^3 D A B < 2^-46 D A B.
// - The identity of second order has 4 * 24 terms. In each of them six first differences, one second difference (three
//   roundings with respect to the sum of the lengths of its two legs, which is the bound to take), at most seven products and
//   eight sums are rounded. The largest of the four products of bounds is M: the error is less than 96 ((1+u)^24 - 1)
//   (1+u)^20 M < 2^-40 M.
//
// All bounds lie between 2^-100 and 2^100, and factors are below 2^10, so that nothing overflows. A product that underflows
// has an error of 2^-1074, which is less than u 2^-300 times the product of the bounds of its factors, at least 2^-700;
// this is within the margins.
class Edge_filter {
  typedef std::array<double, 3> Vector;

  const Edge_layers &s1_, &s2_;
  static constexpr double least = 0x1p-100, most = 0x1p100;

public:
  // \pre the edges are the same, in one direction
  Edge_filter(const Edge_layers& s1, const Edge_layers& s2) : s1_(s1), s2_(s2) {}

  template <int order> bool refutes() const { return refutes_at<order>(false) || refutes_at<order>(true); }

private:
  static Vector minus(const Vector& v, const Vector& w) { return {v[0] - w[0], v[1] - w[1], v[2] - w[2]}; }
  static double dot(const Vector& v, const Vector& w) { return v[0] * w[0] + v[1] * w[1] + v[2] * w[2]; }
  static Vector cross(const Vector& v, const Vector& w) {
    return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
  }
  static bool in_range(double bound) { return least <= bound && bound <= most; }

  // The second difference y - x of two legs and a bound of its terms.
  struct Second_difference {
    Vector value;
    double bound;
    Second_difference(const Vector& x, const Vector& y)
        : value(minus(y, x)), bound((std::max)(least, largest(x) + largest(y))) {}
  };

  // The reversed edge has the differences d with the other sign, and so has f; all terms of the conditions are odd in d, or all
  // even, so that its start may be taken in place of the end.
  template <int order> bool refutes_at(bool end) const {
    const auto point = [&](const Edge_layers& s, int j, int i) -> const Vector& {
      return s.p[j][end ? s.along - i : i];
    };
    const Vector d = minus(point(s1_, 0, 1), point(s1_, 0, 0)), a = minus(point(s1_, 1, 0), point(s1_, 0, 0)),
                 b = minus(point(s2_, 1, 0), point(s1_, 0, 0)), normal = cross(d, a);
    const double D = largest(d), A = largest(a), B = largest(b);
    if (!in_range(D) || !in_range(A) || !in_range(B)) return false;
    if (std::abs(dot(normal, b)) > 0x1p-46 * (D * A * B)) return true;
    if constexpr (order == 2) {
      const int n = s1_.along, q1 = s1_.across, q2 = s2_.across;
      const Second_difference f(a, minus(point(s1_, 1, 1), point(s1_, 0, 1)));
      int i = std::abs(normal[0]) < std::abs(normal[1]) ? 1 : 0;
      if (std::abs(normal[i]) < std::abs(normal[2])) i = 2;
      const double n1 = normal[i], n2 = cross(d, b)[i], n3 = cross(b, a)[i];
      double value = 2 * n * q1 * q2 * (n3 * n2) * dot(normal, f.value),
             M = 2 * n * q1 * q2 * (A * B * D * B) * f.bound, bound = f.bound;
      const auto add = [&](double weight, double x, double X, const Second_difference& y) {
        value += weight * x * dot(normal, y.value);
        M = (std::max)(M, std::abs(weight) * X * y.bound);
        bound = (std::max)(bound, y.bound);
      };
      const auto across = [&](const Edge_layers& s, const Vector& leg) {
        return Second_difference(leg, minus(point(s, 2, 0), point(s, 1, 0)));
      };
      if (n > 1)
        add(q1 * q2 * (n - 1), n3 * n3, A * B * A * B, Second_difference(d, minus(point(s1_, 0, 2), point(s1_, 0, 1))));
      if (q1 > 1) add(n * q2 * (q1 - 1), n2 * n2, D * B * D * B, across(s1_, a));
      if (q2 > 1) add(-n * q1 * (q2 - 1), n1 * n1, D * A * D * A, across(s2_, b));
      return bound <= most && std::abs(value) > 0x1p-40 * (D * A * M);
    }
    return false;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_FILTER_H
