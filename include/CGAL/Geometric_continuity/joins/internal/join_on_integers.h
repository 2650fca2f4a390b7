// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_ON_INTEGERS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_ON_INTEGERS_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/internal/End_polygon.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// Limbs that suffice as a rule: a form of degree d in numbers of n bits that has passed the filter has about (d - 1) n bits.
constexpr int residue_limbs(Join_question question) {
  return form_degree(question) <= 2 ? 2 : form_degree(question) <= 4 ? 3 : 4;
}

// A number of one limb of which products are residues modulo 2^(64 limbs).
template <int limbs> using Residue = Fixed_integer<1, limbs>;
template <class Integer> constexpr int bits_of_residue = 0;
template <int limbs> constexpr int bits_of_residue<Residue<limbs>> = 64 * limbs;

// The decision on differences a and b of the points p and q that have passed the filter, exact or `unknown`: a whole number
// that is divisible by 2^s and smaller than 2^s is 0.
//
// Let all coordinates be multiples of a unit 2^g, and let no leg exceed 2^51 units. Then each leg and each difference is a
// multiple of the unit and at most 2^53 units long, hence a double, so it was computed without rounding. In units they are
// whole numbers |a1| <= 2^51, |a2| <= 2^52, |a3| <= 2^53, and what is shorter than the residues stays within its limbs, as in
// decide_on_grids(). The bound that the filter proves for a form of degree d is divided by 2^(g d); forms of degree at most 2,
// and with four limbs and polynomials the one for G2, are shorter than the residues anyway.
//
// The factors are whole numbers w; in the filter those of a form are 2^unit_of_factors(form) times these.
template <Join_question question, int N, class Integer, class Weights, class Filter, class Unit, class Stages>
CGAL_GC_FORCEINLINE Join_answer decide_modulo(const End_polygon<double, N>& p, const End_polygon<double, N>& q,
                                              const Differences<double, N>& a, const Differences<double, N>& b,
                                              int pivot, const Weights& w, const Filter& filter,
                                              const Unit& unit_of_factors, Stages& stages) {
  constexpr int k = highest_difference(question), bits = bits_of_residue<Integer>;
  Common_grid grid((std::max)(largest_coordinate_of<k>(p), largest_coordinate_of<k>(q)));
  if (!grid.valid()) return Join_answer::unknown;
  grid.include<k>(p);
  grid.include<k>(q);
  const int g = grid.exponent();
  if (!grid.valid() || (std::max)(filter.A.d3, filter.B.d3) > 0x1p53 * power_of_two(g)) return Join_answer::unknown;
  const auto fits = [&](Join_question form) {
    return filter.exponent_of_bound(form) - g * form_degree(form) - unit_of_factors(form) <= bits;
  };
  if (form_degree(question) > 2 && !fits(question)) return Join_answer::unknown;
  if (Weights::rational && is_geometric(question) && !fits(Join_question::g2)) return Join_answer::unknown;

  const double units = power_of_two(-g);
  const Differences<Integer, N> x = in_units<k, Integer>(rotated<k>(a, pivot), units),
                                y = in_units<k, Integer>(rotated<k>(b, pivot), units);
  const Modular_zero zero;
  const Join_equations<Integer, N, Weights, const Modular_zero> equations(x, y, w, zero);
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

// (q, p) of at most 12 bits, so that the cubes with factors of at most 16 bits take one limb. The types of the forms are
// shorter: |q^2 b2 - p^2 a2| < 2^(24+16+55+1), times p and a factor of 16 bits < 2^124; |q^3 a1_0| < 2^(36+16+54).
struct Short_join_ratio {
  typedef Fixed_integer<1> Square, Cube;
  Fixed_integer<1> q, p;
  static Square square(const Fixed_integer<1>& x) { return Square(x.top() * x.top()); }
  static Cube cube(const Fixed_integer<1>& x) { return Cube(x.top() * x.top() * x.top()); }
  template <class V> V p_times(const V& v, std::int64_t w) const { return scaled(v, p.top() * w); }
};

// b/a, if it is a fraction with denominator 2^8 and a numerator of at most 12 bits
CGAL_GC_FORCEINLINE bool short_ratio(std::int64_t a, std::int64_t b, Short_join_ratio& r) {
  const double x = 256 * (static_cast<double>(b) / static_cast<double>(a));
  if (!(std::abs(x) < 4096)) return false;
  std::int64_t p = static_cast<std::int64_t>(x), q = 256;
  if (static_cast<Signed_128>(p) * a != static_cast<Signed_128>(q) * b || p == 0) return false;
  r.q = q;
  r.p = p;
  return true;
}

CGAL_GC_FORCEINLINE bool weights_are_short(const Join_weights<std::int64_t>& w) {
  return (w.a2 | w.b2 | w.a3 | w.b3 | w.mix) < (std::int64_t(1) << 16);
}

// The decision on differences in units of 2^d (left) and 1 (right), of 53 bits for the points: |a1| <= 2^54, |a2| <= 2^55,
// |a3| <= 2^56. With factors w2 < 2^19 of a2 and b2, w3 < 2^28 and a factor < 2^16 of the mixed term (see take_up) no form
// or part of it exceeds its limbs: q^2 w2 < 2^127, V < 2^(108+19+55+1) < 2^191, its product with a1 < 2^239; q^3 w3 < 2^191,
// n.b3 < 2^(110+56+2) < 2^191, their products < 2^360; q^3 w3 a1_0 < 2^245, p V w < 2^254, the sum of three terms
// < 2^312, its product with a1 < 2^367; curvature vector: (b1.b1)^2 w2 < 2^(220+19), times 2^167; torsion: (n.a3) w < 2^188, times
// 2^222.
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
    Short_join_ratio r;
    if (parallel && highest_difference(question) >= 2 && stages.uses(Join_stage::simple_ratio) &&
        weights_are_short(w) && short_ratio(a[0][0], b[0][0], r))
      return decided(Join_stage::simple_ratio, answer(equations_hold<given_parallel>(equations, r)));
    if (parallel)
      return decided(Join_stage::fixed_integer, answer(equations_hold<given_parallel>(equations, equations.ratio())));
  }
  return decided(Join_stage::fixed_integer, answer(equations_hold<question>(equations, equations.ratio())));
}

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// The legs of an end in units of 2^exponent, if its points lie on such a grid.
template <int N> struct Grid_legs {
  Legs<std::int64_t, N> legs;
  int exponent;
  int zeros; // trailing bits that are zero in all legs
  bool valid;
};

