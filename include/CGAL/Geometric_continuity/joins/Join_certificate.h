// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_CERTIFICATE_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_CERTIFICATE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// A certificate that lets anybody check the orders of a join by adding and multiplying: with the
/// derivatives \f$ X^{(j)}, Y^{(j)} \f$ of the left and of the right curve at the join, for each
/// order `j` the equation
///
/// - C: \f$ Y^{(j)} = X^{(j)} + r \f$;
/// - G: \f$ Y^{(j)} = \sum_{m=2}^{j} B_{j,m}(\beta_1, \beta_2, \dots) X^{(m)} + \beta_j X' + r \f$
///   with \f$ r \cdot X' = 0 \f$, where \f$ B_{j,m} \f$ are the Bell polynomials of the chain rule;
/// - F: \f$ Y^{(j)} = \beta_1^j X^{(j)} + \sum_{i=1}^{j-1} a_{j,i} X^{(i)} + r \f$ with
///   \f$ r \cdot X^{(i)} = 0 \f$ for each `i < j`.
///
/// An order holds if for it and all before it `r` is zero, and \f$ \beta_1 > 0 \f$. Where an order
/// does not hold, the residual `r` of the first that fails is not zero, or for the order 1
/// \f$ \beta_1 \le 0 \f$, or a first derivative is zero.
/// \tparam FT an exact field
/// \tparam N the dimension, or 0 when it is known at run time only
template <class FT, int N = 0> struct Join_certificate {
  typedef Coordinate_vector<FT, N> Vector; ///< the derivatives and the residuals

  Coordinate_jet<FT, N> left;  ///< \f$ X, X', \dots \f$ up to the highest order that was asked for
  Coordinate_jet<FT, N> right; ///< \f$ Y, Y', \dots \f$ up to this order
  int c_order;                 ///< as `Join_continuity::c_order`
  int g_order;                 ///< as `Join_continuity::g_order`
  int f_order;                 ///< as `Join_continuity::f_order`
  /// The residual of the order `c_order + 1`; empty when no higher order was asked for.
  std::optional<Vector> c_residual;
  /// \f$ \beta_1, \dots, \beta_g \f$ for `g_order`, and one more if there is `g_residual`.
  std::vector<FT> betas;
  /// The residual of the order `g_order + 1`; empty when no higher order was asked for, and where a
  /// tangent is zero or the points differ.
  std::optional<Vector> g_residual;
  /// \f$ a_{j,1}, \dots, a_{j,j-1} \f$ for `j = 2`, ..., `f_order`, and one row more if there is
  /// `f_residual`. Numbers of derivatives that are combinations of those before them are 0.
  std::vector<std::vector<FT>> f_factors;
  /// The residual of the order `f_order + 1` if that is at least 2 and at most the dimension; empty
  /// as `g_residual`.
  std::optional<Vector> f_residual;
};

namespace internal {

// Vectors that come one at a time, and what writes others as their combinations: Gram and Schmidt's
// orthogonal vectors o_i, each with its factors in terms of the given vectors.
template <class FT, int N> class Orthogonal_span {
  typedef Coordinate_vector<FT, N> Vector;
  std::vector<Vector> orthogonal_;
  std::vector<std::vector<FT>> factors_;

public:
  // v = sum factors_i v_i + residual, where the residual is orthogonal to all vectors v_i; the
  // factor of a vector that depends on those before it is 0.
  struct Combination {
    std::vector<FT> factors;
    Vector residual;
  };
  Combination combination(Vector v) const {
    Combination c{std::vector<FT>(orthogonal_.size(), FT(0)), Vector()};
    for (std::size_t i = 0; i < orthogonal_.size(); ++i) {
      const FT square = dot(orthogonal_[i], orthogonal_[i]);
      if (square == FT(0)) continue;
      const FT factor = FT(dot(v, orthogonal_[i]) / square);
      v -= factor * orthogonal_[i];
      for (std::size_t j = 0; j <= i; ++j) c.factors[j] += FT(factor * factors_[i][j]);
    }
    c.residual = std::move(v);
    return c;
  }

  void add(const Vector& v) {
    Combination c = combination(v);
    for (FT& x : c.factors) x = FT(-x);
    c.factors.push_back(FT(1));
    factors_.push_back(std::move(c.factors));
    orthogonal_.push_back(std::move(c.residual));
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns what certifies the orders that were decided for a join up to order `max_order`, computed
/// anew from the jets: when the verdict is wrong, the certificate shows it. \f$ O(k^3 + k^2 n) \f$
/// operations for the order `k` in dimension `n`
/// \param left, right the jets at the join, of order `max_order` or more
/// \param verdict what `continuity()` has returned for `max_order`
/// \param max_order the highest order that was asked for
/// \throws Error `negative_count` for a negative `max_order`, `jet_order_too_low`,
///   `dimension_mismatch`
template <class FT, int N, class Number>
Join_certificate<FT, N> join_certificate(const Coordinate_jet<FT, N>& left, const Coordinate_jet<FT, N>& right,
                                         const Join_continuity<Number>& verdict, int max_order) {
  static_assert(!std::is_floating_point_v<FT>, "certificates consist of exact numbers");
  typedef typename Join_certificate<FT, N>::Vector Vector;
  if (max_order < 0) throw Error(Error_code::negative_count, "join_certificate: order");
  if ((std::min)(left.order(), right.order()) < max_order)
    throw Error(Error_code::jet_order_too_low, "join_certificate");
  if (left.dimension() != right.dimension()) throw Error(Error_code::dimension_mismatch, "join_certificate");
  const int n = left.dimension();
  Join_certificate<FT, N> c{Coordinate_jet<FT, N>(n, max_order),
                            Coordinate_jet<FT, N>(n, max_order),
                            verdict.c_order,
                            verdict.g_order,
                            verdict.f_order,
                            {},
                            {},
                            {},
                            {},
                            {}};
  for (int j = 0; j <= max_order; ++j) {
    c.left[j] = left[j];
    c.right[j] = right[j];
  }
  const Coordinate_jet<FT, N>&x = c.left, &y = c.right;
  if (c.c_order < max_order) c.c_residual = y[c.c_order + 1] - x[c.c_order + 1];
  if (c.c_order < 0 || max_order == 0 || is_zero(x[1]) || is_zero(y[1])) return c;

  const FT square = dot(x[1], x[1]);
  Bell_polynomials<FT> bell;
  for (int j = 1; j <= (std::min)(c.g_order + 1, max_order); ++j) {
    Vector v = y[j];
    for (int m = 2; m <= j; ++m) v -= bell(j, m) * x[m];
    c.betas.push_back(FT(dot(v, x[1]) / square));
    bell.append(c.betas.back());
    if (j > c.g_order) c.g_residual = v - c.betas.back() * x[1];
  }
  if (c.f_order < 1) return c;
  internal::Orthogonal_span<FT, N> span;
  FT power = c.betas[0];
  for (int j = 2; j <= (std::min)({c.f_order + 1, max_order, n}); ++j) {
    power *= c.betas[0];
    span.add(x[j - 1]);
    typename internal::Orthogonal_span<FT, N>::Combination sum = span.combination(y[j] - power * x[j]);
    c.f_factors.push_back(std::move(sum.factors));
    if (j > c.f_order) c.f_residual = std::move(sum.residual);
  }
  return c;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_CERTIFICATE_H
