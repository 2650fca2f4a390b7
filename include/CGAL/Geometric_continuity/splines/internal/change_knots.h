// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_CHANGE_KNOTS_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_CHANGE_KNOTS_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/splines/internal/Spline_weights.h>
#include <CGAL/Geometric_continuity/splines/internal/bspline_differences.h>
#include <CGAL/Geometric_continuity/splines/internal/bspline_spans.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

/// \file change_knots.h
/// One spline over several knot vectors: insertion, refinement, Bézier pieces and back. But for the
/// Bézier pieces, the new coefficients are computed as blossoms c'_j = f_k[t_{j+1}, ..., t_{j+p}]
/// at the new knots t, in O(p^2) each.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Chooses the span of the old knots u whose polynomial gives a new coefficient. Any span between
// the arguments would do in exact arithmetic. The longest one keeps rounding errors small:
// arguments outside lie at most as many of its lengths away as there are other spans between the
// arguments, however uneven the knots are.
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

  // Returns the span for the j-th coefficient over t; the calls are made for increasing j.
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
        // equivalent [true -> false, 1]: which span is taken matters for roundings only
        found = true;
      }
    return spans_[longest];
  }
};

// The coefficients over t of the spline with coefficients c over u. \pre the spline belongs to the
// space of t
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> change_knots(const Knot_vector<FT>& u, const Coefficients& c,
                                                            const Knot_vector<FT>& t) {
  const int n = t.number_of_coefficients();
  std::vector<typename Coefficients::value_type> result;
  result.reserve(n);
  Span_choice<FT> span(u);
  Blossom_weights<FT> weights;
  for (int j = 0; j < n; ++j) {
    weights.assign(u, u.degree(), span(t, j), t.begin() + (j + 1));
    if (weights.w.size() == 1)
      result.push_back(c[weights.first]);
    else
      result.push_back(weights(c));
  }
  return result;
}

// Boehm's insertion of `times` more copies of t, which is in the span k and has the multiplicity m:
// the coefficients between c_{k-p} and c_{k-m} change. For one copy after the other, the new ones
// are (1 - q) c_{j-1} + q c_j with q = (t - u_j) / (u_{j+p} - u_j). \pre `u.insert(t, times)`
// throws no error
template <class FT> class Knot_insertion {
  const Knot_vector<FT>& u_;
  const FT& t_;
  int times_, first_, last_; // k-p, k-m

public:
  Knot_insertion(const Knot_vector<FT>& u, const FT& t, int times) : u_(u), t_(t), times_(times) {
    const auto copies = std::equal_range(u.begin(), u.end(), t);
    first_ = static_cast<int>(copies.second - u.begin()) - 1 - u.degree();
    last_ = static_cast<int>(copies.first - u.begin()) - 1;
  }

  // Those that take the place of c_{k-p}, ..., c_{k-m}; old(j) is c_j. The first and the last one
  // stay.
  template <class Value, class Old> std::vector<Value> new_coefficients(const Old& old) const {
    std::vector<Value> c;
    if (times_ == 0) return c;
    const int last = last_ - first_;
    c.reserve(last + 1 + times_);
    for (int i = 0; i <= last; ++i) c.push_back(old(first_ + i));
    c.resize(c.size() + times_, c.back());
    for (int l = 0; l < times_; ++l) {
      c[last + times_ - l] = c[last];
      for (int i = last; i > l; --i) {
        const FT& a = u_[first_ + i];
        const FT q = FT(FT(t_ - a) / FT(u_[first_ + i + u_.degree() - l] - a));
        c[i] = FT(FT(1) - q) * c[i - 1] + q * c[i];
      }
    }
    return c;
  }

  // c with changed(i) for number i of those, but for the first and the last one.
  template <class Values, class Changed> Values replaced(const Values& c, const Changed& changed) const {
    if (times_ == 0) return c;
    Values result;
    result.reserve(c.size() + times_);
    result.assign(c.begin(), c.begin() + first_ + 1);
    for (int i = 1; i < last_ - first_ + times_; ++i) result.push_back(changed(i));
    result.insert(result.end(), c.begin() + last_, c.end());
    return result;
  }
};