CGAL_GC_FORCEINLINE std::int64_t any_bits(const std::array<std::int64_t, 2>& x) { return x[0] | x[1]; }
CGAL_GC_FORCEINLINE std::int64_t any_bits(const std::array<std::int64_t, 3>& x) { return x[0] | x[1] | x[2]; }

// The number of trailing zeros of a number below 2^54, 53 for zero.
inline int trailing_zeros(std::int64_t x) {
  // the lowest bit, as a double
  return x == 0 ? 53 : binary_exponent(static_cast<double>(x & -x));
}

// The legs without `shift` trailing zeros.
CGAL_GC_FORCEINLINE std::array<std::int64_t, 2> without_zeros(const std::array<std::int64_t, 2>& x, int shift) {
  return {x[0] >> shift, x[1] >> shift};
}
CGAL_GC_FORCEINLINE std::array<std::int64_t, 3> without_zeros(const std::array<std::int64_t, 3>& x, int shift) {
  return {x[0] >> shift, x[1] >> shift, x[2] >> shift};
}
template <int k, std::size_t N>
CGAL_GC_FORCEINLINE Legs<std::int64_t, N> without_zeros(const std::array<std::array<std::int64_t, N>, 3>& x,
                                                        int shift) {
  if constexpr (k == 1)
    return {without_zeros(x[0], shift)};
  else if constexpr (k == 2)
    return {without_zeros(x[0], shift), without_zeros(x[1], shift)};
  else
    return {without_zeros(x[0], shift), without_zeros(x[1], shift), without_zeros(x[2], shift)};
}

template <int k, std::size_t N>
CGAL_GC_FORCEINLINE Grid_legs<N> grid_legs_of(const std::array<std::array<double, N>, 4>& points) {
  Grid grid(largest_coordinate_of<k>(points));
  if (!grid.valid()) return {{}, 0, 0, false};
  End_polygon<std::int64_t, N> x;
  x[0] = grid(points[0]);
  x[1] = grid(points[1]);
  if constexpr (k >= 2) x[2] = grid(points[2]);
  if constexpr (k >= 3) x[3] = grid(points[3]);
  const Legs<std::int64_t, N> legs = legs_of<k>(x);
  std::int64_t bits = any_bits(legs[0]);
  if constexpr (k >= 2) bits |= any_bits(legs[1]);
  if constexpr (k >= 3) bits |= any_bits(legs[2]);
  return {legs, grid.exponent(), trailing_zeros(bits), grid.valid()};
}

// The decision on legs on grids, or `unknown`.
template <Join_question question, int N, class Weights, class Stages>
CGAL_GC_FORCEINLINE Join_answer decide_on_grid_legs(const Grid_legs<N>& left, int m, const Grid_legs<N>& right, int n,
                                                    int pivot, Weights w, Stages& stages) {
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  constexpr int k = highest_difference(question);
  if (!left.valid || !right.valid) return Join_answer::unknown;
  // The coarsest grid that has all legs, as far as the legs of each end allow: short numbers leave residues that say more.
  const int e = (std::min)(left.exponent + left.zeros, right.exponent + right.zeros),
            x = (std::max)(e - left.exponent, 0), y = (std::max)(e - right.exponent, 0);
  if (take_up<question>(w, left.exponent + x - right.exponent - y))
    return decide_on_grids<question, N>(differences_of<k, true>(without_zeros<k>(rotated<k>(left.legs, pivot), x), m),
                                        differences_of<k, false>(without_zeros<k>(rotated<k>(right.legs, pivot), y), n),
                                        w, stages);
#endif
  return Join_answer::unknown;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_ON_INTEGERS_H
