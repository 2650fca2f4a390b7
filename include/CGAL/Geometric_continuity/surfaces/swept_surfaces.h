// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_SWEPT_SURFACES_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_SWEPT_SURFACES_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/local/Surface_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/internal/sweep_input.h>

#include <array>
#include <utility>
#include <vector>

/// \file swept_surfaces.h
/// Surfaces of extrusion and of revolution in space, with any profile curve: their points, jets and
/// normals.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// The common part of all surfaces that a profile curve sweeps when it moves: the profile, whose
/// parameter is `u`, and the domain of the parameter `v` of the motion. It is the base class of
/// `Extrusion_surface_3` and `Revolution_surface_3`.
///
/// \tparam Curve a copyable model of `ParametricCurve` in dimension 3 that gives jets at all
///   parameters of its domain
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

/// \ingroup PkgGeometricContinuitySurfaces
/// The surface \f$ S(u, v) = c(u) + v\,w \f$ that a profile curve `c` sweeps when it moves in the
/// direction `w`: a general cylinder. The parameter `u` is that of the profile, `v` is measured in
/// units of `w`. Lecture slides, "Normals".
///
/// The normal \f$ S_u \times S_v = c'(u) \times w \f$ does not depend on `v`. It vanishes where
/// \f$ c' = 0 \f$ or \f$ c' \parallel w \f$, see `sweep_defects()`. All is exact with an exact
/// kernel if the jets of the profile are.
///
/// \tparam Curve a copyable model of `ParametricCurve` in dimension 3 that gives jets at all
///   parameters of its domain
/// \cgalModels{ParametricSurface}
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

  /// Constructs the surface from the profile, the direction `w`, and the domain of `v`, by default
  /// [0, 1].
  /// \throws Error `zero_direction` for the zero vector, `empty_domain` unless the domain has
  ///   positive length, `dimension_mismatch` unless in dimension 3, `not_finite` for floating-point
  ///   coordinates, ends of the domain or a length of the domain that are infinite or not a number
  Extrusion_surface_3(Curve profile, const Vector& direction, const Interval& v = Interval(FT(0), FT(1)))
      : Base(std::move(profile), v, "Extrusion_surface_3: domain of v"), direction_(direction) {
    internal::direction_coordinates<Traits, FT>(direction, "Extrusion_surface_3: direction");
  }

  /// Returns the vector `w`.
  const Vector& direction() const { return direction_; }

  /// Returns the point at (`u`, `v`); `v` may lie outside its domain. One jet of the profile.
  /// \throws Error `dimension_mismatch` unless the profile is in dimension 3, `not_finite` when a
  ///   result overflows in floating-point arithmetic, and what the profile throws
  Point operator()(const FT& u, const FT& v) const { return jet(u, v, 0).point(); }

  /// Returns the jet of order `k >= 0`: \f$ \partial^i S / \partial u^i = c^{(i)} \f$ and
  /// \f$ \partial S / \partial v = w \f$, all others are zero. One jet of order `k` of the profile.
  /// \throws Error `dimension_mismatch` unless the profile is in dimension 3, `not_finite` when a
  ///   result overflows in floating-point arithmetic, and what the profile throws
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
  /// \throws Error `dimension_mismatch` unless the profile is in dimension 3, `not_finite` when a
  ///   result overflows in floating-point arithmetic, and what the profile throws
  Vector normal(const FT& u, const FT& v) const { return Geometric_continuity::normal(jet(u, v, 1)); }

private:
  Vector direction_;
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the extrusion of a Bézier curve with the control points \f$ b_i \f$ as a patch, of the
/// degree of the curve in `u` and of degree 1 in `v`. Its control points are \f$ b_i + v_0 w \f$
/// and \f$ b_i + v_1 w \f$, where \f$ [v_0, v_1] \f$ is the domain of `v`.
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

