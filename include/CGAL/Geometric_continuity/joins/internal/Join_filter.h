// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_FILTER_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_FILTER_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_equations.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_grid.h>
#include <CGAL/Geometric_continuity/numbers/internal/Rounding_bound.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

constexpr int join_questions = 10;

// For each form, its error when all differences and all integer factors have the bound 1.
//
// Let the differences a_k, b_k and the factors have bounds A_k, B_k, w instead. Each form is a sum
// of products of these numbers, and so is the bound of its error: the very same products of A_k,
// B_k, w with nonnegative factors, because the error of each of the three operations is at most a
// multiple of the bounds of its result. The sum is therefore at most the error for bounds 1 times
// the largest of these products.
//
// The differences are computed from the first differences l of the polygon, each of which is
// rounded once: |l| <= L gives |a1| <= L, |a2| <= 2 L, |a3| <= 4 L. So first differences of at most
// 1, 1/2 and 1/4 give differences with bound 1.
struct Join_rounding {
  std::array<double, join_questions> error{};

  // unreachable: computed by the compiler
  constexpr Join_rounding() {
    const Rounding_bound d1 = difference(1), d2 = difference(0.5) - difference(0.5),
                         d3 = (difference(0.25) - difference(0.25)) - (difference(0.25) - difference(0.25));
    const Differences<Rounding_bound, 3> d{{{d1, d1, d1}, {d2, d2, d2}, {d3, d3, d3}}};
    record_geometric(d, Degree_factors<int>{1, 1, 1, 1, 1});
    const Parametric_degree_factors<int> units{1, 1, 1, 1, 1, 1};
    const Join_equations<Rounding_bound, 3, Parametric_degree_factors<int>, Join_rounding> parametric(d, d, units,
                                                                                                      *this);
    (void)parametric.derivatives_equal<1>();
    (void)parametric.derivatives_equal<2>();
    (void)parametric.derivatives_equal<3>();
    add_margin();
  }

  // For ends with weights: differences that are rounded once, and rounded factors.
  template <class Weights> constexpr explicit Join_rounding(const Weights& w) {
    const Rounding_bound x = difference(1);
    record_geometric(Differences<Rounding_bound, 3>{{{x, x, x}, {x, x, x}, {x, x, x}}}, w);
    add_margin();
  }

  static constexpr bool exact = false;
  // unreachable: computed by the compiler
  constexpr bool operator()(Join_question form, const Rounding_bound& x) {
    double& e = error[static_cast<int>(form)];
    if (e < x.error) e = x.error;
    return true;
  }

private:
  // unreachable: computed by the compiler
  template <class Weights> constexpr void record_geometric(const Differences<Rounding_bound, 3>& d, const Weights& w) {
    const Join_equations<Rounding_bound, 3, Weights, Join_rounding> geometric(d, d, w, *this);
    const Join_ratio<Rounding_bound> ratio = geometric.ratio();
    (void)geometric.tangents_parallel();
    (void)geometric.g2(ratio);
    (void)geometric.g3(ratio);
    (void)geometric.f3(ratio);
    (void)geometric.curvature_vectors_equal();
    (void)geometric.torsions_equal();
  }
  // for the roundings in the bounds themselves and for underflow, see Join_filter
  // unreachable: computed by the compiler
  constexpr void add_margin() {
    for (double& e : error) e *= 1 + 0x1p-20;
  }
  static constexpr Rounding_bound difference(double bound) { return Rounding_bound(bound, 0x1p-52 * bound); }
};

// For the differences of polygons.
struct Rounding_of_differences {
  // unreachable: computed by the compiler
  static constexpr Join_rounding value() { return Join_rounding(); }
};

// Bounds of the differences of order 1 to 3, nondecreasing.
struct Difference_bounds {
  double d1, d2, d3;
};

// Says of the value of a form in floating-point arithmetic whether the exact value may be zero.
// \pre `in_range()` `Rounding` gives the errors of the differences.
template <class Weights, class Rounding = Rounding_of_differences> struct Join_filter {
  const Difference_bounds &A, &B;
  const Weights& w;

  // All bounds lie within 2^-100 and 2^100, the factors within 1 (or 0) and 2^40. No product of at
  // most seven differences and the factors overflows. A product x y that underflows brings an error
  // of at most 2^-1074, less than 2^-300 times the error 2^-52 X Y that is allowed for, since X
  // Y >= 2^-700.
  CGAL_GC_FORCEINLINE bool in_range() const {
    return 0x1p-100 <= A.d1 && 0x1p-100 <= B.d1 && A.d3 <= 0x1p100 && B.d3 <= 0x1p100;
  }

  static constexpr bool exact = false;
  CGAL_GC_FORCEINLINE bool operator()(Join_question form, double x) const {
    constexpr Join_rounding rounding = Rounding::value();
    return !(std::abs(x) > rounding.error[static_cast<int>(form)] * largest_product(form));
  }

  // The exact value of a form that may be zero is smaller than 2 to this power: at most twice its
  // error.
  CGAL_GC_FORCEINLINE int exponent_of_bound(Join_question form) const {
    constexpr Join_rounding rounding = Rounding::value();
    return binary_exponent(rounding.error[static_cast<int>(form)] * largest_product(form)) + 2;
  }

private:
  CGAL_GC_FORCEINLINE double largest_product(Join_question form) const {
    const double a = A.d1, b = B.d1;
    if constexpr (std::is_same_v<Weights, Parametric_degree_factors<double>>) switch (form) {
      case Join_question::c1: return (std::max)(w.a1 * A.d1, w.b1 * B.d1);
      case Join_question::c2: return (std::max)(w.a2 * A.d2, w.b2 * B.d2);
      default: return (std::max)(w.a3 * A.d3, w.b3 * B.d3);
      }
    else {
      const double second = (std::max)(w.b2 * (a * a) * B.d2, w.a2 * (b * b) * A.d2);
      switch (form) {
      case Join_question::g1: return a * b;
      case Join_question::g2: return a * second;
      case Join_question::g3: {
        double v = second;
        if constexpr (Weights::rational) v = (std::max)(v, w.first * (a * b) * (std::max)(a, b));
        return a * (std::max)((std::max)(w.b3 * (a * a * a * a) * B.d3, w.a3 * (a * b * b * b) * A.d3),
                              w.mix * (b * A.d2) * v);
      }
      case Join_question::f3: return a * A.d2 * (std::max)(w.b3 * (a * a * a) * B.d3, w.a3 * (b * b * b) * A.d3);
      case Join_question::curvature_vector: return a * a * b * b * second;
      default: return a * A.d2 * (b * B.d2) * (std::max)(w.a3 * A.d3 * (b * B.d2), w.b3 * B.d3 * (a * A.d2));
      }
    }
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_FILTER_H
