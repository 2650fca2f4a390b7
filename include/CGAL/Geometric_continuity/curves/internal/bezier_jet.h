// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_BEZIER_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_BEZIER_JET_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/internal/Coordinate_row.h>
#include <CGAL/Geometric_continuity/internal/for_each_index.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/internal/independent_iterations.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/local/internal/jet_of_differences.h>

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_OFF

/// \file bezier_jet.h
/// Jets of polynomial and of rational Bezier curves from their control points: coordinate(j, i) is
/// the i-th coordinate of the j-th point. They are written to `jet`, which has the dimension n.

namespace CGAL {
template <bool is_protected> class Interval_nt;

namespace Geometric_continuity {
namespace internal {

// Degree and order are known at compile time, and everything is unrolled by templates: then a
// compiler keeps the coefficients in registers, and vectorises a loop over many parameters around
// it.

// The forward difference of order m of c_0, ..., c_m; c is overwritten.
template <int m, class FT> CGAL_GC_FORCEINLINE FT forward_difference(FT* c) {
  if constexpr (m > 0) {
    for_each_index<m>([&](int i) CGAL_GC_FORCEINLINE_LAMBDA { c[i] = c[i + 1] - c[i]; });
    return forward_difference<m - 1, FT>(c);
  } else
    return c[0];
}

// Replaces the coefficient i of the level of de Casteljau's algorithm with m+1 coefficients by that
// of the next level, which is reckoned from e = c_(i+1) - c_i, on the left side as c_i + t e and on
// the right side as c_(i+1) - s e: rounded numbers give c_0 for t = 0 and c_m for t = 1, exactly.
template <class FT, class Coefficient>
CGAL_GC_FORCEINLINE void step_to_next_level(Coefficient* c, int i, int m, const FT& s, const FT& t,
                                            const Coefficient& e) {
  if (i < m / 2)
    c[i] += t * e;
  else
    c[i] = c[i + 1] - s * e;
}

// Does so for all i. This is no lambda expression, which a compiler may refuse to inline.
template <class FT, class Coefficient, int... i>
CGAL_GC_FORCEINLINE void steps_to_next_level(Coefficient* c, const FT& s, const FT& t, const Coefficient* e,
                                             std::integer_sequence<int, i...>) {
  (step_to_next_level(c, i, static_cast<int>(sizeof...(i)), s, t, e[i]), ...);
}

// The differences of order j of the level of de Casteljau's algorithm with j+1 coefficients, for
// j = k, ..., 0. c holds the level with m+1.
template <int m, int k, class FT, class Coefficient>
CGAL_GC_FORCEINLINE void bernstein_differences(Coefficient* c, const FT& s, const FT& t, Coefficient* d) {
  if constexpr (m == 0)
    d[0] = c[0];
  else if constexpr (m == 1) {
    if constexpr (k > 0) d[1] = c[1] - c[0];
    d[0] = s * c[0] + t * c[1];
  } else {
    Coefficient e[m];
    for_each_index<m>([&](int i) CGAL_GC_FORCEINLINE_LAMBDA { e[i] = c[i + 1] - c[i]; });
    steps_to_next_level(c, s, t, e, std::make_integer_sequence<int, m>());
    if constexpr (m <= k) d[m] = forward_difference<m - 1, Coefficient>(e);
    bernstein_differences<m - 1, k>(c, s, t, d);
  }
}

// The derivatives at t = 1-s up to order k of the polynomial with the Bernstein coefficients c,
// each divided by n!/(n-j)!; those of higher order than n are zero. c is overwritten.
template <int n, int k, class FT, class Coefficient>
CGAL_GC_FORCEINLINE void bernstein_jet(std::array<Coefficient, n + 1>& c, const FT& s, const FT& t, Coefficient* d) {
  for (int j = n + 1; j <= k; ++j) d[j] = FT(0) * c[0];
  bernstein_differences<n, (k < n ? k : n)>(c.data(), s, t, d);
}

// Splits the polynomial of degree n with the Bernstein coefficients c at t = 1-s: c becomes the
// right part. The numbers are those of bernstein_split() for a degree known at run time only,
// algebra/Bernstein_polynomial.h.
template <int n, class FT> CGAL_GC_FORCEINLINE void bernstein_split(FT* c, const FT& s, const FT& t, FT* left) {
  left[0] = c[0];
  if constexpr (n > 0) {
    for_each_index<n>([&](int j) CGAL_GC_FORCEINLINE_LAMBDA { c[j] = s * c[j] + t * c[j + 1]; });
    bernstein_split<n - 1>(c, s, t, left + 1);
  }
}

// The factors n!/(n-j)! / h^j of the derivatives of order j = 0, ..., k with respect to a parameter
// on an interval of length h.
template <int k, class FT> CGAL_GC_FORCEINLINE std::array<FT, k + 1> derivative_factors(int n, const FT& h) {
  std::array<FT, k + 1> f;
  f[0] = FT(1);
  if constexpr (k > 0) {
    const FT inverse = FT(FT(1) / h);
    for_each_index<k>(
        [&](int j) CGAL_GC_FORCEINLINE_LAMBDA { f[j + 1] = j < n ? FT(f[j] * FT(FT(n - j) * inverse)) : FT(0); });
  }
  return f;
}

// Tells whether jets of low order are unrolled: for a degree known at compile time, and else for
// numbers with which that pays; for intervals as for the floating-point numbers whose rounding
// errors they enclose.
template <class FT> struct Is_floating_point_or_interval : std::is_floating_point<FT> {};
template <bool is_protected> struct Is_floating_point_or_interval<Interval_nt<is_protected>> : std::true_type {};
template <class FT, int Degree> constexpr bool unrolls_jets = Degree >= 0 || Is_floating_point_or_interval<FT>::value;

// A jet of order k of a Bezier curve: for a small one of fixed(a constant that is at least k),
// where the degree is fixed k itself, if that is unrolled; otherwise any().
template <class FT, int Degree, class Fixed, class Any> auto with_largest_order(int k, Fixed fixed, Any any) {
  typedef std::integral_constant<int, 3> Three;
  if constexpr (!unrolls_jets<FT, Degree>)
    return any();
  else if constexpr (Degree < 0)
    return k <= 3 ? fixed(Three()) : any();
  else
    switch (k) {
    case 0: return fixed(std::integral_constant<int, 0>());
    case 1: return fixed(std::integral_constant<int, 1>());
    case 2: return fixed(std::integral_constant<int, 2>());
    case 3: return fixed(Three());
    default: return any();
    }
}

// For the curves below, Level and k are known at compile time, and N is n, or 0 when n is known at
// run time only. The coordinates belong to the level of de Casteljau's algorithm at u with Level +
// 1 points; the first one of a curve has Level == degree. The jet has the given order, which is not
// higher than k.
template <int Level, int k, int N, class FT, class Coordinate, class Jet>
CGAL_GC_FORCEINLINE void bezier_jet(int dimension, int degree, const FT& u, const FT& a, const FT& b,
                                    const Coordinate& coordinate, int order, Jet& jet) {
  const FT h = FT(b - a), t = FT((u - a) / h), s = FT(FT(1) - t);
  const std::array<FT, k + 1> factors = derivative_factors<k>(degree, h);
  const int n = N == 0 ? dimension : N;
  CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
  for (int i = 0; i < n; ++i) {
    std::array<FT, Level + 1> c;
    for_each_index<Level + 1>([&](int j) CGAL_GC_FORCEINLINE_LAMBDA { c[j] = coordinate(j, i); });
    std::array<FT, k + 1> d;
    bernstein_jet<Level, k>(c, s, t, d.data());
    jet[0][i] = d[0];
    for_each_index<k>([&](int j) CGAL_GC_FORCEINLINE_LAMBDA {
      if (j < order) jet[j + 1][i] = FT(factors[j + 1] * d[j + 1]);
    });
  }
}

// Computes the jet of a rational curve, from its homogeneous points of dimension n + 1, see
// homogeneous_point().
template <int Level, int k, int N, class FT, class Coordinate, class Jet>
CGAL_GC_FORCEINLINE void rational_bezier_jet(int dimension, int degree, const FT& u, const FT& a, const FT& b,
                                             const Coordinate& coordinate, int order, Jet& jet) {
  constexpr int M = N == 0 ? 0 : N + 1;
  std::array<Coordinate_row<FT, M>, k + 1> p;
  if constexpr (is_register_row_v<FT, M>) {
    const FT h = FT(b - a), t = FT((u - a) / h), s = FT(FT(1) - t);
    const std::array<FT, k + 1> factors = derivative_factors<k>(degree, h);
    std::array<Coordinate_row<FT, M>, Level + 1> c;
    for (int j = 0; j <= Level; ++j) c[j] = coordinate_row<FT, M>(M, [&](int i) { return coordinate(j, i); });
    bernstein_jet<Level, k>(c, s, t, p.data());
    for_each_index<k>([&](int j) CGAL_GC_FORCEINLINE_LAMBDA { p[j + 1] *= factors[j + 1]; });
  } else {
    p.fill(Coordinate_vector<FT, M>(dimension + 1));
    bezier_jet<Level, k, M>(dimension + 1, degree, u, a, b, coordinate, k, p);
  }
  project_order<k, FT>(p, dimension, order, jet);
}

// Calls f with the degree as a constant. For a degree that is known at run time only, f is compiled
// for 0 to 9; returns false, without a call, for higher ones.
template <int Degree, class Function> CGAL_GC_FORCEINLINE bool with_constant_degree(int degree, const Function& f) {
  if constexpr (Degree >= 0)
    return f(std::integral_constant<int, Degree>()), true;
  else
    switch (degree) {
    case 0: return f(std::integral_constant<int, 0>()), true;
    case 1: return f(std::integral_constant<int, 1>()), true;
    case 2: return f(std::integral_constant<int, 2>()), true;
    case 3: return f(std::integral_constant<int, 3>()), true;
    case 4: return f(std::integral_constant<int, 4>()), true;
    case 5: return f(std::integral_constant<int, 5>()), true;
    case 6: return f(std::integral_constant<int, 6>()), true;
    case 7: return f(std::integral_constant<int, 7>()), true;
    case 8: return f(std::integral_constant<int, 8>()), true;
    case 9: return f(std::integral_constant<int, 9>()), true;
    default: return false;
    }
}

// Calls f(level, coordinate) for one of the two functions above, for points of dimension M, where
// level is the degree as a constant; for a degree above 9 that is known at run time only, the level
// of degree 9 is computed first.
template <int Degree, int M, class FT, class Coordinate, class Function>
CGAL_GC_FORCEINLINE void with_constant_level(int dimension, int degree, const FT& u, const FT& a, const FT& b,
                                             const Coordinate& coordinate, const Function& f) {
  if (with_constant_degree<Degree>(degree, [&](auto level) { f(level, coordinate); })) return;
  const FT t = FT((u - a) / FT(b - a)), s = FT(FT(1) - t);
  std::vector<Coordinate_vector<FT, M>> c(degree + 1, Coordinate_vector<FT, M>(dimension));
  for (int j = 0; j <= degree; ++j)
    for (int i = 0; i < dimension; ++i) c[j][i] = coordinate(j, i);
  for (int m = degree; m > 9; --m)
    for (int i = 0; i < m; ++i) step_to_next_level(c.data(), i, m, s, t, c[i + 1] - c[i]);
  f(std::integral_constant<int, 9>(), [&](int j, int i) { return c[j][i]; });
}

// Splits a curve with the points `right` at the local parameter t, which become those of the right
// part.
template <int Degree, class FT, class Rows>
CGAL_GC_FORCEINLINE void bezier_split(Rows& right, int degree, const FT& t, Rows& left) {
  if constexpr (Is_floating_point_or_interval<FT>::value) {
    const FT s = FT(FT(1) - t);
    if (with_constant_degree<Degree>(degree, [&](auto m) {
          for (int i = 0; i < right[0].dimension(); ++i) {
            std::array<FT, m + 1> c, d;
            for_each_index<m + 1>([&](int j) CGAL_GC_FORCEINLINE_LAMBDA { c[j] = right[j][i]; });
            bernstein_split<m>(c.data(), s, t, d.data());
            for_each_index<m + 1>([&](int j) CGAL_GC_FORCEINLINE_LAMBDA { left[j][i] = d[j]; });
            for_each_index<m + 1>([&](int j) CGAL_GC_FORCEINLINE_LAMBDA { right[j][i] = c[j]; });
          }
        }))
      return;
  }
  bernstein_split(right, degree, t, left);
}

// All coordinates together where their number is known to the compiler, otherwise one after the
// other.
template <int Degree, int N, class FT, class Coordinate, class Jet>
void bezier_jet_of_any_order(int dimension, int degree, const FT& u, const FT& a, const FT& b, int k,
                             const Coordinate& coordinate, Jet& jet) {
  constexpr int width = N == 0 ? 1 : N;
  typedef Coordinate_vector<FT, width> Block;
  const FT h = FT(b - a), t = FT((u - a) / h), inverse = FT(FT(1) / h);
  for (int first = 0; first < dimension; first += width) {
    Bezier_coefficients<Degree, Block> c;
    if constexpr (Degree < 0) c.resize(degree + 1);
    for (int j = 0; j <= degree; ++j)
      for (int i = 0; i < width; ++i) c[j][i] = coordinate(j, first + i);
    FT scale(1);
    bernstein_derivatives(c, degree, t, k, [&](int j, const Block& x) {
      for (int i = 0; i < width; ++i) jet[j][first + i] = scale * x[i];
      scale *= inverse;
    });
  }
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_ON

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_BEZIER_JET_H
