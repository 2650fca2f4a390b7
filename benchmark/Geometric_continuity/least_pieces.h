// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

// How few Bezier curves can be near a polyline in the plane, for comparison with `fit`:
//
// - No fewer than the least number of curves of which each is near the vertices of a run, without
//   any condition where they meet: a dynamic program over the vertices. Pieces may end between
//   vertices, so the next run starts with the next vertex. A part of a curve that is near is near,
//   too: the longest run from a vertex on is sought from that of the vertex before.
// - The number of a chain with the joins, whose joints all move: chains of more and more pieces,
//   each as far as it leads. The next one splits the last piece, and then its end moves along the
//   vertices.
//
// A curve or chain is found by steps of Levenberg and Marquardt, which reduce by how much
// orthogonal distances are above almost the tolerance. Neither number is proved.

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

typedef std::vector<std::pair<double, double>> Plane_polyline;

typedef Eigen::RowVector2d Plane_vector;
typedef Eigen::Matrix<double, Eigen::Dynamic, 2, 0, 6, 2> Bezier_points;

inline std::array<double, 6> bernstein(int degree, double t) {
  std::array<double, 6> b{1};
  for (int m = 1; m <= degree; ++m)
    for (int i = m; i >= 0; --i) b[i] = (1 - t) * b[i] + (i > 0 ? t * b[i - 1] : 0);
  return b;
}
// A point and the derivative.
inline std::pair<Plane_vector, Plane_vector> value(Bezier_points b, double t) {
  const int degree = static_cast<int>(b.rows()) - 1;
  for (int m = degree; m > 1; --m)
    for (int i = 0; i < m; ++i) b.row(i) += t * (b.row(i + 1) - b.row(i));
  const Plane_vector difference = b.row(1) - b.row(0);
  return {b.row(0) + t * difference, degree * difference};
}
// The control points between two parameters.
inline Bezier_points part(const Bezier_points& b, double u, double v) {
  const int degree = static_cast<int>(b.rows()) - 1;
  Bezier_points result(degree + 1, 2);
  for (int k = 0; k <= degree; ++k) {
    Bezier_points c = b;
    for (int m = degree; m > 0; --m)
      for (int i = 0; i < m; ++i) c.row(i) += (m > k ? u : v) * (c.row(i + 1) - c.row(i));
    result.row(k) = c.row(0);
  }
  return result;
}

// The search makes this small: excesses above almost the tolerance, and a little of all distances.
struct Excess {
  static constexpr double part_of_all = 1e-5;
  double aim;
  double of(double distance) const { return distance > aim ? 1 - aim / distance : 0; } // as a part of it
  double weight(double distance) const { return (distance > aim ? 1 : 0) + part_of_all; }
  double sum(const std::vector<double>& distances) const {
    double result = 0;
    for (const double d : distances) {
      const double excess = (std::max)(d - aim, 0.);
      result += excess * excess + part_of_all * d * d;
    }
    return result;
  }
};

// Makes damped steps until a curve is near; returns whether it is.
template <class Curve> bool improve(Curve& curve, int most, double tolerance, const Excess& excess) {
  if (curve.project() <= tolerance) return true;
  double damping = 1e-3;
  int slow = 0;
  for (int step = 0; step < most; ++step) {
    const Curve old = curve;
    const double before = excess.sum(old.distances());
    curve.move(damping);
    const double worst = curve.project(), after = excess.sum(curve.distances());
    if (worst <= tolerance) return true;
    if (!(after <= before)) {
      curve = old;
      damping *= 8;
      if (damping > 1e4) return false;
      continue;
    }
    damping = (std::max)(damping / 4, 1e-9);
    if (after > 0.97 * before && ++slow > 16) return false;
  }
  return false;
}

// One curve near the vertices from `first` to `last`, whose control points all move.
class Piece_near_vertices {
  const Plane_polyline* p_;
  int degree_;
  Excess excess_;
  Bezier_points b_;
  std::vector<double> t_, distance_; // of the vertices

public:
  int first, last;

