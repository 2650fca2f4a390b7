// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_FIT_CHAIN_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_FIT_CHAIN_H

#include <CGAL/Geometric_continuity/splines/internal/Fit_path.h>
#include <CGAL/Geometric_continuity/splines/internal/Fit_piece.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Some pieces near a part of a polyline, whose joints all move at once: points A, tangents D,
// second differences Q, and the multiples b, f before and behind each. Steps of Levenberg and
// Marquardt reduce by how much distances orthogonal to the curve are above 4/5 of the tolerance, so
// that points which are near have hardly any weight. See Polyline_fit.h.
template <int N, int degree> class Fit_chain {
  static constexpr int free_points = (degree - 1) / 2, parts = free_points + 1, samples_of_piece = 20, most_steps = 100;
  static constexpr double part_of_all = 0.02;
  typedef Fit_path<N> Path;
  typedef typename Path::Vector Vector;
  typedef Fit_piece<N, degree> Piece;

public:
  typedef std::array<double, free_points> Multiples;
  struct Joint {
    std::array<Vector, parts> v; // A, D, Q
    Multiples before, after;     // b, f
    double length;               // of D at first
    int first_free;              // of A, D, Q; those before do not move
  };

private:
  struct Sample {
    Vector x;
    double s, t, distance; // t: the number of the piece, plus the parameter on it
  };

  const Path& path_;
  const int first_; // vertex
  int last_;        // that, too
  std::vector<Joint> joints_;
  std::vector<Piece> pieces_;
  std::vector<Sample> samples_;

public:
  // From the first to the last vertex, with joints at arc lengths.
  Fit_chain(const Path& path, int first, int last, std::vector<Joint> joints, const std::vector<double>& places)
      : path_(path), first_(first), last_(last), joints_(std::move(joints)), pieces_(joints_.size() - 1) {
    const int pieces = static_cast<int>(pieces_.size());
    std::vector<double> parameters;
    for (int k = 0; k <= pieces; ++k) parameters.push_back(k);
    take_samples(places, parameters);
    set_pieces();
  }

  // From pieces in a row, with places and joints between them.
  Fit_chain(const Path& path, const std::vector<Piece>& pieces, const std::vector<Fit_place>& places,
            const std::vector<Fit_joint<N>>& joints, int first_free)
      : path_(path), first_(places[0].vertex), last_(places.back().vertex + 1), pieces_(pieces.size()) {
    std::vector<double> s, t; // of the vertices
    for (std::size_t k = 0; k < pieces.size(); ++k)
      for (std::size_t i = 0; i < pieces[k].parameters.size(); ++i) {
        const bool is_last = i + 1 == pieces[k].parameters.size();
        s.push_back(i == 0    ? path.arc_length(places[k])
                    : is_last ? path.arc_length(places[k + 1])
                              : path.arc_length(places[k].vertex + static_cast<int>(i)));
        t.push_back(static_cast<double>(k) + pieces[k].parameters[i]);
      }
    for (std::size_t k = 0; k <= pieces.size(); ++k) {
      const Fit_joint<N>& given = joints[k];
      const double square = dot(given.difference, given.difference);
      const auto multiples = [&](const Vector& near, const Vector& far) {
        Multiples h;
        h[0] = dot(near - given.point, given.difference) / square;
        if constexpr (free_points == 2)
          h[1] = dot(far - given.point - h[0] * h[0] * given.second_difference, given.difference) / square;
        return h;
      };
      Multiples before{}, after{};
      if (k > 0) before = multiples(pieces[k - 1].points[degree - 1], pieces[k - 1].points[degree - 2]);
      for (double& h : before) h = -h;
      if (k < pieces.size()) after = multiples(pieces[k].points[1], pieces[k].points[2]);
      if (k == 0) before = after;
      if (k == pieces.size()) after = before;
      const double length = std::sqrt(square);
      Joint joint = joint_of(given, k == 0 ? first_free : 0, before[0] * length, after[0] * length);
      for (int i = 1; i < free_points; ++i) {
        joint.before[i] = before[i] * length / joint.length;
        joint.after[i] = after[i] * length / joint.length;
      }
      joints_.push_back(joint);
    }
    take_samples(s, t);
    set_pieces();
  }

  double end() const { return samples_.back().s; } // an arc length

  // Extends the last piece beyond its end, by at most an arc length and a part of its parameters.
  void extend(double length, double part) {
    const int k = static_cast<int>(pieces_.size());
    std::array<Vector, degree + 1> b = pieces_.back().points, c; // c: up to the parameter v
    const double speed = degree * Path::length(b[degree] - b[degree - 1]), v = 1 + (std::min)(length / speed, part),
                 to = end() + (v - 1) * speed;
    c[0] = b[0];
    for (int m = degree; m > 0; --m) {
      for (int i = 0; i < m; ++i) b[i] += v * (b[i + 1] - b[i]);
      c[degree + 1 - m] = b[0];
    }
    Joint &start = joints_[k - 1], &last = joints_[k];
    if constexpr (free_points == 2) start.after[1] = v * (v * start.after[1] - 2 * (v - 1) * start.after[0]);
    start.after[0] *= v;
    last.v[0] = c[degree];
    last.v[1] = (1 / last.before[0]) * (c[degree] - c[degree - 1]);
    if constexpr (free_points == 2)
      last.v[2] = (1 / (last.before[0] * last.before[0])) * (c[degree - 2] - c[degree] + last.before[1] * last.v[1]);
    last.length = Path::length(last.v[1]);
    std::vector<double> s, t;
    for (const Sample& x : samples_) {
      s.push_back(x.s);
      t.push_back(x.t < k - 1 ? x.t : k - 1 + (x.t - (k - 1)) / v);
    }
    s.push_back(to);
    t.push_back(k);
    last_ = path_.vertex_after(to);
    take_samples(s, t);
    set_pieces();
  }

  // Lets the chain end at a joint.
  void end_at(const Fit_joint<N>& given, int first_free) {
    Joint& last = joints_.back();
    const Joint joint = joint_of(given, first_free, last.length, last.length);
    last.first_free = first_free;
    std::copy(joint.v.begin(), joint.v.begin() + first_free, last.v.begin());
    set_pieces();
  }

  // A joint that moves, from one that is near. Handles have two lengths at first.
  static Joint joint_of(const Fit_joint<N>& given, int first_free, double before, double after) {
    const double size = (before + after) / 2, f = size / Path::length(given.difference);
    Joint joint{{given.point, Vector(f * given.difference)}, {}, {}, size, first_free};
    if constexpr (free_points == 2) joint.v[2] = f * f * given.second_difference;
    for (int i = 0; i < free_points; ++i) {
      joint.before[i] = (i + 1) * before / size;
      joint.after[i] = (i + 1) * after / size;
    }
    return joint;
  }
  const Joint& joint(int k) const { return joints_[k]; }

  // A joint in integers: among many lengths of D it takes that for which multiples are next to
  // integers.
  Fit_joint<N> rounded_joint(int k) const {
    const Joint& joint = joints_[k];
    const double length = Path::length(joint.v[1]), longest = path_.difference(degree * joint.length, degree);
    double best = longest, least = 1;
    for (int i = 0; i < 500; ++i) {
      const double d = longest * (1 - i / 2000.);
      double error = 0;
      for (const bool is_before : {true, false})
        for (const double x : is_before ? joint.before : joint.after) {
          if (k == (is_before ? 0 : static_cast<int>(pieces_.size()))) continue; // beyond the chain
          const double multiple = x * length / d;
          error = (std::max)(error, std::abs(multiple - std::nearbyint(multiple)));
        }
      if (error < least) best = d;
      least = (std::min)(least, error);
    }
    const double f = best / length;
    Fit_joint<N> result{Path::rounded(joint.v[0]), Path::rounded(f * joint.v[1]), Vector(joint.v[0].dimension())};
    if constexpr (free_points == 2) result.second_difference = Path::rounded(f * f * joint.v[2]);
    return result;
  }

  // The parameter at an arc length of the polyline.
  double parameter(double s) const {
    const auto b = std::upper_bound(samples_.begin() + 1, samples_.end() - 1, s,
                                    [](double x, const Sample&sample) { return x < sample.s; }),
               a = b - 1;
    return b->s > a->s ? a->t + (s - a->s) / (b->s - a->s) * (b->t - a->t) : a->t;
  }
  // Where on the polyline the joint between two pieces is.
  Fit_place place(int k) const {
    std::size_t i = 1;
    while (i + 2 < samples_.size() && samples_[i].t < k) ++i;
    const Sample &a = samples_[i - 1], &b = samples_[i];
    const double part = b.t > a.t ? (std::min)((std::max)((k - a.t) / (b.t - a.t), 0.), 1.) : 0;
    return path_.place_near(joints_[k].v[0], a.s + part * (b.s - a.s), first_, last_);
  }

  // Moves the joints until `succeeds` is true, which is asked when all samples are near. Returns
  // whether it was; the patience is with steps that help little.
  template <class Predicate> bool improve(int patience, Predicate succeeds) {
    const double tolerance = path_.tolerance();
    double damping = 1e-3;
    int asked = 0, slow = 0;
    project();
    for (int step = 1; step <= most_steps; ++step) {
      const std::vector<Joint> joints = joints_;
      const std::vector<Sample> samples = samples_;
      const double before = sum();
      move_joints(damping);
      const double worst = project(), after = sum();
      if (!(after <= before)) {
        joints_ = joints;
        samples_ = samples;
        set_pieces();
        damping = 8 * damping;
        if (damping > 1e3) return false;
        continue;
      }
      damping = (std::max)(damping / 4, 1e-6);
      if (worst <= tolerance) {
        take_worst_vertices();
        if (project() <= tolerance && succeeds()) return true;
        if (++asked == 3 * patience) return false;
      } else if (after > 0.9 * before) {
        if (++slow >= (worst < 2 * tolerance ? 5 : 1) * patience) return false;
        take_worst_vertices();
      }
    }
    return false;
  }

private:
  // At equal distances, with parameters between those at some arc lengths.
  void take_samples(const std::vector<double>& s, const std::vector<double>& t) {
    const int n = samples_of_piece * static_cast<int>(pieces_.size());
    samples_.clear();
    std::size_t k = 1;
    for (int i = 0; i <= n; ++i) {
      const double at = s[0] + i / double(n) * (s.back() - s[0]);
      while (k + 1 < s.size() && s[k] < at) ++k;
      const double h = s[k] - s[k - 1], part = h > 0 ? (std::min)((std::max)((at - s[k - 1]) / h, 0.), 1.) : 0;
      samples_.push_back({path_.point_at(at), at, t[k - 1] + part * (t[k] - t[k - 1]), 0});
    }
  }

  void set_pieces() {
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      const Joint &start = joints_[k], &end = joints_[k + 1];
      std::array<Vector, degree + 1>& b = pieces_[k].points;
      b[0] = start.v[0];
      b[1] = start.v[0] + start.after[0] * start.v[1];
      b[degree] = end.v[0];
      b[degree - 1] = end.v[0] - end.before[0] * end.v[1];
      if constexpr (free_points == 2) {
        b[2] = start.v[0] + start.after[1] * start.v[1] + start.after[0] * start.after[0] * start.v[2];
        b[3] = end.v[0] - end.before[1] * end.v[1] + end.before[0] * end.before[0] * end.v[2];
      }
    }
  }

  // One damped step for all joints at once. The unknowns are lengths: of A, D, Q, and
  // multiples times the length of D.
  void move_joints(double relative) {
    const int d = joints_[0].v[0].dimension(), block = parts * d + 2 * free_points, width = 2 * block,
              n = block * static_cast<int>(joints_.size());
    std::vector<double> band(n * width, 0), r(n, 0), row(width);
    const auto a = [&](int i, int j) -> double& { return band[i * width + j - i]; };
    double total = 0;
    for (const Sample& sample : samples_) {
      const int k = piece_of(sample);
      const double t = sample.t - k;
      const std::array<Vector, 2> offset = pieces_[k].offset(t, sample.x);
      const double speed = Path::length(offset[1]);
      if (!(speed > 0)) continue;
      const Vector tangent = (1 / speed) * offset[1];
      const std::array<double, degree + 1> w = Piece::bernstein(t);
      // columns of the reflection that takes the tangent to the last axis, or away from it
      Vector normal = tangent;
      normal[d - 1] += tangent[d - 1] < 0 ? -1 : 1;
      const double square = dot(normal, normal);
      for (int x = 0; x < d - 1; ++x) { // directions orthogonal to the curve
        Vector q = (-2 * normal[x] / square) * normal;
        q[x] += 1;
        std::fill(row.begin(), row.end(), 0);
        for (const int side : {0, 1}) {
          const Joint& joint = joints_[k + side];
          const Multiples& h = side == 0 ? joint.after : joint.before;
          const double sign = side == 0 ? 1 : -1;
          const auto weight = [&](int i) { return w[side == 0 ? i : degree - i]; };
          std::array<double, parts> factor{};
          for (int i = 0; i < parts; ++i) factor[0] += weight(i);
          for (int i = 0; i < free_points; ++i) factor[1] += sign * weight(i + 1) * h[i];
          if constexpr (free_points == 2) factor[2] = weight(2) * h[0] * h[0];
          double* const entry = &row[side * block];
          for (int part = joint.first_free; part < parts; ++part)
            for (int c = 0; c < d; ++c) entry[part * d + c] = factor[part] * q[c];
          double* const multiple = entry + parts * d + (side == 0 ? free_points : 0);
          const double along = dot(q, joint.v[1]) / joint.length;
          for (int i = 0; i < free_points; ++i) multiple[i] = sign * weight(i + 1) * along;
          if constexpr (free_points == 2) multiple[0] += 2 * weight(2) * h[0] * dot(q, joint.v[2]) / joint.length;
        }
        const double excess = (std::max)(1 - aim() / Path::length(offset[0]), 0.), // of the distance
            weight_of_all = (excess > 0 ? 1 : 0) + part_of_all,
                     rest = dot(q, offset[0]) * (excess + part_of_all) / weight_of_all;
        for (int i = 0; i < width; ++i) {
          if (row[i] == 0) continue;
          const double f = weight_of_all * row[i];
          r[k * block + i] -= f * rest;
          double* const to = &a(k * block + i, k * block + i);
          for (int j = i; j < width; ++j) to[j - i] += f * row[j];
        }
      }
      total += 1;
    }
    const double damping = relative * total / static_cast<double>(pieces_.size());
    for (int i = 0; i < n; ++i) a(i, i) += damping;
    for (int i = 0; i < n; ++i) {
      const int end = (std::min)(i + width, n);
      const double* const pivot = &a(i, i);
      for (int j = i + 1; j < end; ++j) {
        const double f = pivot[j - i] / pivot[0];
        if (f == 0) continue;
        double* const to = &a(j, j);
        for (int l = j; l < end; ++l) to[l - j] -= f * pivot[l - i];
        r[j] -= f * r[i];
      }
    }
    for (int i = n; i-- > 0;) {
      for (int j = i + 1; j < (std::min)(i + width, n); ++j) r[i] -= a(i, j) * r[j];
      r[i] /= a(i, i);
    }
    for (std::size_t k = 0; k < joints_.size(); ++k) {
      Joint& joint = joints_[k];
      const auto change = [&](int i) {
        return (std::min)((std::max)(r[k * block + i], -joint.length / 2), joint.length / 2);
      };
      for (int i = 0; i < parts * d; ++i) joint.v[i / d][i % d] += change(i);
      for (int i = 0; i < free_points; ++i) {
        joint.before[i] += change(parts * d + i) / joint.length;
        joint.after[i] += change(parts * d + free_points + i) / joint.length;
      }
      joint.before[0] = (std::min)((std::max)(joint.before[0], 0.1), 4. * degree);
      joint.after[0] = (std::min)((std::max)(joint.after[0], 0.1), 4. * degree);
    }
    set_pieces();
  }

  double aim() const { return 0.8 * path_.tolerance(); }
  double sum() const {
    double result = 0;
    for (const Sample& x : samples_) {
      const double excess = (std::max)(x.distance - aim(), 0.);
      result += excess * excess + part_of_all * x.distance * x.distance;
    }
    return result;
  }

  int piece_of(const Sample& sample) const {
    return (std::min)((std::max)(static_cast<int>(sample.t), 0), static_cast<int>(pieces_.size()) - 1);
  }
  // Moves the parameter of a sample to the point next to it, and finds the distance.
  void project(Sample& sample) const {
    const int from = piece_of(sample);
    double next = pieces_[from].projected(sample.t - from, sample.x);
    if (next < 0) next *= joints_[from].after[0] / joints_[from].before[0]; // on the piece before
    if (next > 1) next = 1 + (next - 1) * joints_[from + 1].before[0] / joints_[from + 1].after[0];
    sample.t = from + (std::min)((std::max)(next, -0.3), 1.3);
    sample.t = (std::min)((std::max)(sample.t, 0.), static_cast<double>(pieces_.size()));
    const int k = piece_of(sample);
    sample.distance = Path::length(pieces_[k].offset(sample.t - k, sample.x)[0]);
  }
  double project() {
    double worst = 0;
    for (Sample& x : samples_) {
      project(x);
      worst = (std::max)(worst, x.distance);
    }
    return worst;
  }

  // Puts samples where vertices are farther from the curve.
  void take_worst_vertices() {
    std::vector<Sample> worst = samples_;
    std::size_t k = 1;
    for (int v = first_ + 1; v < last_; ++v) {
      const double s = path_.arc_length(v);
      while (k + 1 < samples_.size() && samples_[k].s < s) ++k;
      const Sample &a = samples_[k - 1], &b = samples_[k];
      const double part = b.s > a.s ? (s - a.s) / (b.s - a.s) : 0;
      Sample x{path_.vertex(v), s, a.t + part * (b.t - a.t), 0};
      for (int i = 0; i < 3; ++i) project(x);
      const std::size_t nearest = (std::min)((std::max)(part < 0.5 ? k - 1 : k, std::size_t(1)), samples_.size() - 2);
      if (x.distance > worst[nearest].distance) worst[nearest] = x;
    }
    samples_ = std::move(worst);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_FIT_CHAIN_H
