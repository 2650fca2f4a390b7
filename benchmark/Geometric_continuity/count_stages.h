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
  struct Table {
    // the last row is that of whole edges of splines
    static constexpr std::size_t n = number_of_stages + 1;
    const char* kind;
    std::array<std::array<std::atomic<long>, 4>, n> counts{}; // of each Join_answer

    void print(std::ostream& os) const {
      const char* const names[n] = {"comparison", "floating_point", "simple_ratio", "fixed_integer",
                                    "residue",    "multiprecision", "whole_spline"};
      const char* const answers[] = {"no", "yes", "undefined", "unknown"};
      for (std::size_t s = 0; s < n; ++s)
        for (std::size_t a = 0; a < 4; ++a)
          if (counts[s][a] != 0) os << kind << ' ' << names[s] << ' ' << answers[a] << ' ' << counts[s][a] << '\n';
    }
  };
  Table joins_{"join"}, edges_{"edge"};

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

  void join(Stage stage, Join_answer answer) {
    ++joins_.counts[static_cast<std::size_t>(stage)][static_cast<std::size_t>(answer)];
  }
  void edge(Stage stage, bool answer) { edge(static_cast<std::size_t>(stage), answer); }
  void whole_spline() { edge(Table::n - 1, true); }

private:
  void edge(std::size_t row, bool answer) {
    ++edges_.counts[row][static_cast<std::size_t>(answer ? Join_answer::yes : Join_answer::no)];
  }
};
inline Stage_counts stage_counts;

struct Counted_stages {
  static constexpr bool uses(Stage) { return true; }
  void decided(Stage stage, Join_answer answer) const { stage_counts.join(stage, answer); }
  void decided(Stage stage, bool answer) const { stage_counts.edge(stage, answer); }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#define All_stages Counted_stages

#include <CGAL/Geometric_continuity/edges/internal/Edge_ladder.h>
#include <CGAL/Geometric_continuity/joins/internal/decide_all_questions.h>

#include <optional>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Jets decide the questions that the ladder leaves open, so the answer is not known here.
template <class Questions, class Result>
bool count_all_questions(const Questions& questions, int max_order, Result& join, Join_asked asked) {
  const bool decided = decide_all_questions(questions, max_order, join, asked);
  if (!decided) stage_counts.join(Stage::multiprecision, Join_answer::unknown);
  return decided;
}

// An edge that is not proved to be smooth is left to what finds out why: an enclosure of the
// crease, or the last stage. Edges that are beyond fixed length for their degrees or coordinates do
// not come here and are not counted.
template <class Ladder> std::optional<int> count_smooth_order(Ladder& ladder) {
  struct {
    Stage stage;
    static constexpr bool uses(Stage) { return true; }
    void decided(Stage s, bool) { stage = s; }
  } last{};
  const std::optional<int> found = ladder.template order<2>(Lower_orders::told_apart, last);
  const bool smooth = found.value_or(0) > 0;
  stage_counts.edge(smooth ? last.stage : Stage::multiprecision, smooth);
  return smooth ? found : std::nullopt;
}

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
// Edges of splines as a whole; where it is not proved that they are smooth, their spans are
// decided.
template <class Surface_a, class Surface_b>
std::optional<Edge_direction> count_smooth_spline_edge(const Surface_a& a, Patch_edge edge_a, const Surface_b& b,
                                                       Patch_edge edge_b) {
  const std::optional<Edge_direction> direction = smooth_spline_edge(a, edge_a, b, edge_b);
  if (direction) stage_counts.whole_spline();
  return direction;
}
#define smooth_spline_edge count_smooth_spline_edge
#endif

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#define decide_all_questions count_all_questions
#define smooth_order count_smooth_order

#endif

#endif // COUNT_STAGES_H
