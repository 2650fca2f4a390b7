// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_POLYGON_INVARIANTS_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_POLYGON_INVARIANTS_H

#include <CGAL/Geometric_continuity/algebra/determinant.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// Curvature and torsion at one end of a Bézier curve. They do not depend on the length of the domain.
template <class FT> struct End_invariants {
  std::optional<FT> curvature_squared; ///< empty where the end leg is zero
  std::optional<FT> torsion;           ///< empty unless in space with nonzero curvature
};

namespace internal {

// From the legs p = b0 - b1, r = b2 - b1, s = b2 - b3 of a polygon of degree m, numbered from its end inwards.
template <class FT, int N>
End_invariants<FT> invariants_from_legs(int m, const std::vector<Coordinate_vector<FT, N>>& b) {
  typedef Coordinate_vector<FT, N> Coordinates;
  End_invariants<FT> result;
  if (m < 1) return result;
  const Coordinates p = b[0] - b[1];
  const FT pp = dot(p, p);
  if (pp == FT(0)) return result;
  if (m < 2) {
    result.curvature_squared = FT(0);
    return result;
  }
  const Coordinates r = b[2] - b[1];
  const FT pxr = gram_determinant(std::vector<Coordinates>{p, r}); // |p x r|^2
  const FT c = FT(m - 1) / FT(m);
  result.curvature_squared = FT(c * c * pxr / (pp * pp * pp));
  if (p.dimension() != 3 || pxr == FT(0)) return result;
  if (m < 3) {
    result.torsion = FT(0);
    return result;
  }
  const Coordinates s = b[2] - b[3];
  const Coordinates* legs[] = {&p, &r, &s};
  const FT det = determinant<FT>(3, [&](int row, int column) -> const FT& { return (*legs[row])[column]; });
  result.torsion = FT(FT(m - 2) / FT(m) * det / pxr);
  return result;
}

template <class Traits, int Degree>
End_invariants<typename Traits::FT> end_invariants(const Bezier_curve<Traits, Degree>& curve, bool at_end) {
  const int m = curve.degree();
  std::vector<Coordinates<Traits>> b;
  for (int i = 0; i <= std::min(m, 3); ++i) b.push_back(curve.coordinates(at_end ? m - i : i));
  return invariants_from_legs<typename Traits::FT, dimension_v<Traits>>(m, b);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// \f$ \kappa^2 \f$ and \f$ \tau \f$ at the end of a Bézier curve of degree `m`, read off the last three legs
/// \f$ p = b_0 - b_{-1},\ r = b_{-2} - b_{-1},\ s = b_{-2} - b_{-3} \f$ without differentiation:
/// \f$ \kappa^2 = \left(\frac{m-1}{m}\right)^2 \frac{|p \times r|^2}{|p|^6} \f$,
/// \f$ \tau = \frac{m-2}{m} \frac{\det(p,r,s)}{|p \times r|^2} \f$. Hagen (1.11), (1.12) at the ends of (3.1).
template <class Traits, int Degree>
End_invariants<typename Traits::FT> end_invariants(const Bezier_curve<Traits, Degree>& curve) {
  return internal::end_invariants(curve, true);
}

/// \ingroup PkgGeometricContinuityCurves
/// The same at the start of the curve. Run backwards, a curve keeps its curvature and its torsion.
template <class Traits, int Degree>
End_invariants<typename Traits::FT> start_invariants(const Bezier_curve<Traits, Degree>& curve) {
  return internal::end_invariants(curve, false);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_POLYGON_INVARIANTS_H
