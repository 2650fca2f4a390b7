// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_ON_LONG_INTEGERS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_ON_LONG_INTEGERS_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/internal/join_on_doubles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// An end with integers as coordinates, all below 2^60 in absolute value: longer than those of doubles.
template <int N> struct Long_end {
  End_polygon<std::int64_t, N> points; // the last one repeated
  int degree;
  std::int64_t length; // of the domain, in units of both curves
};

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
constexpr int long_residue_limbs(Join_question question) {
  return form_degree(question) <= 2 ? 2 : form_degree(question) <= 4 ? 4 : 6;
}
#endif

// The decision on two ends with long integers, exact or `unknown`, by the stages of decide_on_doubles() and decide_modulo(). That the
// ends meet is not asked here. Legs are below 2^61, the differences below 2^61, 2^62 and 2^63, and legs become doubles by one
// rounding, as the filter expects.
template <Join_question question, int N, class Stages>
CGAL_GC_FORCEINLINE Join_answer decide_on_long_integers(const Long_end<N>& left, const Long_end<N>& right,
                                                        Stages& stages) {
  constexpr int k = highest_difference(question);
  typedef Join_weights_of<question, double> Weights;
  typedef Join_filter<Weights> Filter;
  const auto decided = [&](Join_stage stage, Join_answer answer) {
    stages.decided(stage, answer);
    return answer;
  };
  const int m = left.degree, n = right.degree;
  const Legs<std::int64_t, N> legs_a = legs_of<k>(left.points), legs_b = legs_of<k>(right.points);
  const int pivot = is_parametric(question) ? 0 : largest_coordinate(legs_a[0]);
  const Legs<double, N> rounded_a = converted<k, double>(legs_a), rounded_b = converted<k, double>(legs_b);
  if constexpr (!is_parametric(question)) {
    const std::array<double, N> zero{};
    const Join_answer by_signs = decide_by_signs<question>(internal::minus(zero, rounded_a[0]), rounded_b[0], pivot);
    if (by_signs != Join_answer::unknown) return decided(Join_stage::comparison, by_signs);
  }
  if ((std::max)(m, n) > 1000) return Join_answer::unknown;
  Join_weights_of<question, std::int64_t> w;
  if constexpr (is_parametric(question)) {
    if ((std::max)(left.length, right.length) > 1024) return Join_answer::unknown;
    w = Parametric_join_weights<std::int64_t>::of(m, n, left.length, right.length);
    if (!weights_fit<k>(w)) return Join_answer::unknown;
  } else
    w = Join_weights<std::int64_t>::template geometric<question>(m, n);
  const Difference_bounds A = bounds_of_differences<k>(rounded_a), B = bounds_of_differences<k>(rounded_b);
  const Weights weights = converted<double>(w);
  const Filter filter{A, B, weights};
  if (filter.in_range()) {
    const Differences<double, N> a = differences_of<k, true>(rounded_a, m), b = differences_of<k, false>(rounded_b, n);
    const Join_equations<double, N, Weights, const Filter> equations(a, b, weights, filter, pivot);
    if (!all_hold<question>(equations)) return decided(Join_stage::floating_point, Join_answer::no);
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
    constexpr int limbs = long_residue_limbs(question);
    typedef Fixed_integer<2, limbs> Integer; // leaves room for the factors
    const auto fits = [&](Join_question form) { return filter.exponent_of_bound(form) <= 64 * limbs; };
    if (!fits(question) || (highest_difference(question) == 3 && is_geometric(question) && !fits(Join_question::g2)))
      return Join_answer::unknown;
    const Differences<Integer, N> x = converted<k, Integer>(differences_of<k, true>(rotated<k>(legs_a, pivot), m)),
                                  y = converted<k, Integer>(differences_of<k, false>(rotated<k>(legs_b, pivot), n));
    const Modular_zero zero;
    const Join_equations<Integer, N, Join_weights_of<question, std::int64_t>, const Modular_zero> residues(x, y, w,
                                                                                                           zero);
    if constexpr (question == Join_question::torsion)
      if (!residues.both_have_curvature()) return decided(Join_stage::bounded_residue, Join_answer::undefined);
    if constexpr (question == Join_question::f3)
      if (!residues.left_has_curvature()) return Join_answer::unknown; // another form counts, without a bound
    return decided(Join_stage::bounded_residue, all_hold<question>(residues) ? Join_answer::yes : Join_answer::no);
#endif
  }
  return Join_answer::unknown;
}

// Whether the curvatures have different magnitudes, see curvatures_differ(). Only `true` is a proof.
template <int N> bool curvatures_differ(const Long_end<N>& left, const Long_end<N>& right) {
  const Join_weights<std::int64_t> w =
      Join_weights<std::int64_t>::template geometric<Join_question::g2>(left.degree, right.degree);
  typedef std::uint64_t Residue;
  Residue g, h;
  const Residue a = square_of_area<Residue, N>(converted<2, Residue>(legs_of<2>(left.points)), w.a2, g),
                b = square_of_area<Residue, N>(converted<2, Residue>(legs_of<2>(right.points)), w.b2, h);
  return a * (h * h * h) != b * (g * g * g);
}

// The shape parameters of such a join, which are to be computed when someone asks for them.
template <class FT, int N> Join_parameters<FT> parameters_of(const Long_end<N>& left, const Long_end<N>& right) {
  const int i = largest_coordinate(legs_of<1>(left.points)[0]);
  const auto along = [i](const Long_end<N>& end) {
    Double_end result{{}, 0, static_cast<double>(end.length), end.degree};
    for (int j = 0; j <= 3; ++j) {
      const std::int64_t x = end.points[j][i];
      result.points[j] = static_cast<double>(x);
      result.rests[j] = static_cast<double>(x - static_cast<std::int64_t>(result.points[j]));
    }
    return result;
  };
  return Join_parameters<FT>(along(left), along(right));
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_ON_LONG_INTEGERS_H
