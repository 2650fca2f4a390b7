// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

// The least number of Bezier curves near a polyline in the plane, without any condition where they
// meet, for comparison with `fit`. A part of a piece that is near is near, too: so the least number
// over all places where pieces may end is that of the longest pieces, one after the other. Each is
// found by steps of Gauss and Newton for the orthogonal distances, whose weights grow where the
// distance is large, with all control points free.

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

typedef std::vector<std::pair<double, double>> Plane_polyline;

inline Eigen::VectorXd bernstein(int degree, double t) {
  Eigen::VectorXd b(degree + 1);
  double binomial = 1;
  for (int i = 0; i <= degree; ++i) {
    b[i] = binomial * std::pow(t, i) * std::pow(1 - t, degree - i);
    binomial = binomial * (degree - i) / (i + 1);
  }
  return b;
}

// Returns whether a curve is within the tolerance of the vertices from i to j, and of points
// between them.
inline bool is_one_piece(const Plane_polyline& p, int i, int j, int degree, double tolerance) {
  const int parts = j - i < 12 ? 4 : j - i < 60 ? 2 : 1, n = (j - i) * parts + 1, unknowns = 2 * (degree + 1);
  Eigen::MatrixX2d x(n, 2);
  std::vector<double> u(n, 0), weight(n, 1);
  for (int k = 0; k < n; ++k) {
    const int at = i + k / parts;
    const double f = k % parts / double(parts);
    const auto& [px, py] = p[at];
    const auto& [qx, qy] = p[(std::min)(at + 1, j)];
    x.row(k) << px + f * (qx - px), py + f * (qy - py);
    if (k > 0) u[k] = u[k - 1] + (x.row(k) - x.row(k - 1)).norm();
  }
  for (double& v : u) v /= u.back();
  Eigen::MatrixXd a(n, degree + 1);
  for (int k = 0; k < n; ++k) a.row(k) = bernstein(degree, u[k]).transpose();
  Eigen::MatrixXd normal = a.transpose() * a;
  normal.diagonal().array() += 1e-13 * normal.trace();
  Eigen::MatrixX2d b = normal.ldlt().solve(a.transpose() * x); // control points
  for (int step = 0; step < 30; ++step) {
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(unknowns, unknowns);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(unknowns);
    std::vector<double> distance(n), next = u;
    for (int k = 0; k < n; ++k) {
      const Eigen::VectorXd c = bernstein(degree, u[k]);
      const Eigen::RowVector2d offset = c.transpose() * b - x.row(k),
                               speed = degree * bernstein(degree - 1, u[k]).transpose() *
                                       (b.bottomRows(degree) - b.topRows(degree)),
                               t = speed.normalized(), across(-t[1], t[0]);
      const bool is_end = k == 0 || k == n - 1;
      distance[k] = is_end ? offset.norm() : std::abs(offset.dot(across));
      if (!is_end) next[k] -= offset.dot(t) / speed.norm();
      for (const Eigen::RowVector2d& direction : {across, t}) {
        if (direction == t && !is_end) continue;
        Eigen::VectorXd row(unknowns);
        row << direction[0] * c, direction[1] * c;
        m += weight[k] * row * row.transpose();
        gradient += weight[k] * offset.dot(direction) * row;
      }
    }
    const double worst = *std::max_element(distance.begin(), distance.end());
    if (worst <= tolerance) return true;
    if (step > 8 && worst > 6 * tolerance) return false;
    if (step > 5)
      for (int k = 0; k < n; ++k) weight[k] *= 0.3 + distance[k] / worst;
    m.diagonal().array() += 1e-10 * m.trace();
    const Eigen::VectorXd change = m.ldlt().solve(gradient);
    b.col(0) -= change.head(degree + 1);
    b.col(1) -= change.tail(degree + 1);
    for (double& v : next) v = (std::min)((std::max)(v, 0.), 1.);
    std::sort(next.begin(), next.end());
    u = next;
  }
  return false;
}

inline int least_pieces(const Plane_polyline& p, int degree, double tolerance) {
  const int n = static_cast<int>(p.size());
  int count = 0;
  for (int i = 0; i < n - 1; ++count) {
    int good = i + 1, bad = n;
    for (int length = 2; good < n - 1 && bad == n; length *= 2) {
      const int j = (std::min)(i + length, n - 1);
      (is_one_piece(p, i, j, degree, tolerance) ? good : bad) = j;
    }
    while (bad - good > 1) {
      const int j = (good + bad) / 2;
      (is_one_piece(p, i, j, degree, tolerance) ? good : bad) = j;
    }
    i = good;
  }
  return count;
}

