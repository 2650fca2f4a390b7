// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIATION_CELLS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIATION_CELLS_H

#include "formats/font/Variable_join.h"
#include <CGAL/Geometric_continuity/algebra/Bernstein_tensor.h>

#include <algorithm>
#include <cstddef>
#include <vector>

/// The cells of the space of instances on which both legs of a join are multi-affine: between the numbers at which a scalar
/// bends.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The cells of a join, which are numbered, and the vectors of its legs on them.
class Variation_cells {
public:
  typedef CGAL::Exact_rational FT;
  typedef Bernstein_tensor<FT> Polynomial;

  // a x b and a . b of the legs as functions on a cell.
  struct Products {
    Polynomial cross, dot;
  };

  Variation_cells(const Variable_join& join, const std::vector<Variation_region>& regions,
                  const std::vector<Variation_axis>& axes)
      : join_(&join), regions_(&regions), axes_(axes.size()) {
    for (std::size_t r = 0; r < regions.size(); ++r)
      if (moves(join.incoming.shifts[r]) || moves(join.outgoing.shifts[r])) moving_.push_back(r);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      std::vector<FT> breaks{FT(axes[k].lowest()), FT(0), FT(axes[k].highest())}, single;
      bool counts = false;
      for (std::size_t r : moving_) {
        const Region_axis& axis = regions[r].axes()[k];
        if (!axis.counts()) continue;
        counts = true;
        for (int units : {axis.start, axis.peak, axis.end}) {
          const FT x = Variation_region::value(units);
          if (breaks[0] < x && x < breaks[2]) breaks.push_back(x);
          if (axis.start == axis.end && breaks[0] <= x && x <= breaks[2]) single.push_back(x);
        }
      }
      sort(breaks);
      if (!counts || breaks.size() == 1) continue;
      sort(single); // values that are a cell of their own, where a scalar is 1 and 0 on both sides
      breaks.insert(breaks.end(), single.begin(), single.end());
      std::sort(breaks.begin(), breaks.end());
      active_.push_back(k);
      size_ *= static_cast<double>(breaks.size() - 1);
      breaks_.push_back(std::move(breaks));
    }
  }

  // On how many axes the join depends.
  int variables() const { return static_cast<int>(active_.size()); }

  // How many cells there are; there can be very many.
  double size() const { return size_; }

  // How much work they are, where 1 is a box of the search.
  double work() const { return size_ * (1 + static_cast<double>(moving_.size()) / 16); }

  // The products on a cell, whose unit cube has the least values at its origin.
  Products products(std::size_t cell) const {
    const Legs legs = this->legs(cell);
    return {legs.a[0] * legs.b[1] - legs.a[1] * legs.b[0], legs.a[0] * legs.b[0] + legs.a[1] * legs.b[1]};
  }

  // Cross and dot product at a point of the unit cube of a cell.
  std::pair<FT, FT> products_at(std::size_t cell, const std::vector<FT>& t) const {
    const Legs legs = this->legs(cell);
    const FT ax = legs.a[0](t), ay = legs.a[1](t), bx = legs.b[0](t), by = legs.b[1](t);
    return {FT(ax * by - ay * bx), FT(ax * bx + ay * by)};
  }

  // The normalised values of all axes at a point of the unit cube of a cell.
  std::vector<FT> instance(std::size_t cell, const std::vector<FT>& t) const {
    std::vector<FT> values(axes_, FT(0));
    for (std::size_t v = 0; v < active_.size(); ++v) {
      const Interval i = interval(cell, v);
      values[active_[v]] = i.lower + t[v] * (i.upper - i.lower);
    }
    return values;
  }

private:
  const Variable_join* join_;
  const std::vector<Variation_region>* regions_;
  std::size_t axes_;
  std::vector<std::size_t> moving_; // the regions that move a leg
  std::vector<std::size_t> active_; // the axes on which that depends
  std::vector<std::vector<FT>> breaks_;
  double size_ = 1;

  struct Interval {
    FT lower, upper;
  };
  struct Legs {
    std::vector<Polynomial> a, b;
  };

  // In order, each once.
  static void sort(std::vector<FT>& x) {
    std::sort(x.begin(), x.end());
    x.erase(std::unique(x.begin(), x.end()), x.end());
  }

  static bool moves(const Outline_vector& v) { return v[0] != FT(0) || v[1] != FT(0); }

  // What a cell is along active axis v.
  Interval interval(std::size_t cell, std::size_t v) const {
    for (std::size_t w = 0; w < v; ++w) cell /= breaks_[w].size() - 1;
    const std::size_t i = cell % (breaks_[v].size() - 1);
    return {breaks_[v][i], breaks_[v][i + 1]};
  }

  // The scalar of a region at each corner of a cell.
  std::vector<FT> corner_scalars(std::size_t cell, const Variation_region& region) const {
    std::vector<FT> scalars(std::size_t(1) << active_.size(), FT(1));
    for (std::size_t k = 0, v = 0; k < axes_; ++k) {
      const bool active = v < active_.size() && active_[v] == k;
      const Interval i = active ? interval(cell, v) : Interval{FT(0), FT(0)};
      const FT low = region.scalar(k, i.lower, i.lower, i.upper), high = region.scalar(k, i.upper, i.lower, i.upper);
      for (std::size_t corner = 0; corner < scalars.size(); ++corner)
        scalars[corner] *= active && (corner >> v & 1) != 0 ? high : low;
      v += active;
    }
    return scalars;
  }

  Legs legs(std::size_t cell) const {
    const std::size_t corners = std::size_t(1) << active_.size();
    std::vector<FT> values[4];
    for (std::size_t c = 0; c < 4; ++c)
      values[c].assign(corners, (c < 2 ? join_->incoming : join_->outgoing).constant[c % 2]);
    for (std::size_t r : moving_) {
      const std::vector<FT> scalars = corner_scalars(cell, (*regions_)[r]);
      for (std::size_t c = 0; c < 4; ++c) {
        const FT& shift = (c < 2 ? join_->incoming : join_->outgoing).shifts[r][c % 2];
        for (std::size_t corner = 0; corner < corners; ++corner)
          if (scalars[corner] != FT(0)) values[c][corner] += scalars[corner] * shift;
      }
    }
    const auto polynomial = [&](std::size_t c) { return Polynomial(variables(), 1, values[c]); };
    return {{polynomial(0), polynomial(1)}, {polynomial(2), polynomial(3)}};
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIATION_CELLS_H
