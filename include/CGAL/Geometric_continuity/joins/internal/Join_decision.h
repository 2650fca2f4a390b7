// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_DECISION_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_DECISION_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/local/internal/Scaled_vector.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The span of vectors that come one at a time, by elimination without fractions (Bareiss): all
// numbers are minors of the vectors, those of floating-point type up to powers of two. O(n k)
// operations for each of k vectors of dimension n.
template <class FT, int N> class Vector_span {
  typedef Coordinate_vector<FT, N> Vector;
  std::vector<Vector> rows_;
  std::vector<int> pivots_;

public:
  // Returns whether the vector lies in the span.
  bool contains(const Vector& v) const { return is_zero(reduced(v)); }

  // Enlarges the span by a vector, unless it contains it.
  void add(const Vector& v) {
    const Vector row = reduced(v);
    int pivot = -1; // of rounded numbers the largest
    for (int i = 0; i < row.dimension(); ++i) {
      if (row[i] == FT(0)) continue;
      if (pivot < 0) pivot = i;
      if constexpr (std::is_floating_point_v<FT>) {
        if (std::abs(row[pivot]) < std::abs(row[i])) pivot = i;
      } else
        break;
    }
    if (pivot < 0) return;
    rows_.push_back(row);
    pivots_.push_back(pivot);
  }

private:
  Vector reduced(Vector v) const {
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const FT factor = v[pivots_[r]];
      v = rows_[r][pivots_[r]] * v - factor * rows_[r];
      v[pivots_[r]] = FT(0); // also if rounded
      if (r > 0) v /= rows_[r - 1][pivots_[r - 1]];
      if (is_zero(v)) break;
      if constexpr (std::is_floating_point_v<FT>)
        v *= std::ldexp(FT(1), (std::min)(-exponent_of(v, "continuity: elimination"), 1000));
    }
    return v;
  }
};

