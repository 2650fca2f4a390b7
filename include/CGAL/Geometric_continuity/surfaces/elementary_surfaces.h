// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_ELEMENTARY_SURFACES_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_ELEMENTARY_SURFACES_H

#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>
#include <CGAL/Geometric_continuity/surfaces/swept_surfaces.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

/// \file elementary_surfaces.h
/// Cylinders, cones, ellipsoids and tori as rational B-spline surfaces, exactly. They are placed by
/// a centre `c` and vectors `x`, `y`, `z`: the surface that is meant when these are orthonormal,
/// under the affine map to them. With orthogonal vectors of one length they are circular cylinders
/// and cones, spheres and tori of revolution.
///
/// All of them are \f$ S(u, v) = c + \rho(u) (\cos\phi(v)\, x + \sin\phi(v)\, y) + h(u)\, z \f$
/// with a full turn in four quarters for `v` in [0, 4], and \f$ \phi = 0, \pi/2, \pi, 3\pi/2 \f$ at
/// the knots. Where `u` rises in the direction of `z`, and `x`, `y`, `z` are positively oriented,
/// \f$ S_u \times S_v \f$ points to the axis; `tessellate()` turns the triangles of closed surfaces
/// outwards. They are \f$ G^\infty \f$ across them. For parts take `bezier_patches()`. A point of a
/// \cgal kernel says what the traits class is (`Traits_of`); for others it is the first template
/// argument, `ellipsoid<Traits>(…)`.
///
/// Surfaces of extrusion and of revolution with any profile as patches, exactly: profiles are
/// Bézier or B-spline curves, rational or not.

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

// From a profile in homogeneous coordinates (w rho, w h, w). `name` is that of the surface, for
// messages.
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
/// Returns the parallelogram \f$ S(u, v) = c + u\,x + v\,y \f$ on the unit square: a piece of a
/// plane.
/// \throws Error `dimension_mismatch`, `not_finite`
template <class Given = internal::Of_points, class Point = typename Given::Point,
          class Traits = Traits_or_of<Given, Point>>
