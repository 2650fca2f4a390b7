// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_TURNS_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_TURNS_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

// The turns of a polygon in the plane, and the tangents, curvatures and handles with which a spline
// through its vertices has no more inflections than it.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <int N> struct Fair_joint {
  Coordinate_vector<double, N> point, tangent, curvature; // of length 1, and orthogonal to that
  bool given = false;                                     // the tangent
};

// Whatever its size: a square may overflow, or be zero.
template <int N> double length(const Coordinate_vector<double, N>& x) {
  double length = 0;
  for (const double y : x) length = std::hypot(length, y);
  return length;
}

// How far along the tangents the control points of a piece lie, in the order in which they are: b_1
// = A + first T, b_2 = A + second T + 5/4 first^2 K, and likewise from the end inwards.
struct Fair_handles {
  std::array<double, 2> first, second;
};

template <class U, class V> double cross_in_plane(const U& u, const V& v) { return u[0] * v[1] - u[1] * v[0]; }

// The turns of a polygon in the plane.
class Fair_turns {
  typedef Coordinate_vector<double, 2> Vector;
  std::vector<int> sign_; // at each point, 0 at the ends of an open polygon as well
  std::vector<double> angle_;
  std::vector<char> line_, free_; // pieces
  bool closed_;
  std::vector<int> bend_;                   // of each piece: its sign where it may have no inflection, or else 0
  static constexpr double small_turn = 0.3; // as a part of the turns beside it

public:
  // The points have two coordinates.
  template <int N> Fair_turns(const std::vector<Fair_joint<N>>& joints, bool closed) : closed_(closed) {
    const int n = static_cast<int>(joints.size()), pieces = closed ? n : n - 1;
    sign_.assign(n, 0);
    angle_.assign(n, 0);
    line_.assign(pieces, n == 2);
    bend_.assign(pieces, 0);
    free_.assign(pieces, 0);
    std::vector<char> back(n, 0);
    for (int i = closed ? 0 : 1; i < (closed ? n : n - 1); ++i) {
      const Vector u = chord(joints, before(i)), v = chord(joints, i);
      const double c = cross_in_plane(u, v), size = std::sqrt(dot(u, u) * dot(v, v));
      angle_[i] = std::atan2(c, dot(u, v));
      sign_[i] = c > 1e-12 * size ? 1 : c < -1e-12 * size ? -1 : 0;
      back[i] = sign_[i] == 0 && dot(u, v) < 0;
    }
    let_inflections_be_at_points();
    for (int i = 0; i < n; ++i) { // on a line with both neighbours, which do not turn to different sides
      if (sign_[i] != 0 || back[i] || (!closed && (i == 0 || i == n - 1))) continue;
      if (sign_[before(i)] * sign_[after(i)] < 0) continue;
      line_[before(i)] = line_[i] = 1;
    }
    for (int i = 0; i < pieces; ++i) {
      const int j = after(i);
      if (!line_[i] && !back[i] && !back[j] && sign_[i] * sign_[j] >= 0)
        bend_[i] = sign_[i] + sign_[j] > 0 ? 1 : sign_[i] + sign_[j] < 0 ? -1 : 0;
      free_[i] = line_[i] || (bend_[i] == 0 && sign_[i] * sign_[j] >= 0);
    }
  }

  int sign(int i) const { return sign_[i]; }
  int bend(int piece) const { return bend_[piece]; }
  // Frees a piece from all conditions.
  void release(int piece) { free_[piece] = 1; }
  bool is_free(int piece) const { return free_[piece] != 0; }
  // The sum of the turns at both ends of a piece.
  double angle(int piece) const { return std::abs(angle_[piece]) + std::abs(angle_[after(piece)]); }
  // Returns whether a point is between turns to different sides, and its own does not matter.
  bool is_inflection(int i) const { return sign_[i] == 0 && sign_[before(i)] * sign_[after(i)] < 0; }
  int before(int i) const { return i == 0 ? static_cast<int>(sign_.size()) - 1 : i - 1; }
  int after(int i) const { return (i + 1) % static_cast<int>(sign_.size()); }
  bool has_before(int i) const { return closed_ || i > 0; }
  bool has_after(int i) const { return closed_ || i + 1 < static_cast<int>(sign_.size()); }
  bool is_line(int piece) const { return line_[piece] != 0; }
  // The number of inflections that a piece may have.
  int inflections(int piece) const { return sign_[piece] * sign_[after(piece)] < 0 ? 1 : 0; }

  bool on_line(int i) const { return (has_before(i) && is_line(before(i))) || (has_after(i) && is_line(i)); }
  // The sign of the curvature at a point, where it is known.
  int curvature_sign(int i) const {
    if (on_line(i)) return 0;
    return has_before(i) && has_after(i) ? sign(i) : bend(has_before(i) ? before(i) : i);
  }
  // Returns whether a point is between pieces that bend to different sides.
  bool has_no_curvature(int i) const {
    return has_before(i) && has_after(i) && sign(i) == 0 && bend(before(i)) * bend(i) < 0;
  }

