// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_PIECEWISE_CUBICS_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_PIECEWISE_CUBICS_H

#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Cubic_blended_curve.h>

#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// Whether a curve through or near many points returns to the first of them.
enum class Closure {
  open,  ///< it ends at the last point, or near it
  closed ///< it returns to the first point
};

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the name of a kind of curve, as spelled in the enumeration.
inline std::string to_string(Closure closure) { return closure == Closure::open ? "open" : "closed"; }

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the curve through or near many points: each four neighbours are the geometry of one cubic segment. `n` points make `n - 3`
/// segments, or `n` if the curve is closed, with the knots 0, 1, 2, ...
///
/// - `Catmull_rom_basis`, `Cardinal_basis`: through all points (an open one from the second to the last but one), \f$ C^1 \f$;
/// - `Uniform_bspline_basis`: near the points, \f$ C^2 \f$.
///
/// `chain_continuity()` proves these orders, with an exact kernel. It also finds where the order G is less because points
/// coincide: that is no error here. With rounded numbers the joins are smooth up to rounding only.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam InputIterator its value type is `Traits::Point`
/// \tparam Basis a model of `CubicBasis` with four points
/// \throws Error `wrong_number_of_points` for fewer than 4 points, or 3 if closed
/// \throws Error `curves_do_not_meet` for a basis of your own whose neighbouring segments do not meet
/// \throws Error `dimension_mismatch` when the points differ in dimension
/// \throws Error `not_finite` for an infinite or undefined floating-point number, and when a result overflows
///
/// \f$ O(n) \f$
template <class Traits, class Basis, class InputIterator>
Composite_bezier_curve<Traits, 3> piecewise_cubic(InputIterator first, InputIterator last, const Basis& basis,
                                                  Closure closure = Closure::open) {
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  const bool closed = closure == Closure::closed;
  const std::vector<Point> p(first, last);
  const int n = static_cast<int>(p.size()), segments = closed ? n : n - 3;
  if (n < (closed ? 3 : 4))
    throw Error(Error_code::wrong_number_of_points, "piecewise_cubic: " + std::to_string(n) + " points");
  const Basis_matrix<FT> to_bezier = basis_conversion<FT>(basis, Bezier_basis());
  std::vector<Bezier_curve<Traits, 3>> pieces;
  for (int i = 0; i < segments; ++i) {
    const std::array<Point, 4> geometry{p[i], p[(i + 1) % n], p[(i + 2) % n], p[(i + 3) % n]};
    pieces.push_back(Cubic_blended_curve<Traits, Basis>(geometry, basis).bezier(to_bezier, FT(i), FT(i + 1)));
  }
  return Composite_bezier_curve<Traits, 3>(pieces.begin(), pieces.end());
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the curve through the given points with the given first derivatives, at the knots 0, 1, 2, ...; a closed one returns to the
/// first point. It is \f$ C^1 \f$, and \f$ G^1 \f$ where the derivative is not zero. A zero derivative is no error:
/// `chain_continuity()` tells what it makes of the join.
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam PointIterator, VectorIterator their value types are `Traits::Point` and `Traits::Vector`
/// \throws Error `wrong_number_of_points` for fewer than 2 points, and unless there are as many derivatives as points
/// \throws Error `dimension_mismatch` when points and derivatives differ in dimension
/// \throws Error `not_finite` for an infinite or undefined floating-point number, and when a result overflows
///
/// \f$ O(n) \f$
template <class Traits, class PointIterator, class VectorIterator>
Composite_bezier_curve<Traits, 3> piecewise_hermite(PointIterator first_point, PointIterator last_point,
                                                    VectorIterator first_derivative, VectorIterator last_derivative,
                                                    Closure closure = Closure::open) {
  typedef typename Traits::FT FT;
  const std::vector<typename Traits::Point> p(first_point, last_point);
  const std::vector<typename Traits::Vector> r(first_derivative, last_derivative);
  const int n = static_cast<int>(p.size());
  if (n < 2 || p.size() != r.size())
    throw Error(Error_code::wrong_number_of_points,
                "piecewise_hermite: " + std::to_string(n) + " points, " + std::to_string(r.size()) + " derivatives");
  const Basis_matrix<FT> to_bezier = basis_conversion<FT>(Hermite_basis(), Bezier_basis());
  std::vector<Bezier_curve<Traits, 3>> pieces;
  for (int i = 0; i < (closure == Closure::closed ? n : n - 1); ++i) {
    const int j = (i + 1) % n;
    pieces.push_back(
        Cubic_blended_curve<Traits, Hermite_basis>({p[i], p[j], r[i], r[j]}).bezier(to_bezier, FT(i), FT(i + 1)));
  }
  return Composite_bezier_curve<Traits, 3>(pieces.begin(), pieces.end());
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_PIECEWISE_CUBICS_H
