// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_CHANGE_KNOTS_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_CHANGE_KNOTS_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/splines/internal/Spline_weights.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <vector>

/// \file change_knots.h
/// The coefficients of a spline over other knots, as blossoms
/// \f$ c'_j = f_k[t_{j+1}, \dots, t_{j+p}] \f$ at the new knots `t`, and its derivatives in another field.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Chooses the span of the old knots u whose polynomial gives a new coefficient. Any span between the arguments would do
// in exact arithmetic. The longest one keeps rounding errors small: arguments outside lie at most as many of its
// lengths away as there are other spans between the arguments, however uneven the knots are.
template <class FT> class Span_choice {
  const Knot_vector<FT>& u_;
  std::vector<int> spans_;  // all that are not empty, outside the domain as well
  std::vector<FT> lengths_; // of these
  std::size_t current_ = 0; // the one that contains the first argument

public:
  explicit Span_choice(const Knot_vector<FT>& u) : u_(u) {
    for (int k = 0; k + 1 < u.size(); ++k)
      if (u[k] < u[k + 1]) {
        spans_.push_back(k);
        lengths_.push_back(FT(u[k + 1] - u[k]));
      }
  }

  // For the j-th coefficient over t; the calls are made for increasing j.
  int operator()(const Knot_vector<FT>& t, int j) {
    const int p = t.degree();
    const FT &first = t[p == 0 ? j : j + 1], &last = t[j + p];
    while (current_ + 1 < spans_.size() && !(first < u_[spans_[current_] + 1])) ++current_;
    if (first == last) { // the basis function lives on the right of the knot, or else on the left
      const bool right = t[j + p] < t[j + p + 1];
      return spans_[right || current_ == 0 || u_[spans_[current_]] != first ? current_ : current_ - 1];
    }
    std::size_t longest = current_;
    bool found = !(u_[spans_[longest]] < first) && !(last < u_[spans_[longest] + 1]);
    for (std::size_t i = current_ + 1; i < spans_.size() && !(last < u_[spans_[i] + 1]); ++i)
      if (!found || lengths_[longest] < lengths_[i]) {
        longest = i;
        found = true;
      }
    return spans_[longest];
  }
};

// The coefficients over t of the spline with coefficients c over u. \pre the spline belongs to the space of t
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> change_knots(const Knot_vector<FT>& u, const Coefficients& c,
                                                            const Knot_vector<FT>& t) {
  std::vector<typename Coefficients::value_type> result;
  result.reserve(t.number_of_coefficients());
  Span_choice<FT> span(u);
  Blossom_weights<FT> weights;
  for (int j = 0; j < t.number_of_coefficients(); ++j) {
    weights.assign(u, u.degree(), span(t, j), t.begin() + (j + 1));
    if (weights.w.size() == 1)
      result.push_back(c[weights.first]);
    else
      result.push_back(weights(c));
  }
  return result;
}

template <class Field, class FT> Field coefficient_over(const FT& x) { return to_field<Field>(x); }
template <class Field, class FT, int N>
Coordinate_vector<Field, N> coefficient_over(const Coordinate_vector<FT, N>& x) {
  Coordinate_vector<Field, N> r(x.dimension());
  for (int i = 0; i < x.dimension(); ++i) r[i] = to_field<Field>(x[i]);
  return r;
}

// The derivatives of order 0 to p at u, not beyond `order`, of the polynomial on the span k, in another field, to which
// what is needed is converted. coefficient(i) is the i-th coefficient in that field; output(j, derivative) is called.
template <class Field, class FT, class Coefficient, class Output>
void derivatives_over(const Knot_vector<FT>& knots, int k, const FT& u, int order, Coefficient coefficient,
                      Output output) {
  const int p = knots.degree();
  Span_vector<decltype(coefficient(0))> c;         // c_{k-p}, ..., c_k
  boost::container::small_vector<Field, 16> local; // u_{k-p}, ..., u_{k+p}
  for (int i = k - p; i <= k; ++i) c.push_back(coefficient(i));
  for (int i = k - p; i <= k + p; ++i) local.push_back(to_field<Field>(knots[i]));
  derivative_weights(local, p, p, to_field<Field>(u), order,
                     [&](int j, const Spline_weights<Field>& weights) { output(j, weights(c)); });
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_CHANGE_KNOTS_H
