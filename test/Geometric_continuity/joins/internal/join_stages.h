// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_TEST_JOINS_INTERNAL_JOIN_STAGES_H
#define CGAL_GEOMETRIC_CONTINUITY_TEST_JOINS_INTERNAL_JOIN_STAGES_H

#include <CGAL/Geometric_continuity/joins/join_predicates.h>

#include <array>

// The stages of the decision of a join, switched on one by one, and how many answers each gave.

using CGAL::Geometric_continuity::internal::Join_answer;
using CGAL::Geometric_continuity::internal::Stage;

using CGAL::Geometric_continuity::internal::number_of_stages;
struct Stages {
  unsigned used;
  std::array<long, number_of_stages> count{};
  bool uses(Stage s) const { return (used >> static_cast<int>(s)) & 1; }
  void decided(Stage s, Join_answer) { ++count[static_cast<int>(s)]; }
};
constexpr unsigned stage(Stage s) { return 1u << static_cast<int>(s); }

// By the ladder, with weights if they are asked for; and, where it does not tell, by numbers of any
// length.
template <CGAL::Geometric_continuity::internal::Join_question question, int N, bool weighted, class Left, class Right>
Join_answer decide_by_ladder(const Left& left, const Right& right, Stages& stages) {
  namespace GC = CGAL::Geometric_continuity;
  return GC::internal::decide_by_stages(GC::internal::Join_reader<question, N, weighted, Left, Right>(left, right)(),
                                        stages);
}
template <CGAL::Geometric_continuity::internal::Join_question question, int N, bool weighted, class Left, class Right>
Join_answer decide_all_the_way(const Left& left, const Right& right, Stages& stages) {
  namespace GC = CGAL::Geometric_continuity;
  typedef typename Left::Traits::FT FT;
  if constexpr (GC::internal::is_double<FT> && !GC::internal::planar_by_definition<question, N>) {
    const Join_answer answer = decide_by_ladder<question, N, weighted>(left, right, stages);
    if (answer != Join_answer::unknown) return answer;
  }
  return GC::internal::decide_exactly<question, weighted>(left, right, stages);
}

#endif // CGAL_GEOMETRIC_CONTINUITY_TEST_JOINS_INTERNAL_JOIN_STAGES_H
