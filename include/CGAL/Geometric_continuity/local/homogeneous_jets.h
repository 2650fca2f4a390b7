// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_HOMOGENEOUS_JETS_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_HOMOGENEOUS_JETS_H

#include <CGAL/Geometric_continuity/internal/for_each_index.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/local/coordinates.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_words.h>
#include <CGAL/Geometric_continuity/numbers/internal/number_rows.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

/// \file homogeneous_jets.h
/// Homogeneous points \f$ (p, w) = (w x, w) \f$, of one dimension more: rational curves and surfaces are polynomial ones of
/// such points. From their derivatives to those of \f$ x = p / w \f$, and back.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityTraits
/// The traits class for the homogeneous points of another one: columns \f$ (w x_1, \dots, w x_n, w) \f$. A polynomial curve or
/// surface over it is the numerator and the denominator of a rational one over `Traits`, and so every algorithm for polynomials
/// serves both.
///
/// \tparam Traits_ a model of `GeometricContinuityTraits`
/// \cgalModels{GeometricContinuityTraits}
template <class Traits_> class Homogeneous_traits {
  static constexpr int N = dimension_v<Traits_>;

public:
  typedef Traits_ Affine_traits;                             ///< the traits class of the points \f$ x \f$
  typedef typename Traits_::FT FT;                           ///< its numbers
  typedef Coordinate_vector<FT, (N == 0 ? 0 : N + 1)> Point; ///< a homogeneous point
  typedef Point Vector;                                      ///< a difference or a derivative of such points
  /// One dimension more than that of the points \f$ x \f$.
  typedef std::conditional_t<N == 0, Dynamic_dimension_tag, Dimension_tag<N + 1>> Dimension;
  /// The field in which predicates are decided.
  typedef Geometric_continuity::Predicate_FT<Traits_> Predicate_FT;

  /// Returns the number of coordinates.
  struct Compute_dimension {
    int operator()(const Point& p) const { return p.dimension(); }
  };
  /// Returns the coordinate number `i`.
  struct Compute_coordinate {
    const FT& operator()(const Point& p, int i) const { return p[i]; }
  };
  /// Constructs a column from a range of coordinates.
  struct Construct_point {
    template <class RandomAccessIterator>
    Point operator()(int d, RandomAccessIterator first, RandomAccessIterator) const {
      Point p(d);
      for (int i = 0; i < d; ++i) p[i] = first[i];
      return p;
    }
  };
  typedef Construct_point Construct_vector; ///< constructs a column, too

  /// Returns the function object `Compute_dimension`.
  Compute_dimension compute_dimension_object() const { return Compute_dimension(); }
  /// Returns the function object `Compute_coordinate`.
  Compute_coordinate compute_coordinate_object() const { return Compute_coordinate(); }
  /// Returns the function object `Construct_point`.
  Construct_point construct_point_object() const { return Construct_point(); }
  /// Returns the function object `Construct_vector`.
  Construct_vector construct_vector_object() const { return Construct_vector(); }
};

/// \ingroup PkgGeometricContinuityTraits
/// Returns the homogeneous point \f$ (w x, w) \f$, or \f$ (x, 0) \f$ for the weight 0: the infinite point in the direction
/// \f$ x \f$. \tparam N the dimension of `x`, or 0
template <class FT, int N>
Coordinate_vector<FT, (N == 0 ? 0 : N + 1)> homogeneous_point(const Coordinate_vector<FT, N>& x, const FT& w) {
  const int n = x.dimension();
  Coordinate_vector<FT, (N == 0 ? 0 : N + 1)> p(n + 1);
  const bool infinite = w == FT(0);
  for (int i = 0; i < n; ++i) p[i] = infinite ? x[i] : FT(w * x[i]);
  p[n] = w;
  return p;
}

