// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_BSPLINE_FUNCTION_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_BSPLINE_FUNCTION_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/splines/bspline_evaluate.h>
#include <CGAL/Geometric_continuity/splines/bspline_knots.h>
#include <CGAL/Geometric_continuity/splines/bspline_product.h>
#include <CGAL/Geometric_continuity/splines/internal/check_spline.h>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Bspline_function.h
/// Spline functions as values: knots and coefficients together.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// A spline function \f$ \sum_i c_i N_i^p(u) \f$ over a `Knot_vector`, with numbers or vectors as values: the
/// algorithms of `bspline_evaluate.h`, `bspline_knots.h` and `bspline_product.h` with knots and coefficients kept
/// together.
///
/// It is a value: operations return new functions. With exact numbers they are exact.
///
/// \tparam FT a field number type
/// \tparam Value `FT` or a `Coordinate_vector` of such numbers
template <class FT_, class Value_ = FT_> class Bspline_function {
public:
  typedef FT_ FT;       ///< the number type
  typedef Value_ Value; ///< a coefficient: a number or a vector

private:
  Knot_vector<FT> knots_;
  std::vector<Value> c_;

public:
  /// Constructs a function from the knots and the `n` coefficients.
  /// \throws Error `wrong_number_of_points` unless there are `n` coefficients
  /// \throws Error `dimension_mismatch` when the coefficients differ in dimension
  /// \throws Error `not_finite` for an infinite or undefined floating-point number
  Bspline_function(Knot_vector<FT> knots, std::vector<Value> coefficients)
      : knots_(std::move(knots)), c_(std::move(coefficients)) {
    internal::check_number_of_coefficients(knots_, c_, "Bspline_function");
    internal::check_coefficients<FT>(c_, "Bspline_function: coefficients");
  }

  /// Returns the degree `p`.
  int degree() const { return knots_.degree(); }
  /// Returns the knots.
  const Knot_vector<FT>& knots() const { return knots_; }
  /// Returns all coefficients.
  const std::vector<Value>& coefficients() const { return c_; }
  /// Returns \f$ c_i \f$, `0 <= i < n`.
  const Value& operator[](int i) const { return c_[i]; }
  /// Returns the ends of the domain \f$ [u_p, u_n] \f$.
  std::pair<FT, FT> domain() const { return knots_.domain(); }

  /// \name Evaluation
  /// All these functions throw `Error` with `parameter_outside_domain`.
  /// @{

  /// Returns the value at `u`, from the right at a knot. \f$ O(\log n + p^2) \f$
  Value operator()(const FT& u) const { return bspline_value<FT>(knots_, c_, u); }

  /// Returns the derivatives of order 0 to `k >= 0` at `u` from the right; at the end of the domain from the left.
  /// \f$ O(\log n + p^2 + p\,k^2) \f$ \throws Error also `negative_count` when `k` is negative
  std::vector<Value> right_derivatives(const FT& u, int k) const {
    return bspline_derivatives<FT>(knots_, c_, knots_.span(u), u, k);
  }
  /// Returns the derivatives of order 0 to `k >= 0` at `u` from the left; at the start of the domain from the right.
  /// \f$ O(\log n + p^2 + p\,k^2) \f$ \throws Error also `negative_count` when `k` is negative
  std::vector<Value> left_derivatives(const FT& u, int k) const {
    return bspline_derivatives<FT>(knots_, c_, knots_.left_span(u), u, k);
  }

  /// Decides the order of continuity inside the domain, see `bspline_smoothness()`.
  int smoothness(const FT& u) const { return bspline_smoothness<FT>(knots_, c_, u); }

  /// @}
  /// \name Other Functions
  /// @{

  /// Returns the derivative, see `bspline_derivative()`.
  Bspline_function derivative() const { return {derivative_knots(knots_), bspline_derivative<FT>(knots_, c_)}; }

  /// Returns the same function with `times >= 0` more copies of the knot `u`, see `bspline_insert()`.
  /// \throws Error as `bspline_insert()`
  Bspline_function insert(const FT& u, int times = 1) const {
    return {knots_.insert(u, times), bspline_insert<FT>(knots_, c_, u, times)};
  }
  /// Returns the same function over finer knots, see `bspline_refine()`. \throws Error as `bspline_refine()`
  Bspline_function refine(const Knot_vector<FT>& finer) const { return {finer, bspline_refine<FT>(knots_, c_, finer)}; }
  /// Returns the same function without the knots outside the domain.
  Bspline_function clamp() const { return refine(knots_.clamp()); }

  /// Returns the same function with `times >= 0` copies of the inner knot `u` less, or nothing, see `bspline_remove()`.
  /// \throws Error as `bspline_remove()`
  std::optional<Bspline_function> remove(const FT& u, int times = 1) const {
    std::optional<std::vector<Value>> c = bspline_remove<FT>(knots_, c_, u, times);
    if (!c) return std::nullopt;
    return Bspline_function(knots_.remove(u, times), std::move(*c));
  }
  /// Returns the same function without superfluous inner knots, see `minimal_knots()`.
  Bspline_function remove_superfluous_knots() const {
    const Knot_vector<FT> knots = minimal_knots<FT>(knots_, c_);
    return {knots, internal::change_knots<FT>(knots_, c_, knots)};
  }

  /// Returns the same function with the degree raised by `times >= 0`, clamped, see `bspline_elevate()`.
  /// \throws Error `negative_count` when `times` is negative
  Bspline_function elevate(int times = 1) const {
    const internal::Distinct_knots<FT> knots = internal::distinct_elevated_knots(knots_, times);
    return {knots.knot_vector(), internal::elevate_over<FT>(knots, knots_, c_)};
  }

  /// Returns the function with its domain reversed, see `Knot_vector::reverse()`.
  Bspline_function reverse() const { return {knots_.reverse(), std::vector<Value>(c_.rbegin(), c_.rend())}; }

  /// @}

  /// Returns the product, see `bspline_product()`. \throws Error `parameter_outside_domain` when the domains differ
  friend Bspline_function operator*(const Bspline_function<FT>& f, const Bspline_function& g) {
    const internal::Distinct_knots<FT> knots = internal::distinct_product_knots(f.knots(), g.knots());
    return {knots.knot_vector(),
            internal::product_over<FT>(knots, f.knots(), f.coefficients(), g.knots(), g.coefficients())};
  }

  /// Returns the sum, clamped, in the larger of the two degrees and over the knots of both.
  /// \throws Error `parameter_outside_domain` when the domains differ
  friend Bspline_function operator+(const Bspline_function& f, const Bspline_function& g) {
    return combined(f, g, FT(1));
  }
  /// Returns the difference, clamped, in the larger of the two degrees and over the knots of both.
  /// \throws Error `parameter_outside_domain` when the domains differ
  friend Bspline_function operator-(const Bspline_function& f, const Bspline_function& g) {
    return combined(f, g, FT(-1));
  }

  /// Decides whether knots and coefficients are equal.
  friend bool operator==(const Bspline_function& f, const Bspline_function& g) {
    return f.knots_ == g.knots_ && f.c_ == g.c_;
  }
  /// Decides whether a knot or a coefficient is different.
  friend bool operator!=(const Bspline_function& f, const Bspline_function& g) { return !(f == g); }

private:
  static Bspline_function combined(const Bspline_function& f, const Bspline_function& g, const FT& sign) {
    const int d = (std::max)(f.degree(), g.degree());
    const Bspline_function x = f.elevate(d - f.degree()), y = g.elevate(d - g.degree());
    const Knot_vector<FT> knots = merge(x.knots_, y.knots_);
    std::vector<Value> c = bspline_refine<FT>(x.knots_, x.c_, knots);
    const std::vector<Value> b = bspline_refine<FT>(y.knots_, y.c_, knots);
    for (std::size_t i = 0; i < c.size(); ++i) c[i] += sign * b[i];
    return {knots, std::move(c)};
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_BSPLINE_FUNCTION_H