Bezier_patch<Traits> parallelogram(const Point& c, const typename Traits::Vector& x, const typename Traits::Vector& y) {
  typedef Coordinates<Traits> Vector;
  const Vector p = internal::point_column<Traits>(c), a = internal::vector_column<Traits>(x),
               b = internal::vector_column<Traits>(y);
  if (a.dimension() != p.dimension() || b.dimension() != p.dimension())
    throw Error(Error_code::dimension_mismatch, "parallelogram");
  const auto point = [](const Vector& v) { return to_point<Traits>(v); };
  return Bezier_patch<Traits>({{point(p), point(p + b)}, {point(p + a), point(p + a + b)}});
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the frustum of a cone between the ellipses about `c` with the half-axes `x` and `y` and
/// about \f$ c + z \f$ with the half-axes \f$ k x \f$ and \f$ k y \f$:
/// \f$ \rho = 1 + u (k - 1) \f$, \f$ h = u \f$ for `u` in [0, 1]. It is a cylinder for `k = 1` and
/// the cone with the apex \f$ c + z \f$ for `k = 0`, where its edge `u = 1` is collapsed.
/// \throws Error `zero_direction` when a vector is zero, `dimension_mismatch`, `not_finite`
template <class Given = internal::Of_points, class Point = typename Given::Point,
          class Traits = Traits_or_of<Given, Point>>
Rational_bspline_surface<Traits> cone(const Point& c, const typename Traits::Vector& x,
                                      const typename Traits::Vector& y, const typename Traits::Vector& z,
                                      const typename Traits::FT& k) {
  typedef typename Traits::FT FT;
  internal::check_finite(k, "cone");
  return internal::turned_profile<Traits>({{FT(1), FT(0), FT(1)}, {k, FT(1), FT(1)}}, Knot_vector<FT>(1, FT(0), FT(1)),
                                          c, x, y, z, "cone");
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the cylinder on the ellipse about `c` with the half-axes `x` and `y`, up to the same
/// ellipse about \f$ c + z \f$; see `cone()`. \throws Error `zero_direction` when a vector is zero,
/// `dimension_mismatch`, `not_finite`
template <class Given = internal::Of_points, class Point = typename Given::Point,
          class Traits = Traits_or_of<Given, Point>>
Rational_bspline_surface<Traits> cylinder(const Point& c, const typename Traits::Vector& x,
                                          const typename Traits::Vector& y, const typename Traits::Vector& z) {
  return cone<Traits>(c, x, y, z, typename Traits::FT(1));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the ellipsoid with the centre `c` and the conjugate half-axes `x`, `y`, `z`; a sphere
/// when they are orthogonal and of one length. `u` in [0, 2] runs from the pole \f$ c - z \f$ over
/// the equator, `u = 1`, to the pole \f$ c + z \f$. At the poles its edges are collapsed, and its
/// normal vanishes.
/// \throws Error `zero_direction` when a vector is zero, `dimension_mismatch`, `not_finite`
template <class Given = internal::Of_points, class Point = typename Given::Point,
          class Traits = Traits_or_of<Given, Point>>
Rational_bspline_surface<Traits> ellipsoid(const Point& c, const typename Traits::Vector& x,
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
/// Returns the torus whose circle in the plane of `x` and `z` has the radius `r` and the distance 1
/// from the centre: \f$ \rho = 1 + r \cos\psi \f$, \f$ h = r \sin\psi \f$, with a full turn of
/// \f$ \psi \f$ for `u` in [0, 4]. For `r > 1` it meets itself.
/// \throws Error `empty_domain` unless `r > 0`, `zero_direction` when a vector is zero,
///   `dimension_mismatch`, `not_finite`
template <class Given = internal::Of_points, class Point = typename Given::Point,
          class Traits = Traits_or_of<Given, Point>>
Rational_bspline_surface<Traits> torus(const Point& c, const typename Traits::Vector& x,
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

namespace internal {

template <class Traits> using Homogeneous_point = typename Homogeneous_traits<Traits>::Point;
template <class Traits> using Homogeneous_points = std::vector<std::vector<Homogeneous_point<Traits>>>;

// The rows of p + v w, at both ends of the domain of v.
template <class Homogeneous_curve, class Surface> auto extruded(const Homogeneous_curve& profile, const Surface& s) {
  typedef typename Surface::Traits Traits;
  typedef typename Surface::FT FT;
  const Coordinates<Traits> w = space_coordinates<Traits, FT>(s.direction(), "extrusion: direction");
  if (profile.dimension() != 4) throw Error(Error_code::dimension_mismatch, "extrusion: the profile");
  Homogeneous_points<Traits> net;
  for (const Homogeneous_point<Traits>& p : profile.control_points()) {
    net.emplace_back(2, p);
    for (int i = 0; i < 3; ++i) {
      net.back()[0][i] += FT(p[3] * s.domain_v().first) * w[i];
      net.back()[1][i] += FT(p[3] * s.domain_v().second) * w[i];
    }
  }
  return net;
}

// The Bernstein coefficients on [v0, v1], of degree 2, of the rotation of each point, whose
// homogeneous coordinates are those of `Revolution_surface_3` times 1 + v^2 W: the coefficients 1,
// v, v^2 have the blossom 1, (s + t)/2, s t. With q = p - w a it is (1 + s t W) (q + w a) + (s + t)
// w x q + 2 s t w x (w x q), and the weight is (1 + s t W) w.
template <class Homogeneous_curve, class Surface>
auto revolved(const Homogeneous_curve& profile, const Surface& s,
              const std::pair<typename Surface::FT, typename Surface::FT>& v) {
  typedef typename Surface::Traits Traits;
  typedef typename Surface::FT FT;
  typedef Coordinates<Traits> Vector;
  const Vector a = space_coordinates<Traits, FT>(s.axis_point(), "revolution: point on the axis"),
               w = space_coordinates<Traits, FT>(s.axis(), "revolution: axis");
  if (profile.dimension() != 4) throw Error(Error_code::dimension_mismatch, "revolution: the profile");
  const FT W = dot(w, w);
  const std::array<std::pair<FT, FT>, 3> arguments{{{v.first, v.first}, {v.first, v.second}, {v.second, v.second}}};
  Homogeneous_points<Traits> net;
  for (const Homogeneous_point<Traits>& p : profile.control_points()) {
    net.emplace_back();
    Vector q(3);
    for (int i = 0; i < 3; ++i) q[i] = p[i] - p[3] * a[i];
    if (s.opposite()) q += FT(FT(2) / W) * cross_product(w, cross_product(w, q));
    const Vector wq = cross_product(w, q), wwq = cross_product(w, wq);
    for (const std::pair<FT, FT>& x : arguments) {
      const FT sum = FT(x.first + x.second), product = FT(x.first * x.second), weight = FT(FT(1) + product * W);
      Homogeneous_point<Traits> r(4);
      for (int i = 0; i < 3; ++i) r[i] = FT(weight * (q[i] + p[3] * a[i]) + sum * wq[i] + FT(FT(2) * product) * wwq[i]);
      r[3] = FT(weight * p[3]);
      net.back().push_back(r);
    }
  }
  return net;
}

template <class Traits, int Degree, class Surface, class Net>
Rational_bezier_patch<Traits> rational_patch(const Rational_bezier_curve<Traits, Degree>& profile, const Surface& s,
                                             const Net& net) {
  typedef typename Rational_bezier_patch<Traits>::Homogeneous Patch;
  return Rational_bezier_patch<Traits>(Patch(net, profile.domain(), s.domain_v()));
}
template <class Traits, class Surface, class Net>
Rational_bspline_surface<Traits> rational_spline(const Rational_bspline_curve<Traits>& profile, const Surface& s,
                                                 const Net& net) {
  typedef typename Rational_bspline_surface<Traits>::Homogeneous Spline;
  const int degree_v = static_cast<int>(net[0].size()) - 1;
  return Rational_bspline_surface<Traits>(Spline(
      net, profile.knots(), Knot_vector<typename Traits::FT>(degree_v, s.domain_v().first, s.domain_v().second)));
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the extrusion of a rational Bézier curve as a patch of degree 1 in `v`, with the
/// parametrisation of the surface.
/// \throws Error `dimension_mismatch` unless the profile is in dimension 3
template <class Traits, int Degree>
Rational_bezier_patch<Traits> bezier_patch(const Extrusion_surface_3<Rational_bezier_curve<Traits, Degree>>& s) {
  return internal::rational_patch(s.profile(), s, internal::extruded(s.profile().homogeneous(), s));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the extrusion of a rational B-spline curve as a surface of degree 1 in `v`, with the
/// parametrisation of the surface. Convert a polynomial profile; `polynomial()` of the result gives
/// the polynomial surface.
/// \throws Error `dimension_mismatch` unless the profile is in dimension 3
template <class Traits>
Rational_bspline_surface<Traits> bspline_surface(const Extrusion_surface_3<Rational_bspline_curve<Traits>>& s) {
  return internal::rational_spline(s.profile(), s, internal::extruded(s.profile().homogeneous(), s));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the revolution of a rational Bézier curve as a patch of degree 2 in `v`, with the
/// parametrisation of the surface. The weights in `v` are
/// \f$ 1 + v_0^2 W, 1 + v_0 v_1 W, 1 + v_1^2 W \f$ with \f$ W = w \cdot w \f$: the second is not
/// positive for half a turn and more.
/// \throws Error `dimension_mismatch` unless the profile is in dimension 3
template <class Traits, int Degree>
Rational_bezier_patch<Traits> bezier_patch(const Revolution_surface_3<Rational_bezier_curve<Traits, Degree>>& s) {
  return internal::rational_patch(s.profile(), s, internal::revolved(s.profile().homogeneous(), s, s.domain_v()));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the revolution of a Bézier curve as a patch, see the function for rational curves.
/// \throws Error `dimension_mismatch` unless the profile is in dimension 3
template <class Traits, int Degree>
Rational_bezier_patch<Traits> bezier_patch(const Revolution_surface_3<Bezier_curve<Traits, Degree>>& s) {
  const Rational_bezier_curve<Traits, Degree> profile(s.profile());
  return internal::rational_patch(profile, s, internal::revolved(profile.homogeneous(), s, s.domain_v()));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the revolution of a rational B-spline curve as a surface of degree 2 in `v`, see the
/// function for Bézier curves. Convert a polynomial profile.
/// \throws Error `dimension_mismatch` unless the profile is in dimension 3
template <class Traits>
Rational_bspline_surface<Traits> bspline_surface(const Revolution_surface_3<Rational_bspline_curve<Traits>>& s) {
  return internal::rational_spline(s.profile(), s, internal::revolved(s.profile().homogeneous(), s, s.domain_v()));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the full turn of a rational B-spline curve about the axis through `a` in the direction
/// `w`, as a closed surface of degree 2 in `v` with the domain [0, 4]. At `v = 0, 1, 2, 3` the
/// angles are 0, \f$ \theta \f$, \f$ \pi \f$ and \f$ 2\pi - \theta \f$, with
/// \f$ \tan(\theta/2) = r |w| \f$, where `r` is a power of two near \f$ 1/|w| \f$: quarters when
/// \f$ |w| \f$ is a power of two; for another axis the sine of a quarter turn need not be rational.
/// It is \f$ G^\infty \f$ across the knots of `v` all the same. Where the profile runs in the
/// direction of `w`, \f$ S_u \times S_v \f$ points to the axis: reverse the profile to turn it
/// outwards.
/// \throws Error `dimension_mismatch` unless in dimension 3, `zero_direction` for `w = 0`,
///   `not_finite`
template <class Traits>
Rational_bspline_surface<Traits> full_revolution(const Rational_bspline_curve<Traits>& profile,
                                                 const typename Traits::Point& a, const typename Traits::Vector& w) {
  typedef typename Traits::FT FT;
  typedef std::pair<FT, FT> Interval;
  const Coordinates<Traits> axis = internal::direction_coordinates<Traits, FT>(w, "full_revolution: axis");
  const FT W = dot(axis, axis);
  FT r(1); // 1/2 < r^2 W <= 2
  while (FT(2) < FT(r * r * W)) r = FT(r / FT(2));
  while (!(FT(1) < FT(FT(2) * r * r * W))) r = FT(r * FT(2));
  typedef Revolution_surface_3<Rational_bspline_curve<Traits>> Surface;
  const Surface s(profile, a, w, Interval(FT(-r), r)), rest = s.complement();
  const auto curve = profile.homogeneous();
  internal::Homogeneous_points<Traits> net(profile.number_of_points());
  const auto add = [&](const Surface& part, const Interval& v, const FT& factor) {
    const internal::Homogeneous_points<Traits> piece = internal::revolved(curve, part, v);
    for (std::size_t i = 0; i < net.size(); ++i) {
      if (net[i].empty()) net[i].push_back(piece[i][0]);
      for (int j = 1; j < 3; ++j) net[i].push_back(factor * piece[i][j]);
    }
  };
  // The weights at the ends of the parts are 1 + v^2 W: 1 + r^2 W in the first part and 1 + 1/(r^2
  // W) in the second.
  const FT factor = FT(r * r * W);
  add(s, Interval(FT(0), r), FT(1));
  add(rest, Interval(rest.domain_v().first, FT(0)), factor);
  add(rest, Interval(FT(0), rest.domain_v().second), factor);
  add(s, Interval(FT(-r), FT(0)), FT(1));
  const std::vector<typename Knot_vector<FT>::Knot> inner = {{FT(1), 2}, {FT(2), 2}, {FT(3), 2}};
  return Rational_bspline_surface<Traits>(typename Rational_bspline_surface<Traits>::Homogeneous(
      net, profile.knots(), Knot_vector<FT>(2, FT(0), FT(4), inner)));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the full turn of any other profile: a `Bezier_curve`, a `Rational_bezier_curve`, a
/// `Bspline_curve`, or a `Composite_bezier_curve`, whose segments are joined to one B-spline curve.
template <class Profile, class Traits = typename Profile::Traits,
          class = std::enable_if_t<!std::is_same_v<Profile, Rational_bspline_curve<Traits>>>>
Rational_bspline_surface<Traits> full_revolution(const Profile& profile, const typename Traits::Point& a,
                                                 const typename Traits::Vector& w) {
  typedef Rational_bspline_curve<Traits> Spline;
  if constexpr (std::is_constructible_v<Bspline_curve<Traits>, const Profile&>)
    return full_revolution(Spline(Bspline_curve<Traits>(profile)), a, w);
  else if constexpr (std::is_constructible_v<Spline, const Profile&>)
    return full_revolution(Spline(profile), a, w);
  else {
    const auto segments = profile.segments();
    return full_revolution(Spline(Bspline_curve<Traits>(segments.begin(), segments.end())), a, w);
  }
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_ELEMENTARY_SURFACES_H
