// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_INTERVAL_FUNCTIONS_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_INTERVAL_FUNCTIONS_H

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <limits>

/// \file interval_functions.h
/// Sine, cosine and exponential function of intervals, without a library that would have to be
/// trusted: Taylor polynomials with the bound of Lagrange, in interval arithmetic. Everything
/// expects the rounding mode of `Protect_FPU_rounding<true>`.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

inline Interval_nt<false> hull(const Interval_nt<false>& x, const Interval_nt<false>& y) {
  return Interval_nt<false>((std::min)(x.inf(), y.inf()), (std::max)(x.sup(), y.sup()));
}
// Where both hold. \pre they have a number in common
inline Interval_nt<false> common_part(const Interval_nt<false>& x, const Interval_nt<false>& y) {
  return Interval_nt<false>((std::max)(x.inf(), y.inf()), (std::min)(x.sup(), y.sup()));
}
inline double magnitude(const Interval_nt<false>& x) { return (std::max)(std::fabs(x.inf()), std::fabs(x.sup())); }
inline bool is_exact_zero(const Interval_nt<false>& x) { return x.inf() == 0 && x.sup() == 0; }
inline Interval_nt<false> symmetric(double radius) { return Interval_nt<false>(-radius, radius); }

struct Cosine_and_sine {
  Interval_nt<false> cosine, sine;
};

// Takes an interval in [-0.9, 0.9]: |r|^20 / 20! < 2^-63 and |r|^19 / 19! < 2^-58 r.
inline Cosine_and_sine small_cosine_and_sine(const Interval_nt<false>& r) {
  const Interval_nt<false> square = r * r;
  Interval_nt<false> cosine = 1, sine = 1;
  for (int k = 18; k >= 2; k -= 2) {
    cosine = 1 - square * cosine / ((k - 1) * k);
    sine = 1 - square * sine / (k * (k + 1));
  }
  return {cosine + symmetric(0x1p-60), r * (sine + symmetric(0x1p-58))};
}

// Takes a floating-point number. It is reduced by the multiple of pi/2 = 1.57079632673412561... (33
// bits) + 6.0771005065061922e-11 (rounded, its error is less than the last place) that is close to
// it; of numbers above 2^19 nothing is known.
inline Cosine_and_sine cosine_and_sine(double x) {
  constexpr double high = 0x1.921fb544p+0, low = 0x1.0b4611a626331p-34;
  if (!(std::fabs(x) <= 0x1p19)) return {symmetric(1), symmetric(1)};
  // in each rounding mode up to one at ties: |r| < 0.9
  const double k = std::floor(x / 1.5707963267948966 + 0.5);
  const Interval_nt<false> r = (Interval_nt<false>(x) - Interval_nt<false>(k) * Interval_nt<false>(high)) -
                               Interval_nt<false>(k) * Interval_nt<false>(low - 0x1p-86, low + 0x1p-86);
  const Cosine_and_sine c = small_cosine_and_sine(r);
  switch (static_cast<long>(k) & 3) {
  case 0: return c;
  case 1: return {-c.sine, c.cosine};
  case 2: return {-c.cosine, -c.sine};
  default: return {c.sine, -c.cosine};
  }
}

// Takes an interval m + d and uses cos m cos d - sin m sin d and so on, with 1 - d^2/2 <= cos d <=
// 1 and |sin d| <= |d|.
inline Cosine_and_sine cosine_and_sine(const Interval_nt<false>& x) {
  if (!(magnitude(x) <= 0x1p19)) return {symmetric(1), symmetric(1)};
  const double m = x.inf() / 2 + x.sup() / 2;
  Cosine_and_sine c = cosine_and_sine(m);
  if (!x.is_point()) {
    const double d = magnitude(x - Interval_nt<false>(m));
    if (!(d < 1.5)) return {symmetric(1), symmetric(1)};
    const Interval_nt<false> cosine =
                                 hull(Interval_nt<false>(1), 1 - Interval_nt<false>(d) * Interval_nt<false>(d) / 2),
                             sine = symmetric(d);
    c = {c.cosine * cosine - c.sine * sine, c.sine * cosine + c.cosine * sine};
  }
  const Interval_nt<false> possible = symmetric(1);
  return {common_part(c.cosine, possible), common_part(c.sine, possible)};
}

// e^x = (e^(x/2^s))^(2^s) with |x/2^s| <= 1/2, where |y|^16 / 16! e^(1/2) < 2^-59.
inline Interval_nt<false> exponential(double x) {
  if (x < -700) return Interval_nt<false>(0, 1e-300);
  if (!(x <= 700)) return Interval_nt<false>(1e300, (std::numeric_limits<double>::infinity)());
  // equivalent [0 -> 1, 1]: a halving more encloses the same number
  int s = 0;
  while (std::ldexp(std::fabs(x), -s) > 0.5) ++s;
  const Interval_nt<false> y(std::ldexp(x, -s));
  Interval_nt<false> e = 1;
  for (int k = 15; k >= 1; --k) e = 1 + y * e / k;
  e += symmetric(0x1p-59);
  for (; s > 0; --s) e = e * e;
  return e;
}
inline Interval_nt<false> exponential(const Interval_nt<false>& x) {
  return Interval_nt<false>(exponential(x.inf()).inf(), exponential(x.sup()).sup());
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_INTERVAL_FUNCTIONS_H
