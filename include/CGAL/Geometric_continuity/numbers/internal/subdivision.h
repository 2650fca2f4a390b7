// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_SUBDIVISION_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_SUBDIVISION_H

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

/// \file subdivision.h
/// Search by subdivision: parts of a domain are examined, and dropped or divided, until none is
/// left or enough is known.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// An interval of doubles.
struct Range {
  double lower, upper;

  double length() const { return upper - lower; }
  double middle() const { return lower / 2 + upper / 2; }
  bool is_divisible() const { return lower < middle() && middle() < upper; }
};

// The parts that are left, by which is next: the one that was added last, from left to right if the
// right half is added first.
template <class Part> class Newest_first {
  std::vector<Part> parts_;

public:
  bool empty() const { return parts_.empty(); }
  const Part& next() const { return parts_.back(); }
  void add(Part part) { parts_.push_back(std::move(part)); }
  Part take() {
    Part part = std::move(parts_.back());
    parts_.pop_back();
    return part;
  }
};

// The one that was added first: the longest.
template <class Part> class Oldest_first {
  std::deque<Part> parts_;

public:
  bool empty() const { return parts_.empty(); }
  const Part& next() const { return parts_.front(); }
  void add(Part part) { parts_.push_back(std::move(part)); }
  Part take() {
    Part part = std::move(parts_.front());
    parts_.pop_front();
    return part;
  }
};

// The largest one: branch and bound for the largest value, when parts are compared by its upper
// bound.
template <class Part> class Largest_first {
  std::vector<Part> parts_; // a heap

public:
  bool empty() const { return parts_.empty(); }
  const Part& next() const { return parts_.front(); }
  void add(Part part) {
    parts_.push_back(std::move(part));
    std::push_heap(parts_.begin(), parts_.end());
  }
  Part take() {
    std::pop_heap(parts_.begin(), parts_.end());
    Part part = std::move(parts_.back());
    parts_.pop_back();
    return part;
  }
  // The parts are in no order.
  auto begin() const { return parts_.begin(); }
  auto end() const { return parts_.end(); }
};

enum class After_part {
  drop,   // nothing more is asked of it
  divide, // and its parts are examined
  stop    // the search ends, and it is left
};

// Examines parts until none is left, examine(part), and divides them, divide(part). Returns false
// if the search has been stopped.
template <class Parts, class Examine, class Divide>
bool subdivide(Parts& parts, const Examine& examine, const Divide& divide) {
  while (!parts.empty()) {
    const After_part after = examine(parts.next());
    if (after == After_part::stop) return false;
    const auto part = parts.take();
    if (after == After_part::divide) divide(part);
  }
  return true;
}

// Examines ranges, which are halved, the left half first.
template <class Examine> bool subdivide(Newest_first<Range>& parts, const Examine& examine) {
  return subdivide(parts, examine, [&](const Range& part) {
    parts.add({part.middle(), part.upper});
    parts.add({part.lower, part.middle()});
  });
}
template <class Examine> bool subdivide(Oldest_first<Range>& parts, const Examine& examine) {
  return subdivide(parts, examine, [&](const Range& part) {
    parts.add({part.lower, part.middle()});
    parts.add({part.middle(), part.upper});
  });
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_SUBDIVISION_H
