// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_STAGE_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_STAGE_H

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The stages of an exact decision, from the cheapest to the one that always answers.
enum class Stage {
  comparison,     // equality and signs of the numbers as given
  floating_point, // a form is larger than its rounding error
  // of edges: integers of fixed length, where the tangent planes agree by short numbers
  simple_ratio,
  // integers of fixed length, which suffice for a form, or for one that is known to be small
  fixed_integer,
  residue,       // of joins: a form is not zero modulo the first modulus
  multiprecision // numbers of any length, or remainders by several moduli
};
constexpr int number_of_stages = 6;

// Says which stages are taken, and is told what each of them decides: this takes all of them and
// records nothing.
struct All_stages {
  static constexpr bool uses(Stage) { return true; }
  template <class Answer> void decided(Stage, Answer) const {}
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_STAGE_H
