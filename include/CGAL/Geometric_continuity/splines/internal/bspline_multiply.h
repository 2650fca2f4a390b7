// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_BSPLINE_MULTIPLY_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_BSPLINE_MULTIPLY_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/numbers/internal/number_rows.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/splines/internal/bspline_spans.h>
#include <CGAL/Geometric_continuity/splines/internal/check_spline.h>

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>
#include <vector>

/// \file bspline_multiply.h
/// Products of splines on rows of numbers: Bernstein products on the spans, and then the
/// coefficients over the knots of the result. Elevation is the product with 1.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class FT> constexpr FT binomial_coefficient(int n, int i) {
  FT b(1);
  for (int j = 0; j < i; ++j) b = FT(b * FT(n - j) / FT(j + 1));
  return b;
}

// B_i^p B_j^q = C(p,i) C(q,j) / C(p+q,i+j) B_{i+j}^{p+q}: the factor is number (q + 1) i + j.
template <class Weights, class FT> constexpr void assign_product_weights(int p, int q, Weights& w) {
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j <= q; ++j)
      w[(q + 1) * i + j] =
          FT(binomial_coefficient<FT>(p, i) * binomial_coefficient<FT>(q, j) / binomial_coefficient<FT>(p + q, i + j));
}

// These factors, at compile time unless P is -1.
template <class FT, int P, int Q> struct Product_weights {
  // unreachable: computed by the compiler
  static constexpr std::array<FT, (P + 1) * (Q + 1)> computed() {
    std::array<FT, (P + 1) * (Q + 1)> weights{};
    assign_product_weights<std::array<FT, (P + 1) * (Q + 1)>, FT>(P, Q, weights);
    return weights;
  }
  static constexpr std::array<FT, (P + 1) * (Q + 1)> w = computed();

  Product_weights(int, int) {}
};
template <class FT> struct Product_weights<FT, -1, -1> {
  std::vector<FT> w;

  Product_weights(int p, int q) : w((p + 1) * (q + 1)) { assign_product_weights<std::vector<FT>, FT>(p, q, w); }
};

// A coefficient as a row of numbers.
template <class Value> struct Fixed_dimension : std::integral_constant<int, 1> {};
template <class FT, int N> struct Fixed_dimension<Coordinate_vector<FT, N>> : std::integral_constant<int, N> {};

template <class Coefficients> struct Rows_of_coefficients {
  typedef typename Coefficients::value_type Value;
  const Coefficients& c;

  void operator()(int i, Value* row) const { *row = c[i]; }
  template <class FT> void operator()(int i, FT* row) const {
    std::copy(c[i].begin(), c[i].end(), row);
    constexpr int dimension = Fixed_dimension<Value>::value, length = row_length_v<FT, dimension>;
    if constexpr (length > dimension) row[dimension] = FT(0);
  }
};

// Writes rows of numbers as coefficients, one after the other.
template <class FT, class Value> struct Write_coefficients {
  int dimension;
  Value* next;

  CGAL_GC_FORCEINLINE void operator()(const FT* row) {
    if constexpr (std::is_same_v<Value, FT>)
      *next = *row;
    else
      for (int i = 0; i < dimension; ++i) (*next)[i] = row[i];
    ++next;
  }
};

// work.run<p, q>() where both degrees are small and the arithmetic is that of the processor, and
// else work.run<-1, -1>().
template <class FT, int P = 1, int Q = 1, class Work> void run_with_degrees(int p, int q, Work work) {
  constexpr int most_unrolled = std::is_floating_point_v<FT> ? 3 : 0;
  if constexpr (P > most_unrolled || Q > most_unrolled)
    work.template run<-1, -1>();
  else if (p != P)
    run_with_degrees<FT, P + 1, Q>(p, q, work);
  else if (q != Q)
    run_with_degrees<FT, P, Q + 1>(p, q, work);
  else
    work.template run<P, Q>();
}

// The Bernstein coefficients of the product on a span: `weighted` are the factor's coefficients
// times the product weights, `b` the rows of the other spline.
template <int N, class FT> void multiply_on_span(const FT* weighted, const FT* b, int p, int q, int n, FT* rows) {
  std::fill_n(rows, (p + q + 1) * n, FT(0));
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j <= q; ++j)
      multiply_row<N, Row_update::add>(weighted[(q + 1) * i + j], b + n * j, n, rows + n * (i + j));
}

