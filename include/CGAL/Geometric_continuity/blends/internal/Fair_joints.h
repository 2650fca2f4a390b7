// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_JOINTS_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_JOINTS_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/internal/solve_positive_definite.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_family.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_minimum.h>
#include <CGAL/Geometric_continuity/blends/internal/Fairness_quadrature.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// Tangents and curvatures at points through which a fair spline leads, in floating-point numbers.
// They start with those of circles through three points; then one point after the other gets those
// with the least
//
//   sum over both neighbouring pieces of  int |(dK/ds)_perp|^2 ds,
//
// where a piece is the quintic blend of least energy whose tangents are as long as an arc of a
// circle with their angle, by Newton's method with differences.

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

// The tangent, unless it is given, and the curvature of the circle through a point and its
// neighbours, with the chords u to the point and v from it. `place` is 0 where the circle is wanted
// at the middle one of the points, -1 at the first, 1 at the last.
template <int N>
void take_circle(Fair_joint<N>& joint, const Coordinate_vector<double, N>& u, const Coordinate_vector<double, N>& v,
                 int place) {
  typedef Coordinate_vector<double, N> Vector;
  const double a = length(u), b = length(v), c = length<N>(u + v);
  const Vector p = u / a, q = v / b;
  Vector t = b * p + a * q; // of the circle in the middle
  if (!(length(t) > 1e-6 * (a + b))) t = p;
  t /= length(t);
  if (place != 0) { // mirrored at the chord
    const Vector chord = place < 0 ? p : q;
    t = (2 * dot(t, chord)) * chord - t;
  }
  if (!joint.given) joint.tangent = t;
  const Vector bend = q - p, normal = bend - dot(bend, joint.tangent) * joint.tangent;
  const double cosine = dot(p, q), sine = std::sqrt((std::max)(0., 1 - cosine * cosine)), size = length(normal);
  joint.curvature = size > 0 && c > 1e-6 * (a + b) ? (2 * sine / (c * size)) * normal : 0. * normal;
}

template <int N> void take_circles(std::vector<Fair_joint<N>>& joints, bool closed) {
  typedef Coordinate_vector<double, N> Vector;
  const int n = static_cast<int>(joints.size());
  const auto chord = [&](int i) -> Vector { return joints[(i + 1) % n].point - joints[i % n].point; };
  for (int i = 0; i < n; ++i) {
    if (n == 2) { // a line, or as its tangents lead
      const Vector v = joints[1].point - joints[0].point, direction = v / length(v);
      if (!joints[i].given) joints[i].tangent = direction;
      joints[i].curvature = Vector(v.dimension());
    } else if (closed || (i > 0 && i + 1 < n))
      take_circle<N>(joints[i], chord(i + n - 1), chord(i), 0);
    else
      take_circle<N>(joints[i], chord(i == 0 ? 0 : n - 3), chord(i == 0 ? 1 : n - 2), i == 0 ? -1 : 1);
  }
}

template <int M> class Fair_joints {
  typedef Coordinate_vector<double, M> Vector;
  typedef Fair_joint<M> Joint;
  static constexpr int most_sweeps = 20;

  std::vector<Joint>& joints_;
  const bool closed_;

public:
  Fair_joints(std::vector<Joint>& joints, bool closed) : joints_(joints), closed_(closed) {}

  // Goes over all points, until that helps no more.
  void minimise() {
    const int n = static_cast<int>(joints_.size());
    double last = total();
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      for (int i = 0; i < n; ++i) {
        Work_meter::pause();
        improve(i);
      }
      const double now = total();
      if (!(now < 0.999 * last)) break;
      last = now;
    }
  }

