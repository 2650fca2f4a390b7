// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_CONTINUITY_H

#include <CGAL/Geometric_continuity/algebra/Bell_polynomials.h>
#include <CGAL/Geometric_continuity/algebra/determinant.h>
#include <CGAL/Geometric_continuity/local/end_jet.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// What was decided about the join of a curve that ends (left) and a curve that starts (right).
/// \tparam FT the field in which it was decided
template <class FT> struct Join_continuity {
  /// The largest `k` such that all derivatives up to order `k` agree; -1 when the points differ.
  int c_order = -1;
  /// The largest `k` such that all arc-length derivatives up to order `k` agree; -1 when the points differ, 0 when a
  /// tangent is zero or the tangents do not have one direction.
  int g_order = -1;
  /// The largest `k` such that the Frenet frame and the curvatures \f$ \kappa_1, \dots, \kappa_{k-1} \f$ agree, at most
  /// the dimension; -1 and 0 as above.
  int f_order = -1;
  /// The shape parameters \f$ \beta_1, \dots, \beta_{g\_order} \f$: the right curve is, up to this order, the left one
  /// with the reparametrisation of these derivatives.
  std::vector<FT> betas;
  /// Both tangents are nonzero (false also when the jets have no derivatives).
  bool regular = false;
  std::optional<bool> tangent_equal;          ///< same direction; empty unless regular
  std::optional<bool> curvature_equal;        ///< same magnitude \f$ \kappa \f$; empty where undefined
  std::optional<bool> curvature_vector_equal; ///< same \f$ \kappa e_2 \f$; empty where undefined
  std::optional<bool> torsion_equal;          ///< empty unless in space with nonzero curvature on both sides

  /// Writes the orders and the shape parameters, e.g. `C1 G2 F2, beta = (1, 3/4)`.
  friend std::ostream& operator<<(std::ostream& os, const Join_continuity& join) {
    if (join.c_order < 0) return os << "gap";
    os << 'C' << join.c_order << " G" << join.g_order << " F" << join.f_order;
    for (std::size_t i = 0; i < join.betas.size(); ++i) os << (i == 0 ? ", beta = (" : ", ") << join.betas[i];
    return os << (join.betas.empty() ? "" : ")");
  }
};

