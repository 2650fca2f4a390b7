// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_TEST_JOINS_INTERNAL_JOIN_STAGES_H
#define CGAL_GEOMETRIC_CONTINUITY_TEST_JOINS_INTERNAL_JOIN_STAGES_H

#include "support/random.h"

#include <CGAL/Geometric_continuity/joins/join_predicates.h>

// The stages of the decision of a join, switched on one by one, and how many answers each gave.

using CGAL::Geometric_continuity::internal::Join_answer;
using CGAL::Geometric_continuity::internal::Join_question;
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
template <Join_question question, int N, bool weighted, class Left, class Right>
Join_answer decide_by_ladder(const Left& left, const Right& right, Stages& stages) {
  return GC::internal::decide_by_stages(GC::internal::Join_reader<question, N, weighted, Left, Right>(left, right)(),
                                        stages);
}
template <Join_question question, int N, bool weighted, class Left, class Right>
Join_answer decide_all_the_way(const Left& left, const Right& right, Stages& stages) {
  typedef typename Left::Traits::FT FT;
  if constexpr (GC::internal::is_double<FT> && !GC::internal::planar_by_definition<question, N>) {
    const Join_answer answer = decide_by_ladder<question, N, weighted>(left, right, stages);
    if (answer != Join_answer::unknown) return answer;
  }
  return GC::internal::decide_exactly<question, weighted>(left, right, stages);
}

inline Join_answer answer(const std::optional<bool>& b) {
  return !b ? Join_answer::undefined : *b ? Join_answer::yes : Join_answer::no;
}
// The answer that follows from a decision of everything.
inline Join_answer expected(const GC::Join_continuity<Q>& join, Join_question question) {
  switch (question) {
  case Join_question::curvature_vector: return answer(join.curvature_vector_equal);
  case Join_question::torsion: return answer(join.torsion_equal);
  case Join_question::f3: return answer(join.f_order >= 3);
  case Join_question::g1:
  case Join_question::g2:
  case Join_question::g3:
    return answer(join.g_order >= 1 + static_cast<int>(question) - static_cast<int>(Join_question::g1));
  default: return answer(join.c_order >= static_cast<int>(question));
  }
}

// The joins that were asked about, and by question what was answered where.
struct Counter {
  std::array<std::array<long, 4>, 10> answers{};
  std::array<std::array<long, number_of_stages>, 10> stages{};
  long joins = 0, mismatches = 0;

  void add(Join_question question, const Stages& s) {
    for (int i = 0; i < number_of_stages; ++i) stages[static_cast<int>(question)][i] += s.count[i];
  }
};

// Asks all stages together, and some of them, with and without what comes behind the ladder: each
// answer is the true one, or the ladder does not tell.
template <Join_question question, int N, bool weighted, class Left, class Right>
void check_stages(const Left& left, const Right& right, const GC::Join_continuity<Q>& join, Counter& counter) {
  const auto x = GC::internal::left_end(left);
  const auto y = GC::internal::right_end(right);
  const bool decided_before = GC::internal::requires_coincident_ends(question) && !GC::internal::ends_meet(x, y);
  const Join_answer truth = expected(join, question);
  ++counter.answers[static_cast<int>(question)][static_cast<int>(truth)];
  bool right_answers = true;
  if constexpr (question != Join_question::c0) {
    if constexpr (!GC::internal::planar_by_definition<question, N>)
      for (const unsigned used :
           {stage(Stage::floating_point), stage(Stage::floating_point) | stage(Stage::fixed_integer),
            (1u << number_of_stages) - 1}) {
        if (decided_before) break;
        Stages some{used};
        const Join_answer partial = decide_by_ladder<question, N, weighted>(x, y, some);
        right_answers = right_answers && (partial == truth || partial == Join_answer::unknown);
        counter.add(question, some);
      }
    for (const unsigned used : {0u, stage(Stage::residue)}) { // without the ladder
      if (decided_before) break;
      Stages last{used};
      right_answers = right_answers && decide_all_the_way<question, N, weighted>(x, y, last) == truth;
      counter.add(question, last);
    }
  }
  Stages all{(1u << number_of_stages) - 1};
  right_answers = right_answers && GC::internal::decide_join<question>(left, right, all) == truth;
  counter.add(question, all);
  if (!right_answers && counter.mismatches++ < 5)
    BOOST_ERROR("question " << static_cast<int>(question) << ", expected " << static_cast<int>(truth) << "\n"
                            << left << "\n"
                            << right);
}

class Random : public Random_integers<std::mt19937_64> {
public:
  // a whole number of at most n bits, and a sign
  double whole(int n) {
    const double x = static_cast<double>(engine_() >> (64 - n));
    return coin() ? x : -x;
  }
  // any double with an exponent from low to high
  double any(int low, int high) {
    const double mantissa = 1 + static_cast<double>(engine_() >> 12) * 0x1p-52;
    return std::ldexp(coin() ? mantissa : -mantissa, integer(low, high));
  }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
};

// The points with these coordinates from the join inwards, in the order of the curve.
template <class Traits, class Rows> std::vector<typename Traits::Point> points_along(const Rows& rows, bool left) {
  std::vector<typename Traits::Point> points;
  for (const auto& c : rows)
    if constexpr (GC::dimension_v<Traits> == 2)
      points.emplace_back(c[0], c[1]);
    else
      points.emplace_back(c[0], c[1], c[2]);
  if (left) std::reverse(points.begin(), points.end());
  return points;
}

#endif // CGAL_GEOMETRIC_CONTINUITY_TEST_JOINS_INTERNAL_JOIN_STAGES_H
