// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_RESULT_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_RESULT_H

#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

/// \file join_result.h
/// What is said about a join: orders of continuity, what is equal, and the shape parameters, which are computed on request.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The powers of two by which the parameters of the two curves of a join have been divided.
struct Parameter_scale {
  int left = 0, right = 0;
};

// One coordinate of the four control points from the join inwards, with what makes derivatives of their differences. The
// tangent has a component along this coordinate.
struct Parameter_end {
  double points[4];
  double start, end; // of the domain
  int degree = -1;
  double rests[4] = {0, 0, 0, 0}; // what the points are larger than these doubles
};

// What the shape parameters beta_1, beta_2, ... of a join are computed from, when someone asks for them. Either from the
// forms of a decision on jets, beta_k = b_k / g^(2k-1); or, for joins of curves with double coordinates, from one coordinate:
// of the vectors Y^(k) - sum_{m=2}^k B_{k,m}(beta_1, ...) X^(m) = beta_k X' only that is needed. No memory is allocated before.
template <class FT> class Join_parameters {
  std::vector<FT> forms_; // g, b_1, b_2, ...
  Parameter_scale scale_;
  Parameter_end left_, right_;
  double unit_ = 1; // of the parameters: unit_ * 10^exponent_
  int exponent_ = 0;

public:
  Join_parameters() = default;
  Join_parameters(std::vector<FT> forms, Parameter_scale scale) : forms_(std::move(forms)), scale_(scale) {}
  Join_parameters(const Parameter_end& left, const Parameter_end& right) : left_(left), right_(right) {}

  // Says that the parameters of both curves are those of the ends times unit * 10^exponent.
  void set_unit(double unit, int exponent) {
    unit_ = unit;
    exponent_ = exponent;
  }

  // The first `count` parameters; none if nothing has been given.
  std::vector<FT> operator()(int count) const {
    std::vector<FT> betas;
    if (count <= 0) return betas;
    if (left_.degree >= 0) {
      if constexpr (!std::is_floating_point_v<FT> && std::is_constructible_v<FT, double>) {
        const int order = (std::min)(count, 3);
        const std::vector<FT> x = derivatives(left_, true, order), y = derivatives(right_, false, order);
        betas.push_back(FT(y[1] / x[1]));
        const FT square = FT(betas[0] * betas[0]);
        if (count > 1) betas.push_back(FT(FT(y[2] - square * x[2]) / x[1]));
        if (count > 2)
          betas.push_back(FT(FT(y[3] - FT(3) * betas[0] * betas[1] * x[2] - square * betas[0] * x[3]) / x[1]));
      }
      return betas;
    }
    if (forms_.empty()) return betas; // none in this field
    FT power = forms_[0];
    for (int k = 1; k <= count; ++k) {
      FT beta = FT(forms_[k] / power);
      if constexpr (std::is_floating_point_v<FT>) {
        beta = std::ldexp(beta, scale_.left - k * scale_.right);
        check_finite(beta, "Join_continuity::betas");
      }
      betas.push_back(beta);
      power *= forms_[0] * forms_[0];
    }
    return betas;
  }

private:
  // m!/(m-k)! / h^k times the k-th difference, k = 0, ..., order <= 3; odd ones point outwards at an end.
  std::vector<FT> derivatives(const Parameter_end& end, bool at_end, int order) const {
    std::vector<FT> d;
    d.reserve(order + 1);
    for (int j = 0; j <= order; ++j)
      d.push_back(end.rests[j] == 0 ? FT(end.points[j]) : FT(FT(end.points[j]) + FT(end.rests[j])));
    for (int k = 1; k <= order; ++k)
      for (int j = order; j >= k; --j) d[j] -= d[j - 1];
    FT h = FT(FT(end.end) - FT(end.start));
    if (at_end) h = FT(-h);
    if (unit_ != 1) h *= FT(unit_);
    for (int e = exponent_; e < 0; ++e) h /= FT(10);
    FT factor(1);
    for (int k = 1; k <= order; ++k) {
      factor *= FT(FT(end.degree - k + 1 > 0 ? end.degree - k + 1 : 0) / h);
      d[k] *= factor;
    }
    return d;
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// What was decided about the join of a curve that ends (left) and a curve that starts (right). It is a value that does not
/// refer to the curves.
/// \tparam FT the field in which it was decided
template <class FT> struct Join_continuity {
  typedef FT Number; ///< the numbers of the shape parameters
  /// The largest `k` such that all derivatives up to order `k` agree; -1 when the points differ.
  int c_order = -1;
  /// The largest `k` such that all arc-length derivatives up to order `k` agree; -1 when the points differ, 0 when a
  /// tangent is zero or the tangents do not have one direction.
  int g_order = -1;
  /// The largest `k` such that the Frenet frame and the curvatures \f$ \kappa_1, \dots, \kappa_{k-1} \f$ agree, at most
  /// the dimension; -1 and 0 as above.
  int f_order = -1;
  /// Both tangents are nonzero (false also when the jets have no derivatives).
  bool regular = false;
  std::optional<bool> tangent_equal;          ///< same direction; empty unless regular
  std::optional<bool> curvature_equal;        ///< same magnitude \f$ \kappa \f$; empty where undefined
  std::optional<bool> curvature_vector_equal; ///< same \f$ \kappa e_2 \f$; empty where undefined
  std::optional<bool> torsion_equal;          ///< empty unless in space with nonzero curvature on both sides

  /// Returns the shape parameters \f$ \beta_1, \dots, \beta_{g\_order} \f$: the right curve is, up to this order, the left one
  /// with the reparametrisation of these derivatives. They are computed by this call, exactly where the decision is exact.
  /// \f$ O(k) \f$ divisions for the order `k`
  /// \throws Error `not_finite` when a parameter is too large for floating-point numbers
  std::vector<FT> betas() const { return parameters(g_order); }

  /// Writes the orders and the shape parameters, e.g. `C1 G2 F2, beta = (1, 3/4)`.
  /// \throws Error as `betas()` does
  friend std::ostream& operator<<(std::ostream& os, const Join_continuity& join) {
    if (join.c_order < 0) return os << "gap";
    const std::vector<FT> betas = join.betas();
    os << 'C' << join.c_order << " G" << join.g_order << " F" << join.f_order;
    for (std::size_t i = 0; i < betas.size(); ++i) os << (i == 0 ? ", beta = (" : ", ") << betas[i];
    return os << (betas.empty() ? "" : ")");
  }

  /// \cond
  internal::Join_parameters<FT> parameters;
  /// \endcond
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_JOIN_RESULT_H