namespace internal {

// The derivatives of order 0 to k, at v, of the two functions of a rotation by the quaternion (1, v
// w), with W = w.w:
//   R(v) x = x + f w x x + g w x (w x x),  f = 2v / (1 + v^2 W),  g = 2v^2 / (1 + v^2 W).
// D f = p with the polynomials D = 1 + v^2 W and p, differentiated n times:
//   D f^(n) + n D' f^(n-1) + n(n-1)/2 D'' f^(n-2) = p^(n).
template <class FT> struct Rotation_functions {
  std::vector<FT> f, g;

  Rotation_functions(const FT& v, const FT& W, int k) {
    const FT d0 = FT(1) + v * v * W, d1 = FT(2) * v * W, d2 = FT(2) * W;
    const FT pf[3] = {FT(FT(2) * v), FT(2), FT(0)}, pg[3] = {FT(FT(2) * v * v), FT(FT(4) * v), FT(4)};
    for (int n = 0; n <= k; ++n) {
      f.push_back(next(f, pf, n, d0, d1, d2));
      g.push_back(next(g, pg, n, d0, d1, d2));
    }
  }

private:
  static FT next(const std::vector<FT>& f, const FT* p, int n, const FT& d0, const FT& d1, const FT& d2) {
    FT sum = n < 3 ? p[n] : FT(0);
    if (n > 0) sum -= FT(n) * d1 * f[n - 1];
    if (n > 1) sum -= FT(n) * FT(n - 1) / FT(2) * d2 * f[n - 2];
    sum /= d0;
    check_finite(sum, "Revolution_surface_3: rotation");
    return sum;
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// The surface that a profile curve `c` sweeps when it turns about the axis through the point `a`
/// with the direction `w`, \f$ S(u, v) = a + R_v (c(u) - a) \f$. The profile need not lie in a
/// plane through the axis, and may meet it.
///
/// <b>Parametrisation.</b> `u` is the parameter of the profile. \f$ R_v \f$ is the rotation by the
/// quaternion \f$ (1, v\,w) \f$, that is, by the angle \f$ \theta \f$ with
/// \f$ v = \tan(\theta/2) / |w| \f$:
///
/// \f[ R_v\,x = x + \frac{2v\; w \times x + 2v^2\; w \times (w \times x)}{1 + v^2\, w \cdot w}. \f]
///
/// It is rational in `v`, and so are all derivatives, whatever the length of `w`. At `v = 0` it is
/// the identity. All finite `v` leave out just half a turn, \f$ \theta = \pi \f$; `complement()`
/// covers the rest of the turn.
///
/// <b>Normals.</b> \f$ S_v = \frac{2}{1 + v^2\, w \cdot w}\; w \times (S - a) \f$. The positive
/// factor says how fast \f$ \theta \f$ grows with `v`: the derivative with respect to
/// \f$ \theta \f$, times \f$ |w| \f$, is \f$ w \times (S - a) \f$. `normal()` leaves the factor
/// out:
/// \f$ N = S_u \times (w \times (S - a)) = R_v (c' \times (w \times (c - a))) \f$. It vanishes
/// where the profile meets the axis, where \f$ c' = 0 \f$, and where the profile runs along a
/// parallel, see `sweep_defects()`. For a profile in a plane through the axis it flips where the
/// profile crosses the axis. Lecture slides, "Normals".
///
/// All is exact with an exact kernel if the jets of the profile are.
///
/// \tparam Curve a copyable model of `ParametricCurve` in dimension 3 that gives jets at all
///   parameters of its domain
/// \cgalModels{ParametricSurface}
template <class Curve_> class Revolution_surface_3 : public Swept_surface_3<Curve_> {
  typedef Swept_surface_3<Curve_> Base;
  typedef typename Base::Coordinates Coordinates;

public:
  using typename Base::Curve;
  using typename Base::FT;
  using typename Base::Interval;
  using typename Base::Point;
  using typename Base::Traits;
  using typename Base::Vector;

  /// Constructs the surface from the profile, a point `a` on the axis, its direction `w`, and the
  /// domain of `v`, by default [-1, 1].
  /// \throws Error `zero_direction` for the zero vector, `empty_domain` unless the domain has
  ///   positive length, `dimension_mismatch` unless in dimension 3, `not_finite` for floating-point
  ///   coordinates, ends of the domain or a length of the domain that are infinite or not a number
  Revolution_surface_3(Curve profile, const Point& axis_point, const Vector& axis,
                       const Interval& v = Interval(FT(-1), FT(1)))
      : Base(std::move(profile), v, "Revolution_surface_3: domain of v"), axis_point_(axis_point), axis_(axis) {
    internal::space_coordinates<Traits, FT>(axis_point, "Revolution_surface_3: point on the axis");
    internal::direction_coordinates<Traits, FT>(axis, "Revolution_surface_3: axis");
  }

  /// Returns the point `a`.
  const Point& axis_point() const { return axis_point_; }
  /// Returns the vector `w`.
  const Vector& axis() const { return axis_; }
  /// Tells whether the profile is first turned by \f$ \theta = \pi \f$, see `complement()`.
  bool opposite() const { return opposite_; }

  /// Returns the rest of the full turn: the surface of the profile turned by \f$ \theta = \pi \f$,
  /// with \f$ v \f$ in \f$ [-1/(v_1 W), -1/(v_0 W)] \f$, where \f$ [v_0, v_1] \f$ is the domain of
  /// `v` of this surface and \f$ W = w \cdot w \f$. Its first parallel is the last one of this
  /// surface, and conversely.
  /// \throws Error `parameter_outside_domain` unless \f$ v_0 < 0 < v_1 \f$, `not_finite` when the
  ///   new domain overflows in floating-point arithmetic
  Revolution_surface_3 complement() const {
    const Interval v = this->domain_v();
    if (!(v.first < FT(0) && FT(0) < v.second))
      throw Error(Error_code::parameter_outside_domain, "Revolution_surface_3::complement: the domain must contain 0");
    const Coordinates w = Geometric_continuity::coordinates<Traits>(axis_);
    const FT W = dot(w, w);
    Revolution_surface_3 r(this->profile(), axis_point_, axis_,
                           Interval(FT(FT(-1) / (v.second * W)), FT(FT(-1) / (v.first * W))));
    r.opposite_ = !opposite_;
    return r;
  }

  /// Returns the point at (`u`, `v`); `v` may lie outside its domain. One jet of the profile.
  /// \throws Error `dimension_mismatch` unless the profile is in dimension 3, `not_finite` when
  ///   \f$ v^2\, w \cdot w \f$ or a result overflows in floating-point arithmetic, and what the
  ///   profile throws
  Point operator()(const FT& u, const FT& v) const { return jet(u, v, 0).point(); }

  /// Returns the jet of order `k >= 0`:
  /// \f$ \partial^{i+j} S / \partial u^i \partial v^j = R^{(j)}_v\, c^{(i)}(u) \f$ for `i + j > 0`.
  /// One jet of order `k` of the profile and \f$ O(k^2) \f$ operations.
  /// \throws Error `dimension_mismatch` unless the profile is in dimension 3, `not_finite` when
  ///   \f$ v^2\, w \cdot w \f$ or a result overflows in floating-point arithmetic, and what the
  ///   profile throws
  Surface_jet<Traits> jet(const FT& u, const FT& v, int k) const {
    Surface_jet<Traits> jet(3, k);
    const Curve_jet<Traits> c = internal::profile_jet(this->profile(), u, k);
    const Coordinates a = Geometric_continuity::coordinates<Traits>(axis_point_),
                      w = Geometric_continuity::coordinates<Traits>(axis_);
    const FT W = dot(w, w);
    const internal::Rotation_functions<FT> rotation(v, W, k);
    for (int i = 0; i <= k; ++i) {
      Coordinates x = i == 0 ? c[0] - a : c[i];
      if (opposite_) x += FT(FT(2) / W) * cross_product(w, cross_product(w, x));
      const Coordinates y = cross_product(w, x), z = cross_product(w, y);
      for (int j = 0; i + j <= k; ++j) jet(i, j) = rotation.f[j] * y + rotation.g[j] * z;
      jet(i, 0) += x;
    }
    jet(0, 0) += a;
    internal::check_jet(jet, "Revolution_surface_3: jet");
    return jet;
  }

  /// Returns \f$ w \times (S - a) \f$, the derivative with respect to the angle times \f$ |w| \f$.
  /// \throws Error as `jet()`
  Vector angular_derivative(const FT& u, const FT& v) const {
    return Geometric_continuity::to_vector<Traits>(angular(jet(u, v, 0)));
  }

  /// Returns the normal \f$ N = S_u \times (w \times (S - a)) \f$, not normalised:
  /// \f$ S_u \times S_v \f$ without a factor that is positive everywhere. Its length does not
  /// depend on `v`.
  /// \throws Error as `jet()`
  Vector normal(const FT& u, const FT& v) const {
    const Surface_jet<Traits> s = jet(u, v, 1);
    return Geometric_continuity::to_vector<Traits>(cross_product(s(1, 0), angular(s)));
  }

private:
  Point axis_point_;
  Vector axis_;
  bool opposite_ = false; // the profile has been turned by half a turn before

  Coordinates angular(const Surface_jet<Traits>& s) const {
    return cross_product(Geometric_continuity::coordinates<Traits>(axis_),
                         s(0, 0) - Geometric_continuity::coordinates<Traits>(axis_point_));
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_SWEPT_SURFACES_H
