// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_MIDPOINT_CONSTRUCTION_H
#define CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_MIDPOINT_CONSTRUCTION_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>

#include <string>

/// \file midpoint_construction.h
/// Hagen's constructions (3.3.1) and (3.3.2), corrected, of the first points of a polygon that continues another one with a
/// continuous curvature vector and \f$ \beta = 1 \f$, by reflections only.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the reflection \f$ 2c - x \f$ of a point in a centre, which becomes the midpoint of both. With \f$ c = b_0 \f$ and
/// \f$ x = b_{-1} \f$ this is Hagen's construction (3.3.1) of the \f$ b_1 \f$ of a continuous tangent.
/// \throws Error `dimension_mismatch`, `not_finite` when the result overflows the number type
template <class Traits>
typename Traits::Point reflection(const typename Traits::Point& centre, const typename Traits::Point& x) {
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;
  const Coordinates c = Geometric_continuity::coordinates<Traits>(centre),
                    d = Geometric_continuity::coordinates<Traits>(x);
  if (c.dimension() != d.dimension()) throw Error(Error_code::dimension_mismatch, "reflection");
  const Coordinates reflected = c + (c - d);
  for (const typename Traits::FT& y : reflected) internal::check_finite(y, "reflection");
  return Geometric_continuity::to_point<Traits>(reflected);
}

/// \ingroup PkgGeometricContinuityConstruction
/// The points of Hagen's construction (3.3.2), corrected, for curvature continuity with \f$ \beta = 1 \f$. All of them come
/// from midpoints, with two operations per coordinate each, in any dimension and over any field.
///
/// A space curve can be constructed from two planar projections (Hagen, remark 2) only when both use the same \f$ C_0 \f$.
/// This is automatic where the tangent is not orthogonal to the axis that the projections share.
template <class Traits> struct Midpoint_construction {
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;

  Point b1; ///< \f$ b_0 \f$ is the midpoint of \f$ b_{-1}, b_1 \f$
  Point d0; ///< \f$ b_{-1} \f$ is the midpoint of \f$ b_{-2}, d_0 \f$
  /// \f$ \tilde b_2 \f$: \f$ b_1 \f$ is the midpoint of \f$ d_0, \tilde b_2 \f$; \f$ C_0 = 4 \f$, the \f$ C^2 \f$ join
  Point b2_tilde;
  /// \f$ \bar b_2 \f$: \f$ b_0 \f$ is the midpoint of \f$ d_0, \bar b_2 \f$; \f$ C_0 = 2 \f$
  Point b2_bar;

  /// Returns the alternatives \f$ b_2 = \bar b_2 + \frac{C_0 - 2}{2} (\tilde b_2 - \bar b_2) \f$, an affine line.
  /// \throws Error `not_finite` when the result overflows the number type
  Point b2(const FT& c0) const {
    typedef Geometric_continuity::Coordinates<Traits> Coordinates;
    const Coordinates bar = Geometric_continuity::coordinates<Traits>(b2_bar),
                      point =
                          bar + FT((c0 - FT(2)) / FT(2)) * (Geometric_continuity::coordinates<Traits>(b2_tilde) - bar);
    for (const FT& x : point) internal::check_finite(x, "midpoint_construction: b2");
    return Geometric_continuity::to_point<Traits>(point);
  }
};

/// \ingroup PkgGeometricContinuityConstruction
/// Constructs the points of Hagen (3.3.1) and (3.3.2) at the end \f$ b_{-2}, b_{-1}, b_0 \f$ of a polygon. Where
/// \f$ b_{-1} = b_0 \f$ the line of alternatives shrinks to a point.
/// \throws Error `dimension_mismatch`, `not_finite` when a point overflows the number type
template <class Traits>
Midpoint_construction<Traits> midpoint_construction(const typename Traits::Point& b_2,
                                                    const typename Traits::Point& b_1,
                                                    const typename Traits::Point& b0) {
  Midpoint_construction<Traits> m;
  m.b1 = reflection<Traits>(b0, b_1);
  m.d0 = reflection<Traits>(b_1, b_2);
  m.b2_tilde = reflection<Traits>(m.b1, m.d0);
  m.b2_bar = reflection<Traits>(b0, m.d0);
  return m;
}

/// \ingroup PkgGeometricContinuityConstruction
/// Constructs the points of Hagen (3.3.1) and (3.3.2) behind a Bézier curve, from its last three control points.
/// \throws Error `wrong_number_of_points` for a degree below 2, `not_finite` when a point overflows the number type
template <class Traits, int Degree>
Midpoint_construction<Traits> midpoint_construction(const Bezier_curve<Traits, Degree>& left) {
  const int m = left.degree();
  if (m < 2)
    throw Error(Error_code::wrong_number_of_points,
                "midpoint_construction: it does not exist for degree " + std::to_string(m));
  return midpoint_construction<Traits>(left.control_point(m - 2), left.control_point(m - 1), left.control_point(m));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_MIDPOINT_CONSTRUCTION_H
