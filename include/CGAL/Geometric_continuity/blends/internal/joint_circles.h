// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_JOINT_CIRCLES_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_JOINT_CIRCLES_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_turns.h>

#include <algorithm>
#include <cmath>
#include <vector>

/// \file joint_circles.h
/// Tangents and curvatures at points, those of the circles through three points.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

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

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_JOINT_CIRCLES_H
