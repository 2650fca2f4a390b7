// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIATION_CELLS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIATION_CELLS_H

#include "formats/font/Bernstein_tensor.h"
#include "formats/font/Variable_join.h"

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

// The cells of the space of instances on which both sides of a join are multi-affine: between the
// numbers at which a scalar bends.

namespace CGAL {
namespace Geometric_continuity {

// A part of a cell; of the cell's axes those are free on which it has a width.
struct Variation_box {
  std::size_t cell;
  std::vector<double> lower, upper; // in the unit cube of the cell, one for each axis of the cells

  bool is_free(std::size_t v) const { return lower[v] < upper[v]; }

  std::vector<std::size_t> free_axes() const {
    std::vector<std::size_t> free;
    for (std::size_t v = 0; v < lower.size(); ++v)
      if (is_free(v)) free.push_back(v);
    return free;
  }
};

// The cells of a join, which are numbered, and its sides on them.
class Variation_cells {
public:
  typedef Variable_join::FT FT;

  // a x b and a . b of the sides as functions on a box, in its free axes. NT: exact numbers, or
  // intervals
  template <class NT> struct Products { Bernstein_tensor<NT> cross, dot; };

  Variation_cells(const Variable_join& join, const std::vector<Variation_region>& regions,
                  const std::vector<Variation_range>& axes)
      : join_(&join), regions_(&regions), axes_(axes.size()) {
    for (std::size_t r = 0; r < regions.size(); ++r)
      if ((moves(join.incoming.shifts[r]) || moves(join.outgoing.shifts[r])) && is_met(regions[r], axes))
        moving_.push_back(r);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      std::vector<double> breaks{axes[k].lowest, 0, axes[k].highest}, single;
      bool counts = false;
      for (std::size_t r : moving_) {
        const Region_axis& axis = regions[r].axes()[k];
        if (!axis.counts()) continue;
        counts = true;
        for (double x : {axis.start, axis.peak, axis.end}) {
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

  // On how many axes the join depends, and how many regions move it.
  std::size_t variables() const { return active_.size(); }
  std::size_t regions() const { return moving_.size(); }

  // How many cells there are; there can be very many.
  double size() const { return size_; }

  // Returns whether the sides are parallel at every instance because what moves them is, whatever
  // the scalars are.
  bool is_parallel() const {
    const std::size_t n = moving_.size();
    for (std::size_t i = 0; i <= n; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const Vector &a = vector(join_->incoming, i), &b = vector(join_->outgoing, j);
        FT cross = a[0] * b[1] - a[1] * b[0];
        if (i != j) {
          const Vector &c = vector(join_->incoming, j), &d = vector(join_->outgoing, i);
          cross += c[0] * d[1] - c[1] * d[0];
        }
        if (cross != FT(0)) return false;
      }
    return true;
  }

  // The interval of a cell along each axis.
  struct Interval {
    double lower, upper;
  };
  typedef std::vector<Interval> Cell;
  Cell cell(std::size_t number) const {
    Cell cell;
    for (const std::vector<double>& breaks : breaks_) {
      const std::size_t i = number % (breaks.size() - 1);
      cell.push_back({breaks[i], breaks[i + 1]});
      number /= breaks.size() - 1;
    }
    return cell;
  }

  // A whole cell, without width along the axes on which the sides do not depend there.
  Variation_box whole(std::size_t number) const {
    Variation_box box{number, {}, {}};
    const Cell cell = this->cell(number);
    // nearest to the default
    for (const Interval& i : cell) box.lower.push_back(i.upper == 0 ? 1 : 0);
    box.upper = box.lower;
    for_each_region(cell, [&](const Vector&, const Vector&, std::size_t r) {
      for (std::size_t v = 0; v < variables(); ++v)
        if (counts(r, v) && cell[v].lower < cell[v].upper) {
          box.lower[v] = 0;
          box.upper[v] = 1;
        }
    });
    return box;
  }

  // The products on a box, as polynomials on its own unit cube.
  template <class NT> Products<NT> products(const Variation_box& box) const {
    const Sides<NT> sides = this->sides<NT>(box);
    return {sides.a[0] * sides.b[1] - sides.a[1] * sides.b[0], sides.a[0] * sides.b[0] + sides.a[1] * sides.b[1]};
  }

  // Cross and dot product at a point of the unit cube of a cell.
  std::pair<FT, FT> products_at(std::size_t number, const std::vector<double>& t) const {
    std::vector<FT> scalars(regions_->size(), FT(0));
    const Cell cell = this->cell(number);
    for_each_region(cell, [&](const Vector&, const Vector&, std::size_t r) {
      scalars[r] = 1;
      for (std::size_t v = 0; v < variables(); ++v) scalars[r] *= factor(r, cell, v, FT(t[v]));
    });
    return join_->products(scalars);
  }

  // The values of all axes at a point of the unit cube of a cell.
  std::vector<FT> instance(std::size_t number, const std::vector<double>& t) const {
    std::vector<FT> values(axes_, FT(0));
    const Cell cell = this->cell(number);
    for (std::size_t v = 0; v < active_.size(); ++v)
      values[active_[v]] = FT(cell[v].lower) + FT(t[v]) * (FT(cell[v].upper) - FT(cell[v].lower));
    return values;
  }

  // For each region that moves a side on a cell, calls f with its shift of both sides, and its
  // number for factor().
  template <class Use> void for_each_region(const Cell& cell, Use f) const {
    for (std::size_t r : moving_)
      if (!vanishes(cell, r)) f(join_->incoming.shifts[r], join_->outgoing.shifts[r], r);
  }

  // The sides without their regions.
  const Variable_vector::Vector& incoming() const { return join_->incoming.constant; }
  const Variable_vector::Vector& outgoing() const { return join_->outgoing.constant; }

  // The factor of a region along axis v at t in the unit cube of a cell. \tparam NT exact numbers,
  // or intervals
  template <class NT> NT factor(std::size_t region, const Cell& cell, std::size_t v, const NT& t) const {
    const Interval i = cell[v];
    const NT value = NT(i.lower) + t * (NT(i.upper) - NT(i.lower));
    return (*regions_)[region].factor(active_[v], value, i.lower, i.upper);
  }

  // Returns whether the scalar of a region depends on axis v.
  bool counts(std::size_t region, std::size_t v) const { return (*regions_)[region].axes()[active_[v]].counts(); }

private:
  typedef Variable_vector::Vector Vector;

  const Variable_join* join_;
  const std::vector<Variation_region>* regions_;
  std::size_t axes_;
  std::vector<std::size_t> moving_; // the regions that move a side
  std::vector<std::size_t> active_; // the axes on which that depends
  std::vector<std::vector<double>> breaks_;
  double size_ = 1;

  template <class NT> struct Sides { std::vector<Bernstein_tensor<NT>> a, b; };

  // In order, each once.
  static void sort(std::vector<double>& x) {
    std::sort(x.begin(), x.end());
    x.erase(std::unique(x.begin(), x.end()), x.end());
  }

  static bool moves(const Vector& v) { return v[0] != FT(0) || v[1] != FT(0); }

  // Returns the vector number i that moves a side, where 0 is its constant part.
  const Vector& vector(const Variable_vector& side, std::size_t i) const {
    return i == 0 ? side.constant : side.shifts[moving_[i - 1]];
  }

  // Returns whether the scalar of a region is not zero everywhere because it depends on an axis
  // that stays at 0.
  static bool is_met(const Variation_region& region, const std::vector<Variation_range>& axes) {
    for (std::size_t k = 0; k < axes.size(); ++k)
      if (region.axes()[k].counts() && axes[k].lowest == axes[k].highest) return false;
    return true;
  }

  // Returns whether the scalar of a region is zero all over a cell.
  bool vanishes(const Cell& cell, std::size_t region) const {
    for (std::size_t v = 0; v < active_.size(); ++v) {
      const Region_axis& axis = (*regions_)[region].axes()[active_[v]];
      if (!axis.counts()) continue;
      const Interval i = cell[v];
      if ((i.upper <= axis.start || axis.end <= i.lower) && !(i.lower == axis.peak && i.upper == axis.peak))
        return true;
    }
    return false;
  }

  // The scalar of a region at each corner of a box.
  template <class NT>
  std::vector<NT> corner_scalars(const Variation_box& box, const Cell& cell, std::size_t corners, std::size_t r) const {
    std::vector<NT> scalars(corners, NT(1));
    for (std::size_t v = 0, f = 0; v < active_.size(); ++v) {
      const bool is_free = box.is_free(v);
      if (counts(r, v)) {
        const NT low = factor(r, cell, v, NT(box.lower[v])),
                 high = is_free ? factor(r, cell, v, NT(box.upper[v])) : low;
        for (std::size_t corner = 0; corner < scalars.size(); ++corner)
          scalars[corner] *= is_free && (corner >> f & 1) != 0 ? high : low;
      }
      f += is_free;
    }
    return scalars;
  }

  template <class NT> static NT number(const FT& x) {
    if constexpr (std::is_same_v<NT, FT>)
      return x;
    else
      return NT(CGAL::to_interval(x));
  }

  template <class NT> Sides<NT> sides(const Variation_box& box) const {
    const std::vector<std::size_t> free = box.free_axes();
    const std::size_t corners = std::size_t(1) << free.size();
    std::vector<NT> values[4];
    for (std::size_t c = 0; c < 4; ++c) values[c].assign(corners, number<NT>((c < 2 ? incoming() : outgoing())[c % 2]));
    const Cell cell = this->cell(box.cell);
    for_each_region(cell, [&](const Vector& a, const Vector& b, std::size_t r) {
      const std::vector<NT> scalars = corner_scalars<NT>(box, cell, corners, r);
      for (std::size_t c = 0; c < 4; ++c) {
        const NT shift = number<NT>((c < 2 ? a : b)[c % 2]);
        for (std::size_t corner = 0; corner < corners; ++corner)
          if (!(scalars[corner] == NT(0))) values[c][corner] += scalars[corner] * shift;
      }
    });
    const auto polynomial = [&](std::size_t c) {
      return Bernstein_tensor<NT>(static_cast<int>(free.size()), 1, values[c]);
    };
    return {{polynomial(0), polynomial(1)}, {polynomial(2), polynomial(3)}};
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_VARIATION_CELLS_H
