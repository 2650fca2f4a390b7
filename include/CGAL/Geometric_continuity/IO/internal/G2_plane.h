// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_PLANE_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_PLANE_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

/// \file G2_plane.h
/// Elementary surfaces of the format. Those with an angle among their parameters, in radians, have
/// no exact ends; planes have, where their axes are exact.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

constexpr int g2_plane = 250;

// The part of a plane that the format writes as a location c, a normal n, an axis x, and
// parameters: c + u x + v (n x x), after n and x have become unit vectors.
template <class Exact> struct G2_plane {
  typedef Coordinate_vector<Exact, 3> Vector;

  Vector location, normal, axis;
  std::array<Exact, 4> bounds; // of u and of v in this formula
  std::array<Exact, 4> domain; // u and v that are the parameters of the surface at the bounds
  bool swapped = false;        // whether the parameters change places

  // The corners with the indices (0, 0), (1, 0), (0, 1), (1, 1), or nothing when the axes are not
  // orthogonal, or a length is not a rational number.
  std::optional<std::vector<Vector>> corners() const {
    const std::optional<Exact> n = length(normal), x = length(axis);
    if (!n || !x || dot(normal, axis) != Exact(0)) return std::nullopt;
    const Vector first = axis / *x, second = cross_product(normal, first) / *n;
    std::vector<Vector> corners;
    for (int corner = 0; corner < 4; ++corner) {
      const int u = swapped ? corner / 2 : corner % 2, v = swapped ? corner % 2 : corner / 2;
      corners.push_back(location + bounds[u] * first + bounds[2 + v] * second);
    }
    return corners;
  }

  // The ends of the first and of the second parameter of the surface.
  std::array<std::pair<Exact, Exact>, 2> intervals() const {
    const std::pair<Exact, Exact> u(domain[0], domain[1]), v(domain[2], domain[3]);
    return swapped ? std::array<std::pair<Exact, Exact>, 2>{v, u} : std::array<std::pair<Exact, Exact>, 2>{u, v};
  }

private:
  // Positive and rational, or nothing.
  static std::optional<Exact> length(const Vector& x) {
    const Exact square = dot(x, x);
    return square == Exact(0) ? std::nullopt : rational_square_root(square);
  }
};

// Reads the location, the normal, an axis, 1 for a plane with bounds, and these; or 11, the bounds,
// and the domain. number() and integer(what, low, high) read a word, refuse(reason) refuses the
// text.
template <class Exact, class Number, class Integer, class Refuse>
G2_plane<Exact> read_g2_plane(Number number, Integer integer, Refuse refuse) {
  G2_plane<Exact> plane;
  for (auto* row : {&plane.location, &plane.normal, &plane.axis})
    for (int i = 0; i < 3; ++i) (*row)[i] = number();
  if (!plane.corners())
    refuse(
        "a plane whose axes are no unit vectors at right angles in exact numbers: write it as a spline surface of the "
        "orders 2");
  const int flag = integer("flag of the bounds of a plane", 0, 11);
  if (flag == 0) refuse("a plane without bounds; a surface has four edges");
  if (flag != 1 && flag != 11) refuse("the flag of the bounds of a plane is neither 0 nor 1 nor 11");
  for (Exact& x : plane.bounds) x = number();
  plane.domain = plane.bounds;
  if (flag == 11)
    for (Exact& x : plane.domain) x = number();
  for (const auto* x : {&plane.bounds, &plane.domain})
    if (!((*x)[0] < (*x)[1] && (*x)[2] < (*x)[3])) refuse("the bounds of a plane do not increase: empty domain");
  return plane;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_PLANE_H
