// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_ON_GRID_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_ON_GRID_H

#include <CGAL/Geometric_continuity/algebra/internal/Bounded_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/internal/Rounded_polynomial.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_equations.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_input.h>
#include <CGAL/Geometric_continuity/numbers/internal/Fixed_integer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

/// \file Edge_on_grid.h
/// The conditions of Edge_equations.h in integers of fixed length: polynomials along the edge, with
/// a ratio of the tangent planes in short numbers or without. How long the integers are follows
/// from the degrees of the forms (Bounded_polynomial).

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// Tangent planes that agree: with the first differences d along the edge, a and b across it
// (polynomials of the degrees n - 1, n and n), alpha b = gamma d + beta a for a linear polynomial
// gamma with the values gamma[0], gamma[1] at the ends. If the coordinates of d x a have no common
// factor, the tangent planes agree if and only if there are such numbers: d x b and b x a are
// polynomials of the degrees 2n - 1 and 2n, which d x a of degree 2n - 1 then divides.
struct Edge_ratio {
  static constexpr int bits = 12;
  static constexpr std::int64_t most = (std::int64_t(1) << bits) - 1;

  std::int64_t alpha, beta, gamma[2]; // alpha > 0, and none is larger than `most`
  int pivot;                          // the largest coordinate of d x a at the start

  // If there are short numbers. The control points are whole numbers of at most 2^53.
  static std::optional<Edge_ratio> find(const Grid_layers& s1, const Grid_layers& s2) {
    const int n = s1.along;
    Edge_ratio r;
    double q, p[2];
    if (!solve(s1, s2, 0, 0, q, p[0], r.pivot)) return std::nullopt;
    int other;
    double same;
    if (!solve(s1, s2, n, n - 1, same, p[1], other)) return std::nullopt;
    std::int64_t denominator[3];
    if (!short_fraction(q, r.beta, denominator[0]) || !short_fraction(p[0], r.gamma[0], denominator[1]) ||
        !short_fraction(p[1], r.gamma[1], denominator[2]))
      return std::nullopt;
    r.alpha = std::lcm(std::lcm(denominator[0], denominator[1]), denominator[2]);
    if (r.alpha > most) return std::nullopt;
    r.beta *= r.alpha / denominator[0];
    r.gamma[0] *= r.alpha / denominator[1];
    r.gamma[1] *= r.alpha / denominator[2];
    if (std::abs(r.beta) > most || std::abs(r.gamma[0]) > most || std::abs(r.gamma[1]) > most) return std::nullopt;
    return r.holds(s1, s2) ? std::optional<Edge_ratio>(r) : std::nullopt;
  }

private:
  // b = p d + q a with the control vector number i of a and b and number j of d, in floating-point
  // arithmetic.
  static bool solve(const Grid_layers& s1, const Grid_layers& s2, int i, int j, double& q, double& p, int& pivot) {
    double d[3], a[3], b[3], normal[3];
    for (int x = 0; x < 3; ++x) {
      d[x] = static_cast<double>(s1.p[0][j + 1][x] - s1.p[0][j][x]);
      a[x] = static_cast<double>(s1.p[1][i][x] - s1.p[0][i][x]);
      b[x] = static_cast<double>(s2.p[1][i][x] - s1.p[0][i][x]);
    }
    normal[0] = d[1] * a[2] - d[2] * a[1];
    // equivalent [1 -> 2, 1]: where another coordinate is the pivot the same holds, and the next
    //   stage decides where there is none
    normal[1] = d[2] * a[0] - d[0] * a[2];
    normal[2] = d[0] * a[1] - d[1] * a[0];
    pivot = std::abs(normal[0]) < std::abs(normal[1]) ? 1 : 0;
    if (std::abs(normal[pivot]) < std::abs(normal[2])) pivot = 2;
    if (normal[pivot] == 0) return false;
    const int y = pivot == 2 ? 0 : pivot + 1, z = 3 - pivot - y;
    q = (d[y] * b[z] - d[z] * b[y]) / normal[pivot];
    p = (b[y] * a[z] - b[z] * a[y]) / normal[pivot];
    return true;
  }

  // A fraction that is very near to x, by its continued fraction. A later check shows if it is the
  // right one.
  static bool short_fraction(double x, std::int64_t& numerator, std::int64_t& denominator) {
    double h = 1, last_h = 0, k = 0, last_k = 1, y = x;
    // equivalent [< -> <=, 1]: one more step of a continued fraction; whether it is the right one
    //   is seen later
    for (int step = 0; step < 8; ++step) {
      const double a = std::nearbyint(y), next_h = a * h + last_h, next_k = a * k + last_k;
      if (!(std::abs(next_h) <= most && std::abs(next_k) <= most)) return false;
      last_h = h;
      last_k = k;
      h = next_h;
      k = next_k;
      if (std::abs(x * k - h) <= 0x1p-30 * std::abs(k)) {
        numerator = static_cast<std::int64_t>(k < 0 ? -h : h);
        denominator = static_cast<std::int64_t>(std::abs(k));
        return true;
      }
      y = 1 / (y - a);
    }
    return false;
  }

