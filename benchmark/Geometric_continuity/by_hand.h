// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BENCHMARK_BY_HAND_H
#define GEOMETRIC_CONTINUITY_BENCHMARK_BY_HAND_H

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

// Instructions written by hand for doubles in space, the limit to which the package is compared.
namespace by_hand {

// ---------------------------------------------------------------- jets of a quintic

struct Quintic {
  double points[6][3];
  double a, b; // the domain

  template <class Points> Quintic(const Points& p, double a, double b) : a(a), b(b) {
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 3; ++i) points[j][i] = p[j][i];
  }
};

struct Jet {
  int order;
  double d[4][3]; // the point and three derivatives
};

// De Casteljau's algorithm with differences, one coordinate after the other. The ends of the domain
// give the first and the last control point exactly.
inline Jet jet(const Quintic& c, double u) {
  const double h = c.b - c.a, t = (u - c.a) / h, s = 1 - t, r = 1 / h, f1 = 5 * r, f2 = f1 * (4 * r), f3 = f2 * (3 * r);
  Jet out;
  out.order = 3;
  for (int i = 0; i < 3; ++i) {
    double p0 = c.points[0][i], p1 = c.points[1][i], p2 = c.points[2][i], p3 = c.points[3][i], p4 = c.points[4][i],
           p5 = c.points[5][i];
    p0 = s * p0 + t * p1, p1 = s * p1 + t * p2, p2 = s * p2 + t * p3, p3 = s * p3 + t * p4, p4 = s * p4 + t * p5;
    p0 = s * p0 + t * p1, p1 = s * p1 + t * p2, p2 = s * p2 + t * p3, p3 = s * p3 + t * p4;
    out.d[3][i] = f3 * (((p3 - p2) - (p2 - p1)) - ((p2 - p1) - (p1 - p0)));
    p0 = s * p0 + t * p1, p1 = s * p1 + t * p2, p2 = s * p2 + t * p3;
    out.d[2][i] = f2 * ((p2 - p1) - (p1 - p0));
    p0 = s * p0 + t * p1, p1 = s * p1 + t * p2;
    out.d[1][i] = f1 * (p1 - p0);
    out.d[0][i] = s * p0 + t * p1;
  }
  return out;
}

// The curve and its derivatives in powers of (u-a)/(b-a), each prepared for Horner's rule.
class Powers {
  double a_, inverse_;
  double c_[4][6][3] = {}; // derivative, power, coordinate

public:
  explicit Powers(const Quintic& q) : a_(q.a), inverse_(1 / (q.b - q.a)) {
    static const int m[6][6] = {{1, 0, 0, 0, 0, 0},       {-5, 5, 0, 0, 0, 0},     {10, -20, 10, 0, 0, 0},
                                {-10, 30, -30, 10, 0, 0}, {5, -20, 30, -20, 5, 0}, {-1, 5, -10, 10, -5, 1}};
    for (int x = 0; x < 3; ++x) {
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) c_[0][i][x] += m[i][j] * q.points[j][x];
      for (int d = 1; d < 4; ++d)
        for (int i = 0; i + d < 6; ++i) c_[d][i][x] = (i + 1) * c_[d - 1][i + 1][x] * inverse_;
    }
  }

  Jet operator()(double u) const {
    const double t = (u - a_) * inverse_;
    Jet out;
    out.order = 3;
    for (int x = 0; x < 3; ++x) {
      out.d[0][x] =
          ((((c_[0][5][x] * t + c_[0][4][x]) * t + c_[0][3][x]) * t + c_[0][2][x]) * t + c_[0][1][x]) * t + c_[0][0][x];
      out.d[1][x] = (((c_[1][4][x] * t + c_[1][3][x]) * t + c_[1][2][x]) * t + c_[1][1][x]) * t + c_[1][0][x];
      out.d[2][x] = ((c_[2][3][x] * t + c_[2][2][x]) * t + c_[2][1][x]) * t + c_[2][0][x];
      out.d[3][x] = (c_[3][2][x] * t + c_[3][1][x]) * t + c_[3][0][x];
    }
    return out;
  }

  // Evaluates many parameters; `out` has `stride` numbers for each derivative and coordinate.
  void batch(const double* u, std::size_t size, double* out, std::size_t stride) const {
    for (int x = 0; x < 3; ++x) {
      double p[4][6]; // of its own, and not changed by what is written
      for (int d = 0; d < 4; ++d)
        for (int i = 0; i < 6; ++i) p[d][i] = c_[d][i][x];
      row(p, a_, inverse_, u, size, out + x * stride, out + (3 + x) * stride, out + (6 + x) * stride,
          out + (9 + x) * stride);
    }
  }