namespace internal {

// The decision on two jets X (left) and Y (right) in one field, without divisions but for the reported betas.
template <class FT, int N> class Join_decision {
  typedef Coordinate_jet<FT, N> Jet;
  typedef Coordinate_vector<FT, N> Vector;

  const Jet& X;
  const Jet& Y;
  const int max_order;
  FT g, a; // g = X'.X', a = X'.Y'; G1 iff g Y' = a X' and a > 0; then beta_1 = a/g
  Join_continuity<FT> join;

public:
  Join_decision(const Jet& left, const Jet& right, int order)
      : X(left), Y(right), max_order(std::min({order, left.order(), right.order()})) {
    if (X.dimension() != Y.dimension()) throw Error(Error_code::dimension_mismatch, "continuity of two jets");
    if (max_order < 0) throw Error(Error_code::jet_order_too_low, "continuity of two jets");
  }

  Join_continuity<FT> operator()() {
    decide_c_order();
    if (jet_order() >= 1) {
      g = dot(X[1], X[1]);
      a = dot(X[1], Y[1]);
      join.regular = g != FT(0) && !is_zero(Y[1]);
    }
    if (join.regular) decide_invariants();
    if (join.c_order < 0) return join;
    join.g_order = join.f_order = 0;
    if (max_order >= 1 && join.tangent_equal.value_or(false)) {
      decide_g_order();
      decide_f_order();
    }
    return join;
  }

private:
  int jet_order() const { return std::min(X.order(), Y.order()); }

  void decide_c_order() {
    while (join.c_order < max_order && X[join.c_order + 1] == Y[join.c_order + 1]) ++join.c_order;
  }

  // V_k = g^(2k-2) Y^(k) - sum_{m=2}^k g^(m-2) B_{k,m}(b_1, b_2, ...) X^(m) must be parallel to X';
  // with b_k = V_k.X' this is g V_k = b_k X', and beta_k = b_k / g^(2k-1). For k = 1, V_1 = Y'.
  void decide_g_order() {
    Bell_polynomials<FT> bell;
    std::vector<FT> powers{FT(1), g}; // of g, up to 2k-1
    FT b = a;
    for (int k = 1;; ++k) {
      join.g_order = k;
      join.betas.push_back(FT(b / powers[2 * k - 1]));
      if (k == max_order) return;
      bell.append(b);
      powers.push_back(FT(powers.back() * g));
      powers.push_back(FT(powers.back() * g));
      Vector v = powers[2 * k] * Y[k + 1];
      for (int m = 2; m <= k + 1; ++m) v -= FT(powers[m - 2] * bell(k + 1, m)) * X[m];
      b = dot(v, X[1]);
      if (g * v != b * X[1]) return;
    }
  }

  // Y^(j) - beta_1^j X^(j) must lie in the span of X', ..., X^(j-1)
  void decide_f_order() {
    std::vector<Vector> span(1, X[1]); // a basis of span(X', ..., X^(j-1))
    FT gj = g, aj = a;
    join.f_order = 1;
    for (int j = 2; j <= std::min(max_order, X.dimension()); ++j) {
      gj *= g;
      aj *= a;
      span.push_back(gj * Y[j] - aj * X[j]);
      if (gram_determinant(span) != FT(0)) return;
      join.f_order = j;
      span.back() = X[j];
      if (gram_determinant(span) == FT(0)) span.pop_back();
    }
  }

  void decide_invariants() {
    join.tangent_equal = FT(0) < a && g * Y[1] == a * X[1];
    if (jet_order() < 2) return;
    // K = (g d2 - (d1.d2) d1) / g^2
    const FT h = dot(Y[1], Y[1]), gg = g * g, hh = h * h;
    const Vector kx = g * X[2] - dot(X[1], X[2]) * X[1], ky = h * Y[2] - dot(Y[1], Y[2]) * Y[1];
    const FT kx2 = dot(kx, kx), ky2 = dot(ky, ky);
    join.curvature_equal = FT(kx2 * hh * hh) == FT(ky2 * gg * gg);
    join.curvature_vector_equal = hh * kx == gg * ky;
    if (X.dimension() != 3 || jet_order() < 3 || kx2 == FT(0) || ky2 == FT(0)) return;
    // tau = det / G_2 with |g d2 - (d1.d2) d1|^2 = g G_2
    join.torsion_equal = FT(determinant_of(X) * g * ky2) == FT(determinant_of(Y) * h * kx2);
  }

  static FT determinant_of(const Jet& jet) {
    return determinant<FT>(3, [&](int row, int column) -> const FT& { return jet[row + 1][column]; });
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of the join of two jets, `left` at the end of one curve and `right` at the start of the next, up
/// to order `max_order` or as far as both jets go. The decision is division-free and exact on the numbers of the jets with
/// every exact kernel and with `Exact_predicates_inexact_constructions_kernel`; it is plain floating point, not certified,
/// with `Simple_cartesian<double>`.
///
/// \f$ C^k \f$: equal derivatives. \f$ G^k \f$: equal arc-length derivatives, i.e. the chain rule (Faà di Bruno) with
/// \f$ \beta_1 > 0 \f$. \f$ F^k \f$: continuous Frenet frame and curvatures, Hagen 2.1 and (2.2), corrected: the curvature
/// \em vector counts.
///
/// \f$ O(n k^2 + k^4) \f$ field operations in dimension `n` for order `k`.
/// \throws Error `dimension_mismatch` when the dimensions differ, `jet_order_too_low` for an empty jet
template <class Traits>
Join_continuity<Predicate_FT<Traits>> continuity(const Curve_jet<Traits>& left, const Curve_jet<Traits>& right,
                                                 int max_order) {
  typedef Predicate_FT<Traits> Field;
  constexpr int N = dimension_v<Traits>;
  const Coordinate_jet<Field, N> x = internal::convert_jet<Field>(left), y = internal::convert_jet<Field>(right);
  return internal::Join_decision<Field, N>(x, y, max_order)();
}

/// \ingroup PkgGeometricContinuityContinuity
/// The same up to the order of the jets.
template <class Traits>
Join_continuity<Predicate_FT<Traits>> continuity(const Curve_jet<Traits>& left, const Curve_jet<Traits>& right) {
  return continuity(left, right, std::min(left.order(), right.order()));
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of the join between the end of `left` and the start of `right`, up to order `max_order`.
///
/// With `Exact_predicates_inexact_constructions_kernel` the control points of Bézier curves are taken over to an exact
/// field before anything is derived from them, so that the answer is exact for the curves as given.
///
/// \tparam Left, Right models of `ParametricCurve` with one traits class
/// \throws Error `dimension_mismatch` when the dimensions differ
template <class Left, class Right>
Join_continuity<Predicate_FT<typename Left::Traits>> continuity(const Left& left, const Right& right,
                                                                int max_order = 3) {
  typedef typename Left::Traits Traits;
  static_assert(std::is_same_v<Traits, typename Right::Traits>, "both curves must have the same traits class");
  typedef Predicate_FT<Traits> Field;
  const int order = std::max(max_order, 3); // curvature and torsion are reported for every max_order
  const Coordinate_jet<Field, dimension_v<Traits>> x = end_jet<Field>(left, order), y = start_jet<Field>(right, order);
  return internal::Join_decision<Field, dimension_v<Traits>>(x, y, max_order)();
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_CONTINUITY_H