/// \ingroup PkgGeometricContinuityTraits
/// Returns \f$ x \f$ of a homogeneous point \f$ (w x, w) \f$, or of an infinite point \f$ (x, 0) \f$; the weight is its last
/// coordinate. \tparam M the dimension of `p`, one more than that of `x`, or 0
template <class FT, int M> Coordinate_vector<FT, (M == 0 ? 0 : M - 1)> affine_point(const Coordinate_vector<FT, M>& p) {
  const int n = p.dimension() - 1;
  Coordinate_vector<FT, (M == 0 ? 0 : M - 1)> x(n);
  const bool as_it_is = p[n] == FT(0) || p[n] == FT(1);
  for (int i = 0; i < n; ++i) x[i] = as_it_is ? p[i] : FT(p[i] / p[n]);
  return x;
}

namespace internal {

// Whether a curve or a surface has weights.
template <class Shape, class = void> struct Is_rational : std::false_type {};
template <class Shape> struct Is_rational<Shape, std::void_t<typename Shape::Homogeneous>> : std::true_type {};

// Calls f(k, binomials) for k = 0, ..., order, with the row C(k, 0), ..., C(k, k) of Pascal's triangle.
template <class FT, class Function> void for_each_binomial_row(int order, Function f) {
  boost::container::small_vector<FT, 6> row(order + 1, FT(0));
  row[0] = FT(1);
  for (int k = 0; k <= order; ++k) {
    for (int j = k; j > 0; --j) row[j] += row[j - 1];
    f(k, row);
  }
}

template <class FT> void require_denominator(const FT& w, const char* place) {
  if (w == FT(0)) throw Error(Error_code::zero_weight, place);
}

constexpr int binomial(int k, int j) { return j == 0 ? 1 : binomial(k - 1, j - 1) * k / j; }

// x_l -= sum_{i=j}^l C(l,i) w_i x_{l-i}
template <int l, int j, class FT, class Value> CGAL_GC_FORCEINLINE void subtract_products(Value* x, const FT* w) {
  if constexpr (j <= l) {
    constexpr int factor = binomial(l, j);
    x[l] -= FT(FT(factor) * w[j]) * x[l - j];
    subtract_products<l, j + 1>(x, w);
  }
}
// Replaces the derivatives p_0, ..., p_k of a coordinate in x by those of x = p / w, for an order known at compile time, from
// l = 0 on. w holds w_1, ..., w_k at their places, and the inverse is 1 / w_0. Recursion, since a compiler may refuse to
// inline long chains of lambda expressions.
template <int k, int l = 0, class FT, class Value>
CGAL_GC_FORCEINLINE void divide_derivatives(Value* x, const FT* w, const FT& inverse) {
  if constexpr (l <= k) {
    subtract_products<l, 1>(x, w);
    x[l] *= inverse;
    divide_derivatives<k, l + 1>(x, w, inverse);
  }
}

// The jet x of an order up to k from the derivatives p[0], ..., p[k] of homogeneous points: all coordinates together where they are
// in a register, otherwise one after the other.
template <int k, class FT, class Derivatives, class Jet>
CGAL_GC_FORCEINLINE void project_order(const Derivatives& p, int n, int order, Jet& x) {
  typedef std::decay_t<decltype(p[0])> Row;
  std::array<FT, k + 1> w;
  for_each_index<k + 1>([&](int j) { w[j] = p[j][n]; });
  require_denominator(w[0], "the denominator of a rational curve");
  const FT inverse = FT(FT(1) / w[0]);
  if constexpr (std::is_same_v<Row, Row_vector<FT>>) {
    std::array<Row, k + 1> c;
    for_each_index<k + 1>([&](int j) { c[j] = p[j]; });
    divide_derivatives<k>(c.data(), w.data(), inverse);
    for_each_index<k + 1>([&](int j) {
      if (j <= order)
        for_each_index<3>([&](int i) {
          if (i < n) x[j][i] = c[j][i];
        });
    });
  } else
    for (int i = 0; i < n; ++i) {
      std::array<FT, k + 1> c;
      for_each_index<k + 1>([&](int j) { c[j] = p[j][i]; });
      divide_derivatives<k>(c.data(), w.data(), inverse);
      for_each_index<k + 1>([&](int j) {
        if (j <= order) x[j][i] = c[j];
      });
    }
}

// The same where the order is at most 3, otherwise nothing is done.
template <class FT, class Derivatives, class Jet>
CGAL_GC_FORCEINLINE bool project_short(const Derivatives& p, int n, int order, Jet& x) {
  switch (order) {
  case 0: return project_order<0, FT>(p, n, order, x), true;
  case 1: return project_order<1, FT>(p, n, order, x), true;
  case 2: return project_order<2, FT>(p, n, order, x), true;
  case 3: return project_order<3, FT>(p, n, order, x), true;
  default: return false;
  }
}

} // namespace internal