// The product on a span, written out: term number I of the coefficient K, and those that follow.
template <int P, int Q, int N, int K = 0, int I = 0, class FT>
CGAL_GC_FORCEINLINE void multiply_on_span(const FT* weighted, const FT* b, FT* rows) {
  constexpr int first = K > Q ? K - Q : 0, last = K < P ? K : P;
  if constexpr (I < first)
    multiply_on_span<P, Q, N, K, first>(weighted, b, rows);
  else if constexpr (I <= last) {
    multiply_row<N, (I > first ? Row_update::add : Row_update::assign)>(weighted[Q * I + K], b + N * (K - I), N,
                                                                        rows + N * K);
    multiply_on_span<P, Q, N, K, I + 1>(weighted, b, rows);
  } else if constexpr (K < P + Q)
    multiply_on_span<P, Q, N, K + 1>(weighted, b, rows);
}

// See product_knots().
template <class FT> Distinct_knots<FT> distinct_product_knots(const Knot_vector<FT>& f, const Knot_vector<FT>& g) {
  if (!f.has_domain_of(g)) throw Error(Error_code::parameter_outside_domain, "B-spline product: the domains differ");
  const int p = f.degree(), q = g.degree();
  const FT *x = f.knots().data() + p, *y = g.knots().data() + q, &start = *x, &end = f[f.number_of_coefficients()];
  Distinct_knots<FT> t(p + q, f.number_of_coefficients() - p + g.number_of_coefficients() - q);
  t.append(start, p + q + 1);
  while (*x == start) ++x;
  while (*y == start) ++y;
  while (*x < end || *y < end) {
    const FT &a = *y < *x ? *y : *x, *const x_before = x, *const y_before = y;
    while (*x == a) ++x;
    while (*y == a) ++y;
    t.append(a, static_cast<int>((std::max)(x > x_before ? x - x_before + q : 0, y > y_before ? y - y_before + p : 0)));
  }
  t.append(end, p + q + 1);
  return t;
}

// See elevated_knots().
template <class FT> Distinct_knots<FT> distinct_elevated_knots(const Knot_vector<FT>& knots, int times) {
  if (times < 0)
    throw Error(Error_code::negative_count, "elevated_knots: the degree raised by " + std::to_string(times));
  const int d = knots.degree() + times;
  const FT *x = knots.knots().data() + knots.degree(), &start = *x, &end = knots[knots.number_of_coefficients()];
  Distinct_knots<FT> t(d, knots.number_of_coefficients() - knots.degree() + 1);
  t.append(start, d + 1);
  while (*x == start) ++x;
  while (*x < end) {
    const FT* const before = x;
    while (*x == *before) ++x;
    t.append(*before, static_cast<int>(x - before) + times);
  }
  t.append(end, d + 1);
  return t;
}

// The product over t = distinct_product_knots(u, v) of the splines over u, with numbers, and over
// v. Coefficients come from f(i, row) and g(i, row), and those of the product go to output(row),
// one after the other.
template <int Dimension, class FT, class F, class G, class Output> struct Multiply_splines {
  const Distinct_knots<FT>& t;
  const Knot_vector<FT>& u;
  F f;
  const Knot_vector<FT>& v;
  G g;
  int dimension;
  Output& output;

  template <int P, int Q> void run() const {
    const int p = P < 0 ? u.degree() : P, q = Q < 0 ? v.degree() : Q, n = row_length<FT, Dimension>(dimension);
    const Product_weights<FT, P, Q> weights(p, q);
    constexpr int size = P < 0 ? 0 : (P + 1) * (Q + 1), degree = P < 0 ? -1 : P + Q;
    Numbers<FT, size> weighted;
    if constexpr (P < 0) weighted.resize((p + 1) * (q + 1));
    Bernstein_pieces<FT> pieces(t, n);
    FT* rows = pieces.rows.data();
    Bernstein_spans<FT, P, 1, F> a(u, 1, f);
    Bernstein_spans<FT, Q, Dimension, G> b(v, dimension, g);
    for (int s = 1; s <= pieces.spans; ++s, rows += n * (p + q + 1)) {
      a.next(pieces.knots[s].value);
      b.next(pieces.knots[s].value);
      for (int i = 0; i <= p; ++i)
        for (int j = 0; j <= q; ++j) weighted[(q + 1) * i + j] = FT(weights.w[(q + 1) * i + j] * a[i][0]);
      if constexpr (P >= 0 && Dimension > 0)
        multiply_on_span<P, Q, row_length_v<FT, Dimension>>(weighted.data(), b[0], rows);
      else
        multiply_on_span<row_length_v<FT, Dimension>>(weighted.data(), b[0], p, q, n, rows);
    }
    coefficients_from_pieces<degree, Dimension>(pieces, p + q, dimension, output);
  }
};