private:
  int pieces() const { return static_cast<int>(joints_.size()) - (closed_ ? 0 : 1); }
  double total() const {
    double sum = 0;
    for (int i = 0; i < pieces(); ++i) {
      Work_meter::pause();
      sum += piece(joints_[i], joints_[(i + 1) % joints_.size()]);
    }
    return sum;
  }

  static double piece(const Joint& a, const Joint& b) {
    typedef Fair_family<Blend_kind::g2, M> Family;
    const Vector chord = b.point - a.point;
    // of half the angle of an arc
    const double sine = std::sqrt((std::max)(0., (1 - dot(a.tangent, b.tangent)) / 2)),
                 size = std::sqrt(dot(chord, chord)) * (sine > 1e-6 ? std::asin((std::min)(sine, 1.)) / sine : 1),
                 square = size * size;
    const Family family{
        chord, {{size * a.tangent, square * a.curvature}, 1}, {{size * b.tangent, square * b.curvature}, -1}};
    Fairness_quadrature<Blend_kind::g2, M, 24> quadrature(family);
    const double e = quadrature.value(least_energy(family));
    return std::isfinite(e) ? quadrature.integral() : e;
  }

  // Returns the variation of the pieces at a point.
  double value(int i, const Joint& joint) const {
    const int n = static_cast<int>(joints_.size());
    double sum = 0;
    if (closed_ || i > 0) sum += piece(joints_[(i + n - 1) % n], joint);
    if (closed_ || i + 1 < n) sum += piece(joint, joints_[(i + 1) % n]);
    return sum;
  }

  // The free numbers: the angle by which the tangent turns, and the change of the curvature in
  // units of 1/h, for each normal.
  static constexpr int normals = M - 1, unknowns = 2 * normals;
  typedef std::array<double, unknowns> Numbers;

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

  static Joint changed(const Joint& joint, const std::array<Vector, normals>& e, double h, const Numbers& x) {
    Joint r = joint;
    for (int k = 0; k < normals; ++k) {
      if (!joint.given) r.tangent += x[k] * e[k];
      r.curvature += (x[normals + k] / h) * e[k];
    }
    r.tangent /= std::sqrt(dot(r.tangent, r.tangent));
    r.curvature -= dot(r.curvature, r.tangent) * r.tangent;
    return r;
  }

  void improve(int i) {
    const int n = static_cast<int>(joints_.size());
    const Joint start = joints_[i];
    double h = 0; // the shorter chord
    for (const int j : {i + n - 1, i + 1}) {
      // equivalent [== -> !=, 2]: the unit of curvatures in a search
      if (!closed_ && (j == n || (i == 0 && j == n - 1))) continue;
      const Vector chord = joints_[j % n].point - start.point;
      const double length = std::sqrt(dot(chord, chord));
      h = h == 0 ? length : (std::min)(h, length);
    }
    const std::array<Vector, normals> e = frame(start.tangent);
    const auto at = [&](const Numbers& x) { return value(i, changed(start, e, h, x)); };
    constexpr double step = 1e-3;
    const double f = at({});
    if (!std::isfinite(f)) return;
    std::array<Numbers, unknowns> matrix;
    Numbers gradient, ahead;
    for (int k = 0; k < unknowns; ++k) {
      Numbers x{}, y{};
      x[k] = step;
      y[k] = -step;
      ahead[k] = at(x);
      const double behind = at(y);
      gradient[k] = (ahead[k] - behind) / (2 * step);
      matrix[k][k] = (ahead[k] - 2 * f + behind) / (step * step);
      for (int l = 0; l < k; ++l) {
        Numbers z = x;
        z[l] = step;
        matrix[k][l] = matrix[l][k] = (at(z) - ahead[k] - ahead[l] + f) / (step * step);
      }
    }
    double largest = 0;
    for (int k = 0; k < unknowns; ++k) largest = (std::max)(largest, std::abs(matrix[k][k]));
    if (!(largest > 0)) return;
    for (double damping = 1e-6; damping < 100; damping *= 100) {
      std::array<Numbers, unknowns> a = matrix;
      Numbers b;
      for (int k = 0; k < unknowns; ++k) {
        a[k][k] += damping * largest;
        b[k] = -gradient[k];
      }
      if (start.given) // the tangent stays
        for (int k = 0; k < normals; ++k) {
          a[k] = {};
          for (int l = 0; l < unknowns; ++l) a[l][k] = 0;
          a[k][k] = largest;
          b[k] = 0;
        }
      const Numbers x = solve_positive_definite(a, b);
      double size = 0;
      for (const double y : x) size = (std::max)(size, std::abs(y));
      if (size < 1) {
        const Joint next = changed(start, e, h, x);
        if (value(i, next) < f) {
          joints_[i] = next;
          return;
        }
      }
    }
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_JOINTS_H