  // By least squares.
  Piece_near_vertices(const Plane_polyline& p, int degree, double tolerance, int from, int to)
      : p_(&p), degree_(degree), excess_{0.97 * tolerance}, first(from), last(to) {
    const int n = to - from + 1;
    for (int k = 0; k < n; ++k) t_.push_back(k == 0 ? 0 : t_.back() + (vertex(k) - vertex(k - 1)).norm());
    Eigen::MatrixXd a(n, degree + 1);
    Eigen::MatrixX2d x(n, 2);
    for (int k = 0; k < n; ++k) {
      t_[k] /= t_.back();
      const std::array<double, 6> b = bernstein(degree, t_[k]);
      for (int i = 0; i <= degree; ++i) a(k, i) = b[i];
      x.row(k) = vertex(k);
    }
    Eigen::MatrixXd normal = a.transpose() * a;
    normal.diagonal().array() += 1e-13 * normal.trace();
    b_ = normal.ldlt().solve(a.transpose() * x);
  }

  const Bezier_points& points() const { return b_; }
  const std::vector<double>& parameters() const { return t_; }
  const std::vector<double>& distances() const { return distance_; }

  void shorten() { // without the first vertex
    const double u = t_[1];
    b_ = part(b_, u, 1);
    t_.erase(t_.begin());
    for (double& t : t_) t = (t - u) / (1 - u);
    ++first;
  }
  void lengthen() { // with the next vertex
    const double step = (vertex(last + 1 - first) - vertex(last - first)).norm(),
                 v = 1 + (std::min)(step / value(b_, 1).second.norm(), 0.5);
    b_ = part(b_, 0, v);
    for (double& t : t_) t /= v;
    t_.push_back(1);
    ++last;
  }
  double project() {
    const std::size_t n = t_.size();
    for (std::size_t i = 1; i + 1 < n; ++i)
      for (int repetition = 0; repetition < 2; ++repetition) {
        const auto [x, speed] = value(b_, t_[i]);
        const double next = t_[i] - (x - vertex(static_cast<int>(i))).dot(speed) / speed.squaredNorm();
        if (std::isfinite(next)) t_[i] = (std::min)((std::max)(next, 0.), 1.);
      }
    std::sort(t_.begin(), t_.end());
    distance_.clear();
    for (std::size_t i = 0; i < n; ++i)
      distance_.push_back((value(b_, t_[i]).first - vertex(static_cast<int>(i))).norm());
    return *std::max_element(distance_.begin(), distance_.end());
  }
  void move(double relative_damping) {
    const int n = degree_ + 1;
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    Eigen::VectorXd r = Eigen::VectorXd::Zero(2 * n), row(2 * n);
    for (std::size_t i = 0; i < t_.size(); ++i) {
      const auto [x, speed] = value(b_, t_[i]);
      const std::array<double, 6> w = bernstein(degree_, t_[i]);
      const Eigen::Map<const Eigen::VectorXd> c(w.data(), n);
      const Plane_vector offset = x - vertex(static_cast<int>(i)), t = speed.normalized();
      const bool is_end = i == 0 || i + 1 == t_.size(); // its distance is not orthogonal
      for (const Plane_vector& q : {Plane_vector(-t[1], t[0]), t}) {
        if (q == t && !is_end) continue;
        row << q[0] * c, q[1] * c;
        a.selfadjointView<Eigen::Lower>().rankUpdate(row, excess_.weight(distance_[i]));
        r += (excess_.of(distance_[i]) + Excess::part_of_all) * offset.dot(q) * row;
      }
    }
    a = a.selfadjointView<Eigen::Lower>();
    a.diagonal().array() += relative_damping * a.trace() / (2 * n);
    const Eigen::VectorXd step = a.ldlt().solve(r);
    b_.col(0) -= step.head(n);
    b_.col(1) -= step.tail(n);
  }

private:
  Plane_vector vertex(int k) const { return {(*p_)[first + k].first, (*p_)[first + k].second}; }
};