private:
  static void row(const double (&p)[4][6], double a, double inverse, const double* __restrict u, std::size_t size,
                  double* __restrict o0, double* __restrict o1, double* __restrict o2, double* __restrict o3) {
    for (std::size_t l = 0; l < size; ++l) {
      const double s = (u[l] - a) * inverse;
      o0[l] = ((((p[0][5] * s + p[0][4]) * s + p[0][3]) * s + p[0][2]) * s + p[0][1]) * s + p[0][0];
      o1[l] = (((p[1][4] * s + p[1][3]) * s + p[1][2]) * s + p[1][1]) * s + p[1][0];
      o2[l] = ((p[2][3] * s + p[2][2]) * s + p[2][1]) * s + p[2][0];
      o3[l] = (p[3][2] * s + p[3][1]) * s + p[3][0];
    }
  }
};

// Takes many jets; `jets` are the first derivatives, then the second and the third, with `stride`
// numbers for each coordinate.
inline void curvature_and_torsion(const double* jets, std::size_t stride, std::size_t size, double* __restrict k,
                                  double* __restrict t) {
  const double *x1 = jets, *y1 = x1 + stride, *z1 = y1 + stride, *x2 = z1 + stride, *y2 = x2 + stride,
               *z2 = y2 + stride, *x3 = z2 + stride, *y3 = x3 + stride, *z3 = y3 + stride;
  for (std::size_t l = 0; l < size; ++l) {
    const double g = x1[l] * x1[l] + y1[l] * y1[l] + z1[l] * z1[l];
    const double x = y1[l] * z2[l] - z1[l] * y2[l], y = z1[l] * x2[l] - x1[l] * z2[l],
                 z = x1[l] * y2[l] - y1[l] * x2[l];
    const double square = x * x + y * y + z * z;
    k[l] = std::sqrt(square / g) / g;
    t[l] = (x * x3[l] + y * y3[l] + z * z3[l]) / square;
  }
}

// ------------------------------------------------ quintic blends with the least second derivatives

struct Blend {
  double points[6][3];
};

// The points next to one end, one division for each end.
inline Blend blend(const Jet& x, const Jet& y) {
  const double *d = x.d[1], *dd = x.d[2], *e = y.d[1], *ee = y.d[2];
  const double u = (d[0] * dd[0] + d[1] * dd[1] + d[2] * dd[2]) / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]),
               v = (e[0] * ee[0] + e[1] * ee[1] + e[2] * ee[2]) / (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
  const double m = 0.4 - 0.05 * u, k = 0.4 + 0.05 * v;
  Blend g;
  for (int i = 0; i < 3; ++i) {
    g.points[0][i] = x.d[0][i];
    g.points[1][i] = x.d[0][i] + 0.2 * d[i];
    g.points[2][i] = x.d[0][i] + m * d[i] + 0.05 * dd[i];
    g.points[3][i] = y.d[0][i] - k * e[i] + 0.05 * ee[i];
    g.points[4][i] = y.d[0][i] - 0.2 * e[i];
    g.points[5][i] = y.d[0][i];
  }
  return g;
}

// A blend with the guarantees of the package: jets of a low order, zero tangents and results that
// overflow are refused, and the curve has its domain and the parameters of the strategy with it.
struct Checked_blend {
  Blend curve;
  double a, b;
  double s1, s2;
  bool fallback_start, fallback_end;
};

[[noreturn]] inline void refuse(const char* reason) { throw std::runtime_error(reason); }

inline Checked_blend checked_blend(const Jet& x, const Jet& y) {
  const double *d = x.d[1], *e = y.d[1];
  if (x.order < 2 || y.order < 2) refuse("a jet has too few derivatives");
  if (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] == 0) refuse("zero tangent, first curve");
  if (e[0] * e[0] + e[1] * e[1] + e[2] * e[2] == 0) refuse("zero tangent, second curve");
  Checked_blend g{blend(x, y), 0, 1, 0, 0, false, false};
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 6; ++j) sum += g.curve.points[j][i];
  if (!std::isfinite(sum))
    for (const auto& point : g.curve.points)
      for (double coordinate : point)
        if (!std::isfinite(coordinate)) refuse("overflow");
  return g;
}

} // namespace by_hand

#endif // GEOMETRIC_CONTINUITY_BENCHMARK_BY_HAND_H
