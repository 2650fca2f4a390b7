// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_ROTATION_BOUNDS_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_ROTATION_BOUNDS_H

#include <CGAL/Geometric_continuity/numbers/internal/certified_bounds.h>

#include <boost/multiprecision/cpp_int.hpp>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The arc tangent of 1/k for k >= 5 in units of 2^-w. Each term 1/((2i+1) k^(2i+1)) is rounded downwards twice and wrong by less than
// 2 units, and there are less than w/4 + 1 of them that are not zero.
inline boost::multiprecision::cpp_int arc_tangent_of_inverse(int k, int w) {
  boost::multiprecision::cpp_int power = boost::multiprecision::cpp_int(1) << w, sum = 0;
  power /= k;
  for (int i = 0; !power.is_zero(); ++i) {
    const boost::multiprecision::cpp_int term = power / (2 * i + 1);
    if (i % 2 == 0)
      sum += term;
    else
      sum -= term;
    power /= k * k;
  }
  return sum;
}

// cos(a) and sin(a) for the angle a of p/q degrees, 0 < p/q < 180, in units of 2^-w, w >= 128, wrong by less than `error` units.
//
// Pi = 16 atan(1/5) - 4 atan(1/239), by Machin, is wrong by less than 20 (2 (w/4 + 1)) units, and a by one more. The error of sin(a)/a
// is multiplied by a < 3.2, and the product rounded: with the error of a that is less than 10 w + 41 + 3.2 (w + 8) + 1 < 14 w.
struct Rotation_bounds {
  typedef boost::multiprecision::cpp_int Integer;
  Integer cosine, sine;
  const int error;

  Rotation_bounds(const Integer& p, const Integer& q, int w) : error(14 * w) {
    const Integer pi = 16 * arc_tangent_of_inverse(5, w) - 4 * arc_tangent_of_inverse(239, w),
                  angle = pi * p / (180 * q);
    const Cosine_and_sinc<Integer> c(Integer(angle * angle >> w), w);
    cosine = c.cosine;
    sine = c.sinc * angle >> w;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_ROTATION_BOUNDS_H
