// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_FAMILY_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_FAMILY_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>

#include <array>
#include <cmath>
#include <cstddef>

// All blends of two jets with joins of one kind, as a function of numbers that are free: in
// floating-point numbers, in dimension M.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

enum class Blend_kind { g2, g3, f3 };

// The derivatives of a blend at one end. With u = e^a d1, w = e^2a d2, z = e^3a d3 they are
//
//   g1 = u,   g2 = w + tau u,   g3 = z + nu w + sigma u,   nu = 3 tau for G3, free for F3,
//
// and the free numbers are x = (a, tau, sigma, nu), of each kind as many as it has.
template <Blend_kind kind, int M> struct Fair_end {
  typedef Coordinate_vector<double, M> Vector;
  static constexpr int order = kind == Blend_kind::g2 ? 2 : 3, degree = 2 * order + 1,
                       unknowns = kind == Blend_kind::g2   ? 2
                                  : kind == Blend_kind::g3 ? 3
                                                           : 4;
  typedef std::array<double, unknowns> Unknowns;
  // the control points next to the end, from there inwards
  typedef std::array<Vector, order> Points;

  std::array<Vector, order> d; // the derivatives of the given curve, scaled
  int direction;               // 1 at the start of the blend, -1 at its end

  // The control points that have the derivatives g, relative to the end point: b_j = sum of C(j,i)
  // (n-i)!/n! g_i.
  Points points(const std::array<Vector, order>& g) const {
    const double s = direction;
    if constexpr (order == 2)
      return {(s / 5) * g[0], (s * 2 / 5) * g[0] + (1. / 20) * g[1]};
    else
      return {(s / 7) * g[0], (s * 2 / 7) * g[0] + (1. / 42) * g[1],
              (s * 3 / 7) * g[0] + (1. / 14) * g[1] + (s / 210) * g[2]};
  }

  static double nu(const Unknowns& x) {
    if constexpr (kind == Blend_kind::f3)
      return x[3];
    else
      return 3 * x[1];
  }

  Points points(const Unknowns& x) const {
    const double e = std::exp(x[0]);
    const Vector u = e * d[0], w = (e * e) * d[1];
    if constexpr (order == 2)
      return points({u, w + x[1] * u});
    else
      return points({u, w + x[1] * u, (e * e * e) * d[2] + nu(x) * w + x[2] * u});
  }

  // The derivative of the control points by each of the free numbers.
  std::array<Points, unknowns> tangents(const Unknowns& x) const {
    const double e = std::exp(x[0]);
    const Vector u = e * d[0], w = (e * e) * d[1], zero(M);
    if constexpr (order == 2)
      return {points({u, 2. * w + x[1] * u}), points({zero, u})};
    else {
      const Vector z = (e * e * e) * d[2];
      const Points by_a = points({u, 2. * w + x[1] * u, 3. * z + (2 * nu(x)) * w + x[2] * u}),
                   by_sigma = points({zero, zero, u});
      if constexpr (kind == Blend_kind::g3)
        return {by_a, points({zero, u, 3. * w}), by_sigma};
      else
        return {by_a, points({zero, u, zero}), by_sigma, points({zero, zero, w})};
    }
  }
};

// The family of blends from the origin to `chord`. The free numbers are those of the start, then
// those of the end.
template <Blend_kind kind, int M> struct Fair_family {
  typedef Fair_end<kind, M> End;
  typedef typename End::Vector Vector;
  static constexpr int order = End::order, degree = End::degree, unknowns = 2 * End::unknowns;
  typedef std::array<double, unknowns> Unknowns;
  typedef std::array<Vector, degree> Points; // without the first one, which is the origin

  Vector chord;
  End start, end;

  static typename End::Unknowns start_of(const Unknowns& x) { return part(x, 0); }
  static typename End::Unknowns end_of(const Unknowns& x) { return part(x, End::unknowns); }

  Points points(const Unknowns& x) const {
    const typename End::Points s = start.points(start_of(x)), e = end.points(end_of(x));
    Points p;
    for (int j = 0; j < order; ++j) {
      p[j] = s[j];
      p[degree - 2 - j] = chord + e[j];
    }
    p[degree - 1] = chord;
    return p;
  }

private:
  static typename End::Unknowns part(const Unknowns& x, int first) {
    typename End::Unknowns y;
    for (int i = 0; i < End::unknowns; ++i) y[i] = x[first + i];
    return y;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_FAMILY_H