// Cubics with G1 joins, or quintics with G2 joins, near the vertices from `first` to `last`.
class Chain_near_vertices {
  typedef Plane_vector Vector;
  typedef Bezier_points Points;
  struct Joint {
    Vector point;
    double angle, bend;                  // of the tangent; of the third control points, over the square of a handle
    std::array<double, 2> before, after; // of the second and third control points, on the tangent
  };
  const Plane_polyline* p_;
  int degree_, free_, unknowns_; // unknowns of a joint
  Excess excess_;
  std::vector<Joint> joints_;
  std::vector<double> t_, distance_; // of the vertices; t: piece plus parameter

public:
  int last;

  // One piece from the first vertex on.
  Chain_near_vertices(const Plane_polyline& p, int degree, double tolerance, const Piece_near_vertices& piece)
      : p_(&p), degree_(degree), free_((degree - 1) / 2), unknowns_(degree == 3 ? 5 : 8), excess_{0.95 * tolerance},
        joints_(2), t_(piece.parameters()), last(piece.last) {
    set_start(joints_[0], piece.points());
    set_end(joints_[1], piece.points());
    joints_[0].before = joints_[0].after;
    joints_[1].after = joints_[1].before;
  }

  const std::vector<double>& distances() const { return distance_; }
  int pieces() const { return static_cast<int>(joints_.size()) - 1; }

  // With the next vertex, beyond the end of the last piece.
  void lengthen() {
    const int k = pieces();
    const Points b = points(k - 1);
    const double speed = degree_ * (b.row(degree_) - b.row(degree_ - 1)).norm(),
                 step = (vertex(last + 1) - vertex(last)).norm(), v = 1 + (std::min)(step / speed, 0.3);
    const Points longer = part(b, 0, v);
    set_start(joints_[k - 1], longer);
    set_end(joints_[k], longer);
    for (double& t : t_)
      if (t > k - 1) t = k - 1 + (t - (k - 1)) / v;
    t_.push_back(k);
    ++last;
  }
  void split_last_piece(double at) {
    const int k = pieces();
    const Points b = points(k - 1), left = part(b, 0, at), right = part(b, at, 1);
    Joint middle;
    set_end(middle, left);
    set_start(middle, right);
    set_start(joints_[k - 1], left);
    set_end(joints_[k], right);
    joints_.insert(joints_.begin() + k, middle);
    for (double& t : t_)
      if (const double u = t - (k - 1); u > 0) t = u < at ? k - 1 + u / at : k + (u - at) / (1 - at);
    t_.back() = k + 1;
  }

