// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_KINK_BOXES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_KINK_BOXES_H

#include <CGAL/Exact_rational.h>
#include <CGAL/FPU.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_tensor.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

/// Parts of the space of instances, each with guaranteed bounds of the tangent of an angle, of which the one with the
/// largest bound is halved again and again.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The boxes for the angles whose sines and cosines are proportional to two polynomials in up to three variables.
class Kink_boxes {
  typedef CGAL::Interval_nt<false> Interval;
  typedef Bernstein_tensor<Interval> Polynomial;
  typedef std::array<double, 3> Place; // in the unit cube of a cell

  struct Box {
    std::size_t cell;
    Place origin, width; // exact: halves of halves
    Polynomial cross, dot;
    double upper; // of |cross| / dot in the box; infinite when an angle may be a right one or larger

    friend bool operator<(const Box& x, const Box& y) { return x.upper < y.upper; }
  };

  const std::size_t variables_;
  std::vector<Box> heap_;
  std::size_t size_ = 0;
  double lower_ = -1; // of |cross| / dot at a place that is known, infinite where dot is not positive
  std::size_t cell_ = 0;
  Place place_{};
  bool vanishes_ = false;

  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  static constexpr double half_turn = 3.1415926535897936; // a little more than pi

  explicit Kink_boxes(int variables) : variables_(static_cast<std::size_t>(variables)) {}

  // Adds a cell.
  void push(std::size_t cell, const Bernstein_tensor<CGAL::Exact_rational>& cross,
            const Bernstein_tensor<CGAL::Exact_rational>& dot) {
    const CGAL::Protect_FPU_rounding<true> protection;
    add({cell, {}, {1, 1, 1}, in_intervals(cross), in_intervals(dot), 0});
  }

  // Halves the box with the largest bound across its longest side.
  void split() {
    const CGAL::Protect_FPU_rounding<true> protection;
    std::pop_heap(heap_.begin(), heap_.end());
    const Box box = std::move(heap_.back());
    heap_.pop_back();
    const auto longest = std::max_element(box.width.begin(), box.width.begin() + variables_);
    const std::size_t v = static_cast<std::size_t>(longest - box.width.begin());
    std::pair<Polynomial, Polynomial> cross = box.cross.split(static_cast<int>(v), Interval(0.5)),
                                      dot = box.dot.split(static_cast<int>(v), Interval(0.5));
    Place origin = box.origin, width = box.width;
    width[v] /= 2;
    add({box.cell, origin, width, std::move(cross.first), std::move(dot.first), 0});
    origin[v] += width[v];
    add({box.cell, origin, width, std::move(cross.second), std::move(dot.second), 0});
  }

  // How many boxes there have been.
  std::size_t size() const { return size_; }

  // Guaranteed bounds of the largest tangent of an angle; infinite when that is or may be a right one or larger.
  double lower() const { return (std::max)(lower_, 0.0); }
  double upper() const { return heap_.empty() ? lower() : (std::max)(heap_.front().upper, lower()); }

  // The place where the angle is at least as large as lower() says.
  std::size_t cell() const { return cell_; }
  std::vector<double> place() const {
    return {place_.begin(), place_.begin() + static_cast<std::ptrdiff_t>(variables_)};
  }

  // Whether both polynomials are certainly zero at the corner of a box.
  bool vanishes() const { return vanishes_; }

private:
  static Polynomial in_intervals(const Bernstein_tensor<CGAL::Exact_rational>& p) {
    std::vector<Interval> c;
    for (const CGAL::Exact_rational& x : p.coefficients()) c.emplace_back(CGAL::to_interval(x));
    return Polynomial(p.variables(), p.degree(), std::move(c));
  }

  static bool is_zero(const Interval& x) { return x.inf() == 0 && x.sup() == 0; }

  // Bounds of |cross| / dot for dot > 0.
  static Interval tangent(const Interval& cross, const Interval& dot) { return CGAL::abs(cross) / dot; }

  // With the rounding mode of intervals.
  void add(Box box) {
    ++size_;
    for (std::size_t corner = 0; corner < (std::size_t(1) << variables_); ++corner) {
      const std::size_t i = box.cross.corner_index(corner);
      const Interval &cross = box.cross[i], &dot = box.dot[i];
      if (is_zero(cross) && is_zero(dot)) {
        vanishes_ = true;
        continue;
      }
      const double tangent_here = dot.inf() > 0 ? tangent(cross, dot).inf() : dot.sup() <= 0 ? infinity : -1;
      if (tangent_here <= lower_) continue;
      lower_ = tangent_here;
      cell_ = box.cell;
      for (std::size_t v = 0; v < variables_; ++v)
        place_[v] = box.origin[v] + ((corner >> v & 1) != 0 ? box.width[v] : 0);
    }
    for (std::size_t i = 0; i < box.cross.coefficients().size(); ++i)
      if (box.dot[i].inf() > 0)
        box.upper = (std::max)(box.upper, tangent(box.cross[i], box.dot[i]).sup());
      else if (!is_zero(box.cross[i]) || !is_zero(box.dot[i]))
        box.upper = infinity;
    heap_.push_back(std::move(box));
    std::push_heap(heap_.begin(), heap_.end());
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_KINK_BOXES_H
