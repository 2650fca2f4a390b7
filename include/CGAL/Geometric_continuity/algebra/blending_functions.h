// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BLENDING_FUNCTIONS_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BLENDING_FUNCTIONS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Basis_matrix.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <vector>

/// \file blending_functions.h
/// The functions with which the points of a curve are weighted, and whether the curve stays
/// in the convex hull of its points: \f$ \sum_i f_i = 1 \f$ and \f$ f_i \ge 0 \f$. Lecture slides, "Blended curves",
/// "Bézier curves III".

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <class FT> std::vector<Bernstein_polynomial<FT>> rows_as_polynomials(const Basis_matrix<FT>& c) {
  std::vector<Bernstein_polynomial<FT>> functions;
  for (int i = 0; i < 4; ++i) functions.push_back({c(i, 0), c(i, 1), c(i, 2), c(i, 3)});
  return functions;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the four blending functions of a cubic basis: polynomials of degree 3 on [0, 1], with which the columns of
/// the geometry are weighted. Lecture slides, "Blended curves".
/// \throws Error `not_finite` for an infinite or undefined floating-point number
template <class FT> std::vector<Bernstein_polynomial<FT>> blending_functions(const Basis_matrix<FT>& basis) {
  return internal::rows_as_polynomials(change_of_basis(basis, bezier_matrix<FT>()));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the Bernstein polynomials \f$ B_0^n, \dots, B_n^n \f$, the blending functions of the Bézier curves of degree
/// `n >= 0`.
/// \throws Error `negative_count` when `n` is negative
template <class FT> std::vector<Bernstein_polynomial<FT>> bernstein_polynomials(int n) {
  if (n < 0) throw Error(Error_code::negative_count, "bernstein_polynomials: degree");
  std::vector<Bernstein_polynomial<FT>> functions;
  for (int i = 0; i <= n; ++i) {
    std::vector<FT> c(n + 1, FT(0));
    c[i] = FT(1);
    functions.push_back(Bernstein_polynomial<FT>(c));
  }
  return functions;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Decides whether the functions sum to 1 everywhere, so that the curve moves with its points. Exact for the
/// coefficients as given: floating-point numbers are taken as the rational numbers they are. Lecture slides, "Bézier
/// curves III".
/// \throws Error `not_finite` when a coefficient is infinite or not a number
template <class FT> bool is_partition_of_unity(const std::vector<Bernstein_polynomial<FT>>& functions) {
  typedef typename Exact_field<FT>::type Field;
  Bernstein_polynomial<Field> sum{Field(0)};
  for (const Bernstein_polynomial<FT>& f : functions) {
    std::vector<Field> c;
    for (const FT& x : f.coefficients()) c.push_back(internal::to_field<Field>(x));
    sum = sum + Bernstein_polynomial<Field>(c);
  }
  for (const Field& x : sum.coefficients())
    if (x != Field(1)) return false;
  return true;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Decides whether `p` is nowhere negative on [0, 1]. Exact, see `sign_pattern()`.
/// \throws Error `not_finite` when a coefficient is infinite or not a number
template <class FT> bool is_nonnegative(const Bernstein_polynomial<FT>& p) {
  const Sign_pattern signs = sign_pattern(p);
  return signs == Sign_pattern::positive || signs == Sign_pattern::nonnegative || signs == Sign_pattern::zero;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Decides whether every curve that has these blending functions stays in the convex hull of its points for `t` in [0,
/// 1]: the functions sum to 1 and are nonnegative there. This is so for Bézier curves and B-splines, but not for
/// Catmull-Rom splines. Lecture slides, "Bézier curves III", corrected.
/// \throws Error `not_finite` when a coefficient is infinite or not a number
template <class FT> bool has_convex_hull_property(const std::vector<Bernstein_polynomial<FT>>& functions) {
  for (const Bernstein_polynomial<FT>& f : functions)
    if (!is_nonnegative(f)) return false;
  return is_partition_of_unity(functions);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BLENDING_FUNCTIONS_H
