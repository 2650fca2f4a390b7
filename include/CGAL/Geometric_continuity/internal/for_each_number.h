// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_FOR_EACH_NUMBER_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_FOR_EACH_NUMBER_H

#include <CGAL/Geometric_continuity/internal/for_each_block.h>

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Calls work(i) for the numbers 0 <= i < n, on several cores with Parallel_tag. If some calls throw, the exception for the least
// number leaves the function, as without cores.
template <class Concurrency_tag, class Work> void for_each_number(std::size_t n, const Work& work) {
  constexpr std::size_t grain = 16;
  std::atomic<std::size_t> failing(n); // the least number for which an exception was thrown
  std::exception_ptr error;
  std::mutex mutex;
  for_each_block<Concurrency_tag>(
      n,
      [&](std::size_t begin, std::size_t end) {
        std::size_t i = begin;
        try {
          for (; i < end && i < failing; ++i) work(i);
        } catch (...) {
          const std::lock_guard<std::mutex> lock(mutex);
          if (failing < i) return;
          failing = i;
          error = std::current_exception();
        }
      },
      grain);
  if (error) std::rethrow_exception(error);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_FOR_EACH_NUMBER_H
