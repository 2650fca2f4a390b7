// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_BSPLINE_EVALUATE_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_BSPLINE_EVALUATE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/splines/internal/Spline_weights.h>
#include <CGAL/Geometric_continuity/splines/internal/check_spline.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

/// \file bspline_evaluate.h
/// Values, blossoms and derivatives of splines \f$ \sum_i c_i N_i^p(u) \f$ over a `Knot_vector`, by field arithmetic
/// only. The coefficients \f$ c_0, \dots, c_{n-1} \f$ are in a random-access container `c`; they are numbers or
/// `Coordinate_vector`s.
///
/// On the span `k` the spline is a polynomial \f$ f_k \f$. Its \em blossom \f$ f_k[t_1, \dots, t_p] \f$ is the function
/// that is symmetric, affine in each argument, and equal to \f$ f_k(t) \f$ at \f$ [t, \dots, t] \f$. Everything rests
/// on \f$ c_i = f_k[u_{i+1}, \dots, u_{i+p}] \f$.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the values of all `n` basis functions \f$ N_i^p(u) \f$: right-continuous, and continuous from the left at
/// the end of the domain. \f$ O(n + p^2) \f$
/// \throws Error `parameter_outside_domain`
template <class FT> std::vector<FT> bspline_basis(const Knot_vector<FT>& knots, const FT& u) {
  const int p = knots.degree(), k = knots.span(u);
  std::vector<FT> basis(knots.number_of_coefficients(), FT(0));
  internal::derivative_weights(knots, p, k, u, 0, [&](int, const internal::Span_weights<FT>& weights) {
    std::copy_n(weights.w, p + 1, basis.begin() + weights.first);
  });
  return basis;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the derivatives of order 0 to `order >= 0` at `u` of the polynomial on the span `k`: from the right or from
/// the left at a knot, according to `Knot_vector::span()` and `Knot_vector::left_span()`. \f$ O(p^2 + p\,order^2) \f$
/// \throws Error `wrong_number_of_points` unless there are `n` coefficients, `negative_count` when `order` is negative,
///   `parameter_outside_domain` unless `k` is a span
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> bspline_derivatives(const Knot_vector<FT>& knots, const Coefficients& c,
                                                                   int k, const FT& u, int order) {
  internal::check_number_of_coefficients(knots, c, "bspline_derivatives");
  internal::check_span(knots, k, "bspline_derivatives");
  if (order < 0) throw Error(Error_code::negative_count, "bspline_derivatives: order");
  return internal::derivatives_on_span(knots, c, k, u, order);
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the value at `u`, from the right at a knot and from the left at the end of the domain.
/// \f$ O(\log n + p^2) \f$
/// \throws Error `parameter_outside_domain`, `wrong_number_of_points` unless there are `n` coefficients
template <class FT, class Coefficients>
typename Coefficients::value_type bspline_value(const Knot_vector<FT>& knots, const Coefficients& c, const FT& u) {
  internal::check_number_of_coefficients(knots, c, "bspline_value");
  return internal::derivatives_on_span(knots, c, knots.span(u), u, 0)[0];
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the blossom \f$ f_k[t_1, \dots, t_p] \f$ of the polynomial on the span `k`, at `p` arguments in any order.
/// \f$ O(p^2) \f$
/// \throws Error `wrong_number_of_points` unless there are `n` coefficients and `p` arguments,
///   `parameter_outside_domain` unless `k` is a span
template <class FT, class Coefficients>
typename Coefficients::value_type bspline_blossom(const Knot_vector<FT>& knots, const Coefficients& c, int k,
                                                  std::vector<FT> arguments) {
  internal::check_number_of_coefficients(knots, c, "bspline_blossom");
  internal::check_span(knots, k, "bspline_blossom");
  if (static_cast<int>(arguments.size()) != knots.degree())
    throw Error(Error_code::wrong_number_of_points, "bspline_blossom: " + std::to_string(arguments.size()) +
                                                        " arguments in degree " + std::to_string(knots.degree()));
  std::sort(arguments.begin(), arguments.end());
  internal::Blossom_weights<FT> weights;
  weights.assign(knots, knots.degree(), k, arguments);
  return weights(c);
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the knots of the derivative: without the first and the last, in degree `p - 1`. A knot where the splines may
/// jump loses one of its `p + 1` copies as well; jumps are not differentiated. In degree 0 the vector itself.
template <class FT> Knot_vector<FT> derivative_knots(const Knot_vector<FT>& knots) {
  const int p = knots.degree(), n = knots.number_of_coefficients();
  if (p == 0) return knots;
  std::vector<FT> u;
  for (int i = 1; i < n + p; ++i)
    if (i >= n || knots[i] < knots[i + p]) u.push_back(knots[i]);
  return Knot_vector<FT>(p - 1, std::move(u));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the coefficients \f$ p \frac{c_i - c_{i-1}}{u_{i+p} - u_i} \f$ of the derivative over `derivative_knots()`;
/// zeros in degree 0. \f$ O(n) \f$
/// \throws Error `wrong_number_of_points` unless there are `n` coefficients
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> bspline_derivative(const Knot_vector<FT>& knots, const Coefficients& c) {
  typedef typename Coefficients::value_type Value;
  internal::check_number_of_coefficients(knots, c, "bspline_derivative");
  const int p = knots.degree(), n = knots.number_of_coefficients();
  std::vector<Value> d;
  if (p == 0) d.assign(n, Value(FT(0) * c[0]));
  for (int i = 1; i < n && p > 0; ++i)
    if (knots[i] < knots[i + p]) d.push_back(Value(FT(FT(p) / FT(knots[i + p] - knots[i])) * (c[i] - c[i - 1])));
  return d;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_BSPLINE_EVALUATE_H
