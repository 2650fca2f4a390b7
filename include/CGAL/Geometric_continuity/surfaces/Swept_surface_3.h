// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_SWEPT_SURFACE_3_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_SWEPT_SURFACE_3_H

#include <CGAL/Geometric_continuity/local/Surface_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/surfaces/internal/sweep_input.h>

#include <utility>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// What all surfaces have that a profile curve sweeps when it moves: the profile, whose parameter is `u`, and the domain of
/// the parameter `v` of the motion. It is the base class of `Extrusion_surface_3` and `Revolution_surface_3`.
///
/// \tparam Curve a copyable model of `ParametricCurve` in dimension 3 that gives jets at all parameters of its domain
template <class Curve_> class Swept_surface_3 {
public:
  typedef Curve_ Curve;                   ///< the profile
  typedef typename Curve::Traits Traits;  ///< the geometric traits
  typedef typename Traits::FT FT;         ///< the number type
  typedef typename Traits::Point Point;   ///< the points
  typedef typename Traits::Vector Vector; ///< the vectors
  typedef std::pair<FT, FT> Interval;     ///< the two ends of a parameter interval

  const Curve& profile() const { return profile_; }       ///< Returns the profile curve.
  Interval domain_u() const { return profile_.domain(); } ///< Returns the domain of the profile.
  Interval domain_v() const { return v_; }                ///< Returns the domain of `v`.

protected:
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;

  // `place` names the domain of v, for messages.
  Swept_surface_3(Curve profile, const Interval& v, const char* place) : profile_(std::move(profile)), v_(v) {
    internal::check_interval(v_, place);
  }

private:
  Curve profile_;
  Interval v_;
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_SWEPT_SURFACE_3_H
