// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_ON_GRID_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_ON_GRID_H

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
/// The conditions of Edge_equations.h in integers of fixed length: polynomials along the edge, with a ratio of the tangent planes in
/// short numbers or without.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// A polynomial sum_k c_k t^k (1-t)^(degree-k), see Homogeneous_polynomial, with integers of fixed length and without
// allocation.
template <int limbs> struct Short_polynomial {
  static constexpr int capacity = 7 * Edge_layers::most_along - 2;
  int degree;
  Fixed_integer<limbs> c[capacity];

  explicit Short_polynomial(int n) : degree(n) {}

  // The sum with the product p q, or the difference. \pre its degree is that of the sum
  template <bool subtracted, int m, int n>
  void add_product(const Short_polynomial<m>& p, const Short_polynomial<n>& q) {
    static_assert(m + n == limbs, "no product overflows");
    for (int i = 0; i <= p.degree; ++i)
      for (int j = 0; j <= q.degree; ++j)
        c[i + j] = subtracted ? c[i + j] - p.c[i] * q.c[j] : c[i + j] + p.c[i] * q.c[j];
  }

  Short_polynomial&& times(std::int64_t w) && {
    for (int k = 0; k <= degree; ++k) c[k] = scaled(c[k], w);
    return std::move(*this);
  }

  bool vanishes() const {
    return std::all_of(c, c + degree + 1, [](const Fixed_integer<limbs>& x) { return is_zero(x); });
  }

  // 1 or -1 when all coefficients have this sign, otherwise 0
  int strict_sign() const {
    const auto sign = [](const Fixed_integer<limbs>& x) { return x.top() < 0 ? -1 : is_zero(x) ? 0 : 1; };
    const int first = sign(c[0]);
    return std::all_of(c, c + degree + 1, [&](const Fixed_integer<limbs>& x) { return sign(x) == first; }) ? first : 0;
  }
};

template <int limbs> using Short_vector = std::array<Short_polynomial<limbs>, 3>;

template <int limbs> Short_polynomial<limbs> zero_polynomial(int degree) {
  Short_polynomial<limbs> p(degree);
  std::fill(p.c, p.c + degree + 1, Fixed_integer<limbs>(0));
  return p;
}

template <int m, int n> Short_polynomial<m + n> operator*(const Short_polynomial<m>& p, const Short_polynomial<n>& q) {
  Short_polynomial<m + n> r = zero_polynomial<m + n>(p.degree + q.degree);
  r.template add_product<false>(p, q);
  return r;
}
template <int m, int n>
void add_product(Short_polynomial<m + n>& r, const Short_polynomial<m>& p, const Short_polynomial<n>& q) {
  r.template add_product<false>(p, q);
}
template <int m, int n>
void subtract_product(Short_polynomial<m + n>& r, const Short_polynomial<m>& p, const Short_polynomial<n>& q) {
  r.template add_product<true>(p, q);
}

// v . w
template <int m, int n> Short_polynomial<m + n> dot(const Short_vector<m>& v, const Short_vector<n>& w) {
  Short_polynomial<m + n> r = zero_polynomial<m + n>(v[0].degree + w[0].degree);
  for (int x = 0; x < 3; ++x) r.template add_product<false>(v[x], w[x]);
  return r;
}

// The coordinate x of v x w.
template <int m, int n>
Short_polynomial<m + n> cross_coordinate(const Short_vector<m>& v, const Short_vector<n>& w, int x) {
  const int y = x == 2 ? 0 : x + 1, z = 3 - x - y;
  Short_polynomial<m + n> r = zero_polynomial<m + n>(v[0].degree + w[0].degree);
  r.template add_product<false>(v[y], w[z]);
  r.template add_product<true>(v[z], w[y]);
  return r;
}

