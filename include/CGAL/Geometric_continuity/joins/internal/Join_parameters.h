// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_PARAMETERS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_PARAMETERS_H

#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Join_parameters.h
/// The shape parameters of a join, which are computed when someone asks for them.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The powers of two by which the parameters of the two curves of a join have been divided.
struct Parameter_scale {
  int left = 0, right = 0;
};

// One coordinate of the four control points from the join inwards, with what makes derivatives of
// their differences. The tangent has a component along this coordinate.
struct Parameter_end {
  double points[4];
  double start, end; // of the domain
  int degree = -1;
  double rests[4] = {0, 0, 0, 0}; // what the points are larger than these doubles
};

// Computes the shape parameters beta_1, beta_2, ... of a join on request. They come from the forms
// of a decision on jets, beta_k = b_k / g^(2k-1). Or, for joins of curves with double coordinates,
// they come from one coordinate, since the vectors Y^(k) - sum_{m=2}^k B_{k,m}(beta_1, ...) X^(m) =
// beta_k X' need no more. No memory is allocated before.
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
    if (count <= 0) return {};
    if (left_.degree >= 0) {
      if constexpr (!std::is_floating_point_v<FT> && std::is_constructible_v<FT, double>) {
        const int order = (std::min)(count, 3);
        const std::array<FT, 4> x = derivatives(left_, true, order), y = derivatives(right_, false, order);
        // beta_1 = y' / x', beta_2 = (y'' - beta_1^2 x'') / x', beta_3 = (y''' - 3 beta_1 beta_2
        // x'' - beta_1^3 x''') / x'
        std::vector<FT> betas(order);
        for (int k = 1; k <= order; ++k) {
          FT& beta = betas[k - 1];
          beta = y[k];
          if (k == 2) beta -= product({x[2], betas[0], betas[0]});
          if (k == 3) {
            beta -= product({x[2], FT(3), betas[0], betas[1]});
            beta -= product({x[3], betas[0], betas[0], betas[0]});
          }
          beta /= x[1];
        }
        return betas;
      }
      // unreachable: of a field in which no shape parameter is computed from control points
      return {};
    }
    if (forms_.empty()) return {}; // none in this field
    std::vector<FT> betas(count);
    FT power = forms_[0];
    for (int k = 1; k <= count; ++k) {
      FT& beta = betas[k - 1];
      beta = forms_[k];
      beta /= power;
      if constexpr (std::is_floating_point_v<FT>) {
        beta = std::ldexp(beta, scale_.left - k * scale_.right);
        check_finite(beta, "Join_continuity::betas");
      }
      power *= forms_[0];
      power *= forms_[0];
    }
    return betas;
  }

private:
  // Multiplies by compound operators only: products of exact numbers are types, which are long to
  // compile.
  static FT product(std::initializer_list<FT> factors) {
    FT x(1);
    for (const FT& factor : factors) x *= factor;
    return x;
  }

  // m!/(m-k)! / h^k times the k-th difference, k = 0, ..., order <= 3; odd ones point outwards at
  // an end.
  std::array<FT, 4> derivatives(const Parameter_end& end, bool at_end, int order) const {
    std::array<FT, 4> d;
    for (int j = 0; j <= order; ++j) {
      d[j] = FT(end.points[j]);
      if (end.rests[j] != 0) d[j] += FT(end.rests[j]);
    }
    for (int k = 1; k <= order; ++k)
      for (int j = order; j >= k; --j) d[j] -= d[j - 1];
    FT h(at_end ? end.start : end.end);
    h -= FT(at_end ? end.end : end.start);
    h *= FT(unit_);
    for (int e = exponent_; e < 0; ++e) h /= FT(10);
    FT factor(1);
    for (int k = 1; k <= order; ++k) {
      factor *= FT(end.degree - k + 1 > 0 ? end.degree - k + 1 : 0);
      factor /= h;
      d[k] *= factor;
    }
    return d;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_PARAMETERS_H
