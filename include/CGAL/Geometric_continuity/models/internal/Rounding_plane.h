// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROUNDING_PLANE_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROUNDING_PLANE_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <type_traits>
#include <utility>

/// \file Rounding_plane.h
/// A plane o + a x + b y, and the points on it nearest to others.
///
/// In floating point, a plane has points with exactly its equation n x = c only where n and c are
/// short. So n has integers of at most 29 bits, o is a point of a grid, and x and y are a reduced
/// basis of the vectors of this grid with n x = 0, which have about 15 bits. Points on the plane
/// have integers a and b; vectors have multiples of 256, so that they stay on the grid when they
/// are multiplied by a number with eight binary digits after the point.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A grid in space: multiples of `unit`, a power of two, of which coordinates have at most 52 bits.
inline double grid_unit(double largest_coordinate) {
  int exponent;
  std::frexp(largest_coordinate, &exponent);
  return std::ldexp(1, exponent - 52);
}

// A reduced basis of the integer vectors that are orthogonal to an integer vector without a common
// divisor.
class Plane_lattice {
  typedef std::int64_t Integer;
  typedef std::array<Integer, 3> Vector;

  static long double product(const Vector& x, const Vector& y) {
    long double sum = 0;
    for (int k = 0; k < 3; ++k) sum += static_cast<long double>(x[k]) * static_cast<long double>(y[k]);
    return sum;
  }
  // Subtracts the multiple of y that leaves the shortest rest; returns whether there is one.
  static bool reduce(Vector& x, const Vector& y) {
    const long double quotient = product(x, y) / product(y, y);
    if (std::abs(quotient) <= 0.500001L) return false;
    const Integer k = std::llround(quotient);
    for (int i = 0; i < 3; ++i) x[i] -= k * y[i];
    return true;
  }
  // x and y with a x + b y = gcd(a, b) > 0
  static std::array<Integer, 3> bezout(Integer a, Integer b) {
    Integer x = 1, y = 0, next_x = 0, next_y = 1;
    while (b != 0) {
      const Integer q = a / b;
      std::tie(a, b) = std::make_pair(b, a - q * b);
      std::tie(x, next_x) = std::make_pair(next_x, x - q * next_x);
      std::tie(y, next_y) = std::make_pair(next_y, y - q * next_y);
    }
    return a < 0 ? std::array<Integer, 3>{-a, -x, -y} : std::array<Integer, 3>{a, x, y};
  }

public:
  Vector x, y;

  explicit Plane_lattice(const Vector& n) {
    if (n[0] == 0 && n[1] == 0) {
      x = {1, 0, 0};
      y = {0, 1, 0};
    } else {
      const auto [g, s, t] = bezout(n[0], n[1]);
      x = {n[1] / g, -n[0] / g, 0};
      y = {-n[2] * s, -n[2] * t, g};
      while (reduce(y, x) || reduce(x, y)) {
      }
    }
    const Vector across = {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
    if (product(across, n) < 0) std::swap(x, y);
  }

  // The integers nearest to a direction: short ones if they agree with it up to rounding.
  static Vector short_normal(const Coordinate_vector<double, 3>& direction) {
    constexpr int bits = 29, few = 1024;
    double largest = 0;
    for (double c : direction) largest = (std::max)(largest, std::abs(c));
    const auto rounded = [&](double factor) {
      return Vector{std::llround(direction[0] / largest * factor), std::llround(direction[1] / largest * factor),
                    std::llround(direction[2] / largest * factor)};
    };
    for (int factor = 1; factor <= few; ++factor) {
      const Vector n = rounded(factor);
      double error = 0;
      for (int k = 0; k < 3; ++k)
        error = (std::max)(error, std::abs(direction[k] / largest * factor - static_cast<double>(n[k])));
      if (error < 1e-13 * factor) return n;
    }
    // of the neighbours, so that both vectors of the basis are short: of (a, b, 0) one would not be
    const Vector n = rounded(std::ldexp(1, bits));
    Vector best = n;
    long double least = -1;
    for (int i = 0; i < 27; ++i) {
      const Vector m = {n[0] + i % 3 - 1, n[1] + i / 3 % 3 - 1, n[2] + i / 9 - 1};
      if (std::gcd(std::gcd(m[0], m[1]), m[2]) != 1) continue;
      const Plane_lattice lattice(m);
      const long double longest = (std::max)(product(lattice.x, lattice.x), product(lattice.y, lattice.y));
      if (least < 0 || longest < least) {
        least = longest;
        best = m;
      }
    }
    return best;
  }
};

template <class FT> class Rounding_plane {
public:
  typedef Coordinate_vector<FT, 3> Vector;

private:
  static constexpr bool is_rounded = std::is_floating_point_v<FT>;

  FT unit_;                        // of the grid
  Vector normal_, origin_, x_, y_; // the last two in units
  Plane_coordinates<FT, 3> coordinates_;

  static std::pair<Vector, Vector> basis(const Vector& normal, const Vector& direction) {
    if constexpr (is_rounded) {
      const Plane_lattice lattice(Plane_lattice::short_normal(normal));
      std::pair<Vector, Vector> b(Vector(3), Vector(3));
      for (int k = 0; k < 3; ++k) {
        b.first[k] = static_cast<FT>(lattice.x[k]);
        b.second[k] = static_cast<FT>(lattice.y[k]);
      }
      return b;
    } else
      return {direction, cross_product(normal, direction)};
  }
  Rounding_plane(const Vector& origin, const FT& unit, const std::pair<Vector, Vector>& b)
      : unit_(unit), normal_(cross_product(b.first, b.second)), origin_(origin), x_(b.first), y_(b.second),
        coordinates_(x_, y_) {
    if constexpr (is_rounded)
      for (int k = 0; k < 3; ++k) origin_[k] = std::nearbyint(origin[k] / unit) * unit;
  }

  Vector nearest(const Vector& x, double multiple) const {
    auto [a, b] = coordinates_.nearest(FT(1) / unit_ * x);
    if constexpr (is_rounded) {
      a = std::nearbyint(a / multiple) * multiple;
      b = std::nearbyint(b / multiple) * multiple;
    }
    return unit_ * (a * x_ + b * y_);
  }

public:
  // Through a point, with a normal and a direction in it. Exact numbers have the unit 1.
  Rounding_plane(const Vector& origin, const Vector& normal, const Vector& direction, const FT& unit)
      : Rounding_plane(origin, unit, basis(normal, direction)) {}

  const Vector& normal() const { return normal_; }
  const Vector& origin() const { return origin_; }
  Vector x() const { return unit_ * x_; }
  Vector y() const { return unit_ * y_; }

  Vector point(const Vector& p) const {
    if constexpr (is_rounded)
      return origin_ + nearest(p - origin_, 1);
    else
      return p;
  }
  Vector vector(const Vector& v) const {
    if constexpr (is_rounded)
      return nearest(v, 256);
    else
      return v;
  }
  // The length that vectors may be wrong by.
  double error() const {
    if constexpr (is_rounded)
      return 256 * unit_ * std::sqrt(dot(x_, x_) + dot(y_, y_));
    else
      return 0;
  }
  // a and b of a point on the plane.
  std::pair<FT, FT> parameters(const Vector& p) const {
    std::pair<FT, FT> c = coordinates_.nearest(FT(1) / unit_ * (p - origin_));
    if constexpr (is_rounded) { // those of points on the plane are integers
      const FT a = std::nearbyint(c.first), b = std::nearbyint(c.second);
      if (origin_ + unit_ * (a * x_ + b * y_) == p) return {a, b};
    }
    return c;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROUNDING_PLANE_H
