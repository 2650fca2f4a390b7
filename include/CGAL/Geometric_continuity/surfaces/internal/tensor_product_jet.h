// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_TENSOR_PRODUCT_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_TENSOR_PRODUCT_JET_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/internal/Coordinate_row.h>
#include <CGAL/Geometric_continuity/splines/internal/Spline_weights.h>
#include <CGAL/Geometric_continuity/splines/internal/change_knots.h>

#include <boost/container/small_vector.hpp>

#include <array>
#include <type_traits>
#include <vector>

/// \file tensor_product_jet.h
/// The derivatives of a tensor-product surface at one place from the control points that matter
/// there, with the coordinates coordinate(i, j, x), and from the weights of these in u and in v.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The weights of the p + 1 coefficients that matter in the derivatives of order 0 to k at t, one
// order after the other.
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

// The derivatives in v for each row of control points, then those in u. The order is Order, unless
// that is negative; then the sums are no local variables.
template <int Order, class FT, class Coordinate, class Jet>
void write_derivatives_of_order(const Derivative_table<FT>& u, const Derivative_table<FT>& v,
                                const Coordinate& coordinate, Jet& jet) {
  constexpr int N = dimension_v<typename Jet::Traits>, fixed = Order < 0 ? 0 : Order + 1;
  typedef Coordinate_row<FT, N> Row;
  const int n = Order < 0 ? jet.order() + 1 : Order + 1, d = jet.dimension();
  const Row zero = coordinate_row<FT, N>(d, [](int) { return FT(0); });
  std::conditional_t<(Order < 0), std::vector<Row>, std::array<Row, fixed>> sums;
  std::conditional_t<(Order < 0), std::vector<Row>, std::array<Row, fixed * fixed>> partials;
  if constexpr (Order < 0) {
    sums.resize(n);
    partials.assign(n * n, zero);
  } else
    partials.fill(zero);
  for (int l = 0; l <= u.degree(); ++l) {
    for (int j = 0; j < n; ++j) sums[j] = zero;
    for (int m = 0; m <= v.degree(); ++m) {
      const Row x = coordinate_row<FT, N>(d, [&](int i) { return coordinate(l, m, i); });
      for (int j = 0; j < n; ++j) sums[j] += v(j, m) * x;
    }
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) partials[n * i + j] += u(i, l) * sums[j];
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j)
      for (int x = 0; x < d; ++x) jet(i, j)[x] = partials[n * i + j][x];
}

template <class FT, class Coordinate, class Jet>
void write_derivatives(const Derivative_table<FT>& u, const Derivative_table<FT>& v, const Coordinate& coordinate,
                       Jet& jet) {
  switch (jet.order()) {
  case 0: return write_derivatives_of_order<0>(u, v, coordinate, jet);
  case 1: return write_derivatives_of_order<1>(u, v, coordinate, jet);
  case 2: return write_derivatives_of_order<2>(u, v, coordinate, jet);
  default: return write_derivatives_of_order<-1>(u, v, coordinate, jet);
  }
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_TENSOR_PRODUCT_JET_H
