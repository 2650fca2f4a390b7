// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_RESULT_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_RESULT_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/internal/Other_members.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_parameters.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

/// \file join_result.h
/// The verdict on a join: orders of continuity, what is equal, and the shape parameters, which are
/// computed on request; the certificate by which anybody can check the orders; and how many
/// joins of a chain have which order.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// An order G that a join of rounded numbers misses by no more than rounding. It is a hint,
/// computed in floating-point numbers, and no proof: `order_within()` proves orders within a
/// tolerance.
struct Order_up_to_rounding {
  int g_order = 0; ///< the order, at most 2
  /// by how much the control points at the join are off, in units in the last place of their
  /// largest coordinate
  double units = 0;
};

namespace internal {

// The first three points on both sides of a join, from it inwards, from which it is told how far it
// is from the order G that it misses: for a report, in floating-point numbers, and when someone
// asks. With the differences a and b and the vectors h from the join to the next but one point,
//
//   gap:  |q_0 - p_0|,   G1:  what of the shorter difference is orthogonal to the other,
//   G2:   |K_b - K_a| min(n/(n-1) |b|^2, m/(m-1) |a|^2),   K = (m-1)/m  (w_0 w_2 / w_1^2)  h^orthogonal / |a|^2.
//
// Coordinates and weights are divided by powers of two first, so that no square overflows or
// vanishes.
class Near_miss {
  struct Side {
    int degree;
    double weights[3] = {1, 1, 1};
    double x[3][3];

    // w_0 w_2 / w_1^2
    double weight() const {
      double w[3];
      int e[3];
      for (int j = 0; j < 3; ++j) w[j] = std::frexp(weights[j], &e[j]);
      return std::ldexp(w[0] * w[2] / (w[1] * w[1]), e[0] + e[2] - 2 * e[1]);
    }
  };
  int dimension_ = 0, max_order_ = 0; // no points for the dimension 0
  Side sides_[2] = {};

public:
  // Takes the points of the views of both ends, in dimension 2 or 3.
  template <int N, class Left, class Right> void set(const Left& left, const Right& right, int max_order) {
    static_assert(N == 2 || N == 3);
    dimension_ = N;
    max_order_ = (std::min)(max_order, 2);
    set_side<N>(sides_[0], left);
    set_side<N>(sides_[1], right);
  }

  std::optional<Order_up_to_rounding> order_up_to_rounding(int g_order) const {
    // unreachable: the points are kept only where the order is not reached
    // equivalent [|| g_order >= max_order_ -> nothing, 1]: an early end: no larger order is asked
    //   for
    if (dimension_ == 0 || g_order >= max_order_) return std::nullopt;
    typedef Coordinate_vector<double, 3> Vector; // with a zero in the plane
    constexpr double most = 16;
    double largest = 0, square[2], curvature_of_unit[2] = {0, 0}, off = 0;
    Vector start[2], difference[2], curvature[2];
    for (const Side& side : sides_)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) largest = (std::max)(largest, std::abs(side.x[j][i]));
    if (!(0 < largest && largest <= (std::numeric_limits<double>::max)())) return std::nullopt;
    const int exponent = std::ilogb(largest);
    largest = std::ldexp(largest, -exponent);
    for (int k = 0; k < 2; ++k) {
      Vector x[3];
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) x[j][i] = std::ldexp(sides_[k].x[j][i], -exponent);
      start[k] = x[0];
      difference[k] = x[1] - x[0];
      square[k] = dot(difference[k], difference[k]);
      curvature[k] = x[0] - x[0];
      if (sides_[k].degree < 2 || !(square[k] > 0)) continue;
      curvature_of_unit[k] = (sides_[k].degree - 1.) / sides_[k].degree * sides_[k].weight() / square[k];
      const Vector h = x[2] - x[0];
      curvature[k] = curvature_of_unit[k] * Vector(h - (dot(h, difference[k]) / square[k]) * difference[k]);
    }
    const double unit = largest * std::numeric_limits<double>::epsilon();
    std::optional<Order_up_to_rounding> result;
    const auto take = [&](int order, double distance) {
      if (!(distance / unit <= most)) return false; // also for what is no number
      off = (std::max)(off, distance / unit);
      if (order > g_order) result = Order_up_to_rounding{order, off};
      return order < max_order_;
    };
    const Vector gap = start[1] - start[0];
    if (!take(0, std::sqrt(dot(gap, gap)))) return result;
    const double product = -dot(difference[0], difference[1]);
    if (!(square[0] > 0 && square[1] > 0 && product > 0)) return result;
    const int shorter = square[0] < square[1] ? 0 : 1;
    const Vector rest = difference[shorter] + (product / square[1 - shorter]) * difference[1 - shorter];
    if (!take(1, std::sqrt(dot(rest, rest)))) return result;
    const Vector jump = curvature[1] - curvature[0];
    const double sensitive = (std::max)(curvature_of_unit[0], curvature_of_unit[1]);
    if (sensitive > 0) take(2, std::sqrt(dot(jump, jump)) / sensitive);
    return result;
  }

