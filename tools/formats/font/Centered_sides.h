// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CENTERED_SIDES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CENTERED_SIDES_H

#include "formats/font/Variation_cells.h"
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// Both sides of a join on a box with many free axes, in the time that the number of regions and the
// square of the number of axes take, where Bernstein coefficients would be exponentially many.

namespace CGAL {
namespace Geometric_continuity {

// With the coordinates x in [-1, 1] of the n free axes, a = a_0 + sum x_k a_k + sum e_r A_r, where
// A_r is the shift of region r and e_r the rest of its scalar, which is of higher order; the same
// for b. So a x b and a . b are quadratic forms in x and an error. The rounding mode must be that
// of intervals.
class Centered_sides {
public:
  typedef CGAL::Interval_nt<false> Interval;

private:
  typedef std::array<Interval, 2> Vector;

  // A bilinear form of two vectors, a x b and a . b.
  struct Products {
    Interval cross, dot;
    friend Products operator+(const Products& p, const Products& q) { return {p.cross + q.cross, p.dot + q.dot}; }
    // alpha a . b + beta a x b
    Interval operator()(const Interval& alpha, const Interval& beta) const { return alpha * dot + beta * cross; }
  };
  struct Region {
    std::size_t number;
    Vector a, b;   // shifts
    Interval rest; // a bound of |e_r|
    // bounds of how far its derivatives are from those at the center
    std::vector<Interval> slope_rest;
    Products products; // of A_r and b_0, and of a_0 and B_r
  };

  const Variation_cells* cells_;
  Variation_cells::Cell cell_;
  std::vector<std::size_t> free_;
  std::vector<Vector> a_, b_; // a_0 and the a_k
  std::vector<Region> regions_;
  std::vector<Products> forms_; // of x_k x_l for k <= l; x_0 is 1
  Vector rest_a_{Interval(0), Interval(0)}, rest_b_ = rest_a_, sum_a_ = rest_a_,
                                            // bounds of what is added to a_0 and b_0
      sum_b_ = rest_a_;
  Products rest_{Interval(0), Interval(0)};

  static Interval interval(const Variable_join::FT& x) { return CGAL::to_interval(x); }
  static Interval magnitude(const Interval& x) { return Interval((std::max)(-x.inf(), x.sup())); }
  static Vector magnitude(const Vector& v) { return {magnitude(v[0]), magnitude(v[1])}; }
  static Interval bound(const Interval& x) { return Interval((std::max)(x.sup(), 0.0)); }

  static Products products(const Vector& a, const Vector& b) {
    return {a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]};
  }
  // Bounds of the products of vectors that are bounded.
  static Products bounds(const Vector& a, const Vector& b) {
    return {a[0] * b[1] + a[1] * b[0], a[0] * b[0] + a[1] * b[1]};
  }
  static void add(Vector& v, const Interval& s, const Vector& w) {
    for (std::size_t c = 0; c < 2; ++c) v[c] += s * w[c];
  }

  std::size_t place(std::size_t k, std::size_t l) const {
    if (l < k) std::swap(k, l);
    return k * free_.size() - k * (k + 1) / 2 + k + l;
  }
  const Products& form(std::size_t k, std::size_t l) const { return forms_[place(k, l)]; }

