// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_QUESTION_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_QUESTION_H

// The vocabulary of the exact decisions about joins of curves in the plane and in space: what is
// asked, what is answered, and the stages of which each proves something. From a predicate of
// join_predicates.h the calls go
//
//   is_g2_join          join_predicates.h
//   decide_join         decide_join.h      control points or jets?
//   decide_polygons     decide_join.h      the ends meet: comparison of the points
//   decide_ends         decide_join.h      doubles, or the numbers of an exact kernel
//   decide_on_doubles   decide_in_ring.h   all stages, one after the other:
//     decide_by_stages  Join_ladder.h      on what Join_input.h makes of the ends:
//       decide_by_signs                    comparison of signs and zeros
//       all_hold                           the filter: a rounded form exceeds its error
//       decide_by_residues                 a form below a proven bound, modulo a power of two above it
//     decide_in_ring    decide_in_ring.h   doubles by remainders, or the numbers of an exact kernel
//
// and continuity() of join_continuity.h asks the ladder several questions (decide_all_questions.h).
// Ends without control points and dimensions above 3 are decided by Join_decision. All stages
// evaluate one text, Join_equations. It is a template with three axes:
//
// - `Zero` says what is known of a number whose form has been computed. Exact_zero: it is 0 or not.
//   Join_filter: if the rounded value exceeds the bound of its error the exact one is not 0;
//   otherwise nothing. Modular_zero: the number is smaller than the modulus, so it is 0 if and only
//   if its residue is. Join_rounding: nothing is known, the bound of the error is recorded.
// - `Weights` are the factors of the differences by which degrees and domains enter.
//   Parametric_degree_factors (both, for C^k) or Degree_factors (degrees, for all others), in the
//   integers or doubles in which the stage computes. Weighted_degree_factors has the weights of
//   rational curves besides the degrees.
// - `Stages` says which stages are taken, and is told what each of them decides. All_stages takes
//   all of them and records nothing; tests switch stages off and count.

#include <CGAL/Geometric_continuity/numbers/internal/Stage.h>

#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The questions that can be decided about a join.
enum class Join_question { c0, c1, c2, c3, g1, g2, g3, f3, curvature_vector, torsion };

constexpr bool is_parametric(Join_question question) { return question <= Join_question::c3; }
constexpr bool is_geometric(Join_question question) {
  return Join_question::g1 <= question && question <= Join_question::f3;
}

// The highest difference of the polygons that is read.
constexpr int highest_difference(Join_question question) {
  switch (question) {
  case Join_question::c0: return 0;
  case Join_question::c1:
  case Join_question::g1: return 1;
  case Join_question::c2:
  case Join_question::g2:
  case Join_question::curvature_vector: return 2;
  default: return 3;
  }
}

// The degree of the form in the differences.
constexpr int form_degree(Join_question question) {
  switch (question) {
  // unreachable: computed by the compiler
  case Join_question::g1: return 2;
  case Join_question::g2: return 4;
  case Join_question::g3:
  case Join_question::f3: return 6;
  case Join_question::curvature_vector:
  case Join_question::torsion: return 7;
  // unreachable: computed by the compiler
  // equivalent [1 -> 2, 1]: degrees up to 2 have the same lengths of integers
  default: return 1;
  }
}

// A question as a type.
template <Join_question question> struct Question : std::integral_constant<Join_question, question> {};

// The answer to a question; `unknown` when a stage cannot tell.
enum class Join_answer { no, yes, undefined, unknown };

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_QUESTION_H