// Tangent planes that agree: with the first differences d along the edge, a and b across it (polynomials of the degrees n - 1,
// n and n), alpha b = gamma d + beta a for a linear polynomial gamma with the values gamma[0], gamma[1] at the ends. If the
// coordinates of d x a have no common factor, the tangent planes agree if and only if there are such numbers: d x b and
// b x a are polynomials of the degrees 2n - 1 and 2n, which d x a of degree 2n - 1 then divides.
struct Edge_ratio {
  static constexpr std::int64_t most = (std::int64_t(1) << 12) - 1;

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
  // b = p d + q a with the control vector number i of a and b and number j of d, in floating-point arithmetic.
  static bool solve(const Grid_layers& s1, const Grid_layers& s2, int i, int j, double& q, double& p, int& pivot) {
    double d[3], a[3], b[3], normal[3];
    for (int x = 0; x < 3; ++x) {
      d[x] = static_cast<double>(s1.p[0][j + 1][x] - s1.p[0][j][x]);
      a[x] = static_cast<double>(s1.p[1][i][x] - s1.p[0][i][x]);
      b[x] = static_cast<double>(s2.p[1][i][x] - s1.p[0][i][x]);
    }
    normal[0] = d[1] * a[2] - d[2] * a[1];
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

  // A fraction that is very near to x, by its continued fraction. Whether it is the right one is seen later.
  static bool short_fraction(double x, std::int64_t& numerator, std::int64_t& denominator) {
    double h = 1, last_h = 0, k = 0, last_k = 1, y = x;
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

  // The identity in Bernstein coefficients of degree n, times n. Numbers of less than 2^(12 + 3 + 54 + 2).
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

// The decision on two surfaces with one edge, in one direction, whose control points are whole numbers of at most 2^53. With an
// Edge_ratio n3 = (gamma/alpha) N, n2 = (beta/alpha) N the identity of second order is N.V = 0 with
//   V = n q1 (q2-1) alpha^2 h - q1 q2 (n-1) gamma^2 e - 2 n q1 q2 beta gamma f - n q2 (q1-1) beta^2 g.
//
// Lengths, for degrees n <= 7 and q <= 8. A coefficient of a product of forms is a sum of at most as many products of
// control points as the forms have terms, times the binomial coefficients of the degree of the product. First differences
// are at most 2^54, second ones 2^55, with binomial factors < 2^6: one limb. Coordinates of N, n2, n3: 2 * 2^108 *
// C(14,7) < 2^121, two limbs. a.N and similar: 6 * 2^163 * C(21,10) < 2^185, three limbs. n3 (N.e) and n2 (N.f), with
// factors of at most 2 * 7 * 64 < 2^10: their sum is < 2 * 12 * 2^271 * C(33,16) * 2^10 < 2^317, five limbs. The identity:
// four terms < 24 * 2^379 * C(46,23) * 2^10 each, together < 2^440, seven limbs. With a ratio: V < 4 * 2^(10 + 24 + 55) *
// C(7,3) < 2^97, two limbs, and N.V < 6 * 2^108 * 2^91 * C(21,10) < 2^221, four limbs.
class Edge_on_grid {
  const Grid_layers &s1_, &s2_;
  const int n_, q1_, q2_;
  const Short_vector<1> d_, a_;

public:
  // \pre not collapsed
  Edge_on_grid(const Grid_layers& s1, const Grid_layers& s2)
      : s1_(s1), s2_(s2), n_(s1.along), q1_(s1.across), q2_(s2.across),
        d_(vector(n_ - 1, [&](int i, int x) { return s1.p[0][i + 1][x] - s1.p[0][i][x]; })), a_(leg(s1)) {}

  // The order, up to `most`. Empty without a ratio, or if a normal may vanish somewhere.
  std::optional<int> order_by_ratio(int most) const {
    const std::optional<Edge_ratio> r = Edge_ratio::find(s1_, s2_);
    if (!r) return std::nullopt;
    if (r->beta >= 0) return 0; // d x b = (beta/alpha) d x a
    if (cross_coordinate(d_, a_, r->pivot).strict_sign() == 0) return std::nullopt;
    return most > 1 && dot(normal(), remainder(*r)).vanishes() ? 2 : 1;
  }

  // The order, up to `most`. Empty if a normal may vanish somewhere.
  std::optional<int> order(int most) const {
    const Short_vector<2> n1 = normal();
    const Short_vector<1> b = leg(s2_);
    if (!dot(n1, b).vanishes()) return 0;
    // The normals are parallel. Where one coordinate of each is never zero they have one sense, or opposite senses.
    for (int x = 0; x < 3; ++x) {
      const int sign = n1[x].strict_sign();
      if (sign == 0) continue;
      const Short_polynomial<2> n2 = cross_coordinate(d_, b, x);
      const int other = n2.strict_sign();
      if (other == 0) continue;
      if (sign == other) return 0;
      const bool second =
          most > 1 && second_order_form(n1[x], n2, cross_coordinate(b, a_, x), Products{*this, n1}).vanishes();
      return second ? 2 : 1;
    }
    return std::nullopt;
  }

  // N and n2
  Short_vector<2> normal() const { return normal_to(a_); }
  Short_vector<2> second_normal() const { return normal_to(leg(s2_)); }

private:
  Short_vector<2> normal_to(const Short_vector<1>& across) const {
    return {cross_coordinate(d_, across, 0), cross_coordinate(d_, across, 1), cross_coordinate(d_, across, 2)};
  }

  // See second_order_form().
  struct Products {
    const Edge_on_grid& edge;
    const Short_vector<2>& normal;

    Short_polynomial<3> mixed() const {
      return dot(normal, edge.mixed_difference()).times(2 * edge.n_ * edge.q1_ * edge.q2_);
    }
    bool is_curved_along() const { return edge.n_ > 1; }
    Short_polynomial<3> along() const {
      return dot(normal, edge.second_difference_along()).times(edge.q1_ * edge.q2_ * (edge.n_ - 1));
    }
    bool is_curved_across(int side) const { return (side == 0 ? edge.q1_ : edge.q2_) > 1; }
    Short_polynomial<3> across(int side) const {
      const Grid_layers &s = side == 0 ? edge.s1_ : edge.s2_, &other = side == 0 ? edge.s2_ : edge.s1_;
      return dot(normal, second_difference(s)).times(edge.n_ * other.across * (s.across - 1));
    }
  };

  // V
  Short_vector<2> remainder(const Edge_ratio& r) const {
    std::array<std::array<Signed_128, Edge_layers::most_along + 1>, 3> v{};
    const auto add = [&](std::int64_t factor, const Short_vector<1>& y, int shift) {
      for (int x = 0; x < 3; ++x)
        for (int k = 0; k <= y[x].degree; ++k) v[x][k + shift] += static_cast<Signed_128>(factor) * y[x].c[k].top();
    };
    if (q2_ > 1) add(n_ * q1_ * (q2_ - 1) * r.alpha * r.alpha, second_difference(s2_), 0);
    if (q1_ > 1) add(-n_ * q2_ * (q1_ - 1) * r.beta * r.beta, second_difference(s1_), 0);
    const std::int64_t f = -2 * n_ * q1_ * q2_ * r.beta, e = -q1_ * q2_ * (n_ - 1);
    for (int k : {0, 1}) add(f * r.gamma[k], mixed_difference(), k);
    if (n_ > 1) {
      const Short_vector<1> y = second_difference_along();
      add(e * r.gamma[0] * r.gamma[0], y, 0);
      add(2 * e * r.gamma[0] * r.gamma[1], y, 1);
      add(e * r.gamma[1] * r.gamma[1], y, 2);
    }
    Short_vector<2> result{Short_polynomial<2>(n_), Short_polynomial<2>(n_), Short_polynomial<2>(n_)};
    for (int x = 0; x < 3; ++x)
      for (int k = 0; k <= n_; ++k) {
        result[x].c[k].limb[0] = static_cast<std::uint64_t>(v[x][k]);
        result[x].c[k].limb[1] = static_cast<std::uint64_t>(v[x][k] >> 64);
      }
    return result;
  }

  // From Bernstein coefficients.
  template <class Coefficient> static Short_vector<1> vector(int degree, Coefficient coefficient) {
    Short_vector<1> v{Short_polynomial<1>(degree), Short_polynomial<1>(degree), Short_polynomial<1>(degree)};
    std::int64_t binomial = 1;
    for (int i = 0; i <= degree; ++i) {
      for (int x = 0; x < 3; ++x) v[x].c[i] = Fixed_integer<1>(binomial * coefficient(i, x));
      binomial = binomial * (degree - i) / (i + 1);
    }
    return v;
  }
  static Short_vector<1> leg(const Grid_layers& s) {
    return vector(s.along, [&](int i, int x) { return s.p[1][i][x] - s.p[0][i][x]; });
  }
  Short_vector<1> second_difference_along() const {
    return vector(n_ - 2, [&](int i, int x) { return s1_.p[0][i + 2][x] - 2 * s1_.p[0][i + 1][x] + s1_.p[0][i][x]; });
  }
  Short_vector<1> mixed_difference() const {
    return vector(n_ - 1, [&](int i, int x) {
      return (s1_.p[1][i + 1][x] - s1_.p[0][i + 1][x]) - (s1_.p[1][i][x] - s1_.p[0][i][x]);
    });
  }
  static Short_vector<1> second_difference(const Grid_layers& s) {
    return vector(s.along, [&](int i, int x) { return s.p[2][i][x] - 2 * s.p[1][i][x] + s.p[0][i][x]; });
  }
};

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_ON_GRID_H
