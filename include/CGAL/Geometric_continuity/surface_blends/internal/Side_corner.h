// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_INTERNAL_SIDE_CORNER_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_INTERNAL_SIDE_CORNER_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/internal/solve_positive_definite.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/surface_blends/internal/Blend_end.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Side_corner.h
/// A side curve and the derivative across it determine the blend surface at a corner, and functions
/// along an edge have given values and slopes at both ends of it.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The value that a function is to have where an edge ends, and the slope if it is given.
template <class FT> struct Edge_end_value {
  FT value;
  std::optional<FT> slope;
};

// The polynomial of the least degree with these values; where a positive one is asked for (of
// positive values) and it is not, a spline.
template <class FT>
Edge_function<FT> interpolating_function(const Edge_end_value<FT>& start, const Edge_end_value<FT>& end,
                                         bool positive) {
  const FT rise = end.value - start.value;
  const auto is_on_line = [&](const Edge_end_value<FT>& x) { return !x.slope || *x.slope == rise; };
  if (is_on_line(start) && is_on_line(end))
    return rise == FT(0) ? Edge_function<FT>{start.value} : Edge_function<FT>{start.value, end.value};
  const FT zero(0), m0 = start.slope ? *start.slope : zero, m1 = end.slope ? *end.slope : zero;
  if (!start.slope || !end.slope) {
    const FT middle = start.slope ? FT(start.value + m0 / FT(2)) : FT(end.value - m1 / FT(2));
    const Edge_function<FT> f{start.value, middle, end.value};
    if (!positive || f.is_positive()) return f;
  } else {
    const Edge_function<FT> f{start.value, FT(start.value + m0 / FT(3)), FT(end.value - m1 / FT(3)), end.value};
    if (!positive || f.is_positive()) return f;
  }
  // cubic, with coefficients that are positive near the ends where the first and the last span are
  // short
  FT h = FT(1) / FT(4);
  while (!(zero < FT(start.value + h * m0 / FT(3)) && zero < FT(end.value - h * m1 / FT(3)))) {
    h = FT(h / FT(2));
    if (h == zero) throw Error(Error_code::not_finite, "blend sides: the slope of beta at a corner");
  }
  const FT next = FT(start.value + h * m0 / FT(3)), last = FT(end.value - h * m1 / FT(3));
  return Bspline_function<FT>(Knot_vector<FT>(3, zero, FT(1), {{h, 1}, {FT(FT(1) - h), 1}}),
                              {start.value, next, next, last, last, end.value});
}

// A number and its derivative along the edge.
template <class FT> struct Number_and_slope {
  FT value, slope;

  friend Number_and_slope operator*(const Number_and_slope& x, const Number_and_slope& y) {
    return {FT(x.value * y.value), FT(x.value * y.slope + x.slope * y.value)};
  }
  friend Number_and_slope operator*(int x, const Number_and_slope& y) {
    return {FT(FT(x) * y.value), FT(FT(x) * y.slope)};
  }
  friend Number_and_slope operator+(const Number_and_slope& x, const Number_and_slope& y) {
    return {FT(x.value + y.value), FT(x.slope + y.slope)};
  }
  friend Number_and_slope operator-(const Number_and_slope& x, const Number_and_slope& y) {
    return {FT(x.value - y.value), FT(x.slope - y.slope)};
  }
};

