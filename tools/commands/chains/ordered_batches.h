// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_ORDERED_BATCHES_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_ORDERED_BATCHES_H

#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#endif

// Calls read(batch), work(batch) and take(batch) for one batch after the other, until read()
// returns false: read() and take() in order, and work(), where TBB is there, on all cores, which
// have the limit of work of this thread. The memory of a batch is used again. No function may throw
// but take().
template <class Batch, class Read, class Work, class Take> void for_batches(Read read, Work work, Take take) {
#ifdef CGAL_LINKED_WITH_TBB
  const std::size_t cores = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  if (cores > 1) {
    const CGAL::Geometric_continuity::Work_limit limit = CGAL::Geometric_continuity::Work_scope::limit_of_each();
    std::mutex mutex;
    std::vector<std::unique_ptr<Batch>> batches;
    std::vector<Batch*> spare;
    const auto read_next = [&](tbb::flow_control& flow) -> Batch* {
      const CGAL::Geometric_continuity::Work_scope each(limit);
      Batch* batch = nullptr;
      {
        const std::lock_guard<std::mutex> lock(mutex);
        if (spare.empty()) {
          batches.push_back(std::make_unique<Batch>());
          spare.push_back(batches.back().get());
        }
        batch = spare.back();
        spare.pop_back();
      }
      if (read(*batch)) return batch;
      flow.stop();
      return nullptr;
    };
    const auto work_on = [&](Batch* batch) {
      const CGAL::Geometric_continuity::Work_scope each(limit);
      work(*batch);
      return batch;
    };
    const auto take_next = [&](Batch* batch) {
      const CGAL::Geometric_continuity::Work_scope each(limit);
      take(*batch);
      const std::lock_guard<std::mutex> lock(mutex);
      spare.push_back(batch);
    };
    tbb::parallel_pipeline(2 * cores, tbb::make_filter<void, Batch*>(tbb::filter_mode::serial_in_order, read_next) &
                                          tbb::make_filter<Batch*, Batch*>(tbb::filter_mode::parallel, work_on) &
                                          tbb::make_filter<Batch*, void>(tbb::filter_mode::serial_in_order, take_next));
    return;
  }
#endif
  Batch batch;
  while (read(batch)) {
    work(batch);
    take(batch);
  }
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_ORDERED_BATCHES_H
