// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_KINK_BOXES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_KINK_BOXES_H

#include "formats/font/Bernstein_tensor.h"
#include "formats/font/Centered_sides.h"
#include "formats/font/Variation_cells.h"
#include <CGAL/FPU.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

// Parts of the space of instances, each with a guaranteed bound of the tangent of the angle of a
// join, of which the one with the largest bound is halved again and again.

namespace CGAL {
namespace Geometric_continuity {

// The boxes of a join. Those with few free axes have the Bernstein coefficients of both products,
// which are exact for whole cells and bound the angle even where a side vanishes at a corner; those
// with more have centered forms, and lose the axes along which the angle rises or falls everywhere.
class Kink_boxes {
  typedef CGAL::Interval_nt<false> Interval;
  typedef Bernstein_tensor<Interval> Polynomial;

  struct Box {
    Variation_box place;
    // cross and dot; none with many free axes
    std::optional<std::pair<Polynomial, Polynomial>> products;
    // of |cross| / dot in the box; infinite when an angle may be a right one or larger
    double upper;
    std::size_t bent = 0; // the axis to halve, of those without polynomials

    friend bool operator<(const Box& x, const Box& y) { return x.upper < y.upper; }
  };

  const Variation_cells& cells_;
  const bool parallel_;
  std::vector<Box> heap_;
  double steps_ = 0;
  double settled_ = 0; // the largest bound of the boxes that cannot be halved
  // of |cross| / dot at a place that is known, infinite where dot is not positive
  double lower_ = -1;
  std::size_t cell_ = 0;
  std::vector<double> point_;
  bool vanishes_ = false;

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::size_t most_exact_axes = 3, most_polynomial_axes = 6;

public:
  static constexpr double half_turn = 3.1415926535897936; // a little more than pi

  explicit Kink_boxes(const Variation_cells& cells)
      : cells_(cells), parallel_(cells.is_parallel()), point_(cells.variables(), 0) {}

  // Adds a cell.
  void push(std::size_t cell) {
    const CGAL::Protect_FPU_rounding<true> protection;
    add(cells_.whole(cell));
  }

  // Halves the box with the largest bound.
  void split() {
    const CGAL::Protect_FPU_rounding<true> protection;
    std::pop_heap(heap_.begin(), heap_.end());
    const Box box = std::move(heap_.back());
    heap_.pop_back();
    Variation_box first = box.place, second = box.place;
    const auto halve = [&](std::size_t v) {
      // exact
      first.upper[v] = second.lower[v] = box.place.lower[v] + (box.place.upper[v] - box.place.lower[v]) / 2;
    };
    if (!box.products) {
      halve(box.bent);
      add(std::move(first));
      add(std::move(second));
      return;
    }
    const std::vector<std::size_t> free = box.place.free_axes();
    std::size_t widest = 0;
    for (std::size_t f = 1; f < free.size(); ++f)
      if (width(box.place, free[f]) > width(box.place, free[widest])) widest = f;
    if (free.empty()) { // a point, of which nothing more can be known
      settled_ = (std::max)(settled_, box.upper);
      return;
    }
    halve(free[widest]);
    const int variable = static_cast<int>(widest);
    std::pair<Polynomial, Polynomial> cross = box.products->first.split(variable, Interval(0.5)),
                                      dot = box.products->second.split(variable, Interval(0.5));
    add({std::move(first), std::make_pair(std::move(cross.first), std::move(dot.first)), 0});
    add({std::move(second), std::make_pair(std::move(cross.second), std::move(dot.second)), 0});
  }

  // Returns whether there is nothing to halve.
  bool empty() const { return heap_.empty(); }

  // How much work there has been, in the steps of Work_limit.
  double steps() const { return steps_; }

  // Guaranteed bounds of the largest tangent of an angle; infinite when that is or may be a right
  // one or larger.
  double lower() const { return (std::max)(lower_, 0.0); }
  double upper() const { return (std::max)({heap_.empty() ? 0 : heap_.front().upper, settled_, lower()}); }

  // The place where the angle is at least as large as lower() says.
  std::size_t cell() const { return cell_; }
  const std::vector<double>& point() const { return point_; }

  // Returns whether both products are certainly zero at the corner of a box.
  bool vanishes() const { return vanishes_; }

private:
  static double width(const Variation_box& box, std::size_t v) { return box.upper[v] - box.lower[v]; }

  static Polynomial in_intervals(const Bernstein_tensor<Variation_cells::FT>& p) {
    std::vector<Interval> c;
    for (const Variation_cells::FT& x : p.coefficients()) c.emplace_back(CGAL::to_interval(x));
    return Polynomial(p.variables(), p.degree(), std::move(c));
  }

  static bool is_zero(const Interval& x) { return x.inf() == 0 && x.sup() == 0; }

  // Bounds of |cross| / dot for dot > 0.
  static Interval tangent(const Interval& cross, const Interval& dot) { return CGAL::abs(cross) / dot; }

