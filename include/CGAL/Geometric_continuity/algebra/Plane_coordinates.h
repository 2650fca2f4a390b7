// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_PLANE_COORDINATES_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_PLANE_COORDINATES_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>

#include <optional>
#include <utility>

/// \file Plane_coordinates.h
/// Coordinates in the plane of two vectors, by the normal equations. *Algebraic G1 connection*, (7) to (11).

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// The coordinates \f$ (\alpha, \beta) \f$ of vectors \f$ u = \alpha v + \beta w \f$ in the plane of two independent vectors
/// \f$ v, w \f$, by the normal equations
/// \f[ \left[\begin{array}{cc} v \cdot v & v \cdot w \\ v \cdot w & w \cdot w \end{array}\right]
///     \left[\begin{array}{c} \alpha \\ \beta \end{array}\right] = \left[\begin{array}{c} v \cdot u \\ w \cdot u \end{array}\right], \f]
/// in any dimension and without a root. *Algebraic G1 connection*, (7) to (11).
/// \tparam FT a field number type \tparam N the dimension, or 0 if it is known at run time only
template <class FT, int N> class Plane_coordinates {
public:
  typedef Coordinate_vector<FT, N> Vector; ///< the vectors

  /// Takes the two vectors. \f$ O(n) \f$ in dimension `n`
  /// \param place what the text of the error names
  /// \throws Error `singular_frame` when \f$ v \f$ and \f$ w \f$ are parallel, or one of them is zero
  Plane_coordinates(const Coordinate_vector<FT, N>& v, const Coordinate_vector<FT, N>& w,
                    const char* place = "Plane_coordinates")
      : v_(v), w_(w), vv_(dot(v, v)), vw_(dot(v, w)), ww_(dot(w, w)), gram_(vv_ * ww_ - vw_ * vw_) {
    if (gram_ == FT(0)) throw Error(Error_code::singular_frame, place);
  }

  /// Returns the coordinates of `u`; empty if `u` is not in the plane. \f$ O(n) \f$
  std::optional<std::pair<FT, FT>> operator()(const Vector& u) const {
    const std::pair<FT, FT> c = multiples(u);
    if (gram_ * u != c.first * v_ + c.second * w_) return std::nullopt;
    return divided(c);
  }

  /// Returns the coordinates of the vector of the plane that is nearest to `u`: of `u` itself, if it is in the plane.
  /// \f$ O(n) \f$
  std::pair<FT, FT> nearest(const Vector& u) const { return divided(multiples(u)); }

private:
  Vector v_, w_;
  FT vv_, vw_, ww_, gram_;

  // the numerators of (11)
  std::pair<FT, FT> multiples(const Vector& u) const {
    const FT vu = dot(v_, u), wu = dot(w_, u);
    return {FT(ww_ * vu - vw_ * wu), FT(vv_ * wu - vw_ * vu)};
  }
  std::pair<FT, FT> divided(const std::pair<FT, FT>& c) const { return {FT(c.first / gram_), FT(c.second / gram_)}; }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_PLANE_COORDINATES_H
