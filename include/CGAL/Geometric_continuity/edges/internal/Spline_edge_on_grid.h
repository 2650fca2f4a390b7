// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_SPLINE_EDGE_ON_GRID_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_SPLINE_EDGE_ON_GRID_H

#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_grid.h>
#include <CGAL/Geometric_continuity/numbers/internal/Fixed_integer.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

/// \file Spline_edge_on_grid.h
/// Whether B-spline surfaces with floating-point numbers continue each other twice continuously differentiably along a whole edge,
/// but for the speed of the parameter across it, as the parts of one surface do: decided for all spans at once, by the control
/// points, in integers of fixed length.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// The control points next to an edge over clamped knots, and the knots across it. With the distances h1 and h2 of the first two
// that follow the edge, from there on, and the legs a = P1 - P0 and c = P2 - P1, the rows of the derivatives across are
//   T = q a/h1,  W = q (q-1)/h1 (c/h2 - a/h1),
// coefficient by coefficient, over the knots along the edge.
template <class Field> struct Spline_side {
  typedef std::array<std::int64_t, 3> Point;

  int q;
  Field h1, h2;
  std::vector<Field> knots; // along the edge
  std::vector<std::array<double, 3>> given[3];
  std::vector<Point> p[3];

  // Whether the surface has such an edge, of a degree of at least 2 across it.
  template <class Traits> bool take(const Bspline_surface<Traits>& s, Patch_edge edge) {
    const Knot_vector<double>&along = s.knots_along(edge), &across = s.knots_across(edge);
    q = across.degree();
    if (q < 2 || along.degree() < 1 || !along.is_clamped() || !across.is_clamped()) return false;
    const int last = across.size() - 1, m = across.number_of_coefficients();
    const bool upper = at_upper_end(edge);
    const auto knot = [&](int i) { return Field(upper ? -across[last - i] : across[i]); };
    h1 = Field(knot(q + 1) - knot(q));
    h2 = Field(knot(q + 2) - knot(q));
    for (double u : along) knots.emplace_back(u);
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < along.number_of_coefficients(); ++i) {
        const int side = upper ? m - 1 - j : j;
        const Coordinates<Traits> x =
            coordinates<Traits>(runs_along_u(edge) ? s.control_point(i, side) : s.control_point(side, i));
        given[j].push_back({x[0], x[1], x[2]});
      }
    return true;
  }

  void reverse() {
    std::reverse(knots.begin(), knots.end());
    for (Field& u : knots) u = Field(-u);
    for (auto& row : given) std::reverse(row.begin(), row.end());
  }

  static Point difference(const Point& x, const Point& y) { return {x[0] - y[0], x[1] - y[1], x[2] - y[2]}; }
  std::size_t size() const { return p[0].size(); }
  Point a(std::size_t i) const { return difference(p[1][i], p[0][i]); }
  Point c(std::size_t i) const { return difference(p[2][i], p[1][i]); }
};