  // Moves the parameters to the nearest points; returns the largest distance.
  double project() {
    std::vector<Points> b;
    for (int k = 0; k < pieces(); ++k) b.push_back(points(k));
    const std::size_t n = t_.size();
    for (std::size_t i = 1; i + 1 < n; ++i)
      for (int repetition = 0; repetition < 2; ++repetition) {
        const int k = piece_of(t_[i]);
        const auto [x, speed] = value(b[k], t_[i] - k);
        double next = t_[i] - k - (x - vertex(static_cast<int>(i))).dot(speed) / speed.squaredNorm();
        if (next < 0 && k > 0) next *= joints_[k].after[0] / joints_[k].before[0]; // on the piece before
        if (next > 1 && k + 1 < pieces()) next = 1 + (next - 1) * joints_[k + 1].before[0] / joints_[k + 1].after[0];
        if (std::isfinite(next))
          t_[i] = (std::min)((std::max)(k + (std::min)((std::max)(next, -0.3), 1.3), 0.), double(pieces()));
      }
    t_.front() = 0;
    t_.back() = pieces();
    std::sort(t_.begin(), t_.end());
    distance_.clear();
    for (std::size_t i = 0; i < n; ++i) {
      const int k = piece_of(t_[i]);
      distance_.push_back((value(b[k], t_[i] - k).first - vertex(static_cast<int>(i))).norm());
    }
    return *std::max_element(distance_.begin(), distance_.end());
  }
  // One damped step. The unknowns are lengths: point, angle, bend, handles before and after.
  void move(double relative_damping) {
    const int n = unknowns_ * static_cast<int>(joints_.size());
    std::vector<double> size;
    for (std::size_t k = 0; k < joints_.size(); ++k)
      size.push_back(k == 0                    ? joints_[k].after[0]
                     : k + 1 == joints_.size() ? joints_[k].before[0]
                                               : (joints_[k].before[0] + joints_[k].after[0]) / 2);
    std::vector<Points> b;
    for (int k = 0; k < pieces(); ++k) b.push_back(points(k));
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd r = Eigen::VectorXd::Zero(n), row(2 * unknowns_);
    for (std::size_t i = 0; i < t_.size(); ++i) {
      const int k = piece_of(t_[i]);
      const auto [x, speed] = value(b[k], t_[i] - k);
      const std::array<double, 6> w = bernstein(degree_, t_[i] - k);
      const Vector offset = x - vertex(static_cast<int>(i)), t = speed.normalized();
      const bool is_end = i == 0 || i + 1 == t_.size(); // its distance is not orthogonal
      for (const Vector& q : {Vector(-t[1], t[0]), t}) {
        if (q == t && !is_end) continue;
        row.setZero();
        for (const int side : {0, 1}) {
          const Joint& j = joints_[k + side];
          const double sign = side == 0 ? 1 : -1, length = size[k + side], along = q.dot(tangent(j)),
                       across = q.dot(normal(j));
          const std::array<double, 2>& h = side == 0 ? j.after : j.before;
          const auto factor = [&](int m) { return w[side == 0 ? m : degree_ - m]; };
          double* const to = &row[side * unknowns_];
          double* const handle = to + (free_ == 2 ? 4 : 3) + (side == 0 ? free_ : 0);
          const double whole = factor(0) + factor(1) + (free_ == 2 ? factor(2) : 0);
          to[0] = whole * q[0];
          to[1] = whole * q[1];
          to[2] = sign * factor(1) * h[0] * across / length;
          handle[0] = sign * factor(1) * along;
          if (free_ == 1) continue;
          to[2] += factor(2) * (sign * h[1] * across - h[0] * h[0] * j.bend * along) / length;
          to[3] = factor(2) * h[0] * h[0] * across / (length * length);
          handle[0] += 2 * factor(2) * h[0] * j.bend * across;
          handle[1] = sign * factor(2) * along;
        }
        const Eigen::Index at = k * unknowns_;
        a.block(at, at, row.size(), row.size()) += excess_.weight(distance_[i]) * row * row.transpose();
        r.segment(at, row.size()) -= (excess_.of(distance_[i]) + Excess::part_of_all) * offset.dot(q) * row;
      }
    }
    a.diagonal().array() += relative_damping * static_cast<double>(t_.size()) / pieces();
    const Eigen::VectorXd step = a.llt().solve(r);
    for (std::size_t k = 0; k < joints_.size(); ++k) {
      Joint& j = joints_[k];
      const double length = size[k];
      Eigen::Index at = static_cast<Eigen::Index>(k) * unknowns_;
      const auto change = [&] { return (std::min)((std::max)(step[at++], -length / 2), length / 2); };
      j.point[0] += change();
      j.point[1] += change();
      j.angle += change() / length;
      if (free_ == 2) j.bend += change() / (length * length);
      for (std::array<double, 2>* const h : {&j.before, &j.after}) {
        (*h)[0] = (std::min)((std::max)((*h)[0] + change(), 0.1 * length), 10 * length);
        if (free_ == 2) (*h)[1] += change();
      }
    }
  }

private:
  Vector vertex(int k) const { return {(*p_)[k].first, (*p_)[k].second}; }
  static Vector tangent(const Joint& j) { return {std::cos(j.angle), std::sin(j.angle)}; }
  static Vector normal(const Joint& j) { return {-std::sin(j.angle), std::cos(j.angle)}; }
  Points points(int piece) const {
    const Joint &s = joints_[piece], &e = joints_[piece + 1];
    Points b(degree_ + 1, 2);
    b.row(0) = s.point;
    b.row(1) = s.point + s.after[0] * tangent(s);
    b.row(degree_) = e.point;
    b.row(degree_ - 1) = e.point - e.before[0] * tangent(e);
    if (free_ == 2) {
      b.row(2) = s.point + s.after[1] * tangent(s) + s.after[0] * s.after[0] * s.bend * normal(s);
      b.row(3) = e.point - e.before[1] * tangent(e) + e.before[0] * e.before[0] * e.bend * normal(e);
    }
    return b;
  }
  // A joint where a piece starts, or ends, from the control points of the piece.
  void set_start(Joint& j, const Points& b) const {
    const Vector handle = b.row(1) - b.row(0);
    set(j, b.row(0), handle, b.row(2) - b.row(0), 1, j.after);
  }
  void set_end(Joint& j, const Points& b) const {
    const Vector handle = b.row(degree_) - b.row(degree_ - 1);
    set(j, b.row(degree_), handle, b.row(degree_ - 2) - b.row(degree_), -1, j.before);
  }
  void set(Joint& j, const Vector& point, const Vector& handle, const Vector& third, int sign,
           std::array<double, 2>& handles) const {
    j.point = point;
    j.angle = std::atan2(handle[1], handle[0]);
    handles = {handle.norm(), sign * third.dot(tangent(j))};
    j.bend = free_ == 2 ? third.dot(normal(j)) / handle.squaredNorm() : 0;
  }