/// \ingroup PkgGeometricContinuityLocal
/// Returns the jet of the curve \f$ x = p / w \f$ from that of its homogeneous points \f$ (p, w) \f$:
/// \f$ x_k = (p_k - \sum_{j=1}^k \binom{k}{j} w_j x_{k-j}) / w_0 \f$. \f$ O(n k^2) \f$
/// \tparam M one more than the dimension of \f$ x \f$, or 0
/// \throws Error `zero_weight` when \f$ w_0 = 0 \f$, `jet_order_too_low` for an empty jet
template <class FT, int M> Coordinate_jet<FT, (M == 0 ? 0 : M - 1)> project(const Coordinate_jet<FT, M>& p) {
  if (p.order() < 0) throw Error(Error_code::jet_order_too_low, "project");
  const int n = p.dimension() - 1;
  Coordinate_jet<FT, (M == 0 ? 0 : M - 1)> x(n, p.order(), internal::Unspecified());
  internal::Work_meter* const work = internal::scope_of<FT>();
  std::size_t words = 1; // of the denominators
  if (work) {
    for (int k = 0; k <= p.order(); ++k) words = (std::max)(words, internal::number_words(p[k][n]));
    work->charge_fractions(n * (p.order() + 1.), words); // the first of each of the sums
  }
  if (internal::project_short<FT>(p, n, p.order(), x)) return x;
  internal::require_denominator(p[0][n], "the denominator of a rational curve");
  const FT inverse = FT(FT(1) / p[0][n]);
  internal::for_each_binomial_row<FT>(p.order(), [&](int k, const auto& binomial) {
    for (int i = 0; i < n; ++i) {
      if (work && k > 0) work->charge_fractions(k / 2., internal::number_words(x[k - 1][i]), words);
      FT sum = p[k][i];
      for (int j = 1; j <= k; ++j) sum -= binomial[j] * p[j][n] * x[k - j][i];
      x[k][i] = FT(sum * inverse);
    }
  });
  return x;
}

/// \ingroup PkgGeometricContinuityLocal
/// Returns the jet of the homogeneous points \f$ (p, w) \f$ of a curve from that of \f$ x = p / w \f$ and the derivatives
/// \f$ w_0, w_1, \dots \f$ of the denominator, which may be chosen freely:
/// \f$ p_k = \sum_{j=0}^k \binom{k}{j} w_j x_{k-j} \f$. Derivatives of the denominator that are not given are zero.
/// \f$ O(n k^2) \f$
/// \param x the jet
/// \param weights a container of numbers
/// \throws Error `zero_weight` when \f$ w_0 \f$ is zero or missing, `jet_order_too_low` for an empty jet
template <class FT, int N, class Weights>
Coordinate_jet<FT, (N == 0 ? 0 : N + 1)> lift(const Coordinate_jet<FT, N>& x, const Weights& weights) {
  if (x.order() < 0) throw Error(Error_code::jet_order_too_low, "lift");
  const int n = x.dimension();
  Coordinate_jet<FT, (N == 0 ? 0 : N + 1)> p(n + 1, x.order());
  int given = 0;
  for (const FT& w : weights)
    if (given <= x.order()) p[given++][n] = w;
  internal::require_denominator(p[0][n], "the denominator of a rational curve");
  internal::for_each_binomial_row<FT>(x.order(), [&](int k, const auto& binomial) {
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i < n; ++i) p[k][i] += binomial[j] * p[j][n] * x[k - j][i];
  });
  return p;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_HOMOGENEOUS_JETS_H