  // The identity in Bernstein coefficients of degree n, times n. Numbers of less than 2^(12 + 3 +
  // 54 + 2).
  bool holds(const Grid_layers& s1, const Grid_layers& s2) const {
    const int n = s1.along;
    const auto d = [&](int i, int x) -> Signed_128 {
      return i < 0 || n <= i ? 0 : s1.p[0][i + 1][x] - s1.p[0][i][x]; // with the factor 0
    };
    for (int i = 0; i <= n; ++i)
      for (int x = 0; x < 3; ++x) {
        const Signed_128 a = s1.p[1][i][x] - s1.p[0][i][x], b = s2.p[1][i][x] - s1.p[0][i][x];
        if (alpha * n * b != (n - i) * gamma[0] * d(i, x) + i * gamma[1] * d(i - 1, x) + beta * n * a) return false;
      }
    return true;
  }
};

// The decision on two surfaces with one edge, in one direction, whose control points are whole
// numbers of at most 2^coordinate_bits: in space, N = 3, or homogeneous ones, N = 4. Homogeneous
// edges are the same up to the factor scale[1]/scale[0] > 0, of at most 2^scale_bits each, and may
// have another unit in each coordinate.
//
// With a ratio n3 = (gamma/alpha) N, n2 = (beta/alpha) N the identity of second order is N.V = 0
// with
//   V = n q1 (q2-1) alpha^2 h - q1 q2 (n-1) gamma^2 e - 2 n q1 q2 beta gamma f - n q2 (q1-1) beta^2 g.
template <int N, int coordinate_bits, int scale_bits = 0> class Edge_on_grid {
public:
  typedef std::conditional_t<(coordinate_bits < 60), std::int64_t, Signed_128> Coordinate;
  typedef Edge_points<Coordinate, N> Layers;

private:
  // Makes the polynomial of the degree n - below by sums of at most 2^bits control points.
  template <int below, int bits>
  using Vector = std::array<Bounded_polynomial<(std::max)(Layers::most_along - below, 1), coordinate_bits + bits>, N>;
  typedef Vector<0, 0> Edge;
  typedef Vector<1, 1> Difference;
  typedef Vector<0, 1> Cross_difference;
  static constexpr int factor_bits = Layers::factor_bits + scale_bits;

  const Layers &s1_, &s2_;
  const std::array<std::int64_t, 2> scale_;
  const int n_;
  const Difference d_;
  const Cross_difference a_;
  template <class D> using Tangent = Edge_tangent<N, typename Edge::value_type, typename D::value_type>;
  const Tangent<Difference> tangent_;

public:
  // \pre not collapsed
  Edge_on_grid(const Layers& s1, const Layers& s2, const std::array<std::int64_t, 2>& scale = {1, 1})
      : s1_(s1), s2_(s2), scale_(scale), n_(s1.along),
        d_(vector<Difference>(n_ - 1, [&](int i, int x) { return s1.p[0][i + 1][x] - s1.p[0][i][x]; })),
        a_(cross_difference(s1)), tangent_(tangent(d_)) {}
  Edge_on_grid(const Edge_on_grid&) = delete;

  // The order, up to `most`. Empty without a ratio, or if a normal may vanish somewhere.
  std::optional<int> order_by_ratio(int most) const {
    const std::optional<Edge_ratio> r = Edge_ratio::find(s1_, s2_);
    if (!r) return std::nullopt;
    if (r->beta >= 0) return 0; // d x b = (beta/alpha) d x a
    if (most == 1 && tangent_.normal(r->pivot, a_).strict_sign() != 0) return 1;
    const auto n1 = normal();
    if (n1[r->pivot].strict_sign() == 0 && Rounded_polynomial::sign_of(sum_of_products<3>(n1, n1)) != 1)
      return std::nullopt;
    return most > 1 && sum_of_products<3>(n1, remainder(*r)).vanishes() ? 2 : 1;
  }

  // The order, up to `most`. Empty if a normal may vanish somewhere.
  std::optional<int> order(int most) const {
    const auto n1 = normal();
    const Cross_difference b = cross_difference(s2_);
    if (!sum_of_products<N>(n1, b).vanishes()) return 0;
    // The normals are parallel. Where one coordinate of each is never zero they have one sense, or
    // opposite senses.
    for (int x = 0; x < 3; ++x) {
      const int sign = n1[x].strict_sign();
      if (sign == 0) continue;
      const auto n2 = tangent_.normal(x, b);
      const int other = n2.strict_sign();
      if (other == 0) continue;
      if (sign == other) return 0;
      return most > 1 && second_order_holds(n1, n2, b, x) ? 2 : 1;
    }
    const auto n2 = tangent_.normal(b);
    const int side = Rounded_polynomial::sign_of(sum_of_products<3>(n1, n2));
    if (side >= 0) return side > 0 ? std::optional<int>(0) : std::nullopt;
    int x = 0;
    while (n1[x].vanishes()) ++x;
    return most > 1 && second_order_holds(n1, n2[x], b, x) ? 2 : 1;
  }

  // N and n2
  auto normal() const { return tangent_.normal(a_); }
  auto second_normal() const { return tangent_.normal(cross_difference(s2_)); }

private:
  // Decides by the coordinate x. See second_order_form().
  template <class Normal, class Coordinate_2>
  bool second_order_holds(const Normal& n1, const Coordinate_2& n2, const Cross_difference& b, int x) const {
    const Edge_factors<int> w = edge_factors(s1_, s2_);
    const auto factor = [&](int of_degrees, int side) {
      return Bounded_factor<factor_bits>{of_degrees * scale_[side]};
    };
    const Edge_factors<Bounded_factor<factor_bits>> factors{
        factor(w.along, 0), factor(w.mixed, 0), {factor(w.across[0], 0), factor(w.across[1], 1)}};
    return second_order_form(n1[x], n2, tangent(b).normal(x, a_), factors, Products<Normal>{*this, n1}).vanishes();
  }
  template <class Normal> struct Products {
    const Edge_on_grid& edge;
    const Normal& normal;

    auto mixed() const { return sum_of_products<N>(normal, edge.mixed_difference()); }
    auto along() const { return sum_of_products<N>(normal, edge.second_difference_along()); }
    auto across(int side) const {
      return sum_of_products<N>(normal, second_difference(side == 0 ? edge.s1_ : edge.s2_));
    }
  };

  // V
  auto remainder(const Edge_ratio& r) const {
    const Edge_factors<int> w = edge_factors(s1_, s2_);
    // a factor and two numbers of the ratio, or their polynomial
    typedef Bounded_polynomial<2, factor_bits + 2 * Edge_ratio::bits> Multiplier;
    const auto& gamma = r.gamma;
    const Multiplier to_h = Multiplier::from_bernstein(0, [&](int) { return w.across[1] * r.alpha * r.alpha; }),
                     to_e = Multiplier::from_bernstein(
                         2, [&](int i) { return w.along * gamma[i / 2] * gamma[(i + 1) / 2]; }),
                     to_f = Multiplier::from_bernstein(1, [&](int i) { return w.mixed * r.beta * gamma[i]; }),
                     to_g = Multiplier::from_bernstein(0, [&](int) { return w.across[0] * r.beta * r.beta; });
    const auto h = second_difference(s2_), g = second_difference(s1_);
    const auto f = mixed_difference();
    const auto e = second_difference_along();
    const auto coordinate = [&](int x) {
      auto v = first_of_products<4>(to_h, h[x]);
      subtract_product(v, to_e, e[x]);
      subtract_product(v, to_f, f[x]);
      subtract_product(v, to_g, g[x]);
      return v;
    };
    return std::array<decltype(coordinate(0)), 3>{coordinate(0), coordinate(1), coordinate(2)};
  }

  template <class D> Tangent<D> tangent(const D& d) const {
    if constexpr (N == 3)
      return Tangent<D>(d);
    else
      return Tangent<D>(vector<Edge>(n_, [&](int i, int x) { return s1_.p[0][i][x]; }), d);
  }

  // Makes a polynomial from Bernstein coefficients.
  template <class V, class Coefficient> static V vector(int degree, Coefficient coefficient) {
    V v;
    for (int x = 0; x < N; ++x) v[x].degree = degree;
    for (int i = 0; i <= degree; ++i) {
      const std::int64_t binomial = V::value_type::binomial(degree, i);
      for (int x = 0; x < N; ++x) v[x].set_bernstein(i, binomial, coefficient(i, x));
    }
    return v;
  }
  static Cross_difference cross_difference(const Layers& s) {
    return vector<Cross_difference>(s.along, [&](int i, int x) { return s.p[1][i][x] - s.p[0][i][x]; });
  }
  Vector<2, 2> second_difference_along() const {
    return vector<Vector<2, 2>>(
        n_ - 2, [&](int i, int x) { return s1_.p[0][i + 2][x] - 2 * s1_.p[0][i + 1][x] + s1_.p[0][i][x]; });
  }
  Vector<1, 2> mixed_difference() const {
    return vector<Vector<1, 2>>(n_ - 1, [&](int i, int x) {
      return (s1_.p[1][i + 1][x] - s1_.p[0][i + 1][x]) - (s1_.p[1][i][x] - s1_.p[0][i][x]);
    });
  }
  static Vector<0, 2> second_difference(const Layers& s) {
    return vector<Vector<0, 2>>(s.along, [&](int i, int x) {
      return s.across > 1 ? s.p[2][i][x] - 2 * s.p[1][i][x] + s.p[0][i][x] : Coordinate(0);
    });
  }
};

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_ON_GRID_H
