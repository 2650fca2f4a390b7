// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_SHORT_BLOSSOM_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_SHORT_BLOSSOM_H

#include <CGAL/Geometric_continuity/numbers/internal/Fixed_integer.h>

#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

/// \file short_blossom.h
/// The Bézier points of a span of a B-spline curve whose knots and control points are integers, as long as the numbers stay short.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A point with short rational coordinates: these divided by one denominator.
template <int N> struct Short_point {
  std::array<std::int64_t, N> numerators;
  std::int64_t denominator = 1;
};

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// ((whole - part) x + part y) / whole, for 0 < whole < 2^60 and |part| < 2^61. Returns false where numbers get longer than 60 bits.
template <int N>
bool combine(const Short_point<N>& x, const Short_point<N>& y, std::int64_t part, std::int64_t whole,
             Short_point<N>& result) {
  constexpr std::int64_t largest = (std::int64_t(1) << 60) - 1;
  if (part == 0 || part == whole) {
    result = part == 0 ? x : y;
    return true;
  }
  const auto product = [](std::int64_t a, std::int64_t b, std::int64_t& c) {
    return !__builtin_mul_overflow(a, b, &c) && -largest <= c && c <= largest;
  };
  const std::int64_t unit = std::gcd(part, whole), common = std::gcd(x.denominator, y.denominator);
  const std::int64_t b = part / unit, all = whole / unit, a = all - b;
  std::int64_t first, second, denominator;
  if (!product(a, y.denominator / common, first) || !product(b, x.denominator / common, second) ||
      !product(x.denominator / common, y.denominator, denominator) || !product(denominator, all, denominator))
    return false;
  std::array<Signed_128, N> sums;
  std::int64_t divisor = denominator;
  for (int i = 0; i < N; ++i) {
    sums[i] = static_cast<Signed_128>(first) * x.numerators[i] + static_cast<Signed_128>(second) * y.numerators[i];
    divisor = std::gcd(divisor, static_cast<std::int64_t>(sums[i] % divisor));
  }
  result.denominator = denominator / divisor;
  for (int i = 0; i < N; ++i) {
    const Signed_128 quotient = sums[i] / divisor;
    if (quotient < -largest || largest < quotient) return false;
    result.numerators[i] = static_cast<std::int64_t>(quotient);
  }
  return true;
}

// The Bezier point with the blossom f(a, ..., a, b, ..., b), where a is taken `as` times, of the span [a, b] of a B-spline curve of
// degree p with the control points c_0, ..., c_p and knots t_0, ..., t_2p+1: a = t_p and b = t_p+1.
template <int N>
bool short_bezier_point(const std::vector<std::int64_t>& t, std::vector<Short_point<N>> c, int as,
                        Short_point<N>& result) {
  const int p = static_cast<int>(c.size()) - 1;
  for (int r = 1; r <= p; ++r) {
    const std::int64_t x = r <= as ? t[p] : t[p + 1];
    for (int i = p; i >= r; --i) {
      Short_point<N> point;
      if (!combine(c[i - 1], c[i], x - t[i], t[i + p + 1 - r] - t[i], point)) return false;
      c[i] = point;
    }
  }
  result = c[p];
  return true;
}

#else

template <int N>
bool short_bezier_point(const std::vector<std::int64_t>&, std::vector<Short_point<N>>, int, Short_point<N>&) {
  return false;
}

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_SHORT_BLOSSOM_H