  void add_region(const Variation_box& box, const Vector& a, const Vector& b, std::size_t r) {
    Interval constant(1);
    std::vector<std::pair<Interval, Interval>> factors; // middle and half of the difference
    std::vector<std::size_t> axes;
    for (std::size_t v = 0, k = 0; v < box.lower.size(); ++v) {
      const bool is_free = box.is_free(v);
      k += is_free;
      if (!cells_->counts(r, v)) continue;
      const Interval low = cells_->factor(r, cell_, v, Interval(box.lower[v]));
      if (!is_free) {
        constant *= low;
        continue;
      }
      const Interval high = cells_->factor(r, cell_, v, Interval(box.upper[v]));
      factors.emplace_back((low + high) * Interval(0.5), (high - low) * Interval(0.5));
      axes.push_back(k);
    }
    // products of the middles, and of the largest values, of all factors but one
    Interval middle = constant, largest = CGAL::abs(constant);
    for (const auto& [m, d] : factors) {
      middle *= m;
      largest *= CGAL::abs(m) + CGAL::abs(d);
    }
    Region region{r,
                  a,
                  b,
                  largest - CGAL::abs(middle),
                  std::vector<Interval>(free_.size() + 1, Interval(0)),
                  Products{Interval(0), Interval(0)}};
    add(a_[0], middle, a);
    add(b_[0], middle, b);
    for (std::size_t i = 0; i < factors.size(); ++i) {
      Interval others = constant, others_largest = CGAL::abs(constant);
      for (std::size_t j = 0; j < factors.size(); ++j)
        if (j != i) {
          others *= factors[j].first;
          others_largest *= CGAL::abs(factors[j].first) + CGAL::abs(factors[j].second);
        }
      const Interval slope = factors[i].second * others, half = CGAL::abs(factors[i].second);
      add(a_[axes[i]], slope, a);
      add(b_[axes[i]], slope, b);
      region.rest -= CGAL::abs(slope);
      if (factors.size() > 1) region.slope_rest[axes[i]] = bound(half * others_largest - half * CGAL::abs(others));
    }
    region.rest = factors.size() > 1 ? bound(region.rest) : Interval(0);
    regions_.push_back(std::move(region));
  }

public:
  Centered_sides(const Variation_cells& cells, const Variation_box& box)
      : cells_(&cells), cell_(cells.cell(box.cell)), free_(box.free_axes()) {
    const std::size_t n = free_.size();
    const Vector zero{Interval(0), Interval(0)};
    a_.assign(n + 1, zero);
    b_.assign(n + 1, zero);
    for (std::size_t c = 0; c < 2; ++c) {
      a_[0][c] = interval(cells.incoming()[c]);
      b_[0][c] = interval(cells.outgoing()[c]);
    }
    cells.for_each_region(cell_,
                          [&](const Variable_vector::Vector& a, const Variable_vector::Vector& b, std::size_t r) {
                            add_region(box, {interval(a[0]), interval(a[1])}, {interval(b[0]), interval(b[1])}, r);
                          });
    for (std::size_t k = 0; k <= n; ++k)
      for (std::size_t l = k; l <= n; ++l)
        forms_.push_back(k == l ? products(a_[k], b_[k]) : products(a_[k], b_[l]) + products(a_[l], b_[k]));
    for (Region& region : regions_) {
      region.products = products(region.a, b_[0]) + products(a_[0], region.b);
      add(rest_a_, region.rest, magnitude(region.a));
      add(rest_b_, region.rest, magnitude(region.b));
    }
    sum_a_ = rest_a_;
    sum_b_ = rest_b_;
    Vector linear_a = zero, linear_b = zero;
    for (std::size_t k = 1; k <= n; ++k) {
      add(linear_a, Interval(1), magnitude(a_[k]));
      add(linear_b, Interval(1), magnitude(b_[k]));
    }
    add(sum_a_, Interval(1), linear_a);
    add(sum_b_, Interval(1), linear_b);
    rest_ = bounds(linear_a, rest_b_) + bounds(rest_a_, sum_b_);
  }

  // The number of the free axis k, from 1.
  std::size_t axis(std::size_t k) const { return free_[k - 1]; }
  std::size_t free() const { return free_.size(); }

  // About how many steps of work it takes, bounds included.
  static double steps(const Variation_cells& cells, std::size_t free) {
    return 12.0 * static_cast<double>(cells.regions() * (free + 6) + free * free + 16);
  }

  // A lower bound of alpha a . b + beta a x b on the box.
  double lower(const Interval& alpha, const Interval& beta) const {
    Interval sum = form(0, 0)(alpha, beta);
    for (std::size_t k = 0; k <= free(); ++k)
      for (std::size_t l = (std::max)(k, std::size_t(1)); l <= free(); ++l) {
        const Interval x = form(k, l)(alpha, beta);
        sum -= k == l ? bound(-x) : magnitude(x);
      }
    for (const Region& region : regions_)
      if (region.rest.sup() != 0) sum -= region.rest * magnitude(region.products(alpha, beta));
    return (sum - rest_(magnitude(alpha), magnitude(beta))).inf();
  }

