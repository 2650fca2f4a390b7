// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_POLYGON_INVARIANTS_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_POLYGON_INVARIANTS_H

#include <CGAL/Geometric_continuity/algebra/determinant.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/local/internal/Scaled_vector.h>

#include <algorithm>
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

// From the vectors p = b0 - b1, r = b2 - b1, s = b2 - b3 of a polygon of degree m, numbered from its end inwards. Scaled, so
// that no product of floating-point numbers overflows.
template <class FT, int N>
End_invariants<FT> invariants_from_legs(int m, const std::vector<Coordinate_vector<FT, N>>& b) {
  typedef Coordinate_vector<FT, N> Coordinates;
  constexpr const char* place = "end_invariants";
  End_invariants<FT> result;
  if (m < 1) return result;
  const Coordinates first = b[0] - b[1];
  const Scaled_vector<FT, N> p(first, place);
  const FT pp = dot(*p, *p);
  if (pp == FT(0)) return result;
  if (m < 2) {
    result.curvature_squared = FT(0);
    return result;
  }
  const Coordinates second = b[2] - b[1];
  const Scaled_vector<FT, N> r(second, place);
  const FT pxr = gram_determinant(std::vector<Coordinates>{*p, *r}); // |p x r|^2
  const FT c = FT(m - 1) / FT(m);
  result.curvature_squared =
      times_power_of_two(FT(c * c * pxr / (pp * pp * pp)), 2 * r.exponent() - 4 * p.exponent(), place);
  if (first.dimension() != 3 || pxr == FT(0)) return result;
  if (m < 3) {
    result.torsion = FT(0);
    return result;
  }
  const Coordinates third = b[2] - b[3];
  const Scaled_vector<FT, N> s(third, place);
  const Coordinates* legs[] = {&*p, &*r, &*s};
  const FT det = determinant<FT>(3, [&](int row, int column) -> const FT& { return (*legs[row])[column]; });
  result.torsion =
      times_power_of_two(FT(FT(m - 2) / FT(m) * det / pxr), s.exponent() - p.exponent() - r.exponent(), place);
  return result;
}

// index(0), index(1), ... are the numbers of the control points from the end inwards.
template <class Traits, int Degree, class Index>
End_invariants<typename Traits::FT> invariants_at(const Bezier_curve<Traits, Degree>& curve, const Index& index) {
  const int m = curve.degree();
  std::vector<Coordinates<Traits>> b;
  for (int j = 0; j <= (std::min)(m, 3); ++j) b.push_back(curve.coordinates(index(j)));
  return invariants_from_legs<typename Traits::FT, dimension_v<Traits>>(m, b);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// Returns \f$ \kappa^2 \f$ and \f$ \tau \f$ at the end of a Bézier curve of degree `m`, read off the last three legs
/// \f$ p = b_0 - b_{-1},\ r = b_{-2} - b_{-1},\ s = b_{-2} - b_{-3} \f$ without differentiation:
/// \f$ \kappa^2 = \left(\frac{m-1}{m}\right)^2 \frac{|p \times r|^2}{|p|^6} \f$,
/// \f$ \tau = \frac{m-2}{m} \frac{\det(p,r,s)}{|p \times r|^2} \f$. Hagen (1.11), (1.12) at the ends of (3.1).
/// \throws Error `not_finite` when a floating-point result overflows
template <class Traits, int Degree>
End_invariants<typename Traits::FT> end_invariants(const Bezier_curve<Traits, Degree>& curve) {
  return internal::invariants_at(curve, [m = curve.degree()](int j) { return m - j; });
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns \f$ \kappa^2 \f$ and \f$ \tau \f$ at the start of a Bézier curve of degree `m`, read off the first three legs as
/// `end_invariants()` reads the last ones: in the opposite direction, a curve has the same curvature and torsion.
/// \throws Error `not_finite` when a floating-point result overflows
template <class Traits, int Degree>
End_invariants<typename Traits::FT> start_invariants(const Bezier_curve<Traits, Degree>& curve) {
  return internal::invariants_at(curve, [](int j) { return j; });
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_POLYGON_INVARIANTS_H
