// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_MIDPOINT_CONSTRUCTION_H
#define CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_MIDPOINT_CONSTRUCTION_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>

#include <string>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// The reflection \f$ 2c - x \f$ of a point in a centre, which becomes the midpoint of both. With \f$ c = b_0 \f$ and
/// \f$ x = b_{-1} \f$ this is Hagen's construction (3.3.1) of the \f$ b_1 \f$ of a continuous tangent.
/// \throws Error `dimension_mismatch`
template <class Traits>
typename Traits::Point reflection(const typename Traits::Point& center, const typename Traits::Point& x) {
  const Geometric_continuity::Coordinates<Traits> c = Geometric_continuity::coordinates<Traits>(center),
                                                  d = Geometric_continuity::coordinates<Traits>(x);
  if (c.dimension() != d.dimension()) throw Error(Error_code::dimension_mismatch, "reflection");
  return Geometric_continuity::to_point<Traits>(c + (c - d));
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
  Point
      b2_tilde; ///< \f$ \tilde b_2 \f$: \f$ b_1 \f$ is the midpoint of \f$ d_0, \tilde b_2 \f$; \f$ C_0 = 4 \f$, the \f$ C^2 \f$ join
  Point b2_bar; ///< \f$ \bar b_2 \f$: \f$ b_0 \f$ is the midpoint of \f$ d_0, \bar b_2 \f$; \f$ C_0 = 2 \f$

  /// The alternatives \f$ b_2 = \bar b_2 + \frac{C_0 - 2}{2} (\tilde b_2 - \bar b_2) \f$, an affine line.
  Point b2(const FT& c0) const {
    const Geometric_continuity::Coordinates<Traits> bar = Geometric_continuity::coordinates<Traits>(b2_bar);
    return Geometric_continuity::to_point<Traits>(
        bar + FT((c0 - FT(2)) / FT(2)) * (Geometric_continuity::coordinates<Traits>(b2_tilde) - bar));
  }
};

/// \ingroup PkgGeometricContinuityConstruction
/// Hagen's constructions (3.3.1) and (3.3.2) at the end \f$ b_{-2}, b_{-1}, b_0 \f$ of a polygon. Where
/// \f$ b_{-1} = b_0 \f$ the line of alternatives shrinks to a point. \throws Error `dimension_mismatch`
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
/// The same at the end of a curve. \throws Error `wrong_number_of_points` for a degree below 2
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