  int piece_of(double t) const { return (std::min)((std::max)(static_cast<int>(t), 0), pieces() - 1); }
};

// Moves the end as far as it finds a curve that is near, at most some vertices at once.
template <class Curve>
void lengthen(Curve& curve, const Plane_polyline& p, double tolerance, int most, int steps, const Excess& excess) {
  const int end = static_cast<int>(p.size()) - 1;
  for (int step = most; step > 0 && curve.last < end;) {
    Curve longer = curve;
    while (longer.last < (std::min)(curve.last + step, end)) longer.lengthen();
    if (improve(longer, steps, tolerance, excess)) {
      curve = longer;
      step = (std::min)(2 * step, most);
    } else
      step /= 2;
  }
}
// One piece, which may start anew.
inline void lengthen(Piece_near_vertices& piece, const Plane_polyline& p, int degree, double tolerance) {
  const Excess excess{0.97 * tolerance};
  for (;;) {
    lengthen(piece, p, tolerance, 1, 60, excess);
    if (piece.last + 1 == static_cast<int>(p.size())) return;
    Piece_near_vertices other(p, degree, tolerance, piece.first, piece.last + 1);
    if (!improve(other, 60, tolerance, excess)) return;
    piece = other;
  }
}

// The least number of curves without any condition where they meet.
inline int least_pieces(const Plane_polyline& p, int degree, double tolerance) {
  const int n = static_cast<int>(p.size());
  std::vector<int> least(n + 1, n); // for as many vertices
  least[0] = 0;
  Piece_near_vertices piece(p, degree, tolerance, 0, degree);
  for (int i = 0; i < n; ++i) {
    lengthen(piece, p, degree, tolerance);
    for (int j = i; j <= piece.last; ++j) least[j + 1] = (std::min)(least[j + 1], least[i] + 1);
    if (piece.last + 1 == n) break; // later ones end there, too
    piece.shorten();
  }
  return least[n];
}

// The number of pieces of a chain with the joins.
inline int pieces_of_chain(const Plane_polyline& p, int degree, double tolerance) {
  Piece_near_vertices piece(p, degree, tolerance, 0, degree);
  lengthen(piece, p, degree, tolerance);
  const Excess excess{0.95 * tolerance};
  Chain_near_vertices chain(p, degree, tolerance, piece);
  while (chain.last + 1 < static_cast<int>(p.size())) {
    std::optional<Chain_near_vertices> best;
    for (const double at : {0.3, 0.5, 0.7, 0.85, 0.95}) {
      Chain_near_vertices next = chain;
      next.split_last_piece(at);
      next.project();
      lengthen(next, p, tolerance, 16, 100, excess);
      if (!best || next.last > best->last) best = next;
    }
    chain = *best;
  }
  return chain.pieces();
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
