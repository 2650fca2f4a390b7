// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_VERTICAL_CLOTHOID_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_VERTICAL_CLOTHOID_H

#include "formats/rails/Rail_check.h"

#include <CGAL/Exact_rational.h>

#include <cmath>
#include <optional>

// The arc tangent of x with an error below 2^-250 parts. \pre |x| < 10^140
inline CGAL::Exact_rational long_atan(CGAL::Exact_rational x) {
  typedef CGAL::Exact_rational Q;
  Q factor(1);
  for (; std::fabs(CGAL::to_double(x)) > 1. / 16; factor = Q(2 * factor)) // atan x = 2 atan(x / (1 + sqrt(1 + x^2)))
    x = shortened(Q(x / (1 + long_root(Q(1 + x * x)))));
  const Q square = Q(-x * x);
  Q sum(0);
  for (int n = 1; n <= 67; n += 2) { // 16^-68 < 2^-270
    sum = Q(sum + x / n);
    x = shortened(Q(x * square));
  }
  return Q(factor * sum);
}

// A clothoid in a profile from the gradient g0 to g1, which is straight at one end: with the turn
// D = atan g1 - atan g0 and the part w of its length L from there on, its direction is
// atan g + t w^2 with (g, t) = (g0, D), or (g1, -D) backwards. So it reaches
//   L c (A - g B) far and L c (g A + B) high, where c = 1 / sqrt(1 + g^2),
//   A = the integral of cos(t w^2) over [0, 1], B = that of sin(t w^2),
// and the curvature at its other end is 2 D / L. All have errors below 2^-230 parts.
struct Vertical_clothoid {
  typedef CGAL::Exact_rational Q;

  Q distance, rise, curvature;

  // By the curvature, which is 1/radius, or where there is no radius by the distance.
  // \pre `g0 != g1`, both below 10^9; `distance > 0`
  Vertical_clothoid(const Q& g0, const Q& g1, bool is_straight_at_start, const std::optional<Q>& radius,
                    const Q& distance)
      : distance(distance) {
    const Q turn = Q(long_atan(g1) - long_atan(g0)), g = is_straight_at_start ? g0 : g1,
            t = is_straight_at_start ? turn : Q(-turn), root = long_root(Q(1 + g * g));
    Q a(0), b(0), term(1);          // t^n / n!
    for (int n = 0; n <= 74; ++n) { // pi^75 / 75! < 10^-70
      Q& sum = n % 2 == 0 ? a : b;
      sum = n % 4 < 2 ? Q(sum + term / (2 * n + 1)) : Q(sum - term / (2 * n + 1));
      term = shortened(Q(term * t / (n + 1)));
    }
    const Q far = Q(a - g * b);
    Q scale; // L c
    if (radius) {
      curvature = Q(1 / *radius);
      if ((curvature < 0) != (turn < 0)) curvature = Q(-curvature);
      scale = Q(2 * turn / (curvature * root));
      this->distance = Q(scale * far);
    } else {
      scale = Q(distance / far);
      curvature = Q(2 * turn / (scale * root));
    }
    rise = Q(scale * (g * a + b));
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_VERTICAL_CLOTHOID_H
