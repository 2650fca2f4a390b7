// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_EXTRUSION_SURFACE_3_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_EXTRUSION_SURFACE_3_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Swept_surface_3.h>

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
template <class Curve_> class Extrusion_surface_3 : public Swept_surface_3<Curve_> {
  typedef Swept_surface_3<Curve_> Base;
  typedef typename Base::Coordinates Coordinates;

public:
  using typename Base::Curve;
  using typename Base::FT;
  using typename Base::Interval;
  using typename Base::Point;
  using typename Base::Traits;
  using typename Base::Vector;

  /// Constructs the surface from the profile, the direction `w`, and the domain of `v`, by default [0, 1].
  /// \throws Error `zero_direction` for the zero vector, `empty_domain` unless the domain has positive length,
  ///   `dimension_mismatch` unless in dimension 3, `not_finite` for floating-point coordinates, ends of the domain or a
  ///   length of the domain that are infinite or not a number
  Extrusion_surface_3(Curve profile, const Vector& direction, const Interval& v = Interval(FT(0), FT(1)))
      : Base(std::move(profile), v, "Extrusion_surface_3: domain of v"), direction_(direction) {
    internal::direction_coordinates<Traits, FT>(direction, "Extrusion_surface_3: direction");
  }

  /// Returns the vector `w`.
  const Vector& direction() const { return direction_; }

  /// Returns the point at (`u`, `v`); `v` may lie outside its domain. One jet of the profile.
  /// \throws Error `dimension_mismatch` unless the profile is in dimension 3, `not_finite` when a result
  ///   overflows in floating-point arithmetic, and what the profile throws
  Point operator()(const FT& u, const FT& v) const { return jet(u, v, 0).point(); }

  /// Returns the jet of order `k >= 0`: \f$ \partial^i S / \partial u^i = c^{(i)} \f$ and
  /// \f$ \partial S / \partial v = w \f$, all others are zero. One jet of order `k` of the profile.
  /// \throws Error `dimension_mismatch` unless the profile is in dimension 3, `not_finite` when a result
  ///   overflows in floating-point arithmetic, and what the profile throws
  Surface_jet<Traits> jet(const FT& u, const FT& v, int k) const {
    Surface_jet<Traits> jet(3, k);
    const Curve_jet<Traits> c = internal::profile_jet(this->profile(), u, k);
    const Coordinates w = Geometric_continuity::coordinates<Traits>(direction_);
    for (int i = 0; i <= k; ++i) jet(i, 0) = c[i];
    jet(0, 0) += v * w;
    if (k > 0) jet(0, 1) = w;
    internal::check_jet(jet, "Extrusion_surface_3: jet");
    return jet;
  }

  /// Returns the normal \f$ S_u \times S_v = c'(u) \times w \f$, not normalised.
  /// \throws Error `dimension_mismatch` unless the profile is in dimension 3, `not_finite` when a result
  ///   overflows in floating-point arithmetic, and what the profile throws
  Vector normal(const FT& u, const FT& v) const { return Geometric_continuity::normal(jet(u, v, 1)); }

private:
  Vector direction_;
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the extrusion of a Bézier curve with the control points \f$ b_i \f$ as a patch, of the degree of the curve in `u`
/// and of degree 1 in `v`. Its control points are \f$ b_i + v_0 w \f$ and \f$ b_i + v_1 w \f$, where \f$ [v_0, v_1] \f$ is the domain of `v`.
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