// The decision on two jets X (left) and Y (right) in one field, for every order and dimension,
// without divisions but exact ones. The same decision for orders up to 3 in the plane and in space,
// on the differences of control points, is Join_equations; test_decide_join compares the two.
//
// Jets of floating-point numbers are scaled first, by powers of two, so that the first derivatives
// have a length of about 1 and the others are not longer: nothing overflows, and the answers do not
// depend on the units.
template <class FT, int N> class Join_decision {
  typedef Coordinate_jet<FT, N> Jet;
  typedef Coordinate_vector<FT, N> Vector;
  static constexpr bool rounded = std::is_floating_point_v<FT>;

  std::conditional_t<rounded, Jet, const Jet&> X, Y;
  const int max_order;
  const Work_guard work{"continuity"};
  Parameter_scale scale;
  FT g, a; // g = X'.X', a = X'.Y'; G1 iff g Y' = a X' and a > 0; then beta_1 = a/g
  Join_continuity<FT> join;

public:
  Join_decision(const Jet& left, const Jet& right, int order)
      : X(left), Y(right), max_order((std::min)({order, left.order(), right.order()})) {
    if (order < 0) throw Error(Error_code::negative_count, "continuity: order");
    if (X.dimension() != Y.dimension()) throw Error(Error_code::dimension_mismatch, "continuity of two jets");
    if (max_order < 0) throw Error(Error_code::jet_order_too_low, "continuity of two jets");
    if constexpr (rounded)
      for (const Jet* jet : {&X, &Y})
        for (int j = 0; j <= jet->order(); ++j)
          for (const FT& x : (*jet)[j]) check_finite(x, "continuity: derivatives");
  }

  Join_continuity<FT> operator()() {
    decide_c_order();
    join.regular = jet_order() >= 1 && !is_zero(X[1]) && !is_zero(Y[1]);
    if constexpr (!rounded)
      if (join.regular && jets_agree()) return one_curve();
    if (join.regular) {
      if constexpr (rounded) scale_jets();
      g = dot(X[1], X[1]);
      a = dot(X[1], Y[1]);
      decide_invariants();
    }
    if (join.c_order < 0) return std::move(join);
    join.g_order = join.f_order = 0;
    if (max_order >= 1 && join.tangent_equal.value_or(false)) {
      decide_g_order();
      decide_f_order();
    }
    return std::move(join);
  }

private:
  // So many products of numbers as long as these, with sums. Those with 0 cost nothing.
  void charge(double number, const FT& x, const FT& y) {
    if constexpr (!rounded) {
      if (x == FT(0) || y == FT(0)) return;
      const std::size_t words = number_words(x), other_words = number_words(y);
      if (is_whole(x, words) && is_whole(y, other_words))
        work_meter().charge_products(number, words, other_words);
      else
        work_meter().charge_fractions(number, words, other_words);
    }
  }
  // Recognises long numbers only; others are taken for fractions.
  static bool is_whole(const FT& x, std::size_t words) {
    constexpr std::size_t few = 8;
    if constexpr (Common_denominator<FT>::clears)
      return words > few && number_words(Common_denominator<FT>::denominator_of(x)) == 1;
    else
      return true;
  }

  int jet_order() const { return (std::min)(X.order(), Y.order()); }

  void decide_c_order() {
    while (join.c_order < max_order && X[join.c_order + 1] == Y[join.c_order + 1]) ++join.c_order;
  }

  bool jets_agree() const {
    int j = join.c_order + 1;
    while (j <= jet_order() && X[j] == Y[j]) ++j;
    return j > jet_order();
  }

  // The answers for two equal jets, as at most knots of a spline, with beta = (1, 0, ..., 0).
  Join_continuity<FT> one_curve() {
    join.g_order = max_order;
    join.f_order = (std::min)(max_order, X.dimension());
    std::vector<FT> numerators(max_order + 1, FT(0));
    std::fill_n(numerators.begin(), (std::min)(max_order + 1, 2), FT(1));
    join.parameters = Join_parameters<FT>(std::move(numerators), scale);
    join.tangent_equal = true;
    if (jet_order() >= 2) join.curvature_equal = join.curvature_vector_equal = true;
    if (X.dimension() == 3 && jet_order() >= 3)
      for (int i = 0; i < 3; ++i) // has curvature
        if (FT(X[1][i] * X[2][(i + 1) % 3]) != FT(X[1][(i + 1) % 3] * X[2][i])) join.torsion_equal = true;
    return std::move(join);
  }

  // V_k = g^(2k-2) Y^(k) - sum_{m=2}^k g^(m-2) B_{k,m}(b_1, b_2, ...) X^(m) must be parallel to X';
  // with b_k = V_k.X' this is g V_k = b_k X', and beta_k = b_k / g^(2k-1). For k = 1, V_1 = Y'.
  void decide_g_order() {
    Bell_polynomials<FT> bell;
    std::vector<FT> powers{FT(1), g}; // of g, up to 2k-1
    std::vector<FT> numerators{g, a};
    int factors = 0; // that are not 0
    for (int k = 1;; ++k) {
      join.g_order = k;
      if (k == max_order) break;
      factors += numerators.back() != FT(0);
      charge(3, powers.back(), g);
      bell.append(numerators.back());
      powers.push_back(FT(powers.back() * g));
      powers.push_back(FT(powers.back() * g));
      Vector v = powers[2 * k] * Y[k + 1];
      for (int m = 2; m <= k + 1; ++m) {
        const FT& b = bell(k + 1, m);
        charge(factors + X.dimension(), powers[m - 2], b);
        v -= FT(powers[m - 2] * b) * X[m];
      }
      const FT b = dot(v, X[1]);
      charge(4 * X.dimension(), b, g);
      if (g * v != b * X[1]) break;
      numerators.push_back(b);
    }
    join.parameters = Join_parameters<FT>(std::move(numerators), scale);
  }

  // Y^(j) - beta_1^j X^(j) must lie in the span of X', ..., X^(j-1)
  void decide_f_order() {
    Vector_span<FT, N> span;
    FT gj = g, aj = a;
    join.f_order = 1;
    for (int j = 2; j <= (std::min)(max_order, X.dimension()); ++j) {
      gj *= g;
      aj *= a;
      charge(j * (j + X.dimension()), gj, gj);
      span.add(X[j - 1]);
      if (!span.contains(gj * Y[j] - aj * X[j])) return;
      join.f_order = j;
    }
  }

  void decide_invariants() {
    join.tangent_equal = FT(0) < a && g * Y[1] == a * X[1];
    if (jet_order() < 2) return;
    // K = (g d2 - (d1.d2) d1) / g^2
    const FT h = dot(Y[1], Y[1]), gg = g * g, hh = h * h;
    const Vector kx = g * X[2] - dot(X[1], X[2]) * X[1], ky = h * Y[2] - dot(Y[1], Y[2]) * Y[1];
    const FT kx2 = dot(kx, kx), ky2 = dot(ky, ky);
    charge(4. * X.dimension(), kx2, hh);
    charge(4. * X.dimension(), ky2, gg);
    join.curvature_equal = FT(kx2 * hh * hh) == FT(ky2 * gg * gg);
    join.curvature_vector_equal = hh * kx == gg * ky;
    if (X.dimension() != 3 || jet_order() < 3 || kx2 == FT(0) || ky2 == FT(0)) return;
    // tau = det / G_2 with |g d2 - (d1.d2) d1|^2 = g G_2
    join.torsion_equal = FT(determinant_of(X) * g * ky2) == FT(determinant_of(Y) * h * kx2);
  }

  static FT determinant_of(const Jet& jet) {
    return determinant<FT>(3, [&](int row, int column) -> const FT& { return jet[row + 1][column]; });
  }

  // The coordinates times 2^s and the parameters divided by 2^l and 2^r, with s + l and s + r such
  // that the first derivatives are about 1, and the least s such that no other one is larger.
  void scale_jets() {
    const char* const place = "continuity: derivatives";
    const int first_x = exponent_of(X[1], place), first_y = exponent_of(Y[1], place);
    bool straight = true;
    int s = 0;
    const auto include = [&](const Jet& jet, int first) {
      for (int j = 2; j <= jet.order(); ++j) {
        if (is_zero(jet[j])) continue;
        // divided by j - 1 and rounded up
        const int excess = exponent_of(jet[j], place) - j * first;
        const int least = excess > 0 ? (excess + j - 2) / (j - 1) : -(-excess / (j - 1));
        s = straight ? least : (std::max)(s, least);
        straight = false;
      }
    };
    include(X, first_x);
    include(Y, first_y);
    if (straight) s = -first_x;
    scale = {-first_x - s, -first_y - s};
    multiply(X, s, scale.left);
    multiply(Y, s, scale.right);
  }
  static void multiply(Jet& jet, int s, int l) {
    for (int j = 1; j <= jet.order(); ++j)
      for (int i = 0; i < jet.dimension(); ++i) jet[j][i] = std::ldexp(jet[j][i], s + j * l);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_DECISION_H
