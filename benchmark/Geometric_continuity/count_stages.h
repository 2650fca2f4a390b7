// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef COUNT_STAGES_H
#define COUNT_STAGES_H

// Counts which stage decides each question about a join or an edge, in a program that is compiled
// with `-include count_stages.h`. At its end it appends lines "join STAGE ANSWER NUMBER" and "edge
// STAGE ANSWER NUMBER" to the file that GEOMETRIC_CONTINUITY_STAGES names. In all headers that are
// read behind this one, the names of what says which stages are taken become those of what counts.

// not where CMake tries the compiler
#if __has_include(<CGAL/Geometric_continuity/joins/internal/Join_question.h>)

#include <CGAL/Geometric_continuity/joins/internal/Join_question.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <fstream>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

class Stage_counts {
  template <std::size_t n> struct Table {
    const char* kind;
    std::array<const char*, n> names;
    std::array<std::array<std::atomic<long>, 4>, n> counts{}; // of each Join_answer

    void print(std::ostream& os) const {
      const char* const answers[] = {"no", "yes", "undefined", "unknown"};
      for (std::size_t s = 0; s < n; ++s)
        for (std::size_t a = 0; a < 4; ++a)
          if (counts[s][a] != 0) os << kind << ' ' << names[s] << ' ' << answers[a] << ' ' << counts[s][a] << '\n';
    }
  };
  Table<5> joins_{"join", {"comparison", "floating_point", "bounded_residue", "residue", "multiprecision"}};
  Table<6> edges_{"edge",
                  {"comparison", "floating_point", "simple_ratio", "fixed_integer", "multiprecision", "whole_spline"}};

public:
  Stage_counts() = default;
  Stage_counts(const Stage_counts&) = delete;
  ~Stage_counts() {
    const char* const file = std::getenv("GEOMETRIC_CONTINUITY_STAGES");
    if (file == nullptr) return;
    std::ofstream os(file, std::ios::app);
    joins_.print(os);
    edges_.print(os);
  }

  void join(Join_stage stage, Join_answer answer) {
    ++joins_.counts[static_cast<std::size_t>(stage)][static_cast<std::size_t>(answer)];
  }
  // The last number is that of whole edges of splines.
  void edge(int stage, bool answer) {
    ++edges_.counts[static_cast<std::size_t>(stage)]
                   [static_cast<std::size_t>(answer ? Join_answer::yes : Join_answer::no)];
  }
};
inline Stage_counts stage_counts;

struct Counted_join_stages {
  static constexpr bool uses(Join_stage) { return true; }
  void decided(Join_stage stage, Join_answer answer) const { stage_counts.join(stage, answer); }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#define All_join_stages Counted_join_stages

#include <CGAL/Geometric_continuity/edges/internal/Edge_ladder.h>
#include <CGAL/Geometric_continuity/joins/internal/decide_all_questions.h>

#include <optional>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Jets decide the questions that the ladder leaves open, so the answer is not known here.
template <class Questions, class Result>
bool count_all_questions(const Questions& questions, int max_order, Result& join, bool only_orders) {
  const bool decided = decide_all_questions(questions, max_order, join, only_orders);
  if (!decided) stage_counts.join(Join_stage::multiprecision, Join_answer::unknown);
  return decided;
}

struct Counted_edge_stages {
  static constexpr bool uses(Edge_stage) { return true; }
  void decided(Edge_stage stage, bool answer) const { stage_counts.edge(static_cast<int>(stage), answer); }
};

// An edge that is not proved to be smooth is left to what finds out why: an enclosure of the
// crease, or the last stage. Edges that are beyond fixed length for their degrees or coordinates do
// not come here and are not counted.
template <class Ladder> std::optional<int> count_smooth_order(Ladder& ladder) {
  struct {
    Edge_stage stage;
    static constexpr bool uses(Edge_stage) { return true; }
    void decided(Edge_stage s, bool) { stage = s; }
  } last{};
  const std::optional<int> found = ladder.template order<2>(Lower_orders::told_apart, last);
  const bool smooth = found.value_or(0) > 0;
  stage_counts.edge(static_cast<int>(smooth ? last.stage : Edge_stage::multiprecision), smooth);
  return smooth ? found : std::nullopt;
}

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
// Edges of splines as a whole; where it is not proved that they are smooth, their spans are
// decided.
template <class Surface_a, class Surface_b>
std::optional<Edge_direction> count_smooth_spline_edge(const Surface_a& a, Patch_edge edge_a, const Surface_b& b,
                                                       Patch_edge edge_b) {
  const std::optional<Edge_direction> direction = smooth_spline_edge(a, edge_a, b, edge_b);
  if (direction) stage_counts.edge(static_cast<int>(Edge_stage::multiprecision) + 1, true);
  return direction;
}
#define smooth_spline_edge count_smooth_spline_edge
#endif

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#define All_edge_stages Counted_edge_stages
#define decide_all_questions count_all_questions
#define smooth_order count_smooth_order

#endif

#endif // COUNT_STAGES_H
