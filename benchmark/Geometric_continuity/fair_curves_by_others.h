// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

// Four well-known curves through points in the plane, for comparison with `interpolate_fair`,
// written from their papers: the splines of J. D. Hobby (Smooth, easy to compute interpolating
// splines, 1986), the spiro splines of R. Levien (From Spiral to Spline, 2009), kappa-curves (Z.
// Yan et al., kappa-Curves: Interpolation with Local Curvature Control, 2017), and cubic splines
// with centripetal parameters (E. T. Y. Lee, 1989). Each is returned as samples.

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

typedef std::complex<double> Plane_point;
typedef std::vector<Plane_point> Plane_points;

constexpr double pi = 3.141592653589793;

inline double cross(Plane_point a, Plane_point b) { return std::imag(std::conj(a) * b); }

struct Curve_sample {
  Plane_point point;
  double curvature;
};
// The samples of each piece between two joints, where the curvature may jump.
typedef std::vector<std::vector<Curve_sample>> Sampled_curve;

constexpr int samples_of_a_piece = 400;

// The samples of a Bezier curve.
inline std::vector<Curve_sample> sampled_bezier(const Plane_points& control) {
  std::vector<Curve_sample> samples;
  const double degree = static_cast<double>(control.size() - 1);
  for (int k = 0; k <= samples_of_a_piece; ++k) {
    const double t = k / double(samples_of_a_piece);
    Plane_points b = control;
    Plane_point d1, d2;
    for (std::size_t n = b.size() - 1; n > 0; --n) { // de Casteljau's algorithm
      if (n == 2) d2 = degree * (degree - 1) * (b[2] - 2. * b[1] + b[0]);
      if (n == 1) d1 = degree * (b[1] - b[0]);
      for (std::size_t i = 0; i < n; ++i) b[i] += t * (b[i + 1] - b[i]);
    }
    samples.push_back({b[0], cross(d1, d2) / std::pow(std::abs(d1), 3)});
  }
  return samples;
}

// The chords of a polygon, and by which angle it turns at each of its points.
struct Chords {
  const bool closed;
  const int points, pieces;
  Plane_points chord;
  std::vector<double> length, turn;

  Chords(const Plane_points& p, bool is_closed)
      : closed(is_closed), points(static_cast<int>(p.size())), pieces(closed ? points : points - 1), chord(pieces),
        length(pieces), turn(points, 0) {
    for (int k = 0; k < pieces; ++k) {
      chord[k] = p[(k + 1) % points] - p[k];
      length[k] = std::abs(chord[k]);
    }
    for (int k = closed ? 0 : 1; k < pieces; ++k) turn[k] = std::arg(chord[k] / chord[before(k)]);
  }
  int before(int k) const { return (k + pieces - 1) % pieces; }
  int after(int k) const { return (k + 1) % points; }
  bool is_end(int k) const { return !closed && (k == 0 || k == points - 1); }
};

// Cubics whose mock curvature, the linear part of the curvature in the angles theta and phi of the
// tangents with the chord, is the same on both sides; the curl at ends is 1.
inline Sampled_curve hobby_spline(const Plane_points& p, bool closed) {
  const Chords c(p, closed);
  // theta of each point; phi = -turn - theta of the piece before
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(c.points, c.points);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(c.points);
  for (int k = 0; k < c.points; ++k) {
    const int next = c.after(k), last = (k + c.points - 1) % c.points;
    if (!c.is_end(k)) { // (theta' - 2 phi) / d' = (phi'' - 2 theta) / d
      const double d = c.length[k], d0 = c.length[c.before(k)], next_turn = c.is_end(next) ? 0 : c.turn[next];
      m(k, last) += 1 / d0;
      m(k, k) += 2 / d0 + 2 / d;
      m(k, next) += 1 / d;
      right[k] = -2 * c.turn[k] / d0 - next_turn / d;
    } else { // theta = phi of the other end of the piece
      const int other = k == 0 ? 1 : last;
      m(k, k) = 1;
      m(k, other) = 1;
      right[k] = k == 0 && !c.is_end(other) ? -c.turn[other] : 0;
    }
  }
  const Eigen::VectorXd theta = m.colPivHouseholderQr().solve(right);
  const auto velocity = [](double t, double f) {
    const double bend = std::sqrt(2) * (std::sin(t) - std::sin(f) / 16) * (std::sin(f) - std::sin(t) / 16) *
                        (std::cos(t) - std::cos(f)),
                 root = std::sqrt(5);
    return (2 + bend) / (3 * (1 + (root - 1) / 2 * std::cos(t) + (3 - root) / 2 * std::cos(f)));
  };
  Sampled_curve curve;
  for (int k = 0; k < c.pieces; ++k) {
    const int next = c.after(k);
    const double t = theta[k], f = (c.is_end(next) ? 0 : -c.turn[next]) - theta[next];
    curve.push_back(sampled_bezier({p[k], p[k] + velocity(t, f) * std::polar(1., t) * c.chord[k],
                                    p[next] - velocity(f, t) * std::polar(1., -f) * c.chord[k], p[next]}));
  }
  return curve;
}

