// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_ELEMENTARY_SURFACES_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_ELEMENTARY_SURFACES_H

#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_bspline_surface.h>

#include <array>
#include <utility>
#include <vector>

/// \file elementary_surfaces.h
/// Cylinders, cones, ellipsoids and tori as rational B-spline surfaces, exactly. They are placed by a centre `c` and vectors
/// `x`, `y`, `z`: the surface that is meant when these are orthonormal, under the affine map to them. With orthogonal vectors of one
/// length they are circular cylinders and cones, spheres and tori of revolution.
///
/// All of them are \f$ S(u, v) = c + \rho(u) (\cos\phi(v)\, x + \sin\phi(v)\, y) + h(u)\, z \f$ with a full turn in four
/// quarters for `v` in [0, 4], and \f$ \phi = 0, \pi/2, \pi, 3\pi/2 \f$ at the knots. They are \f$ G^\infty \f$ across them. For parts
/// take `bezier_patches()`; for arcs by other angles and other profiles see `Revolution_surface_3`.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The homogeneous points (w cos, w sin, w) of the unit circle in quarters, of degree 2.
constexpr std::array<std::array<int, 3>, 9> circle_points = {
    {{1, 0, 1}, {1, 1, 1}, {0, 2, 2}, {-1, 1, 1}, {-1, 0, 1}, {-1, -1, 1}, {0, -2, 2}, {1, -1, 1}, {1, 0, 1}}};

template <class FT> Knot_vector<FT> knots_of_quarters(int quarters) {
  std::vector<typename Knot_vector<FT>::Knot> inner;
  for (int i = 1; i < quarters; ++i) inner.push_back({FT(i), 2});
  return Knot_vector<FT>(2, FT(0), FT(quarters), inner);
}

