// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_MODULO_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_MODULO_H

#include <CGAL/Geometric_continuity/joins/internal/join_differences.h>
#include <CGAL/Geometric_continuity/joins/internal/join_stage.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_grid.h>

#include <algorithm>
#include <cstdint>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// Limbs that suffice as a rule: a form of degree d in numbers of n bits that has passed the filter has about (d - 1) n bits.
constexpr int residue_limbs(Join_question question) {
  return form_degree(question) <= 2 ? 2 : form_degree(question) <= 4 ? 3 : 4;
}

// The decision on differences a and b of the points p and q that have passed the filter, exact or `unknown`: a whole number
// that is divisible by 2^s and smaller than 2^s is 0.
//
// Let all coordinates be multiples of a unit 2^g, and let no leg exceed 2^51 units. Then each leg and each difference is a
// multiple of the unit and at most 2^53 units long, hence a double, so it was computed without rounding. In units they are
// whole numbers |a1| <= 2^51, |a2| <= 2^52, |a3| <= 2^53, and what is shorter than the residues stays within its limbs, as in
// decide_on_grids(). The bound that the filter proves for a form of degree d is divided by 2^(g d); forms of degree at most 2,
// and with four limbs the one for G2, are shorter than the residues anyway.
template <Join_question question, int N, class Filter, class Stages>
BOOST_FORCEINLINE Join_answer decide_modulo(const End_points<double, N>& p, const End_points<double, N>& q,
                                            const Differences<double, N>& a, const Differences<double, N>& b, int pivot,
                                            Join_weights_of<question, std::int64_t> w, const Filter& filter,
                                            Stages& stages) {
  constexpr int k = highest_difference(question), limbs = residue_limbs(question);
  typedef Fixed_integer<1, limbs> Integer;
  Common_grid grid(std::max(largest_coordinate_of<k>(p), largest_coordinate_of<k>(q)));
  if (!grid.valid()) return Join_answer::unknown;
  grid.include<k>(p);
  grid.include<k>(q);
  const int g = grid.exponent();
  if (!grid.valid() || std::max(filter.A.d3, filter.B.d3) > 0x1p53 * power_of_two(g)) return Join_answer::unknown;
  if (form_degree(question) > 2 && filter.exponent_of_bound(question) - g * form_degree(question) > 64 * limbs)
    return Join_answer::unknown;
  if (!take_up<question>(w, 0)) return Join_answer::unknown;

  const double units = power_of_two(-g);
  const Differences<Integer, N> x = in_units<k, Integer>(rotated<k>(a, pivot), units),
                                y = in_units<k, Integer>(rotated<k>(b, pivot), units);
  const Modular_zero zero;
  const Join_equations<Integer, N, Join_weights_of<question, std::int64_t>, const Modular_zero> equations(x, y, w,
                                                                                                          zero);
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

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_MODULO_H
