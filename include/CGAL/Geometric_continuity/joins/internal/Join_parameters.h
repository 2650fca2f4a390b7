// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_PARAMETERS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_PARAMETERS_H

#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

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
        const std::vector<FT> x = derivatives(left_, true), y = derivatives(right_, false);
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
  // m!/(m-k)! / h^k times the k-th difference, k = 0, ..., 3; odd ones point outwards at an end.
  std::vector<FT> derivatives(const Parameter_end& end, bool at_end) const {
    std::vector<FT> d;
    for (int j = 0; j <= 3; ++j)
      d.push_back(end.rests[j] == 0 ? FT(end.points[j]) : FT(FT(end.points[j]) + FT(end.rests[j])));
    for (int k = 1; k <= 3; ++k)
      for (int j = 3; j >= k; --j) d[j] -= d[j - 1];
    FT h = FT(FT(end.end) - FT(end.start));
    if (at_end) h = FT(-h);
    if (unit_ != 1) h *= FT(unit_);
    for (int e = exponent_; e < 0; ++e) h /= FT(10);
    FT factor(1);
    for (int k = 1; k <= 3; ++k) {
      factor *= FT(FT(end.degree - k + 1 > 0 ? end.degree - k + 1 : 0) / h);
      d[k] *= factor;
    }
    return d;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_PARAMETERS_H
