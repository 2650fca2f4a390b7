// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_EQUATIONS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_EQUATIONS_H

#include <CGAL/Geometric_continuity/joins/internal/Join_equations.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The field in which the join of two ends is decided.
template <class View> using Join_field = typename Exact_field<Predicate_FT<typename View::Traits>>::type;

// The index of the first coordinate that is not zero.
template <class T, std::size_t N> int first_nonzero(const std::array<T, N>& x) {
  int i = 0;
  while (i < static_cast<int>(N) && x[i] == T(0)) ++i;
  return i;
}

// The equations in exact numbers. Unless the question is parametric, the first coordinate of the first difference on the left is not
// zero, and neither is the first difference on the right.
template <Join_question question, class T, std::size_t N, class Weights>
Join_answer decide_equations(const std::array<std::array<T, N>, 3>& a, const std::array<std::array<T, N>, 3>& b,
                             const Weights& w) {
  Exact_zero<T> zero;
  const Join_equations<T, static_cast<int>(N), Weights, Exact_zero<T>> equations(a, b, w, zero);
  if constexpr (is_geometric(question))
    if ((T(0) < a[0][0]) != (T(0) < b[0][0]) || b[0][0] == T(0) || !equations.tangents_parallel())
      return Join_answer::no;
  if constexpr (question == Join_question::torsion)
    if (!equations.both_have_curvature()) return Join_answer::undefined;
  return equations_hold<question>(equations, equations.ratio()) ? Join_answer::yes : Join_answer::no;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_DECIDE_EQUATIONS_H