  // Takes note of the products at a corner of a box.
  void meet(const Variation_box& box, const Interval& cross, const Interval& dot, const std::vector<bool>& corner) {
    if (is_zero(cross) && is_zero(dot)) {
      vanishes_ = true;
      return;
    }
    const double tangent_here = dot.inf() > 0 ? tangent(cross, dot).inf() : dot.sup() <= 0 ? infinity : -1;
    if (tangent_here <= lower_) return;
    lower_ = tangent_here;
    cell_ = box.cell;
    point_ = box.lower;
    for (std::size_t v = 0, k = 0; v < point_.size(); ++v)
      if (box.is_free(v) && corner[k++]) point_[v] = box.upper[v];
  }

  // The following functions have the rounding mode of intervals.
  void add(Variation_box place) {
    for (std::size_t free = place.free_axes().size(); free > most_exact_axes; free = place.free_axes().size()) {
      const Centered_sides sides(cells_, place);
      steps_ += 2 * Centered_sides::steps(cells_, free);
      double upper = 0;
      bool counts[2]; // whether the angle to either side may be the largest one
      for (int side : {0, 1}) {
        const int sign = 1 - 2 * side;
        const double bound = sides.upper(sign), here = parallel_ && std::isfinite(bound) ? 0 : bound;
        counts[side] = here > lower_;
        upper = (std::max)(upper, here);
        if (!counts[side]) continue;
        const std::vector<bool> corner = sides.corner(sign, std::isinf(here) ? lower_or_one() : here);
        const auto [cross, dot] = sides.products_at(place, corner);
        meet(place, cross, dot, corner);
      }
      if (upper <= lower()) return;
      if (std::isfinite(upper) && reduce(place, sides, counts, upper)) continue;
      if (free <= most_polynomial_axes) break;
      keep({std::move(place), std::nullopt, upper,
            sides.axis(sides.bent_axis(std::isinf(upper) ? lower_or_one() : upper))});
      return;
    }
    const double free = static_cast<double>(place.free_axes().size()), corners = std::exp2(free),
                 multiplications = 4 * corners * corners + (2 + 4 * static_cast<double>(cells_.regions())) * corners;
    if (free > most_exact_axes) {
      Variation_cells::Products<Interval> products = cells_.products<Interval>(place);
      steps_ += 6 * multiplications;
      add({std::move(place), std::make_pair(std::move(products.cross), std::move(products.dot)), 0});
      return;
    }
    const Variation_cells::Products<Variation_cells::FT> products = cells_.products<Variation_cells::FT>(place);
    steps_ += 200 * multiplications; // of numbers of a word or two, which are allocated
    add({std::move(place), std::make_pair(in_intervals(products.cross), in_intervals(products.dot)), 0});
  }

  // Takes those axes from a box along which the angle to each side that counts rises or falls
  // everywhere, as far as it is larger than lower(), and returns whether there are some. The
  // largest angle is at one of their ends.
  bool reduce(Variation_box& place, const Centered_sides& sides, const bool counts[2], double upper) {
    steps_ += Centered_sides::steps(cells_, sides.free());
    bool reduced = false;
    for (std::size_t k = 1; k <= sides.free(); ++k) {
      const int left = counts[0] ? sides.slope(k, 1, lower(), upper) : 0,
                right = counts[1] ? sides.slope(k, -1, lower(), upper) : 0,
                slope = !counts[1]      ? left
                        : !counts[0]    ? right
                        : left == right ? left
                                        : 0;
      if (slope == 0) continue;
      const std::size_t v = sides.axis(k);
      (slope > 0 ? place.upper[v] : place.lower[v]) = slope > 0 ? place.lower[v] : place.upper[v];
      reduced = true;
    }
    return reduced;
  }

  double lower_or_one() const { return std::isfinite(lower_) && lower_ > 0 ? lower_ : 1; }

  void add(Box box) {
    const Polynomial &crosses = box.products->first, &dots = box.products->second;
    const std::size_t variables = static_cast<std::size_t>(crosses.variables());
    steps_ += 200 + 30 * static_cast<double>(crosses.coefficients().size());
    for (std::size_t corner = 0; corner < (std::size_t(1) << variables); ++corner) {
      const std::size_t i = crosses.corner_index(corner);
      std::vector<bool> bits;
      for (std::size_t k = 0; k < variables; ++k) bits.push_back((corner >> k & 1) != 0);
      meet(box.place, crosses[i], dots[i], bits);
    }
    for (std::size_t i = 0; i < crosses.coefficients().size(); ++i)
      if (dots[i].inf() > 0)
        box.upper = (std::max)(box.upper, tangent(crosses[i], dots[i]).sup());
      else if (!is_zero(crosses[i]) || !is_zero(dots[i]))
        box.upper = infinity;
    if (parallel_ && std::isfinite(box.upper)) box.upper = 0;
    keep(std::move(box));
  }

  // A box whose bound is not above what is attained need not be looked at again.
  void keep(Box box) {
    if (box.upper <= lower()) return;
    heap_.push_back(std::move(box));
    std::push_heap(heap_.begin(), heap_.end());
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_KINK_BOXES_H
