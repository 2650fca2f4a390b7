// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_KNOT_RUNS_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_KNOT_RUNS_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The knots of a spline as they are read, equal ones once with their multiplicity, and then as they are taken, from the first on.
template <class Number> class G2_knot_runs {
  struct Run {
    Number knot;
    std::size_t multiplicity;
  };

  std::vector<Run> runs_;
  std::size_t size_ = 0, run_ = 0, taken_ = 0; // taken of the current run

public:
  typedef Number value_type;

  void clear() {
    runs_.clear();
    size_ = run_ = taken_ = 0;
  }

  std::size_t size() const { return size_; }
  const Number& front() const { return runs_.front().knot; }
  const Number& back() const { return runs_.back().knot; }

  void push_back(const Number& knot) {
    if (size_++ > 0 && knot == back())
      ++runs_.back().multiplicity;
    else
      runs_.push_back({knot, 1});
  }

  // Returns one knot after the other, from the first on. \pre not called more often than there are knots
  const Number& take() {
    if (taken_ == runs_[run_].multiplicity) {
      ++run_;
      taken_ = 0;
    }
    ++taken_;
    return runs_[run_].knot;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_KNOT_RUNS_H
