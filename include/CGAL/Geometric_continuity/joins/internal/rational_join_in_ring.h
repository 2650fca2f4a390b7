// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_RATIONAL_JOIN_IN_RING_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_RATIONAL_JOIN_IN_RING_H

#include <CGAL/Geometric_continuity/joins/internal/Rational_join_weights.h>
#include <CGAL/Geometric_continuity/joins/internal/decide_equations.h>
#include <CGAL/Geometric_continuity/joins/internal/join_on_doubles.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/config.h>

// As Rational_parts, only where there are the functions of GMP for limbs.
#ifdef CGAL_USE_GMP
#include <CGAL/Geometric_continuity/numbers/internal/Inline_integer.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

#ifdef CGAL_USE_GMP

// Doubles of any size as whole numbers, in units of the largest power of two of which all that have been included are multiples:
// Common_denominator for doubles.
class Binary_scale {
  int exponent_ = (std::numeric_limits<int>::max)();

public:
  typedef Inline_integer Ring;

  // A number with the sign of x and the absolute value odd_part 2^exponent, or 0.
  class Number {
    friend Binary_scale;
    std::uint64_t odd_part_ = 0;
    int exponent_ = (std::numeric_limits<int>::max)();
    bool negative_ = false;

  public:
    Number() = default;
    explicit Number(double x) : negative_(x < 0) {
      if (x == 0) return;
      int e;
      const std::uint64_t n = static_cast<std::uint64_t>(std::frexp(std::abs(x), &e) * 0x1p53); // exact
      const int zeros = __builtin_ctzll(n);
      odd_part_ = n >> zeros;
      exponent_ = e - 53 + zeros;
    }
  };

  void include(const Number& x) { exponent_ = (std::min)(exponent_, x.exponent_); }

  // x in units. \pre x has been included
  Ring numerator(const Number& x) const {
    Ring y;
    y.assign(&x.odd_part_, 1, x.negative_);
    y <<= x.exponent_ - exponent_;
    return y;
  }

  // The same modulo 2^64.
  std::uint64_t residue(const Number& x) const {
    const int shift = x.exponent_ - exponent_;
    const std::uint64_t n = shift < 64 ? x.odd_part_ << shift : 0;
    return x.negative_ ? -n : n;
  }
};

#endif // CGAL_USE_GMP

// Control points and weights of an end as numbers of a ring.
template <class Ring, int N> struct Rational_end {
  End_polygon<Ring, N> points;
  std::array<Ring, 4> weights;
};

// Two ends with weights in the ring of common denominators, that of the points being one for both ends. `Scale` finds the
// denominators of a type of numbers.
template <Join_question question, int N, class Scale, class Number> class Rational_ends {
  static constexpr int k = highest_difference(question);
  Scale points_;
  std::array<Scale, 2> weights_;
  std::array<Rational_end<Number, N>, 2> ends_;
  std::array<int, 2> degrees_;

public:
  // number(x) is a number of an end as one of Scale.
  template <class Left, class Right, class Function>
  Rational_ends(const Left& left, const Right& right, Function number) : degrees_{left.degree(), right.degree()} {
    const auto read = [&](const auto& end, int side) {
      for (int j = 0; j <= k; ++j) {
        const int l = (std::min)(j, end.degree());
        for (int i = 0; i < N; ++i) points_.include(ends_[side].points[j][i] = number(end.coordinate(l, i)));
        weights_[side].include(ends_[side].weights[j] = number(end.weight(l)));
      }
    };
    read(left, 0);
    read(right, 1);
  }

  // The decision in a ring; in_ring(scale, x) is the numerator of x. `decide` takes differences, of which the first coordinate of the
  // first on the left is not zero, and factors. Where a first difference vanishes in the ring the answer is `vanishing`.
  template <class Ring, class Function, class Decide>
  Join_answer operator()(Function in_ring, Decide decide, Join_answer vanishing) const {
    std::array<Rational_end<Ring, N>, 2> ends;
    for (int side = 0; side < 2; ++side)
      for (int j = 0; j <= k; ++j) {
        for (int i = 0; i < N; ++i) ends[side].points[j][i] = in_ring(points_, ends_[side].points[j][i]);
        ends[side].weights[j] = in_ring(weights_[side], ends_[side].weights[j]);
      }
    const Differences<Ring, N> a = fan_of<k, true>(ends[0].points), b = fan_of<k, false>(ends[1].points);
    const int pivot = first_nonzero(a[0]);
    if (pivot == N || first_nonzero(b[0]) == N) return vanishing;
    typedef Rational_join_weights<question, Ring> Weights;
    return decide(rotated<k>(a, pivot), rotated<k>(b, pivot),
                  Weights::of(ends[0].weights, degrees_[0], ends[1].weights, degrees_[1]));
  }
};

// The decision on two ends with positive weights, in integers of any length or in the field of an exact kernel.
template <Join_question question, int N, class Left, class Right, class Stages>
BOOST_NOINLINE Join_answer decide_rational_exactly(const Left& left, const Right& right, Stages& stages) {
  const auto exactly = [](const auto& a, const auto& b, const auto& w) { return decide_equations<question>(a, b, w); };
  const auto numerator = [](const auto& scale, const auto& x) { return scale.numerator(x); };
  constexpr Join_answer no_tangent = is_geometric(question) ? Join_answer::no : Join_answer::undefined;
  const auto decided = [&](Join_stage stage, Join_answer answer) {
    stages.decided(stage, answer);
    return answer;
  };
#ifdef CGAL_USE_GMP
  if constexpr (is_double<typename Left::Traits::FT>) {
    typedef Binary_scale::Number Number;
    const Rational_ends<question, N, Binary_scale, Number> ends(left, right, [](double x) { return Number(x); });
    if (stages.uses(Join_stage::residue)) {
      const auto residue = [](const Binary_scale& scale, const Number& x) { return scale.residue(x); };
      const auto may_hold = [](const auto& a, const auto& b, const auto& w) {
        typedef std::decay_t<decltype(w)> Weights;
        Residue_zero zero;
        const Join_equations<std::uint64_t, N, Weights, Residue_zero> equations(a, b, w, zero);
        return all_hold<question>(equations) ? Join_answer::unknown : Join_answer::no;
      };
      const Join_answer answer = ends.template operator()<std::uint64_t>(residue, may_hold, Join_answer::unknown);
      if (answer == Join_answer::no) return decided(Join_stage::residue, answer);
    }
    return decided(Join_stage::multiprecision,
                   ends.template operator()<Inline_integer>(numerator, exactly, no_tangent));
  }
#endif
  typedef Join_field<Left> Field;
  typedef typename Common_denominator<Field>::Ring Ring;
  const Rational_ends<question, N, Common_denominator<Field>, Field> ends(
      left, right, [](const auto& x) { return to_field<Field>(x); });
  return decided(Join_stage::multiprecision, ends.template operator()<Ring>(numerator, exactly, no_tangent));
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_RATIONAL_JOIN_IN_RING_H
