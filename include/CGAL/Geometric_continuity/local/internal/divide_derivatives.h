// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_DIVIDE_DERIVATIVES_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_DIVIDE_DERIVATIVES_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/internal/for_each_index.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/local/internal/Short_vector.h>
#include <CGAL/Geometric_continuity/numbers/internal/number_rows.h>

#include <array>
#include <type_traits>

/// \file divide_derivatives.h
/// From the derivatives of homogeneous points (p, w) to those of x = p / w.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Calls f(k, binomials) for k = 0, ..., order, with the row C(k, 0), ..., C(k, k) of Pascal's
// triangle.
template <class FT, class Function> void for_each_binomial_row(int order, Function f) {
  Short_vector<FT, 6> row(order + 1, FT(0));
  row[0] = FT(1);
  for (int k = 0; k <= order; ++k) {
    for (int j = k; j > 0; --j) row[j] += row[j - 1];
    f(k, row);
  }
}

template <class FT> void require_denominator(const FT& w, const char* place) {
  if (w == FT(0)) throw Error(Error_code::zero_weight, place);
}

// unreachable: computed by the compiler
constexpr int binomial(int k, int j) { return j == 0 ? 1 : binomial(k - 1, j - 1) * k / j; }

// x_l -= sum_{i=j}^l C(l,i) w_i x_{l-i}
template <int l, int j, class FT, class Value> CGAL_GC_FORCEINLINE void subtract_products(Value* x, const FT* w) {
  if constexpr (j <= l) {
    constexpr int factor = binomial(l, j);
    x[l] -= FT(FT(factor) * w[j]) * x[l - j];
    subtract_products<l, j + 1>(x, w);
  }
}
// Replaces the derivatives p_0, ..., p_k of a coordinate in x by those of x = p / w, for an order
// known at compile time, from l = 0 on. w holds w_1, ..., w_k at their places, and the inverse is 1
// / w_0. Recursion, since a compiler may refuse to inline long chains of lambda expressions.
template <int k, int l = 0, class FT, class Value>
CGAL_GC_FORCEINLINE void divide_derivatives(Value* x, const FT* w, const FT& inverse) {
  if constexpr (l <= k) {
    subtract_products<l, 1>(x, w);
    x[l] *= inverse;
    divide_derivatives<k, l + 1>(x, w, inverse);
  }
}

// The jet x of an order up to k from the derivatives p[0], ..., p[k] of homogeneous points: all
// coordinates together where they are in a register, otherwise one after the other.
template <int k, class FT, class Derivatives, class Jet>
CGAL_GC_FORCEINLINE void project_order(const Derivatives& p, int n, int order, Jet& x) {
  typedef std::decay_t<decltype(p[0])> Row;
  std::array<FT, k + 1> w;
  for_each_index<k + 1>([&](int j) CGAL_GC_FORCEINLINE_LAMBDA { w[j] = p[j][n]; });
  require_denominator(w[0], "the denominator of a rational curve");
  const FT inverse = FT(FT(1) / w[0]);
  if constexpr (std::is_same_v<Row, Row_vector<FT>>) {
    std::array<Row, k + 1> c;
    for_each_index<k + 1>([&](int j) CGAL_GC_FORCEINLINE_LAMBDA { c[j] = p[j]; });
    divide_derivatives<k>(c.data(), w.data(), inverse);
    for_each_index<k + 1>([&](int j) CGAL_GC_FORCEINLINE_LAMBDA {
      if (j <= order)
        for_each_index<3>([&](int i) CGAL_GC_FORCEINLINE_LAMBDA {
          if (i < n) x[j][i] = c[j][i];
        });
    });
  } else
    for (int i = 0; i < n; ++i) {
      std::array<FT, k + 1> c;
      for_each_index<k + 1>([&](int j) CGAL_GC_FORCEINLINE_LAMBDA { c[j] = p[j][i]; });
      divide_derivatives<k>(c.data(), w.data(), inverse);
      for_each_index<k + 1>([&](int j) CGAL_GC_FORCEINLINE_LAMBDA {
        if (j <= order) x[j][i] = c[j];
      });
    }
}

// Divides the derivatives if the order is at most 3, and otherwise does nothing.
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
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_DIVIDE_DERIVATIVES_H
