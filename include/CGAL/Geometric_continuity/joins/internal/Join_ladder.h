// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_LADDER_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_LADDER_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_input.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

/// \file Join_ladder.h
/// The stages by which a question about a join is decided on two ends (Join_input.h), from the
/// cheapest to the one that is left: signs, a rounded form that exceeds its error, residues of a
/// form that is smaller than the modulus. Each answers, or `unknown`. What all of them leave open
/// is decided in numbers of any length (decide_in_ring.h).

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Returns whether all coordinates but the first are zero.
template <class T> CGAL_GC_FORCEINLINE bool is_on_axis(const std::array<T, 2>& x) { return x[1] == 0; }
template <class T> CGAL_GC_FORCEINLINE bool is_on_axis(const std::array<T, 3>& x) { return x[1] == 0 && x[2] == 0; }

// Decides by the signs of the first differences. Where the tangents run along the same axis, as
// most at the smooth joins of drawings do, nothing is left to ask for G1.
template <Join_question question, class T, std::size_t N>
CGAL_GC_FORCEINLINE Join_answer decide_by_signs(const std::array<T, N>& a1, const std::array<T, N>& b1) {
  const T x = a1[0], y = b1[0];
  if constexpr (is_geometric(question)) {
    if (!((x < 0 && y < 0) || (0 < x && 0 < y))) return Join_answer::no;
    if constexpr (question == Join_question::g1)
      if (is_on_axis(a1) && is_on_axis(b1)) return Join_answer::yes;
    return Join_answer::unknown;
  } else
    return x == 0 || (y == 0 && is_on_axis(b1)) ? Join_answer::undefined : Join_answer::unknown;
}

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// On ends whose rounded forms have passed the filter: a whole number that is divisible by 2^s and
// smaller than 2^s is 0.
//
// Let all differences be multiples of a unit 2^g, and the factors of a form be whole numbers w
// times a power of two. In units they are whole numbers, the differences of points with 53
// bits: |a1| <= 2^54, |a2| <= 2^55, |a3| <= 2^56. Factors are below their limits. What is shorter
// than the residues stays within its limbs: test_integer_lengths.cpp computes the bounds by the
// same equations. The bound that the filter proves for a form of degree d is divided by 2^(g d) and
// by the power of the factors. Forms of degree at most 2, and for polynomials the one for G2 with
// the limbs of a form of degree 6, are shorter than the residues anyway.
template <class Input, class Filter> class Residue_width {
  const Filter& filter_;
  int unit_;
  typename Input::Units units_;
  bool valid_;

public:
  CGAL_GC_FORCEINLINE Residue_width(const Input& join, const typename Input::Factors& w, const Filter& filter)
      : filter_(filter), valid_(join.find_unit((std::max)(filter.A.d3, filter.B.d3), unit_)) {
    if (valid_) units_ = join.units_of_factors(w);
  }

  CGAL_GC_FORCEINLINE bool valid() const { return valid_; }
  CGAL_GC_FORCEINLINE int unit() const { return unit_; }
  CGAL_GC_FORCEINLINE const typename Input::Units& units_of_factors() const { return units_; }
  CGAL_GC_FORCEINLINE const typename Input::Rounded_factors& rounded_factors() const { return filter_.w; }

  // Returns whether so many limbs suffice.
  CGAL_GC_FORCEINLINE bool fits(int limbs) const {
    constexpr Join_question question = Input::question;
    return (form_degree(question) <= 2 || fits(question, limbs)) &&
           (!Input::weighted || !is_geometric(question) || fits(Join_question::g2, limbs));
  }

private:
  CGAL_GC_FORCEINLINE bool fits(Join_question form, int limbs) const {
    return filter_.exponent_of_bound(form) - unit_ * form_degree(form) - units_(form) <= 64 * limbs;
  }
};

template <int limbs, class Input, class Factors, class Stages>
CGAL_GC_FORCEINLINE Join_answer decide_by_residues_with(const Factors& w, const Input& join, int unit, Stages& stages) {
  constexpr Join_question question = Input::question;
  constexpr int N = Input::dimension;
  typedef typename Input::template Integer<limbs> Integer;
  const Differences<Integer, N> a = join.template left_in<limbs>(unit), b = join.template right_in<limbs>(unit);
  const Modular_zero zero;
  const Join_equations<Integer, N, Factors, const Modular_zero> equations(a, b, w, zero);
  const auto decided = [&](Join_answer answer) {
    stages.decided(Stage::fixed_integer, answer);
    return answer;
  };
  if constexpr (question == Join_question::torsion)
    if (!equations.both_have_curvature()) return decided(Join_answer::undefined);
  if constexpr (question == Join_question::f3)
    // another form counts, without a bound
    if (!equations.left_has_curvature()) return Join_answer::unknown;
  return decided(all_hold<question>(equations) ? Join_answer::yes : Join_answer::no);
}
// Decides by residues of the least length that suffices. Long ones need much room, and are compiled
// apart. Those are called by value, since what they could read by reference would not stay in
// registers anywhere.
template <class Input, class Width, class Stages, int... limbs>
BOOST_NOINLINE Join_answer decide_by_long_residues(Input join, typename Input::Factors given, Width width,
                                                   Stages& stages, std::integer_sequence<int, limbs...>);
