// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "peers.h"
#include "test.h"

// Rational splines with random doubles, the same with exact numbers, and how far a rounded result
// may be from the exact one.

typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Double;
typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Exact;

constexpr unsigned seed = 2026;
std::mt19937 engine(seed);

int below(int n) { return static_cast<int>(engine() % static_cast<unsigned>(n)); }
double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }

// Clamped, with up to four inner knots of any multiplicity, at distances in [1/2, 3/2].
GC::Knot_vector<double> random_knots(int degree) {
  double u = between(-2, 2);
  std::vector<double> knots(degree + 1, u);
  for (int spans = below(5); spans > 0; --spans) {
    u += between(0.5, 1.5);
    knots.insert(knots.end(), 1 + below(degree), u);
  }
  knots.insert(knots.end(), degree + 1, u + between(0.5, 1.5));
  return GC::Knot_vector<double>(degree, knots);
}
Double::Point random_point() {
  const double x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
  return Double::Point(x, y, z);
}
double random_weight() { return between(0.25, 4); }

Exact::Point exact(const Double::Point& p) { return Exact::Point(Q(p.x()), Q(p.y()), Q(p.z())); }
GC::Knot_vector<Q> exact(const GC::Knot_vector<double>& knots) {
  return GC::Knot_vector<Q>(knots.degree(), std::vector<Q>(knots.begin(), knots.end()));
}

double length_of_span(const GC::Knot_vector<double>& knots, double u) {
  const int k = knots.span(u);
  return knots[k + 1] - knots[k];
}

// All coordinates are in [-1, 1] and all weights in [1/4, 4]; then those of homogeneous points are
// in [-4, 4]. A differentiation takes differences, at most twice as large, times the degree over
// differences of knots, which are no shorter than the span. With sums of absolute values in the
// quotient rule this bounds the derivatives of x = p/w by
//   X_kl = (D_kl + sum C(k,i) C(l,j) D_ij X_(k-i)(l-j)) / (1/4).
// Each of the at most p+q+2 levels of de Boor's triangles makes fewer than 9 roundings on the way
// to a homogeneous coordinate; the quotient reads two of them and the denominator once more, and
// adds 4 roundings for each of its at most k+l+1 terms, which happens k+l+1 times one after the
// other. The result is off by as many times 2^-53 X_kl, but for terms with 2^-106.
class Peer_bound {
  static constexpr int most = 3;
  double x_[most + 1][most + 1];
  int levels_;

  static double derivative(int degree, double h, int k) {
    double d = 1;
    for (int j = 0; j < k; ++j) d *= 2 * (std::max)(0, degree - j) / h;
    return d;
  }
  static double binomial(int n, int k) { return k == 0 ? 1 : binomial(n - 1, k - 1) * n / k; }

public:
  Peer_bound(int p, double h_u, int q, double h_v) : levels_(p + q + 2) {
    for (int k = 0; k <= most; ++k)
      for (int l = 0; l <= most; ++l) {
        x_[k][l] = 0;
        for (int i = 0; i <= k; ++i)
          for (int j = 0; j <= l; ++j) {
            const double d = 4 * derivative(p, h_u, i) * derivative(q, h_v, j);
            if (i == k && j == l) x_[k][l] += d;
            if (i + j > 0) x_[k][l] += binomial(k, i) * binomial(l, j) * d * x_[k - i][l - j];
          }
        x_[k][l] *= 4;
      }
  }
  Peer_bound(int p, double h) : Peer_bound(p, h, 0, 1) {}

  double operator()(int k, int l = 0) const {
    const int n = k + l + 1;
    return 0x1p-53 * n * (3 * 9 * levels_ + 4 * n) * x_[k][l];
  }
};

// The largest error of a method, in parts of its bound.
class Largest_error {
  std::string method_;
  double part_ = 0;
  int compared_ = 0;

public:
  explicit Largest_error(const std::string& method) : method_(method) {}
  ~Largest_error() {
    if (compared_ > 0) std::cout << method_ << ": errors up to " << part_ << " of the bound\n";
  }
  void compare(double x, const Q& exact, double bound) {
    const double part = std::abs(CGAL::to_double(Q(Q(x) - exact))) / bound;
    BOOST_CHECK_MESSAGE(part <= 1, method_ << ": " << x << " where " << CGAL::to_double(exact) << " is exact");
    part_ = (std::max)(part_, part);
    ++compared_;
  }
};
