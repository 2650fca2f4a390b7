// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "geometry.h"

#include <cmath>
#include <cstdint>
#include <cstring>

double nearest_double(const Exact& x) {
  const std::pair<double, double> ends = CGAL::to_interval(x);
  if (ends.first == ends.second || std::isinf(ends.first) || std::isinf(ends.second))
    return std::isinf(ends.first) ? ends.first : ends.second;
  double low = ends.first, high = ends.second; // halved until there is no double in between
  for (;;) {
    double middle = low / 2 + high / 2;
    if (!(low < middle && middle < high)) middle = std::nextafter(low, high);
    if (!(middle < high)) break;
    (x < Exact(middle) ? high : low) = middle;
  }
  const Exact twice = Exact(x + x), sum = Exact(Exact(low) + Exact(high));
  if (twice != sum) return twice < sum ? low : high;
  std::uint64_t bits;
  std::memcpy(&bits, &low, sizeof bits);
  return bits % 2 == 0 ? low : high;
}