private:
  template <int N, class View> static void set_side(Side& side, const View& view) {
    side.degree = view.degree();
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < N; ++i)
        side.x[j][i] = static_cast<double>(view.coordinate(j <= side.degree ? j : side.degree, i));
    if constexpr (View::has_weights)
      for (int j = 0; j < 3 && side.degree >= 2; ++j) side.weights[j] = static_cast<double>(view.weight(j));
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// The decision about the join of a curve that ends (left) and a curve that starts (right). It is a
/// value that does not refer to the curves.
/// \tparam FT the field in which it was decided
template <class FT> struct Join_continuity {
  typedef FT Number; ///< the numbers of the shape parameters
  /// The largest `k` such that all derivatives up to order `k` agree; -1 when the points differ.
  int c_order = -1;
  /// The largest `k` such that all arc-length derivatives up to order `k` agree; -1 when the points
  /// differ, 0 when a tangent is zero or the tangents do not have one direction.
  int g_order = -1;
  /// The largest `k` such that the Frenet frame and the curvatures
  /// \f$ \kappa_1, \dots, \kappa_{k-1} \f$ agree, at most the dimension; -1 and 0 as above.
  int f_order = -1;
  /// Both tangents are nonzero (false also when the jets have no derivatives).
  bool regular = false;
  std::optional<bool> tangent_equal; ///< same direction; empty unless regular
  /// same magnitude \f$ \kappa \f$; empty where undefined
  std::optional<bool> curvature_equal;
  std::optional<bool> curvature_vector_equal; ///< same \f$ \kappa e_2 \f$; empty where undefined
  /// empty unless in space with nonzero curvature on both sides
  std::optional<bool> torsion_equal;

  /// Returns the shape parameters \f$ \beta_1, \dots, \beta_{g\_order} \f$: the right curve is, up
  /// to this order, the left one with the reparametrisation of these derivatives. They are computed
  /// by this call, exactly where the decision is exact. \f$ O(k) \f$ divisions for the order `k`
  /// \throws Error `not_finite` when a parameter is too large for floating-point numbers
  std::vector<FT> betas() const { return parameters(g_order); }

  /// Returns the order, greater than `g_order` and at most 2, that the join has but for at most 16
  /// units in the last place; empty when there is none, for the join of two jets, and unless the
  /// numbers of the curves are floating-point numbers, in the plane or in space.
  std::optional<Order_up_to_rounding> up_to_rounding() const { return points.order_up_to_rounding(g_order); }

  // This refuses a join in the place of a number.
  template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>> operator Number() const {
    static_assert(!std::is_same_v<Number, Number>, "a join has several orders: join.g_order, join.c_order and "
                                                   "join.f_order; is_g2_join(a, b) is true or false");
    return Number();
  }

  /// \cond SKIP_IN_MANUAL
#define CGAL_GEOMETRIC_CONTINUITY_NO_COMPARISON(op)                                                                    \
  template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>>                                      \
  friend bool operator op(const Join_continuity&, Number) {                                                            \
    static_assert(!std::is_same_v<Number, Number>, "a join has several orders: continuity(a, b).g_order >= 2, also "   \
                                                   "c_order and f_order; is_g2_join(a, b) is true or false");          \
    return false;                                                                                                      \
  }
  CGAL_GEOMETRIC_CONTINUITY_NO_COMPARISON(>=)
  CGAL_GEOMETRIC_CONTINUITY_NO_COMPARISON(>)
  CGAL_GEOMETRIC_CONTINUITY_NO_COMPARISON(==)
#undef CGAL_GEOMETRIC_CONTINUITY_NO_COMPARISON
  /// \endcond

  /// Writes the orders and the shape parameters, e.g. `C1 G2 F2, beta = (1, 3/4)`, and by how much
  /// a greater order is missed if that is no more than rounding, e.g.
  /// `C0 G0 F0; G2 but for 1.5 units in the last place`.
  /// \throws Error as `betas()` does
  friend std::ostream& operator<<(std::ostream& os, const Join_continuity& join) {
    if (join.c_order < 0)
      os << "gap";
    else {
      const std::vector<FT> betas = join.betas();
      os << 'C' << join.c_order << " G" << join.g_order << " F" << join.f_order;
      for (std::size_t i = 0; i < betas.size(); ++i) os << (i == 0 ? ", beta = (" : ", ") << betas[i];
      os << (betas.empty() ? "" : ")");
    }
    // by some, however few
    if (const std::optional<Order_up_to_rounding> order = join.up_to_rounding())
      os << "; G" << order->g_order << " but for " << (std::max)(1., std::ceil(order->units * 10)) / 10
         << " units in the last place";
    return os;
  }

  /// \cond
  CGAL_GEOMETRIC_CONTINUITY_NO_ORDERS("a join has several orders: join.g_order, join.c_order and join.f_order, without "
                                      "parentheses; is_g2_join(a, b) is true or false")
  internal::Join_parameters<FT> parameters;
  internal::Near_miss points;
  /// \endcond
};

