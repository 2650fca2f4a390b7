// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_JOINTS_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_JOINTS_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/internal/solve_positive_definite.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_family.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_minimum.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_turns.h>
#include <CGAL/Geometric_continuity/blends/internal/Fairness_quadrature.h>
#include <CGAL/Geometric_continuity/blends/internal/joint_circles.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

// Tangents and curvatures at points through which a fair spline leads, and the handles of the
// quintics between them, in floating-point numbers. They start with those of circles through three
// points; then all together get those with the least
//
//   sum over the pieces of  int |(dK/ds)_perp|^2 ds
//
// by steps of Gauss and Newton, whose matrix couples neighbours only. In the plane a condition
// comes first: where the polygon turns to the same side at both ends of a piece, its tangents lie
// inside of the angles of the chords, its curvatures have the sign of the turn, and so have the
// corners of its control polygon, as far as that is possible. Then the curve has no more
// inflections than the polygon. Nothing depends on the order of the points.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <int M> class Fair_joints {
  typedef Coordinate_vector<double, M> Vector;
  typedef Fair_joint<M> Joint;
  typedef Fair_family<Blend_kind::g2, M> Family;
  typedef typename Family::Unknowns Shape; // of a piece
  static constexpr int nodes = 12, most_steps = 16;
  static constexpr double tolerance = 1e-3;
  static constexpr double corner_weight = 0.001; // of a corner of a control polygon that hardly turns

  // The free numbers of a joint: the angle by which the tangent turns, and the change of the
  // curvature in units of 1/h, for each normal.
  static constexpr int normals = M - 1, free = 2 * normals, shape_free = 4, all = 2 * free + shape_free;
  typedef std::array<double, free> Numbers;
  typedef std::array<Numbers, free> Block;

  struct Value {
    double sum = 0;
    bool is_resolved = true; // no bend hides between the nodes of the quadrature
  };
  struct Piece {
    double length, damping = 1e-3;
    Value value;
    bool stays = false;           // in the last step
    int quiet = 0;                // how many steps have hardly changed it and its neighbours
    Shape neutral{}, x{}, next{}; // the first one costs nothing
    // the equations of its shape, from which its numbers before are eliminated
    std::array<std::array<double, all>, shape_free> row;
    std::array<double, shape_free> right;
  };

  std::vector<Joint>& joints_;
  const bool closed_;
  std::vector<Piece> pieces_;
  std::vector<double> size_; // the shorter chord at each joint
  std::vector<char> rests_;  // joints
  std::optional<Fair_turns> turns_;

public:
  Fair_joints(std::vector<Joint>& joints, bool closed) : joints_(joints), closed_(closed) {
    const int n = number();
    for (int i = 0; i < (closed ? n : n - 1); ++i) {
      const Vector chord = joints_[next(i)].point - joints_[i].point;
      pieces_.push_back({});
      pieces_.back().length = std::sqrt(dot(chord, chord));
    }
    for (int i = 0; i < n; ++i) {
      const double before = has_before(i) ? pieces_[before_(i)].length : pieces_[i].length;
      size_.push_back((std::min)(before, has_after(i) ? pieces_[i].length : before));
    }
    rests_.assign(n, 0);
    if constexpr (M == 2) turns_.emplace(joints_, closed_);
  }

  // Takes steps until they help no more; returns the handles of the pieces.
  std::vector<Fair_handles> minimise() {
    if constexpr (M == 2)
      for (int i = 0; i < number(); ++i) turns_->confine(joints_, i, 0.02);
    double last = 0;
    for (int i = 0; i < pieces(); ++i) {
      Piece& p = pieces_[i];
      for (int k = 0; k < shape_free; ++k) p.x[k] = p.neutral[k] = speed_of_arc(k, joints_[i], joints_[next(i)]);
      begin_without_waves(i);
      p.value = value(p, joints_[i], joints_[next(i)], p.x, i);
      last += p.value.sum;
    }
    int failures = 0;
    for (int step = 0; step < most_steps && failures < 4 && find_resting() < number(); ++step) {
      std::vector<Joint> moved = proposed();
      const std::vector<Value> values = values_after(moved);
      double now = 0;
      for (const Value& v : values) now += v.sum;
      const bool better = now < last;
      for (int i = 0; i < pieces(); ++i) {
        Piece& p = pieces_[i];
        if (p.stays || (!better && values[i].sum > p.value.sum))
          p.damping = (std::min)(10 * p.damping, 1e6);
        else if (better && values[i].sum <= p.value.sum)
          p.damping = (std::max)(p.damping / 4, 1e-7);
        if (better)
          p.quiet = p.stays || !(std::abs(around(i, values) - around(i)) <= tolerance * around(i)) ? 0 : p.quiet + 1;
      }
      failures = better ? 0 : failures + 1;
      if (!better) continue;
      for (int i = 0; i < pieces(); ++i) {
        pieces_[i].value = values[i];
        pieces_[i].x = pieces_[i].next;
      }
      joints_ = std::move(moved);
      last = now;
    }
    std::vector<Fair_handles> handles;
    for (int i = 0; i < pieces(); ++i) handles.push_back(handles_of(i));
    return handles;
  }

