// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_PARALLEL_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_PARALLEL_H

#include <CGAL/Geometric_continuity/internal/Per_object_limit.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <optional>
#include <type_traits>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>
#endif

// Work on several cores, where TBB is there.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

#ifdef CGAL_LINKED_WITH_TBB
// Returns whether TBB may use more than one core. Otherwise it need not be started, which takes
// memory.
inline bool several_cores() {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) > 1;
}
#endif

// Calls work(begin, end) for consecutive parts of [0, n), on several cores with Parallel_tag, where
// they are halved while they are larger than `grain`.
template <class Concurrency_tag, class Work>
void for_each_block(std::size_t n, const Work& work, [[maybe_unused]] std::size_t grain = 1024) {
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible_v<Concurrency_tag, Parallel_tag>) {
    // unreachable: where TBB may use one core only
    if (!several_cores()) return work(std::size_t(0), n);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain),
                      [&work, steps = Per_object_limit::steps()](const tbb::blocked_range<std::size_t>& r) {
                        const Per_object_limit each(steps);
                        work(r.begin(), r.end());
                      });
    return;
  }
#endif
  static_assert(!std::is_same_v<Concurrency_tag, Parallel_tag> ||
                    std::is_same_v<Parallel_if_available_tag, Parallel_tag>,
                "Parallel_tag needs TBB, see CGAL_TBB_support; Parallel_if_available_tag does without");
  work(std::size_t(0), n);
}

// Something that is done at once, or, with Parallel_tag, at some time until it is waited for,
// possibly on another core.
template <class Concurrency_tag, class = void> class Task {
  static_assert(!std::is_same_v<Concurrency_tag, Parallel_tag>,
                "Parallel_tag needs TBB, see CGAL_TBB_support; Parallel_if_available_tag does without");

public:
  static constexpr bool may_wait() { return false; }
  template <class Function> void run(Function f) { f(); }
  void wait() {}
};

#ifdef CGAL_LINKED_WITH_TBB
// Runs both at once, also where TBB may use one core only.
template <class Concurrency_tag>
class Task<Concurrency_tag, std::enable_if_t<std::is_convertible_v<Concurrency_tag, Parallel_tag>>> {
  std::optional<tbb::task_group> group_;

public:
  static bool may_wait() { return several_cores(); }
  Task() = default;
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;
  ~Task() {
    // unreachable: a task that was not run, as on one core
    if (!group_) return;
    group_->cancel();
    group_->wait();
  }
  template <class Function> void run(Function f) {
    // unreachable: where TBB may use one core only
    if (!several_cores()) return f();
    if (!group_) group_.emplace();
    group_->run([f, steps = Per_object_limit::steps()] {
      const Per_object_limit each(steps);
      f();
    });
  }
  void wait() {
    // unreachable: a task that was not run, as on one core
    if (group_) group_->wait();
  }
};
#endif

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_PARALLEL_H
