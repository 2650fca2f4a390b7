// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_STAGE_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_STAGE_H

#include <CGAL/Geometric_continuity/joins/internal/Join_weights.h>

#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

enum class Join_answer { no, yes, undefined, unknown };

// Where a decision was made.
enum class Join_stage {
  comparison,      // equality and signs of the numbers as given
  floating_point,  // a form is larger than its rounding error
  bounded_residue, // a form is smaller than the modulus
  residue,         // a form is not zero modulo 2^64
  simple_ratio,    // integers of fixed length, with p/q short
  fixed_integer,   // integers of fixed length
  multiprecision
};

// Which stages are taken, and what hears of the decision: the default uses all and does not listen.
struct All_join_stages {
  static constexpr bool uses(Join_stage) { return true; }
  void decided(Join_stage, Join_answer) const {}
};

template <class T> struct Exact_zero {
  static constexpr bool exact = true, pivot_is_first = true;
  template <class X> bool operator()(Join_question, const X& x) const {
    if constexpr (std::is_same_v<X, T>)
      return bool(x == T(0));
    else
      return is_zero(x);
  }
};

// The residue of zero is zero; the residue of another number may be.
struct Residue_zero {
  static constexpr bool exact = false, pivot_is_first = true;
  bool operator()(Join_question, std::uint64_t x) const { return x == 0; }
};

// The residue of a number that is known to be smaller than the modulus.
struct Modular_zero {
  static constexpr bool exact = false, pivot_is_first = true;
  template <class X> bool operator()(Join_question, const X& x) const { return is_zero(x); }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_JOIN_STAGE_H