// The corner of a blend at the end of an edge. The vectors C', T and for homogeneous points C are
// those with respect to which all that is free has coordinates. `order` is that of the blend.
template <bool is_rational, class FT, int N, int order> class Side_corner {
  typedef Coordinate_vector<FT, N> Vector;
  typedef Number_and_slope<FT> Number;
  static constexpr std::size_t k = is_rational ? 3 : 2;
  typedef std::array<Number, k> Free;

  std::string name_;
  std::vector<Vector> c_, t_, w_, x_; // with their derivatives along the edge
  std::array<Free, order> free_{};

public:
  bool has_slopes = false;

  Side_corner(const Blend_end<FT, N>& end, bool upper, std::string name) : name_(std::move(name)) {
    const auto derivatives = [&](const typename Blend_end<FT, N>::Row& row, int n) {
      const Edge_spline<FT, N> f = end.spline(row);
      return upper ? f.left_derivatives(f.domain().second, n) : f.right_derivatives(f.domain().first, n);
    };
    c_ = derivatives(end.edge, order + 1);
    t_ = derivatives(end.cross, order);
    w_ = derivatives(end.second_cross, order - 1);
    if constexpr (order == 3) x_ = derivatives(end.third_cross, 1);
  }

  // Returns the free factor of C', T or C in the derivative of the order n across the edge; 0 where
  // the order is higher than that of the blend, or where the blend is not rational.
  Number free(int n, std::size_t i) const { return i < k ? free_[n - 1][i] : Number{FT(0), FT(0)}; }

  const Vector& point() const { return c_[0]; }
  void scale(const FT& factor) {
    for (std::vector<Vector>* v : {&c_, &t_, &w_, &x_})
      for (Vector& x : *v) x *= factor;
  }

  [[noreturn]] void refuse(Error_code code, const std::string& condition) const {
    throw Error(code, "blend sides: " + name_ + ": " + condition);
  }

  void check_point(const Vector& x) const {
    if (!agree(x, c_[0])) refuse(Error_code::curves_do_not_meet, "the side curve does not end at the corner");
  }

  // The number f > 0 with C' = f x.
  FT ratio(const Vector& x) const {
    const FT product = dot(c_[1], x), square = dot(x, x);
    if (!(FT(0) < product) || !agree(c_[1], FT(product / square) * x))
      refuse(Error_code::incompatible_corner, "S_u: what is given along the side does not lead along the edge");
    return FT(product / square);
  }

  // Takes the derivatives of the side curve.
  void take_curve(const std::array<Vector, order + 1>& g) {
    static constexpr const char* conditions[] = {
        "S_v: the side curve does not run in the tangent plane of the surface",
        "S_vv: the side curve does not have the curvature of the surface",
        "S_vvv: the side curve does not have the third derivative of the surface"};
    check_point(g[0]);
    for (int n = 1; n <= order; ++n) {
      Vector x = g[n];
      for (const Term& term : terms(n)) x -= term.factor.value * *term.row;
      const std::array<FT, k> values = coordinates(x, conditions[n - 1]);
      for (std::size_t i = 0; i < k; ++i) free_[n - 1][i].value = values[i];
      if (n == 1 && !(FT(0) < values[1]))
        refuse(Error_code::nonpositive_beta, "S_v: the side curve does not cross the edge");
    }
  }

  // Takes the derivatives of S_u along the side.
  void take_cross(const std::array<Vector, order + 1>& d) {
    static constexpr const char* conditions[] = {
        "S_uv: what is given along the side contradicts the derivative across the edge",
        "S_uvv: what is given along the side contradicts the curvature along the edge",
        "S_uvvv: what is given along the side contradicts the third derivative along the edge"};
    const std::array<const Vector*, 3> slopes_of_basis = {&c_[2], &t_[1], &c_[1]};
    for (int n = 1; n <= order; ++n) {
      Vector x = d[n];
      for (const Term& term : terms(n)) {
        x -= term.factor.slope * term.row[0];
        x -= term.factor.value * term.row[1];
      }
      for (std::size_t i = 0; i < k; ++i) x -= free_[n - 1][i].value * *slopes_of_basis[i];
      const std::array<FT, k> slopes = coordinates(x, conditions[n - 1]);
      for (std::size_t i = 0; i < k; ++i) free_[n - 1][i].slope = slopes[i];
    }
    has_slopes = true;
  }

  // Returns whether two vectors are equal; floating-point numbers up to rounding.
  bool agree(const Vector& x, const Vector& y) const { return is_small(x - y, {&x, &y}); }

private:
  struct Term {
    Number factor;
    const Vector* row; // followed by its derivative along the edge
  };

  // Returns the derivative of the order n across the edge without its parts along C', T and C. With
  // c = lambda_1,
  // and alpha_2 + 2 c alpha and delta + 2 c beta for the coordinates p, q of the second one, it is
  // alpha^2 C'' + 2 alpha beta T' + beta^2 W, and of the third one alpha^3 C''' + 3 alpha^2 beta
  // T'' + 3 alpha beta^2 W' + beta^3 X and
  // 3 (alpha (p - c alpha) C'' + (alpha q + beta p - 2 c alpha beta) T' + beta (q - c beta) W).
  std::vector<Term> terms(int n) const {
    if (n == 1) return {};
    const Number alpha = free(1, 0), beta = free(1, 1), c = free(1, 2);
    if (n == 2) return {{alpha * alpha, &c_[2]}, {2 * alpha * beta, &t_[1]}, {beta * beta, &w_[0]}};
    const Number p = free(2, 0), q = free(2, 1);
    return {{alpha * alpha * alpha, &c_[3]},       {3 * alpha * alpha * beta, &t_[2]},
            {3 * alpha * beta * beta, &w_[1]},     {beta * beta * beta, &x_[0]},
            {3 * alpha * (p - c * alpha), &c_[2]}, {3 * (alpha * q + beta * p - 2 * c * alpha * beta), &t_[1]},
            {3 * beta * (q - c * beta), &w_[0]}};
  }

  static bool is_small(const Vector& x, const std::vector<const Vector*>& sizes) {
    if constexpr (!std::is_floating_point_v<FT>)
      return is_zero(x);
    else {
      FT largest(0);
      for (const Vector* v : sizes)
        for (const FT& y : *v) largest = (std::max)(largest, CGAL::abs(y));
      return std::all_of(x.begin(), x.end(), [&](const FT& y) { return CGAL::abs(y) <= largest * FT(0x1p-30); });
    }
  }

  std::array<FT, k> coordinates(const Vector& x, const char* condition) const {
    std::array<const Vector*, 3> basis = {&c_[1], &t_[0], &c_[0]};
    std::array<std::array<FT, k>, k> a;
    std::array<FT, k> b;
    for (std::size_t i = 0; i < k; ++i) {
      b[i] = dot(*basis[i], x);
      for (std::size_t j = 0; j < k; ++j) a[i][j] = dot(*basis[i], *basis[j]);
    }
    FT determinant = a[0][0] * a[1][1] - a[0][1] * a[0][1];
    if constexpr (is_rational)
      determinant = a[2][2] * determinant - a[0][0] * a[1][2] * a[1][2] - a[1][1] * a[0][2] * a[0][2] +
                    FT(2) * a[0][1] * a[0][2] * a[1][2];
    if (!(FT(0) < determinant)) refuse(Error_code::singular_frame, "the normal of the surface vanishes");
    const std::array<FT, k> r = solve_positive_definite(a, b);
    Vector rest = x;
    for (std::size_t i = 0; i < k; ++i) rest -= r[i] * *basis[i];
    if (!is_small(rest, {&x, basis[0], basis[1], basis[2]})) refuse(Error_code::incompatible_corner, condition);
    return r;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_INTERNAL_SIDE_CORNER_H