/// \ingroup PkgGeometricContinuityContinuity
/// A certificate of the orders of a join, which anybody can check by adding and multiplying: with
/// the derivatives \f$ X^{(j)}, Y^{(j)} \f$ of the left and of the right curve at the join, for
/// each order `j` the equation
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

/// \ingroup PkgGeometricContinuityContinuity
/// The three kinds of continuity, each of which has an order.
enum class Continuity_kind {
  C, ///< equal derivatives
  G, ///< equal derivatives with respect to arc length
  F  ///< equal Frenet frames and curvatures
};

/// \ingroup PkgGeometricContinuityContinuity
/// Returns the order of one kind that was decided for a join.
template <class FT> int order_of(const Join_continuity<FT>& join, Continuity_kind kind) {
  return kind == Continuity_kind::C ? join.c_order : kind == Continuity_kind::G ? join.g_order : join.f_order;
}

/// \ingroup PkgGeometricContinuityContinuity
/// How many joins of a chain have which order. The size does not depend on the length of the chain.
class Chain_summary {
  std::size_t joins_ = 0;
  std::array<std::vector<std::size_t>, 3> counts_; // of the orders -1, 0, 1, ...

public:
  /// Counts one more join.
  template <class FT> void add(const Join_continuity<FT>& join) {
    ++joins_;
    for (Continuity_kind kind : {Continuity_kind::C, Continuity_kind::G, Continuity_kind::F})
      add(kind, order_of(join, kind), 1);
  }

  /// Counts the joins of another part of the chain.
  Chain_summary& operator+=(const Chain_summary& other) {
    joins_ += other.joins_;
    for (Continuity_kind kind : {Continuity_kind::C, Continuity_kind::G, Continuity_kind::F})
      for (const auto& [order, count] : other.counts(kind)) add(kind, order, count);
    return *this;
  }

  /// Returns the number of joins.
  std::size_t joins() const { return joins_; }

  /// \cond SKIP_IN_MANUAL
  // The orders of all joins are not counted: this refuses to return them.
  template <class Number> operator std::vector<Number>() const {
    static_assert(!std::is_same_v<Number, Number>, "chain_joins(curves) has one Join_continuity for each join, with "
                                                   ".g_order; chain_continuity(curves) counts them; "
                                                   "failing_joins(curves, is_g2_join) has the numbers of those that "
                                                   "fail");
    return {};
  }
  CGAL_GEOMETRIC_CONTINUITY_NO_ORDERS("*chain_continuity(curves).g_order() is the least G order of all joins, also "
                                      "c_order() and f_order(); failing_joins(curves, is_g2_join).empty() is true or "
                                      "false")
  /// \endcond

  /// Returns for each order that occurs the number of joins of exactly this order; -1 stands for a
  /// gap. Joins of the highest order that was asked for may be smoother than that.
  std::map<int, std::size_t> counts(Continuity_kind kind) const {
    std::map<int, std::size_t> counts;
    int order = -1;
    for (const std::size_t count : counts_[static_cast<int>(kind)]) {
      if (count > 0) counts[order] = count;
      ++order;
    }
    return counts;
  }

  /// Returns the least \f$ C \f$ order of all joins: the chain as a whole has this continuity.
  /// Empty for a chain without joins.
  std::optional<int> c_order() const { return least_order(Continuity_kind::C); }
  /// Returns the least \f$ G \f$ order of all joins. Empty for a chain without joins.
  std::optional<int> g_order() const { return least_order(Continuity_kind::G); }
  /// Returns the least \f$ F \f$ order of all joins. Empty for a chain without joins.
  std::optional<int> f_order() const { return least_order(Continuity_kind::F); }

  /// Returns the number of joins whose order of this kind is less than `order`.
  std::size_t failing(Continuity_kind kind, int order) const {
    std::size_t n = 0;
    for (const std::pair<const int, std::size_t>& count : counts(kind)) n += count.first < order ? count.second : 0;
    return n;
  }

  /// Writes the number of joins and the least orders, e.g. `3 joins, C0 G2 F2 or more`.
  friend std::ostream& operator<<(std::ostream& os, const Chain_summary& s) {
    os << s.joins_ << (s.joins_ == 1 ? " join" : " joins");
    if (s.joins_ == 0) return os;
    if (*s.c_order() < 0) return os << ", " << s.failing(Continuity_kind::C, 0) << " with a gap";
    return os << ", C" << *s.c_order() << " G" << *s.g_order() << " F" << *s.f_order() << " or more";
  }

private:
  std::optional<int> least_order(Continuity_kind kind) const {
    if (joins_ == 0) return std::nullopt;
    return counts(kind).begin()->first;
  }

  void add(Continuity_kind kind, int order, std::size_t count) {
    std::vector<std::size_t>& counts = counts_[static_cast<int>(kind)];
    if (counts.size() < static_cast<std::size_t>(order + 2)) counts.resize(order + 2);
    counts[order + 1] += count;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_RESULT_H
