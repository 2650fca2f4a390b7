// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "test.h"

#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

// This certifies an enclosure, without the functions that made it.

namespace enclosures {

typedef CGAL::Exact_rational Exact;

// How many floating-point numbers the upper end is beyond the lower one.
inline int ulps(const GC::Enclosure& e) {
  int n = 0;
  for (double x = e.lower; x < e.upper && n < 100; ++n) x = std::nextafter(x, e.upper);
  return n;
}

// The exact square of the enclosed number is known.
inline bool encloses_root(const GC::Enclosure& e, const Exact& square) {
  return Exact(Exact(e.lower) * Exact(e.lower)) <= square && square <= Exact(Exact(e.upper) * Exact(e.upper));
}

// cos(x) and sin(x) of a number in [0, pi], enclosed by partial sums of their alternating series in
// exact numbers.
struct Circle_point {
  Exact cos_low, cos_high, sin_low, sin_high;
};
inline Circle_point circle_point(double x) {
  const Exact square = Exact(x) * Exact(x);
  Exact term(1), sum[2] = {Exact(0), Exact(0)}, previous[2];
  for (int k = 0; k < 60; ++k) { // x^k / k!, signs ++--; it falls from k = 4 on
    previous[k % 2] = sum[k % 2];
    sum[k % 2] += k % 4 < 2 ? term : Exact(-term);
    term = term * Exact(x) / Exact(k + 1);
  }
  return {std::min(sum[0], previous[0]), std::max(sum[0], previous[0]), std::min(sum[1], previous[1]),
          std::max(sum[1], previous[1])};
}

// Returns whether the angle x is certainly not larger than the one between two vectors with this
// scalar product and squared lengths (`not_larger`), or certainly not smaller: cos falls on [0,
// pi], and for cosines of one sign their squares compare.
inline bool angle_is(bool not_larger, double x, const Exact& product, const Exact& lengths_squared) {
  if (not_larger ? x <= 0 : x >= 3.1415926535897936) return true;
  const Circle_point p = circle_point(x);
  const Exact cosine = not_larger ? p.cos_low : p.cos_high;
  const auto signed_square = [](const Exact& y) { return Exact(y < 0 ? Exact(-y * y) : Exact(y * y)); };
  const Exact left = signed_square(cosine) * lengths_squared, right = signed_square(product);
  return not_larger ? left >= right : left <= right;
}

} // namespace enclosures
