// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_BSPLINE_EVALUATE_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_BSPLINE_EVALUATE_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

/// \file bspline_evaluate.h
/// Values, blossoms and derivatives of splines \f$ \sum_i c_i N_i^p(u) \f$ over a `Knot_vector`, by field arithmetic
/// only. The coefficients \f$ c_0, \dots, c_{n-1} \f$ are in a random-access container `c`; they are numbers or
/// `Coordinate_vector`s.
///
/// On the span `k` the spline is a polynomial \f$ f_k \f$. Its \em blossom \f$ f_k[t_1, \dots, t_p] \f$ is the function that
/// is symmetric, affine in each argument, and equal to \f$ f_k(t) \f$ at \f$ [t, \dots, t] \f$. Everything rests on
/// \f$ c_i = f_k[u_{i+1}, \dots, u_{i+p}] \f$.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// As many as belong to one span: without allocation up to degree 7.
template <class T> using Span_vector = boost::container::small_vector<T, 8>;

// A combination sum_i w_i c_{first+i} of consecutive coefficients.
template <class FT> struct Spline_weights {
  int first = 0;
  Span_vector<FT> w;

  template <class Coefficients> typename Coefficients::value_type operator()(const Coefficients& c) const {
    typename Coefficients::value_type sum = w[0] * c[first];
    for (int i = 1; i < static_cast<int>(w.size()); ++i) sum += w[i] * c[first + i];
    return sum;
  }
};

// De Boor's triangle, transposed: it starts with the weight 1 and leads to the weights of the coefficients. The level with
// n weights gives n + 1; its i-th quotient belongs to the knots left + i and right + i.
template <class FT, class Knots>
void add_argument(Span_vector<FT>& w, const Knots& u, int left, int right, const FT& t) {
  FT carry(0);
  const int n = static_cast<int>(w.size());
  for (int i = 0; i < n; ++i) {
    const FT x = w[i] * FT(FT(t - u[left + i]) / FT(u[right + i] - u[left + i]));
    w[i] = carry + FT(w[i] - x);
    carry = x;
  }
  w.push_back(carry);
}

// The same for one differentiation.
template <class FT, class Knots> void add_differentiation(Span_vector<FT>& w, const Knots& u, int left, int right) {
  FT carry(0);
  const int n = static_cast<int>(w.size());
  for (int i = 0; i < n; ++i) {
    const FT x = FT(n) * w[i] / FT(u[right + i] - u[left + i]);
    w[i] = carry - x;
    carry = x;
  }
  w.push_back(carry);
}

// The weights of the derivatives of order 0 to p at t, not beyond `order`, of a spline of degree p on the span k, for the
// coefficients k-p, ..., k: output(j, weights) is called for each. Only the knots k-p+1, ..., k+p are read.
template <class FT, class Knots, class Output>
void derivative_weights(const Knots& u, int p, int k, const FT& t, int order, Output output) {
  Spline_weights<FT> basis, weights; // the basis of degree p - j
  basis.w.reserve(p + 1);
  basis.w.push_back(FT(1));
  const int last = std::min(order, p);
  for (int m = 0; m < p - last; ++m) add_argument(basis.w, u, k - m, k + 1, t);
  weights.first = basis.first = k - p;
  for (int j = last; j > 0; --j) {
    weights.w = basis.w;
    for (int m = p - j; m < p; ++m) add_differentiation(weights.w, u, k - m, k + 1);
    output(j, weights);
    add_argument(basis.w, u, k - (p - j), k + 1, t);
  }
  output(0, basis);
}

// The weights of the blossom f_k[t_1, ..., t_p] at increasing arguments. Arguments that are knots next to the span are not
// computed with but select the coefficients, so that as few levels as possible remain. When every knot between the
// arguments is one of them, all weights are nonnegative.
template <class FT> class Blossom_weights : public Spline_weights<FT> {
  std::vector<int> other_; // the arguments that are not selected

public:
  template <class Knots, class Arguments> void assign(const Knots& u, int p, int k, const Arguments& t) {
    int middle = 0, left = 0, right = 0; // t_0, ..., t_{middle-1} <= u_k
    while (middle < p && !(u[k] < t[middle])) ++middle;
    other_.clear();
    for (int i = middle - 1; i >= 0; --i)
      if (t[i] == u[k - left])
        ++left;
      else
        other_.push_back(i);
    for (int i = middle; i < p; ++i)
      if (t[i] == u[k + 1 + right])
        ++right;
      else
        other_.push_back(i);
    this->w.assign(1, FT(1));
    for (int m = 0; m < static_cast<int>(other_.size()); ++m)
      add_argument(this->w, u, k - left - m, k + 1 + right, FT(t[other_[m]]));
    this->first = k - p + right;
  }
};