struct Polyline_to_fit {
  std::string name;
  double tolerance;
  Plane_polyline points;
};

// Polylines with 500 vertices: arcs, spirals, sines, letters, coastlines, and noise of half the
// tolerance.
inline std::vector<Polyline_to_fit> polylines_to_fit() {
  constexpr int n = 500;
  constexpr double pi = 3.141592653589793;
  typedef std::pair<double, double> Pair;
  typedef std::function<Pair(double)> Function;
  std::vector<Polyline_to_fit> all;
  const auto add = [&](const std::string& name, double tolerance, const Function& f, int noise_seed = 0) {
    std::mt19937 random(noise_seed);
    Polyline_to_fit p{name, tolerance, {}};
    for (int i = 0; i < n; ++i) {
      const auto [x, y] = f(i / double(n - 1));
      const double angle = 2 * pi * static_cast<double>(random()) / 4294967296.,
                   size = noise_seed > 0 ? tolerance / 2 : 0;
      p.points.emplace_back(x + size * std::cos(angle), y + size * std::sin(angle));
    }
    all.push_back(p);
  };
  const auto arc = [](double angle) -> Function {
    return [=](double t) { return Pair(std::cos(angle * t), std::sin(angle * t)); };
  };
  const auto spiral = [](double turns) -> Function {
    return [=](double t) {
      return Pair((.1 + t) * std::cos(2 * pi * turns * t), (.1 + t) * std::sin(2 * pi * turns * t));
    };
  };
  const auto sine = [](double waves, double height) -> Function {
    return [=](double t) { return Pair(10 * t, height * std::sin(waves * t)); };
  };
  const auto coast = [](int seed, double power) -> Function {
    std::mt19937 random(seed);
    std::array<double, 60> x{}, y{};
    for (std::size_t k = 1; k < x.size(); ++k)
      for (double* c : {&x[k], &y[k]})
        *c = (static_cast<double>(random()) / 2147483648. - 1) * 1.7 * std::pow(k, -power);
    return [=](double t) {
      Pair p(6 * t, 0);
      for (std::size_t k = 1; k < x.size(); ++k) {
        p.first += x[k] * std::sin(pi * static_cast<double>(k) * t);
        p.second += y[k] * std::sin(pi * static_cast<double>(k) * t);
      }
      return p;
    };
  };
  add("arc of 180 degrees", 1e-3, arc(pi));
  add("arc of 57 degrees", 1e-5, arc(1));
  add("circle", 3e-5, arc(2 * pi));
  add("arc of 344 degrees", 2.5e-5, arc(6));
  add("spiral of 2 turns", 1e-2, spiral(2));
  add("spiral of 5 turns", 2e-3, spiral(5));
  add("sine", 1e-3, sine(8, 2));
  add("steep sine", 1e-2, sine(20, 1));
  add("steeper sine", 2e-2, sine(40, 1));
  add("many waves", 5e-2, sine(60, .5));
  add("letter S", 5e-3, [](double t) {
    const double a = 3 * pi * t, b = pi / 2 - (a - 1.5 * pi);
    return a < 1.5 * pi ? Pair(std::cos(a), 1 + std::sin(a)) : Pair(std::cos(b), std::sin(b) - 1);
  });
  add("letter O", 1e-2, [](double t) {
    const auto power = [](double v) { return std::copysign(std::pow(std::abs(v), 0.6), v); };
    return Pair(3 * power(std::cos(2 * pi * t)), 4 * power(std::sin(2 * pi * t)));
  });
  add("letter U", 2e-2, [](double t) {
    const double s = t * (20 + 3 * pi);
    if (s < 10) return Pair(-3, 10 - s);
    if (s > 10 + 3 * pi) return Pair(3, s - 10 - 3 * pi);
    return Pair(-3 * std::cos((s - 10) / 3), -3 * std::sin((s - 10) / 3));
  });
  add("coastline", 2e-2, coast(1, 1.7));
  add("smooth coastline", 1e-2, coast(2, 2.2));
  add("coastline from afar", 1e-1, coast(3, 1.7));
  add("noisy arc", 1e-2, arc(pi), 1);
  add("noisy sine", 2e-2, sine(20, 1), 2);
  add("noisy spiral", 1e-2, spiral(2), 3);
  add(
      "noisy line", 1e-1, [](double t) { return Pair(10 * t, 3 * t); }, 4);
  return all;
}
