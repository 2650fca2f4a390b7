// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_TASK_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_TASK_H

#include <CGAL/Geometric_continuity/internal/Steps_of_each.h>
#include <CGAL/Geometric_continuity/internal/several_cores.h>
#include <CGAL/tags.h>

#include <optional>
#include <type_traits>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_group.h>
#endif

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Something that is done at once, or, with Parallel_tag, at some time until it is waited for, possibly on another core.
template <class Concurrency_tag, class = void> class Task {
  static_assert(!std::is_same_v<Concurrency_tag, Parallel_tag>,
                "Parallel_tag needs TBB, see CGAL_TBB_support; Parallel_if_available_tag does without");

public:
  static constexpr bool concurrent = false;
  template <class Function> void run(Function f) { f(); }
  void wait() {}
};

#ifdef CGAL_LINKED_WITH_TBB
// At once also where TBB may use one core only.
template <class Concurrency_tag>
class Task<Concurrency_tag, std::enable_if_t<std::is_convertible_v<Concurrency_tag, Parallel_tag>>> {
  std::optional<tbb::task_group> group_;

public:
  static constexpr bool concurrent = true;
  Task() = default;
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;
  ~Task() {
    if (!group_) return;
    group_->cancel();
    group_->wait();
  }
  template <class Function> void run(Function f) {
    if (!several_cores()) return f();
    if (!group_) group_.emplace();
    group_->run([f, steps = Steps_of_each::steps()] {
      const Steps_of_each each(steps);
      f();
    });
  }
  void wait() {
    if (group_) group_->wait();
  }
};
#endif

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_TASK_H
