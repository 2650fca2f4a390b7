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
/// The rungs by which a question about a join is decided on two ends (Join_input.h), from the cheapest to the one that is left: signs, a
/// rounded form that exceeds its error, residues of a form that is smaller than the modulus, integers of fixed length. Each answers, or
/// `unknown`. What all of them leave open is decided in numbers of any length (decide_in_ring.h).

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Whether all coordinates but one are zero.
template <class T, std::size_t N> CGAL_GC_FORCEINLINE bool is_on_axis(const std::array<T, N>& x, int axis) {
  for (int i = 0; i < static_cast<int>(N); ++i)
    if (i != axis && x[static_cast<std::size_t>(i)] != 0) return false;
  return true;
}

// By the signs of the first differences: the largest coordinate of the left one is the pivot. Where the tangents run along the same axis,
// as most at the smooth joins of drawings do, nothing is left to ask for G1.
template <Join_question question, class T, std::size_t N>
CGAL_GC_FORCEINLINE Join_answer decide_by_signs(const std::array<T, N>& a1, const std::array<T, N>& b1, int pivot) {
  const T x = coordinate_at(a1, pivot), y = coordinate_at(b1, pivot);
  if constexpr (is_geometric(question)) {
    if (!((x < 0 && y < 0) || (0 < x && 0 < y))) return Join_answer::no;
    if constexpr (question == Join_question::g1)
      if (is_on_axis(a1, pivot) && is_on_axis(b1, pivot)) return Join_answer::yes;
    return Join_answer::unknown;
  } else
    return x == 0 || (y == 0 && is_on_axis(b1, pivot)) ? Join_answer::undefined : Join_answer::unknown;
}

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// On ends whose rounded forms have passed the filter: a whole number that is divisible by 2^s and smaller than 2^s is 0.
//
// Let all differences be multiples of a unit 2^g, and the factors of a form be whole numbers w times a power of two. In units they are
// whole numbers, and what is shorter than the residues stays within its limbs, as in decide_on_grids(). The bound that the filter proves
// for a form of degree d is divided by 2^(g d) and by the power of the factors. Forms of degree at most 2, and for polynomials the one
// for G2 with the limbs of a form of degree 6, are shorter than the residues anyway.
template <class Input, class Filter> class Residue_room {
  const Filter& filter_;
  int unit_;
  typename Input::Units units_;
  bool valid_;

public:
  CGAL_GC_FORCEINLINE Residue_room(const Input& join, const typename Input::Factors& w, const Filter& filter)
      : filter_(filter), valid_(join.find_unit((std::max)(filter.A.d3, filter.B.d3), unit_)) {
    if (valid_) units_ = join.units_of_factors(w);
  }

  CGAL_GC_FORCEINLINE bool valid() const { return valid_; }
  CGAL_GC_FORCEINLINE int unit() const { return unit_; }
  CGAL_GC_FORCEINLINE const typename Input::Units& units_of_factors() const { return units_; }
  CGAL_GC_FORCEINLINE const typename Input::Rounded_factors& rounded_factors() const { return filter_.w; }

  // Whether so many limbs suffice.
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
CGAL_GC_FORCEINLINE Join_answer decide_by_residues_with(const Factors& w, const Input& join, int unit, int pivot,
                                                        Stages& stages) {
  constexpr Join_question question = Input::question;
  constexpr int N = Input::dimension;
  typedef typename Input::template Integer<limbs> Integer;
  const Differences<Integer, N> a = join.template left_in<limbs>(unit, pivot),
                                b = join.template right_in<limbs>(unit, pivot);
  const Modular_zero zero;
  const Join_equations<Integer, N, Factors, const Modular_zero> equations(a, b, w, zero);
  const auto decided = [&](Join_answer answer) {
    stages.decided(Join_stage::bounded_residue, answer);
    return answer;
  };
  if constexpr (question == Join_question::torsion)
    if (!equations.both_have_curvature()) return decided(Join_answer::undefined);
  if constexpr (question == Join_question::f3)
    if (!equations.left_has_curvature()) return Join_answer::unknown; // another form counts, without a bound
  return decided(all_hold<question>(equations) ? Join_answer::yes : Join_answer::no);
}
// By residues of the least length that suffices. Long ones need much room, and are compiled apart. That is called by value, since what it
// could read by reference would not stay in registers anywhere.
template <class Input, class Room, class Stages, int... limbs>
BOOST_NOINLINE Join_answer decide_by_long_residues(Input join, typename Input::Factors given, Room room, int pivot,
                                                   Stages& stages, std::integer_sequence<int, limbs...>);
template <bool apart, class Input, class Room, class Stages, int limbs, int... more>
CGAL_GC_FORCEINLINE Join_answer decide_by_residues(const Input& join, const typename Input::Factors& given,
                                                   const Room& room, int pivot, Stages& stages,
                                                   std::integer_sequence<int, limbs, more...>) {
  if (!room.fits(limbs)) {
    if constexpr (sizeof...(more) != 0)
      return decide_by_residues<apart>(join, given, room, pivot, stages, std::integer_sequence<int, more...>());
    else
      return Join_answer::unknown;
  }
  if constexpr (limbs > 4 && !apart)
    return decide_by_long_residues(join, given, room, pivot, stages, std::integer_sequence<int, limbs>());
  else {
    if constexpr (Input::template has_short_factors<limbs>) {
      Join_weights<std::int64_t> w;
      if (join.short_factors(room.rounded_factors(), room.units_of_factors(), w))
        return decide_by_residues_with<limbs>(w, join, room.unit(), pivot, stages);
    }
    typename Input::template Integer_factors<limbs> w;
    if (!join.template integer_factors<limbs>(given, room.units_of_factors(), w)) return Join_answer::unknown;
    return decide_by_residues_with<limbs>(w, join, room.unit(), pivot, stages);
  }
}
template <class Input, class Room, class Stages, int... limbs>
BOOST_NOINLINE Join_answer decide_by_long_residues(Input join, typename Input::Factors given, Room room, int pivot,
                                                   Stages& stages, std::integer_sequence<int, limbs...> length) {
  return decide_by_residues<true>(join, given, room, pivot, stages, length);
}

// (q, p) below a limit, so that the cubes with short factors take one limb. The types of the forms are shorter.
template <class Integer, class Factor> struct Short_join_ratio {
  typedef Integer Square, Cube;
  static constexpr std::int64_t limit = 1 << 12, factor_limit = 1 << 16;
  Factor q, p;
  static constexpr Square square(const Factor& x) { return Square(x * x); }
  static constexpr Cube cube(const Factor& x) { return Cube(x * x * x); }
  template <class V> constexpr V p_times(const V& v, const Factor& w) const { return scaled(v, p * w); }
};

// b/a, if it is a fraction with denominator 2^8 and a numerator below the limit
template <class Ratio> CGAL_GC_FORCEINLINE bool short_ratio(std::int64_t a, std::int64_t b, Ratio& r) {
  const double x = 256 * (static_cast<double>(b) / static_cast<double>(a));
  if (!(std::abs(x) < Ratio::limit)) return false;
  r.p = static_cast<std::int64_t>(x);
  r.q = 256;
  return static_cast<Signed_128>(r.p) * a == static_cast<Signed_128>(r.q) * b && r.p != 0;
}

template <class Ratio> CGAL_GC_FORCEINLINE bool weights_are_short(const Join_weights<std::int64_t>& w) {
  return (w.a2 | w.b2 | w.a3 | w.b3 | w.mix) < Ratio::factor_limit;
}

// On differences in units of 2^d (left) and 1 (right) of points with 53 bits: |a1| <= 2^54, |a2| <= 2^55, |a3| <= 2^56. With factors
// below their limits no form or part of it exceeds its limbs: test_integer_lengths.cpp computes the bounds of all of them by the same
// equations.
template <Join_question question, int N, class Weights, class Stages>
CGAL_GC_FORCEINLINE Join_answer decide_on_grids(const Differences<std::int64_t, N>& a,
                                                const Differences<std::int64_t, N>& b, const Weights& w,
                                                Stages& stages) {
  typedef Fixed_integer<1> Integer;
  constexpr int k = highest_difference(question);
  const auto decided = [&](Join_stage stage, Join_answer answer) {
    stages.decided(stage, answer);
    return answer;
  };
  if (stages.uses(Join_stage::residue)) {
    const Differences<std::uint64_t, N> x = converted<k, std::uint64_t>(a), y = converted<k, std::uint64_t>(b);
    Residue_zero zero;
    const Join_equations<std::uint64_t, N, Weights, Residue_zero> equations(x, y, w, zero);
    if (!all_hold<question>(equations)) return decided(Join_stage::residue, Join_answer::no);
  }
  const Differences<Integer, N> x = converted<k, Integer>(a), y = converted<k, Integer>(b);
  Exact_zero<Integer> zero;
  const Join_equations<Integer, N, Weights, Exact_zero<Integer>> equations(x, y, w, zero);
  const auto answer = [](bool holds) { return holds ? Join_answer::yes : Join_answer::no; };
  if constexpr (question == Join_question::torsion)
    if (!equations.both_have_curvature()) return decided(Join_stage::fixed_integer, Join_answer::undefined);
  if constexpr (is_geometric(question) || question == Join_question::curvature_vector) {
    constexpr Join_question given_parallel = question == Join_question::curvature_vector ? Join_question::g2 : question;
    const bool parallel = equations.tangents_parallel();
    if (is_geometric(question) && !parallel) return decided(Join_stage::fixed_integer, Join_answer::no);
    typedef Short_join_ratio<Integer, std::int64_t> Short_ratio;
    Short_ratio r;
    if (parallel && highest_difference(question) >= 2 && stages.uses(Join_stage::simple_ratio) &&
        weights_are_short<Short_ratio>(w) && short_ratio(a[0][0], b[0][0], r))
      return decided(Join_stage::simple_ratio, answer(equations_hold<given_parallel>(equations, r)));
    if (parallel)
      return decided(Join_stage::fixed_integer, answer(equations_hold<given_parallel>(equations, equations.ratio())));
  }
  return decided(Join_stage::fixed_integer, answer(equations_hold<question>(equations, equations.ratio())));
}

// On the coarsest grid that has all legs, as far as the legs of each end allow: short numbers leave residues that say more.
template <class Input, class Stages>
CGAL_GC_FORCEINLINE Join_answer decide_on_grid(const Input& join, typename Input::Factors w, int pivot,
                                               Stages& stages) {
  constexpr Join_question question = Input::question;
  constexpr int N = Input::dimension, k = highest_difference(question);
  const Grid_legs<N>&left = join.left_grid(), &right = join.right_grid();
  if (!left.valid || !right.valid) return Join_answer::unknown;
  const int e = (std::min)(left.exponent + left.zeros, right.exponent + right.zeros),
            x = (std::max)(e - left.exponent, 0), y = (std::max)(e - right.exponent, 0);
  if (!take_up<question>(w, left.exponent + x - right.exponent - y)) return Join_answer::unknown;
  return decide_on_grids<question, N>(
      differences_of<k, true>(without_zeros<k>(rotated<k>(left.legs, pivot), x), join.left_degree()),
      differences_of<k, false>(without_zeros<k>(rotated<k>(right.legs, pivot), y), join.right_degree()), w, stages);
}

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// The ladder. Exact or `unknown`; that the ends meet is not asked here.
template <class Input, class Stages>
CGAL_GC_FORCEINLINE Join_answer decide_by_rungs(const Input& join, Stages& stages) {
  constexpr Join_question question = Input::question;
  static_assert(highest_difference(question) > 0, "the points are compared before");
  int pivot = 0;
  if constexpr (!is_parametric(question)) {
    pivot = join.pivot();
    const Join_answer answer = decide_by_signs<question>(join.first_left(), join.first_right(), pivot);
    if (answer != Join_answer::unknown) {
      stages.decided(Join_stage::comparison, answer);
      return answer;
    }
  }
  typename Input::Factors w;
  if (!join.find_factors(w)) {
    if (!stages.uses(Join_stage::floating_point) || !join.first_derivatives_differ()) return Join_answer::unknown;
    stages.decided(Join_stage::floating_point, Join_answer::no);
    return Join_answer::no;
  }
  if constexpr (Input::rounded)
    if (stages.uses(Join_stage::floating_point)) { // with a bound of the error, then by residues
      constexpr int N = Input::dimension;
      typedef typename Input::Rounded_factors Factors;
      typedef Join_filter<Factors, typename Input::Rounding> Filter;
      const Difference_bounds A = join.left_bounds(), B = join.right_bounds();
      const Factors rounded = join.rounded_factors(w);
      const Filter filter{A, B, rounded};
      if (!filter.in_range()) return Join_answer::unknown;
      const Differences<double, N>&a = join.left(), &b = join.right();
      const Join_equations<double, N, Factors, const Filter> equations(a, b, rounded, filter, pivot);
      if (!all_hold<question>(equations)) {
        stages.decided(Join_stage::floating_point, Join_answer::no);
        return Join_answer::no;
      }
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
      if (stages.uses(Join_stage::bounded_residue)) {
        const Residue_room<Input, Filter> room(join, w, filter);
        if (room.valid()) return decide_by_residues<false>(join, w, room, pivot, stages, typename Input::Limbs());
      }
#endif
      return Join_answer::unknown;
    }
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  if constexpr (Input::on_grid)
    if (stages.uses(Join_stage::fixed_integer)) return decide_on_grid(join, w, pivot, stages);
#endif
  return Join_answer::unknown;
}

// What the ladder decides of two ends with double coordinates: they are read by the constructor, with positive weights if they are asked
// for them.
template <Join_question question, int N, bool weighted, class Left, class Right> class Read_join {
  Double_end<N> left_, right_;
  Short_lengths lengths_;

public:
  CGAL_GC_FORCEINLINE Read_join(const Left& left, const Right& right)
      : left_(left, Question<question>()), right_(right, Question<question>()) {
    if constexpr (is_parametric(question)) lengths_ = Short_lengths(left_.domain(), right_.domain());
  }
  CGAL_GC_FORCEINLINE Double_join<question, N> operator()() const { return {left_, right_, lengths_}; }
};
template <Join_question question, int N, class Left, class Right>
class Read_join<question, N, true, Left, Right> : Weighted_join<question, N, Left, Right> {
public:
  using Weighted_join<question, N, Left, Right>::Weighted_join;
  CGAL_GC_FORCEINLINE const Weighted_join<question, N, Left, Right>& operator()() const { return *this; }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_LADDER_H
