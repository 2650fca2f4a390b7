// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BSPLINE_PRODUCT_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BSPLINE_PRODUCT_H

#include <CGAL/Geometric_continuity/algebra/bernstein.h>
#include <CGAL/Geometric_continuity/algebra/bspline_knots.h>

#include <algorithm>
#include <cstddef>
#include <vector>

/// \file bspline_product.h
/// Degree elevation and the product of splines: Bernstein products on the spans, and then one blossom value for each
/// coefficient over the knots of the result. No linear system is solved.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The product over `knots` of two splines of the degrees p and q from the Bernstein coefficients a and b on its spans:
// B_i^p B_j^q = C(p,i) C(q,j) / C(p+q,i+j) B_{i+j}^{p+q}.
template <class FT, class Value>
std::vector<Value> product_of_pieces(const Knot_vector<FT>& knots, int p, const std::vector<FT>& a, int q,
                                     const std::vector<Value>& b) {
  const std::vector<FT> x = binomial_coefficients<FT>(p), y = binomial_coefficients<FT>(q),
                        xy = binomial_coefficients<FT>(p + q);
  std::vector<FT> w; // row by row
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j <= q; ++j) w.push_back(FT(x[i] * y[j] / xy[i + j]));
  const int spans = static_cast<int>(a.size()) / (p + 1);
  std::vector<Value> c(spans * (p + q + 1), Value(FT(0) * b[0]));
  for (int s = 0; s < spans; ++s)
    for (int i = 0; i <= p; ++i)
      for (int j = 0; j <= q; ++j)
        c[s * (p + q + 1) + i + j] += FT(w[i * (q + 1) + j] * a[s * (p + 1) + i]) * b[s * (q + 1) + j];
  return change_knots<FT>(knots.bezier(p + q), c, knots);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// The knots of the product of splines of the degrees `p` and `q` over `f` and `g`: clamped, of degree `p + q`, with the
/// multiplicity \f$ \max(m_f + q \text{ if } m_f > 0,\ m_g + p \text{ if } m_g > 0) \f$ for an inner knot of the multiplicities
/// \f$ m_f, m_g \f$, which is the smallest that holds all products. Che et al.
/// \throws Error `parameter_outside_domain` when the domains differ
template <class FT> Knot_vector<FT> product_knots(const Knot_vector<FT>& f, const Knot_vector<FT>& g) {
  typedef typename Knot_vector<FT>::Knot Knot;
  const int p = f.degree(), q = g.degree();
  if (!f.has_domain_of(g)) throw Error(Error_code::parameter_outside_domain, "B-spline product: the domains differ");
  const std::vector<Knot> x = f.inner_knots(), y = g.inner_knots();
  std::vector<Knot> merged;
  for (std::size_t i = 0, j = 0; i < x.size() || j < y.size();) {
    const bool of_f = j == y.size() || (i < x.size() && !(y[j].value < x[i].value)),
               of_g = i == x.size() || (j < y.size() && !(x[i].value < y[j].value));
    merged.push_back(
        {of_f ? x[i].value : y[j].value, std::max(of_f ? x[i].multiplicity + q : 0, of_g ? y[j].multiplicity + p : 0)});
    i += of_f;
    j += of_g;
  }
  return Knot_vector<FT>(p + q, f.domain().first, f.domain().second, merged);
}

/// \ingroup PkgGeometricContinuityAlgebra
/// The coefficients over `product_knots()` of the product of a spline `f` of degree `p` with numbers and a spline `g` of degree
/// `q` with numbers or vectors as coefficients. The knots need not be equal nor clamped, and may have any multiplicity.
///
/// With \f$ P_k = f_k g_k \f$ in Bernstein form on each span, the coefficients are
/// \f$ P_k[t_{j+1}, \dots, t_{j+p+q}] \f$. Most of them are Bernstein coefficients as they are; of splines of equal degree with
/// simple knots, one for each knot needs arithmetic.
///
/// \f$ O((p + q)^3) \f$ field operations for each span.
/// \throws Error `parameter_outside_domain` when the domains differ,
///   `wrong_number_of_points` unless the numbers of coefficients fit the knots
template <class FT, class Scalars, class Coefficients>
std::vector<typename Coefficients::value_type> bspline_product(const Knot_vector<FT>& f_knots, const Scalars& f,
                                                               const Knot_vector<FT>& g_knots, const Coefficients& g) {
  internal::check_number_of_coefficients(f_knots, f, "bspline_product: first factor");
  internal::check_number_of_coefficients(g_knots, g, "bspline_product: second factor");
  const int p = f_knots.degree(), q = g_knots.degree();
  const Knot_vector<FT> knots = product_knots(f_knots, g_knots);
  return internal::product_of_pieces<FT>(knots, p, internal::change_knots<FT>(f_knots, f, knots.bezier(p)), q,
                                         internal::change_knots<FT>(g_knots, g, knots.bezier(q)));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// The knots of the same splines in a degree raised by `times >= 0`: clamped, every inner knot repeated `times` more.
template <class FT> Knot_vector<FT> elevated_knots(const Knot_vector<FT>& knots, int times = 1) {
  return product_knots(knots, Knot_vector<FT>(times, knots.domain().first, knots.domain().second));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// The coefficients over `elevated_knots()`: those of the product with the constant 1 of degree `times >= 0`. \f$ O(d^3) \f$
/// field operations for each span, in the new degree `d`.
/// \throws Error `wrong_number_of_points` for `times < 0`, and unless there are `n` coefficients
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> bspline_elevate(const Knot_vector<FT>& knots, const Coefficients& c,
                                                               int times = 1) {
  const Knot_vector<FT> elevated = elevated_knots(knots, times);
  const std::vector<typename Coefficients::value_type> pieces = bspline_bezier<FT>(knots, c);
  const std::vector<FT> ones(pieces.size() / (knots.degree() + 1) * (times + 1), FT(1));
  return internal::product_of_pieces<FT>(elevated, times, ones, knots.degree(), pieces);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_BSPLINE_PRODUCT_H