// The product with the constant 1, over t = distinct_elevated_knots(v, times).
template <int Dimension, class FT, class G, class Output> struct Elevate_spline {
  const Distinct_knots<FT>& t;
  const Knot_vector<FT>& v;
  G g;
  int dimension;
  Output& output;

  template <int P, int Q> void run() const {
    constexpr int degree = P < 0 ? -1 : P + Q;
    const int q = Q < 0 ? v.degree() : Q, p = P < 0 ? t.degree - q : P, n = row_length<FT, Dimension>(dimension);
    const Product_weights<FT, P, Q> weights(p, q);
    Bernstein_pieces<FT> pieces(t, n);
    FT* rows = pieces.rows.data();
    Bernstein_spans<FT, Q, Dimension, G> b(v, dimension, g);
    for (int s = 1; s <= pieces.spans; ++s, rows += n * (p + q + 1)) {
      b.next(pieces.knots[s].value);
      if constexpr (P >= 0 && Dimension > 0)
        multiply_on_span<P, Q, row_length_v<FT, Dimension>>(weights.w.data(), b[0], rows);
      else
        multiply_on_span<row_length_v<FT, Dimension>>(weights.w.data(), b[0], p, q, n, rows);
    }
    coefficients_from_pieces<degree, Dimension>(pieces, p + q, dimension, output);
  }
};

template <int Dimension, class FT, class F, class G, class Output>
void multiply_splines(const Distinct_knots<FT>& t, const Knot_vector<FT>& u, const F& f, const Knot_vector<FT>& v,
                      const G& g, int dimension, Output& output) {
  run_with_degrees<FT>(u.degree(), v.degree(),
                       Multiply_splines<Dimension, FT, F, G, Output>{t, u, f, v, g, dimension, output});
}
template <int Dimension, class FT, class G, class Output>
void elevate_spline(const Distinct_knots<FT>& t, const Knot_vector<FT>& v, const G& g, int dimension, Output& output) {
  run_with_degrees<FT>(t.degree - v.degree(), v.degree(),
                       Elevate_spline<Dimension, FT, G, Output>{t, v, g, dimension, output});
}

// The coefficients of the product over t = distinct_product_knots(f_knots, g_knots).
template <class FT, class Scalars, class Coefficients>
std::vector<typename Coefficients::value_type> product_over(const Distinct_knots<FT>& t, const Knot_vector<FT>& f_knots,
                                                            const Scalars& f, const Knot_vector<FT>& g_knots,
                                                            const Coefficients& g) {
  typedef typename Coefficients::value_type Value;
  std::vector<Value> c(t.number_of_coefficients(), g[0]);
  Write_coefficients<FT, Value> output{number_of_coordinates(g[0]), c.data()};
  multiply_splines<Fixed_dimension<Value>::value>(t, f_knots, Rows_of_coefficients<Scalars>{f}, g_knots,
                                                  Rows_of_coefficients<Coefficients>{g}, output.dimension, output);
  return c;
}

// The coefficients over t = distinct_elevated_knots(knots, times).
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> elevate_over(const Distinct_knots<FT>& t, const Knot_vector<FT>& knots,
                                                            const Coefficients& g) {
  typedef typename Coefficients::value_type Value;
  std::vector<Value> c(t.number_of_coefficients(), g[0]);
  Write_coefficients<FT, Value> output{number_of_coordinates(g[0]), c.data()};
  elevate_spline<Fixed_dimension<Value>::value>(t, knots, Rows_of_coefficients<Coefficients>{g}, output.dimension,
                                                output);
  return c;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_BSPLINE_MULTIPLY_H