  // Puts a tangent inside of the angle of the chords, not nearer to them than a part of it, with a
  // curvature of the sign of the turn; on a line both are those of the line.
  template <int N> void confine(std::vector<Fair_joint<N>>& joints, int i, double part) const {
    Fair_joint<N>& joint = joints[i];
    const auto direction = [&](int piece) { return Vector(chord(joints, piece) / length(chord(joints, piece))); };
    const bool before = has_before(i), after = has_after(i);
    if (on_line(i)) {
      if (!joint.given) set(joint.tangent, direction(before && is_line(this->before(i)) ? this->before(i) : i));
      set(joint.curvature, Vector(2));
      return;
    }
    const bool inflects = has_no_curvature(i);
    if (inflects) set(joint.curvature, Vector(2));
    const int s = inflects ? bend(this->before(i)) : curvature_sign(i);
    if (s == 0) return;
    if (!joint.given) {
      // the angle from the chord before, and that of both chords
      const Vector u = before ? direction(this->before(i)) : direction(i), v = after ? direction(i) : u;
      const double whole = s * std::atan2(cross_in_plane(u, v), dot(u, v));
      double low = before ? part * whole : -1.4, high = after ? (1 - part) * whole : 1.4;
      if (!before) high = -1e-3;
      if (!after) low = 1e-3;
      if (inflects) { // on one side of both chords
        low = (std::max)(0., whole) + part * (std::min)(angle(this->before(i)), angle(i));
        high = 1.4;
      }
      double angle =
          s * std::atan2(cross_in_plane(u, joint.tangent), u[0] * joint.tangent[0] + u[1] * joint.tangent[1]);
      if (!(low <= angle && angle <= high)) {
        angle = s * (std::min)((std::max)(angle, low), high);
        const double size = length(joint.curvature);
        joint.tangent[0] = std::cos(angle) * u[0] - std::sin(angle) * u[1];
        joint.tangent[1] = std::sin(angle) * u[0] + std::cos(angle) * u[1];
        bend_to(joint, s * size);
      }
    }
    if (!inflects) soften(joints, i);
  }

private:
  // Between turns to different sides the inflection may be on either side of a point, so the sign
  // of its turn is not asked for where it is small: within the narrow angle of its chords the
  // tangent would have to be nearly the chord, and the rest of the turn would be a corner.
  void let_inflections_be_at_points() {
    const std::vector<int> sign = sign_;
    for (int i = 0; i < static_cast<int>(sign.size()); ++i)
      if (sign[before(i)] * sign[after(i)] < 0 &&
          std::abs(angle_[i]) < small_turn * (std::min)(std::abs(angle_[before(i)]), std::abs(angle_[after(i)])))
        sign_[i] = 0;
  }

  template <int N> static void set(Coordinate_vector<double, N>& x, const Vector& y) {
    for (int k = 0; k < 2; ++k) x[k] = y[k];
  }
  template <int N> Vector chord(const std::vector<Fair_joint<N>>& joints, int piece) const {
    Vector v(2);
    for (int k = 0; k < 2; ++k) v[k] = joints[after(piece)].point[k] - joints[piece].point[k];
    return v;
  }
  // Gives a joint a signed curvature.
  template <int N> static void bend_to(Fair_joint<N>& joint, double curvature) {
    joint.curvature[0] = curvature * -joint.tangent[1];
    joint.curvature[1] = curvature * joint.tangent[0];
  }
  // Makes the curvature at a joint no larger than those of the arcs with the tangent and the
  // chords, and not much smaller than the larger one.
  template <int N> void soften(std::vector<Fair_joint<N>>& joints, int i) const {
    Fair_joint<N>& joint = joints[i];
    double least = std::numeric_limits<double>::infinity();
    for (const int piece : {has_before(i) ? before(i) : -1, has_after(i) ? i : -1}) {
      if (piece < 0) continue;
      const Vector v = chord(joints, piece);
      const double along = joint.tangent[0] * v[0] + joint.tangent[1] * v[1],
                   angle = std::abs(std::atan2(cross_in_plane(joint.tangent, v), along));
      least = (std::min)(least, 2 * angle / length(v));
    }
    const double size = curvature_sign(i) * cross_in_plane(joint.tangent, joint.curvature);
    bend_to(joint, curvature_sign(i) * (std::min)((std::max)(size, 0.1 * least), least));
  }
};

// Handles of a piece in the plane with which its control polygon hardly turns but at its ends:
// parts of the sides of the triangle of the tangents, where the piece bends to one side by less
// than 180 degrees, or else of the chord.
constexpr double longest_part = 0.24, shortest_part = 0.02;
template <int N> Fair_handles short_handles(const Fair_joint<N>& a, const Fair_joint<N>& b, int bend, double part) {
  const Coordinate_vector<double, N> chord = b.point - a.point;
  const double whole = cross_in_plane(a.tangent, b.tangent), h = length(chord);
  const std::array<double, 2> side = {cross_in_plane(chord, b.tangent) / whole,
                                      cross_in_plane(a.tangent, chord) / whole};
  const bool meet = bend != 0 && side[0] > 0 && side[1] > 0;
  Fair_handles handles;
  for (const int k : {0, 1}) {
    const double s = meet ? (std::min)(side[k], h) : 0.5 * h;
    handles.first[k] = part * s;
    handles.second[k] = (0.35 + part) * s;
  }
  return handles;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_TURNS_H