template <bool apart, class Input, class Width, class Stages, int limbs, int... more>
CGAL_GC_FORCEINLINE Join_answer decide_by_residues(const Input& join, const typename Input::Factors& given,
                                                   const Width& width, Stages& stages,
                                                   std::integer_sequence<int, limbs, more...>) {
  if (!width.fits(limbs)) {
    if constexpr (sizeof...(more) != 0)
      return decide_by_residues<apart>(join, given, width, stages, std::integer_sequence<int, more...>());
    else
      return Join_answer::unknown;
  }
  if constexpr (limbs > 4 && !apart)
    return decide_by_long_residues(join, given, width, stages, std::integer_sequence<int, limbs>());
  else {
    if constexpr (Input::template has_short_factors<limbs>) {
      Degree_factors<std::int64_t> w;
      if (join.short_factors(width.rounded_factors(), width.units_of_factors(), w))
        return decide_by_residues_with<limbs>(w, join, width.unit(), stages);
    }
    typename Input::template Integer_factors<limbs> w;
    if (!join.template integer_factors<limbs>(given, width.units_of_factors(), w)) return Join_answer::unknown;
    return decide_by_residues_with<limbs>(w, join, width.unit(), stages);
  }
}
template <class Input, class Width, class Stages, int... limbs>
BOOST_NOINLINE Join_answer decide_by_long_residues(Input join, typename Input::Factors given, Width width,
                                                   Stages& stages, std::integer_sequence<int, limbs...> length) {
  return decide_by_residues<true>(join, given, width, stages, length);
}

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// The ladder. Exact or `unknown`; that the ends meet is not asked here.
template <class Input, class Stages>
CGAL_GC_FORCEINLINE Join_answer decide_by_stages(const Input& join, Stages& stages) {
  constexpr Join_question question = Input::question;
  static_assert(highest_difference(question) > 0, "the points are compared before");
  if constexpr (!is_parametric(question)) {
    const Join_answer answer = decide_by_signs<question>(join.first_left(), join.first_right());
    if (answer != Join_answer::unknown) {
      stages.decided(Stage::comparison, answer);
      return answer;
    }
  }
  typename Input::Factors w;
  if (!join.find_factors(w)) {
    if (!stages.uses(Stage::floating_point) || !join.first_derivatives_differ()) return Join_answer::unknown;
    stages.decided(Stage::floating_point, Join_answer::no);
    return Join_answer::no;
  }
  if (!stages.uses(Stage::floating_point)) return Join_answer::unknown;
  constexpr int N = Input::dimension;
  typedef typename Input::Rounded_factors Factors;
  typedef Join_filter<Factors, typename Input::Rounding> Filter;
  const Difference_bounds A = join.left_bounds(), B = join.right_bounds();
  const Factors rounded = join.rounded_factors(w);
  const Filter filter{A, B, rounded};
  if (!filter.in_range()) return Join_answer::unknown;
  const Differences<double, N>&a = join.left(), &b = join.right();
  const Join_equations<double, N, Factors, const Filter> equations(a, b, rounded, filter);
  if (!all_hold<question>(equations)) {
    stages.decided(Stage::floating_point, Join_answer::no);
    return Join_answer::no;
  }
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  if (stages.uses(Stage::fixed_integer)) {
    const Residue_width<Input, Filter> width(join, w, filter);
    if (width.valid()) return decide_by_residues<false>(join, w, width, stages, typename Input::Limbs());
  }
#endif
  return Join_answer::unknown;
}

// Decides two ends with double coordinates by the ladder. The constructor reads them, with positive
// weights if these are asked for.
template <Join_question question, int N, bool weighted, class Left, class Right> class Join_reader {
  typedef Double_end_view<question, N, Left> Left_view;
  typedef Double_end_view<question, N, Right> Right_view;
  int pivot_;
  Left_view left_;
  Right_view right_;
  Short_lengths lengths_;

public:
  CGAL_GC_FORCEINLINE Join_reader(const Left& left, const Right& right)
      : pivot_(is_parametric(question) ? 0 : pivot_of<N>(left)), left_(left, pivot_), right_(right, pivot_) {
    if constexpr (is_parametric(question)) lengths_ = Short_lengths(left_.domain(), right_.domain());
  }
  CGAL_GC_FORCEINLINE Double_join<question, N, Left_view, Right_view> operator()() const {
    return {left_, right_, lengths_};
  }
};
template <Join_question question, int N, class Left, class Right>
class Join_reader<question, N, true, Left, Right> : Weighted_join<question, N, Left, Right> {
public:
  using Weighted_join<question, N, Left, Right>::Weighted_join;
  CGAL_GC_FORCEINLINE const Weighted_join<question, N, Left, Right>& operator()() const { return *this; }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_LADDER_H
