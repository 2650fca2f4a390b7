// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_EXTRUSION_SURFACE_3_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_EXTRUSION_SURFACE_3_H

#include <CGAL/Geometric_continuity/local/Surface_jet.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/internal/sweep_input.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// The surface \f$ S(u, v) = c(u) + v\,w \f$ that a profile curve `c` sweeps when it moves in the direction `w`: a general
/// cylinder. The parameter `u` is that of the profile, `v` is measured in units of `w`. Lecture slides, "Normals".
///
/// The normal \f$ S_u \times S_v = c'(u) \times w \f$ does not depend on `v`. It vanishes where \f$ c' = 0 \f$ or
/// \f$ c' \parallel w \f$, see `sweep_defects()`. All is exact with an exact kernel if the jets of the profile are.
///
/// \tparam Curve a copyable model of `ParametricCurve` in dimension 3 that gives jets at all parameters of its domain
/// \models ParametricSurface
template <class Curve_> class Extrusion_surface_3 {
public:
  typedef Curve_ Curve;
  typedef typename Curve::Traits Traits;
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  typedef typename Traits::Vector Vector;
  typedef std::pair<FT, FT> Interval;

private:
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;

  Curve profile_;
  Vector direction_;
  Interval v_;

public:
  /// From the profile, the direction `w`, and the domain of `v`, by default [0, 1].
  /// \throws Error `zero_direction` for the zero vector, `empty_domain` unless the domain has positive length,
  ///   `dimension_mismatch` unless in dimension 3, `not_finite`
  Extrusion_surface_3(Curve profile, const Vector& direction, const Interval& v = Interval(FT(0), FT(1)))
      : profile_(std::move(profile)), direction_(direction), v_(v) {
    internal::direction_coordinates<Traits, FT>(direction, "Extrusion_surface_3: direction");
    internal::check_interval(v_, "Extrusion_surface_3: domain of v");
  }

  /// The curve `c`.
  const Curve& profile() const { return profile_; }
  /// The vector `w`.
  const Vector& direction() const { return direction_; }

  /// The domain of the profile.
  Interval domain_u() const { return profile_.domain(); }
  /// The domain of `v`.
  Interval domain_v() const { return v_; }

  /// The point at (`u`, `v`); `v` may lie outside its domain. One jet of the profile.
  Point operator()(const FT& u, const FT& v) const { return jet(u, v, 0).point(); }

  /// The jet of order `k >= 0`: \f$ \partial^i S / \partial u^i = c^{(i)} \f$ and \f$ \partial S / \partial v = w \f$, all
  /// others are zero. One jet of order `k` of the profile.
  /// \throws Error `dimension_mismatch` unless the profile is in dimension 3, and what the profile throws
  Surface_jet<Traits> jet(const FT& u, const FT& v, int k) const {
    const Curve_jet<Traits> c = internal::profile_jet(profile_, u, k);
    const Coordinates w = Geometric_continuity::coordinates<Traits>(direction_);
    Surface_jet<Traits> jet(3, k);
    for (int i = 0; i <= k; ++i) jet(i, 0) = c[i];
    jet(0, 0) += v * w;
    if (k > 0) jet(0, 1) = w;
    return jet;
  }

  /// The normal \f$ S_u \times S_v = c'(u) \times w \f$, not normalised.
  /// \throws Error as `jet()`
  Vector normal(const FT& u, const FT& v) const { return Geometric_continuity::normal(jet(u, v, 1)); }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// The extrusion of a Bézier curve with the control points \f$ b_i \f$ as a patch of the same degree in `u` and of degree 1 in
/// `v`: its control points are \f$ b_i + v_0 w \f$ and \f$ b_i + v_1 w \f$, where \f$ [v_0, v_1] \f$ is the domain of `v`.
/// \throws Error `dimension_mismatch` unless the profile is in dimension 3
template <class Traits, int Degree>
Bezier_patch<Traits> bezier_patch(const Extrusion_surface_3<Bezier_curve<Traits, Degree>>& s) {
  const Geometric_continuity::Coordinates<Traits> w = Geometric_continuity::coordinates<Traits>(s.direction());
  if (s.profile().dimension() != 3) throw Error(Error_code::dimension_mismatch, "bezier_patch: the profile");
  std::vector<std::array<typename Traits::Point, 2>> net;
  for (int i = 0; i <= s.profile().degree(); ++i)
    net.push_back({Geometric_continuity::to_point<Traits>(s.profile().coordinates(i) + s.domain_v().first * w),
                   Geometric_continuity::to_point<Traits>(s.profile().coordinates(i) + s.domain_v().second * w)});
  return Bezier_patch<Traits>(net, s.domain_u(), s.domain_v());
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_EXTRUSION_SURFACE_3_H