// From a profile in homogeneous coordinates (w rho, w h, w). `name` is that of the surface, for messages.
template <class Traits>
Rational_bspline_surface<Traits> turned_profile(const std::vector<std::array<typename Traits::FT, 3>>& profile,
                                                Knot_vector<typename Traits::FT> knots, const typename Traits::Point& c,
                                                const typename Traits::Vector& x, const typename Traits::Vector& y,
                                                const typename Traits::Vector& z, const char* name) {
  typedef typename Traits::FT FT;
  typedef typename Rational_bspline_surface<Traits>::Homogeneous Homogeneous;
  const Coordinates<Traits> centre = Geometric_continuity::coordinates<Traits>(c),
                            a = Geometric_continuity::coordinates<Traits>(x),
                            b = Geometric_continuity::coordinates<Traits>(y),
                            h = Geometric_continuity::coordinates<Traits>(z);
  const int n = centre.dimension();
  for (const Coordinates<Traits>* v : {&a, &b, &h}) {
    if (v->dimension() != n) throw Error(Error_code::dimension_mismatch, name);
    if (is_zero(*v)) throw Error(Error_code::zero_direction, name);
  }
  std::vector<std::vector<typename Homogeneous::Point>> net;
  for (const std::array<FT, 3>& p : profile) {
    net.emplace_back();
    for (const std::array<int, 3>& q : circle_points) {
      const FT u = FT(p[0] * FT(q[0])), v = FT(p[0] * FT(q[1])), w = FT(p[1] * FT(q[2])), weight = FT(p[2] * FT(q[2]));
      typename Homogeneous::Point r(n + 1);
      for (int i = 0; i < n; ++i) r[i] = FT(weight * centre[i] + u * a[i] + v * b[i] + w * h[i]);
      r[n] = weight;
      net.back().push_back(r);
    }
  }
  return Rational_bspline_surface<Traits>(Homogeneous(net, std::move(knots), knots_of_quarters<FT>(4)));
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the parallelogram \f$ S(u, v) = c + u\,x + v\,y \f$ on the unit square: a piece of a plane.
/// \throws Error `dimension_mismatch`, `not_finite`
template <class Traits>
Bezier_patch<Traits> parallelogram(const typename Traits::Point& c, const typename Traits::Vector& x,
                                   const typename Traits::Vector& y) {
  typedef Coordinates<Traits> Vector;
  const Vector p = Geometric_continuity::coordinates<Traits>(c), a = Geometric_continuity::coordinates<Traits>(x),
               b = Geometric_continuity::coordinates<Traits>(y);
  if (a.dimension() != p.dimension() || b.dimension() != p.dimension())
    throw Error(Error_code::dimension_mismatch, "parallelogram");
  const auto point = [](const Vector& v) { return to_point<Traits>(v); };
  return Bezier_patch<Traits>({{point(p), point(p + b)}, {point(p + a), point(p + a + b)}});
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the frustum of a cone between the ellipses about `c` with the half-axes `x` and `y` and about \f$ c + z \f$ with the half-axes
/// \f$ k x \f$ and \f$ k y \f$: \f$ \rho = 1 + u (k - 1) \f$, \f$ h = u \f$ for `u` in [0, 1]. It is a cylinder for `k = 1`
/// and the cone with the apex \f$ c + z \f$ for `k = 0`, where its edge `u = 1` is collapsed.
/// \throws Error `zero_direction` when a vector is zero, `dimension_mismatch`, `not_finite`
template <class Traits>
Rational_bspline_surface<Traits> cone(const typename Traits::Point& c, const typename Traits::Vector& x,
                                      const typename Traits::Vector& y, const typename Traits::Vector& z,
                                      const typename Traits::FT& k) {
  typedef typename Traits::FT FT;
  internal::check_finite(k, "cone");
  return internal::turned_profile<Traits>({{FT(1), FT(0), FT(1)}, {k, FT(1), FT(1)}}, Knot_vector<FT>(1, FT(0), FT(1)),
                                          c, x, y, z, "cone");
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the cylinder on the ellipse about `c` with the half-axes `x` and `y`, up to the same ellipse about \f$ c + z \f$; see
/// `cone()`. \throws Error `zero_direction` when a vector is zero, `dimension_mismatch`, `not_finite`
template <class Traits>
Rational_bspline_surface<Traits> cylinder(const typename Traits::Point& c, const typename Traits::Vector& x,
                                          const typename Traits::Vector& y, const typename Traits::Vector& z) {
  return cone<Traits>(c, x, y, z, typename Traits::FT(1));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the ellipsoid with the centre `c` and the conjugate half-axes `x`, `y`, `z`; a sphere when they are orthogonal and of one length.
/// `u` in [0, 2] runs from the pole \f$ c - z \f$ over the equator, `u = 1`, to the pole \f$ c + z \f$. At the poles its edges are
/// collapsed, and its normal vanishes.
/// \throws Error `zero_direction` when a vector is zero, `dimension_mismatch`, `not_finite`
template <class Traits>
Rational_bspline_surface<Traits> ellipsoid(const typename Traits::Point& c, const typename Traits::Vector& x,
                                           const typename Traits::Vector& y, const typename Traits::Vector& z) {
  typedef typename Traits::FT FT;
  return internal::turned_profile<Traits>({{FT(0), FT(-1), FT(1)},
                                           {FT(1), FT(-1), FT(1)},
                                           {FT(2), FT(0), FT(2)},
                                           {FT(1), FT(1), FT(1)},
                                           {FT(0), FT(1), FT(1)}},
                                          internal::knots_of_quarters<FT>(2), c, x, y, z, "ellipsoid");
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the torus whose circle in the plane of `x` and `z` has the radius `r` and the distance 1 from the centre:
/// \f$ \rho = 1 + r \cos\psi \f$, \f$ h = r \sin\psi \f$, with a full turn of \f$ \psi \f$ for `u` in [0, 4]. For `r > 1` it meets
/// itself.
/// \throws Error `empty_domain` unless `r > 0`, `zero_direction` when a vector is zero, `dimension_mismatch`, `not_finite`
template <class Traits>
Rational_bspline_surface<Traits> torus(const typename Traits::Point& c, const typename Traits::Vector& x,
                                       const typename Traits::Vector& y, const typename Traits::Vector& z,
                                       const typename Traits::FT& r) {
  typedef typename Traits::FT FT;
  internal::check_finite(r, "torus");
  if (!(FT(0) < r)) throw Error(Error_code::empty_domain, "torus: the radius must be positive");
  std::vector<std::array<FT, 3>> profile;
  for (const std::array<int, 3>& q : internal::circle_points)
    profile.push_back({FT(FT(q[2]) + r * FT(q[0])), FT(r * FT(q[1])), FT(q[2])});
  return internal::turned_profile<Traits>(profile, internal::knots_of_quarters<FT>(4), c, x, y, z, "torus");
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_ELEMENTARY_SURFACES_H
