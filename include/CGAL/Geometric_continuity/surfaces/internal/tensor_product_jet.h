// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_TENSOR_PRODUCT_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_TENSOR_PRODUCT_JET_H

#include <CGAL/Geometric_continuity/splines/bspline_knots.h>
#include <CGAL/Geometric_continuity/splines/internal/Spline_weights.h>

#include <boost/container/small_vector.hpp>

#include <array>
#include <type_traits>
#include <vector>

/// \file tensor_product_jet.h
/// The derivatives of a tensor-product surface at one place from the control points that matter there, point(i, j), and from the
/// weights of these in u and in v.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The weights of the p + 1 coefficients that matter in the derivatives of order 0 to k at t, one order after the other.
template <class FT> class Derivative_table {
  int p_;
  boost::container::small_vector<FT, 24> w_;

public:
  template <class Knots>
  Derivative_table(const Knots& knots, int p, int span, const FT& t, int k) : p_(p), w_((k + 1) * (p + 1), FT(0)) {
    with_degree_inside_span(knots, p, span, t, [&](auto degree) {
      derivative_weights<degree>(knots, p_, span, t, k, [&](int j, const auto& weights) {
        FT* const row = w_.data() + j * (p_ + 1);
        for (int i = 0; i <= (degree < 0 ? p_ : degree); ++i) row[i] = weights.w[i];
      });
    });
  }
  int degree() const { return p_; }
  const FT& operator()(int j, int i) const { return w_[j * (p_ + 1) + i]; }
};

// Adds the derivatives to a jet that is zero: first those in v for each row of control points, then those in u. The order is Order,
// unless that is negative; then the sums are no local variables.
template <int Order, class FT, class Point, class Jet>
void add_derivatives(const Derivative_table<FT>& u, const Derivative_table<FT>& v, const Point& point, Jet& jet) {
  const int p = u.degree(), q = v.degree(), k = jet.order();
  typedef std::decay_t<decltype(jet(0, 0))> Column;
  if constexpr (Order < 0) {
    for (int l = 0; l <= p; ++l) {
      std::vector<Column> sums(k + 1, Column(jet.dimension()));
      for (int m = 0; m <= q; ++m)
        for (int j = 0; j <= k; ++j) sums[j] += v(j, m) * point(l, m);
      for (int i = 0; i <= k; ++i)
        for (int j = 0; j <= k - i; ++j) jet(i, j) += u(i, l) * sums[j];
    }
  } else {
    std::array<std::array<Column, Order + 1>, Order + 1> partials;
    for (int i = 0; i <= Order; ++i)
      for (int j = 0; j <= Order - i; ++j) partials[i][j] = jet(i, j);
    for (int l = 0; l <= p; ++l) {
      std::array<Column, Order + 1> sums; // derivatives with respect to v
      for (int j = 0; j <= Order; ++j) sums[j] = jet(0, 0);
      for (int m = 0; m <= q; ++m) {
        const Column x = point(l, m);
        for (int j = 0; j <= Order; ++j) sums[j] += v(j, m) * x;
      }
      for (int i = 0; i <= Order; ++i)
        for (int j = 0; j <= Order - i; ++j) partials[i][j] += u(i, l) * sums[j];
    }
    for (int i = 0; i <= Order; ++i)
      for (int j = 0; j <= Order - i; ++j) jet(i, j) = partials[i][j];
  }
}

template <class FT, class Point, class Jet>
void write_derivatives(const Derivative_table<FT>& u, const Derivative_table<FT>& v, const Point& point, Jet& jet) {
  switch (jet.order()) {
  case 0: return add_derivatives<0>(u, v, point, jet);
  case 1: return add_derivatives<1>(u, v, point, jet);
  case 2: return add_derivatives<2>(u, v, point, jet);
  default: return add_derivatives<-1>(u, v, point, jet);
  }
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_TENSOR_PRODUCT_JET_H