// A natural or periodic cubic spline whose parameters are the sums of the roots of the chords.
inline Sampled_curve centripetal_spline(const Plane_points& p, bool closed) {
  const Chords c(p, closed);
  Eigen::MatrixXcd m = Eigen::MatrixXcd::Zero(c.points, c.points); // of the first derivatives
  Eigen::VectorXcd right = Eigen::VectorXcd::Zero(c.points);
  std::vector<double> h(c.pieces);
  for (int k = 0; k < c.pieces; ++k) h[k] = std::sqrt(c.length[k]);
  for (int k = 0; k < c.points; ++k) {
    const int next = c.after(k), last = (k + c.points - 1) % c.points;
    if (!(!closed && k == 0)) { // the second derivative at the end of the piece before
      const double g = h[c.before(k)];
      m(k, last) += 2 / g;
      m(k, k) += 4 / g;
      right[k] += 6. * c.chord[c.before(k)] / (g * g);
    }
    if (!(!closed && k == c.points - 1)) { // equals that at the start of the next piece
      m(k, next) += 2 / h[k];
      m(k, k) += 4 / h[k];
      right[k] += 6. * c.chord[k] / (h[k] * h[k]);
    }
  }
  const Eigen::VectorXcd d = m.colPivHouseholderQr().solve(right);
  Sampled_curve curve;
  for (int k = 0; k < c.pieces; ++k) {
    const int next = c.after(k);
    curve.push_back(sampled_bezier({p[k], p[k] + h[k] / 3 * d[k], p[next] - h[k] / 3 * d[next], p[next]}));
  }
  return curve;
}

// The curve over a chord of length 1 whose curvature is the polynomial k0 + k1 s + k2 s^2 / 2 + k3
// s^3 / 6 of s in [-1/2, 1/2], before it is scaled: direction and curvature at s.
struct Cubic_spiral {
  std::array<double, 4> k;
  double curvature(double s) const { return k[0] + s * (k[1] + s * (k[2] / 2 + s * k[3] / 6)); }
  double first(double s) const { return k[1] + s * (k[2] + s * k[3] / 2); }
  double second(double s) const { return k[2] + s * k[3]; }
  double direction(double s) const { return s * (k[0] + s * (k[1] / 2 + s * (k[2] / 6 + s * k[3] / 24))); }
  // The way from s = -1/2, by the midpoint rule on many parts.
  Plane_points positions(int parts) const {
    Plane_points way{0};
    for (int i = 0; i < parts; ++i) { // Gauss' rule with two points
      const double a = (i + .5 - std::sqrt(1 / 12.)) / parts - .5, b = (i + .5 + std::sqrt(1 / 12.)) / parts - .5;
      way.push_back(way.back() + (std::polar(1., direction(a)) + std::polar(1., direction(b))) / (2. * parts));
    }
    return way;
  }
};

// Pieces whose curvature is a cubic polynomial of the length, with continuous direction, curvature
// and its first two derivatives; those are zero at ends. Newton's steps from the polygon; nothing
// if they do not end.
inline std::optional<Sampled_curve> spiro_spline(const Plane_points& p, bool closed) {
  const Chords c(p, closed);
  const int unknowns = 4 * c.pieces;
  const auto spiral = [&](const Eigen::VectorXd& x, int k) {
    return Cubic_spiral{{x[4 * k], x[4 * k + 1], x[4 * k + 2], x[4 * k + 3]}};
  };
  struct End {
    double direction, curvature, first, second;
  };
  const auto ends = [&](const Eigen::VectorXd& x, int k) { // relative to the chord, in units of length
    const Cubic_spiral s = spiral(x, k);
    const Plane_point way = s.positions(32).back();
    const double unit = c.length[k] / std::abs(way);
    const auto end = [&](double at) {
      return End{s.direction(at) - std::arg(way), s.curvature(at) / unit, s.first(at) / (unit * unit),
                 s.second(at) / (unit * unit * unit)};
    };
    return std::array<End, 2>{end(-.5), end(.5)};
  };
  const auto residuals = [&](const Eigen::VectorXd& x) {
    std::vector<std::array<End, 2>> e;
    for (int k = 0; k < c.pieces; ++k) e.push_back(ends(x, k));
    Eigen::VectorXd r(unknowns);
    int row = 0;
    for (int k = 0; k < c.points; ++k) {
      if (c.is_end(k)) { // its second and its third derivative are zero
        const End& end = k == 0 ? e.front()[0] : e.back()[1];
        const double d = k == 0 ? c.length.front() : c.length.back();
        r[row++] = end.first * d * d;
        r[row++] = end.second * d * d * d;
        continue;
      }
      const End &a = e[c.before(k)][1], &b = e[k][0];
      const double d = std::sqrt(c.length[k] * c.length[c.before(k)]);
      r[row++] = b.direction - a.direction + c.turn[k];
      r[row++] = (b.curvature - a.curvature) * d;
      r[row++] = (b.first - a.first) * d * d;
      r[row++] = (b.second - a.second) * d * d * d;
    }
    return r;
  };
  Eigen::VectorXd x = Eigen::VectorXd::Zero(unknowns), r = residuals(x);
  for (int step = 0; step < 200 && r.norm() > 1e-10; ++step) {
    Eigen::MatrixXd jacobian(unknowns, unknowns);
    for (int i = 0; i < unknowns; ++i) {
      Eigen::VectorXd y = x;
      y[i] += 1e-6;
      Eigen::VectorXd z = x;
      z[i] -= 1e-6;
      jacobian.col(i) = (residuals(y) - residuals(z)) / 2e-6;
    }
    const Eigen::VectorXd change = jacobian.colPivHouseholderQr().solve(r);
    double part = 1;
    Eigen::VectorXd next = x - change, s = residuals(next);
    for (; part > 1e-4 && !(s.norm() < r.norm()); s = residuals(next)) next = x - (part /= 2) * change;
    if (!(s.norm() < r.norm())) break;
    x = next;
    r = s;
  }
  if (!(r.norm() < 1e-7)) return std::nullopt;
  Sampled_curve curve;
  for (int k = 0; k < c.pieces; ++k) {
    const Cubic_spiral s = spiral(x, k);
    const Plane_points way = s.positions(samples_of_a_piece);
    const Plane_point unit = c.chord[k] / way.back();
    std::vector<Curve_sample> samples;
    for (int i = 0; i <= samples_of_a_piece; ++i)
      samples.push_back({p[k] + unit * way[i], s.curvature(i / double(samples_of_a_piece) - .5) / std::abs(unit)});
    curve.push_back(samples);
  }
  return curve;
}