template <class FT, class Values>
Values insert_knot(const Knot_vector<FT>& knots, const Values& c, const FT& u, int times) {
  const Knot_insertion<FT> insertion(knots, u, times);
  typedef typename Values::value_type Value;
  const std::vector<Value> changed = insertion.template new_coefficients<Value>([&](int j) { return c[j]; });
  return insertion.replaced(c, [&](int i) { return changed[i]; });
}

// The Bernstein coefficients on the spans.
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> bernstein_pieces(const Knot_vector<FT>& knots, const Coefficients& c) {
  typedef typename Coefficients::value_type Value;
  const int p = knots.degree(), n = number_of_coordinates(c[0]);
  const std::vector<int> spans = knots.spans();
  std::vector<Value> result(spans.size() * (p + 1), c[0]);
  if (spans.size() == 1 && knots.is_clamped()) {
    std::copy(c.begin(), c.end(), result.begin());
    return result;
  }
  const auto number = [](auto& x, int d) -> auto& {
    if constexpr (std::is_same_v<Value, FT>)
      return x;
    else
      return x[d];
  };
  if constexpr (is_rational_v<FT>) {
    for (int d = 0; d < n; ++d) {
      std::vector<FT> column;
      for (const Value& x : c) column.push_back(number(x, d));
      Difference_spans<FT> pieces(knots, std::move(column));
      for (std::size_t s = 0; s < spans.size(); ++s) {
        pieces.start();
        pieces.finish([&](int i, const auto& x, const auto& y) {
          number(result[s * (p + 1) + i], d) = Difference_spans<FT>::quotient(x, y);
        });
      }
    }
  } else {
    const auto row = [&](int i, FT* x) {
      for (int d = 0; d < n; ++d) x[d] = number(c[i], d);
    };
    Bernstein_spans<FT, -1, 0, decltype(row)> pieces(knots, n, row);
    for (std::size_t s = 0; s < spans.size(); ++s) {
      pieces.next(knots[spans[s] + 1]);
      for (int i = 0; i <= p; ++i)
        for (int d = 0; d < n; ++d) number(result[s * (p + 1) + i], d) = pieces[i][d];
    }
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

// The derivatives of order 0 to p at u, not beyond `order`, of the polynomial on the span k, in
// another field, to which what is needed is converted. coefficient(i) is the i-th coefficient in
// that field; output(j, derivative) is called.
template <class Field, class FT, class Coefficient, class Output>
void derivatives_over(const Knot_vector<FT>& knots, int k, const FT& u, int order, const Coefficient& coefficient,
                      const Output& output) {
  const auto in_degree = [&](auto degree) {
    constexpr int Degree = degree;
    const int p = Degree < 0 ? knots.degree() : Degree;
    typedef decltype(coefficient(0)) Value;
    std::conditional_t<(Degree < 0), Span_vector<Value>, std::array<Value, Degree + 1 + (Degree < 0)>>
        c; // c_{k-p}, ...
    std::conditional_t<(Degree < 0), boost::container::small_vector<Field, 16>,
                       std::array<Field, 2 * Degree + 1 + 2 * (Degree < 0)>>
        local; // u_{k-p}, ..., u_{k+p}
    if constexpr (Degree < 0) {
      c.resize(p + 1);
      local.resize(2 * p + 1);
    }
    for (int i = 0; i <= p; ++i) c[i] = coefficient(k - p + i);
    for (int i = 0; i <= 2 * p; ++i) local[i] = to_field<Field>(knots[k - p + i]);
    derivative_weights<Degree>(local, p, p, to_field<Field>(u), order,
                               [&](int j, const Span_weights<Field, Degree>& weights) { output(j, weights(c)); });
  };
  if constexpr (std::is_same_v<Field, FT>)
    with_degree_inside_span(knots, knots.degree(), k, u, in_degree);
  else
    in_degree(std::integral_constant<int, -1>());
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_CHANGE_KNOTS_H
