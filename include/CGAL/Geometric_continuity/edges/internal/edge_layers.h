// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_LAYERS_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_LAYERS_H

#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/joins/internal/join_forms.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>

/// \file edge_layers.h
/// The control points next to an edge, in numbers of fixed length, and what floating-point numbers can refute about them.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The layers of the control net of a Bezier patch next to an edge: p[j][i] is the control point number i along the edge in
// the layer number j, of which there are min(k, across) + 1 for the order k.
template <class T> struct Edge_points {
  static constexpr int most_along = 7, most_across = 8; // the degrees that are decided in numbers of fixed length

  int along, across, layers;
  std::array<T, 3> p[3][most_along + 1];

  // Whether numbers of fixed length decide edges of these degrees.
  static bool fits(int degree_along, int degree_across) {
    return degree_along <= most_along && 1 <= degree_across && degree_across <= most_across;
  }

  void reverse() {
    for (int j = 0; j < layers; ++j) std::reverse(p[j], p[j] + along + 1);
  }
};

typedef Edge_points<double> Edge_layers;
typedef Edge_points<std::int64_t> Grid_layers;

// Edges of equal degree are the same if and only if their control points are, see also Edge_sides::align().
inline bool same_edge(const Edge_layers& a, const Edge_layers& b) {
  return std::equal(a.p[0], a.p[0] + a.along + 1, b.p[0]);
}
inline bool same_edge_reversed(const Edge_layers& a, const Edge_layers& b) {
  return std::equal(a.p[0], a.p[0] + a.along + 1,
                    std::reverse_iterator<const std::array<double, 3>*>(b.p[0] + b.along + 1));
}
inline std::optional<Edge_direction> common_direction(const Edge_layers& a, const Edge_layers& b) {
  if (a.along != b.along) return std::nullopt;
  if (same_edge(a, b)) return Edge_direction::same;
  return same_edge_reversed(a, b) ? std::optional<Edge_direction>(Edge_direction::opposite) : std::nullopt;
}
inline bool is_collapsed(const Edge_layers& a) {
  return std::all_of(a.p[0], a.p[0] + a.along + 1, [&](const std::array<double, 3>& x) { return x == a.p[0][0]; });
}

// Infinity if a coordinate is infinite or not a number, or a bound of all coordinates.
inline double size_of(const Edge_layers& a) {
  double size[3] = {0, 0, 0}, test[3] = {0, 0, 0}; // 0, or not a number
  for (int j = 0; j < a.layers; ++j)
    for (int i = 0; i <= a.along; ++i)
      for (int x = 0; x < 3; ++x) {
        size[x] = (std::max)(size[x], std::abs(a.p[j][i][x]));
        test[x] += a.p[j][i][x] - a.p[j][i][x];
      }
  if (test[0] + test[1] + test[2] != 0) return std::numeric_limits<double>::infinity();
  return (std::max)({size[0], size[1], size[2]});
}

// In units of the grid; it is invalid afterwards unless all coordinates lie on it.
inline Grid_layers on_grid(const Edge_layers& a, Grid& grid) {
  Grid_layers g;
  g.along = a.along;
  g.across = a.across;
  g.layers = a.layers;
  for (int j = 0; j < a.layers; ++j)
    for (int i = 0; i <= a.along; ++i) g.p[j][i] = grid(a.p[j][i]);
  return g;
}

// What floating-point numbers can refute: the conditions of Edge_on_grid, and of Edge_normals, at both ends of the edge,
// where they need only few control points. With u = 2^-52, which bounds the relative error of an operation in every
// rounding mode, with or without fused multiplication and addition:
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
                 b = minus(point(s2_, 1, 0), point(s1_, 0, 0)), normal = cross_form(d, a);
    const double D = largest(d), A = largest(a), B = largest(b);
    if (!in_range(D) || !in_range(A) || !in_range(B)) return false;
    if (std::abs(dot_form(normal, b)) > 0x1p-46 * (D * A * B)) return true;
    if constexpr (order == 2) {
      const int n = s1_.along, q1 = s1_.across, q2 = s2_.across;
      const Second_difference f(a, minus(point(s1_, 1, 1), point(s1_, 0, 1)));
      int i = std::abs(normal[0]) < std::abs(normal[1]) ? 1 : 0;
      if (std::abs(normal[i]) < std::abs(normal[2])) i = 2;
      const double n1 = normal[i], n2 = cross_form(d, b)[i], n3 = cross_form(b, a)[i];
      double value = 2 * n * q1 * q2 * (n3 * n2) * dot_form(normal, f.value),
             M = 2 * n * q1 * q2 * (A * B * D * B) * f.bound, bound = f.bound;
      const auto add = [&](double weight, double x, double X, const Second_difference& y) {
        value += weight * x * dot_form(normal, y.value);
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

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_LAYERS_H
