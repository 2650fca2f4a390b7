// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_CELL_DIAGONALS_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_CELL_DIAGONALS_H

#include <CGAL/Geometric_continuity/local/coordinates.h>
#include <CGAL/Geometric_continuity/numbers/internal/Rational_parts.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

/// \file Cell_diagonals.h
/// Which of the two diagonals of a cell of a grid is shorter.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Compares the diagonals of the cells between two rows of points. The answers are those of the number type. For rational
// numbers they are found by intervals of floating-point numbers wherever these suffice.
template <class Traits> class Cell_diagonals {
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  typedef Interval_nt<false> Interval;
  static constexpr bool filtered = Rational_parts<FT>::value;

  const std::vector<Point>& points_;
  struct Row {
    std::vector<std::size_t> numbers; // of points
    std::vector<std::array<Interval, 3>> boxes;
  };
  Row low_, high_;

public:
  explicit Cell_diagonals(const std::vector<Point>& points) : points_(points) {}

  // The upper row becomes the lower one; `point(j)` is the number of the point number j < n of the next row.
  template <class Function> void next_row(std::size_t n, const Function& point) {
    std::swap(low_, high_);
    high_.numbers.clear();
    high_.boxes.clear();
    for (std::size_t j = 0; j < n; ++j) {
      high_.numbers.push_back(point(j));
      if constexpr (filtered) {
        const Coordinates<Traits> x = coordinates<Traits>(points_[high_.numbers[j]]);
        high_.boxes.push_back(
            {Interval(CGAL::to_interval(x[0])), Interval(CGAL::to_interval(x[1])), Interval(CGAL::to_interval(x[2]))});
      }
    }
  }

  // Of the cell between the points number j and j + 1: whether the diagonal from number j of the lower row is shorter than the
  // other, equal, or longer.
  Comparison_result operator()(std::size_t j) const {
    if constexpr (filtered) {
      const Protect_FPU_rounding<true> protection;
      const Interval difference = square(low_.boxes[j], high_.boxes[j + 1]) - square(low_.boxes[j + 1], high_.boxes[j]);
      if (difference.sup() < 0) return SMALLER;
      if (difference.inf() > 0) return LARGER;
    }
    return CGAL::compare(square(low_.numbers[j], high_.numbers[j + 1]), square(low_.numbers[j + 1], high_.numbers[j]));
  }

private:
  // The squares of distances.
  static Interval square(const std::array<Interval, 3>& p, const std::array<Interval, 3>& q) {
    return CGAL::square(p[0] - q[0]) + CGAL::square(p[1] - q[1]) + CGAL::square(p[2] - q[2]);
  }
  FT square(std::size_t i, std::size_t j) const {
    const Coordinates<Traits> d = coordinates<Traits>(points_[i]) - coordinates<Traits>(points_[j]);
    return dot(d, d);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_CELL_DIAGONALS_H
