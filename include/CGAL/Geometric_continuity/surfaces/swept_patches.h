// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_SWEPT_PATCHES_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_SWEPT_PATCHES_H

#include <CGAL/Geometric_continuity/curves/Rational_bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_bspline_curve.h>
#include <CGAL/Geometric_continuity/surfaces/Extrusion_surface_3.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Revolution_surface_3.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

/// \file swept_patches.h
/// Surfaces of extrusion and of revolution as patches, exactly, for profiles that are Bézier or B-spline curves, rational or not.

namespace CGAL {
namespace Geometric_continuity {

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

// The Bernstein coefficients on [v0, v1], of degree 2, of the rotation of each point, whose homogeneous coordinates are those of
// `Revolution_surface_3` times 1 + v^2 W: the coefficients 1, v, v^2 have the blossom 1, (s + t)/2, s t. With q = p - w a it is
// (1 + s t W) (q + w a) + (s + t) w x q + 2 s t w x (w x q), and the weight is (1 + s t W) w.
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
/// Returns the extrusion of a rational Bézier curve as a patch of degree 1 in `v`, with the parametrisation of the surface.
/// \throws Error `dimension_mismatch` unless the profile is in dimension 3
template <class Traits, int Degree>
Rational_bezier_patch<Traits> bezier_patch(const Extrusion_surface_3<Rational_bezier_curve<Traits, Degree>>& s) {
  return internal::rational_patch(s.profile(), s, internal::extruded(s.profile().homogeneous(), s));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the extrusion of a rational B-spline curve as a surface of degree 1 in `v`, with the parametrisation of the surface.
/// Convert a polynomial profile; `polynomial()` of the result gives the polynomial surface.
/// \throws Error `dimension_mismatch` unless the profile is in dimension 3
template <class Traits>
Rational_bspline_surface<Traits> bspline_surface(const Extrusion_surface_3<Rational_bspline_curve<Traits>>& s) {
  return internal::rational_spline(s.profile(), s, internal::extruded(s.profile().homogeneous(), s));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the revolution of a rational Bézier curve as a patch of degree 2 in `v`, with the parametrisation of the surface. The
/// weights in `v` are \f$ 1 + v_0^2 W, 1 + v_0 v_1 W, 1 + v_1^2 W \f$ with \f$ W = w \cdot w \f$: the second is not positive for half
/// a turn and more.
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
/// Returns the revolution of a rational B-spline curve as a surface of degree 2 in `v`, see the function for Bézier curves.
/// Convert a polynomial profile.
/// \throws Error `dimension_mismatch` unless the profile is in dimension 3
template <class Traits>
Rational_bspline_surface<Traits> bspline_surface(const Revolution_surface_3<Rational_bspline_curve<Traits>>& s) {
  return internal::rational_spline(s.profile(), s, internal::revolved(s.profile().homogeneous(), s, s.domain_v()));
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the full turn of a rational B-spline curve about the axis through `a` in the direction `w`, as a closed surface of
/// degree 2 in `v` with the domain [0, 4]. At `v = 0, 1, 2, 3` the angles are 0, \f$ \theta \f$, \f$ \pi \f$ and
/// \f$ 2\pi - \theta \f$, with \f$ \tan(\theta/2) = r |w| \f$, where `r` is a power of two near \f$ 1/|w| \f$: quarters when
/// \f$ |w| \f$ is a power of two; for another axis the sine of a quarter turn need not be rational. It is
/// \f$ G^\infty \f$ across the knots of `v` all the same.
/// \throws Error `dimension_mismatch` unless in dimension 3, `zero_direction` for `w = 0`, `not_finite`
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
  // The weights at the ends of the parts are 1 + v^2 W: 1 + r^2 W in the first part and 1 + 1/(r^2 W) in the second.
  const FT factor = FT(r * r * W);
  add(s, Interval(FT(0), r), FT(1));
  add(rest, Interval(rest.domain_v().first, FT(0)), factor);
  add(rest, Interval(FT(0), rest.domain_v().second), factor);
  add(s, Interval(FT(-r), FT(0)), FT(1));
  const std::vector<typename Knot_vector<FT>::Knot> inner = {{FT(1), 2}, {FT(2), 2}, {FT(3), 2}};
  return Rational_bspline_surface<Traits>(typename Rational_bspline_surface<Traits>::Homogeneous(
      net, profile.knots(), Knot_vector<FT>(2, FT(0), FT(4), inner)));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_SWEPT_PATCHES_H
