// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_BSPLINE_FUNCTION_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_BSPLINE_FUNCTION_H

#include <CGAL/Geometric_continuity/splines/bspline_product.h>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// Without a branch for each number.
template <class FT, class Value> void check_coefficients(const std::vector<Value>& c, const char* place) {
  const int d = number_of_coordinates(c[0]);
  bool same = true, finite = true;
  for (const Value& x : c) same &= number_of_coordinates(x) == d;
  if (!same) throw Error(Error_code::dimension_mismatch, place);
  if constexpr (std::is_floating_point_v<FT>)
    for (const Value& x : c) {
      if constexpr (std::is_same_v<FT, Value>)
        finite &= is_finite(x);
      else
        for (const FT& xi : x) finite &= is_finite(xi);
    }
  if (!finite) throw Error(Error_code::not_finite, place);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// A spline function \f$ \sum_i c_i N_i^p(u) \f$ over a `Knot_vector`, with numbers or vectors as values: the algorithms of
/// `bspline_evaluate.h`, `bspline_knots.h` and `bspline_product.h` with knots and coefficients kept together.
///
/// It is a value: operations return new functions. With exact numbers they are exact.
///
/// \tparam FT a field number type
/// \tparam Value `FT` or a `Coordinate_vector` of such numbers
template <class FT_, class Value_ = FT_> class Bspline_function {
public:
  typedef FT_ FT;
  typedef Value_ Value;

private:
  Knot_vector<FT> knots_;
  std::vector<Value> c_;

public:
  /// From the knots and the `n` coefficients.
  /// \throws Error `wrong_number_of_points` unless there are `n` coefficients
  /// \throws Error `dimension_mismatch` when the coefficients differ in dimension
  /// \throws Error `not_finite` for an infinite or undefined floating-point number
  Bspline_function(Knot_vector<FT> knots, std::vector<Value> coefficients)
      : knots_(std::move(knots)), c_(std::move(coefficients)) {
    internal::check_number_of_coefficients(knots_, c_, "Bspline_function");
    internal::check_coefficients<FT>(c_, "Bspline_function: coefficients");
  }

  int degree() const { return knots_.degree(); }
  const Knot_vector<FT>& knots() const { return knots_; }
  const std::vector<Value>& coefficients() const { return c_; }
  const Value& operator[](int i) const { return c_[i]; }
  /// The domain \f$ [u_p, u_n] \f$.
  std::pair<FT, FT> domain() const { return knots_.domain(); }

  /// \name Evaluation
  /// All these functions throw `Error` with `parameter_outside_domain`.
  /// @{

  /// The value at `u`, from the right at a knot.
  Value operator()(const FT& u) const { return bspline_value<FT>(knots_, c_, u); }

  /// The derivatives of order 0 to `k` at `u` from one side; at an end of the domain from the only side that there is.
  std::vector<Value> right_derivatives(const FT& u, int k) const {
    return bspline_derivatives<FT>(knots_, c_, knots_.span(u), u, k);
  }
  std::vector<Value> left_derivatives(const FT& u, int k) const {
    return bspline_derivatives<FT>(knots_, c_, knots_.left_span(u), u, k);
  }

  /// The order of continuity inside the domain, see `bspline_smoothness()`.
  int smoothness(const FT& u) const { return bspline_smoothness<FT>(knots_, c_, u); }

  /// @}
  /// \name Other Functions
  /// @{

  /// The derivative, see `bspline_derivative()`.
  Bspline_function derivative() const { return {derivative_knots(knots_), bspline_derivative<FT>(knots_, c_)}; }

  /// The same function with `times` more copies of the knot `u`, see `bspline_insert()`.
  Bspline_function insert(const FT& u, int times = 1) const {
    return {knots_.insert(u, times), bspline_insert<FT>(knots_, c_, u, times)};
  }
  /// The same function over finer knots, see `bspline_refine()`.
  Bspline_function refine(const Knot_vector<FT>& finer) const { return {finer, bspline_refine<FT>(knots_, c_, finer)}; }
  /// The same function without the knots outside the domain.
  Bspline_function clamp() const { return refine(knots_.clamp()); }

  /// The same function with `times` copies of the inner knot `u` less, or nothing, see `bspline_remove()`.
  std::optional<Bspline_function> remove(const FT& u, int times = 1) const {
    std::optional<std::vector<Value>> c = bspline_remove<FT>(knots_, c_, u, times);
    if (!c) return std::nullopt;
    return Bspline_function(knots_.remove(u, times), std::move(*c));
  }
  /// The same function without superfluous inner knots, see `minimal_knots()`.
  Bspline_function remove_superfluous_knots() const {
    const Knot_vector<FT> knots = minimal_knots<FT>(knots_, c_);
    return {knots, internal::change_knots<FT>(knots_, c_, knots)};
  }

  /// The same function with the degree raised by `times >= 0`, clamped, see `bspline_elevate()`.
  Bspline_function elevate(int times = 1) const {
    const internal::Distinct_knots<FT> knots = internal::distinct_elevated_knots(knots_, times);
    return {knots.knot_vector(), internal::elevate_over<FT>(knots, knots_, c_)};
  }

  /// The function run through backwards, see `Knot_vector::reverse()`.
  Bspline_function reverse() const { return {knots_.reverse(), std::vector<Value>(c_.rbegin(), c_.rend())}; }

  /// @}

  /// The product, see `bspline_product()`.
  friend Bspline_function operator*(const Bspline_function<FT>& f, const Bspline_function& g) {
    const internal::Distinct_knots<FT> knots = internal::distinct_product_knots(f.knots(), g.knots());
    return {knots.knot_vector(),
            internal::product_over<FT>(knots, f.knots(), f.coefficients(), g.knots(), g.coefficients())};
  }

  /// Sum and difference, clamped, in the larger of the two degrees and over the knots of both.
  /// \throws Error `parameter_outside_domain` when the domains differ
  friend Bspline_function operator+(const Bspline_function& f, const Bspline_function& g) {
    return combined(f, g, FT(1));
  }
  friend Bspline_function operator-(const Bspline_function& f, const Bspline_function& g) {
    return combined(f, g, FT(-1));
  }

  /// Equality of knots and coefficients.
  friend bool operator==(const Bspline_function& f, const Bspline_function& g) {
    return f.knots_ == g.knots_ && f.c_ == g.c_;
  }
  friend bool operator!=(const Bspline_function& f, const Bspline_function& g) { return !(f == g); }

private:
  static Bspline_function combined(const Bspline_function& f, const Bspline_function& g, const FT& sign) {
    const int d = std::max(f.degree(), g.degree());
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
