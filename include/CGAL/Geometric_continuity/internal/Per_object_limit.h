// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_PER_OBJECT_LIMIT_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_PER_OBJECT_LIMIT_H

#include <cstdint>
#include <utility>

// How many steps of work each object may take: what a thread hands on to those that work for it,
// see Work_limit.h.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Sets it for this thread, from here to the end of the block.
class Per_object_limit {
  const std::uint64_t before_;

  static std::uint64_t& of_this_thread() {
    static thread_local std::uint64_t steps = default_steps;
    return steps;
  }

public:
  static constexpr std::uint64_t default_steps = 4'000'000'000;

  explicit Per_object_limit(std::uint64_t steps) : before_(std::exchange(of_this_thread(), steps)) {}
  Per_object_limit(const Per_object_limit&) = delete;
  Per_object_limit& operator=(const Per_object_limit&) = delete;
  ~Per_object_limit() { of_this_thread() = before_; }

  static std::uint64_t steps() { return of_this_thread(); }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_PER_OBJECT_LIMIT_H