// T2 = -k T1 and W2 = k^2 W1 for a number k > 0. \pre the edges are the same curve in one direction
template <class Field> class Spline_edge_on_grid {
  typedef Spline_side<Field> Side;
  typedef typename Side::Point Point;

  const Side &s1_, &s2_;
  const int n_; // the degree along

public:
  Spline_edge_on_grid(const Side& s1, const Side& s2, int degree_along) : s1_(s1), s2_(s2), n_(degree_along) {}

  bool is_smooth() const {
    if (!normal_is_nowhere_zero()) return false;
    // a2 = -l a1, by the coordinate x of the first leg, which is not zero
    const Point first = s1_.a(0), second = s2_.a(0);
    int x = std::abs(first[0]) < std::abs(first[1]) ? 1 : 0;
    if (std::abs(first[x]) < std::abs(first[2])) x = 2;
    if (second[x] == 0 || (second[x] < 0) == (first[x] < 0)) return false;
    for (std::size_t i = 0; i < s1_.size(); ++i) {
      const Point a1 = s1_.a(i), a2 = s2_.a(i);
      for (int y = 0; y < 3; ++y)
        if (Signed_128(a2[y]) * first[x] != Signed_128(a1[y]) * second[x]) return false;
    }
    return second_order(Field(Field(static_cast<double>(-second[x])) / Field(static_cast<double>(first[x]))));
  }

private:
  // By one coordinate of all products of first differences d of the edge and legs a whose basis functions overlap.
  bool normal_is_nowhere_zero() const {
    const std::size_t m = s1_.size(), n = static_cast<std::size_t>(n_);
    for (int x = 0; x < 3; ++x) {
      const int y = (x + 1) % 3, z = (x + 2) % 3;
      int signs[3] = {0, 0, 0};
      for (std::size_t i = 0; i + 1 < m; ++i) {
        const Point d = Side::difference(s1_.p[0][i + 1], s1_.p[0][i]);
        for (std::size_t j = i < n ? 0 : i - n; j <= (std::min)(m - 1, i + n); ++j) {
          const Point a = s1_.a(j);
          const Signed_128 product = Signed_128(d[y]) * a[z] - Signed_128(d[z]) * a[y];
          ++signs[product < 0 ? 0 : product == 0 ? 1 : 2];
        }
      }
      if (signs[1] == 0 && (signs[0] == 0 || signs[2] == 0)) return true;
    }
    return false;
  }

  // W2 = k^2 W1 with a2 = -l a1, hence k = l q2 h1/(q1 h1'), is f c2 = g c1 + e a1 with the numbers f, g, e below.
  bool second_order(const Field& l) const {
    const Field q1(s1_.q), q2(s2_.q), k = Field(Field(l * q2 * s1_.h1) / Field(q1 * s2_.h1)), square = Field(k * k),
                                      w1 = Field(q1 * (q1 - Field(1))), w2 = Field(q2 * (q2 - Field(1)));
    const Field numbers[3] = {
        Field(w2 / Field(s2_.h1 * s2_.h2)), Field(Field(square * w1) / Field(s1_.h1 * s1_.h2)),
        Field(-Field(Field(square * w1) / Field(s1_.h1 * s1_.h1)) - Field(Field(w2 * l) / Field(s2_.h1 * s2_.h1)))};
    Common_denominator<Field> denominator;
    for (const Field& x : numbers) denominator.include(x);
    std::int64_t factors[3];
    for (int i = 0; i < 3; ++i) {
      const double x = CGAL::to_double(denominator.numerator(numbers[i]));
      if (!(std::abs(x) <= 0x1p50)) return false; // below that it is exact
      factors[i] = static_cast<std::int64_t>(x);
    }
    for (std::size_t i = 0; i < s1_.size(); ++i) {
      const Point a1 = s1_.a(i), c1 = s1_.c(i), c2 = s2_.c(i);
      for (int y = 0; y < 3; ++y)
        if (Signed_128(factors[0]) * c2[y] != Signed_128(factors[1]) * c1[y] + Signed_128(factors[2]) * a1[y])
          return false;
    }
    return true;
  }
};

// The direction of the second edge, if the edges are the same curve and the surfaces continue each other as above. Empty where that
// is not proved.
template <class Traits>
std::optional<Edge_direction> smooth_spline_edge(const Bspline_surface<Traits>& a, Patch_edge edge_a,
                                                 const Bspline_surface<Traits>& b, Patch_edge edge_b) {
  typedef Edge_field<Traits> Field;
  const int n = a.knots_along(edge_a).degree();
  if (b.knots_along(edge_b).degree() != n) return std::nullopt;
  Spline_side<Field> s1, s2;
  if (!s1.take(a, edge_a) || !s2.take(b, edge_b) || s1.knots.size() != s2.knots.size()) return std::nullopt;
  if (s1.given[0].front() == s1.given[0].back()) return std::nullopt; // it may be closed, and the same backwards
  Edge_direction direction = Edge_direction::same;
  if (s1.given[0] != s2.given[0]) {
    direction = Edge_direction::opposite;
    s2.reverse();
    if (s1.given[0] != s2.given[0]) return std::nullopt;
  }
  const Field length1 = Field(s1.knots.back() - s1.knots.front()), length2 = Field(s2.knots.back() - s2.knots.front());
  const std::size_t last = s1.knots.size() - 1;
  for (std::size_t i = 1; i < last; ++i) // the affine map of the domains maps the knots
    if (Field(length2 * Field(s1.knots[i] - s1.knots[0])) != Field(length1 * Field(s2.knots[i] - s2.knots[0])))
      return std::nullopt;
  for (const auto& knot : a.knots_along(edge_a).inner_knots())
    if (knot.multiplicity > n) return std::nullopt; // the edge may have a gap there
  double size = 0;
  for (const Spline_side<Field>* s : {&s1, &s2})
    for (const auto& row : s->given)
      for (const auto& x : row) size = (std::max)(size, largest(x));
  Grid grid(size);
  if (!grid.valid()) return std::nullopt;
  for (Spline_side<Field>* s : {&s1, &s2})
    for (int j = 0; j < 3; ++j)
      for (const auto& x : s->given[j]) s->p[j].push_back(grid(x));
  if (!grid.valid() || !Spline_edge_on_grid<Field>(s1, s2, n).is_smooth()) return std::nullopt;
  return direction;
}

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_SPLINE_EDGE_ON_GRID_H
