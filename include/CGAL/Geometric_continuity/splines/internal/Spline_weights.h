// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_SPLINE_WEIGHTS_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_SPLINE_WEIGHTS_H

#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <vector>

/// \file Spline_weights.h
/// The weights with which the coefficients of a spline enter its values, derivatives and blossoms: de Boor's triangle.

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

// De Boor's triangle, transposed: it starts with the weight 1 and leads to the weights of the coefficients. The level
// with n weights gives n + 1; its i-th quotient belongs to the knots left + i and right + i.
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

// The level of the triangle that stands for one differentiation.
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

// The weights of the derivatives of order 0 to p at t, not beyond `order`, of a spline of degree p on the span k, for
// the coefficients k-p, ..., k: output(j, weights) is called for each. Only the knots k-p+1, ..., k+p are read.
template <class FT, class Knots, class Output>
void derivative_weights(const Knots& u, int p, int k, const FT& t, int order, Output output) {
  Spline_weights<FT> basis, weights; // the basis of degree p - j
  basis.w.reserve(p + 1);
  basis.w.push_back(FT(1));
  const int last = (std::min)(order, p);
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

// The derivatives of order 0 to `order` at t of the polynomial on the span k.
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> derivatives_on_span(const Knot_vector<FT>& u, const Coefficients& c,
                                                                   int k, const FT& t, int order) {
  typedef typename Coefficients::value_type Value;
  std::vector<Value> derivatives(order + 1, Value(FT(0) * c[0]));
  derivative_weights(u, u.degree(), k, t, order,
                     [&](int j, const Spline_weights<FT>& weights) { derivatives[j] = weights(c); });
  return derivatives;
}

// The weights of the blossom f_k[t_1, ..., t_p] at increasing arguments. Arguments that are knots next to the span are
// not computed with but select the coefficients, so that as few levels as possible remain. When every knot between the
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

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_SPLINE_WEIGHTS_H
