// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_FOR_EACH_BLOCK_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_FOR_EACH_BLOCK_H

#include <CGAL/Geometric_continuity/internal/Steps_of_each.h>
#include <CGAL/Geometric_continuity/internal/several_cores.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Calls work(begin, end) for consecutive parts of [0, n), on several cores with Parallel_tag, where they are halved while they
// are larger than `grain`.
template <class Concurrency_tag, class Work>
void for_each_block(std::size_t n, const Work& work, [[maybe_unused]] std::size_t grain = 1024) {
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible_v<Concurrency_tag, Parallel_tag>) {
    if (!several_cores()) return work(std::size_t(0), n);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain),
                      [&work, steps = Steps_of_each::steps()](const tbb::blocked_range<std::size_t>& r) {
                        const Steps_of_each each(steps);
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

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_FOR_EACH_BLOCK_H
