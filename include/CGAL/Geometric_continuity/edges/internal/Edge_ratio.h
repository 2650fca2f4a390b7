// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_RATIO_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_RATIO_H

#include <CGAL/Geometric_continuity/edges/internal/edge_layers.h>
#include <CGAL/Geometric_continuity/numbers/internal/Fixed_integer.h>

#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

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

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_RATIO_H