// Quadratic curves that meet the points where their curvature is greatest, with continuous
// curvature but for its sign at inflections.
inline Sampled_curve kappa_curve(const Plane_points& p, bool closed) {
  const int points = static_cast<int>(p.size()), n = closed ? points : points - 2, first = closed ? 0 : 1;
  if (n < 1) return {};
  const auto point = [&](int i) { return p[i + first]; };
  Plane_points middle(n), start(n), end(n);
  std::vector<double> share(n, .5), at(n, .5); // lambda behind each curve; where it meets its point
  for (int i = 0; i < n; ++i) middle[i] = point(i);
  const auto next = [&](int i) { return (i + 1) % n; };
  const auto set_ends = [&] {
    for (int i = 0; i < n; ++i) {
      if (!closed && i == n - 1) continue;
      end[i] = (1 - share[i]) * middle[i] + share[i] * middle[next(i)];
      start[next(i)] = end[i];
    }
    if (!closed) {
      start[0] = p.front();
      end[n - 1] = p.back();
    }
  };
  set_ends();
  for (int step = 0; step < 300; ++step) {
    for (int i = 0; i < n; ++i) {
      if (!closed && i == n - 1) continue;
      const double a = std::sqrt(std::abs(cross(middle[i] - start[i], middle[next(i)] - start[i]))),
                   b = std::sqrt(std::abs(cross(middle[next(i)] - middle[i], end[next(i)] - middle[i])));
      if (a + b > 0) share[i] = a / (a + b);
    }
    set_ends();
    for (int i = 0; i < n; ++i) { // the root in [0, 1] of a cubic that increases there
      const Plane_point d = end[i] - start[i], s = start[i] - point(i);
      const auto dot = [](Plane_point a, Plane_point b) { return std::real(std::conj(a) * b); };
      const auto cubic = [&](double t) {
        return dot(d, d) * t * t * t + 3 * dot(d, s) * t * t + dot(3. * start[i] - 2. * point(i) - end[i], s) * t -
               dot(s, s);
      };
      double low = 0, high = 1;
      for (int k = 0; k < 60; ++k) (cubic((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
      at[i] = (low + high) / 2;
    }
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXcd right(n);
    for (int i = 0; i < n; ++i) {
      const double t = at[i], u = 1 - t;
      right[i] = point(i);
      m(i, i) += 2 * t * u;
      if (closed || i > 0) {
        const int before = (i + n - 1) % n;
        m(i, before) += u * u * (1 - share[before]);
        m(i, i) += u * u * share[before];
      } else
        right[i] -= u * u * p.front();
      if (closed || i < n - 1) {
        m(i, i) += t * t * (1 - share[i]);
        m(i, next(i)) += t * t * share[i];
      } else
        right[i] -= t * t * p.back();
    }
    const Eigen::VectorXcd x = m.cast<Plane_point>().colPivHouseholderQr().solve(right);
    for (int i = 0; i < n; ++i) middle[i] = x[i];
    set_ends();
  }
  Sampled_curve curve;
  for (int i = 0; i < n; ++i) curve.push_back(sampled_bezier({start[i], middle[i], end[i]}));
  return curve;
}