private:
  // Finds out which joints stay where they are: those beside which nothing has changed in two
  // steps. Returns how many there are.
  int find_resting() {
    int resting = 0, moving = 0;
    for (int i = 0; i < number(); ++i) {
      rests_[i] = (!has_before(i) || pieces_[before_(i)].quiet > 1) && (!has_after(i) || pieces_[i].quiet > 1);
      resting += rests_[i];
    }
    for (int i = 0; i < pieces(); ++i) moving += !rests(i);
    // about 3000 nanoseconds for each piece
    if (Work_meter* const work = Work_meter::scope()) work->charge_products(300. * moving, 1);
    return resting;
  }
  bool rests(int piece) const { return rests_[piece] && rests_[next(piece)]; }

  // The sum of the values of a piece and its neighbours.
  template <class Values> double around(int i, const Values& value_of) const {
    return value_of(i).sum + (has_before(i) ? value_of(before_(i)).sum : 0) +
           (has_after(next(i)) ? value_of(next(i)).sum : 0);
  }
  double around(int i) const {
    return around(i, [&](int k) { return pieces_[k].value; });
  }
  double around(int i, const std::vector<Value>& values) const {
    return around(i, [&](int k) { return values[k]; });
  }

  // The values of the pieces between joints after a step. Where a piece gets much worse, or bends
  // would hide, it stays, with both of its joints.
  std::vector<Value> values_after(std::vector<Joint>& moved) {
    std::vector<Value> values(pieces());
    std::vector<int> open;
    for (int i = 0; i < pieces(); ++i) {
      pieces_[i].stays = false;
      values[i] = pieces_[i].value;
      if (!rests(i)) open.push_back(i);
    }
    while (!open.empty()) {
      std::vector<int> worse;
      for (const int i : open) {
        Work_meter::pause();
        const Piece& p = pieces_[i];
        values[i] = value(p, moved[i], moved[next(i)], p.next, i);
        if (!p.stays && (values[i].is_resolved < p.value.is_resolved || !(values[i].sum <= 4 * around(i))))
          worse.push_back(i);
      }
      open.clear();
      for (const int i : worse) {
        Piece& p = pieces_[i];
        const int j = next(i);
        p.stays = true;
        p.next = p.x;
        moved[i] = joints_[i];
        moved[j] = joints_[j];
        open.push_back(i);
        if (has_before(i)) open.push_back(before_(i));
        if (has_after(j)) open.push_back(j);
      }
    }
    return values;
  }

  int number() const { return static_cast<int>(joints_.size()); }
  int pieces() const { return static_cast<int>(pieces_.size()); }
  int next(int i) const { return i + 1 == number() ? 0 : i + 1; }
  int before_(int i) const { return i == 0 ? number() - 1 : i - 1; }
  bool has_before(int i) const { return closed_ || i > 0; }
  bool has_after(int i) const { return closed_ || i + 1 < number(); }

  static Family family(const Piece& p, const Joint& a, const Joint& b) {
    const double h = p.length, square = h * h;
    return {b.point - a.point, {{h * a.tangent, square * a.curvature}, 1}, {{h * b.tangent, square * b.curvature}, -1}};
  }

  // In the plane, this calls f(r, gradient of r by the control points) for what keeps three control
  // points turned to one side: those in the middle of a piece without an inflection, and otherwise
  // the tangents and the chord. It is infinite where they are not. Returns false there.
  template <class Function>
  bool for_corners(const Piece& p, const typename Family::Points& points, int i, Function f) const {
    if constexpr (M == 2) {
      struct Corner {
        std::array<int, 3> at;
        int sign;
        double size;
      };
      const int bend = turns_->bend(i), start = turns_->sign(i), end = turns_->sign(next(i));
      if (turns_->is_free(i)) return true;
      const std::array<Corner, 2> corners =
          bend != 0 ? std::array<Corner, 2>{{{{1, 2, 3}, bend, 0.04}, {{2, 3, 4}, bend, 0.04}}}
                    : std::array<Corner, 2>{{{{0, 1, 5}, start, 0.2}, {{0, 4, 5}, end, 0.2}}};
      for (const auto& [at, sign, size] : corners) {
        const auto point = [&](int l) -> Vector { return l == 0 ? Vector(2) : points[l - 1]; };
        const Vector u = point(at[1]) - point(at[0]), v = point(at[2]) - point(at[1]);
        const double scale = sign * 25 / (p.length * p.length), enough = size * turns_->angle(i),
                     c = scale * cross_in_plane(u, v);
        if (!(c > 1e-3 * enough)) return false;
        const double missing = enough / c - 1;
        if (!(missing > 0)) continue;
        const auto turned = [](const Vector& w) { // the gradient of cross(w, x) by x
          Vector r(2);
          r[0] = -w[1];
          r[1] = w[0];
          return r;
        };
        const double slope = -enough / (c * c) * scale;
        const Vector by_v = slope * turned(u), by_u = -slope * turned(v);
        std::array<Vector, 6> g; // by b_0 to b_5
        g.fill(Vector(2));
        g[at[0]] -= by_u;
        g[at[1]] += by_u - by_v;
        g[at[2]] += by_v;
        f(missing, g);
      }
    } else
      (void)p, (void)points, (void)i, (void)f;
    return true;
  }

  // Returns in the plane the sign of the curvature at a joint, where it is known: then it is
  // multiplied.
  int sign(int i) const {
    if constexpr (M == 2)
      return turns_->curvature_sign(i);
    else
      return i * 0;
  }
  bool on_line(int i) const {
    if constexpr (M == 2)
      return turns_->on_line(i);
    else
      return i < 0;
  }

  // A shape with which the control polygon turns as the inflections of the piece ask for, for these
  // joints: with short handles. Otherwise the piece may turn as it likes.
  void begin_without_waves(int i) {
    if constexpr (M == 2) {
      if (turns_->is_free(i)) return;
      Piece& p = pieces_[i];
      const Joint &a = joints_[i], &b = joints_[next(i)];
      const auto is_good = [&] { return std::isfinite(value(p, a, b, p.x, i).sum); };
      if (is_good()) return;
      for (double part = longest_part; part > shortest_part; part *= 0.8) {
        const Fair_handles handles = short_handles(a, b, turns_->bend(i), part);
        for (const int k : {0, 1}) {
          // first = h e^x / 5, second = first (2 + y / 4), with another sign at the end
          p.x[2 * k] = std::log(5 * handles.first[k] / p.length);
          p.x[2 * k + 1] = (k == 0 ? 4 : -4) * (handles.second[k] / handles.first[k] - 2);
        }
        if (is_good()) return;
      }
      p.x = p.neutral;
      turns_->release(i);
    } else
      (void)i;
  }

  double weight_of_corners(const Piece& p) const { return corner_weight / (p.length * p.length * p.length); }
  static double weight_of_shape(const Piece& p, int k) {
    return (k % 2 == 0 ? 1e-2 : 1e-3) / (p.length * p.length * p.length);
  }
  // Where the shape begins: with the speed of an arc of a circle.
  static double speed_of_arc(int k, const Joint& a, const Joint& b) {
    const double half = std::sqrt((std::max)(0., (1 - dot(a.tangent, b.tangent)) / 2));
    return k % 2 == 0 && half > 1e-6 ? std::log(std::asin((std::min)(half, 1.)) / half) : 0;
  }

  Value value(const Piece& p, const Joint& a, const Joint& b, const Shape& x, int i) const {
    const Family f = family(p, a, b);
    Fairness_quadrature<Blend_kind::g2, M, nodes> quadrature(f);
    const double infinite = std::numeric_limits<double>::infinity();
    if (!std::isfinite(quadrature.value(x))) return {infinite, false};
    double sum = quadrature.integral();
    for (int k = 0; k < shape_free; ++k) {
      const double y = x[k] - p.neutral[k];
      sum += weight_of_shape(p, k) * y * y;
    }
    const bool is_convex = for_corners(
        p, f.points(x), i, [&](double missing, const auto&) { sum += weight_of_corners(p) * missing * missing; });
    return {is_convex ? sum : infinite, quadrature.is_resolved()};
  }

  static std::array<Vector, normals> frame(const Vector& t) {
    std::array<Vector, normals> e;
    if constexpr (M == 2) {
      e[0] = Vector(2);
      e[0][0] = -t[1];
      e[0][1] = t[0];
    } else {
      int least = 0; // coordinate
      for (int i = 1; i < 3; ++i)
        if (std::abs(t[i]) < std::abs(t[least])) least = i;
      Vector x(3);
      x[least] = 1;
      x -= dot(x, t) * t;
      e[0] = x / std::sqrt(dot(x, x));
      e[1] = cross_product(t, e[0]);
    }
    return e;
  }

  Joint changed(const Joint& joint, const Numbers& x, int i) const {
    const std::array<Vector, normals> e = frame(joint.tangent);
    double longest = 0;
    for (const double y : x) longest = (std::max)(longest, std::abs(y));
    const double part = longest > 1 ? 1 / longest : 1;
    Joint r = joint;
    for (int k = 0; k < normals; ++k)
      if (!joint.given) r.tangent += (part * x[k]) * e[k];
    r.tangent /= std::sqrt(dot(r.tangent, r.tangent));
    if (sign(i) != 0)
      r.curvature = (std::exp(part * x[normals]) * dot(joint.curvature, e[0])) * frame(r.tangent)[0];
    else {
      for (int k = 0; k < normals; ++k) r.curvature += (part * x[normals + k] / size_[i]) * e[k];
      r.curvature -= dot(r.curvature, r.tangent) * r.tangent;
    }
    return r;
  }

  // Returns whether the joint is in the plane, between turns to different sides.
  bool has_no_curvature(int i) const {
    if constexpr (M == 2)
      return turns_->has_no_curvature(i);
    else
      return i < 0;
  }

  // Returns whether the piece is in the plane and may have no inflection.
  bool bends(int piece) const {
    if constexpr (M == 2)
      return turns_->bend(piece) != 0;
    else
      return piece < 0;
  }

  // The numbers of a joint that do not change.
  bool is_fixed(int i, int k) const {
    return rests_[i] || on_line(i) || (k < normals ? joints_[i].given : has_no_curvature(i));
  }

  // Adds the expansion of a piece, without the numbers of its shape, to the equations of its
  // joints.
  void expand(int i, std::array<Block*, 3> blocks, std::array<Numbers*, 2> sides) {
    Piece& p = pieces_[i];
    const Family f = family(p, joints_[i], joints_[next(i)]);
    Fairness_quadrature<Blend_kind::g2, M, nodes> quadrature(f);
    quadrature.value(p.x);
    const double h = p.length;
    std::array<typename Family::End::Points, all> motions; // of the two control points at an end
    for (const int end : {0, 1}) {
      const Joint& joint = joints_[end == 0 ? i : next(i)];
      const auto& side = end == 0 ? f.start : f.end;
      const std::array<double, 2> x = {p.x[2 * end], p.x[2 * end + 1]};
      const std::array<Vector, normals> e = frame(joint.tangent);
      const double speed = std::exp(x[0]);
      const double unit = size_[end == 0 ? i : next(i)];
      for (int k = 0; k < normals; ++k) {
        const Vector u = (speed * h) * e[k],
                     turned = (-speed * speed * h * h * dot(joint.curvature, e[k])) * joint.tangent,
                     bent = speed * speed * h * h * (sign(end == 0 ? i : next(i)) != 0 ? joint.curvature : e[k] / unit);
        motions[end * free + k] = side.points({u, turned + x[1] * u});
        motions[end * free + normals + k] = side.points({Vector(M), bent});
      }
      const auto shape = side.tangents(x);
      for (int k = 0; k < 2; ++k) motions[2 * free + 2 * end + k] = shape[k];
    }
    std::array<std::array<double, all>, all> a{};
    std::array<double, all> g{};
    const auto at_start = [](int k) { return k < free || (k >= 2 * free && k < 2 * free + 2); };
    quadrature.template products<all>(motions, at_start, a, g);
    for (int k = 0; k < shape_free; ++k) {
      a[2 * free + k][2 * free + k] += weight_of_shape(p, k);
      g[2 * free + k] += weight_of_shape(p, k) * (p.x[k] - p.neutral[k]);
    }
    for_corners(p, f.points(p.x), i, [&](double missing, const std::array<Vector, 6>& gradient) {
      std::array<double, all> r;
      for (int k = 0; k < all; ++k)
        r[k] = at_start(k) ? -dot(gradient[1], motions[k][0]) - dot(gradient[2], motions[k][1])
                           : -dot(gradient[4], motions[k][0]) - dot(gradient[3], motions[k][1]);
      for (int k = 0; k < all; ++k) {
        g[k] += weight_of_corners(p) * missing * r[k];
        for (int l = 0; l < all; ++l) a[k][l] += weight_of_corners(p) * r[k] * r[l];
      }
    });
    for (int k = 0; k < all; ++k) a[k][k] += p.damping * a[k][k] + 1e-9 * weight_of_shape(p, 1);
    for (const int end : {0, 1})
      for (int k = 0; k < free; ++k)
        if (is_fixed(end == 0 ? i : next(i), k)) {
          const int l = end * free + k;
          for (int m = 0; m < all; ++m) a[l][m] = a[m][l] = 0;
          a[l][l] = 1;
          g[l] = 0;
        }
    // eliminates the numbers of the shape
    for (int m = 0; m < shape_free; ++m) {
      const int k = 2 * free + m;
      for (int r = 0; r < all; ++r) {
        if (r >= 2 * free && r <= k) continue;
        const double factor = a[r][k] / a[k][k];
        for (int c = 0; c < all; ++c) a[r][c] -= factor * a[k][c];
        g[r] -= factor * g[k];
      }
    }
    for (int m = 0; m < shape_free; ++m) {
      p.row[m] = a[2 * free + m];
      p.right[m] = g[2 * free + m];
    }
    for (int k = 0; k < 2 * free; ++k) {
      (*sides[k / free])[k % free] -= g[k];
      for (int l = 0; l < free; ++l) {
        if (k < free) {
          (*blocks[0])[k][l] += a[k][l];
          (*blocks[1])[k][l] += a[k][free + l];
        } else
          (*blocks[2])[k - free][l] += a[k][free + l];
      }
    }
  }

  // The change of the numbers of the shape for these of its joints, from the equations that were
  // kept.
  static Shape change_of_shape(const Piece& p, const Numbers& start, const Numbers& end) {
    Shape change;
    for (int m = shape_free; m-- > 0;) {
      double rest = -p.right[m];
      for (int k = 0; k < free; ++k) rest -= p.row[m][k] * start[k] + p.row[m][free + k] * end[k];
      for (int k = m + 1; k < shape_free; ++k) rest -= p.row[m][2 * free + k] * change[k];
      change[m] = rest / p.row[m][2 * free + m];
    }
    return change;
  }

  static Numbers times(const Block& a, const Numbers& x) {
    Numbers y{};
    for (int k = 0; k < free; ++k)
      for (int l = 0; l < free; ++l) y[k] += a[k][l] * x[l];
    return y;
  }
  static Numbers times_transposed(const Block& a, const Numbers& x) {
    Numbers y{};
    for (int k = 0; k < free; ++k)
      for (int l = 0; l < free; ++l) y[k] += a[l][k] * x[l];
    return y;
  }

  // The joints after a step, and the shapes of the pieces. The matrix has blocks on its diagonal
  // and beside it; the joint 0, which closes the curve, comes last.
  std::vector<Joint> proposed() {
    const int n = number();
    std::vector<Block> diagonal(n, Block{}), beside(n, Block{}); // the latter from each joint to the next one
    std::vector<Numbers> right(n, Numbers{});
    for (int i = 0; i < pieces(); ++i) {
      Work_meter::pause();
      const int j = next(i);
      if (!rests(i)) expand(i, {&diagonal[i], &beside[i], &diagonal[j]}, {&right[i], &right[j]});
    }
    for (int i = 0; i < n; ++i)
      if (rests_[i])
        for (int k = 0; k < free; ++k) diagonal[i][k][k] += 1;
    // columns: the right side, and the joint 0
    std::vector<std::array<Numbers, free + 1>> column(n);
    for (int i = 1; i < n; ++i) {
      column[i] = {};
      column[i][free] = right[i];
      for (int c = 0; c < free; ++c)
        for (int k = 0; k < free; ++k) {
          if (i == 1) column[i][c][k] += beside[0][c][k];
          if (i == n - 1 && closed_) column[i][c][k] += beside[i][k][c];
        }
    }
    for (int i = 1; i < n; ++i) {
      if (i > 1) // eliminates the joint before
        for (int k = 0; k < free; ++k) {
          Numbers row;
          for (int l = 0; l < free; ++l) row[l] = beside[i - 1][l][k];
          row = solve_positive_definite(diagonal[i - 1], row);
          for (int l = 0; l < free; ++l)
            for (int m = 0; m < free; ++m) diagonal[i][k][l] -= row[m] * beside[i - 1][m][l];
          for (int c = 0; c <= free; ++c)
            for (int m = 0; m < free; ++m) column[i][c][k] -= row[m] * column[i - 1][c][m];
        }
    }
    for (int i = n - 1; i > 0; --i)
      for (int c = 0; c <= free; ++c) {
        Numbers& x = column[i][c];
        if (i < n - 1) {
          const Numbers y = times(beside[i], column[i + 1][c]);
          for (int k = 0; k < free; ++k) x[k] -= y[k];
        }
        x = solve_positive_definite(diagonal[i], x);
      }
    const auto touching = [&](int c) { // what the others do to the joint 0
      Numbers y = times(beside[0], column[1][c]);
      if (closed_) {
        const Numbers z = times_transposed(beside[n - 1], column[n - 1][c]);
        for (int k = 0; k < free; ++k) y[k] += z[k];
      }
      return y;
    };
    Numbers first = right[0];
    const Numbers of_right = touching(free);
    for (int k = 0; k < free; ++k) first[k] -= of_right[k];
    for (int c = 0; c < free; ++c) {
      const Numbers y = touching(c);
      for (int k = 0; k < free; ++k) diagonal[0][k][c] -= y[k];
    }
    std::vector<Numbers> x(n);
    x[0] = solve_positive_definite(diagonal[0], first);
    for (int i = 1; i < n; ++i)
      for (int k = 0; k < free; ++k) {
        x[i][k] = column[i][free][k];
        for (int c = 0; c < free; ++c) x[i][k] -= column[i][c][k] * x[0][c];
      }
    std::vector<Joint> moved = joints_;
    for (int i = 0; i < n; ++i)
      if (!rests_[i]) moved[i] = changed(joints_[i], x[i], i);
    for (int i = 0; i < pieces(); ++i) {
      Piece& p = pieces_[i];
      p.next = p.x;
      if (rests(i)) continue;
      const int j = next(i);
      const Shape changes = change_of_shape(p, x[i], x[j]);
      for (int k = 0; k < shape_free; ++k) {
        const double most = k % 2 == 0 ? 0.5 : 4, bound = k % 2 == 0 ? 1.5 : 30,
                     change = (std::min)((std::max)(changes[k], -most), most);
        p.next[k] = (std::min)((std::max)(p.x[k] + change, (std::min)(p.x[k], -bound)), (std::max)(p.x[k], bound));
        // where there is no inflection the control polygon does not turn back at its second point
        if (k % 2 == 1 && bends(i)) {
          const Vector& bend = moved[k == 1 ? i : j].curvature;
          const double turn = p.length * std::exp(p.next[k - 1]) * std::sqrt(dot(bend, bend)), least = -3.5 - turn;
          p.next[k] = k == 1 ? (std::max)(p.next[k], least) : (std::min)(p.next[k], -least);
        }
      }
    }
    return moved;
  }

  Fair_handles handles_of(int i) const {
    const Piece& p = pieces_[i];
    const double a = p.length * std::exp(p.x[0]), b = p.length * std::exp(p.x[2]);
    return {{a / 5, b / 5}, {a * (0.4 + p.x[1] / 20), b * (0.4 - p.x[3] / 20)}};
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_JOINTS_H
