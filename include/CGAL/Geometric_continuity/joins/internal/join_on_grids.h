// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_ON_GRIDS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_ON_GRIDS_H

#include <CGAL/Geometric_continuity/joins/internal/join_differences.h>
#include <CGAL/Geometric_continuity/joins/internal/join_stage.h>

#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

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
BOOST_FORCEINLINE bool short_ratio(std::int64_t a, std::int64_t b, Short_join_ratio& r) {
  const double x = 256 * (static_cast<double>(b) / static_cast<double>(a));
  if (!(std::abs(x) < 4096)) return false;
  std::int64_t p = static_cast<std::int64_t>(x), q = 256;
  if (static_cast<Signed_128>(p) * a != static_cast<Signed_128>(q) * b || p == 0) return false;
  r.q = q;
  r.p = p;
  return true;
}

BOOST_FORCEINLINE bool weights_are_short(const Join_weights<std::int64_t>& w) {
  return (w.a2 | w.b2 | w.a3 | w.b3 | w.mix) < (std::int64_t(1) << 16);
}

// The decision on differences in units of 2^d (left) and 1 (right), of 53 bits for the points: |a1| <= 2^54, |a2| <= 2^55,
// |a3| <= 2^56. With factors w2 < 2^19 of a2 and b2, w3 < 2^28 and a factor < 2^16 of the mixed term (see take_up) no form
// or part of it exceeds its limbs: q^2 w2 < 2^127, V < 2^(108+19+55+1) < 2^191, its product with a1 < 2^239; q^3 w3 < 2^191,
// n.b3 < 2^(110+56+2) < 2^191, their products < 2^360; q^3 w3 a1_0 < 2^245, p V w < 2^254, the sum of three terms
// < 2^312, its product with a1 < 2^367; curvature vector: (b1.b1)^2 w2 < 2^(220+19), times 2^167; torsion: (n.a3) w < 2^188, times
// 2^222.
template <Join_question question, int N, class Weights, class Stages>
BOOST_FORCEINLINE Join_answer decide_on_grids(const Differences<std::int64_t, N>& a,
                                              const Differences<std::int64_t, N>& b, const Weights& w, Stages& stages) {
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

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_ON_GRIDS_H