  // An upper bound of `sign` (a x b) / (a . b); infinite when a . b is not known to be positive.
  // The bound is the root of the lower bound of T a . b - sign a x b, which is concave in T: chords
  // of it are above the root.
  double upper(int sign) const {
    const double dot = lower(Interval(1), Interval(0));
    if (!(dot > 0)) return std::numeric_limits<double>::infinity();
    const Interval beta(-sign);
    const double cross = (std::max)(-lower(Interval(0), beta), 0.0);
    double high = (Interval(cross) / Interval(dot)).sup(),
           low = (std::max)((Interval(sign) * form(0, 0).cross / form(0, 0).dot).inf(), 0.0);
    double at_low = lower(Interval(low), beta), at_high = lower(Interval(high), beta);
    if (at_low >= 0) return low;
    for (int i = 0; i < 3 && at_high > 0; ++i) {
      const double middle = low + (high - low) * (at_low / (at_low - at_high)),
                   at_middle = lower(Interval(middle), beta);
      if (!(low < middle && middle < high)) break;
      (at_middle >= 0 ? high : low) = middle;
      (at_middle >= 0 ? at_high : at_low) = at_middle;
    }
    return high;
  }

  // The sign of the derivative of T a . b - sign a x b with respect to x_k, if it has one on the
  // box for all T in a range; 0 otherwise.
  int slope(std::size_t k, int sign, double least, double most) const {
    bool rises = true, falls = true;
    const Interval beta(-sign), b_size(1);
    for (double t : {least, most}) {
      const Interval alpha(t), at_center = form(0, k)(alpha, beta);
      Interval rest(0);
      for (std::size_t l = 1; l <= free(); ++l) rest += Interval(l == k ? 2 : 1) * magnitude(form(k, l)(alpha, beta));
      Vector slope_a{Interval(0), Interval(0)}, slope_b = slope_a;
      for (const Region& region : regions_) {
        const Interval& s = region.slope_rest[k];
        if (s.sup() == 0) continue;
        rest += s * magnitude(region.products(alpha, beta));
        add(slope_a, s, magnitude(region.a));
        add(slope_b, s, magnitude(region.b));
      }
      const Products more = bounds(magnitude(a_[k]), rest_b_) + bounds(rest_a_, magnitude(b_[k])) +
                            bounds(slope_a, sum_b_) + bounds(sum_a_, slope_b);
      rest += more(alpha, b_size);
      rises = rises && (at_center - rest).inf() >= 0;
      falls = falls && (at_center + rest).sup() <= 0;
    }
    return rises ? 1 : falls ? -1 : 0;
  }

  // The axis that keeps T a . b - sign a x b from being linear most.
  std::size_t bent_axis(double t) const {
    std::size_t bent = 1;
    double most = -1;
    for (std::size_t k = 1; k <= free(); ++k) {
      Interval x(0);
      for (std::size_t l = 1; l <= free(); ++l) x += bounds_of(form(k, l))(Interval(t), Interval(1));
      for (const Region& region : regions_)
        x += region.slope_rest[k] * bounds_of(region.products)(Interval(t), Interval(1));
      if (x.sup() > most) {
        most = x.sup();
        bent = k;
      }
    }
    return bent;
  }

  // The corner where T a . b - sign a x b is least if it is linear: bit k - 1 tells whether x_k is
  // 1 there.
  std::vector<bool> corner(int sign, double t) const {
    std::vector<bool> corner;
    for (std::size_t k = 1; k <= free(); ++k) corner.push_back(form(0, k)(Interval(t), Interval(-sign)).sup() < 0);
    return corner;
  }

  // a x b and a . b at a corner.
  std::pair<Interval, Interval> products_at(const Variation_box& box, const std::vector<bool>& corner) const {
    Vector a{interval(cells_->incoming()[0]), interval(cells_->incoming()[1])},
        b{interval(cells_->outgoing()[0]), interval(cells_->outgoing()[1])};
    for (const Region& region : regions_) {
      Interval scalar(1);
      for (std::size_t v = 0, k = 0; v < box.lower.size(); ++v) {
        const bool upper = box.is_free(v) && corner[k];
        k += box.is_free(v);
        if (cells_->counts(region.number, v))
          scalar *= cells_->factor(region.number, cell_, v, Interval(upper ? box.upper[v] : box.lower[v]));
      }
      add(a, scalar, region.a);
      add(b, scalar, region.b);
    }
    const Products p = products(a, b);
    return {p.cross, p.dot};
  }

private:
  static Products bounds_of(const Products& p) { return {magnitude(p.cross), magnitude(p.dot)}; }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CENTERED_SIDES_H