template <class FT, class Coefficients>
void check_number_of_coefficients(const Knot_vector<FT>& u, const Coefficients& c, const char* place) {
  if (static_cast<int>(c.size()) != u.number_of_coefficients())
    throw Error(Error_code::wrong_number_of_points, std::string(place) + ": " + std::to_string(c.size()) +
                                                        " coefficients where the knots need " +
                                                        std::to_string(u.number_of_coefficients()));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// The values of all `n` basis functions \f$ N_i^p(u) \f$: right-continuous, and continuous from the left at the end of the
/// domain. \f$ O(n + p^2) \f$ \throws Error `parameter_outside_domain`
template <class FT> std::vector<FT> bspline_basis(const Knot_vector<FT>& knots, const FT& u) {
  const int p = knots.degree(), k = knots.span(u);
  std::vector<FT> basis(knots.number_of_coefficients(), FT(0));
  internal::derivative_weights(knots, p, k, u, 0, [&](int, const internal::Spline_weights<FT>& weights) {
    std::copy(weights.w.begin(), weights.w.end(), basis.begin() + weights.first);
  });
  return basis;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// The derivatives of order 0 to `order >= 0` at `u` of the polynomial on the span `k`: from the right or from the left at a
/// knot, according to `Knot_vector::span()` and `Knot_vector::left_span()`. \f$ O(p^2 + p\,order^2) \f$
/// \pre `k` is a span
/// \throws Error `wrong_number_of_points` unless there are `n` coefficients
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> bspline_derivatives(const Knot_vector<FT>& knots, const Coefficients& c,
                                                                   int k, const FT& u, int order) {
  typedef typename Coefficients::value_type Value;
  internal::check_number_of_coefficients(knots, c, "bspline_derivatives");
  std::vector<Value> derivatives(order + 1, Value(FT(0) * c[0]));
  internal::derivative_weights(
      knots, knots.degree(), k, u, order,
      [&](int j, const internal::Spline_weights<FT>& weights) { derivatives[j] = weights(c); });
  return derivatives;
}

/// \ingroup PkgGeometricContinuityAlgebra
/// The value at `u`, from the right at a knot and from the left at the end of the domain. \f$ O(\log n + p^2) \f$
/// \throws Error `parameter_outside_domain`, `wrong_number_of_points` unless there are `n` coefficients
template <class FT, class Coefficients>
typename Coefficients::value_type bspline_value(const Knot_vector<FT>& knots, const Coefficients& c, const FT& u) {
  return bspline_derivatives<FT>(knots, c, knots.span(u), u, 0)[0];
}

/// \ingroup PkgGeometricContinuityAlgebra
/// The blossom \f$ f_k[t_1, \dots, t_p] \f$ of the polynomial on the span `k`, at `p` arguments in any order. \f$ O(p^2) \f$
/// \pre `k` is a span
/// \throws Error `wrong_number_of_points` unless there are `n` coefficients and `p` arguments
template <class FT, class Coefficients>
typename Coefficients::value_type bspline_blossom(const Knot_vector<FT>& knots, const Coefficients& c, int k,
                                                  std::vector<FT> arguments) {
  internal::check_number_of_coefficients(knots, c, "bspline_blossom");
  if (static_cast<int>(arguments.size()) != knots.degree())
    throw Error(Error_code::wrong_number_of_points, "bspline_blossom: " + std::to_string(arguments.size()) +
                                                        " arguments in degree " + std::to_string(knots.degree()));
  std::sort(arguments.begin(), arguments.end());
  internal::Blossom_weights<FT> weights;
  weights.assign(knots, knots.degree(), k, arguments);
  return weights(c);
}

/// \ingroup PkgGeometricContinuityAlgebra
/// The knots of the derivative: without the first and the last, in degree `p - 1`. A knot where the splines may jump loses
/// one of its `p + 1` copies as well; jumps are not differentiated. In degree 0 the vector itself.
template <class FT> Knot_vector<FT> derivative_knots(const Knot_vector<FT>& knots) {
  const int p = knots.degree(), n = knots.number_of_coefficients();
  if (p == 0) return knots;
  std::vector<FT> u;
  for (int i = 1; i < n + p; ++i)
    if (i >= n || knots[i] < knots[i + p]) u.push_back(knots[i]);
  return Knot_vector<FT>(p - 1, std::move(u));
}

/// \ingroup PkgGeometricContinuityAlgebra
/// The coefficients \f$ p \frac{c_i - c_{i-1}}{u_{i+p} - u_i} \f$ of the derivative over `derivative_knots()`; zeros in degree
/// 0. \f$ O(n) \f$ \throws Error `wrong_number_of_points` unless there are `n` coefficients
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

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_BSPLINE_EVALUATE_H
