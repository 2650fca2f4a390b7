// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_BSPLINE_FUNCTION_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_BSPLINE_FUNCTION_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/splines/internal/Spline_weights.h>
#include <CGAL/Geometric_continuity/splines/internal/bspline_multiply.h>
#include <CGAL/Geometric_continuity/splines/internal/change_knots.h>
#include <CGAL/Geometric_continuity/splines/internal/check_spline.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Bspline_function.h
/// Splines \f$ \sum_i c_i N_i^p(u) \f$ over a `Knot_vector`, by field arithmetic only: values,
/// blossoms and derivatives, insertion and removal of knots, Bézier pieces, degree elevation and
/// products, and spline functions as values, knots and coefficients together. In the functions the
/// coefficients
/// \f$ c_0, \dots, c_{n-1} \f$ are in a random-access container `c`; they are numbers or
/// `Coordinate_vector`s.
///
/// On the span `k` the spline is a polynomial \f$ f_k \f$. Its \em blossom
/// \f$ f_k[t_1, \dots, t_p] \f$ is the function that is symmetric, affine in each argument, and
/// equal to \f$ f_k(t) \f$ at \f$ [t, \dots, t] \f$. Everything rests on
/// \f$ c_i = f_k[u_{i+1}, \dots, u_{i+p}] \f$. Products are Bernstein products on the spans, and
/// then one blossom value for each coefficient over the knots of the result. No linear system is
/// solved.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the values of all `n` basis functions \f$ N_i^p(u) \f$: right-continuous, and continuous
/// from the left at the end of the domain. \f$ O(n + p^2) \f$
/// \throws Error `parameter_outside_domain`
template <class FT> std::vector<FT> bspline_basis(const Knot_vector<FT>& knots, const FT& u) {
  const int p = knots.degree(), k = knots.span(u);
  std::vector<FT> basis(knots.number_of_coefficients(), FT(0));
  internal::derivative_weights(knots, p, k, u, 0, [&](int, const internal::Span_weights<FT>& weights) {
    std::copy_n(weights.w, p + 1, basis.begin() + weights.first);
  });
  return basis;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the derivatives of order 0 to `order >= 0` at `u` of the polynomial on the span `k`:
/// from the right or from the left at a knot, according to `Knot_vector::span()` and
/// `Knot_vector::left_span()`. \f$ O(p^2 + p\,order^2) \f$
/// \throws Error `wrong_number_of_points` unless there are `n` coefficients, `negative_count` when
///   `order` is negative, `parameter_outside_domain` unless `k` is a span
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> bspline_derivatives(const Knot_vector<FT>& knots, const Coefficients& c,
                                                                   int k, const FT& u, int order) {
  internal::check_number_of_coefficients(knots, c, "bspline_derivatives");
  internal::check_span(knots, k, "bspline_derivatives");
  if (order < 0) throw Error(Error_code::negative_count, "bspline_derivatives: order");
  return internal::derivatives_on_span(knots, c, k, u, order);
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the value at `u`, from the right at a knot and from the left at the end of the domain.
/// \f$ O(\log n + p^2) \f$
/// \throws Error `parameter_outside_domain`, `wrong_number_of_points` unless there are `n`
///   coefficients
template <class FT, class Coefficients>
typename Coefficients::value_type bspline_value(const Knot_vector<FT>& knots, const Coefficients& c, const FT& u) {
  internal::check_number_of_coefficients(knots, c, "bspline_value");
  // equivalent [0 -> 1, 1]: a derivative more, which is not used
  return internal::derivatives_on_span(knots, c, knots.span(u), u, 0)[0];
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the blossom \f$ f_k[t_1, \dots, t_p] \f$ of the polynomial on the span `k`, at `p`
/// arguments in any order. \f$ O(p^2) \f$
/// \throws Error `wrong_number_of_points` unless there are `n` coefficients and `p` arguments,
///   `parameter_outside_domain` unless `k` is a span
template <class FT, class Coefficients>
typename Coefficients::value_type bspline_blossom(const Knot_vector<FT>& knots, const Coefficients& c, int k,
                                                  std::vector<FT> arguments) {
  internal::check_number_of_coefficients(knots, c, "bspline_blossom");
  internal::check_span(knots, k, "bspline_blossom");
  if (static_cast<int>(arguments.size()) != knots.degree())
    throw Error(Error_code::wrong_number_of_points, "bspline_blossom: " + std::to_string(arguments.size()) +
                                                        " arguments in degree " + std::to_string(knots.degree()));
  std::sort(arguments.begin(), arguments.end());
  internal::Blossom_weights<FT> weights;
  weights.assign(knots, knots.degree(), k, arguments);
  return weights(c);
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the coefficients of a spline over finer knots. A coefficient with `r` new knots between
/// its old ones is a convex combination of `r + 1` old coefficients. \f$ O(n p^2) \f$. Boehm,
/// Goldman; the Oslo algorithm
/// \param finer has the same degree and domain and every knot inside it at least as often; outside,
///   it has the same
///        knots, or it is clamped
/// \throws Error `wrong_number_of_points` when the degrees differ and unless there are `n`
///   coefficients, `parameter_outside_domain` when the domains differ, `knot_multiplicity` when a
///   knot is missing
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> bspline_refine(const Knot_vector<FT>& knots, const Coefficients& c,
                                                              const Knot_vector<FT>& finer) {
  internal::check_number_of_coefficients(knots, c, "bspline_refine");
  if (knots.degree() != finer.degree())
    throw Error(Error_code::wrong_number_of_points, "bspline_refine: the degrees differ");
  if (!knots.has_domain_of(finer))
    throw Error(Error_code::parameter_outside_domain, "bspline_refine: the domains differ");
  const auto outside = [&finer](const Knot_vector<FT>& x) {
    std::vector<FT> u;
    std::copy_if(x.begin(), x.end(), std::back_inserter(u), [&](const FT& v) { return !finer.contains(v); });
    return u;
  };
  const Knot_vector<FT> coarse = finer.is_clamped() ? knots.clamp() : knots;
  if (outside(coarse) != outside(finer) || !std::includes(finer.begin(), finer.end(), coarse.begin(), coarse.end()))
    throw Error(Error_code::knot_multiplicity, "bspline_refine: the finer knots do not contain the old ones");
  return internal::change_knots<FT>(knots, c, finer);
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the coefficients of a spline over `knots.insert(u, times)`, `times >= 0`.
/// \f$ O(n + p\,times) \f$ operations. Boehm
/// \throws Error `negative_count`, `parameter_outside_domain`, `knot_multiplicity` when `u` would
///   be repeated more than `p + 1` times, `wrong_number_of_points` unless there are `n`
///   coefficients
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> bspline_insert(const Knot_vector<FT>& knots, const Coefficients& c,
                                                              const FT& u, int times = 1) {
  internal::check_number_of_coefficients(knots, c, "bspline_insert");
  knots.insert(u, times); // or an error
  return internal::insert_knot(knots, c, u, times);
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the Bernstein coefficients of the polynomials on the spans of the domain, `p + 1` for
/// each span, one after the other: the coefficients over `knots.bezier(p)`. \f$ O(p^2) \f$ for each
/// span and coordinate, with rational numbers additions of integers: these have the common
/// denominator of a span.
/// \param knots, c the spline
/// \throws Error `wrong_number_of_points` unless there are `n` coefficients, `work_limit`
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> bspline_bezier(const Knot_vector<FT>& knots, const Coefficients& c) {
  internal::check_number_of_coefficients(knots, c, "bspline_bezier");
  const internal::Work_guard work("Bernstein coefficients of a spline");
  return internal::bernstein_pieces(knots, c);
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the coefficients of the spline over `knots` from the Bernstein coefficients of its
/// polynomials, the inverse of `bspline_bezier()`: each coefficient is one value of the blossom of
/// one polynomial. \f$ O(n p^2) \f$ With rounded numbers, knots far outside the domain magnify the
/// roundings: their coefficients are extrapolations.
///
/// The caller must ensure that the polynomials join as smoothly at each knot of multiplicity `m` as
/// `knots` says, \f$ C^{p-m} \f$. Otherwise there is no such spline, and each coefficient belongs
/// to one of the polynomials.
/// \throws Error `wrong_number_of_points` unless there are `p + 1` coefficients for each span
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> bspline_from_bezier(const Knot_vector<FT>& knots,
                                                                   const Coefficients& pieces) {
  const Knot_vector<FT> u = knots.bezier(knots.degree());
  internal::check_number_of_coefficients(u, pieces, "bspline_from_bezier");
  return internal::change_knots<FT>(u, pieces, knots);
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Decides the order of continuity at a parameter inside the domain: the largest \f$ s \le p \f$
/// such that all derivatives up to order `s` agree from both sides, -1 at a jump. It is `p` where
/// both sides are one polynomial. Decided exactly: floating-point numbers are taken as the rational
/// numbers they are. \f$ O(p^3) \f$
/// \throws Error `parameter_outside_domain` also at the ends of the domain,
///   `wrong_number_of_points` unless there are `n` coefficients
template <class FT, class Coefficients>
int bspline_smoothness(const Knot_vector<FT>& knots, const Coefficients& c, const FT& u) {
  typedef typename Exact_field<FT>::type Field;
  internal::check_number_of_coefficients(knots, c, "bspline_smoothness");
  const int p = knots.degree(), left = knots.left_span(u), right = knots.span(u);
  if (u == knots.domain().first || u == knots.domain().second)
    throw Error(Error_code::parameter_outside_domain, "bspline_smoothness: an end of the domain has one side only");
  if (left == right) return p;
  const auto coefficient = [&c](int i) { return internal::coefficient_over<Field>(c[i]); };
  std::vector<decltype(coefficient(0))> from_left(p + 1), from_right(p + 1);
  internal::derivatives_over<Field>(knots, left, u, p, coefficient, [&](int j, const auto& x) { from_left[j] = x; });
  internal::derivatives_over<Field>(knots, right, u, p, coefficient, [&](int j, const auto& x) { from_right[j] = x; });
  int s = -1;
  while (s < p && from_left[s + 1] == from_right[s + 1]) ++s;
  return s;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the coefficients over the knots without `times >= 0` copies of the inner knot `u`, or
/// nothing when that would change the spline. The decision is that of `bspline_smoothness()`.
/// \f$ O(n + p^3) \f$ operations
/// \throws Error `negative_count` when `times` is negative, `parameter_outside_domain` unless `u`
///   is inside the domain, `wrong_number_of_points` unless there are `n` coefficients
template <class FT, class Coefficients>
std::optional<std::vector<typename Coefficients::value_type>>
bspline_remove(const Knot_vector<FT>& knots, const Coefficients& c, const FT& u, int times = 1) {
  if (times < 0) throw Error(Error_code::negative_count, "bspline_remove: times");
  const int smoothness = bspline_smoothness<FT>(knots, c, u), rest = knots.multiplicity(u) - times;
  if (rest < 0 || smoothness < knots.degree() - rest) return std::nullopt;
  return internal::change_knots<FT>(knots, c, knots.remove(u, times));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the knots without those inner copies that the spline does not need, by
/// `bspline_smoothness()`. `Bspline_function::remove_superfluous_knots()` is the function over
/// them. \f$ O(n p^3) \f$
/// \throws Error `wrong_number_of_points` unless there are `n` coefficients
template <class FT, class Coefficients>
Knot_vector<FT> minimal_knots(const Knot_vector<FT>& knots, const Coefficients& c) {
  std::vector<typename Knot_vector<FT>::Knot> inner = knots.inner_knots();
  for (typename Knot_vector<FT>::Knot& knot : inner)
    knot.multiplicity = (std::min)(knot.multiplicity, knots.degree() - bspline_smoothness<FT>(knots, c, knot.value));
  return knots.with_inner_knots(inner);
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the knots of the derivative: without the first and the last, in degree `p - 1`. A knot
/// where the splines may jump loses one of its `p + 1` copies as well; jumps are not
/// differentiated. In degree 0 the vector itself.
template <class FT> Knot_vector<FT> derivative_knots(const Knot_vector<FT>& knots) {
  const int p = knots.degree(), n = knots.number_of_coefficients();
  if (p == 0) return knots;
  std::vector<FT> u;
  for (int i = 1; i < n + p; ++i)
    if (i >= n || knots[i] < knots[i + p]) u.push_back(knots[i]);
  return Knot_vector<FT>(p - 1, std::move(u));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the coefficients \f$ p \frac{c_i - c_{i-1}}{u_{i+p} - u_i} \f$ of the derivative over
/// `derivative_knots()`; zeros in degree 0. \f$ O(n) \f$
/// \throws Error `wrong_number_of_points` unless there are `n` coefficients
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> bspline_derivative(const Knot_vector<FT>& knots, const Coefficients& c) {
  typedef typename Coefficients::value_type Value;
  internal::check_number_of_coefficients(knots, c, "bspline_derivative");
  const int p = knots.degree(), n = knots.number_of_coefficients();
  std::vector<Value> d;
  if (p == 0) d.assign(n, Value(FT(0) * c[0]));
  for (int i = 1; i < n && p > 0; ++i)
    if (knots[i] < knots[i + p]) d.push_back(Value(FT(FT(p) / FT(knots[i + p] - knots[i])) * (c[i] - c[i - 1])));
  return d;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the knots of the product of splines of the degrees `p` and `q` over `f` and `g`:
/// clamped, of degree `p + q`, with the multiplicity
/// \f$ \max(m_f + q \text{ if } m_f > 0,\ m_g + p \text{ if } m_g > 0) \f$ for an inner knot of the
/// multiplicities \f$ m_f, m_g \f$, which is the smallest that holds all products. Che et al.
/// \throws Error `parameter_outside_domain` when the domains differ
template <class FT> Knot_vector<FT> product_knots(const Knot_vector<FT>& f, const Knot_vector<FT>& g) {
  return internal::distinct_product_knots(f, g).knot_vector();
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the coefficients over `product_knots()` of the product of a spline `f` of degree `p`
/// with numbers and a spline `g` of degree `q` with numbers or vectors as coefficients. The knots
/// need not be equal nor clamped, and may have any multiplicity.
///
/// With \f$ P_k = f_k g_k \f$ in Bernstein form on each span, the coefficients are
/// \f$ P_k[t_{j+1}, \dots, t_{j+p+q}] \f$. Most of them are Bernstein coefficients as they are; of
/// splines of equal degree with simple knots, one for each knot needs arithmetic.
///
/// \f$ O(p^2 + q^2 + pq) \f$ field operations for each coordinate and span, and \f$ O((p+q)^2) \f$
/// for each coefficient that straddles a knot. Degrees up to 3 on floating-point numbers are
/// unrolled.
/// \throws Error `parameter_outside_domain` when the domains differ,
///   `wrong_number_of_points` unless the numbers of coefficients fit the knots
template <class FT, class Scalars, class Coefficients>
std::vector<typename Coefficients::value_type> bspline_product(const Knot_vector<FT>& f_knots, const Scalars& f,
                                                               const Knot_vector<FT>& g_knots, const Coefficients& g) {
  internal::check_number_of_coefficients(f_knots, f, "bspline_product: first factor");
  internal::check_number_of_coefficients(g_knots, g, "bspline_product: second factor");
  return internal::product_over(internal::distinct_product_knots(f_knots, g_knots), f_knots, f, g_knots, g);
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the knots of the same splines in a degree raised by `times >= 0`: clamped, every inner
/// knot repeated `times` more.
/// \throws Error `negative_count` when `times` is negative
template <class FT> Knot_vector<FT> elevated_knots(const Knot_vector<FT>& knots, int times = 1) {
  return internal::distinct_elevated_knots(knots, times).knot_vector();
}

/// \ingroup PkgGeometricContinuityAlgebra
/// Returns the coefficients over `elevated_knots()`: those of the product with the constant 1 of
/// degree `times >= 0`. The operations are those of `bspline_product()`.
/// \throws Error `negative_count` when `times` is negative, `wrong_number_of_points` unless there
///   are `n` coefficients
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> bspline_elevate(const Knot_vector<FT>& knots, const Coefficients& c,
                                                               int times = 1) {
  internal::check_number_of_coefficients(knots, c, "bspline_elevate");
  return internal::elevate_over(internal::distinct_elevated_knots(knots, times), knots, c);
}

/// \ingroup PkgGeometricContinuityAlgebra
/// A spline function \f$ \sum_i c_i N_i^p(u) \f$ over a `Knot_vector`, with numbers or vectors as
/// values: the algorithms of this header with knots and coefficients kept together.
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

  /// Returns the derivatives of order 0 to `k >= 0` at `u` from the right; at the end of the domain
  /// from the left. \f$ O(\log n + p^2 + p\,k^2) \f$ \throws Error also `negative_count` when `k`
  /// is negative
  std::vector<Value> right_derivatives(const FT& u, int k) const {
    return bspline_derivatives<FT>(knots_, c_, knots_.span(u), u, k);
  }
  /// Returns the derivatives of order 0 to `k >= 0` at `u` from the left; at the start of the
  /// domain from the right. \f$ O(\log n + p^2 + p\,k^2) \f$ \throws Error also `negative_count`
  /// when `k` is negative
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

  /// Returns the same function with `times >= 0` more copies of the knot `u`, see
  /// `bspline_insert()`.
  /// \throws Error as `bspline_insert()`
  Bspline_function insert(const FT& u, int times = 1) const {
    return {knots_.insert(u, times), internal::insert_knot(knots_, c_, u, times)};
  }
  /// Returns the same function over finer knots, see `bspline_refine()`. \throws Error as
  /// `bspline_refine()`
  Bspline_function refine(const Knot_vector<FT>& finer) const { return {finer, bspline_refine<FT>(knots_, c_, finer)}; }
  /// Returns the same function without the knots outside the domain.
  Bspline_function clamp() const { return refine(knots_.clamp()); }

  /// Returns the same function with `times >= 0` copies of the inner knot `u` less, or nothing, see
  /// `bspline_remove()`.
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

  /// Returns the same function with the degree raised by `times >= 0`, clamped, see
  /// `bspline_elevate()`.
  /// \throws Error `negative_count` when `times` is negative
  Bspline_function elevate(int times = 1) const {
    const internal::Distinct_knots<FT> knots = internal::distinct_elevated_knots(knots_, times);
    return {knots.knot_vector(), internal::elevate_over<FT>(knots, knots_, c_)};
  }

  /// Returns the function with its domain reversed, see `Knot_vector::reverse()`.
  Bspline_function reverse() const { return {knots_.reverse(), std::vector<Value>(c_.rbegin(), c_.rend())}; }

  /// @}

  /// Returns the product, see `bspline_product()`. \throws Error `parameter_outside_domain` when
  /// the domains differ
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
    if (f.knots_ == g.knots_ && f.knots_.is_clamped()) return combined(f.knots_, f.c_, g.c_, sign);
    const int d = (std::max)(f.degree(), g.degree());
    const Bspline_function x = f.elevate(d - f.degree()), y = g.elevate(d - g.degree());
    const Knot_vector<FT> knots = merge(x.knots_, y.knots_);
    return combined(knots, bspline_refine<FT>(x.knots_, x.c_, knots), bspline_refine<FT>(y.knots_, y.c_, knots), sign);
  }
  static Bspline_function combined(const Knot_vector<FT>& knots, std::vector<Value> c, const std::vector<Value>& b,
                                   const FT& sign) {
    for (std::size_t i = 0; i < c.size(); ++i) c[i] += sign * b[i];
    return {knots, std::move(c)};
  }
};

/// \ingroup PkgGeometricContinuityConstruction
/// A function of the parameter along an edge, whose domain is mapped to [0, 1]: a spline, of which
/// numbers and polynomials are the ones without inner knots.
/// \tparam FT a field number type
template <class FT_> class Edge_function {
public:
  typedef FT_ FT; ///< the number type

private:
  Bspline_function<FT> f_; // on [0, 1], clamped

  struct On_unit_interval {};
  Edge_function(Bspline_function<FT> f, On_unit_interval) : f_(std::move(f)) {}

public:
  /// Constructs a polynomial from its Bernstein coefficients, a number from one.
  /// \throws Error `wrong_number_of_points` without coefficients, `not_finite`
  Edge_function(std::initializer_list<FT> coefficients) : Edge_function(Bernstein_polynomial<FT>(coefficients)) {}
  /// Constructs a polynomial. \throws Error `not_finite`
  Edge_function(const Bernstein_polynomial<FT>& p) : f_(Knot_vector<FT>(p.degree(), FT(0), FT(1)), p.coefficients()) {}
  /// Constructs a spline; its domain is mapped to [0, 1].
  Edge_function(const Bspline_function<FT>& f)
      : f_(on_interval({FT(0), FT(1)}, f.knots().is_clamped() ? f : f.clamp())) {}

  /// Returns the degree.
  int degree() const { return f_.degree(); }
  /// Returns the knots, from 0 to 1.
  const Knot_vector<FT>& knots() const { return f_.knots(); }
  /// Returns the number of coefficients \f$ c_i \f$ of the spline over the knots.
  int number_of_coefficients() const { return f_.knots().number_of_coefficients(); }
  /// Returns \f$ c_i \f$; of a number there is only \f$ c_0 \f$, of a polynomial these are
  /// Bernstein coefficients.
  const FT& operator[](int i) const { return f_[i]; }
  /// Returns the value at `t` in [0, 1]. \throws Error `parameter_outside_domain`
  FT operator()(const FT& t) const { return f_(t); }

  /// Returns the spline on another domain, to which [0, 1] is mapped. \throws Error `empty_domain`
  Bspline_function<FT> over(const std::pair<FT, FT>& domain) const { return on_interval(domain, f_); }

  /// Decides whether the function is a number.
  bool is_number() const { return f_.coefficients().size() == 1; }

  /// Decides whether the function is positive on [0, 1], on both sides of each knot; exactly, also
  /// of floating-point numbers.
  bool is_positive() const { return is_number() ? bool(FT(0) < f_.coefficients()[0]) : is_positive_function(); }

  /// Returns the product.
  friend Edge_function operator*(const Edge_function& f, const Edge_function& g) {
    return Edge_function(f.f_ * g.f_, On_unit_interval());
  }
  /// Returns the sum, in the larger of the two degrees and over the knots of both.
  friend Edge_function operator+(const Edge_function& f, const Edge_function& g) {
    return Edge_function(f.f_ + g.f_, On_unit_interval());
  }

  /// Decides whether knots and coefficients are equal.
  friend bool operator==(const Edge_function& f, const Edge_function& g) { return f.f_ == g.f_; }
  /// Decides whether a knot or a coefficient is different.
  friend bool operator!=(const Edge_function& f, const Edge_function& g) { return !(f == g); }

  /// Writes the coefficients, separated by spaces, and then ` over ` and the inner knots if there
  /// are any.
  friend std::ostream& operator<<(std::ostream& os, const Edge_function& f) {
    for (int i = 0; i < f.number_of_coefficients(); ++i) os << (i == 0 ? "" : " ") << f[i];
    const char* separator = " over ";
    for (const auto& knot : f.knots().inner_knots())
      for (int i = 0; i < knot.multiplicity; ++i, separator = " ") os << separator << knot.value;
    return os;
  }

private:
  // Decides whether a function that is no number is positive.
  bool is_positive_function() const {
    const std::vector<FT>& c = f_.coefficients();
    // mostly
    if (std::all_of(c.begin(), c.end(), [](const FT& x) { return FT(0) < x; })) return true;
    const internal::Work_on_part work("Edge_function::is_positive");
    const std::vector<FT> pieces = internal::bernstein_pieces(f_.knots(), f_.coefficients());
    const std::ptrdiff_t n = degree() + 1;
    for (auto piece = pieces.begin(); piece != pieces.end(); piece += n)
      if (sign_pattern(Bernstein_polynomial<FT>(piece, piece + n)) != Sign_pattern::positive) return false;
    return true;
  }

  static Bspline_function<FT> on_interval(const std::pair<FT, FT>& to, const Bspline_function<FT>& f) {
    return Bspline_function<FT>(f.knots().on_domain(to.first, to.second), f.coefficients());
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_BSPLINE_FUNCTION_H
