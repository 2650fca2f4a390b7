// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_BSPLINE_PRODUCT_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_BSPLINE_PRODUCT_H

#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/splines/internal/bspline_multiply.h>
#include <CGAL/Geometric_continuity/splines/internal/check_spline.h>

#include <vector>

/// \file bspline_product.h
/// Degree elevation and the product of splines: Bernstein products on the spans, and then one blossom value for each
/// coefficient over the knots of the result. No linear system is solved.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the knots of the product of splines of the degrees `p` and `q` over `f` and `g`: clamped, of degree `p + q`,
/// with the multiplicity \f$ \max(m_f + q \text{ if } m_f > 0,\ m_g + p \text{ if } m_g > 0) \f$ for an inner knot of
/// the multiplicities \f$ m_f, m_g \f$, which is the smallest that holds all products. Che et al.
/// \throws Error `parameter_outside_domain` when the domains differ
template <class FT> Knot_vector<FT> product_knots(const Knot_vector<FT>& f, const Knot_vector<FT>& g) {
  return internal::distinct_product_knots(f, g).knot_vector();
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the coefficients over `product_knots()` of the product of a spline `f` of degree `p` with numbers and a
/// spline `g` of degree `q` with numbers or vectors as coefficients. The knots need not be equal nor clamped, and may
/// have any multiplicity.
///
/// With \f$ P_k = f_k g_k \f$ in Bernstein form on each span, the coefficients are
/// \f$ P_k[t_{j+1}, \dots, t_{j+p+q}] \f$. Most of them are Bernstein coefficients as they are; of splines of equal
/// degree with simple knots, one for each knot needs arithmetic.
///
/// \f$ O(p^2 + q^2 + pq) \f$ field operations for each coordinate and span, and \f$ O((p+q)^2) \f$ for each coefficient
/// that straddles a knot. Degrees up to 3 on floating-point numbers are unrolled.
/// \throws Error `parameter_outside_domain` when the domains differ,
///   `wrong_number_of_points` unless the numbers of coefficients fit the knots
template <class FT, class Scalars, class Coefficients>
std::vector<typename Coefficients::value_type> bspline_product(const Knot_vector<FT>& f_knots, const Scalars& f,
                                                               const Knot_vector<FT>& g_knots, const Coefficients& g) {
  internal::check_number_of_coefficients(f_knots, f, "bspline_product: first factor");
  internal::check_number_of_coefficients(g_knots, g, "bspline_product: second factor");
  return internal::product_over(internal::distinct_product_knots(f_knots, g_knots), f_knots, f, g_knots, g);
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the knots of the same splines in a degree raised by `times >= 0`: clamped, every inner knot repeated `times`
/// more.
/// \throws Error `negative_count` when `times` is negative
template <class FT> Knot_vector<FT> elevated_knots(const Knot_vector<FT>& knots, int times = 1) {
  return internal::distinct_elevated_knots(knots, times).knot_vector();
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the coefficients over `elevated_knots()`: those of the product with the constant 1 of degree `times >= 0`.
/// The operations are those of `bspline_product()`.
/// \throws Error `negative_count` when `times` is negative, `wrong_number_of_points` unless there are `n` coefficients
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> bspline_elevate(const Knot_vector<FT>& knots, const Coefficients& c,
                                                               int times = 1) {
  internal::check_number_of_coefficients(knots, c, "bspline_elevate");
  return internal::elevate_over(internal::distinct_elevated_knots(knots, times), knots, c);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_BSPLINE_PRODUCT_H
