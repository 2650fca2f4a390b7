// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The bounds for both sides of a join on a box of many axes hold at its points.

#define BOOST_TEST_MODULE centered_legs
#include "support/test.h"

#include "formats/font/Centered_sides.h"

namespace {

std::mt19937 engine(20261127);
int whole(int low, int high) { return low + static_cast<int>(engine() % static_cast<unsigned>(high - low + 1)); }
int shift() { // often 0
  const bool is_shifted = whole(0, 1) == 1;
  const int x = whole(-60, 60);
  return is_shifted ? x : 0;
}

} // namespace

// Bounds of both products on a box with many axes, also where what is bilinear in the axes moves
// the sides at right angles.
BOOST_AUTO_TEST_CASE(bounds_with_centered_legs) {
  using GC::Centered_sides;
  for (int round = 0; round < 200; ++round) {
    const std::size_t n = static_cast<std::size_t>(whole(2, 4));
    GC::Variable_join join{{{100, 0}, {}}, {{100, 0}, {}}};
    std::vector<GC::Variation_region> regions;
    const std::vector<GC::Variation_range> axes(n, GC::Variation_range{0, 1});
    for (int r = whole(1, 4); r > 0; --r) {
      std::vector<GC::Region_axis> peaks; // at 1, or the axis does not count
      for (std::size_t k = 0; k < n; ++k) {
        const double peak = whole(0, 1) == 1 || k == static_cast<std::size_t>(r) % n ? 1 : 0;
        peaks.push_back({0, peak, peak});
      }
      regions.emplace_back(peaks);
      join.incoming.shifts.push_back({shift(), shift()});
      join.outgoing.shifts.push_back({shift(), shift()});
    }
    const GC::Variation_cells cells(join, regions, axes);
    const CGAL::Protect_FPU_rounding<true> upwards;
    const Centered_sides centered(cells, cells.whole(0));
    for (int k = 0; k < 20; ++k) {
      const double alpha = whole(0, 4), beta = whole(-2, 2);
      const double lower = centered.lower(Centered_sides::Interval(alpha), Centered_sides::Interval(beta));
      std::vector<double> t;
      for (std::size_t v = 0; v < cells.variables(); ++v) t.push_back(k < 10 ? whole(0, 1) : whole(0, 64) / 64.);
      const std::pair<Q, Q> p = cells.products_at(0, t);
      BOOST_CHECK(Q(lower) <= Q(alpha) * p.second + Q(beta) * p.first);
      for (std::size_t axis = 1; axis <= centered.free(); ++axis) // and the sign of a slope
        for (const int sign : {1, -1}) {
          const int slope = centered.slope(axis, sign, alpha / 4, alpha);
          if (slope == 0) continue;
          std::vector<double> low = t, high = t;
          low[centered.axis(axis)] = 0;
          high[centered.axis(axis)] = 1;
          const std::pair<Q, Q> x = cells.products_at(0, low), y = cells.products_at(0, high);
          const Q step = Q(alpha) * (y.second - x.second) - Q(sign) * (y.first - x.first);
          BOOST_CHECK(slope > 0 ? Q(0) <= step : step <= Q(0));
        }
    }
  }
}
